#include "po_run.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_deadline.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_job.h"
#include "po_record.h"
#include "po_store.h"
#include "po_text.h"

/* Shows the progress of a run on standard error: one line that is updated on a terminal, separate
 * lines elsewhere. */

typedef struct {
  bool live;    /* standard error is a terminal */
  size_t total; /* points to solve */
  size_t done;
  double effort, spent; /* of all points and of the solved ones; 1 is the full trace of a point */
  double begin;         /* seconds of the monotonic clock */
  double last;          /* time of the last output, by the same clock */
  size_t width;         /* of the line that is now on the terminal */
} po_progress;

/* Least time between separate lines in seconds, so that a log does not become long. */
static const double PLAIN_INTERVAL = 2;

/* Erases the updated line. */
static void clear_line(po_progress *progress) {
  if (progress->width)
    fprintf(stderr, "\r%*s\r", (int)progress->width, "");
  progress->width = 0;
}

static void span(double seconds, char text[32]) {
  if (seconds < 90)
    snprintf(text, 32, "%.0f s", seconds);
  else
    snprintf(text, 32, "%.0f min %02d s", (seconds - (double)((int)seconds % 60)) / 60,
             (int)seconds % 60);
}

static void show_progress(po_progress *progress, const char *what) {
  char elapsed[32], remaining[32], line[160];
  const double seconds = po_clock_wall() - progress->begin;
  span(seconds, elapsed);
  span(progress->done ? seconds * (progress->effort / progress->spent - 1) : 0, remaining);
  const int width =
      progress->done
          ? snprintf(line, sizeof line, "%zu/%zu %s, %s elapsed, about %s remaining (%.60s)",
                     progress->done, progress->total,
                     po_one_or_more(progress->total, "solve", "solves"), elapsed, remaining, what)
          : snprintf(line, sizeof line, "0/%zu %s", progress->total,
                     po_one_or_more(progress->total, "solve", "solves"));
  clear_line(progress);
  fprintf(stderr, progress->live ? "%s" : "%s\n", line);
  progress->width = progress->live ? (size_t)width : 0;
  progress->last = po_clock_wall();
}

/* Starts a run of `total` points with the given total effort. */
static void progress_begin(po_progress *progress, size_t total, double effort) {
  const double now = po_clock_wall();
  *progress = (po_progress){.live = isatty(STDERR_FILENO) == 1,
                            .total = total,
                            .effort = effort,
                            .begin = now,
                            .last = now};
  if (total && progress->live)
    show_progress(progress, "");
}

/* Counts a solved point. Given: `what`, its name; `effort`, its share of the total. Only one thread
 * at a time may call this. */
static void progress_step(po_progress *progress, const char *what, double effort) {
  progress->done += 1;
  progress->spent += effort;
  if (progress->live || po_clock_wall() - progress->last > PLAIN_INTERVAL)
    show_progress(progress, what);
}

/* Prints a line that remains on the terminal, e.g. when a case is finished. */
static void progress_say(po_progress *progress, const char *format, ...) {
  clear_line(progress);
  va_list arguments;
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  progress->last = po_clock_wall();
}

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
  char starved_message[768]; /* of the first of them */
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

static void report_finished(po_crew *crew, const po_case_run *run) {
  char kept[64] = "", part[64] = "";
  if (run->kept)
    snprintf(kept, sizeof kept, " (kept)");
  else if (run->resumed)
    snprintf(kept, sizeof kept, " (%zu %s kept)", run->resumed,
             po_one_or_more(run->resumed, "point", "points"));
  if (!po_case_run_is_whole(run))
    snprintf(part, sizeof part, " of %zu", run->plan->kase->point_count);
  progress_say(
      &crew->progress, "%s: %zu%s %s, %zu %s: %s%s", run->plan->name, run->asked_count, part,
      po_one_or_more(run->plan->kase->point_count, "point", "points"), run->check_results.count,
      po_one_or_more(run->check_results.count, "check", "checks"), po_case_run_verdict(run), kept);
}

/* Makes the checks and writes the record of a case whose points are all solved. */
static po_status finish_case(po_crew *crew, po_case_run *run) {
  const po_run_options *options = crew->options;
  const bool whole = po_case_run_is_whole(run);
  const bool writes = !run->current && (whole || run->plan->solver);
  po_status status = po_run_check(run, options->stop);
  if (!status && writes && whole && run->untidy)
    status = po_store_renew(run, run->folder.text);
  if (!status && writes)
    status = po_record_write(run, run->folder.text, crew->jobs, options->stop);
  run->finished = status == PO_OK;
  if (!status && !(options->brief && crew->progress.live))
    report_finished(crew, run);
  return status;
}

