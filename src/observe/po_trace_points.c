#include "po_trace_points.h"

#include <stdlib.h>

#include "po_memory.h"

void po_trace_points_free(po_trace_points *points) {
  free(points->path);
  *points = (po_trace_points){0};
}

po_status po_trace_points_add_to_path(po_trace_points *points, const po_branch_point *p,
                                      double contact_radius, double energy_error) {
  po_path_point *path = po_grow(points->path, points->path_count, &points->path_room, sizeof *path);
  if (!path)
    return PO_NO_MEMORY;
  points->path = path;
  path[points->path_count++] = (po_path_point){.approach = p->approach,
                                               .load = p->load,
                                               .energy = p->energy,
                                               .energy_error = energy_error,
                                               .approach_rate = p->approach_rate,
                                               .load_rate = p->load_rate,
                                               .contact_radius = contact_radius,
                                               .position = p->position,
                                               .unstable_modes = p->unstable_modes,
                                               .minimum = p->kind == PO_POINT_LOAD_MIN};
  return PO_OK;
}

po_status po_trace_points_add_to_curve(po_trace_points *points, const po_branch_point *p,
                                       double contact_radius, double energy_error,
                                       po_result *result) {
  po_curve_point *curve =
      po_grow(result->curve, result->curve_count, &points->curve_room, sizeof *curve);
  if (!curve)
    return PO_NO_MEMORY;
  result->curve = curve;
  curve[result->curve_count++] = (po_curve_point){.position = p->position,
                                                  .approach = p->approach,
                                                  .load = p->load,
                                                  .energy = p->energy,
                                                  .energy_error = energy_error,
                                                  .contact_radius = contact_radius,
                                                  .approach_rate = p->approach_rate,
                                                  .load_rate = p->load_rate,
                                                  .unstable_modes = p->unstable_modes};
  return PO_OK;
}
