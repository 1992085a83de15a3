/* The jobs that solve with this program: a point, or a series. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_job.h"
#include "po_memory.h"
#include "po_observe.h"
#include "po_series.h"
#include "po_watch.h"

/* Seconds. The time of a long solve is already a mean over disturbances of the machine: in the case
 * precision, beside other work on the same cores, the processor times of a point that takes between
 * a tenth and a quarter of a second differ by 1.6 % (median), those of shorter ones by 3 to 6 %. */
static const double ENOUGH = 0.1;

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double po_times_median(const double *seconds, unsigned count) {
  double sorted[1000]; /* the greatest value of `repeats` */
  unsigned known = 0;
  for (unsigned i = 0; i < count; ++i)
    if (!isnan(seconds[i]))
      sorted[known++] = seconds[i];
  if (known == 0)
    return (double)NAN;
  qsort(sorted, known, sizeof *sorted, ascending);
  return known % 2 ? sorted[known / 2] : (sorted[known / 2 - 1] + sorted[known / 2]) / 2;
}

bool po_times_are_enough(const double *seconds, unsigned round) {
  double spent = 0.0;
  for (unsigned i = 0; i < round; ++i)
    spent += isnan(seconds[i]) ? 0.0 : seconds[i];
  return spent >= ENOUGH;
}

/* Solves a scene. Returned: in *result, also if the solve failed. */
static po_status solve(const po_request *request, po_result *result) {
  const po_status status = po_observe(request, result);
  if (status && !result->reason[0])
    snprintf(result->reason, sizeof result->reason, "%.250s", po_message());
  return status;
}

static void solve_round(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  const size_t place = job->point * run->plan->kase->repeats + job->round;
  po_request request = po_plan_request(run->plan, job->point);
  po_result again = {0}, *first = &run->results[job->point];
  po_result *result = job->round ? &again : first;
  request.stop = desk->stop;
  const double begin = po_clock_thread();
  const po_status status = solve(&request, result);
  run->processor_seconds[place] = po_clock_thread() - begin;
  run->seconds[place] = result->work.seconds;
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
    if (run->asked[i] && !run->done[i])
      status = desk->take(desk->context, run, i, last);
  return status;
}

po_status po_job_solve(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  const unsigned repeats = run->plan->kase->repeats;
  double *seconds = run->seconds + job->point * repeats;
  double *processor_seconds = run->processor_seconds + job->point * repeats;
  if (po_times_are_enough(processor_seconds, job->round))
    seconds[job->round] = processor_seconds[job->round] = (double)NAN;
  else
    solve_round(run, job, desk);
  if (job->round + 1 == repeats)
    run->results[job->point].work.seconds = po_times_median(seconds, repeats);
  po_no_memory_forget(); /* the status of the result reports it */
  return hand_over(run, job->point, 1, job->round + 1 == repeats, desk);
}

/* Traces a scene in addition to the continuation. A failed trace is a result, not a failure of the
 * series. */
static po_status trace_in_addition(const po_request *request, po_result *trace) {
  po_result_clear(trace);
  const po_status status = solve(request, trace);
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

po_status po_job_series(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  const po_case *kase = run->plan->kase;
  const size_t first = job->point;
  po_request *requests = po_allocate(kase->series_length, sizeof *requests);
  if (!requests)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < kase->series_length; ++k) {
    requests[k] = po_plan_request(run->plan, first + k);
    requests[k].stop = desk->stop;
    po_result_clear(&run->results[first + k]);
  }
  po_status status =
      po_series_observe(requests, kase->series_length, kase->checkpoints, &run->results[first]);
  status = po_no_memory_or(status);
  for (size_t k = 0; k < kase->series_length && !status; ++k)
    if (kase->points[first + k].traced)
      status = trace_in_addition(&requests[k], &run->traces[first + k]);
  for (size_t k = 0; k < kase->series_length; ++k) {
    run->seconds[first + k] = run->results[first + k].work.seconds;
    run->processor_seconds[first + k] = NAN; /* a series is not timed */
  }
  free(requests);
  return status ? status : hand_over(run, first, kase->series_length, true, desk);
}
