#include "po_reference_bradley.h"

#include <float.h>
#include <math.h>

#include "po_bradley.h"
#include "po_elementary.h"
#include "po_law.h"
#include "po_memory.h"

/* Distance between points of the sampled curve near contact, in the plane of approach and load. The
 * least radius of curvature is 1/32, at the minimum, so that a cubic through the points is accurate
 * to 1e-8. Far from contact the curvature decreases as x^-4, and the distance grows by x^2 / FAR.
 */
static const double SPACING = 0.002;
static const double FAR = 2;

/* The curve ends at this approach; beyond it the load is far larger than in any contact test. */
static const double LARGEST_APPROACH = 0.45;

static bool applies_to(const po_request *request) {
  return po_law_index(&request->scene.law) == 0 && po_scene_is_of_paper(&request->scene) &&
         request->scene.amplitude == 0 && isinf(request->scene.outer_radius);
}

po_status po_bradley_find(po_quantity quantity, const po_request *request,
                          po_reference_number *number) {
  if (!applies_to(request))
    return PO_NOT_FOUND;
  /* The minimum of the load is -2, at approach 0. The load is a function of the approach, so there
   * is no fold. At the contact edge the parabola r^2/(2 R) equals the gap of the greatest tension.
   */
  *number = (po_reference_number){.uncertainty = 0};
  if (quantity == PO_PULL_OFF_FORCE)
    number->value = 2;
  if (quantity == PO_CONTACT_RADIUS)
    number->value = sqrt(2 * request->scene.radius * po_law_peak_gap(&request->scene.law));
  return PO_OK;
}

static po_reference_point point_at(double approach) {
  const double x = 1 - approach, x4 = x * x * (x * x);
  const double larger_term = fmax(8 / (3 * x * x), 2 / (3 * x4 * x4));
  return (po_reference_point){.approach = approach,
                              .load = po_bradley_load(approach),
                              .load_uncertainty = 4 * DBL_EPSILON * larger_term};
}

/* Returned: the approach of the next point, at the distance described at SPACING. */
static double step_from(double approach) {
  const double h = 1e-6;
  const double slope = (po_bradley_load(approach + h) - po_bradley_load(approach - h)) / (2 * h);
  const double x = 1 - approach;
  return approach + SPACING * fmax(1, x * x / FAR) / sqrt(1 + slope * slope);
}

static po_status sample(double start, double end, po_reference_point **points, size_t *count) {
  size_t room = 0;
  for (double approach = start;; approach = fmin(step_from(approach), end)) {
    po_reference_point *larger = po_grow(*points, *count, &room, sizeof *larger);
    if (!larger)
      return PO_NO_MEMORY;
    *points = larger;
    larger[(*count)++] = point_at(approach);
    if (approach >= end)
      return PO_OK;
  }
}

po_status po_bradley_points(po_quantity quantity, const po_request *request,
                            const po_result *result, po_reference_point **points, size_t *count) {
  if (!applies_to(request))
    return PO_NOT_FOUND;
  if (quantity == PO_CURVE && result && result->curve_count)
    return sample(fmin(result->curve[0].approach, LARGEST_APPROACH),
                  fmin(result->curve[result->curve_count - 1].approach, LARGEST_APPROACH), points,
                  count);
  *points = po_allocate(1, sizeof **points);
  if (!*points)
    return PO_NO_MEMORY;
  if (quantity == PO_EXTREMA) {
    **points = (po_reference_point){.approach = 0, .load = -2, .kind = PO_MINIMUM};
    *count = 1;
  }
  return PO_OK;
}
