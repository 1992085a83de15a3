#include "po_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_compare.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_journal.h"
#include "po_judge.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_observe.h"
#include "po_progress.h"
#include "po_record.h"
#include "po_rounds.h"
#include "po_run_solver.h"
#include "po_tasks.h"
#include "po_times.h"

/* The data that the threads of a run share. */
typedef struct {
  po_case_run *runs;
  const po_run_options *options;
  int jobs;
  po_progress progress;
  bool broken;               /* a failure other than that of a solve: no further solve is started */
  po_status status;          /* of that failure */
  char message[512];         /* of that failure; po_fail stores messages by thread */
  size_t starved;            /* number of solves that ended for lack of memory */
  char starved_message[512]; /* of the first of them */
} po_crew;

static bool must_end(const po_crew *crew) {
  bool broken;
#pragma omp atomic read
  broken = crew->broken;
  return broken || (crew->options->stop && *crew->options->stop);
}

/* Stores the status and ends the run. To be called inside the critical section. */
static void give_up(po_crew *crew, po_status status) {
  if (crew->broken)
    return;
  crew->status = status;
  snprintf(crew->message, sizeof crew->message, "%s", po_message());
#pragma omp atomic write
  crew->broken = true;
}

/* Returned: the folder of the records of a case. */
static const char *folder_of(const po_crew *crew, const po_case_run *run) {
  return run->output ? run->output : crew->options->output;
}

/* Reports whether the results of a point are compared: it is requested, and an external solver was
 * asked for it. */
static bool is_judged(const po_case_run *run, size_t point) {
  return run->asked[point] && !(run->beyond && run->beyond[point]);
}

static bool is_measured(const po_case_run *run, const po_check *measure) {
  return !run->plan->solver || po_solver_computes(run->plan->solver, measure->quantity);
}

/* The share of solved points among those that an external solver was asked for. */
static po_status compare_share(po_case_run *run, const po_check *check,
                               const po_reference *reference) {
  const po_case *kase = run->plan->kase;
  bool *judged = po_allocate(kase->point_count, sizeof *judged);
  if (!judged)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < kase->point_count; ++i)
    judged[i] = is_judged(run, i);
  const po_status status =
      po_compare_share(kase, judged, check, reference, run->results, &run->check_results);
  free(judged);
  return status;
}

static po_status compare_all(po_case_run *run, const volatile sig_atomic_t *stop) {
  const po_case *kase = run->plan->kase;
  po_status status = PO_OK;
  for (unsigned c = 0; !status && c < kase->file->checks_count; ++c) {
    const po_check *check = &kase->file->checks[c];
    if (!po_plan_covers(run->plan, check))
      continue;
    if (check->quantity == PO_SOLVED_SHARE) {
      status = compare_share(run, check, &run->plan->references[c]);
      continue;
    }
    if (po_check_is_traced(check)) {
      status = po_compare_traced(kase, run->asked, check, &run->plan->references[c], run->results,
                                 run->traces, &run->check_results);
      continue;
    }
    for (size_t i = 0; !status && i < kase->point_count; ++i)
      if (is_judged(run, i))
        status = po_compare(kase, i, check, &run->plan->references[c], &run->results[i],
                            &run->check_results);
  }
  for (unsigned m = 0; !status && m < kase->file->measure_count; ++m)
    for (size_t i = 0; !status && i < kase->point_count; ++i)
      if (is_judged(run, i) && is_measured(run, &kase->file->measure[m]))
        status = po_compare(kase, i, &kase->file->measure[m], &run->plan->measures[m],
                            &run->results[i], &run->measured);
  if (!status)
    po_judge(&run->check_results);
  return !status && run->plan->solver ? po_run_solver_judge(run, stop) : status;
}

static void report_finished(po_crew *crew, const po_case_run *run) {
  char kept[64] = "", part[64] = "";
  if (run->kept)
    snprintf(kept, sizeof kept, " (kept)");
  else if (run->resumed)
    snprintf(kept, sizeof kept, " (%zu points kept)", run->resumed);
  if (!po_case_run_is_whole(run))
    snprintf(part, sizeof part, " of %zu", run->plan->kase->point_count);
  po_progress_say(&crew->progress, "%s: %zu%s points, %zu checks: %s%s", po_plan_name(run->plan),
                  run->asked_count, part, run->check_results.count, po_case_run_verdict(run), kept);
}

