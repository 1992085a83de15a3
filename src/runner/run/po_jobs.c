/* The order of the jobs of a run, and the jobs that solve with this program: a point, or a series.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_deadline.h"
#include "po_job.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_series.h"
#include "po_solve.h"

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

/* Seconds. The time of a long solve is already a mean over disturbances of the machine: in the case
 * precision, beside other work on the same cores, the processor times of a point that takes between
 * a tenth and a quarter of a second differ by 1.6 % (median), those of shorter ones by 3 to 6 %. */
static const double ENOUGH = 0.1;

double po_times_median(const po_round *rounds, unsigned count) {
  double sorted[1000]; /* the greatest value of `repeats` */
  unsigned known = 0;
  for (unsigned i = 0; i < count; ++i)
    if (!isnan(rounds[i].seconds))
      sorted[known++] = rounds[i].seconds;
  if (known == 0)
    return (double)NAN;
  qsort(sorted, known, sizeof *sorted, po_order_ascending);
  return known % 2 ? sorted[known / 2] : (sorted[known / 2 - 1] + sorted[known / 2]) / 2;
}

bool po_times_are_enough(const po_round *rounds, unsigned count) {
  double spent = 0.0;
  for (unsigned i = 0; i < count; ++i)
    spent += isnan(rounds[i].processor_seconds) ? 0.0 : rounds[i].processor_seconds;
  return spent >= ENOUGH;
}

/* Solves a scene. Returned: in *result, also if the solve failed. */
static po_status solve_scene(const po_request *request, po_result *result) {
  const po_status status = po_solve(request, result);
  if (status && !result->reason[0])
    snprintf(result->reason, sizeof result->reason, "%.250s", po_message());
  return status;
}

static void solve_round(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  po_round *round = &run->points[job->point].rounds[job->round];
  po_request request = po_plan_request(run->plan, job->point);
  po_result again = {0}, *first = &run->points[job->point].result;
  po_result *result = job->round ? &again : first;
  request.stop = desk->stop;
  const double begin = po_clock_thread();
  const po_status status = solve_scene(&request, result);
  round->processor_seconds = po_clock_thread() - begin;
  round->seconds = result->work.seconds;
  if (status == PO_NO_MEMORY)
    first->status = status;
  po_result_clear(&again);
}

/* Hands over the requested ones of some points, unless the run ends. */
static po_status hand_over(po_case_run *run, size_t first, size_t count, bool last,
                           const po_job_desk *desk) {
  po_status status = PO_OK;
  const bool stopped = desk->stop && *desk->stop;
#pragma omp critical(po_run_finish)
  for (size_t i = first; i < first + count && !status && !stopped; ++i)
    if (run->points[i].asked && !run->points[i].done)
      status = desk->take(desk->context, run, i, last);
  return status;
}

po_status po_job_solve(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  const unsigned repeats = run->plan->kase->repeats;
  po_round *rounds = run->points[job->point].rounds;
  if (po_times_are_enough(rounds, job->round))
    rounds[job->round].seconds = rounds[job->round].processor_seconds = (double)NAN;
  else
    solve_round(run, job, desk);
  if (job->round + 1 == repeats)
    run->points[job->point].result.work.seconds = po_times_median(rounds, repeats);
  po_no_memory_forget(); /* the status of the result reports it */
  return hand_over(run, job->point, 1, job->round + 1 == repeats, desk);
}

/* Traces a scene in addition to the continuation. A failed trace is a result, not a failure of the
 * series. */
static po_status trace_in_addition(const po_request *request, po_result *trace) {
  po_result_clear(trace);
  const po_status status = solve_scene(request, trace);
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

po_status po_job_series(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  const po_case *kase = run->plan->kase;
  const size_t first = job->point;
  po_point_run *points = run->points + first;
  po_request *requests = po_allocate(kase->series_length, sizeof *requests);
  po_result *results = po_allocate(kase->series_length, sizeof *results);
  po_status status = requests && results ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; k < kase->series_length && !status; ++k) {
    requests[k] = po_plan_request(run->plan, first + k);
    requests[k].stop = desk->stop;
  }
  if (!status)
    status = po_no_memory_or(
        po_series_pull_offs(requests, kase->series_length, kase->checkpoints, results));
  for (size_t k = 0; k < kase->series_length && results; ++k) {
    po_result_clear(&points[k].result);
    points[k].result = results[k];
    points[k].rounds->seconds = results[k].work.seconds;
    points[k].rounds->processor_seconds = NAN; /* a series is not timed */
    if (!status && kase->points[first + k].traced)
      status = trace_in_addition(&requests[k], &points[k].trace);
  }
  free(results);
  free(requests);
  return status ? status : hand_over(run, first, kase->series_length, true, desk);
}
