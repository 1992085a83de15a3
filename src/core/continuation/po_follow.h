/* Parameter continuation of a special point, an extremum of the load or a fold: Eq 15 together with
 * the condition that the rate of the load, or of the approach, vanishes is solved for successive
 * values of a parameter of the scene. A step takes one or two factorisations, a trace hundreds. See
 * doc/method.md, "Parameter continuation". */
#ifndef PO_FOLLOW_H
#define PO_FOLLOW_H

#include "po_branch_point.h"
#include "po_resolution.h"
#include "po_solution.h"
#include "po_special_point.h"

typedef struct po_follower po_follower;

/* The scenes as a function of the parameter. The function is smooth; all scenes are wavy or all are
 * smooth, and all surfaces are cut or none is. */
typedef struct {
  void (*scene_at)(void *data, double at, po_scene *scene);
  /* radius of the domain of the panels, eps */
  double (*domain_of)(void *data, const po_scene *scene);
  double (*unit_at)(void *data, double at); /* the unit of length of the scenes, in a unit of all;
                                               NULL: all have the same. The scenes then differ in
                                               the width of the contact edges, to which the weights
                                               of the arclength functional are adapted */
  void *data;
  po_allowance allowed; /* allowed errors of the panels */
  double precision;     /* of Newton's method, see po_equilibrium.h */
  double sharpness; /* relative error of an extremum of the load above which po_follow_point solves
                       it again on a finer mesh */
} po_follow_options;

/* Given: options, which are copied, and whose data must outlive the follower; at, the first value
 * of the parameter. Status: PO_NO_MEMORY. */
po_status po_follow_create(const po_follow_options *options, double at, po_follower **follower);
void po_follow_destroy(po_follower *follower);

/* Begins at a special point of a trace, which replaces the one followed before. Given: its
 * solution; whether it is of the load or of the approach; the value of the parameter. Status:
 * PO_NOT_CONVERGED, PO_OUT_OF_NODES. */
po_status po_follow_begin(po_follower *f, const po_solution *special, po_event_kind of, double at);

/* Follows the special point to a value of the parameter, in as many steps as necessary. Status:
 * PO_NOT_FOUND if the special point is lost, usually because it merges with another and both end
 * there; PO_OUT_OF_NODES; PO_OUT_OF_TIME and PO_INTERRUPTED if the deadline of the thread
 * (po_deadline.h) says so, at which the function looks before every step; PO_NO_MEMORY. */
po_status po_follow_to(po_follower *f, double at);

/* The special point at the present value of the parameter. Its pointers are valid until the next
 * call. Given: judged, whether it is solved on finer meshes for its errors. */
po_branch_point po_follow_point(po_follower *f, bool judged);

/* The surface on whose mesh the special point is. */
const po_surface *po_follow_surface(const po_follower *f);

/* The work so far. */
po_work po_follow_work(const po_follower *f);

#endif
