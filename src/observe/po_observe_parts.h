/* Functions of the solve of one scene; some are shared with the parameter continuation of its
 * special points. */
#ifndef PO_OBSERVE_PARTS_H
#define PO_OBSERVE_PARTS_H

#include "po_branch_point.h"
#include "po_request.h"
#include "po_resolution.h"
#include "po_result.h"

/* A receiver of the minima of the load and of the folds, with their solutions, as needed for
 * parameter continuation. */
typedef struct {
  void (*begin)(void *data,
                double tolerance); /* a trace begins; those of earlier traces are to be discarded */
  /* Given: the margin of the stopping rule at the point. Returned: false if there is no memory */
  bool (*special)(void *data, const po_branch_point *point, double margin);
  void *data;
  bool minima_only; /* the errors of folds are not needed */
} po_keeper;

/* The settings of one trace, which change if it is repeated. */
typedef struct {
  double core;      /* radius of the core of the surface, eps */
  double tolerance; /* of panels, relative */
  double begin; /* greatest approach at which the trace begins, eps; NAN: chosen by the solver */
  size_t unmet_folds; /* returned: number of folds not found on a finer mesh */
} po_attempt;

/* Traces the branch of a request once (po_trace.c). Given: rigid, whether the scene is solved
 * without elasticity; the settings; deadline, the processor time at which the function gives up;
 * keeper, which receives minima and folds, or NULL. Returned: result; a->begin is changed if
 * unloading leads to a smaller approach than the trace began with. Status: that of the trace;
 * PO_NOT_FOUND if there is no pull-off. */
po_status po_trace(const po_request *request, bool rigid, po_attempt *a, double deadline,
                   const po_keeper *keeper, po_result *result);

/* The processor time (po_clock_thread) at which the solve of a request gives up; INFINITY: no
 * limit. */
double po_observe_deadline(const po_request *request);

/* po_observe without the companion theory and
 * without the solves with changed inputs (po_diagnose_moved). */
po_status po_observe_kept(const po_request *request, const po_keeper *keeper, po_result *result);

/* Solves the scene again with each uncertain input, and with the profile changed by its noise, both
 * ways (doc/method.md, "Uncertain inputs"). Given: a request with a pull-off in its result;
 * deadline. Returned: the uncertainties of the result. A solve that fails is not a failure. Status:
 * as po_diagnose_moved. */
po_status po_uncertainty_solve(const po_request *request, double deadline, po_result *result);

/* Solves the scene again with each parameter changed by one unit in the last place. Given: a
 * request that succeeded, and its result; deadline, the processor time at which the function gives
 * up. Status: PO_NO_MEMORY, PO_INTERRUPTED, PO_OUT_OF_TIME. */
po_status po_diagnose_moved(const po_request *request, double deadline, po_result *result);

/* The allowed errors of the panels, and the precision of Newton's method, for a relative tolerance
 * of the pull-off force. */
po_allowance po_observe_allowance(double tolerance);
double po_observe_precision(double tolerance);

/* An approach, eps, from which on the load of rigid bodies exceeds `load`, pi w R. */
double po_observe_rigid_end(const po_scene *scene, double load);

/* The radius of the core, eps, of the first trace of a request. */
double po_observe_core(const po_request *request);

/* Radius of the domain of the panels, eps, for a core of the given radius. */
double po_observe_domain(const po_scene *scene, double core);

/* Whether the surface is unbounded and the contact so near the end of the core, the part of the
 * surface that may come into contact, that the scene must be solved again with a larger core. */
bool po_observe_is_cut_off(const po_scene *scene, double contact_radius, double core);

#endif
