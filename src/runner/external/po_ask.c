#include "po_ask.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_ask_folder.h"
#include "po_deadline.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_process.h"
#include "po_quote.h"
#include "po_taking.h"

/* Seconds between two looks at the response, and from TERM to KILL. */
static const double LOOK = 0.02, GRACE = 2;

/* After so many starts in a row without an answer, the remaining questions are not asked any more:
 * the solver does not work at all. Time-outs count only while it has never answered. */
enum { MOST_FRUITLESS = 3 };

typedef struct {
  const po_solver *solver;
  const char *folder, *key;
  const volatile sig_atomic_t *stop;
  po_ask_log *log;
  po_taking taking;
  bool late; /* the time limit of the first open question of the present process passed */
} asking;

/* Returned: the last line that a process printed, without blanks; "" if there is none. */
static void last_line(const char *output, char *line, size_t size) {
  size_t end = strlen(output);
  while (end > 0 && strchr(" \t\r\n", output[end - 1]))
    --end;
  size_t begin = end;
  while (begin > 0 && output[begin - 1] != '\n')
    --begin;
  char text[160];
  snprintf(text, sizeof text, "%.*s", (int)(end - begin), output + begin);
  po_quote_text(text, line, size);
}

/* Returned: the status of the first question that a process left open, and in `why` the reason. */
static po_status judge_end(const asking *a, const po_process_end *end, char *why, size_t size) {
  const po_taking *t = &a->taking;
  char line[200], ended[80] = "";
  last_line(end->output, line, sizeof line);
  if (a->late) {
    snprintf(why, size, "no answer within %.4g s; the solver was stopped",
             t->questions[po_taking_first(t)].limit);
    return PO_TIMED_OUT;
  }
  if (t->response.wrong[0] || end->flooded) {
    snprintf(why, size, "%s; the solver was stopped",
             t->response.wrong[0] ? t->response.wrong : "it printed more than 256 MB");
    return PO_INVALID;
  }
  if (end->signal)
    snprintf(ended, sizeof ended, "signal %d (%s) ended the solver", end->signal,
             strsignal(end->signal));
  else if (end->code)
    snprintf(ended, sizeof ended, "the solver ended with exit status %d", end->code);
  if (ended[0]) {
    snprintf(why, size, "%s%s%s", ended, line[0] ? ": " : "", line);
    return PO_CRASHED;
  }
  if (t->complaint[0]) {
    snprintf(why, size, "%s", t->complaint);
    return PO_INVALID;
  }
  snprintf(why, size, "the solver ended without an answer%s%s", line[0] ? "; it printed: " : "",
           line);
  return PO_NO_ANSWER;
}

static po_status add_process(asking *a, const po_ask_process *process) {
  po_ask_log *log = a->log;
  po_ask_process *list = po_resize(log->processes, log->count + 1, sizeof *list);
  if (!list)
    return PO_NO_MEMORY;
  log->processes = list;
  list[log->count++] = *process;
  return PO_OK;
}

/* Reads the answers of a running process until it ends, or must be ended. */
static po_status listen(asking *a, po_process *process, po_ask_process *found) {
  po_taking *t = &a->taking;
  double last = process->begin;
  po_status status = PO_OK;
  while (!status && !po_process_wait(process, LOOK)) {
    const size_t before = t->found.lines;
    status = po_taking_lines(t, false);
    if (t->found.lines > before)
      last = po_clock_wall();
    if (t->found.lines && !before)
      found->first = last - process->begin;
    const size_t open = po_taking_first(t);
    const double limit = open < t->count ? t->questions[open].limit : GRACE;
    a->late = po_clock_wall() - last > limit + (t->found.lines ? 0 : a->solver->start_limit);
    const double grace = status == PO_INTERRUPTED ? 0 : GRACE; /* the taker needs no more */
    if (a->stop && *a->stop)
      status = PO_INTERRUPTED;
    if (status || a->late || t->response.wrong[0])
      po_process_stop(process, grace);
  }
  if (!process->running && (!status || status == PO_INTERRUPTED)) {
    const po_status taken = po_taking_lines(t, !status);
    status = status ? status : taken;
  }
  if (t->found.lines && isnan(found->first))
    found->first = process->end.wall;
  return status;
}

