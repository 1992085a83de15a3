/* The closed forms of any profile, waves and law, as po_forms.h lists them. */
#ifndef PO_FORMS_PROFILE_H
#define PO_FORMS_PROFILE_H

#include "po_forms.h"

/* Appends a number. */
void po_form_put(po_form_values *values, po_form_unit unit, const char *name, double value);

/* Each appends the same numbers whether it succeeds or not: NAN, and the status, if not. */
void po_form_jkr_profile(const po_form_input *input, po_form_values *values);
void po_form_jkr_profile_along(const po_form_input *input, po_form_values *values);
void po_form_maugis(const po_form_input *input, po_form_values *values);
void po_form_maugis_along(const po_form_input *input, po_form_values *values);
void po_form_rigid_profile(const po_form_input *input, po_form_values *values);
void po_form_rigid_profile_along(const po_form_input *input, po_form_values *values);

#endif
