/* JSON documents and tables of closed forms. */
#ifndef PO_JSON_FORM_H
#define PO_JSON_FORM_H

#include "po_forms.h"
#include "po_json_value.h"
#include "po_physical.h"

/* The document of the numbers of a closed form, with what they assume, and the curve if `count` is
 * not 0; without numbers in SI units. Returned: NULL if memory runs out. */
json_t *po_json_form(const po_form *form, const po_form_input *input, const po_form_values *values,
                     const po_form_point *points, size_t count);

/* Writes the curve of a closed form as CSV, with the columns approach, load, contact_radius,
 * stable_at_approach and stable_at_load; with units in SI units, with the unit at the end of each
 * name. The headers state the equation, the preload and the command. The path "-" is standard
 * output. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_tables_write_form(const char *path, const po_form *form, const po_form_input *input,
                               const po_units *units, const char *load_unit, const char *command,
                               const po_form_point *points, size_t count);

#endif
