/* From what a case file says to what it means. */
#ifndef PO_CASE_PARSE_H
#define PO_CASE_PARSE_H

#include "po_case.h"
#include "po_yaml.h"

/* Checks every value of kase->file and fills suites, want, repeats, checks and points.
 * Status: PO_BAD_INPUT with file, line, path, value and what was expected. */
po_status po_case_parse(po_case *kase, const po_yaml *yaml);

/* The cartesian product of the sweep over the scene: kase->points. */
po_status po_case_expand(po_case *kase, const po_yaml *yaml);

#endif