/* Keeps the folder of the last process that was unusual, and removes that of any other. */
static void keep_folder(po_ask_log *log, const po_file_path *folder, bool unusual) {
  const po_file_path *gone = unusual ? &log->folder : folder;
  if (*gone->text)
    po_ask_folder_remove(gone->text);
  if (unusual)
    log->folder = *folder;
}

/* Writes the request, and the same as a table. */
static po_status write_request(const asking *a, const po_ask_folder *folder) {
  const po_taking *t = &a->taking;
  po_text request = {0}, table = {0};
  po_status status =
      po_questions_print(a->solver, t->questions, t->open, t->count, &request, &table);
  if (!status)
    status = po_file_write(folder->request.text, request.data, request.length);
  if (!status)
    status = po_file_write(folder->table.text, table.data, table.length);
  po_text_clear(&request);
  po_text_clear(&table);
  return status;
}

/* Starts a process in its folder, with the request, and takes its answers. Returned: in *end, how
 * it ended. */
static po_status run_in(asking *a, const po_ask_folder *folder, po_process_end *end) {
  po_process process;
  po_ask_process used = {.first = NAN};
  for (size_t i = 0; i < a->taking.count; ++i)
    used.asked += a->taking.open[i];
  po_status status = po_process_start(a->solver, folder, &process);
  if (status)
    return status;
  status = listen(a, &process, &used);
  if (process.running)
    po_process_stop(&process, GRACE);
  *end = process.end;
  used.found = a->taking.found;
  used.wall = end->wall;
  used.processor = end->processor;
  used.left = end->left;
  const po_status added = add_process(a, &used);
  return status ? status : added;
}

/* Runs one process for all open questions. */
static po_status run_process(asking *a) {
  po_taking *t = &a->taking;
  po_ask_folder folder;
  po_process_end end = {0};
  po_status status = po_ask_folder_make(a->folder, a->key, &folder);
  if (!status)
    status = write_request(a, &folder);
  po_taking_begin(t, folder.response.text);
  a->late = false;
  if (!status)
    status = run_in(a, &folder, &end);
  const size_t open = po_taking_first(t);
  if (!status && open < t->count) {
    char why[sizeof t->complaint];
    const po_status ending = judge_end(a, &end, why, sizeof why);
    status = po_taking_give_up(t, open, ending, why);
  } else if (!status && (t->complaint[0] || end.left || end.code))
    t->unusual = true;
  /* if an answer could not be stored, the next run takes it from the folder */
  if (!status || status == PO_INTERRUPTED || !a->key)
    keep_folder(a->log, &folder.path, t->unusual);
  po_ask_folder_unlock(&folder);
  return status;
}

/* The solver does not answer: the remaining questions are not asked. */
static po_status abandon(po_taking *t) {
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < t->count; ++i)
    if (t->open[i])
      status = po_taking_give_up(
          t, i, PO_NO_ANSWER, "not asked any more: the solver gave no answer three times in a row");
  return status;
}

static po_status ask_all(asking *a) {
  unsigned fruitless = 0;
  po_status status = PO_OK;
  while (!status && po_taking_first(&a->taking) < a->taking.count) {
    status = run_process(a);
    if (a->taking.found.answered)
      fruitless = 0;
    else if (!(a->late && a->taking.ever))
      ++fruitless;
    if (!status && fruitless >= MOST_FRUITLESS)
      status = abandon(&a->taking);
  }
  return status;
}

po_status po_ask(const po_solver *solver, const po_question *questions, size_t count,
                 const char *folder, const char *key, const volatile sig_atomic_t *stop,
                 po_answer_taker *take, void *context, po_ask_log *log) {
  asking a = {.solver = solver, .folder = folder, .key = key, .stop = stop, .log = log};
  *log = (po_ask_log){0};
  po_status status = po_taking_make(questions, count, take, context, &a.taking);
  if (!status)
    status = count ? ask_all(&a) : run_process(&a);
  if (status == PO_INTERRUPTED)
    po_fail(status, "interrupted while the solver %s was running", solver->name);
  po_taking_clear(&a.taking);
  return status;
}

void po_ask_log_clear(po_ask_log *log) {
  free(log->processes);
  *log = (po_ask_log){0};
}
