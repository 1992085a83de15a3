/* The branch followed back from its end: the special points met on the way must be those of the way
 * out in the other order. Steps and meshes are others, so that one of the two that went past a
 * fold, or onto another branch, gives itself away. */
#ifndef PO_REVERSE_TRACE_H
#define PO_REVERSE_TRACE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_branch_point.h"

/* What the reverse trace came to. */
typedef struct {
  bool made;             /* on panels alone */
  po_status status;      /* of that trace */
  char reason[256];      /* why it is not PO_OK */
  size_t points;         /* steps and special points visited */
  size_t folds, extrema; /* met */
  bool same; /* the special points of the way out, each kind and number of unstable modes */
  /* largest differences between the ways, eps and pi w R, 0 without special points; NAN: not the
   * same */
  double fold_approach, fold_load, extremum_approach, extremum_load;
  double
      excess; /* the largest of a fold, in parts of the sum of both error estimates; 0, NAN alike */
} po_reverse_trace;

typedef struct {
  po_point_kind kind;
  double approach, load, approach_error, load_error;
  int modes; /* unstable, on the side farther along the way out */
} po_passed;

/* Special points as they are passed. */
typedef struct {
  po_passed *list;
  size_t count, room;
  size_t points;
  int modes; /* after the point visited last */
} po_passage;

/* Takes note of a point on the way. Given: bounds of its errors. Status: PO_NO_MEMORY. */
po_status po_passage_note(po_passage *passage, const po_branch_point *point, double approach_error,
                          double load_error, bool back);
void po_passage_clear(po_passage *passage);

/* Compares the ways out and back, when the trace of the latter had a status. */
po_reverse_trace po_reverse_trace_compare(const po_passage *out, const po_passage *back,
                                          po_status status);

#endif
