#include "po_job.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_ask_folder.h"
#include "po_deadline.h"
#include "po_input.h"
#include "po_json.h"
#include "po_memory.h"
#include "po_result_rows.h"
#include "po_store.h"

/* Reports whether an external solver is asked the same for two points: they differ only in the mesh
 * and the time limit of this program. */
static bool is_same(const po_case_run *run, size_t point, size_t other) {
  const po_request *a = &run->plan->kase->points[point].request;
  const po_request *b = &run->plan->kase->points[other].request;
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char x[PO_KEY_TEXT_LENGTH], y[PO_KEY_TEXT_LENGTH];
    if (key == PO_KEY_SCHEME || key == PO_KEY_GRADING || key == PO_KEY_NODES ||
        key == PO_KEY_TOLERANCE || key == PO_KEY_TIME_LIMIT)
      continue;
    po_key_print(a, key, x);
    po_key_print(b, key, y);
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
  const po_job_desk *desk;
} share_of_run;

/* Returned: the question of a point. */
static po_question question_of(const po_case_run *run, size_t point) {
  const po_plan *plan = run->plan;
  const po_request *request = &plan->kase->points[point].request;
  po_question q = {.request = *request,
                   .want = po_plan_asked(plan),
                   .repeats = run->starts ? PO_ROUND_SOLVES : 1,
                   .limit =
                       isnan(request->time_limit) ? plan->solver->time_limit : request->time_limit};
  snprintf(q.id, sizeof q.id, "%s", plan->kase->points[point].id);
  return q;
}

/* Collects the questions of a share. Question number k of the requested points, whether they are
 * done or not, belongs to share k modulo the number of shares; it is asked if one of its points is
 * not done. Status: PO_NO_MEMORY. */
static po_status collect_questions(po_case_run *run, size_t share, size_t shares, share_of_run *s) {
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
    if (!run->points[i].asked || run->points[i].beyond)
      continue;
    size_t k = 0;
    while (k < distinct && !is_same(run, first[k], i))
      ++k;
    if (k == distinct) {
      first[distinct] = i;
      number[distinct++] = SIZE_MAX;
    }
    if (run->points[i].done || k % shares != share)
      continue;
    if (number[k] == SIZE_MAX) {
      number[k] = s->count;
      s->questions[s->count++] = question_of(run, i);
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

/* Copies a result of a point. Status: PO_NO_MEMORY. */
static po_status copy_result(const po_case_run *run, size_t point, const po_result *from,
                             po_result *to) {
  json_t *document = po_json_result(&run->plan->kase->points[point].request, from);
  po_json_set_all(&document, po_json_of(&PO_BRANCH_ROWS, from));
  const po_status status = document ? po_json_read_result(document, to) : PO_NO_MEMORY;
  json_decref(document);
  return status;
}

/* Stores an answer for all points of its question. */
static po_status store_answer(share_of_run *s, size_t question, po_answer *answer, bool final) {
  po_case_run *run = s->run;
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i) {
    po_result *result = &run->points[i].result;
    if (s->leader[i] != question)
      continue;
    run->points[i].rounds->seconds = answer->solve;
    run->points[i].rounds->processor_seconds = (double)NAN;
    po_result_clear(result);
    status = copy_result(run, i, &answer->result, result);
    if (!status && final) {
      result->work.seconds = answer->result.status ? (double)NAN : answer->solve;
      status = s->desk->take(s->desk->context, run, i, true);
    }
  }
  return status;
}

static po_status take_answer(void *context, size_t question, po_answer *answer, bool final) {
  po_status status = PO_OK;
#pragma omp critical(po_run_finish)
  status = store_answer(context, question, answer, final);
  return status;
}

/* Adds what processes used. Status: PO_NO_MEMORY. */
static po_status keep_log(po_case_run *run, const po_ask_log *log) {
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
  }
  return status;
}

po_status po_job_share(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  share_of_run s = {.desk = desk};
  po_ask_log log = {0};
  po_status status = PO_OK;
#pragma omp critical(po_run_finish)
  status = collect_questions(run, job->point, run->chunks, &s);
  if (!status && s.count)
    status = po_ask(run->plan->solver, s.questions, s.count, run->folder.text, run->plan->solve_key,
                    desk->stop, take_answer, &s, &log);
  if (!status)
    status = keep_log(run, &log);
  po_ask_log_clear(&log);
  clear_share(&s);
  return status;
}

/* A point that was recovered is stored before the folder with its answer is removed: this run may
 * be killed, too. */
static po_status take_recovered(void *context, po_case_run *run, size_t point, bool last) {
  (void)context;
  run->points[point].done = last;
  return po_store_put(run, point, run->folder.text);
}

po_status po_run_solver_recover(po_case_run *run) {
  static const po_job_desk STORE = {.take = take_recovered};
  share_of_run s = {.desk = &STORE};
  po_status status = collect_questions(run, 0, 1, &s);
  if (!status)
    status =
        po_recover(s.questions, s.count, run->folder.text, run->plan->solve_key, take_answer, &s);
  clear_share(&s);
  return status;
}

/* Elapsed seconds of a first solve that is not repeated. Compilation of a solver of a few pages,
 * for which the second solve is made, takes less. The example solvers need 40 % less time for the
 * case solver_times than with two solves of each scene. */
