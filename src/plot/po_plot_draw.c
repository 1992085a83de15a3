/* Runs gnuplot: its standard input and its standard output are files in memory, with the script and
 * for the figure. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "po_file.h"
#include "po_plot.h"

static const char *ending_of(const char *file) {
  const char *point = strrchr(file, '.');
  return point && strlen(point) == 4 ? point + 1 : "";
}

bool po_plot_is_figure(const char *file) {
  const char *ending = ending_of(file);
  return strcmp(ending, "svg") == 0 || strcmp(ending, "png") == 0 || strcmp(ending, "pdf") == 0;
}

/* Starts gnuplot, which reads one file and writes the other. Returned: its process; -1: errno. */
static pid_t start(int script, int figure) {
  const pid_t child = fork();
  if (child)
    return child;
  dup2(script, STDIN_FILENO);
  dup2(figure, STDOUT_FILENO);
  /* In the locale C gnuplot warns of the characters of its own tables. */
  setenv("LC_ALL", "C.UTF-8", 1);
  execlp("gnuplot", "gnuplot", "-", (char *)NULL);
  _exit(127);
}

static po_status run(const po_text *script, po_text *figure) {
  const int from = memfd_create("script", MFD_CLOEXEC), to = memfd_create("figure", MFD_CLOEXEC);
  pid_t child = -1;
  int ending = 0;
  char bytes[1 << 14];
  ssize_t got = 0;
  for (size_t put = 0; put < script->length && got >= 0; put += (size_t)got)
    got = pwrite(from, script->data + put, script->length - put, (off_t)put);
  if (got >= 0 && to >= 0)
    child = start(from, to);
  if (child < 0)
    po_fail(PO_MISSING_TOOL, "gnuplot cannot be started: %s", strerror(errno));
  while (child > 0 && waitpid(child, &ending, 0) < 0 && errno == EINTR)
    continue;
  while (!figure->failed && (got = pread(to, bytes, sizeof bytes, (off_t)figure->length)) > 0)
    po_text_add_bytes(figure, bytes, (size_t)got);
  close(from);
  close(to);
  if (child < 0)
    return PO_MISSING_TOOL;
  if (WIFEXITED(ending) && WEXITSTATUS(ending) == 127)
    return po_fail(PO_MISSING_TOOL,
                   "gnuplot was not found: expected it in PATH, to draw the figure");
  if (figure->failed)
    return PO_NO_MEMORY;
  return !WIFEXITED(ending) || WEXITSTATUS(ending) || !figure->length
             ? po_fail(PO_MISSING_TOOL, "gnuplot failed, see its message above")
             : PO_OK;
}

/* Appends a file to the script, because gnuplot would search other folders for it. */
static po_status add_file(po_text *script, const char *folder, const char *name) {
  char *path = po_path_join(folder, name), *content = NULL;
  size_t size = 0;
  const po_status status = path ? po_file_read(path, &content, &size) : PO_NO_MEMORY;
  if (!status)
    po_text_add_bytes(script, content, size);
  po_text_add(script, "\n");
  free(content);
  free(path);
  return status;
}

po_status po_plot_run(const po_text *script, const char *figures, const char *name,
                      const po_text *then, const char *file) {
  po_text whole = {0}, figure = {0};
  po_plot_assign(&whole, "figure_terminal", ending_of(file));
  po_plot_assign(&whole, "figure_output", "");
  po_text_add_bytes(&whole, po_text_string(script), script->length);
  po_status status = add_file(&whole, figures, "style.gp");
  if (!status)
    status = add_file(&whole, figures, name);
  if (then)
    po_text_add_bytes(&whole, po_text_string(then), then->length);
  if (!status && (whole.failed || script->failed || (then && then->failed)))
    status = PO_NO_MEMORY;
  if (!status)
    status = run(&whole, &figure);
  if (!status)
    status = po_file_write(file, figure.data, figure.length);
  po_text_clear(&whole);
  po_text_clear(&figure);
  return status;
}
