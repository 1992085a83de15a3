/* A special point of the branch, an extremum of the load or a fold, followed in a parameter of the
 * scene by its own extended system: an equilibrium at which the rate of the load, or of the
 * approach, vanishes. One or two factorisations a step, against hundreds of a trace. */
#ifndef PO_FOLLOW_H
#define PO_FOLLOW_H

#include "po_branch_point.h"
#include "po_resolution.h"
#include "po_solution.h"
#include "po_special_point.h"

typedef struct po_follower po_follower;

/* Scenes along a parameter: smooth in it, all wavy or all smooth, all bounded or all not. */
typedef struct {
  void (*scene_at)(void *data, double at, po_scene *scene);
  double (*domain_of)(const po_scene *scene); /* radius of the domain of the panels, eps */
  void *data;
  po_allowance allowed; /* what panels may leave */
  double precision;     /* of Newton's iteration, see po_equilibrium */
  double sharpness;     /* relative error of an extremum of the load for which it is solved
                           again on a finer mesh when it is judged */
} po_follow_options;

/* Status: PO_NO_MEMORY. Options are copied, their data must outlive the follower. */
po_status po_follow_create(const po_follow_options *options, double at, po_follower **follower);
void po_follow_destroy(po_follower *follower);

/* Begins at a special point of a trace at a parameter; what was followed before is forgotten.
 * Given: of the load or of the approach. Status: PO_NOT_CONVERGED, PO_OUT_OF_NODES. */
po_status po_follow_begin(po_follower *f, const po_solution *special, po_event_kind of, double at);

/* Goes on to a parameter, in as many steps as it takes, or until the processor time of this thread
 * (po_clock_thread) is past the deadline, which is looked at before every step; INFINITY: none.
 * Status: PO_NOT_FOUND when the special point is lost on the way, mostly since it met another and
 * both ended there; PO_OUT_OF_NODES; PO_OUT_OF_TIME. */
po_status po_follow_to(po_follower *f, double at, double deadline);

/* The special point where the follower is; what it points to holds until the next step. With
 * `judged` it is solved on finer meshes, too, for the errors. */
po_branch_point po_follow_point(po_follower *f, bool judged);

/* Radius of the domain of the panels there, and the work so far. */
double po_follow_domain(const po_follower *f);
po_solve_work po_follow_work(const po_follower *f, uint64_t *kernel_evaluations);

#endif
