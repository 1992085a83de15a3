#include "po_launch.h"

#include <stdlib.h>

#include "po_memory.h"
#include "po_text.h"

/* The greatest size of a file that a solver writes, and of its standard output. */
static const size_t MOST_BYTES = (size_t)256 << 20;

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
static char **make_command(const po_solver *solver, const po_ask_folder *folder) {
  const unsigned count = solver->file->command_count;
  char **words = po_allocate(count + 1, sizeof *words);
  for (unsigned i = 0; words && i < count; ++i) {
    char *with_request = po_solver_replace(solver->command[i], "{request}", folder->request);
    char *with_table =
        with_request ? po_solver_replace(with_request, "{table}", folder->table) : NULL;
    words[i] = with_table ? po_solver_replace(with_table, "{response}", folder->response) : NULL;
    free(with_request);
    free(with_table);
    if (!words[i]) {
      free_words(words);
      return NULL;
    }
  }
  return words;
}

po_status po_launch(const po_solver *solver, const po_ask_folder *folder, po_process *process) {
  char **command = make_command(solver, folder);
  char **environment = make_environment(solver, folder->path);
  const po_process_request request = {.command = command,
                                      .environment = environment,
                                      .folder = folder->path,
                                      .most_bytes = MOST_BYTES};
  const po_status status =
      command && environment ? po_process_start(&request, process) : PO_NO_MEMORY;
  free_words(command);
  free_words(environment);
  return status;
}
