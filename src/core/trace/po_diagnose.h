/* The diagnostics of a result: states that are kept while a branch is traced, the first point, the
 * first folds, the pull-off and the last point, and diagnosed afterwards; and the reverse trace,
 * which must find the special points of the forward trace in the opposite order. */
#ifndef PO_DIAGNOSE_H
#define PO_DIAGNOSE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_branch_point.h"
#include "po_diagnostics.h"
#include "po_equilibrium.h"
#include "po_request.h"
#include "po_result.h"

/* The special points of a trace in their order. Their unstable modes are those on the side that is
 * later on the forward trace. */
typedef struct {
  po_special_point *list;
  size_t count, room;
  size_t points;
  int modes; /* number of unstable modes after the last point */
} po_passage;

typedef struct {
  po_kept_kind kind;
  double approach, load;
  size_t n;
  double *node, *gap; /* n: radii, eps; H */
} po_kept_state;

enum { PO_KEPT_FOLDS = 12, PO_MOST_KEPT = PO_KEPT_FOLDS + 3 };

typedef struct {
  po_kept_state states[PO_MOST_KEPT]; /* start, pull-off, end, then the folds */
  size_t folds;
  po_passage out, back; /* of the forward and of the reverse trace */
} po_kept;

/* Diagnoses the states kept of a trace. Given: the equilibrium of the trace, whose surface
 * is left on the mesh of the last of them. Returned: in the result. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED, PO_OUT_OF_TIME. */
po_status po_diagnose_states(const po_request *request, const po_kept *kept, po_equilibrium *e,
                             po_result *result);

/* Fails with PO_OUT_OF_TIME and a message that the branch is traced, followed by `what`. */
po_status po_diagnose_out_of_time(const po_request *request, const char *what);

/* Keeps a visited point if it is one of those to be diagnosed. Given: deepest, whether the point is
 * the deepest minimum of the load so far. Status: PO_NO_MEMORY. */
po_status po_kept_note(po_kept *kept, const po_branch_point *point, bool deepest);
void po_kept_clear(po_kept *kept);

/* Adds a point of a trace. Given: a special point, otherwise NULL; the number of unstable modes
 * after it; back, whether the trace is the reverse one. Status: PO_NO_MEMORY. */
po_status po_passage_note(po_passage *passage, const po_special_point *point, int modes, bool back);

/* Compares the forward trace with the reverse trace, kept->out and kept->back. Given: the status of
 * the reverse trace. */
po_reverse_trace po_reverse_trace_compare(const po_kept *kept, po_status status);

#endif
