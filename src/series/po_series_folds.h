/* The folds of the first scene of a line, followed along it. */
#ifndef PO_SERIES_FOLDS_H
#define PO_SERIES_FOLDS_H

#include "po_request.h"
#include "po_result.h"

/* Given: requests of neighbouring scenes, elastic, on panels, wavy all or none, bounded all or
 * none. The first is traced; each of its folds is followed from scene to scene, as far as it is
 * there: two that meet both end, and what is born on the way is not seen. Returned: a result for
 * each scene, to be cleared whatever the status: that of the trace; of the others, `followed`, as
 * many folds as the first has, in its order, with their errors (no energy and no position),
 * approach and load NAN from where one ended. Status: PO_INTERRUPTED, PO_NO_MEMORY; PO_BAD_INPUT
 * for other scenes; a trace that fails is no failure of the line. */
po_status po_series_folds(const po_request *requests, size_t count, po_result *results);

#endif