/* Returned: the effort of a solve relative to a full trace, for the estimate of the remaining time.
 * A scene in parameter continuation takes about a tenth. */
static double effort(const po_case_run *run) {
  return run->plan->kase->series_length > 1 ? 0.1 : 1;
}

/* Reports whether a solve ended for lack of memory. This is no result: the point is not stored, and
 * the next run solves it again. */
static bool is_starved(po_crew *crew, const po_case_run *run, size_t point) {
  const po_result *result = &run->points[point].result;
  if (result->status != PO_NO_MEMORY || run->plan->solver)
    return false;
  if (crew->starved++ == 0)
    snprintf(crew->starved_message, sizeof crew->starved_message, "%s %s: %s", run->plan->name,
             run->plan->kase->points[point].label, result->reason);
  return true;
}

/* Counts a solve and, if it was the last one of its point, stores the result. */
static po_status take_point(void *context, po_case_run *run, size_t point, bool last) {
  po_crew *crew = context;
  if (!run->points[point].done) {
    char what[128];
    snprintf(what, sizeof what, "%.40s %.60s", run->plan->name,
             run->plan->kase->points[point].label);
    progress_step(&crew->progress, what, effort(run));
  }
  if (!last || is_starved(crew, run, point))
    return PO_OK;
  run->pending -= !run->points[point].done;
  run->points[point].done = true;
  return po_store_put(run, point, run->folder.text);
}

/* Does a job, and finishes the case if nothing of it is left to do. */
static void do_job(po_crew *crew, const po_job *job) {
  po_case_run *run = &crew->runs[job->run];
  const po_job_desk desk = {crew->options->stop, take_point, crew};
  const double begin = po_clock_wall();
#pragma omp critical(po_run_finish)
  run->at_work += 1;
  po_no_memory_forget();
  po_status status = job->work(run, job, &desk);
#pragma omp critical(po_run_finish)
  {
    run->elapsed += po_clock_wall() - begin;
    run->at_work -= 1;
    if (!status && run->pending == 0 && run->at_work == 0 && !run->finished)
      status = finish_case(crew, run);
    status = po_no_memory_or(status);
    if (status && status != PO_INTERRUPTED)
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
  progress_begin(&crew->progress, solves, all);
}

/* Does the jobs that may run in parallel. With one thread no parallel region is used, because it
 * allocates memory and ends the program if there is none. */
static void do_shared(po_crew *crew, const po_job *jobs, size_t count, int threads) {
  if (threads <= 1) {
    for (size_t i = 0; i < count && !must_end(crew); ++i)
      do_job(crew, &jobs[i]);
    return;
  }
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (size_t i = 0; i < count; ++i)
    if (!must_end(crew))
      do_job(crew, &jobs[i]);
}

/* Reports whether this program solves a point of a case in the rounds that follow. */
static bool is_open_here(const po_crew *crew, size_t count, const po_case *kase, size_t point) {
  for (size_t k = 0; k < count; ++k) {
    const po_case_run *run = &crew->runs[k];
    if (run->plan->kase == kase && !run->plan->solver && !run->finished &&
        run->points[point].asked && !run->points[point].done)
      return true;
  }
  return false;
}

/* Marks the points of external solvers that are timed in the rounds in which this program solves
 * them. A point that is known from an earlier run, and that this program solves again, is not one
 * of them: the record of a finished case is written again with that. */
static po_status mark_interleaved(po_crew *crew, size_t count) {
  po_status status = PO_OK;
  for (size_t r = 0; r < count && !status; ++r) {
    po_case_run *run = &crew->runs[r];
    bool changed = false;
    for (size_t i = 0; !status && run->starts && i < run->plan->kase->point_count; ++i) {
      const bool open = is_open_here(crew, count, run->plan->kase, i);
      const bool before = run->points[i].interleaved;
      if (run->points[i].asked && (open || !run->points[i].done))
        run->points[i].interleaved = open && !run->points[i].done;
      if (run->points[i].interleaved == before)
        continue;
      changed = true;
      if (run->points[i].done)
        status = po_store_put(run, i, run->folder.text);
    }
    if (!status && run->finished && changed)
      status = po_record_write(run, run->folder.text, crew->jobs, crew->options->stop);
  }
  return status;
}

static po_status work_through(po_crew *crew, size_t count) {
  size_t shared = 0, total = 0;
  po_job *jobs = po_jobs_list(crew->runs, count, &shared, &total);
  if (!jobs)
    return PO_NO_MEMORY;
  const int threads = shared < (size_t)crew->jobs ? (int)shared : crew->jobs;
  const po_status status = mark_interleaved(crew, count);
  if (status) {
    free(jobs);
    return status;
  }
  begin_progress(crew, count);
  do_shared(crew, jobs, shared, threads);
  for (size_t i = shared; i < total; ++i)
    if (!must_end(crew))
      do_job(crew, &jobs[i]);
  clear_line(&crew->progress);
  free(jobs);
  if (crew->broken)
    return po_fail(crew->status, "%s", crew->message);
  if (crew->starved && !(crew->options->stop && *crew->options->stop))
    return po_fail(PO_NO_MEMORY,
                   "%zu %s ended for lack of memory, the first is %s; finished points are "
                   "kept in %s, run again to solve the others",
                   crew->starved, po_one_or_more(crew->starved, "solve", "solves"),
                   crew->starved_message, crew->options->output);
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
    if (run->points[i].asked && !run->points[i].done && !needed[i]) {
      run->points[i].asked = false;
      run->asked_count -= 1;
    }
}

/* Reports what was altered since it was written. A result that was read from another line of the
 * store is none of it. */
static void report_altered(po_crew *crew, po_case_run *run) {
  const char *name = run->plan->kase->file->name;
  const size_t lacking = po_case_run_lacking(run);
  if (run->altered > lacking)
    run->altered = lacking;
  if (run->altered)
    progress_say(&crew->progress, "%s: %zu stored %s altered or damaged and %s solved again", name,
                 run->altered, po_one_or_more(run->altered, "result was", "results were"),
                 po_one_or_more(run->altered, "is", "are"));
  else if (run->damaged)
    progress_say(&crew->progress,
                 "%s: the record or a table beside it was altered or damaged; the stored results "
                 "are intact, and it is written again",
                 name);
}

/* Counts the points that are left to solve. */
static void count_pending(po_crew *crew, po_case_run *run) {
  run->pending = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    if (!run->points[i].asked)
      continue;
    run->pending += run->points[i].done ? 0 : 1;
    const bool resumed = run->points[i].done && !run->points[i].beyond;
    run->resumed += resumed;
    run->elapsed += resumed && !run->plan->solver ? run->points[i].result.work.seconds : 0;
  }
  run->chunks = run->plan->kase->repeats > 1 ? 1 : (size_t)crew->jobs;
  if (run->chunks > run->pending)
    run->chunks = run->pending;
}