/* Makes the checks and writes the record of a case whose points are all solved. */
static po_status finish_case(po_crew *crew, po_case_run *run) {
  const po_run_options *options = crew->options;
  po_status status = compare_all(run, options->stop);
  if (!status && po_case_run_is_whole(run) && strcmp(run->old_key, run->plan->key) != 0)
    status = po_record_write(run, folder_of(crew, run), crew->jobs, options->stop);
  else if (!status && !po_case_run_is_whole(run) && run->plan->solver && !run->kept)
    status = po_record_write_part(run, folder_of(crew, run), crew->jobs, options->stop);
  run->finished = status == PO_OK;
  if (!status && po_case_run_is_whole(run))
    status = po_journal_remove(run, folder_of(crew, run));
  if (!status && !(options->brief && crew->progress.live))
    report_finished(crew, run);
  return status;
}

/* Adds a point to the journal, except the last point of a whole case: the record follows at once.
 */
static po_status keep_point(const po_crew *crew, const po_case_run *run, size_t point) {
  if (run->pending == 0 && po_case_run_is_whole(run))
    return PO_OK;
  return po_journal_add(run, point, folder_of(crew, run));
}

/* Solves a point. The first round gives the result, later rounds only the time. */
static void solve_round(const po_crew *crew, po_case_run *run, const po_task *task) {
  const unsigned repeats = run->plan->kase->repeats;
  const size_t place = task->point * repeats + task->round;
  po_request request = po_plan_request(run->plan, task->point);
  po_result again = {0}, *first = &run->results[task->point];
  po_result *result = task->round ? &again : first;
  request.stop = crew->options->stop;
  const double begin = po_clock_thread();
  const po_status status = po_observe(&request, result);
  run->processor_seconds[place] = po_clock_thread() - begin;
  run->seconds[place] = result->work.seconds;
  if (status && !result->reason[0])
    snprintf(result->reason, sizeof result->reason, "%.250s", po_message());
  if (status == PO_NO_MEMORY)
    first->status = status;
  po_result_clear(&again);
}

static void solve_point(const po_crew *crew, po_case_run *run, const po_task *task) {
  const unsigned repeats = run->plan->kase->repeats;
  double *seconds = run->seconds + task->point * repeats;
  double *processor_seconds = run->processor_seconds + task->point * repeats;
  if (po_times_are_enough(processor_seconds, task->round))
    seconds[task->round] = processor_seconds[task->round] = (double)NAN;
  else
    solve_round(crew, run, task);
  if (task->round + 1 == repeats)
    run->results[task->point].work.seconds = po_times_median(seconds, repeats);
}

/* Counts and stores a point after its last round. */
static po_status end_point(po_crew *crew, po_case_run *run, size_t point) {
  run->pending -= 1;
  run->done[point] = true;
  const po_status status = keep_point(crew, run, point);
  if (status || run->pending)
    return status;
  const po_status finished = finish_case(crew, run);
  return finished == PO_INTERRUPTED ? po_journal_add(run, point, folder_of(crew, run)) : finished;
}

/* Returned: the effort of a solve relative to a full trace, for the estimate of the remaining time.
 * A scene in parameter continuation takes about a tenth. */
static double effort(const po_case_run *run) {
  return run->plan->kase->series_length > 1 ? 0.1 : 1;
}

/* Reports whether a solve ended for lack of memory. This is no result: the point is not stored, and
 * the next run solves it again. */
static bool is_starved(po_crew *crew, const po_case_run *run, size_t point) {
  const po_result *result = &run->results[point];
  if (result->status != PO_NO_MEMORY)
    return false;
  if (!crew->starved)
    snprintf(crew->starved_message, sizeof crew->starved_message, "%s %s: %s",
             po_plan_name(run->plan), run->plan->kase->points[point].label, result->reason);
  return true;
}

