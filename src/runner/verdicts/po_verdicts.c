#include "po_verdicts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_order.h"
#include "po_quote.h"
#include "po_text.h"

/* Adds the line of a check. A curve is not a single number; its line shows the largest distance
 * from the reference. */
static void table_line(const po_case_run *run, const po_finding *finding, po_text *text) {
  const po_check_result *item = finding->item;
  char obtained[PO_NUMBER_LENGTH], expected[PO_NUMBER_LENGTH], ratio[PO_NUMBER_LENGTH];
  const bool curve = item->check->quantity == PO_CURVE;
  const bool is_told = (!finding->plain || item->reference->row) && item->note[0];
  po_text_add(
      text, "%-12s %-23s %-24s %14s %14s %9s  %-9s %s%s%s\n", run->plan->name, item->quantity,
      finding->label ? finding->label : "-",
      po_number_or("%.9g", curve ? item->error : item->obtained, "-", obtained),
      po_number_or("%.9g", curve && isfinite(item->error) ? 0 : item->expected, "-", expected),
      po_number_or(item->ratio < 1e5 ? "%.3f" : "%.2e", item->ratio, "-", ratio),
      PO_LEDGERS[item->ledger], PO_VERDICTS[item->verdict], is_told ? ": " : "",
      is_told ? item->note : "");
}

/* Adds the pull-off of each point in newton and metre, if the scene is given in SI units. */
static void physical_lines(const po_case_run *run, po_text *text) {
  const po_case *kase = run->plan->kase;
  for (size_t i = 0; kase->is_physical && i < kase->point_count; ++i)
    if (run->points[i].result.has_pull_off)
      po_text_add(text, "%-12s %-23s %-24s %.10g N at approach %.10g m\n", run->plan->name,
                  "pull_off", kase->points[i].label,
                  run->points[i].result.pull_off.force * kase->points[i].request.units.force,
                  run->points[i].result.pull_off.approach * kase->points[i].request.units.length);
}

void po_verdicts_totals(const po_case_run *runs, size_t count, po_text *text) {
  size_t of[PO_VERDICT_COUNT] = {0}, total = 0, failures = 0, passing = 0;
  for (size_t r = 0; r < count; ++r)
    for (po_finding f = {0}; po_finding_next(&runs[r], &f); passing += f.passes)
      if (f.item) {
        of[f.item->verdict] += 1;
        total += 1;
      } else
        failures += 1;
  for (int passes = 1; passes >= 0; --passes) {
    if (passes)
      po_text_add(text, "%zu %s", passing, po_one_or_more(passing, "check passes", "checks pass"));
    else
      po_text_add(text, ", %zu %s not", total - passing,
                  po_one_or_more(total - passing, "does", "do"));
    const char *before = " (";
    for (int v = PO_WITHIN + 1; v < PO_VERDICT_COUNT; ++v)
      if (of[v] && po_verdict_passes((po_verdict)v) == passes) {
        po_text_add(text, "%s%zu %s", before, of[v], PO_VERDICTS[v]);
        before = ", ";
      }
    po_text_add(text, "%s", *before == ',' ? ")" : "");
  }
  po_text_add(text, ", %zu %s failed\n", failures, po_one_or_more(failures, "solve", "solves"));
}

void po_verdicts_table(const po_case_run *runs, size_t count, po_text *text) {
  po_text_add(text, "%-12s %-23s %-24s %14s %14s %9s  %-9s %s\n", "case", "quantity", "point",
              "obtained", "expected", "|err|/tol", "ledger", "verdict");
  for (size_t r = 0; r < count; ++r) {
    const po_case_run *run = &runs[r];
    for (po_finding f = {0}; po_finding_next(run, &f);)
      if (f.item)
        table_line(run, &f, text);
    physical_lines(run, text);
    for (po_finding f = {0}; po_finding_next(run, &f);)
      if (!f.item)
        po_text_add(text, "%-12s %-23s %-24s failed: %s\n", run->plan->name, "solve", f.label,
                    run->points[f.point].result.reason);
  }
  po_verdicts_totals(runs, count, text);
}

/* A finding as a test for other programs. */
typedef struct {
  const char *what, *id; /* together its name */
  char words[640];       /* what is to be said of it, unless it is plain */
} named;

