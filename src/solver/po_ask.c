#include "po_ask.h"

#include <fcntl.h>
#include <ftw.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "po_clock.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_quote.h"
#include "po_response.h"

/* Seconds between two looks at the response, and from TERM to KILL. */
static const double LOOK = 0.02, GRACE = 2;

/* After so many starts in a row without an answer, the remaining questions are not asked any more:
 * the solver does not work at all. Time-outs count only while it has never answered. */
enum { MOST_FRUITLESS = 3 };

/* The greatest size of a file that a solver writes, and of its standard output. */
static const size_t MOST_BYTES = (size_t)256 << 20;

typedef struct {
  const po_solver *solver;
  const po_question *questions;
  size_t count;
  const char *key;
  const volatile sig_atomic_t *stop;
  po_answer_taker *take;
  void *context;
  po_ask_log *log;
  bool *open;        /* one a question: it has not been answered */
  bool *asked;       /* one a question: the present process was asked */
  unsigned *answers; /* one a question: number of answers so far */
  bool *seen;        /* `repeats` a question: this repeat was answered */
  bool *spoiled;     /* one a question: it has got an invalid answer */
  bool ever;         /* the solver has answered something */
  bool unusual; /* the present process has given an invalid answer, or did not end as it should */
  char complaint[sizeof((po_result *)0)->reason]; /* about a line that belongs to no question */
} asking;

static size_t first_open(const asking *a) {
  size_t i = 0;
  while (i < a->count && !a->open[i])
    ++i;
  return i;
}

/* Ends a question without an answer of the solver. */
static po_status give_up_on(asking *a, size_t question, po_status status, const char *reason) {
  po_answer answer = {.result = po_result_none(), .repeat = 1, .setup = NAN, .solve = NAN};
  answer.result.status = status;
  answer.result.work.seconds = (double)NAN;
  po_quote_text(reason, answer.result.reason, sizeof answer.result.reason);
  a->open[question] = false;
  a->spoiled[question] = a->unusual = true;
  const po_status taken = a->take(a->context, question, &answer, true);
  po_answer_clear(&answer);
  return taken;
}

/* Returned: the question with an id that the present process was asked; `count`: none. */
static size_t find_question(const asking *a, const char *id) {
  size_t i = 0;
  while (i < a->count && !(a->asked[i] && strcmp(a->questions[i].id, id) == 0))
    ++i;
  return i;
}

/* Takes an answer to a known question. */
static po_status take_answer(asking *a, size_t q, po_answer *answer) {
  const po_question *question = &a->questions[q];
  const unsigned repeats = question->repeats;
  char reason[80];
  if (a->spoiled[q])
    return PO_OK; /* its status is final */
  if (answer->result.status == PO_INVALID)
    return give_up_on(a, q, PO_INVALID, answer->result.reason);
  if (answer->repeat > repeats) {
    snprintf(reason, sizeof reason, "repeat is %u: expected at most %u", answer->repeat, repeats);
    return give_up_on(a, q, PO_INVALID, reason);
  }
  if (a->seen[q * repeats + answer->repeat - 1]) {
    snprintf(reason, sizeof reason, "two answers for repeat %u: expected one", answer->repeat);
    return give_up_on(a, q, PO_INVALID, reason);
  }
  a->seen[q * repeats + answer->repeat - 1] = true;
  a->answers[q] += 1;
  a->ever = true;
  /* a failure needs no repetition */
  const bool final = a->answers[q] == repeats || answer->result.status != PO_OK;
  if (final)
    a->open[q] = false;
  return a->take(a->context, q, answer, final);
}

static double reported_by(const po_answer *answer) {
  return (isfinite(answer->setup) ? answer->setup : 0) +
         (isfinite(answer->solve) ? answer->solve : 0);
}

