#include "po_run_solver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_input.h"
#include "po_journal.h"
#include "po_json.h"
#include "po_memory.h"
#include "po_observe.h"
#include "po_pins.h"
#include "po_recover.h"
#include "po_rounds.h"

po_status po_run_solver_begin(po_case_run *run) {
  const po_plan *plan = run->plan;
  const bool nothing = po_plan_asked(plan) == 0;
  run->chunks = 1;
  run->beyond = po_allocate(plan->kase->point_count, sizeof *run->beyond);
  if (!run->beyond)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < plan->kase->point_count; ++i) {
    po_result *result = &run->results[i];
    char why[PO_SOLVER_WHY] = "the case wants no quantity that the solver computes";
    *result = po_result_none();
    if (!nothing && po_solver_accepts(plan->solver, &plan->kase->points[i].request, why))
      continue;
    run->beyond[i] = run->done[i] = true;
    result->status = PO_UNSUPPORTED;
    result->work.seconds = (double)NAN;
    snprintf(result->reason, sizeof result->reason, "not asked: %s", why);
  }
  return PO_OK;
}

bool po_run_solver_same(const po_case_run *run, size_t point, size_t other) {
  const po_request *a = &run->plan->kase->points[point].request;
  const po_request *b = &run->plan->kase->points[other].request;
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char x[PO_KEY_TEXT_LENGTH], y[PO_KEY_TEXT_LENGTH];
    if (key == PO_KEY_SCHEME || key == PO_KEY_GRADING || key == PO_KEY_NODES ||
        key == PO_KEY_TOLERANCE || key == PO_KEY_TIME_LIMIT)
      continue;
    po_key_print(a, (po_key)key, x);
    po_key_print(b, (po_key)key, y);
    if (strcmp(x, y) != 0)
      return false;
  }
  return true;
}

/* The questions of one share, and the points that they belong to. */
typedef struct {
  po_case_run *run;
  po_question *questions;
  size_t count;
  size_t *leader; /* one a point: the question, or `count` */
  po_run_solver_taker *taken;
  void *context;
} share_of_run;

po_question po_run_solver_question(const po_case_run *run, size_t point) {
  const po_plan *plan = run->plan;
  const po_request *request = &plan->kase->points[point].request;
  po_question q = {.request = *request,
                   .want = po_plan_asked(plan),
                   .repeats = run->rounds ? PO_ROUND_SOLVES : 1,
                   .limit =
                       isnan(request->time_limit) ? plan->solver->time_limit : request->time_limit};
  snprintf(q.id, sizeof q.id, "%s", plan->kase->points[point].id);
  return q;
}

/* Collects the questions of a share. Question number k of the requested points, whether they are
 * done or not, belongs to share k modulo the number of shares; it is asked if one of its points is
 * not done. Status: PO_NO_MEMORY. */
static po_status collect(po_case_run *run, size_t share, size_t shares, share_of_run *s) {
  const po_plan *plan = run->plan;
  const size_t points = plan->kase->point_count;
  size_t *first = po_allocate(points, sizeof *first); /* of each distinct question, its point */
  size_t *number = po_allocate(points, sizeof *number);
  size_t distinct = 0;
  s->run = run;
  s->questions = po_allocate(points, sizeof *s->questions);
  s->leader = po_allocate(points, sizeof *s->leader);
  const bool made = first && number && s->questions && s->leader;
  for (size_t i = 0; made && i < points; ++i) {
    s->leader[i] = SIZE_MAX;
    if (!run->asked[i] || run->beyond[i])
      continue;
    size_t k = 0;
    while (k < distinct && !po_run_solver_same(run, first[k], i))
      ++k;
    if (k == distinct) {
      first[distinct] = i;
      number[distinct++] = SIZE_MAX;
    }
    if (run->done[i] || k % shares != share)
      continue;
    if (number[k] == SIZE_MAX) {
      number[k] = s->count;
      s->questions[s->count++] = po_run_solver_question(run, i);
    }
    s->leader[i] = number[k];
  }
  free(first);
  free(number);
  return made ? PO_OK : PO_NO_MEMORY;
}

