/* Command lines: each line of the input is an argument. Every verb reads its arguments completely.
 * Stubs (linked by --wrap) replace the functions that solve, draw a report or write a file, so that
 * an input costs no more than reading it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_ask.h"
#include "po_file.h"
#include "po_options.h"
#include "po_series.h"
#include "po_shard.h"
#include "po_verbs.h"

enum { MOST_ARGUMENTS = 64 };

static po_request solved; /* the last request that a verb tried to solve */
static bool was_solved;

po_status __wrap_po_solve(const po_request *request, po_result *result);
po_status __wrap_po_series_pull_offs(const po_request *requests, size_t count, size_t every,
                                     po_result *results);
po_status __wrap_po_series_folds(const po_request *requests, size_t count, po_result *results);
po_status __wrap_po_run(po_case_run *runs, size_t count, const po_run_options *options);
po_status __wrap_po_shard_write(const po_case_run *runs, size_t count, po_shard shard,
                                double time_limit, int jobs, const char *output);
po_status __wrap_po_ask(const po_solver *solver, const po_question *questions, size_t count,
                        const char *folder, const char *key, const volatile sig_atomic_t *stop,
                        po_answer_taker *take, void *context, po_ask_log *log);
po_status __wrap_po_file_write(const char *path, const char *data, size_t size);
po_status __wrap_po_folder_make(const char *path);
const volatile sig_atomic_t *__wrap_po_interrupt_listen(void);
FILE *__wrap_popen(const char *command, const char *type);
pid_t __wrap_fork(void);

po_status __wrap_po_solve(const po_request *request, po_result *result) {
  *result = (po_result){.status = PO_INTERRUPTED};
  solved = *request;
  was_solved = true;
  return po_fail(PO_INTERRUPTED, "nothing is solved here");
}

po_status __wrap_po_series_pull_offs(const po_request *requests, size_t count, size_t every,
                                     po_result *results) {
  fuzz_require(every > 0 && count > 1, "a line of %zu scenes is followed, each %zu", count, every);
  for (size_t i = 0; i < count; ++i) {
    results[i].status = PO_NOT_CONVERGED;
    fuzz_require(po_request_check(&requests[i]) == PO_OK, "scene %zu of a line: %s", i,
                 po_message());
  }
  return PO_OK;
}

po_status __wrap_po_series_folds(const po_request *requests, size_t count, po_result *results) {
  return __wrap_po_series_pull_offs(requests, count, 1, results);
}

po_status __wrap_po_run(po_case_run *runs, size_t count, const po_run_options *options) {
  fuzz_require(options->output && *options->output && options->jobs > 0, "a run without an output");
  for (size_t r = 0; r < count; ++r)
    fuzz_require(runs[r].asked_count <= runs[r].plan->kase->point_count,
                 "more points are asked for "
                 "than there are");
  return po_fail(PO_INTERRUPTED, "nothing is solved here");
}

po_status __wrap_po_shard_write(const po_case_run *runs, size_t count, po_shard shard,
                                double time_limit, int jobs, const char *output) {
  (void)runs, (void)count, (void)time_limit, (void)jobs, (void)output;
  fuzz_require(shard.number >= 1 && shard.number <= shard.count, "shard %zu of %zu is accepted",
               shard.number, shard.count);
  return PO_OK;
}

po_status __wrap_po_ask(const po_solver *solver, const po_question *questions, size_t count,
                        const char *folder, const char *key, const volatile sig_atomic_t *stop,
                        po_answer_taker *take, void *context, po_ask_log *log) {
  (void)key, (void)questions, (void)count, (void)stop, (void)take, (void)context;
  *log = (po_ask_log){0};
  fuzz_require(*folder && solver->command[0], "a solver without a folder or a command");
  return po_fail(PO_INTERRUPTED, "no solver is started here");
}

po_status __wrap_po_file_write(const char *path, const char *data, size_t size) {
  (void)data, (void)size;
  return *path ? PO_OK : po_fail(PO_CANNOT_WRITE, "a file without a name is not written");
}

po_status __wrap_po_folder_make(const char *path) {
  return *path ? PO_OK : po_fail(PO_CANNOT_WRITE, "a folder without a name is not made");
}

const volatile sig_atomic_t *__wrap_po_interrupt_listen(void) {
  static volatile sig_atomic_t never;
  return &never;
}

FILE *__wrap_popen(const char *command, const char *type) {
  (void)command, (void)type;
  return NULL;
}

pid_t __wrap_fork(void) {
  return -1;
}

/* Runs a command line and returns its exit code. */
static int run(int argc, char **argv) {
  was_solved = false;
  optind = 0; /* restarts getopt */
  po_message_clear();
  const int code = po_verbs_run(argc, argv);
  const bool known = code == PO_EXIT_OK || code == PO_EXIT_OUTSIDE || code == PO_EXIT_USAGE ||
                     code == PO_EXIT_SOLVE || code == PO_EXIT_FILE || code == PO_EXIT_INTERRUPTED;
  fuzz_require(known, "the exit code is %d", code);
  if (code == PO_EXIT_USAGE || code == PO_EXIT_FILE)
    fuzz_require(*po_message() != '\0', "the exit code %d has no message", code);
  if (code)
    fuzz_require_words("a message", po_message(), false);
  return code;
}

/* The command that is printed for a request must give the same request. */
static void require_command(void) {
  const po_request before = solved;
  char *argv[MOST_ARGUMENTS], *rest = NULL;
  int argc = 0;
  po_text command = {0};
  po_input_add_command(&before, &command);
  fuzz_require_words("a command", command.data, false);
  for (char *word = strtok_r(command.data, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
    argv[argc++] = word;
  argv[argc] = NULL;
  run(argc, argv);
  fuzz_require(was_solved, "the command of a request is refused: %s", po_message());
  fuzz_require(before.want == solved.want, "the command of a request wants %u, not %u", solved.want,
               before.want);
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    const double a = po_key_number(&before, (po_key)key), b = po_key_number(&solved, (po_key)key);
    fuzz_require(po_key_is_idle(&before, (po_key)key) || a == b,
                 "%s is %.17g in a request, and %.17g in that of its command", PO_KEYS[key].name, a,
                 b);
  }
  po_text_clear(&command);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part text;
  char *argv[MOST_ARGUMENTS + 1] = {(char *)"pulloff"}, *rest = NULL;
  int argc = 1;
  setenv("PULLOFF_DATA", FUZZ_DATA, 1);
  fuzz_split(data, size, &text, 1);
  for (char *line = text.bytes; line && argc < MOST_ARGUMENTS; line = rest) {
    rest = strchr(line, '\n');
    if (rest)
      *rest++ = '\0';
    if (rest || *line)
      argv[argc++] = line;
  }
  argv[argc] = NULL;
  run(argc, argv);
  if (was_solved)
    require_command();
  free(text.bytes);
  return 0;
}
