/* The scenes of a series, as the parameter continuation of special points uses them. */
#ifndef PO_SERIES_SCENES_H
#define PO_SERIES_SCENES_H

#include "po_follow.h"
#include "po_request.h"
#include "po_result.h"

/* The continuation parameter of a scene is its index in the series; non-integer values interpolate
 * between scenes. */
typedef struct {
  const po_request *requests; /* in the units of their solves (po_load_unit.h) */
  po_result *results;
  size_t count;
  size_t checkpoint_every; /* see po_series_observe */
} po_series_scenes;

/* Solves scenes in the units of their solves and converts the results. Given: scenes with the
 * requests as they were given, and `solve`, which finds empty results. Status: PO_NO_MEMORY, and
 * that of `solve`. */
po_status po_series_solve(po_series_scenes scenes, po_status (*solve)(const po_series_scenes *l));

/* A special point of a trace on its panels. */
typedef struct {
  po_solution point;
  double approach, load;
  double margin; /* of the stopping rule at this point, see po_stopping.h */
} po_kept_point;

/* The tensile minima of the load of a trace, or its folds. */
typedef struct {
  bool minima;
  po_kept_point *points;
  size_t count, room;
  po_arrays arrays; /* of the points */
  double tolerance; /* with which the trace met the requested one */
} po_kept_points;

/* Solves a request and keeps the points of its trace, to be cleared whatever the status. Given:
 * kept, empty but for `minima`. Status: as po_observe_kept. */
po_status po_series_trace(const po_request *request, po_kept_points *kept, po_result *result);
void po_kept_points_clear(po_kept_points *kept);

/* Returned: whether minima and folds can be followed between two scenes: only numbers of the scene
 * differ, and only the pull-off is wanted. */
bool po_series_alike(const po_request *a, const po_request *b);

/* Creates a follower for the scenes, with a tolerance. It begins at the scene `first`. Status:
 * PO_NO_MEMORY. */
po_status po_series_follower(const po_series_scenes *l, size_t first, double tolerance,
                             po_follower **follower);

/* Returned: whether the contact of a followed special point reaches the end of the core of its
 * surface, so that a trace would enlarge the core. */
bool po_series_is_cut_off(const po_request *request, const po_branch_point *special);

/* Adds the work since the last call. Given: seconds, its elapsed time; before, the work of the
 * follower up to that call. */
void po_series_add_work(const po_follower *follower, double seconds, po_work *before,
                        po_work *work);

#endif