static po_status take_line(asking *a, const char *line, size_t length, po_ask_process *process) {
  po_answer answer;
  po_status status = po_answer_read(line, length, &answer);
  const size_t q = status ? a->count : find_question(a, answer.id);
  if (!status && q < a->count)
    po_answer_check(&a->questions[q], &answer);
  if (!status && q == a->count && !a->complaint[0]) {
    if (answer.result.status == PO_INVALID)
      snprintf(a->complaint, sizeof a->complaint, "%s", answer.result.reason);
    else
      snprintf(a->complaint, sizeof a->complaint, "an answer has the id %.30s, which was not asked",
               answer.id);
  }
  if (!status && q == a->count)
    a->unusual = true;
  if (!status && q < a->count) {
    process->answered += 1;
    process->reported += reported_by(&answer);
    status = take_answer(a, q, &answer);
  }
  po_answer_clear(&answer);
  return status;
}

/* Takes the lines that have been added. Returned: in *news, whether there are any. */
static po_status take_lines(asking *a, po_response *response, bool last, po_ask_process *process,
                            bool *news) {
  po_status status = PO_OK;
  bool more = true;
  *news = false;
  while (!status && more) {
    const size_t before = response->read;
    if (!po_response_read(response))
      return response->wrong[0] ? PO_OK : PO_NO_MEMORY;
    more = response->read > before;
    size_t length = 0;
    const char *line = NULL;
    while (!status && (line = po_response_line(response, last && !more, &length))) {
      *news = true;
      status = take_line(a, line, length, process);
    }
  }
  return status;
}

typedef struct {
  char *folder, *request, *table, *response;
  int lock; /* the file of the key, locked while this program lives; -1: none */
} places;

static void clear_places(places *p) {
  free(p->folder);
  free(p->request);
  free(p->table);
  free(p->response);
  if (p->lock >= 0)
    close(p->lock);
  *p = (places){.lock = -1};
}

static int remove_entry(const char *path, const struct stat *found, int type, struct FTW *walk) {
  (void)found;
  (void)type;
  (void)walk;
  return remove(path);
}

static void remove_folder(const char *folder) {
  nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS | FTW_MOUNT);
}

/* The file of the key, in the folder of a process. */
static const char KEY_FILE[] = "key";

/* Writes the key into the folder of a process and locks the file. */
static po_status lock_key(const asking *a, places *p) {
  char *path = po_path_join(p->folder, KEY_FILE);
  if (!path)
    return PO_NO_MEMORY;
  po_status status = po_file_write(path, a->key, strlen(a->key));
  if (!status)
    p->lock = open(path, O_RDONLY | O_CLOEXEC);
  if (p->lock >= 0)
    (void)flock(p->lock, LOCK_EX | LOCK_NB);
  free(path);
  return status;
}

/* Creates a folder for a process, with its request. */
static po_status make_places(asking *a, const char *folder, places *p) {
  po_text request = {0}, table = {0};
  *p = (places){.folder = po_path_join(folder, "ask-XXXXXX"), .lock = -1};
  po_status status = p->folder ? po_folder_make(folder) : PO_NO_MEMORY;
  if (!status && !mkdtemp(p->folder))
    status = po_fail(PO_CANNOT_WRITE, "a folder for the solver cannot be created in %s", folder);
  char *real = status ? NULL : realpath(p->folder, NULL);
  if (!status && real) {
    free(p->folder);
    p->folder = real;
    p->request = po_path_join(real, "request.json");
    p->table = po_path_join(real, "request.csv");
    p->response = po_path_join(real, "response.jsonl");
  }
  if (!status && !(p->request && p->table && p->response))
    status = PO_NO_MEMORY;
  if (!status && a->key)
    status = lock_key(a, p);
  if (!status)
    status = po_questions_json(a->solver, a->questions, a->open, a->count, &request);
  if (!status)
    status = po_questions_table(a->solver, a->questions, a->open, a->count, &table);
  if (!status)
    status = po_file_write(p->request, request.data, request.length);
  if (!status)
    status = po_file_write(p->table, table.data, table.length);
  po_text_clear(&request);
  po_text_clear(&table);
  return status;
}

