/* The branch as it is recorded while it is traced: whole, as a path from which loading, unloading
 * and staircases are read; and as the curve of a result. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include "po_branch_point.h"
#include "po_path.h"
#include "po_result.h"

typedef struct {
  po_path_point *path; /* owned */
  size_t path_count, path_room, curve_room;
} po_record;

void po_record_free(po_record *record);

/* Adds a point to the path, or to the curve of the result. Given: contact radius, eps. Status:
 * PO_NO_MEMORY. */
po_status po_record_path(po_record *record, const po_branch_point *point, double contact_radius);
po_status po_record_curve(po_record *record, const po_branch_point *point, double contact_radius,
                          po_result *result);

#endif
