/* The rows of a loop: what a test records. Private to the module. */
#ifndef PO_LOOP_RECORD_H
#define PO_LOOP_RECORD_H

#include "po_loop.h"

typedef struct {
  const po_path *path;
  po_control control;
  bool loading;
  po_loop *loop; /* to which the rows are added if it has_rows; row_area_error is what the
                    trapezoidal rule lacks so far */
  size_t room;   /* for rows */
  double unit;   /* of load: the greatest tension of the curve, pi w R */
} po_loop_record;

/* Begins the rows of a loop. Given: the curve with the extrema of the position of the base. */
po_loop_record po_loop_record_begin(const po_path *path, po_control control, po_loop *loop);

/* Adds the states on the segment from a point of the curve between two fractions; the first only if
 * there is no row yet. Between the points of the curve there are so many rows that the area under
 * straight lines between them is that under the cubics of the curve, up to OF_LOAD times the
 * greatest tension times the way of the base. Status: PO_NO_MEMORY. */
po_status po_loop_record_way(po_loop_record *r, size_t index, double from, double to);

/* Adds the state at which a jump ends, NULL: apart, which is `after`. Status: PO_NO_MEMORY. */
po_status po_loop_record_jump(po_loop_record *r, const po_path_place *to, po_path_state after);

#endif