/* Counts one solve of a requested point. To be called inside the critical section. */
static po_status take_point(po_crew *crew, po_case_run *run, size_t point, unsigned round) {
  if (run->done[point] || !run->asked[point])
    return PO_OK;
  char what[128];
  snprintf(what, sizeof what, "%.40s %.60s", po_plan_name(run->plan),
           run->plan->kase->points[point].label);
  po_progress_step(&crew->progress, what, effort(run));
  if (round + 1 < run->plan->kase->repeats)
    return PO_OK;
  if (!is_starved(crew, run, point))
    return end_point(crew, run, point);
  crew->starved += 1;
  return PO_OK;
}

/* Stores a point that an external solver has answered. Its answer is in the journal before the next
 * one is read. To be called inside the critical section. */
static po_status take_solved(void *context, po_case_run *run, size_t point, bool again) {
  po_crew *crew = context;
  char what[128];
  if (!again) {
    snprintf(what, sizeof what, "%.40s %.60s", po_plan_name(run->plan),
             run->plan->kase->points[point].label);
    po_progress_step(&crew->progress, what, effort(run));
    run->pending -= 1;
    run->done[point] = true;
  }
  return po_journal_add(run, point, folder_of(crew, run));
}

/* Asks an external solver for its share of the points. */
static void do_share(po_crew *crew, const po_task *task) {
  po_case_run *run = &crew->runs[task->run];
  const double begin = po_clock_wall();
  po_no_memory_forget();
  po_status status = po_run_solver_ask(run, task->point, folder_of(crew, run), crew->options->stop,
                                       take_solved, crew);
#pragma omp critical(po_run_finish)
  {
    run->elapsed += po_clock_wall() - begin;
    run->shares_left -= 1;
    if (!status && run->pending == 0 && run->shares_left == 0)
      status = finish_case(crew, run);
    status = po_no_memory_or(status);
    if (status && status != PO_INTERRUPTED)
      give_up(crew, status);
  }
}

/* Stores a point of an external solver after its last round, which is number `round`, for all
 * points with its question. */
static po_status end_rounds(po_crew *crew, po_case_run *run, size_t point, unsigned round) {
  po_status status = PO_OK;
  po_rounds_end(run, point, round);
  for (size_t i = point; !status && i < run->plan->kase->point_count; ++i) {
    bool copied = false;
    status = po_rounds_copy(run, point, i, &copied);
    if (!status && copied && i != point)
      status = take_solved(crew, run, i, false);
  }
  if (!status)
    status = take_solved(crew, run, point, false);
  return !status && run->pending == 0 ? finish_case(crew, run) : status;
}

/* Times one round of a question of an external solver, unless an earlier one was the last. A point
 * is stored at once after its last round, so that an interruption loses no long solve. */
static void do_round(po_crew *crew, const po_task *task) {
  po_case_run *run = &crew->runs[task->run];
  if (run->done[task->point])
    return;
  const double begin = po_clock_wall();
  char *folder = po_path_join(folder_of(crew, run), run->plan->kase->file->name);
  po_no_memory_forget();
  po_status status = folder
                         ? po_rounds_ask(run, task->point, task->round, folder, crew->options->stop)
                         : PO_NO_MEMORY;
  run->elapsed += po_clock_wall() - begin;
  if (!status && po_rounds_are_enough(run, task->point, task->round))
    status = end_rounds(crew, run, task->point, task->round);
  status = po_no_memory_or(status);
  if (status && status != PO_INTERRUPTED)
    give_up(crew, status);
  free(folder);
}

