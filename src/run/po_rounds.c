#include "po_rounds.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_memory.h"
#include "po_run_solver.h"
#include "po_times.h"

/* A clock agrees if the time that it misses is less than this share of the measured time, plus this
 * share of the start-up time, whose variation under load is not known. */
static const double MISSED_SHARE = 0.25, START_SHARE = 0.5;

/* The time that a solver may report beyond that of its process: a share, and seconds. The process
 * is measured from before its start until after its end. */
static const double EXCESS_SHARE = 0.01, EXCESS_SECONDS = 0.02;

/* Elapsed seconds of a first solve that is not repeated. Compilation of a solver of a few pages,
 * for which the second solve is made, takes less. The example solvers need 40 % less time for the
 * case solver_times than with two solves of each scene. */
static const double LONG_SOLVE = 5;

/* Names of the arrays in the record, and the members that they contain. */
static const struct {
  const char *name;
  size_t place;
} COLUMNS[] = {{"first_seconds", offsetof(po_round, first)},
               {"reported_seconds", offsetof(po_round, reported)},
               {"process_seconds", offsetof(po_round, wall)},
               {"process_processor_seconds", offsetof(po_round, processor)},
               {"start_seconds", offsetof(po_round, start_wall)},
               {"start_processor_seconds", offsetof(po_round, start_processor)}};
enum { COLUMN_COUNT = sizeof COLUMNS / sizeof *COLUMNS };

static double *cell(po_round *round, size_t column) {
  return (double *)(void *)((char *)round + COLUMNS[column].place);
}

static po_round *rounds_of(const po_case_run *run, size_t point) {
  return run->rounds + point * run->plan->kase->repeats;
}

static po_round unknown(void) {
  return (po_round){NAN, NAN, NAN, NAN, NAN, NAN, NAN};
}

po_status po_rounds_create(po_case_run *run) {
  const unsigned repeats = run->plan->kase->repeats;
  const size_t points = run->plan->kase->point_count;
  run->rounds = po_allocate(points * repeats, sizeof *run->rounds);
  run->starts = po_allocate(repeats, sizeof *run->starts);
  run->interleaved = po_allocate(points, sizeof *run->interleaved);
  if (!run->rounds || !run->starts || !run->interleaved)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < points * repeats; ++i)
    run->rounds[i] = unknown();
  for (unsigned r = 0; r < repeats; ++r)
    run->starts[r] = unknown();
  return PO_OK;
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

/* Returned: the time of a process beyond that of its start. */
static double beyond_start(double whole, double start) {
  return whole > start ? whole - start : 0;
}

po_status po_rounds_ask(po_case_run *run, size_t point, unsigned round, const char *folder,
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
    l.round.later = beyond_start(l.round.wall, l.round.start_wall) / solves;
  rounds_of(run, point)[round] = l.round;
  run->seconds[place] = l.round.later;
  run->processor_seconds[place] = beyond_start(l.round.processor, l.round.start_processor) / solves;
  status = po_run_solver_keep_log(run, &log);
  po_ask_log_clear(&log);
  return status;
}

bool po_rounds_are_enough(const po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  return round + 1 == repeats || run->results[point].status != PO_OK ||
         po_times_are_enough(run->processor_seconds + point * repeats, round + 1);
}

void po_rounds_end(po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  po_result *result = &run->results[point];
  double *seconds = run->seconds + point * repeats;
  for (unsigned r = round + 1; r < repeats; ++r)
    seconds[r] = run->processor_seconds[point * repeats + r] = NAN;
  result->work.seconds = result->status ? (double)NAN : po_times_median(seconds, repeats);
  for (unsigned r = 0; result->status && r < repeats; ++r)
    seconds[r] = run->processor_seconds[point * repeats + r] = NAN;
}

po_status po_rounds_copy(po_case_run *run, size_t point, size_t to, bool *copied) {
  const unsigned repeats = run->plan->kase->repeats;
  const size_t from_place = point * repeats, to_place = to * repeats;
  *copied = is_open(run, to) && po_run_solver_same(run, point, to);
  if (!*copied || point == to)
    return PO_OK;
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

const char *po_rounds_clock(const po_case_run *run, size_t point) {
  const unsigned repeats = run->plan->kase->repeats;
  const po_round *rounds = rounds_of(run, point);
  unsigned known = 0, less = 0;
  /* the process of a failed solve may do more than it reports */
  for (unsigned r = 0; !run->results[point].status && r < repeats; ++r) {
    const po_round *round = &rounds[r];
    const double taken = beyond_start(round->wall, round->start_wall);
    if (isnan(round->reported) || isnan(round->wall))
      continue;
    known += 1;
    if (round->reported > (1 + EXCESS_SHARE) * round->wall + EXCESS_SECONDS)
      return "more";
    less += taken - round->reported > MISSED_SHARE * taken + START_SHARE * round->start_wall;
  }
  return !known ? "none" : less == known ? "less" : "agrees";
}

size_t po_rounds_disagreements(const po_case_run *run) {
  size_t count = 0;
  for (size_t i = 0; run->rounds && i < run->plan->kase->point_count; ++i) {
    const char *clock = po_rounds_clock(run, i);
    count += run->asked[i] && (strcmp(clock, "more") == 0 || strcmp(clock, "less") == 0);
  }
  return count;
}

json_t *po_rounds_json(const po_case_run *run, size_t point) {
  if (!run->rounds)
    return json_null();
  json_t *object = po_json_empty_object();
  for (size_t c = 0; c < COLUMN_COUNT; ++c) {
    json_t *array = po_json_empty_array();
    for (unsigned r = 0; r < run->plan->kase->repeats; ++r)
      po_json_append(&array, po_json_number(*cell(&rounds_of(run, point)[r], c)));
    po_json_set(&object, COLUMNS[c].name, array);
  }
  po_json_set(&object, "clock", po_json_text(po_rounds_clock(run, point)));
  po_json_set(&object, "interleaved", po_json_flag(run->interleaved[point]));
  return object;
}

po_status po_rounds_read(po_case_run *run, size_t point, const json_t *timing) {
  const unsigned repeats = run->plan->kase->repeats;
  if (!run->rounds)
    return PO_OK;
  for (size_t c = 0; c < COLUMN_COUNT; ++c) {
    const json_t *array = json_object_get(timing, COLUMNS[c].name);
    if (json_array_size(array) != repeats)
      return PO_NOT_FOUND;
    for (unsigned r = 0; r < repeats; ++r) {
      const json_t *value = json_array_get(array, r);
      *cell(&rounds_of(run, point)[r], c) =
          json_is_number(value) ? json_number_value(value) : (double)NAN;
    }
  }
  run->interleaved[point] = json_is_true(json_object_get(timing, "interleaved"));
  return PO_OK;
}