static void name_finding(const po_case_run *run, const po_finding *finding, named *test) {
  const po_check_result *item = finding->item;
  char obtained[PO_NUMBER_LENGTH], expected[PO_NUMBER_LENGTH], error[PO_NUMBER_LENGTH];
  test->what = item ? "" : "solve/";
  test->id = item ? item->id : finding->label;
  if (!item) {
    snprintf(test->words, sizeof test->words, "%s", run->points[finding->point].result.reason);
    return;
  }
  snprintf(test->words, sizeof test->words,
           "%s: obtained %s, expected %s, error %s, tolerance %s %s%s%s",
           PO_VERDICTS[item->verdict], po_number_or("%.17g", item->obtained, "-", obtained),
           po_number_or("%.17g", item->expected, "-", expected),
           po_number_or("%.6g", item->error, "-", error), item->check->tolerance_text,
           item->check->kind_text, item->note[0] ? "; " : "", item->note);
}

/* The comparison with the pins as a test for other programs. */
static const char STORED[] = "stored_results/pin";

void po_verdicts_tap(const po_case_run *runs, const po_identity *identities, size_t count,
                     po_text *text) {
  size_t total = 0, number = 0;
  for (size_t r = 0; r < count; ++r) {
    total += po_identity_counts(&identities[r]);
    for (po_finding f = {0}; po_finding_next(&runs[r], &f);)
      total += 1;
  }
  po_text_add(text, "TAP version 13\n1..%zu\n", total);
  for (size_t r = 0; r < count; ++r) {
    for (po_finding f = {0}; po_finding_next(&runs[r], &f);) {
      named test;
      name_finding(&runs[r], &f, &test);
      po_text_add(text, "%s %zu - %s %s%s\n", f.passes ? "ok" : "not ok", ++number,
                  runs[r].plan->name, test.what, test.id);
      if (!f.plain)
        po_text_add(text, "# %s\n", test.words);
    }
    if (po_identity_counts(&identities[r]))
      po_text_add(text, "%s %zu - %s %s\n", po_identity_passes(&identities[r]) ? "ok" : "not ok",
                  ++number, runs[r].plan->name, STORED);
  }
}

/* Adds a string to XML, which must be UTF-8 without U+FFFE and U+FFFF: both become U+FFFD. */
static void add_escaped(po_text *text, const char *string) {
  char *valid = po_quote_utf8(string);
  text->failed = text->failed || !valid;
  for (char *c = valid; c && *c; ++c) {
    if (strncmp(c, "\xEF\xBF", 2) == 0 && (unsigned char)c[2] >= 0xBE)
      c[2] = '\xBD';
    const char *entity = *c == '&'   ? "&amp;"
                         : *c == '<' ? "&lt;"
                         : *c == '>' ? "&gt;"
                         : *c == '"' ? "&quot;"
                                     : NULL;
    if (entity)
      po_text_add(text, "%s", entity);
    else
      po_text_add_bytes(text, c, 1);
  }
  free(valid);
}

static void junit_test(const po_case_run *run, const po_finding *finding, po_text *text) {
  named test;
  name_finding(run, finding, &test);
  po_text_add(text, "    <testcase classname=\"%s\" name=\"%s", run->plan->name, test.what);
  add_escaped(text, test.id);
  const double seconds = run->points[finding->point].result.work.seconds;
  po_text_add(text, "\" time=\"%.3f\"", isnan(seconds) ? 0 : seconds);
  if (finding->plain) {
    po_text_add(text, "/>\n");
    return;
  }
  po_text_add(text, finding->passes ? "><system-out>" : "><failure message=\"");
  add_escaped(text, test.words);
  po_text_add(text, finding->passes ? "</system-out></testcase>\n" : "\"/></testcase>\n");
}

static void junit_suite(const po_case_run *run, const po_identity *identity, po_text *text) {
  const size_t failures = po_case_run_failures(run);
  const bool passes = po_identity_passes(identity);
  po_text_add(text, "  <testsuite name=\"%s\" tests=\"%zu\" failures=\"%zu\" time=\"%.3f\">\n",
              run->plan->name, run->check_results.count + failures + po_identity_counts(identity),
              po_case_run_outside(run) + failures + !passes, run->elapsed);
  for (po_finding f = {0}; po_finding_next(run, &f);)
    junit_test(run, &f, text);
  if (po_identity_counts(identity))
    po_text_add(text, "    <testcase classname=\"%s\" name=\"%s\"%s\n", run->plan->name, STORED,
                passes ? "/>" : "><failure message=\"other than the stored ones\"/></testcase>");
  po_text_add(text, "  </testsuite>\n");
}

