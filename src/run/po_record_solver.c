#include "po_record_solver.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* A clock agrees if the time that it misses is less than this share of the measured time, plus this
 * share of the start-up time, whose variation under load is not known. */
static const double MISSED_SHARE = 0.25, START_SHARE = 0.5;

/* The time that a solver may report beyond that of its process: a share, and seconds. The process
 * is measured from before its start until after its end. */
static const double EXCESS_SHARE = 0.01, EXCESS_SECONDS = 0.02;

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

/* What the times of a point say about the clock of the solver. "more": a process reported more time
 * than it took. "less": in every round it reported clearly less than it took beyond its start.
 * "none": it reports no times, or has no result. Otherwise "agrees". */
static const char *clock_of(const po_case_run *run, size_t point) {
  const unsigned repeats = run->plan->kase->repeats;
  const po_round *rounds = rounds_of(run, point);
  unsigned known = 0, less = 0;
  /* the process of a failed solve may do more than it reports */
  for (unsigned r = 0; !run->results[point].status && r < repeats; ++r) {
    const po_round *round = &rounds[r];
    const double taken = fmax(round->wall - round->start_wall, 0);
    if (isnan(round->reported) || isnan(round->wall))
      continue;
    known += 1;
    if (round->reported > (1 + EXCESS_SHARE) * round->wall + EXCESS_SECONDS)
      return "more";
    less += taken - round->reported > MISSED_SHARE * taken + START_SHARE * round->start_wall;
  }
  return !known ? "none" : less == known ? "less" : "agrees";
}

size_t po_record_solver_disagreements(const po_case_run *run) {
  size_t count = 0;
  for (size_t i = 0; run->rounds && i < run->plan->kase->point_count; ++i) {
    const char *clock = clock_of(run, i);
    count += run->asked[i] && (strcmp(clock, "more") == 0 || strcmp(clock, "less") == 0);
  }
  return count;
}

json_t *po_record_solver_timing(const po_case_run *run, size_t point) {
  if (!run->rounds)
    return json_null();
  json_t *object = po_json_empty_object();
  for (size_t c = 0; c < COLUMN_COUNT; ++c) {
    json_t *array = po_json_empty_array();
    for (unsigned r = 0; r < run->plan->kase->repeats; ++r)
      po_json_append(&array, po_json_number(*cell(&rounds_of(run, point)[r], c)));
    po_json_set(&object, COLUMNS[c].name, array);
  }
  po_json_set(&object, "clock", po_json_text(clock_of(run, point)));
  po_json_set(&object, "interleaved", po_json_flag(run->interleaved[point]));
  return object;
}

po_status po_record_solver_read_timing(po_case_run *run, size_t point, const json_t *timing) {
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

static json_t *processes_json(const po_case_run *run) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < run->process_count; ++i) {
    const po_ask_process *p = &run->processes[i];
    po_json_append(&array, PO_JSON_OBJECT({"asked", po_json_count(p->asked)},
                                          {"answered", po_json_count(p->found.answered)},
                                          {"seconds", po_json_number(p->wall)},
                                          {"processor_seconds", po_json_number(p->processor)},
                                          {"first_answer", po_json_number(p->first)},
                                          {"reported_seconds", po_json_number(p->found.reported)},
                                          {"left_behind", po_json_integer(p->left)}));
  }
  return array;
}

json_t *po_record_solver(const po_case_run *run) {
  const po_solver *solver = run->plan->solver;
  const po_coverage *c = &run->coverage;
  if (!solver)
    return json_null();
  json_t *command = po_json_empty_array();
  for (unsigned i = 0; i < solver->file->command_count; ++i)
    po_json_append(&command, po_json_text(solver->file->command[i]));
  json_t *quantities = po_json_empty_array();
  for (unsigned i = 0; i < solver->file->can.quantities_count; ++i)
    po_json_append(&quantities, po_json_text(solver->file->can.quantities[i]));
  return PO_JSON_OBJECT(
      {"name", po_json_text(solver->name)}, {"manifest", po_json_text(solver->path)},
      {"knob", po_json_text(solver->file->knob ? solver->file->knob->name : NULL)},
      {"knob_value", po_json_text(solver->knob)}, {"command", command}, {"quantities", quantities},
      {"unstable", po_json_flag(solver->unstable)}, {"sha256", po_json_text(solver->digest)},
      {"coverage",
       PO_JSON_OBJECT({"points", po_json_count(c->points)}, {"asked", po_json_count(c->asked)},
                      {"checks", po_json_count(c->checks)}, {"made", po_json_count(c->made)},
                      {"not_reachable", po_json_count(c->not_reachable)})},
      {"processes", processes_json(run)});
}
