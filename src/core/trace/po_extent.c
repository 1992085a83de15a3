/* The end of a rigid trace, the part of the surface that may come into contact (the core), and the
 * size of the domain of the panels; and the accuracy of the solve. */
#include <math.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_margins.h"
#include "po_rigid.h"
#include "po_scales.h"
#include "po_special_point.h"
#include "po_trace.h"

/* If the repulsion of the central crest is PUSH_PER_LOAD times the load plus PUSH_BEYOND_LOAD, it
 * exceeds the load and all attraction. For Lennard-Jones the attraction is at most the term
 * 8/(3 x^2) of Eq 23, at the x at which the repulsive term 2/(3 x^8) has that value; of another law
 * its own attraction is taken off (po_law_approach_of_push). */
static const double PUSH_PER_LOAD = 1.1, PUSH_BEYOND_LOAD = 8.0;

/* Bisections of the approach at which the load of rigid bodies has a value. */
enum { BISECTIONS = 30 };

/* The same for any profile: the approach at which the load itself has that value. */
static double end_of_load(const po_scene *scene, double push) {
  double low = 0.0, high = -po_law_numbers_of(&scene->law)->closest;
  for (int k = 0; k < BISECTIONS; ++k) {
    const double middle = 0.5 * (low + high);
    double load, rate;
    if (po_rigid_load(scene, middle, &load, &rate) || load > push)
      high = middle;
    else
      low = middle;
  }
  return low;
}

double po_trace_rigid_end(const po_scene *scene, double load) {
  const double push = PUSH_PER_LOAD * load + PUSH_BEYOND_LOAD;
  return po_profile_is_sphere(&scene->profile) ? po_rigid_approach_of_crest(scene, push)
                                               : end_of_load(scene, push);
}

/* A panel ends at the kink of a profile if the kink is at k/2^l of the domain: panels are made by
 * halving it. Up to this denominator such a domain is looked for. */
enum { KINK_PARTS = 64 };

/* The smallest domain of at least `least` in which the kink is at the end of a panel. */
static double with_kink(double kink, double least) {
  const double part = fmin(kink / least, 1.0);
  for (double parts = 1.0; parts <= KINK_PARTS; parts *= 2.0)
    if (part * parts >= KINK_PARTS / 4)
      return kink * parts / floor(part * parts);
  return part * KINK_PARTS >= 1.0 ? kink * KINK_PARTS / floor(part * KINK_PARTS) : least;
}

double po_trace_domain(const po_scene *scene, double core) {
  if (isfinite(scene->outer_radius))
    return core;
  const double kink = po_profile_shape(&scene->profile).kink;
  const double averaging = po_averaging_radius(scene, po_averaging_phase(scene, core));
  /* the phase of the waves at the end of the domain matters unless nothing acts beyond */
  const bool free = !po_scene_is_wavy(scene) || isinf(po_law_numbers_of(&scene->law)->exponent);
  return !isnan(kink) && free ? with_kink(kink, averaging) : averaging;
}

/* Greatest contact radius on an unbounded surface, relative to the radius of the domain: beyond,
 * the panel to infinity does not represent the far field. */
static const double GREATEST_CONTACT = 0.9;

bool po_trace_is_cut_off(const po_scene *scene, double contact_radius, double core) {
  return isinf(scene->outer_radius) && contact_radius > GREATEST_CONTACT * core;
}

static double finite_or_none(double value) {
  return isfinite(value) ? value : (double)NAN;
}

/* The core for a search reaches to the contact at which the search is complete for a pull-off force
 * of SEARCHED_FORCE, pi w R, if that is at most as much larger as the core of a repeated trace. */
static const double SEARCHED_FORCE = 1.0;

double po_trace_core(const po_request *request) {
  const po_scene *scene = &request->scene;
  const double deepest = fmax(fmax(request->approach_end, request->profile_approach),
                              finite_or_none(request->preload.approach));
  const double core = po_surface_core(scene, deepest);
  if (po_request_search(request) == PO_SEARCH_NONE || !request->theories ||
      po_scene_is_simple(scene) || isfinite(scene->outer_radius))
    return core;
  const double enough = po_request_bound(request, -SEARCHED_FORCE) / GREATEST_CONTACT;
  return enough < PO_FARTHER * core ? fmax(core, enough) : core;
}

/* Allowed error of the gap, eps, divided by the square root of the relative tolerance of the
 * pull-off force, and its greatest value at any tolerance. The square root, because the error of
 * the load goes as the square of the last Legendre coefficients. Where the curve is steeper or the
 * contact edge sharper, the panel itself asks for less (RIPPLE in po_resolution.c). */
static const double ERROR_OF_TOLERANCE = 0.3, COARSEST_ERROR = 3e-4;

/* Allowed error of the load of a panel, divided by the tolerance. The estimate of this error is
 * usually too large. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* Precision of Newton's method, relative to 1 + H, divided by the tolerance. */
static const double PRECISION_OF_TOLERANCE = 1e-4;

po_allowance po_trace_allowance(double tolerance) {
  return (po_allowance){fmin(COARSEST_ERROR, ERROR_OF_TOLERANCE * sqrt(tolerance)),
                        fmin(COARSEST_ERROR, LOAD_OF_TOLERANCE * tolerance)};
}

/* Never coarser than special points are located. */
double po_trace_precision(double tolerance) {
  return fmax(PO_FINEST_PRECISION, fmin(PO_LOCATED, PRECISION_OF_TOLERANCE * tolerance));
}