void po_verdicts_junit(const po_case_run *runs, const po_identity *identities, size_t count,
                       po_text *text) {
  po_text_add(text, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n");
  for (size_t r = 0; r < count; ++r)
    junit_suite(&runs[r], &identities[r], text);
  po_text_add(text, "</testsuites>\n");
}

/* The summary of a case with many scenes. */

enum { SLOWEST = 5 };

static void add_statuses(const po_case_run *run, po_text *text) {
  static const po_status STATUSES[] = {
#define VALUE(name, value, words) name,
      PO_STATUS_LIST(VALUE)
#undef VALUE
  };
  po_text_add(text, "%-20s %9s\n", "status", "points");
  for (size_t s = 0; s < sizeof STATUSES / sizeof *STATUSES; ++s) {
    size_t count = 0;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i)
      count += run->points[i].asked && run->points[i].result.status == STATUSES[s];
    if (count)
      po_text_add(text, "%-20s %9zu\n", po_status_name(STATUSES[s]), count);
  }
}

static double cost(const po_work *work, int what) {
  return what == 0 ? work->seconds : what == 1 ? (double)work->points : (double)work->nodes;
}

/* Returned: the quantile by the nearest rank: the least value that a fraction `part` > 0 of the
 * values does not exceed; NAN without values. */
static double quantile(const double *sorted, size_t count, double part) {
  return count ? sorted[(size_t)ceil(part * (double)count) - 1] : (double)NAN;
}

static void add_costs(const po_case_run *run, double *space, po_text *text) {
  static const char *const NAMES[] = {"seconds", "points", "nodes"};
  static const double PARTS[] = {0.5, 0.95, 1.0};
  po_text_add(text, "%-20s %9s %9s %9s\n", "of each solve", "median", "95 %", "greatest");
  for (int what = 0; what < 3; ++what) {
    size_t count = 0;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
      const double value = cost(&run->points[i].result.work, what);
      /* the time of an external solver may be unknown */
      if (run->points[i].asked && !run->points[i].beyond && !isnan(value))
        space[count++] = value;
    }
    qsort(space, count, sizeof *space, po_order_ascending);
    po_text_add(text, "%-20s", NAMES[what]);
    for (size_t k = 0; k < 3; ++k) {
      char number[PO_NUMBER_LENGTH];
      po_text_add(text, " %9s",
                  po_number_or("%.4g", quantile(space, count, PARTS[k]), "-", number));
    }
    po_text_add(text, "\n");
  }
}

static void add_command(const po_case_run *run, size_t point, po_text *text) {
  const po_request request = po_plan_request(run->plan, point);
  po_text_add(text, "  ");
  if (po_case_run_needs_rerun(run, point))
    po_plan_add_rerun(run->plan, point, text);
  else
    po_input_add_command(&request, text);
  po_text_add(text, "\n");
}

/* Adds the slowest solves. Each is found by a search through all points, as there are few. */
static void add_slowest(const po_case_run *run, po_text *text) {
  double below = (double)INFINITY;
  for (int found = 0; found < SLOWEST;) {
    double greatest = -1;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
      const double seconds = run->points[i].result.work.seconds;
      if (run->points[i].asked && seconds < below && seconds > greatest)
        greatest = seconds;
    }
    if (greatest < 0)
      return;
    if (!found)
      po_text_add(text, "slowest\n");
    for (size_t i = 0; i < run->plan->kase->point_count && found < SLOWEST; ++i)
      if (run->points[i].asked && run->points[i].result.work.seconds >= greatest &&
          run->points[i].result.work.seconds < below) {
        po_text_add(text, "point %s, %s, %.3g s\n", run->plan->kase->points[i].id,
                    po_status_name(run->points[i].result.status), greatest);
        add_command(run, i, text);
        ++found;
      }
    below = greatest;
  }
}

static void add_failures(const po_case_run *run, po_text *text) {
  size_t count = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    const po_result *result = &run->points[i].result;
    if (!run->points[i].asked || run->points[i].beyond || result->status == PO_OK)
      continue;
    if (count++ == 0)
      po_text_add(text, "failed\n");
    po_text_add(text, "point %s, %s: %s\n", run->plan->kase->points[i].id,
                po_status_name(result->status), result->reason);
    add_command(run, i, text);
  }
  if (!count)
    po_text_add(text, "none failed\n");
}

void po_summary_add(const po_case_run *run, po_text *text) {
  if (!run->asked_count)
    return;
  double *space = po_allocate(run->asked_count, sizeof *space);
  if (!space) {
    text->failed = true;
    return;
  }
  po_text_add(text, "%s: %zu of %zu %s\n", run->plan->name, run->asked_count,
              run->plan->kase->point_count,
              po_one_or_more(run->plan->kase->point_count, "point", "points"));
  add_statuses(run, text);
  add_costs(run, space, text);
  add_slowest(run, text);
  add_failures(run, text);
  free(space);
}