static void do_task(po_crew *crew, const po_task *task) {
  po_case_run *run = &crew->runs[task->run];
  if (run->rounds) {
    do_round(crew, task);
    return;
  }
  if (run->plan->solver) {
    do_share(crew, task);
    return;
  }
  const size_t points = run->plan->kase->series_length;
  const double begin = po_clock_wall();
  po_status status = PO_OK;
  po_no_memory_forget();
  if (points > 1)
    status = po_run_series(run, task->point, crew->options->stop);
  else {
    solve_point(crew, run, task);
    po_no_memory_forget(); /* the status of the result reports it */
  }
  const bool stopped = crew->options->stop && *crew->options->stop;
#pragma omp critical(po_run_finish)
  if (!stopped) {
    run->elapsed += po_clock_wall() - begin;
    for (size_t k = 0; k < points && !status; ++k)
      status = take_point(crew, run, task->point + k, task->round);
    status = po_no_memory_or(status);
    if (status)
      give_up(crew, status);
  }
}

static void begin_progress(po_crew *crew, size_t count) {
  size_t solves = 0;
  double all = 0;
  for (size_t r = 0; r < count; ++r) {
    const po_case_run *run = &crew->runs[r];
    const unsigned rounds = run->plan->solver ? 1 : run->plan->kase->repeats;
    const size_t pending = run->finished ? 0 : run->pending * rounds;
    solves += pending;
    all += (double)pending * effort(run);
  }
  po_progress_begin(&crew->progress, solves, all);
}

/* Does the tasks that may run in parallel. With one thread no parallel region is used, because it
 * allocates memory and ends the program if there is none. */
static void do_shared(po_crew *crew, const po_task *tasks, size_t count, int threads) {
  if (threads <= 1) {
    for (size_t i = 0; i < count && !must_end(crew); ++i)
      do_task(crew, &tasks[i]);
    return;
  }
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (size_t i = 0; i < count; ++i)
    if (!must_end(crew))
      do_task(crew, &tasks[i]);
}

/* Reports whether this program solves a point of a case in the rounds that follow. */
static bool is_open_here(const po_crew *crew, size_t count, const po_case *kase, size_t point) {
  for (size_t k = 0; k < count; ++k) {
    const po_case_run *run = &crew->runs[k];
    if (run->plan->kase == kase && !run->plan->solver && !run->finished && run->asked[point] &&
        !run->done[point])
      return true;
  }
  return false;
}

/* Writes the record of a finished case once more. */
static po_status rewrite(po_crew *crew, po_case_run *run) {
  const char *folder = folder_of(crew, run);
  const volatile sig_atomic_t *stop = crew->options->stop;
  return po_case_run_is_whole(run) ? po_record_write(run, folder, crew->jobs, stop)
                                   : po_record_write_part(run, folder, crew->jobs, stop);
}

/* Marks the points of external solvers that are timed in the rounds in which this program solves
 * them. A point that is known from an earlier run, and that this program solves again, is not one
 * of them: the record of a finished case is written again with that. */
static po_status mark_interleaved(po_crew *crew, size_t count) {
  po_status status = PO_OK;
  for (size_t r = 0; r < count && !status; ++r) {
    po_case_run *run = &crew->runs[r];
    bool changed = false;
    for (size_t i = 0; run->rounds && i < run->plan->kase->point_count; ++i) {
      const bool open = is_open_here(crew, count, run->plan->kase, i);
      const bool before = run->interleaved[i];
      if (run->asked[i] && (open || !run->done[i]))
        run->interleaved[i] = open && !run->done[i];
      changed = changed || run->interleaved[i] != before;
    }
    if (run->finished && changed)
      status = rewrite(crew, run);
  }
  return status;
}

static po_status work_through(po_crew *crew, size_t count) {
  size_t shared = 0, total = 0;
  po_task *tasks = po_tasks_list(crew->runs, count, &shared, &total);
  if (!tasks)
    return PO_NO_MEMORY;
  const int threads = shared < (size_t)crew->jobs ? (int)shared : crew->jobs;
  po_status status = total ? po_linear_reserve(threads > 1 ? threads : 1) : PO_OK;
  if (!status)
    status = mark_interleaved(crew, count);
  if (status) {
    free(tasks);
    return status;
  }
  begin_progress(crew, count);
  do_shared(crew, tasks, shared, threads);
  for (size_t i = shared; i < total; ++i)
    if (!must_end(crew))
      do_task(crew, &tasks[i]);
  po_progress_end(&crew->progress);
  free(tasks);
  if (crew->broken)
    return po_fail(crew->status, "%s", crew->message);
  if (crew->starved && !(crew->options->stop && *crew->options->stop))
    return po_fail(PO_NO_MEMORY,
                   "%zu solves ended for lack of memory, the first is %s; finished points are "
                   "kept in %s, run again to solve the others",
                   crew->starved, crew->starved_message, crew->options->output);
  for (size_t r = 0; r < count; ++r)
    if (!crew->runs[r].finished)
      return po_fail(PO_INTERRUPTED,
                     "interrupted; finished points are kept in %s, run again to continue",
                     crew->options->output);
  return PO_OK;
}

