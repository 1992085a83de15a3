/* The section `lines` of a case: closed forms evaluated along a sweep, to be drawn beside the
 * computed results. */
#ifndef PO_CASE_LINES_H
#define PO_CASE_LINES_H

#include "po_case.h"
#include "po_forms.h"
#include "po_yaml.h"

/* Largest number of keys in the sweep of a line: tabor, amplitude, wavelength, radius, law and
 * profile with a parameter of one of them, and the variable of the form. */
enum { PO_LINE_MOST_AXES = 8 };

/* Checks the section `lines`: the names, the forms, the keys of the sweeps, and that every input of
 * each form is given. Status: PO_BAD_INPUT. */
po_status po_case_lines_parse(po_case *kase, const po_yaml *yaml);

/* Returned: the number of combinations in the sweep of a line. */
size_t po_case_line_rows(const po_case_line *line);

/* Returned: the value of a key of the sweep, as written, in combination number `row`. */
const char *po_case_line_value(const po_case_line *line, unsigned axis, size_t row);

/* Returned: the input of the form for combination number `row`. */
po_form_input po_case_line_input(const po_case_file *file, const po_case_line *line, size_t row);

#endif
