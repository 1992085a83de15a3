/* The stated values of a special point, corrected on the finest mesh, and bounds of their errors.
 * See doc/method.md, "Errors". */
#ifndef PO_ESTIMATE_H
#define PO_ESTIMATE_H

#include "po_branch_point.h"
#include "po_panel_errors.h"
#include "po_request.h"
#include "po_result.h"

typedef struct {
  po_special_point point; /* the error of its energy includes that of the approach */
  double far_load_error;  /* the part of its load_error that no other mesh reduces */
  /* Bounds for the solution of the trace, which is not corrected; NAN: not estimated. */
  double traced_approach_error, traced_load_error;
  double traced_energy_error; /* of the energy at given approach */
} po_estimate;

/* Given: a special point during its visit, whose kind is a fold or an extremum. Returned: without
 * has_base and base_modes. */
po_estimate po_estimate_of(const po_request *request, const po_branch_point *point);

/* Makes a minimum of the load the pull-off of a result. */
void po_estimate_pull_off(const po_estimate *minimum, po_result *result);

/* Greatest allowed distance of the curve from the cubics between its points, in eps and pi w R, for
 * loading and unloading. */
double po_estimate_miss(const po_request *request);

/* The errors of any point of a branch. */
po_point_error po_point_error_of(const po_request *request, const po_branch_point *point);

/* That of its energy. */
double po_energy_error(const po_request *request, const po_branch_point *point);

#endif
