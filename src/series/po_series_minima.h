/* The minima of the load between two checkpoints of a series (po_series.h): followed from each to
 * the other, and compared with both traces. */
#ifndef PO_SERIES_MINIMA_H
#define PO_SERIES_MINIMA_H

#include "po_series_scenes.h"

/* A scene of a series that is traced completely, with the minima of its load. */
typedef struct {
  size_t index;        /* index of its scene in the series */
  bool usable;         /* whether the minima can be followed: the scene was solved, on panels */
  double deepest;      /* load of the pull-off, pi w R */
  po_kept_points kept; /* all minima of the trace, in the order of their depth */
  size_t candidates; /* the number of minima, the deepest ones, that may be the pull-off of a scene
                        before the next checkpoint */
} po_checkpoint;

/* Given: two checkpoints with scenes between them. Returned: *settled, whether the followed minima
 * agree with both traces; then the results of the scenes between have their pull-off. Status:
 * PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_series_follow_minima(const po_series_scenes *scenes, const po_checkpoint *from,
                                  const po_checkpoint *to, bool *settled);

#endif
