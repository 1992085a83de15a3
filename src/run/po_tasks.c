#include "po_tasks.h"

#include "po_memory.h"

/* Reports whether a point of the series that begins at `begin` (or this point alone) is requested
 * and not done. */
static bool is_wanted(const po_case_run *run, size_t begin) {
  bool wanted = false;
  for (size_t p = begin; p < begin + run->plan->kase->series_length; ++p)
    wanted = wanted || (run->asked[p] && !run->done[p]);
  return wanted;
}

/* Adds the solves of one round over the points of all cases that are timed, or of all others. */
static void add_round(const po_case_run *runs, size_t count, bool timed, unsigned round,
                      po_task *tasks, size_t *total) {
  for (size_t r = 0; r < count; ++r) {
    const po_case_run *run = &runs[r];
    const unsigned repeats = run->plan->kase->repeats;
    if (run->finished || (repeats > 1) != timed || round >= repeats)
      continue;
    if (run->plan->solver) {
      for (size_t share = 0; round == 0 && share < run->chunks; ++share)
        tasks[(*total)++] = (po_task){r, share, 0};
      continue;
    }
    for (size_t p = 0; p < run->plan->kase->point_count; p += run->plan->kase->series_length)
      if (is_wanted(run, p))
        tasks[(*total)++] = (po_task){r, p, round};
  }
}

po_task *po_tasks_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total) {
  size_t solves = 0;
  unsigned rounds = 1;
  for (size_t r = 0; r < count; ++r) {
    const unsigned repeats = runs[r].plan->kase->repeats;
    solves += runs[r].pending * repeats;
    rounds = repeats > rounds ? repeats : rounds;
  }
  po_task *tasks = po_allocate(solves, sizeof *tasks);
  *total = *shared = 0;
  if (!tasks)
    return NULL;
  add_round(runs, count, false, 0, tasks, total);
  *shared = *total;
  for (unsigned round = 0; round < rounds; ++round)
    add_round(runs, count, true, round, tasks, total);
  return tasks;
}