static void clear_share(share_of_run *s) {
  free(s->questions);
  free(s->leader);
}

po_status po_run_solver_copy(const po_case_run *run, size_t point, const po_result *from,
                             po_result *to) {
  json_t *document = po_json_result(&run->plan->kase->points[point].request, from);
  po_status status = document ? po_json_read_result(document, to) : PO_NO_MEMORY;
  json_decref(document);
  if (!status && from->curve_count) {
    to->curve = po_allocate(from->curve_count, sizeof *to->curve);
    if (!to->curve)
      return PO_NO_MEMORY;
    memcpy(to->curve, from->curve, from->curve_count * sizeof *to->curve);
    to->curve_count = from->curve_count;
  }
  return status;
}

/* Stores an answer for all points of its question. */
static po_status store(share_of_run *s, size_t question, po_answer *answer, bool final) {
  po_case_run *run = s->run;
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i) {
    po_result *result = &run->results[i];
    if (s->leader[i] != question)
      continue;
    run->seconds[i] = answer->solve;
    run->processor_seconds[i] = (double)NAN;
    po_result_clear(result);
    status = po_run_solver_copy(run, i, &answer->result, result);
    if (!status && final) {
      result->work.seconds = answer->result.status ? (double)NAN : answer->solve;
      const bool again = run->done[i];
      status = s->taken(s->context, run, i, again);
    }
  }
  return status;
}

static po_status take(void *context, size_t question, po_answer *answer, bool final) {
  po_status status = PO_OK;
#pragma omp critical(po_run_finish)
  status = store(context, question, answer, final);
  return status;
}

po_status po_run_solver_keep_log(po_case_run *run, po_ask_log *log) {
  po_status status = PO_OK;
#pragma omp critical(po_run_finish)
  {
    po_ask_process *list = po_resize(run->processes, run->process_count + log->count, sizeof *list);
    if (list || !log->count) {
      run->processes = list;
      if (log->count)
        memcpy(list + run->process_count, log->processes, log->count * sizeof *list);
      run->process_count += log->count;
    } else
      status = PO_NO_MEMORY;
    if (log->folder && !run->kept_folder) {
      run->kept_folder = log->folder;
      log->folder = NULL;
    }
  }
  return status;
}

po_status po_run_solver_ask(po_case_run *run, size_t share, const char *output,
                            const volatile sig_atomic_t *stop, po_run_solver_taker *taken,
                            void *context) {
  share_of_run s = {.taken = taken, .context = context};
  po_ask_log log = {0};
  char *folder = po_path_join(output, run->plan->kase->file->name);
  po_status status = folder ? PO_OK : PO_NO_MEMORY;
#pragma omp critical(po_run_finish)
  if (!status)
    status = collect(run, share, run->chunks, &s);
  if (!status && s.count)
    status = po_ask(run->plan->solver, s.questions, s.count, folder, run->plan->solve_key, stop,
                    take, &s, &log);
  if (!status)
    status = po_run_solver_keep_log(run, &log);
  po_ask_log_clear(&log);
  clear_share(&s);
  free(folder);
  return status;
}

/* A point that was recovered is in the journal before the folder with its answer is removed: this
 * run may be killed, too. */
static po_status take_recovered(void *context, po_case_run *run, size_t point, bool again) {
  const char *output = context;
  (void)again;
  run->done[point] = true;
  return po_journal_add(run, point, output);
}

po_status po_run_solver_recover(po_case_run *run, const char *output) {
  share_of_run s = {.taken = take_recovered, .context = (void *)output};
  char *folder = po_path_join(output, run->plan->kase->file->name);
  po_status status = folder ? collect(run, 0, 1, &s) : PO_NO_MEMORY;
  if (!status)
    status = po_recover(s.questions, s.count, folder, run->plan->solve_key, take, &s);
  clear_share(&s);
  free(folder);
  return status;
}

