#include "po_load_unit.h"

#include <math.h>

#include "po_elementary.h"
#include "po_result_rows.h"
#include "po_scales.h"

/* The radius of the sphere with the gap of a profile C r^2, 1/(2C); NAN: it is none. */
static double radius_of_sphere(const po_profile *profile) {
  return po_profile_has(profile, PO_POWER_N) && profile->parameter[PO_POWER_N] == 2.0
             ? 0.5 / profile->parameter[PO_POWER_C]
             : (double)NAN;
}

po_request po_load_unit_request(const po_request *request) {
  po_request r = *request;
  if (po_profile_is_sphere(&r.scene.profile) || po_scene_check(&r.scene))
    return r;
  const double radius = radius_of_sphere(&r.scene.profile);
  const double unit = isnan(radius) ? po_scene_scales(&r.scene).load : radius / r.scene.radius;
  if (!(isfinite(unit) && unit > 0.0))
    return r;
  if (!isnan(radius))
    r.scene.profile = po_profile_sphere();
  r.scene.load_unit = unit;
  r.scene.radius *= unit;
  r.scene.tabor *= po_cbrt(unit);
  r.preload.load /= unit;
  r.profile_load /= unit;
  r.stiffness /= unit;
  return r;
}

po_preload po_load_unit_preload(const po_request *request) {
  const po_request solved = po_load_unit_request(request);
  po_preload preload = po_request_preload(&solved);
  preload.load *= po_scene_load_unit(&solved.scene);
  return preload;
}

/* The factors of loads and lengths. */
typedef struct {
  double load, length;
} factors;

static double convert(po_dimension dimension, double value, factors by) {
  switch (dimension) {
  case PO_DIMENSION_LENGTH:
    return value * by.length;
  case PO_DIMENSION_LOAD:
    return value * by.load;
  case PO_DIMENSION_ENERGY:
    return value * by.load * by.length;
  case PO_DIMENSION_STIFFNESS:
    return value * by.load / by.length;
  case PO_DIMENSION_TRACTION: /* in w/(mu eps), mu^3 as R */
    return value / po_cbrt(by.load);
  default:
    return value;
  }
}

/* Converts every member that is a number. */
static void convert_block(const po_block *block, void *owner, factors by) {
  for (size_t i = 0; i < block->count; ++i) {
    const po_row *row = &block->row[i];
    if (row->type == PO_ROW_PART || row->type == PO_ROW_INLINE)
      convert_block(row->block, (char *)owner + row->offset, by);
    else if (row->type == PO_ROW_LIST)
      for (size_t k = 0; k < po_row_items(row, owner); ++k)
        convert_block(row->block, po_row_item(row, owner, k), by);
    else if (row->type == PO_ROW_NUMBER && !row->alias) {
      double *number = (void *)((char *)owner + row->offset);
      *number = convert(row->dimension, *number, by);
    }
  }
}

void po_load_unit_result(const po_scene *solved, po_result *o) {
  const double unit = po_scene_load_unit(solved);
  if (unit != 1.0)
    convert_block(&PO_ALL_ROWS, o, (factors){.load = unit, .length = 1.0});
}

void po_load_unit_lengthen(po_result *o, double factor) {
  convert_block(&PO_ALL_ROWS, o, (factors){.load = 1.0, .length = factor});
}
