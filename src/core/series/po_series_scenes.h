/* The scenes of a series, as the parameter continuation of special points uses them. */
#ifndef PO_SERIES_SCENES_H
#define PO_SERIES_SCENES_H

#include "po_estimate.h"
#include "po_follow.h"
#include "po_solve_internal.h"

/* The continuation parameter of a scene is its index in the series; non-integer values interpolate
 * between scenes. */
typedef struct {
  const po_request *requests; /* in the units of their solves (po_load_unit.h) */
  po_result *results;
  size_t count;
  size_t checkpoint_every; /* see po_series_pull_offs */
} po_series_scenes;

/* Solves scenes in the units of their solves and converts the results. Given: scenes with the
 * requests as they were given, and `solve`, which finds empty results. Status: PO_NO_MEMORY, and
 * that of `solve`. */
po_status po_series_solve(po_series_scenes scenes, po_status (*solve)(const po_series_scenes *l));

/* Returned: whether minima and folds can be followed between two scenes: only numbers of the scene
 * differ, and only the pull-off is wanted. */
bool po_series_alike(const po_request *a, const po_request *b);

/* Follows special points from scene to scene. */
typedef struct {
  const po_series_scenes *scenes;
  po_event_kind of; /* of the load or of the approach */
  /* Called where the follower has reached a scene. Given: the point there, without errors. */
  void (*record)(void *data, size_t index, const po_branch_point *point);
  void *data;
  po_follower *follower; /* made by po_series_course_begin, to be destroyed */
  po_work counted;       /* its work up to the last scene, which is in the results */
} po_series_course;

/* Given: a course without a follower; tolerance, that of the follower, which begins at the scene
 * `first`. Status: PO_NO_MEMORY. */
po_status po_series_course_begin(po_series_course *course, size_t first, double tolerance);

/* Follows a point of the scene `first` up to the scene `last`, which may be before it. Returned:
 * the work, in the results. Status: PO_OUT_OF_DOMAIN if the contact reaches the end of the core of
 * the surface, so that a trace would enlarge the core; PO_INTERRUPTED; that of po_follow_begin and
 * po_follow_to. */
po_status po_series_follow(po_series_course *course, const po_solution *point, size_t first,
                           size_t last);

/* The point at which the follower is, solved for its errors. Given: the index of its scene. */
po_estimate po_series_estimate(const po_series_course *course, size_t index);

#endif