/* The environment of a solver: what a program needs to run, one thread, and the variables that the
 * manifest names. Returned: strings of which each and the list are to be freed; NULL without
 * memory. */
static char **make_environment(const po_solver *solver, const char *folder) {
  static const char *const ONE[] = {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS",
                                    "JULIA_NUM_THREADS", "NUMEXPR_NUM_THREADS"};
  enum { FIXED = 4, ONES = sizeof ONE / sizeof *ONE };
  const unsigned named = solver->file->environment_count;
  char **list = po_allocate(FIXED + ONES + named + 1, sizeof *list);
  size_t count = 0;
  bool failed = !list;
  const char *path = getenv("PATH");
  const char *const fixed[FIXED][2] = {{"PATH", path ? path : "/usr/bin:/bin"},
                                       {"HOME", folder},
                                       {"TMPDIR", folder},
                                       {"LANG", "C.UTF-8"}};
  for (size_t i = 0; !failed && i < FIXED + ONES + named; ++i) {
    po_text text = {0};
    const char *name = i < FIXED          ? fixed[i][0]
                       : i < FIXED + ONES ? ONE[i - FIXED]
                                          : solver->file->environment[i - FIXED - ONES];
    const char *value = i < FIXED ? fixed[i][1] : i < FIXED + ONES ? "1" : getenv(name);
    if (!value)
      continue;
    po_text_add(&text, "%s=%s", name, value);
    failed = text.failed;
    list[count++] = text.data;
  }
  if (!failed)
    return list;
  for (size_t i = 0; i < count; ++i)
    free(list[i]);
  free(list);
  return NULL;
}

static void free_words(char **words) {
  for (size_t i = 0; words && words[i]; ++i)
    free(words[i]);
  free(words);
}

/* Returned: the command with the names of the files, to be freed; NULL without memory. */
static char **make_command(const po_solver *solver, const places *p) {
  const unsigned count = solver->file->command_count;
  char **words = po_allocate(count + 1, sizeof *words);
  for (unsigned i = 0; words && i < count; ++i) {
    char *with_request = po_solver_replace(solver->command[i], "{request}", p->request);
    char *with_table = with_request ? po_solver_replace(with_request, "{table}", p->table) : NULL;
    words[i] = with_table ? po_solver_replace(with_table, "{response}", p->response) : NULL;
    free(with_request);
    free(with_table);
    if (!words[i]) {
      free_words(words);
      return NULL;
    }
  }
  return words;
}