/* Leaves out the points that are neither needed nor known. */
static void leave_out(po_case_run *run, const bool *needed) {
  for (size_t i = 0; needed && i < run->plan->kase->point_count; ++i)
    if (run->asked[i] && !run->done[i] && !needed[i]) {
      run->asked[i] = false;
      run->asked_count -= 1;
    }
}

/* Reports stored results that were altered. One that was read from another line of the journal is
 * none of them. */
static void report_altered(po_crew *crew, po_case_run *run) {
  const char *name = run->plan->kase->file->name;
  const size_t lacking = po_case_run_lacking(run);
  if (run->altered > lacking)
    run->altered = lacking;
  if (run->altered)
    po_progress_say(&crew->progress, "%s: %zu stored %s altered or damaged and %s solved again",
                    name, run->altered, run->altered == 1 ? "result was" : "results were",
                    run->altered == 1 ? "is" : "are");
  else if (run->damaged)
    po_progress_say(&crew->progress,
                    "%s: the record was altered; its results have their checksums and are kept",
                    name);
}

/* Reads the results of earlier runs of a case, unless all points are to be solved again, and counts
 * the points that are left to solve. A case without such points is finished. */
static po_status begin_case(po_crew *crew, po_case_run *run) {
  const po_run_options *options = crew->options;
  if (options->fresh)
    leave_out(run, options->needed);
  if (po_case_run_is_done(run) && run->asked_count)
    return finish_case(crew, run); /* merged from shards */
  if (options->fresh && po_case_run_is_whole(run)) {
    const po_status status = po_journal_remove(run, folder_of(crew, run));
    if (status)
      return status;
  } else if (!options->fresh) {
    po_status status = po_record_read(run, folder_of(crew, run));
    if (!status) {
      report_altered(crew, run);
      return finish_case(crew, run);
    }
    if (status == PO_NOT_FOUND)
      status = po_journal_read(run, folder_of(crew, run));
    if (!status && run->plan->solver)
      status = po_run_solver_recover(run, folder_of(crew, run));
    if (status)
      return status;
    report_altered(crew, run);
    leave_out(run, options->needed);
  }
  run->chunks = run->plan->kase->repeats > 1 ? 1 : (size_t)crew->jobs;
  run->pending = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    if (!run->asked[i])
      continue;
    run->pending += run->done[i] ? 0 : 1;
    const bool resumed = run->done[i] && !(run->beyond && run->beyond[i]);
    run->resumed += resumed;
    run->elapsed += resumed && !run->plan->solver ? run->results[i].work.seconds : 0;
  }
  if (run->chunks > run->pending)
    run->chunks = run->pending;
  run->shares_left = run->chunks;
  return run->pending ? PO_OK : finish_case(crew, run);
}

po_status po_run(po_case_run *runs, size_t count, const po_run_options *options) {
  po_crew crew = {.runs = runs, .options = options};
  crew.jobs = options->jobs > 0 ? options->jobs : po_environment_cores();
  po_status status = po_no_memory_or(PO_OK);
  if (!status)
    status = po_folder_make(options->output);
  po_progress_begin(&crew.progress, 0, 0);
  for (size_t i = 0; !status && i < count; ++i) {
    status = begin_case(&crew, &runs[i]);
    if (status == PO_INTERRUPTED) /* work_through reports it */
      status = PO_OK;
  }
  return status ? status : work_through(&crew, count);
}
