#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_memory.h"
#include "po_observe.h"
#include "po_run.h"
#include "po_series.h"

/* Traces a scene in addition to the continuation. A failed trace is a result, not a failure of the
 * series. */
static po_status trace_in_addition(const po_request *request, po_result *trace) {
  po_result_clear(trace);
  const po_status status = po_observe(request, trace);
  if (status && !trace->reason[0])
    snprintf(trace->reason, sizeof trace->reason, "%.250s", po_message());
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

po_status po_run_series(po_case_run *run, size_t first, const volatile sig_atomic_t *stop) {
  const po_case *kase = run->plan->kase;
  po_request *requests = po_allocate(kase->series_length, sizeof *requests);
  if (!requests)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < kase->series_length; ++k) {
    requests[k] = po_plan_request(run->plan, first + k);
    requests[k].stop = stop;
    po_result_clear(&run->results[first + k]);
  }
  po_status status =
      po_series_observe(requests, kase->series_length, kase->checkpoints, &run->results[first]);
  status = po_no_memory_or(status);
  for (size_t k = 0; k < kase->series_length && !status; ++k)
    if (kase->points[first + k].traced)
      status = trace_in_addition(&requests[k], &run->traces[first + k]);
  for (size_t k = 0; k < kase->series_length; ++k) {
    run->seconds[first + k] = run->results[first + k].work.seconds;
    run->processor_seconds[first + k] = NAN; /* a series is not timed */
  }
  free(requests);
  return status == PO_INTERRUPTED ? PO_OK : status; /* the run reports the interruption */
}
