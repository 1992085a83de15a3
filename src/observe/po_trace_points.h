/* The points of a trace, as they are kept while the branch is traced: all of them as the path from
 * which loading, unloading and staircases are computed, and those of the curve of a result. */
#ifndef PO_TRACE_POINTS_H
#define PO_TRACE_POINTS_H

#include "po_branch_point.h"
#include "po_path.h"
#include "po_result.h"

typedef struct {
  po_path_point *path; /* owned */
  size_t path_count, path_room, curve_room;
} po_trace_points;

void po_trace_points_free(po_trace_points *points);

/* Appends a point to the path, or to the curve of the result. Given: contact radius, eps. Status:
 * PO_NO_MEMORY. */
po_status po_trace_points_add_to_path(po_trace_points *points, const po_branch_point *point,
                                      double contact_radius, double energy_error);
po_status po_trace_points_add_to_curve(po_trace_points *points, const po_branch_point *point,
                                       double contact_radius, double energy_error,
                                       po_result *result);

#endif
