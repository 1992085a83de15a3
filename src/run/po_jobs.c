#include "po_jobs.h"

#include "po_memory.h"
/* Reports whether a point of the series that begins at `begin` (or this point alone) is requested
 * and not done. */
static bool is_wanted(const po_case_run *run, size_t begin) {
  bool wanted = false;
  for (size_t p = begin; p < begin + run->plan->kase->series_length; ++p)
    wanted = wanted || (run->points[p].asked && !run->points[p].done);
  return wanted;
}

/* Adds the solves of all cases that are not timed. */
static void add_shared(const po_case_run *runs, size_t count, po_job *jobs, size_t *total) {
  for (size_t r = 0; r < count; ++r) {
    const po_case_run *run = &runs[r];
    if (run->finished || run->plan->kase->repeats > 1)
      continue;
    if (run->plan->solver) {
      for (size_t share = 0; share < run->chunks; ++share)
        jobs[(*total)++] = (po_job){r, share, 0, po_job_share};
      continue;
    }
    for (size_t p = 0; p < run->plan->kase->point_count; p += run->plan->kase->series_length)
      if (is_wanted(run, p))
        jobs[(*total)++] =
            (po_job){r, p, 0, run->plan->kase->series_length > 1 ? po_job_series : po_job_solve};
  }
}

/* Adds one round over the points of a timed case, which run `first` is the first to solve: each
 * point for all solvers of the case. */
static void add_round(const po_case_run *runs, size_t count, size_t first, unsigned round,
                      po_job *jobs, size_t *total) {
  const po_case *kase = runs[first].plan->kase;
  for (size_t p = 0; p < kase->point_count; ++p)
    for (size_t r = first; r < count; ++r) {
      const po_case_run *run = &runs[r];
      if (run->plan->kase == kase && !run->finished &&
          (run->plan->solver ? po_run_solver_leads(run, p) : is_wanted(run, p)))
        jobs[(*total)++] = (po_job){r, p, round, run->plan->solver ? po_job_round : po_job_solve};
    }
}

/* Reports whether no earlier run has the same case. */
static bool is_first(const po_case_run *runs, size_t run) {
  for (size_t r = 0; r < run; ++r)
    if (runs[r].plan->kase == runs[run].plan->kase)
      return false;
  return true;
}

po_job *po_jobs_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total) {
  size_t solves = 0;
  unsigned rounds = 1;
  for (size_t r = 0; r < count; ++r) {
    const unsigned repeats = runs[r].plan->kase->repeats;
    solves += runs[r].pending * repeats;
    rounds = repeats > rounds ? repeats : rounds;
  }
  po_job *jobs = po_allocate(solves, sizeof *jobs);
  *total = *shared = 0;
  if (!jobs)
    return NULL;
  add_shared(runs, count, jobs, total);
  *shared = *total;
  for (unsigned round = 0; round < rounds; ++round)
    for (size_t r = 0; r < count; ++r)
      if (runs[r].plan->kase->repeats > 1 && round < runs[r].plan->kase->repeats &&
          is_first(runs, r))
        add_round(runs, count, r, round, jobs, total);
  return jobs;
}
