/* A checkpoint of a series of scenes: a scene that is traced completely, with the minima of its
 * load. */
#ifndef PO_CHECKPOINT_H
#define PO_CHECKPOINT_H

#include "po_request.h"
#include "po_result.h"
#include "po_solution.h"

typedef struct {
  po_solution point;
  double approach, load;
  double margin; /* margin of the stopping rule at this point, see po_reader.h */
} po_checkpoint_minimum;

typedef struct {
  size_t index;     /* index of its scene in the series */
  bool usable;      /* whether the minima can be followed: the scene was solved, on panels */
  double tolerance; /* the tolerance with which the trace met the requested one */
  double deepest;   /* load of the pull-off, pi w R */
  po_checkpoint_minimum *minima; /* all minima of the trace, in the order of their depth */
  size_t count, room;
  size_t candidates; /* the number of minima, the deepest ones, that may be the pull-off of a scene
                        before the next checkpoint */
} po_checkpoint;

/* Traces a scene. Returned: its result; the checkpoint, with the minima in the order of their
 * depth, the pull-off first, to be cleared with po_checkpoint_clear. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED. A trace that fails gives a checkpoint that is not usable. */
po_status po_checkpoint_trace(const po_request *request, size_t index, po_result *result,
                              po_checkpoint *checkpoint);
void po_checkpoint_clear(po_checkpoint *checkpoint);

#endif
