#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare.h"
#include "po_memory.h"
#include "po_run.h"
#include "po_solve.h"
#include "po_text.h"

/* Reports whether the results of a point are compared: it is requested, and an external solver was
 * asked for it. */
static bool is_judged(const po_case_run *run, size_t point) {
  return run->points[point].asked && !run->points[point].beyond;
}

/* Reports whether the approach of a result is one at which a jump, or the greatest tension of a
 * path with jumps, was located. */
static bool is_located(const po_check_result *item) {
  return strcmp(item->quantity, "jump_approach") == 0 ||
         strcmp(item->quantity, "hysteresis_approach") == 0 ||
         strcmp(item->quantity, "pull_off_approach") == 0;
}

/* Adds the step with which an external solver locates jumps to the tolerances of their approaches.
 */
static void allow_step(po_check_results *check_results, double step) {
  for (size_t i = 0; step > 0 && i < check_results->count; ++i) {
    po_check_result *item = &check_results->items[i];
    if (!is_located(item) || isnan(item->error))
      continue;
    item->allowance += step;
    item->ratio = fabs(item->error) / item->allowance;
    if (item->verdict == PO_OUTSIDE && item->ratio <= 1)
      item->verdict = PO_WITHIN;
    po_check_result_note(item, "the approach step of the solver, %g, is added to the tolerance",
                         step);
  }
}

/* Finds out whether the stable path of a scene reaches its pull-off. */
static po_status reach(const po_case_run *run, size_t point, const volatile sig_atomic_t *stop,
                       bool *reached) {
  po_request request = run->plan->kase->points[point].request;
  po_result result;
  request.mesh = po_mesh_default();
  request.want = PO_WANT_HYSTERESIS;
  request.variations = 0;
  request.time_limit = (double)NAN;
  request.stop = stop;
  const po_status status = po_solve(&request, &result);
  const double path =
      result.has_hysteresis ? -result.hysteresis.of[PO_AT_APPROACH].pull_off.load : NAN;
  *reached = status || !result.has_pull_off || isnan(path) ||
             path > result.pull_off.force - 1e-4 * fabs(result.pull_off.force);
  po_result_clear(&result);
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

static po_status judge_reach(po_case_run *run, const volatile sig_atomic_t *stop) {
  enum { UNKNOWN, REACHED, NOT_REACHED };
  const po_case *kase = run->plan->kase;
  unsigned char *known = po_allocate(kase->point_count, 1);
  po_status status = known ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < run->check_results.count; ++i) {
    po_check_result *item = &run->check_results.items[i];
    if (item->whole || po_verdict_passes(item->verdict) || item->verdict == PO_NO_RESULT ||
        item->verdict == PO_MISSING_REFERENCE ||
        !po_quantity_is(item->check->quantity, PO_OF_PULL_OFF))
      continue;
    bool reached = true;
    if (known[item->point] == UNKNOWN) {
      status = reach(run, item->point, stop, &reached);
      known[item->point] = reached ? REACHED : NOT_REACHED;
    }
    if (known[item->point] != NOT_REACHED)
      continue;
    item->verdict = PO_NOT_REACHABLE;
    run->coverage.not_reachable += 1;
    po_check_result_note(
        item,
        "the pull-off of the branch lies on equilibria that no test at given approach passes");
  }
  free(known);
  return status;
}

/* Of all points of the case, also if the run is limited to some of them. */
static void count_coverage(po_case_run *run) {
  const po_case *kase = run->plan->kase;
  run->coverage = (po_coverage){.points = kase->point_count};
  for (size_t i = 0; i < kase->point_count; ++i) {
    const bool judged = is_judged(run, i);
    run->coverage.asked += judged;
    for (unsigned c = 0; c < kase->file->checks_count; ++c) {
      const po_check *check = &kase->file->checks[c];
      if (!po_check_concerns(check, &kase->points[i].request) ||
          run->plan->references[c].type == PO_REFERENCE_ABSENT)
        continue;
      run->coverage.checks += 1;
      run->coverage.made += judged && po_plan_covers(run->plan, check);
    }
  }
}

static po_status judge_solver(po_case_run *run, const volatile sig_atomic_t *stop) {
  count_coverage(run);
  return run->plan->solver->unstable ? PO_OK : judge_reach(run, stop);
}

/* Compares the share of solved points with 1, and adds one result for the case. The share refers to
 * the compared points to which the check applies. If a failure has no reason, the verdict is
 * outside, whatever the share. Status: PO_NO_MEMORY. */
static po_status compare_share(po_case_run *run, const po_check *check,
                               const po_reference *reference) {
  const po_case *kase = run->plan->kase;
  size_t concerned = 0, solved = 0, without_reason = 0, example = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_result *result = &run->points[i].result;
    if (!is_judged(run, i) || !po_check_concerns(check, &kase->points[i].request))
      continue;
    concerned += 1;
    if (result->status == PO_OK)
      solved += 1;
    else {
      without_reason += result->reason[0] ? 0 : 1;
      example = concerned == solved + 1 ? i : example;
    }
  }
  if (!concerned)
    return PO_OK;
  const po_compare_input c = {.kase = kase,
                              .point = example,
                              .check = check,
                              .reference = reference,
                              .check_results = &run->check_results};
  po_check_result *item =
      po_compare_add(&c, PO_QUANTITIES[check->quantity].name, "",
                     (double)solved / (double)concerned, (po_reference_number){1, (double)NAN});
  if (!item)
    return PO_NO_MEMORY;
  item->whole = true;
  if (without_reason) {
    item->verdict = PO_OUTSIDE;
    snprintf(item->note, sizeof item->note, "%zu of %zu %s no reason", without_reason,
             concerned - solved,
             po_one_or_more(concerned - solved, "failure has", "failures have"));
  } else if (solved < concerned)
    snprintf(item->note, sizeof item->note, "%zu of %zu %s failed, first point %s: %.100s",
             concerned - solved, concerned, po_one_or_more(concerned, "point", "points"),
             kase->points[example].id, run->points[example].result.reason);
  return PO_OK;
}

po_status po_run_check(po_case_run *run, const volatile sig_atomic_t *stop) {
  const po_case *kase = run->plan->kase;
  const po_check *check;
  po_status status = PO_OK;
  for (unsigned c = 0; !status && (check = po_case_check(kase->file, c)) != NULL; ++c) {
    if (!po_plan_covers(run->plan, check))
      continue;
    const po_reference *reference = &run->plan->references[c];
    if (check->quantity == PO_SOLVED_SHARE)
      status = compare_share(run, check, reference);
    else
      for (size_t i = 0; !status && i < kase->point_count; ++i)
        if (is_judged(run, i) && (kase->points[i].traced || check->type != PO_REFERENCE_TRACED))
          status = po_compare(&(po_compare_input){.kase = kase,
                                                  .point = i,
                                                  .check = check,
                                                  .reference = reference,
                                                  .result = &run->points[i].result,
                                                  .trace = &run->points[i].trace,
                                                  .check_results = c < kase->file->checks_count
                                                                       ? &run->check_results
                                                                       : &run->measured});
  }
  if (status)
    return status;
  if (run->plan->solver)
    allow_step(&run->check_results, run->plan->solver->approach_step);
  po_judge_tolerances(&run->check_results);
  return run->plan->solver ? judge_solver(run, stop) : PO_OK;
}
