/* How far a trace goes, and how far its surface reaches. */
#include <math.h>

#include "po_observe_parts.h"
#include "po_profile.h"
#include "po_rigid.h"

/* The crest that pushes with this much more than the load, and this, outdoes all that pulls: the
 * attractive term of Eq 23, 8/(3 x^2) where its repulsive term, 2/(3 x^8), is such a push. */
static const double PUSH_PER_LOAD = 1.1, PUSH_BEYOND_LOAD = 8.0;

double po_observe_rigid_end(const po_scene *scene, double load) {
  return po_rigid_approach_of_crest(scene, PUSH_PER_LOAD * load + PUSH_BEYOND_LOAD);
}

double po_observe_domain(const po_scene *scene, double core) {
  return isfinite(scene->outer_radius)
             ? core
             : po_averaging_radius(scene, po_averaging_phase(scene, core));
}

/* A contact that comes this close to the end of the panels of an unbounded surface does not leave
 * the far field to the panel beyond, in parts of the radius of that end. */
static const double GREATEST_CONTACT = 0.9, LARGER_THAN_CONTACT = 1.15;

double po_observe_core_of_contact(double contact_radius) {
  return LARGER_THAN_CONTACT * contact_radius;
}

bool po_observe_is_cut_off(const po_scene *scene, double contact_radius, double core) {
  return isinf(scene->outer_radius) && contact_radius > GREATEST_CONTACT * core;
}
