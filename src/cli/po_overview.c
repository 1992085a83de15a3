#include "po_overview.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_record_solver.h"
#include "po_verdicts.h"

static const char *label_of(const po_finding *finding) {
  return finding->label ? finding->label : "all points";
}

static void add_case(const po_case_run *run, po_text *text) {
  po_finding worst = {0};
  size_t remarkable = 0; /* pass, and are neither identical nor within */
  for (po_finding f = {0}; po_finding_next(run, &f);) {
    remarkable += !f.plain && f.passes;
    if (f.item && isfinite(f.item->ratio) && (!worst.item || f.item->ratio > worst.item->ratio))
      worst = f;
  }
  const size_t outside = po_case_run_outside(run);
  po_text_add(text, "%-18s %7zu %7zu %8zu %9.1f ", po_plan_name(run->plan),
              run->check_results.count - outside, outside, po_case_run_failures(run), run->elapsed);
  if (worst.item)
    po_text_add(text, "%10.*f  %s, %s", worst.item->ratio < 1e5 ? 3 : 0, worst.item->ratio,
                worst.item->subject, label_of(&worst));
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

/* Whether a result is further off than another. One without a number is not. */
static bool is_worse(const po_check_result *item, const po_check_result *than) {
  return isfinite(than->ratio) && !(item->ratio <= than->ratio);
}

static void add_result(const po_case_run *run, const po_check_result *item, po_text *text) {
  po_text_add(text, "%s", po_verdict_name(item->verdict));
  if (isfinite(item->ratio) && !(item->verdict == PO_OUTSIDE && item->ratio <= 1))
    po_text_add(text, ", %.4g times the tolerance", item->ratio);
  po_text_add(text, " (%s)%s%s", po_plan_reference_of(run->plan, item->check),
              item->note[0] ? ": " : "", item->note);
}

/* What does not pass of one check of a case (NULL: the solves that failed): how many, the worst
 * (the first), and its command. */
static void add_check(const po_case_run *run, const po_check *check, const char *output,
                      po_text *text) {
  po_finding worst = {0};
  size_t count = 0;
  for (po_finding f = {0}; po_finding_next(run, &f);)
    if (!f.passes && (f.item ? f.item->check : NULL) == check)
      if (count++ == 0 || (check && is_worse(f.item, worst.item)))
        worst = f;
  if (!count)
    return;
  const po_check_result *item = worst.item;
  po_text_add(text, "%s %s, %s: ", po_plan_name(run->plan), check ? item->subject : "solve",
              label_of(&worst));
  if (check)
    add_result(run, item, text);
  else
    po_text_add(text, "failed: %s", run->results[worst.point].reason);
  if (count > 1)
    po_text_add(text,
                check ? "; %zu results of this check do not pass, this is the worst"
                      : "; %zu solves failed, this is the first",
                count);
  po_text_add(text, "\n");
  if (check && item->ledger == PO_LEDGER_PIN && item->verdict == PO_MISSING_REFERENCE)
    po_text_add(text, "    pulloff bless %s --reason TEXT\n", po_case_word(run->plan->kase));
  else
    add_command(run, worst.label ? &run->plan->kase->points[worst.point] : NULL, output, text);
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
    add_check(&runs[r], NULL, output, text);
    add_excluded(&runs[r], text);
  }
  po_verdicts_totals(runs, count, text);
}