static po_status start(const asking *a, const places *p, po_process *process) {
  char **command = make_command(a->solver, p);
  char **environment = make_environment(a->solver, p->folder);
  const po_process_request request = {.command = command,
                                      .environment = environment,
                                      .folder = p->folder,
                                      .most_bytes = MOST_BYTES};
  const po_status status =
      command && environment ? po_process_start(&request, process) : PO_NO_MEMORY;
  free_words(command);
  free_words(environment);
  return status;
}

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
static po_status judge_end(const asking *a, const po_process_end *end, bool late,
                           const po_response *response, char *why, size_t size) {
  char line[200], ended[80] = "";
  last_line(end->output, line, sizeof line);
  if (late) {
    snprintf(why, size, "no answer within %.4g s; the solver was stopped",
             a->questions[first_open(a)].limit);
    return PO_TIMED_OUT;
  }
  if (response->wrong[0] || end->flooded) {
    snprintf(why, size, "%s; the solver was stopped",
             response->wrong[0] ? response->wrong : "it printed more than 256 MB");
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
  if (a->complaint[0]) {
    snprintf(why, size, "%s", a->complaint);
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

/* Reads the answers of a running process until it ends, or must be ended. Returned: in *late,
 * whether the time limit of the first open question passed. */
static po_status listen(asking *a, po_process *process, po_response *response,
                        po_ask_process *found, bool *late) {
  double last = process->begin;
  bool news = false, any = false;
  po_status status = PO_OK;
  *late = false;
  while (!status && !po_process_wait(process, LOOK)) {
    status = take_lines(a, response, false, found, &news);
    if (news) {
      last = po_clock_wall();
      found->first = any ? found->first : last - process->begin;
      any = true;
    }
    const size_t open = first_open(a);
    const double limit = open < a->count ? a->questions[open].limit : GRACE;
    *late = po_clock_wall() - last > limit + (any ? 0 : a->solver->start_limit);
    if (a->stop && *a->stop)
      status = PO_INTERRUPTED;
    if (status || *late || response->wrong[0])
      po_process_stop(process, GRACE);
  }
  if (!process->running && !status)
    status = take_lines(a, response, true, found, &news);
  if (news && !any)
    found->first = process->end.wall;
  return status;
}

/* A question that is asked again starts with its first repeat. */
static void begin_process(asking *a) {
  a->complaint[0] = '\0';
  a->unusual = false;
  for (size_t q = 0; q < a->count; ++q) {
    a->asked[q] = a->open[q];
    if (a->open[q]) {
      a->answers[q] = 0;
      for (unsigned k = 0; k < a->questions[q].repeats; ++k)
        a->seen[q * a->questions[q].repeats + k] = false;
    }
  }
}

/* Keeps the folder of the last process that was unusual, and removes that of any other. */
static void keep_folder(po_ask_log *log, char **folder, bool unusual) {
  char **gone = unusual ? &log->folder : folder;
  if (*gone)
    remove_folder(*gone);
  free(*gone);
  *gone = NULL;
  if (unusual) {
    log->folder = *folder;
    *folder = NULL;
  }
}

/* Runs one process for all open questions. Returned: in *fruitless, whether it gave no answer. */
static po_status run_process(asking *a, const char *folder, bool *fruitless, bool *late) {
  places p;
  po_process process;
  size_t asked = 0;
  for (size_t i = 0; i < a->count; ++i)
    asked += a->open[i];
  po_ask_process found = {.asked = asked, .first = NAN};
  po_status status = make_places(a, folder, &p);
  po_response response = {.path = p.response, .file = -1};
  begin_process(a);
  *late = false;
  if (!status)
    status = start(a, &p, &process);
  if (!status) {
    status = listen(a, &process, &response, &found, late);
    if (process.running)
      po_process_stop(&process, GRACE);
    found.wall = process.end.wall;
    found.processor = process.end.processor;
    found.left = process.end.left;
    if (!status)
      status = add_process(a, &found);
  }
  *fruitless = found.answered == 0;
  const size_t open = first_open(a);
  if (!status && open < a->count) {
    char why[sizeof a->complaint];
    const po_status ending = judge_end(a, &process.end, *late, &response, why, sizeof why);
    status = give_up_on(a, open, ending, why);
  } else if (!status && (a->complaint[0] || process.end.left || process.end.code))
    a->unusual = true;
  po_response_close(&response);
  keep_folder(a->log, &p.folder, a->unusual);
  clear_places(&p);
  return status;
}

/* The solver does not answer: the remaining questions get the status of the last one. */
static po_status abandon(asking *a) {
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < a->count; ++i)
    if (a->open[i])
      status = give_up_on(a, i, PO_NO_ANSWER,
                          "not asked any more: the solver gave no answer three times in a row");
  return status;
}

static po_status ask_all(asking *a, const char *folder) {
  unsigned fruitless = 0;
  po_status status = PO_OK;
  while (!status && first_open(a) < a->count) {
    bool none = false, late = false;
    status = run_process(a, folder, &none, &late);
    if (none && !(late && a->ever))
      ++fruitless;
    else if (!none)
      fruitless = 0;
    if (!status && fruitless >= MOST_FRUITLESS)
      status = abandon(a);
  }
  return status;
}

po_status po_ask(const po_solver *solver, const po_question *questions, size_t count,
                 const char *folder, const char *key, const volatile sig_atomic_t *stop,
                 po_answer_taker *take, void *context, po_ask_log *log) {
  const unsigned repeats = count ? questions[0].repeats : 1;
  *log = (po_ask_log){0};
  asking a = {.solver = solver,
              .questions = questions,
              .count = count,
              .key = key,
              .stop = stop,
              .take = take,
              .context = context,
              .log = log,
              .open = po_allocate(count, sizeof(bool)),
              .asked = po_allocate(count, sizeof(bool)),
              .answers = po_allocate(count, sizeof(unsigned)),
              .seen = po_allocate(count * repeats, sizeof(bool)),
              .spoiled = po_allocate(count, sizeof(bool))};
  po_status status = a.open && a.asked && a.answers && a.seen && a.spoiled ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < count; ++i)
    a.open[i] = true;
  bool none = false, late = false;
  if (!status && count == 0)
    status = run_process(&a, folder, &none, &late);
  else if (!status)
    status = ask_all(&a, folder);
  if (status == PO_INTERRUPTED)
    po_fail(status, "interrupted while the solver %s was running", solver->name);
  free(a.open);
  free(a.asked);
  free(a.answers);
  free(a.seen);
  free(a.spoiled);
  return status;
}

/* Takes the complete successful answers of a response that an interrupted run left. */
static po_status recover_response(const po_question *questions, size_t count, bool *done,
                                  const char *path, po_answer_taker *take, void *context) {
  po_response response = {.path = path, .file = -1};
  po_status status = PO_OK;
  const char *line = NULL;
  size_t length = 0, before = 0;
  do {
    before = response.read;
    if (!po_response_read(&response))
      break;
    while (!status && (line = po_response_line(&response, false, &length))) {
      po_answer answer;
      status = po_answer_read(line, length, &answer);
      size_t q = 0;
      while (q < count && (done[q] || strcmp(questions[q].id, answer.id) != 0))
        ++q;
      if (!status && q < count)
        po_answer_check(&questions[q], &answer);
      /* of repeated solves, all would be needed: such a point is solved again */
      if (!status && q < count && answer.result.status == PO_OK && questions[q].repeats == 1 &&
          answer.repeat == 1) {
        done[q] = true;
        status = take(context, q, &answer, true);
      }
      po_answer_clear(&answer);
    }
  } while (!status && response.read > before);
  po_response_close(&response);
  return status;
}

/* Reports whether a folder belongs to a process with the same key whose run does not live. */
static bool is_left(const char *folder, const char *key) {
  char *path = po_path_join(folder, KEY_FILE), found[PO_DIGEST_LENGTH] = "";
  const int file = path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
  free(path);
  if (file < 0)
    return false;
  const bool same =
      read(file, found, sizeof found - 1) == (ssize_t)strlen(key) && strcmp(found, key) == 0;
  const bool left = same && flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return left;
}

po_status po_ask_recover(const po_question *questions, size_t count, const char *folder,
                         const char *key, po_answer_taker *take, void *context) {
  char **names = NULL;
  size_t name_count = 0;
  bool *done = po_allocate(count, sizeof *done);
  po_status status = done ? PO_OK : PO_NO_MEMORY;
  if (!status && po_path_exists(folder))
    status = po_folder_list(folder, "", &names, &name_count);
  for (size_t i = 0; !status && i < name_count; ++i) {
    char *path = strncmp(names[i], "ask-", 4) == 0 ? po_path_join(folder, names[i]) : NULL;
    char *response = path && is_left(path, key) ? po_path_join(path, "response.jsonl") : NULL;
    if (response)
      status = recover_response(questions, count, done, response, take, context);
    if (response && !status)
      remove_folder(path);
    free(response);
    free(path);
  }
  po_names_free(names, name_count);
  free(done);
  return status;
}

void po_ask_log_clear(po_ask_log *log) {
  free(log->processes);
  free(log->folder);
  *log = (po_ask_log){0};
}
