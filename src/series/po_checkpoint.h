/* A checkpoint of a line: a scene that is traced, with the minima of its load. */
#ifndef PO_CHECKPOINT_H
#define PO_CHECKPOINT_H

#include "po_request.h"
#include "po_result.h"
#include "po_solution.h"

typedef struct {
  po_solution point;
  double approach, load;
  double margin; /* of the trace up to there, see po_reader.h */
} po_checkpoint_minimum;

typedef struct {
  size_t index;                  /* of its scene on the line */
  bool usable;                   /* solved, on panels: its minima can be followed */
  double tolerance;              /* that the trace took for the one asked for */
  double deepest;                /* load of the pull-off */
  po_checkpoint_minimum *minima; /* all of the trace */
  size_t count, room;
  size_t deep; /* the first of them, that may be the deepest before the next checkpoint */
} po_checkpoint;

/* Traces a scene. Returned: its result; the checkpoint, with the minima in the order of their
 * depth, the pull-off first; to be cleared. Status: PO_NO_MEMORY, PO_INTERRUPTED; a trace that
 * fails makes a checkpoint that is not usable. */
po_status po_checkpoint_trace(const po_request *request, size_t index, po_result *result,
                              po_checkpoint *checkpoint);
void po_checkpoint_clear(po_checkpoint *checkpoint);

#endif
