/* Comparison of the forward trace with the reverse trace. The reverse trace must find the special
 * points of the forward trace in the opposite order. Its steps and meshes are different, so that a
 * difference shows that one of the traces passed over a fold or changed to another branch. */
#ifndef PO_REVERSE_TRACE_H
#define PO_REVERSE_TRACE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_branch_point.h"
#include "po_diagnostics.h"

typedef struct {
  po_point_kind kind;
  double approach, load, approach_error, load_error;
  int modes; /* number of unstable modes, on the side that is later on the forward trace */
} po_passed;

/* The special points of a trace in their order. */
typedef struct {
  po_passed *list;
  size_t count, room;
  size_t points;
  int modes; /* number of unstable modes after the last point */
} po_passage;

/* Adds a point of a trace. Given: bounds of its errors; back, whether the trace is the reverse one.
 * Status: PO_NO_MEMORY. */
po_status po_passage_note(po_passage *passage, const po_branch_point *point, double approach_error,
                          double load_error, bool back);
void po_passage_clear(po_passage *passage);

/* Compares the forward trace with the reverse trace. Given: the status of the reverse trace. */
po_reverse_trace po_reverse_trace_compare(const po_passage *out, const po_passage *back,
                                          po_status status);

#endif
