/* The section `lines` of a case: closed forms along a sweep, drawn beside what is solved. */
#ifndef PO_CASE_LINES_H
#define PO_CASE_LINES_H

#include "po_case.h"
#include "po_forms.h"
#include "po_yaml.h"

/* Largest number of swept keys of a line: tabor, amplitude, wavelength, radius and the variable of
 * the form. */
enum { PO_LINE_MOST_AXES = 5 };

/* Checks the section `lines`: names, forms, the keys of their sweeps, and that each form has what
 * it needs. Status: PO_BAD_INPUT. */
po_status po_case_lines_parse(po_case *kase, const po_yaml *yaml);

/* The number of combinations of the sweep of a line. */
size_t po_case_line_rows(const po_case_line *line);

/* The input of the form in one combination. Returned: swept, the values of the swept keys. */
po_form_input po_case_line_input(const po_case_file *file, const po_case_line *line, size_t row,
                                 double swept[PO_LINE_MOST_AXES]);

#endif
