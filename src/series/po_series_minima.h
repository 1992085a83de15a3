/* The minima of the load between two checkpoints of a series (po_series.h): followed from each to
 * the other, and compared with both traces. */
#ifndef PO_SERIES_MINIMA_H
#define PO_SERIES_MINIMA_H

#include "po_series.h"
#include "po_series_scenes.h"

/* Given: two checkpoints with scenes between them. Returned: *settled, whether the followed minima
 * agree with both traces; then the results of the scenes between have their pull-off. Status:
 * PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_series_follow_minima(const po_series_scenes *scenes, const po_checkpoint *from,
                                  const po_checkpoint *to, bool *settled);

#endif
