/* What a test along the traced branch gives: the preload that belongs to the pull-off, the greatest
 * pull-off force of all preloads, staircases, and loops of loading and unloading. */
#ifndef PO_TEST_RESULTS_H
#define PO_TEST_RESULTS_H

#include "po_reader.h"
#include "po_trace.h"

/* Given: the reader of a trace that succeeded, whose result has the special points, the pull-off
 * and the cause of the end of the trace; the path of the branch. Returned: in the result of the
 * reader, the preload of the pull-off, the greatest pull-off of all preloads, and the staircases
 * and loops with their errors if they are wanted. If unloading leads to a smaller approach than the
 * trace began with, a->begin is set instead of the loops, and the trace must be repeated. Status:
 * PO_NO_MEMORY. */
po_status po_test_results(const po_reader *reader, const po_path *path, po_attempt *a);

#endif
