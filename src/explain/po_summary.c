#include "po_verdicts.h"

#include <math.h>
#include <stdlib.h>

#include "po_memory.h"

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

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Returned: the quantile by the nearest rank: the least value that a fraction `part` of the values
 * does not exceed. */
static double quantile(const double *sorted, size_t count, double part) {
  const size_t rank = (size_t)ceil(part * (double)count);
  return sorted[rank > 0 ? rank - 1 : 0];
}

static void add_costs(const po_case_run *run, double *space, po_text *text) {
  static const char *const NAMES[] = {"seconds", "points", "nodes"};
  po_text_add(text, "%-20s %9s %9s %9s\n", "of each solve", "median", "95 %", "greatest");
  for (int what = 0; what < 3; ++what) {
    size_t count = 0;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i)
      if (run->points[i].asked)
        space[count++] = cost(&run->points[i].result.work, what);
    qsort(space, count, sizeof *space, ascending);
    po_text_add(text, "%-20s %9.4g %9.4g %9.4g\n", NAMES[what], quantile(space, count, 0.5),
                quantile(space, count, 0.95), space[count - 1]);
  }
}

static void add_command(const po_case_run *run, size_t point, po_text *text) {
  const po_request request = po_plan_request(run->plan, point);
  char *command = po_input_command(&request);
  po_text_add(text, "  %s\n", command ? command : "");
  text->failed = text->failed || !command;
  free(command);
}

/* Adds the slowest solves. Each is found by a search through all points, as there are few. */
static void add_slowest(const po_case_run *run, po_text *text) {
  double below = (double)INFINITY;
  po_text_add(text, "slowest\n");
  for (int found = 0; found < SLOWEST;) {
    double greatest = -1;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
      const double seconds = run->points[i].result.work.seconds;
      if (run->points[i].asked && seconds < below && seconds > greatest)
        greatest = seconds;
    }
    if (greatest < 0)
      return;
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
    if (!run->points[i].asked || result->status == PO_OK)
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
  po_text_add(text, "%s: %zu of %zu points\n", po_plan_name(run->plan), run->asked_count,
              run->plan->kase->point_count);
  add_statuses(run, text);
  add_costs(run, space, text);
  add_slowest(run, text);
  add_failures(run, text);
  free(space);
}
