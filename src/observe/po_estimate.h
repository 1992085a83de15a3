/* The values stated for a special point of a branch (as corrected on the finest mesh solved), and
 * bounds of their errors. */
#ifndef PO_ESTIMATE_H
#define PO_ESTIMATE_H

#include "po_branch_point.h"
#include "po_contact.h"
#include "po_request.h"
#include "po_result.h"

typedef struct {
  double approach, load;             /* eps; pi w R */
  double approach_error, load_error; /* bounds; NaN: not estimated */
  po_contact_edge edge; /* the outermost contact edge, its error NaN where it was not estimated */
} po_estimate;

/* Given: the radius of the domain of the panels, for panels only; a special point while it is
 * visited. */
po_estimate po_estimate_of(const po_request *request, double domain, const po_branch_point *point);

/* Bounds of the errors of a load and of an approach on panels, from what a finer mesh changes and
 * from what it cannot show. */
double po_estimate_load_error(const po_request *request, double change, double load);
double po_estimate_approach_error(const po_request *request, double change, double approach);

/* How far a curve kept for loading and unloading may lie from the cubics between its points, in eps
 * and in pi w R. */
double po_estimate_miss(const po_request *request);

/* A bound of the error of the energy lost in jumps. Given: bound of the errors of folds in
 * approach; the sum over the jumps of 1 and of the loads (magnitudes) before and after, by which
 * the place of a jump, and that of the curve where it lands, change the energies. */
double po_estimate_energy_error(const po_request *request, double fold_error, double error_factor);

#endif