/* Reads the results of earlier runs of a case, unless all points are to be solved again. A case
 * without points that are left to solve is finished. */
static po_status begin_case(po_crew *crew, po_case_run *run) {
  const po_run_options *options = crew->options;
  po_status status = PO_OK;
  if (options->fresh)
    leave_out(run, options->needed);
  if (options->fresh || !po_case_run_lacking(run))
    run->untidy = true; /* lines of earlier runs remain; or the case was merged from shards */
  if (!po_case_run_lacking(run) && run->asked_count)
    return finish_case(crew, run);
  if (!options->fresh)
    status = po_store_read(run, run->folder.text);
  if (!status && !options->fresh && run->plan->solver)
    status = po_run_solver_recover(run);
  leave_out(run, options->needed);
  count_pending(crew, run);
  run->kept = run->pending == 0 && po_case_run_is_whole(run);
  if (!status && run->pending == 0)
    status = po_record_check(run, run->folder.text);
  report_altered(crew, run);
  return status || run->pending ? status : finish_case(crew, run);
}

po_status po_run(po_case_run *runs, size_t count, const po_run_options *options) {
  po_crew crew = {.runs = runs, .options = options};
  crew.jobs = options->jobs > 0 ? options->jobs : po_environment_cores();
  po_status status = po_no_memory_or(PO_OK);
  if (!status)
    status = po_folder_make(options->output);
  progress_begin(&crew.progress, 0, 0);
  for (size_t i = 0; !status && i < count; ++i) {
    po_case_run_place(&runs[i], options->output);
    status = begin_case(&crew, &runs[i]);
    if (status == PO_INTERRUPTED) /* work_through reports it */
      status = PO_OK;
  }
  return status ? status : work_through(&crew, count);
}