static const double LONG_SOLVE = 5;

static bool is_open(const po_case_run *run, size_t point) {
  return run->points[point].asked && !run->points[point].done;
}

bool po_run_solver_leads(const po_case_run *run, size_t point) {
  if (!is_open(run, point))
    return false;
  for (size_t i = 0; i < point; ++i)
    if (is_open(run, i) && is_same(run, i, point))
      return false;
  return true;
}

/* Measures start and end of the program once a round. */
static po_status measure_start(po_case_run *run, unsigned round,
                               const volatile sig_atomic_t *stop) {
  po_ask_log log = {0};
  if (!isnan(run->starts[round].start_wall))
    return PO_OK;
  const po_status status = po_ask(run->plan->solver, NULL, 0, run->folder.text,
                                  run->plan->solve_key, stop, NULL, NULL, &log);
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

static po_status take_round(void *context, size_t question, po_answer *answer, bool final) {
  listener *l = context;
  po_result *result = &l->run->points[l->point].result;
  (void)question;
  (void) final;
  if (answer->repeat == 1)
    l->round.first = answer->solve;
  else
    l->round.seconds = answer->solve;
  l->enough = !answer->result.status && answer->repeat == 1 &&
              po_clock_wall() - l->begin > l->round.start_wall + LONG_SOLVE;
  if (l->enough)
    l->round.seconds = answer->solve;
  if (answer->result.status || (l->number == 0 && answer->repeat == 1)) {
    po_result_clear(result);
    const po_status status = copy_result(l->run, l->point, &answer->result, result);
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
static po_status ask_round(po_case_run *run, size_t point, unsigned round,
                           const volatile sig_atomic_t *stop) {
  po_round *made = &run->points[point].rounds[round];
  made->seconds = made->processor_seconds = NAN;
  po_status status = measure_start(run, round, stop);
  const po_question question = question_of(run, point);
  listener l = {.run = run,
                .point = point,
                .number = round,
                .begin = po_clock_wall(),
                .round = run->starts[round]};
  l.round.seconds = NAN;
  po_ask_log log = {0};
  if (!status)
    status = po_ask(run->plan->solver, &question, 1, run->folder.text, run->plan->solve_key, stop,
                    take_round, &l, &log);
  if (status == PO_INTERRUPTED && l.enough && !(stop && *stop))
    status = PO_OK;
  if (status) {
    po_ask_log_clear(&log);
    return status;
  }
  const double solves = l.enough ? 1 : PO_ROUND_SOLVES;
  take_process(&l.round, &log);
  if (isnan(l.round.seconds)) /* it reports no time */
    l.round.seconds = fmax(l.round.wall - l.round.start_wall, 0) / solves;
  l.round.processor_seconds = fmax(l.round.processor - l.round.start_processor, 0) / solves;
  *made = l.round;
  status = keep_log(run, &log);
  po_ask_log_clear(&log);
  return status;
}

/* Reports whether a point needs no further round: `round` was the last one, it failed, or its
 * solves took long enough. */
static bool are_enough(const po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  return round + 1 == repeats || run->points[point].result.status != PO_OK ||
         po_times_are_enough(run->points[point].rounds, round + 1);
}

/* Computes the medians of a point whose last round was number `round`. */
static void end_rounds(po_case_run *run, size_t point, unsigned round) {
  const unsigned repeats = run->plan->kase->repeats;
  po_result *result = &run->points[point].result;
  po_round *rounds = run->points[point].rounds;
  for (unsigned r = result->status ? 0 : round + 1; r < repeats; ++r)
    rounds[r].seconds = rounds[r].processor_seconds = NAN;
  result->work.seconds = po_times_median(rounds, repeats);
}

/* Copies result and times of a point to another one with the same question. */
static po_status copy_point(po_case_run *run, size_t number, const po_point_run *point) {
  po_point_run *to = &run->points[number];
  po_result_clear(&to->result);
  const po_status status = copy_result(run, number, &point->result, &to->result);
  memcpy(to->rounds, point->rounds, run->plan->kase->repeats * sizeof *to->rounds);
  to->result.work.seconds = point->result.work.seconds;
  to->interleaved = point->interleaved;
  return status;
}

/* Hands over a point after its last round, and before it all other points with its question. */
static po_status hand_over(po_case_run *run, size_t point, const po_job_desk *desk) {
  po_status status = PO_OK;
  for (size_t i = point + 1; !status && i < run->plan->kase->point_count; ++i) {
    if (!is_open(run, i) || !is_same(run, point, i))
      continue;
    status = copy_point(run, i, &run->points[point]);
    if (!status)
      status = desk->take(desk->context, run, i, true);
  }
  return status ? status : desk->take(desk->context, run, point, true);
}

/* A point is handed over at once after its last round, so that an interruption loses no long solve.
 */
po_status po_job_round(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  if (run->points[job->point].done)
    return PO_OK;
  const po_status status = ask_round(run, job->point, job->round, desk->stop);
  if (status || !are_enough(run, job->point, job->round))
    return status;
  end_rounds(run, job->point, job->round);
  return hand_over(run, job->point, desk);
}