/* Reports whether the approach of a result is one at which a jump, or the greatest tension of a
 * path with jumps, was located. */
static bool is_located(const po_check_result *item) {
  return strcmp(item->quantity, "jump_approach") == 0 ||
         strcmp(item->quantity, "hysteresis_approach") == 0 ||
         strcmp(item->quantity, "pull_off_approach") == 0;
}

static void allow_step(po_check_result *item, double step) {
  if (step <= 0 || !is_located(item) || isnan(item->error))
    return;
  item->allowance += step;
  item->ratio = fabs(item->error) / item->allowance;
  if (item->verdict == PO_OUTSIDE && fabs(item->error) <= item->allowance) {
    item->verdict = PO_WITHIN;
    snprintf(item->note, sizeof item->note, "within the approach step of the solver, %g", step);
  }
}

/* Finds out whether the stable path of a scene reaches its pull-off. */
static po_status reach(const po_case_run *run, size_t point, const volatile sig_atomic_t *stop,
                       bool *reached) {
  po_request request = run->plan->kase->points[point].request;
  po_result result;
  request.mesh = po_mesh_default();
  request.want = PO_WANT_HYSTERESIS;
  request.time_limit = (double)NAN;
  request.stop = stop;
  const po_status status = po_observe(&request, &result);
  const double path = result.has_hysteresis ? -result.hysteresis.displacement.pull_off.load : NAN;
  *reached = status || !result.has_pull_off || isnan(path) ||
             path > result.pull_off.force - 1e-4 * fabs(result.pull_off.force);
  po_result_clear(&result);
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

static po_status judge_reach(po_case_run *run, const volatile sig_atomic_t *stop) {
  enum { UNKNOWN, REACHED, NOT_REACHED };
  const po_case *kase = run->plan->kase;
  unsigned char *known = po_allocate(kase->point_count, 1);
  po_status status = known ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < run->check_results.count; ++i) {
    po_check_result *item = &run->check_results.items[i];
    if (item->whole || po_verdict_passes(item->verdict) || item->verdict == PO_NO_RESULT ||
        item->verdict == PO_MISSING_REFERENCE || item->ledger == PO_LEDGER_PIN ||
        !po_quantity_is_pull_off(item->check->quantity))
      continue;
    bool reached = true;
    if (known[item->point] == UNKNOWN) {
      status = reach(run, item->point, stop, &reached);
      known[item->point] = reached ? REACHED : NOT_REACHED;
    }
    if (known[item->point] != NOT_REACHED)
      continue;
    item->verdict = PO_NOT_REACHABLE;
    run->coverage.not_reachable += 1;
    snprintf(item->note, sizeof item->note,
             "the pull-off of the branch lies on equilibria that no test at given approach passes");
  }
  free(known);
  return status;
}

/* Of all points of the case, also if the run is limited to some of them. */
static void count_coverage(po_case_run *run) {
  const po_case *kase = run->plan->kase;
  run->coverage = (po_coverage){.points = kase->point_count};
  for (size_t i = 0; i < kase->point_count; ++i) {
    const bool judged = run->asked[i] && !run->beyond[i];
    run->coverage.asked += judged;
    for (unsigned c = 0; c < kase->file->checks_count; ++c) {
      const po_check *check = &kase->file->checks[c];
      if (!po_check_concerns(check, &kase->points[i].request) ||
          run->plan->references[c].type == PO_REFERENCE_ABSENT)
        continue;
      run->coverage.checks += 1;
      run->coverage.made += judged && po_plan_covers(run->plan, check);
    }
  }
}

po_status po_run_solver_judge(po_case_run *run, const volatile sig_atomic_t *stop) {
  const po_solver *solver = run->plan->solver;
  count_coverage(run);
  for (size_t i = 0; i < run->check_results.count; ++i)
    allow_step(&run->check_results.items[i], solver->approach_step);
  return solver->unstable ? PO_OK : judge_reach(run, stop);
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

json_t *po_run_solver_json(const po_case_run *run) {
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
