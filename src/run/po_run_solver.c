#include "po_run_solver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_input.h"
#include "po_job.h"
#include "po_journal.h"
#include "po_json.h"
#include "po_memory.h"
#include "po_recover.h"

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
  const po_job_desk *desk;
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
      status = s->desk->take(s->desk->context, run, i, true);
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

po_status po_job_share(po_case_run *run, const po_job *job, const po_job_desk *desk) {
  share_of_run s = {.desk = desk};
  po_ask_log log = {0};
  char *folder = po_path_join(run->output, run->plan->kase->file->name);
  po_status status = folder ? PO_OK : PO_NO_MEMORY;
#pragma omp critical(po_run_finish)
  if (!status)
    status = collect(run, job->point, run->chunks, &s);
  if (!status && s.count)
    status = po_ask(run->plan->solver, s.questions, s.count, folder, run->plan->solve_key,
                    desk->stop, take, &s, &log);
  if (!status)
    status = po_run_solver_keep_log(run, &log);
  po_ask_log_clear(&log);
  clear_share(&s);
  free(folder);
  return status;
}

/* A point that was recovered is in the journal before the folder with its answer is removed: this
 * run may be killed, too. */
static po_status take_recovered(void *context, po_case_run *run, size_t point, bool last) {
  (void)context;
  run->done[point] = last;
  return po_journal_add(run, point, run->output);
}

po_status po_run_solver_recover(po_case_run *run) {
  static const po_job_desk JOURNAL = {.take = take_recovered};
  share_of_run s = {.desk = &JOURNAL};
  char *folder = po_path_join(run->output, run->plan->kase->file->name);
  po_status status = folder ? collect(run, 0, 1, &s) : PO_NO_MEMORY;
  if (!status)
    status = po_recover(s.questions, s.count, folder, run->plan->solve_key, take, &s);
  clear_share(&s);
  free(folder);
  return status;
}
