#include "po_python.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_options.h"

const char *po_python(void) {
  const char *chosen = getenv("PULLOFF_PYTHON");
  return chosen && *chosen ? chosen : PULLOFF_PYTHON;
}

/* Puts a folder before those of a variable that names folders. */
static void put_before(const char *variable, const char *folder) {
  const char *others = getenv(variable);
  po_text text = {0};
  po_text_add(&text, "%s%s%s", folder, others && *others ? ":" : "", others ? others : "");
  if (!text.failed)
    setenv(variable, po_text_string(&text), 1);
  po_text_clear(&text);
}

/* The module finds the library beside the program, if that is in PATH. */
static void make_findable(void) {
  char program[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  const po_file_path module = po_path_join(po_environment_data(), "python");
  if (po_path_exists(module.text))
    put_before("PYTHONPATH", module.text);
  if (length <= 0)
    return;
  program[length] = '\0';
  *strrchr(program, '/') = '\0';
  put_before("PATH", program);
}

int po_python_run(char *const *argv) {
  fflush(stdout);
  const pid_t child = fork();
  int ending = 0;
  if (child == 0) {
    make_findable();
    execvp(argv[0], argv);
  }
  if (child <= 0) { /* there is no process, or it has not become Python */
    po_fail(PO_MISSING_TOOL, "%s cannot be started: %s", argv[0], strerror(errno));
    const int code = po_options_end(PO_MISSING_TOOL);
    if (child == 0)
      _exit(code);
    return code;
  }
  while (waitpid(child, &ending, 0) < 0 && errno == EINTR)
    continue;
  return WIFSIGNALED(ending) ? 128 + WTERMSIG(ending) : WEXITSTATUS(ending);
}
