#include "po_overview.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_record_solver.h"
#include "po_verdicts.h"

static const char *label_of(const po_case_run *run, const po_check_result *item) {
  return item->whole ? "all points" : run->plan->kase->points[item->point].label;
}

static void add_case(const po_case_run *run, po_text *text) {
  const po_check_result *worst = NULL;
  size_t remarkable = 0; /* pass, and are neither identical nor within */
  for (size_t i = 0; i < run->check_results.count; ++i) {
    const po_check_result *item = &run->check_results.items[i];
    remarkable += !po_verdict_is_plain(item->verdict) && po_verdict_passes(item->verdict);
    if (isfinite(item->ratio) && (!worst || item->ratio > worst->ratio))
      worst = item;
  }
  const size_t outside = po_case_run_outside(run);
  po_text_add(text, "%-18s %7zu %7zu %8zu %9.1f ", po_plan_name(run->plan),
              run->check_results.count - outside, outside, po_case_run_failures(run), run->elapsed);
  if (worst)
    po_text_add(text, "%10.*f  %s, %s", worst->ratio < 1e5 ? 3 : 0, worst->ratio, worst->subject,
                label_of(run, worst));
  else
    po_text_add(text, "%10s", "-");
  if (remarkable)
    po_text_add(text, "; %zu improved%s or slack", remarkable,
                run->coverage.not_reachable ? ", not reachable" : "");
  if (run->plan->solver)
    po_text_add(text, "; coverage %zu/%zu points, %zu/%zu checks", run->coverage.asked,
                run->coverage.points, run->coverage.made, run->coverage.checks);
  const size_t clocks = po_record_solver_disagreements(run);
  if (clocks)
    po_text_add(text,
                "; the times that it reports disagree with those of its processes at %zu points",
                clocks);
  po_text_add(text, "\n");
}

/* The command that explains a point of a case (NULL: all its points). */
static void add_command(const po_case_run *run, const po_point *point, const char *output,
                        po_text *text) {
  po_text_add(text, "    pulloff explain %s", po_case_word(run->plan->kase));
  if (point)
    po_text_add(text, " --point %s", point->id);
  po_plan_add_solver(run->plan, text);
  if (output) {
    po_text_add(text, " --output ");
    po_text_add_word(text, output);
  }
  po_text_add(text, "\n");
}

/* Whether a result is further off than another (NULL: none). One without a number is. */
static bool is_worse(const po_check_result *item, const po_check_result *than) {
  return !than || (isfinite(than->ratio) && !(item->ratio <= than->ratio));
}

/* What does not pass of one check of a case: how many results, the worst, and its command. */
static void add_check(const po_case_run *run, const po_check *check, const char *output,
                      po_text *text) {
  const po_check_result *worst = NULL;
  size_t count = 0;
  for (size_t i = 0; i < run->check_results.count; ++i) {
    const po_check_result *item = &run->check_results.items[i];
    if (item->check != check || po_verdict_passes(item->verdict))
      continue;
    count += 1;
    if (is_worse(item, worst))
      worst = item;
  }
  if (!worst)
    return;
  po_text_add(text, "%s %s, %s: %s", po_plan_name(run->plan), worst->subject, label_of(run, worst),
              po_verdict_name(worst->verdict));
  if (isfinite(worst->ratio) && !(worst->verdict == PO_OUTSIDE && worst->ratio <= 1))
    po_text_add(text, ", %.4g times the tolerance", worst->ratio);
  po_text_add(text, " (%s)%s%s", po_plan_reference_of(run->plan, check), worst->note[0] ? ": " : "",
              worst->note);
  if (count > 1)
    po_text_add(text, "; %zu results of this check do not pass, this is the worst", count);
  po_text_add(text, "\n");
  if (worst->ledger == PO_LEDGER_PIN && worst->verdict == PO_MISSING_REFERENCE)
    po_text_add(text, "    pulloff bless %s --reason TEXT\n", po_case_word(run->plan->kase));
  else
    add_command(run, worst->whole ? NULL : &run->plan->kase->points[worst->point], output, text);
}

/* The solves that failed: how many, the first, and its command. */
static void add_failures(const po_case_run *run, const char *output, po_text *text) {
  const po_case *kase = run->plan->kase;
  const size_t count = po_case_run_failures(run);
  size_t first = 0;
  while (first < kase->point_count && !(run->asked[first] && po_case_run_failed(run, first)))
    ++first;
  if (first == kase->point_count)
    return;
  po_text_add(text, "%s solve, %s: failed: %s", po_plan_name(run->plan), kase->points[first].label,
              run->results[first].reason);
  if (count > 1)
    po_text_add(text, "; %zu solves failed, this is the first", count);
  po_text_add(text, "\n");
  add_command(run, &kase->points[first], output, text);
}

/* The points of an external solver that its manifest excludes: how many, the first, and why. */
static void add_excluded(const po_case_run *run, po_text *text) {
  const po_case *kase = run->plan->kase;
  size_t count = 0, first = 0;
  for (size_t i = kase->point_count; run->beyond && i-- > 0;)
    if (run->asked[i] && run->beyond[i]) {
      count += 1;
      first = i;
    }
  if (count)
    po_text_add(text, "%s: the manifest excludes %zu of %zu points; the first, %s, is %s\n",
                po_plan_name(run->plan), count, run->asked_count, kase->points[first].label,
                run->results[first].reason);
}

void po_overview_add(const po_case_run *runs, size_t count, const char *output, po_text *text) {
  po_text_add(text, "%-18s %7s %7s %8s %9s %10s  %s\n", "case", "pass", "fail", "unsolved",
              "seconds", "|err|/tol", "of the worst check");
  for (size_t r = 0; r < count; ++r)
    add_case(&runs[r], text);
  for (size_t r = 0; r < count; ++r) {
    const po_case_file *file = runs[r].plan->kase->file;
    for (unsigned c = 0; c < file->checks_count; ++c)
      add_check(&runs[r], &file->checks[c], output, text);
    add_failures(&runs[r], output, text);
    add_excluded(&runs[r], text);
  }
  po_verdicts_totals(runs, count, text);
}
