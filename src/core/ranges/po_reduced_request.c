/* Where a solve with greater ranges of the attraction applies, which ranges these are, and the
 * requests with them. */
#include <math.h>

#include "po_initial_gap.h"
#include "po_memory.h"
#include "po_reduced_internal.h"
#include "po_rigid.h"

/* Width of an edge, as po_reduced_width, with the greatest and the least range that is solved. Half
 * the width changes the force by about as much of it; at the least one the extrapolated force of
 * all scenes tried was right to 1e-8. */
#define WIDEST 4e-2
static const double NARROWEST = 1e-6;

/* The widths of the first and the last of the ranges of a limit differ by a factor of 32. */
const double PO_REDUCED_MOST_WIDTH = WIDEST / 32.0;

/* Below this width a scene is solved so without being asked, over the square root of the tolerance:
 * the least range that is solved is then at least three times the true one. A smooth sphere of
 * a greater width than CHOSEN_SMOOTH, a Tabor parameter below 14,000, is solved in some two seconds
 * with the true range, which gives all special points. */
static const double CHOSEN = 6e-3, CHOSEN_SMOOTH = 5e-9;

/* The range decreases by this factor from solve to solve. */
static const double STEP = M_SQRT2;

/* The extrapolation multiplies the errors of the solves by no more than this: the sum of the moduli
 * of its weights for ranges far above the true one. */
static const double AMPLIFICATION = 39.46;

/* The most ranges of limits. */
enum { MOST_TRACED = 24 };

/* Results that need traces of their own. */
enum { OF_LOADING = PO_WANT_HYSTERESIS | PO_WANT_PRELOAD };

double po_reduced_width(const po_scene *scene) {
  const double length = po_scene_is_wavy(scene) ? po_initial_gap_detail(scene) : INFINITY;
  return 1.0 / (po_scene_coupling(scene) * fmin(length, po_scene_gamma(scene)));
}

bool po_reduced_applies(const po_request *request) {
  const po_scene *scene = &request->scene;
  return request->creep.kind == PO_CREEP_NONE && request->mesh.scheme == PO_PANEL &&
         !po_rigid_suffices(scene) && po_profile_is_sphere(&scene->profile) &&
         po_law_numbers_of(&scene->law)->exponent == 3.0 &&
         !(request->want & ~(unsigned)(PO_WANT_THEORIES | OF_LOADING)) &&
         (isnan(request->stiffness) || request->want & OF_LOADING) &&
         isnan(request->approach_start) && isnan(request->profile_approach) && !request->show &&
         po_reduced_width(scene) < PO_REDUCED_MOST_WIDTH;
}

bool po_reduced_is_chosen(const po_request *request) {
  const double chosen =
      po_scene_is_wavy(&request->scene) ? CHOSEN * sqrt(request->mesh.tolerance) : CHOSEN_SMOOTH;
  const bool loads = request->want & OF_LOADING;
  return po_reduced_applies(request) &&
         (request->range == PO_RANGE_REDUCED ||
          (request->range == PO_RANGE_AUTO &&
           po_reduced_width(&request->scene) < (loads ? fmin(chosen, NARROWEST) : chosen)));
}

bool po_reduced_is_resort(const po_request *request, po_status status) {
  const bool stuck = status == PO_STEP_TOO_SMALL || status == PO_OUT_OF_NODES ||
                     status == PO_NOT_CONVERGED || status == PO_TOO_MANY_POINTS;
  return stuck && po_reduced_applies(request);
}

double po_reduced_tolerance(const po_request *request) {
  return fmax(request->mesh.tolerance / AMPLIFICATION, PO_LEAST_TOLERANCE);
}

po_request po_reduced_request(const po_request *request, double s) {
  po_request r = *request;
  r.scene.length_unit = po_scene_length_unit(&request->scene) * s;
  r.scene.tabor /= s;
  r.scene.radius /= s;
  r.scene.outer_radius /= s;
  r.scene.amplitude /= s;
  r.scene.wavelength /= s;
  for (size_t k = 0; k < r.scene.more_waves; ++k) {
    r.scene.more[k].amplitude /= s;
    r.scene.more[k].length /= s;
  }
  r.preload.approach /= s;
  r.approach_end /= s;
  r.stiffness *= s;
  r.range = PO_RANGE_EXACT;
  r.want &= ~(unsigned)OF_LOADING;
  r.mesh.tolerance = po_reduced_tolerance(request);
  return r;
}

po_request po_reduced_narrowest(const po_request *request) {
  const double s = sqrt(NARROWEST / po_reduced_width(&request->scene));
  return po_reduced_request(request, fmax(1.0, s));
}

po_ranges po_ranges_of(const po_request *request) {
  const double width = po_reduced_width(&request->scene);
  po_ranges r = {.request = request};
  for (double range = sqrt(WIDEST / width); range > 1.0 && r.all < PO_MOST_RANGES - 1;
       range /= STEP) {
    r.count += width * range * range > NARROWEST && r.count < MOST_TRACED;
    r.range[r.all++] = range;
  }
  if (r.all < PO_MOST_RANGES - 1)
    r.range[r.all++] = 1.0;
  return r;
}
