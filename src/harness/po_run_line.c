#include <math.h>
#include <stdlib.h>

#include "po_line.h"
#include "po_memory.h"
#include "po_run.h"

po_status po_run_line(po_case_run *run, size_t first, const volatile sig_atomic_t *stop) {
  const po_case *kase = run->plan->kase;
  po_request *requests = po_allocate(kase->line, sizeof *requests);
  if (!requests)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < kase->line; ++k) {
    requests[k] = po_plan_request(run->plan, first + k);
    requests[k].stop = stop;
    po_outcome_clear(&run->outcomes[first + k]);
  }
  const po_status status =
      po_line_observe(requests, kase->line, kase->anchors, &run->outcomes[first]);
  for (size_t k = 0; k < kase->line; ++k) {
    run->seconds[first + k] = run->outcomes[first + k].work.seconds;
    run->processor_seconds[first + k] = NAN; /* a line is not timed */
  }
  free(requests);
  return status == PO_INTERRUPTED ? PO_OK : status; /* the run sees to that */
}
