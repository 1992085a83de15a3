#include "po_job.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_run_solver.h"
#include "po_times.h"

/* Elapsed seconds of a first solve that is not repeated. Compilation of a solver of a few pages,
 * for which the second solve is made, takes less. The example solvers need 40 % less time for the
 * case solver_times than with two solves of each scene. */
static const double LONG_SOLVE = 5;

static po_round *rounds_of(const po_case_run *run, size_t point) {
  return run->rounds + point * run->plan->kase->repeats;
}

static bool is_open(const po_case_run *run, size_t point) {
  return run->asked[point] && !run->done[point];
}

bool po_rounds_leads(const po_case_run *run, size_t point) {
  if (!is_open(run, point))
    return false;
  for (size_t i = 0; i < point; ++i)
    if (is_open(run, i) && po_run_solver_same(run, i, point))
      return false;
  return true;
}

/* Measures start and end of the program once a round. */
static po_status measure_start(po_case_run *run, unsigned round, const char *folder,
                               const volatile sig_atomic_t *stop) {
  po_ask_log log = {0};
  if (!isnan(run->starts[round].start_wall))
    return PO_OK;
  const po_status status = po_ask(run->plan->solver, NULL, 0, folder, NULL, stop, NULL, NULL, &log);
  if (!status && log.count) {
    run->starts[round].start_wall = log.processes[0].wall;
    run->starts[round].start_processor = log.processes[0].processor;
  }
  po_ask_log_clear(&log);
  return status;
}

/* The answers of one process. */
typedef struct {
  po_case_run *run;
  size_t point;
  unsigned number;
  double begin;
  bool enough; /* the first solve took so long that it is the only one */
  po_round round;
} listener;

static po_status take(void *context, size_t question, po_answer *answer, bool final) {
  listener *l = context;
  po_result *result = &l->run->results[l->point];
  (void)question;
  (void) final;
  if (answer->repeat == 1)
    l->round.first = answer->solve;
  else
    l->round.later = answer->solve;
  l->enough = !answer->result.status && answer->repeat == 1 &&
              po_clock_wall() - l->begin > l->round.start_wall + LONG_SOLVE;
  if (l->enough)
    l->round.later = answer->solve;
  if (answer->result.status || (l->number == 0 && answer->repeat == 1)) {
    po_result_clear(result);
    const po_status status = po_run_solver_copy(l->run, l->point, &answer->result, result);
    if (status)
      return status;
  } /* else only its time counts */
  return l->enough ? PO_INTERRUPTED : PO_OK;
}

/* The times of the last process. If an earlier one was needed, it gave no usable time. */
static void take_process(po_round *round, const po_ask_log *log) {
  const po_ask_process *process = log->count ? &log->processes[log->count - 1] : NULL;
  if (!process)
    return;
  round->wall = process->wall;
  round->processor = process->processor;
  round->reported = process->found.reported > 0 ? process->found.reported : (double)NAN;
}

/* Asks the question of a point in a process of its own, and stores the times; the first round gives
 * the result. Status: as po_ask. */
static po_status ask(po_case_run *run, size_t point, unsigned round, const char *folder,
                     const volatile sig_atomic_t *stop) {
  const unsigned repeats = run->plan->kase->repeats;
  const size_t place = point * repeats + round;
  run->seconds[place] = run->processor_seconds[place] = NAN;
  po_status status = measure_start(run, round, folder, stop);
  const po_question question = po_run_solver_question(run, point);
  listener l = {.run = run,
                .point = point,
                .number = round,
                .begin = po_clock_wall(),
                .round = run->starts[round]};
  po_ask_log log = {0};
  if (!status)
    status =
        po_ask(run->plan->solver, &question, 1, folder, run->plan->solve_key, stop, take, &l, &log);
  if (status == PO_INTERRUPTED && l.enough && !(stop && *stop))
    status = PO_OK;
  if (status) {
    po_ask_log_clear(&log);
    return status;
  }
  const double solves = l.enough ? 1 : PO_ROUND_SOLVES;
  take_process(&l.round, &log);
  if (isnan(l.round.later)) /* it reports no time */
    l.round.later = fmax(l.round.wall - l.round.start_wall, 0) / solves;
  rounds_of(run, point)[round] = l.round;
  run->seconds[place] = l.round.later;
  run->processor_seconds[place] = fmax(l.round.processor - l.round.start_processor, 0) / solves;
  status = po_run_solver_keep_log(run, &log);
  po_ask_log_clear(&log);
  return status;
}

/* Reports whether a point needs no further round: `round` was the last one, it failed, or its
 * solves took long enough. */
static bool are_enough(const po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  return round + 1 == repeats || run->results[point].status != PO_OK ||
         po_times_are_enough(run->processor_seconds + point * repeats, round + 1);
}

/* Computes the medians of a point whose last round was number `round`. */
static void end(po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  po_result *result = &run->results[point];
  double *seconds = run->seconds + point * repeats;
  for (unsigned r = round + 1; r < repeats; ++r)
    seconds[r] = run->processor_seconds[point * repeats + r] = NAN;
  result->work.seconds = result->status ? (double)NAN : po_times_median(seconds, repeats);
  for (unsigned r = 0; result->status && r < repeats; ++r)
    seconds[r] = run->processor_seconds[point * repeats + r] = NAN;
}

/* Copies result and times of a point to another one with the same question. */
static po_status copy(po_case_run *run, size_t point, size_t to) {
  const unsigned repeats = run->plan->kase->repeats;
  const size_t from_place = point * repeats, to_place = to * repeats;
  po_result_clear(&run->results[to]);
  const po_status status = po_run_solver_copy(run, to, &run->results[point], &run->results[to]);
  memcpy(run->seconds + to_place, run->seconds + from_place, repeats * sizeof *run->seconds);
  memcpy(run->processor_seconds + to_place, run->processor_seconds + from_place,
         repeats * sizeof *run->processor_seconds);
  memcpy(run->rounds + to_place, run->rounds + from_place, repeats * sizeof *run->rounds);
  run->results[to].work.seconds = run->results[point].work.seconds;
  run->interleaved[to] = run->interleaved[point];
  return status;
}

/* Hands over a point after its last round, and before it all other points with its question. */
static po_status hand_over(po_case_run *run, size_t point, const po_job_desk *desk) {
  po_status status = PO_OK;
  for (size_t i = point + 1; !status && i < run->plan->kase->point_count; ++i) {
    if (!is_open(run, i) || !po_run_solver_same(run, point, i))
      continue;
    status = copy(run, point, i);
    if (!status)
      status = desk->take(desk->context, run, i, true);
  }
  return status ? status : desk->take(desk->context, run, point, true);
}

/* A point is handed over at once after its last round, so that an interruption loses no long solve.
 */
po_status po_job_round(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  if (run->done[job->point])
    return PO_OK;
  char *folder = po_path_join(run->output, run->plan->kase->file->name);
  po_status status = folder ? ask(run, job->point, job->round, folder, desk->stop) : PO_NO_MEMORY;
  free(folder);
  if (status || !are_enough(run, job->point, job->round))
    return status;
  end(run, job->point, job->round);
  return hand_over(run, job->point, desk);
}
