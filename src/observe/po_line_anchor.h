/* An anchor of a line: a scene that is traced, with the minima of its load. */
#ifndef PO_LINE_ANCHOR_H
#define PO_LINE_ANCHOR_H

#include "po_outcome.h"
#include "po_track_point.h"

typedef struct {
  po_track_point point;
  double approach, load;
  double margin; /* of the trace up to there, see po_reader.h */
} po_line_minimum;

typedef struct {
  size_t index;            /* of its scene on the line */
  bool usable;             /* solved, on panels: its minima can be followed */
  double tolerance;        /* that the trace took for the one asked for */
  double deepest;          /* load of the pull-off */
  po_line_minimum *minima; /* all of the trace */
  size_t count, room;
  size_t deep; /* the first of them, that may be the deepest before the next anchor */
} po_line_anchor;

/* Traces a scene. Returned: its outcome; the anchor, with the minima in the order of their depth,
 * the pull-off first; to be cleared. Status: PO_NO_MEMORY, PO_INTERRUPTED; a trace that fails makes
 * an anchor that is not usable. */
po_status po_line_anchor_trace(const po_request *request, size_t index, po_outcome *outcome,
                               po_line_anchor *anchor);
void po_line_anchor_clear(po_line_anchor *anchor);

#endif
