/* Results in SI units as JSON; each key names its unit. */
#ifndef PO_JSON_UNITS_H
#define PO_JSON_UNITS_H

#include <jansson.h>

#include "po_physical.h"
#include "po_result.h"

/* The units of dimensionless numbers: {"length_m", "force_n", "traction_pa"}. */
json_t *po_json_units(const po_units *units);

/* The pull-off: {"force_n", "approach_m", "contact_radius_m", "error_estimate_n",
 * "approach_error_estimate_m", "contact_radius_error_estimate_m", "contact_radius_other_m"}; null
 * if there is none. */
json_t *po_json_units_pull_off(const po_units *units, const po_result *result);

#endif
