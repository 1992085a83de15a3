#include "po_case_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_file.h"
#include "po_memory.h"

void po_case_run_exclude(po_case_run *run, size_t point, const char *why) {
  po_result *result = &run->points[point].result;
  po_result_clear(result);
  *result = po_result_none();
  result->status = PO_UNSUPPORTED;
  result->work.seconds = (double)NAN;
  snprintf(result->reason, sizeof result->reason, "not asked: %s", why);
  run->points[point].beyond = true;
}

/* Marks the points that the manifest of an external solver excludes. */
static void exclude(po_case_run *run) {
  const po_plan *plan = run->plan;
  const bool nothing = po_plan_asked(plan) == 0;
  run->chunks = 1;
  for (size_t i = 0; i < plan->kase->point_count; ++i) {
    char why[PO_SOLVER_WHY] = "the case wants no quantity that the solver computes";
    run->points[i].result = po_result_none();
    if (!nothing && po_solver_accepts(plan->solver, &plan->kase->points[i].request, why))
      continue;
    po_case_run_exclude(run, i, why);
    run->points[i].done = true;
  }
}

/* Returned: the times of rounds that were not made; NULL without memory. */
static po_round *create_rounds(size_t count) {
  po_round *rounds = po_allocate(count, sizeof *rounds);
  for (size_t i = 0; rounds && i < count; ++i)
    rounds[i] = (po_round){0, 0, NAN, NAN, NAN, NAN, NAN, NAN};
  return rounds;
}

po_status po_case_run_create(po_plan *plan, po_case_run *run) {
  const size_t points = plan->kase->point_count, repeats = plan->kase->repeats;
  *run = (po_case_run){.plan = plan, .pending = points};
  run->points = po_allocate(points, sizeof *run->points);
  run->rounds = create_rounds(points * repeats);
  if (!run->points || !run->rounds)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < points; ++i)
    run->points[i].rounds = run->rounds + i * repeats;
  po_case_run_ask(run, &(po_point_range){0, points}, 1);
  if (!plan->solver)
    return PO_OK;
  exclude(run);
  if (repeats > 1 && !(run->starts = create_rounds(repeats)))
    return PO_NO_MEMORY;
  return PO_OK;
}

void po_case_run_clear(po_case_run *run) {
  for (size_t i = 0; run->points && i < run->plan->kase->point_count; ++i) {
    po_result_clear(&run->points[i].result);
    po_result_clear(&run->points[i].trace);
  }
  free(run->points);
  free(run->rounds);
  json_decref(run->environment);
  free(run->starts);
  free(run->processes);
  po_check_results_clear(&run->check_results);
  po_check_results_clear(&run->measured);
  po_plan_destroy(run->plan);
  *run = (po_case_run){0};
}

bool po_case_run_needs_rerun(const po_case_run *run, size_t point) {
  return run->plan->solver || run->points[point].result.followed;
}

void po_case_run_place(po_case_run *run, const char *output) {
  if (!*run->folder.text)
    run->folder = po_path_join(output, run->plan->kase->file->name);
}

void po_case_run_ask(po_case_run *run, const po_point_range *ranges, size_t count) {
  run->asked_count = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    run->points[i].asked = false;
    for (size_t k = 0; k < count; ++k)
      run->points[i].asked = run->points[i].asked || (i >= ranges[k].first && i <= ranges[k].last);
    run->asked_count += run->points[i].asked;
  }
}

bool po_case_run_is_whole(const po_case_run *run) {
  return run->asked_count == run->plan->kase->point_count;
}

size_t po_case_run_lacking(const po_case_run *run) {
  size_t count = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i)
    count += run->points[i].asked && !run->points[i].done;
  return count;
}

bool po_case_run_failed(const po_case_run *run, size_t point) {
  if (run->points[point].result.status == PO_OK || run->points[point].beyond)
    return false;
  for (size_t i = 0; i < run->check_results.count; ++i) {
    const po_check_result *item = &run->check_results.items[i];
    if (item->whole && po_verdict_passes(item->verdict) &&
        po_check_concerns(item->check, &run->plan->kase->points[point].request))
      return false;
  }
  return true;
}

bool po_finding_next(const po_case_run *run, po_finding *finding) {
  const po_case *kase = run->plan->kase;
  const size_t checks = run->check_results.count, end = checks + kase->point_count;
  size_t next = finding->next;
  while (next >= checks && next < end &&
         !(run->points[next - checks].asked && po_case_run_failed(run, next - checks)))
    ++next;
  if (next == end)
    return false;
  const po_check_result *item = next < checks ? &run->check_results.items[next] : NULL;
  const size_t point = item ? item->point : next - checks;
  *finding = (po_finding){.item = item,
                          .point = point,
                          .label = item && item->whole ? NULL : kase->points[point].label,
                          .passes = item && po_verdict_passes(item->verdict),
                          .plain = item && item->verdict == PO_WITHIN,
                          .next = next + 1};
  return true;
}

size_t po_case_run_failures(const po_case_run *run) {
  size_t count = 0;
  for (po_finding f = {0}; po_finding_next(run, &f);)
    count += !f.item;
  return count;
}

size_t po_case_run_outside(const po_case_run *run) {
  size_t count = 0;
  for (po_finding f = {0}; po_finding_next(run, &f);)
    count += f.item && !f.passes;
  return count;
}

const char *po_case_run_verdict(const po_case_run *run) {
  if (po_case_run_failures(run))
    return "failed";
  return po_case_run_outside(run) ? "outside" : "within";
}
