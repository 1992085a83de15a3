/* Functions of the solve of one scene; some are shared with the parameter continuation of its
 * special points. */
#ifndef PO_SOLVE_INTERNAL_H
#define PO_SOLVE_INTERNAL_H

#include "po_branch_point.h"
#include "po_request.h"
#include "po_resolution.h"
#include "po_result.h"
#include "po_solution.h"

/* A special point of a trace on its panels, from which parameter continuation begins. */
typedef struct {
  po_solution point;
  po_point_kind kind;
  double position, approach, load;
  int unstable_modes;
  double margin; /* of the stopping rule at this point, see po_stopping.h */
  bool met;      /* the preload is met before it */
} po_kept_point;

/* A special point that was followed to a scene and one of its trace are the same if their loads
 * differ by at most PO_SAME_LOAD relative tolerances, and their approaches by at most
 * PO_SAME_APPROACH relative to 1 + |approach|. */
extern const double PO_SAME_LOAD, PO_SAME_APPROACH;

/* Which special points of a trace are kept. But for folds, errors are then estimated for minima of
 * the load only. */
typedef enum {
  PO_KEEP_FOLDS,
  PO_KEEP_MINIMA, /* all tensile minima of the load */
  PO_KEEP_TEST,   /* of a test: the folds and maxima of the load that loading at given approach
                     passes, the tensile minima that are deeper than PO_NEARLY of all before, and the
                     minima of the approach at which a stable stretch begins */
} po_keep;

/* With another range of the attraction another minimum may be the deepest. From the smaller of two
 * traced ranges to the true one the load of a minimum changed by up to 2.3 %. */
extern const double PO_NEARLY;

/* Special points of a trace. */
typedef struct {
  po_keep which;
  po_kept_point *points;
  size_t count, room;
  po_arena arrays;  /* of the points */
  double tolerance; /* of the trace */
} po_kept_points;

/* Frees the points. Returned: all members 0. */
void po_kept_points_clear(po_kept_points *kept);

/* The settings of one trace, which change if it is repeated. */
typedef struct {
  double core;      /* radius of the core of the surface, eps */
  double tolerance; /* of panels, relative */
  double begin; /* greatest approach at which the trace begins, eps; NAN: chosen by the solver */
  size_t most_points; /* points before the preload is met beyond which the trace fails with
                         PO_TOO_MANY_POINTS; 0: any number */
  size_t unmet_folds; /* returned: number of folds not found on a finer mesh */
} po_attempt;

/* Traces the branch of a request once (po_trace.c). Given: the settings; kept, NULL: no points
 * are kept. Returned: result; the points that are kept, in place of those of an earlier trace;
 * a->begin is changed if unloading leads to a smaller approach than the trace began with. Status:
 * that of the trace; PO_NOT_FOUND if there is no pull-off. */
po_status po_trace(const po_request *request, po_attempt *a, po_kept_points *kept,
                   po_result *result);

/* The factor by which a trace goes farther that did not suffice: it is repeated with a core larger
 * by it if the contact reaches the end of the core of an unbounded surface, and from an approach
 * farther by it if unloading leads beyond its beginning. */
extern const double PO_FARTHER;

/* Ratio of the error of the pull-off force to its tolerance above which a solve fails. */
extern const double PO_MOST_EXCESS;

/* Adds work to other work. */
void po_work_add(const po_work *more, po_work *work);

/* The processor time (po_clock_thread) at which the solve of a request gives up; INFINITY: no
 * limit. */
double po_solve_deadline(const po_request *request);

/* po_solve without the theories theory and without the solves with changed inputs. Given: kept,
 * empty but for `minima`, or NULL. Returned: kept, to be cleared whatever the status. */
po_status po_solve_kept(const po_request *request, po_kept_points *kept, po_result *result);

/* Solves the scene again: for the diagnostics with each parameter changed by one unit in the last
 * place; and for the uncertainty of a pull-off with each uncertain input, and with the profile
 * changed by its noise, both ways (doc/method.md, "Uncertain inputs"). Given: a request that
 * succeeded, and its result. A solve that fails is not a failure. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED, PO_OUT_OF_TIME, also by the deadline (po_deadline.h). */
po_status po_solve_changed(const po_request *request, po_result *result);

/* The allowed errors of the panels, and the precision of Newton's method, for a relative tolerance
 * of the pull-off force. */
po_allowance po_solve_allowance(double tolerance);
double po_solve_precision(double tolerance);

/* An approach, eps, from which on the load of rigid bodies exceeds `load`, pi w R. */
double po_solve_rigid_end(const po_scene *scene, double load);

/* The radius of the core, eps, of the first trace of a request. */
double po_solve_core(const po_request *request);

/* Radius of the domain of the panels, eps, for a core of the given radius. */
double po_solve_domain(const po_scene *scene, double core);

/* Whether the surface is unbounded and the contact so near the end of the core, the part of the
 * surface that may come into contact, that the scene must be solved again with a larger core. */
bool po_solve_is_cut_off(const po_scene *scene, double contact_radius, double core);

#endif
