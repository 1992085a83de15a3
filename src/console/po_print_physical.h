/* Input and results in SI units, for scenes given with --from-physical. */
#ifndef PO_PRINT_PHYSICAL_H
#define PO_PRINT_PHYSICAL_H

#include "po_given.h"
#include "po_json_value.h"
#include "po_request.h"
#include "po_result.h"

/* {"input": {"modulus_pa", "work_j_per_m2", "distance_m", "radius_m", ...}, "units": {"length_m",
 * "force_n", "traction_pa"}}: the options that were given, and the units by which dimensionless
 * numbers are multiplied. */
json_t *po_json_physical_input(const po_given *given, const po_units *units);

/* The same object with "pull_off", "folds", "extrema" and, if they are wanted, "curve",
 * "profile" and "theories". */
json_t *po_json_physical(const po_given *given, const po_request *request, const po_result *result);

/* A change in percent for the terminal: rounded to 1e-4, so that a derivative that vanishes is
 * printed as 0. */
double po_print_percent(double change);

/* The same as text for the terminal. */
void po_print_physical_input(const po_given *given);
void po_print_physical(const po_given *given, const po_request *request, const po_result *result);

#endif
