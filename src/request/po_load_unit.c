#include "po_load_unit.h"

#include <math.h>

#include "po_elementary.h"
#include "po_result_rows.h"
#include "po_scales.h"

po_request po_load_unit_request(const po_request *request) {
  po_request r = *request;
  if (po_profile_is_sphere(&r.scene.profile) || po_scene_check(&r.scene))
    return r;
  const double radius = po_profile_radius_of_sphere(&r.scene.profile);
  const double unit = isnan(radius) ? po_scene_scales(&r.scene).load : radius / r.scene.radius;
  if (!(isfinite(unit) && unit > 0.0))
    return r;
  if (!isnan(radius))
    r.scene.profile = po_profile_sphere();
  r.scene.load_unit = unit;
  r.scene.radius *= unit;
  r.scene.tabor *= po_cbrt(unit);
  r.preload.load /= unit;
  r.stiffness /= unit;
  return r;
}

po_preload po_load_unit_preload(const po_request *request) {
  const po_request solved = po_load_unit_request(request);
  po_preload preload = po_request_preload(&solved);
  preload.load *= po_scene_load_unit(&solved.scene);
  return preload;
}

static double convert(po_dimension dimension, double value, double unit) {
  switch (dimension) {
  case PO_DIMENSION_LOAD:
  case PO_DIMENSION_ENERGY:
  case PO_DIMENSION_STIFFNESS:
    return value * unit;
  case PO_DIMENSION_TRACTION: /* in w/(mu eps), mu^3 as R */
    return value / po_cbrt(unit);
  default:
    return value;
  }
}

void po_load_unit_result(const po_scene *solved, po_result *o) {
  const double unit = po_scene_load_unit(solved);
  if (unit != 1.0)
    po_block_change(&PO_ALL_ROWS, o, convert, unit);
}
