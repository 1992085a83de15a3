#include <stdlib.h>

#include "po_memory.h"
#include "po_run.h"

po_status po_case_run_create(po_plan *plan, po_case_run *run) {
  const size_t points = plan->kase->point_count;
  *run = (po_case_run){.plan = plan, .end = points, .pending = points};
  run->outcomes = po_allocate(points, sizeof *run->outcomes);
  run->seconds = po_allocate(points * plan->kase->repeats, sizeof *run->seconds);
  run->processor_seconds = po_allocate(points * plan->kase->repeats, sizeof *run->seconds);
  run->done = po_allocate(points, sizeof *run->done);
  const bool made = run->outcomes && run->seconds && run->processor_seconds && run->done;
  return made ? PO_OK : PO_NO_MEMORY;
}

void po_case_run_clear(po_case_run *run) {
  for (size_t i = 0; run->outcomes && i < run->plan->kase->point_count; ++i)
    po_outcome_clear(&run->outcomes[i]);
  free(run->outcomes);
  free(run->seconds);
  free(run->processor_seconds);
  free(run->done);
  po_results_clear(&run->results);
  po_results_clear(&run->measured);
  po_plan_destroy(run->plan);
  *run = (po_case_run){0};
}

bool po_case_run_failed(const po_case_run *run, size_t point) {
  if (run->outcomes[point].status == PO_OK)
    return false;
  for (size_t i = 0; i < run->results.count; ++i) {
    const po_result *item = &run->results.items[i];
    if (item->whole && po_verdict_passes(item->verdict) &&
        po_check_concerns(item->check, &run->plan->kase->points[point].request))
      return false;
  }
  return true;
}

size_t po_case_run_failures(const po_case_run *run) {
  size_t count = 0;
  for (size_t i = run->first; i < run->end; ++i)
    count += po_case_run_failed(run, i);
  return count;
}

size_t po_case_run_outside(const po_case_run *run) {
  size_t count = 0;
  for (size_t i = 0; i < run->results.count; ++i)
    count += !po_verdict_passes(run->results.items[i].verdict);
  return count;
}

const char *po_case_run_verdict(const po_case_run *run) {
  if (po_case_run_failures(run))
    return "failed";
  return po_case_run_outside(run) ? "outside" : "within";
}
