/* The end of a rigid trace, and the size of the domain of the panels. */
#include <math.h>

#include "po_initial_gap.h"
#include "po_observe_parts.h"
#include "po_rigid.h"

/* If the repulsion of the central crest is PUSH_PER_LOAD times the load plus PUSH_BEYOND_LOAD, it
 * exceeds the load and all attraction: the attraction is at most the term 8/(3 x^2) of Eq 23, at
 * the x at which the repulsive term 2/(3 x^8) has that value. */
static const double PUSH_PER_LOAD = 1.1, PUSH_BEYOND_LOAD = 8.0;

double po_observe_rigid_end(const po_scene *scene, double load) {
  return po_rigid_approach_of_crest(scene, PUSH_PER_LOAD * load + PUSH_BEYOND_LOAD);
}

double po_observe_domain(const po_scene *scene, double core) {
  return isfinite(scene->outer_radius)
             ? core
             : po_averaging_radius(scene, po_averaging_phase(scene, core));
}

/* Greatest contact radius on an unbounded surface, relative to the radius of the domain: beyond,
 * the panel to infinity does not represent the far field. */
static const double GREATEST_CONTACT = 0.9, LARGER_THAN_CONTACT = 1.15;

double po_observe_core_of_contact(double contact_radius) {
  return LARGER_THAN_CONTACT * contact_radius;
}

bool po_observe_is_cut_off(const po_scene *scene, double contact_radius, double core) {
  return isinf(scene->outer_radius) && contact_radius > GREATEST_CONTACT * core;
}
