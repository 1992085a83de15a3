/* The trace of the branch of one scene, with its results. Some of the functions are shared with the
 * continuation of special points in a parameter. */
#ifndef PO_TRACE_H
#define PO_TRACE_H

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
  PO_KEEP_MINIMA,  /* all tensile minima of the load */
  PO_KEEP_LOADING, /* of loading and unloading: the folds and maxima of the load that loading at
                     given approach passes, the tensile minima that are deeper than PO_NEARLY of all
                     before, and the minima of the approach at which a stable stretch begins */
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

/* Traces the branch of a request with its own range of the attraction, and repeats the trace if its
 * domain or its errors require it (po_attempt.c). Given: most_points before the preload is met,
 * beyond which the trace fails with PO_TOO_MANY_POINTS, 0: any number; kept, empty but for `which`,
 * or NULL: no points are kept. Returned: result, which is empty before; kept, to be cleared
 * whatever the status; without theories and solves with changed inputs. Status: as po_solve, but
 * not stored in the result. */
po_status po_trace(const po_request *request, size_t most_points, po_kept_points *kept,
                   po_result *result);

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
po_status po_trace_once(const po_request *request, po_attempt *a, po_kept_points *kept,
                        po_result *result);

/* The gap, eps, at which a trace of rigid bodies and loading at a speed begin: there a sphere is
 * attracted by a hundredth of its pull-off force. */
static const double PO_APART = 10.0;

/* Ratio of the error of the pull-off force to its tolerance above which a solve fails. */
extern const double PO_MOST_EXCESS;

/* The processor time (po_clock_thread) at which the solve of a request gives up; INFINITY: no
 * limit. */
double po_trace_deadline(const po_request *request);

/* The allowed errors of the panels, and the precision of Newton's method, for a relative tolerance
 * of the pull-off force. */
po_allowance po_trace_allowance(double tolerance);
double po_trace_precision(double tolerance);

/* An approach, eps, from which on the load of rigid bodies exceeds `load`, pi w R. */
double po_trace_rigid_end(const po_scene *scene, double load);

/* The radius of the core, eps, of the first trace of a request. */
double po_trace_core(const po_request *request);

/* Radius of the domain of the panels, eps, for a core of the given radius. */
double po_trace_domain(const po_scene *scene, double core);

/* Whether the surface is unbounded and the contact so near the end of the core, the part of the
 * surface that may come into contact, that the scene must be solved again with a larger core. */
bool po_trace_is_cut_off(const po_scene *scene, double contact_radius, double core);

#endif
