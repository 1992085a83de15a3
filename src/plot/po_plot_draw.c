/* Runs gnuplot: the script goes to its standard input, the figure comes from its standard output.
 */
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
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

/* Starts gnuplot. Returned: its process, and the ends of the two pipes; -1 with a message. */
static pid_t start(int *to, int *from) {
  int in[2] = {-1, -1}, out[2] = {-1, -1};
  pid_t child = -1;
  if (pipe(in) == 0 && pipe(out) == 0)
    child = fork();
  if (child == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    for (int k = 0; k < 2; ++k) {
      close(in[k]);
      close(out[k]);
    }
    /* In the locale C gnuplot warns of the characters of its own tables. */
    setenv("LC_ALL", "C.UTF-8", 1);
    execlp("gnuplot", "gnuplot", "-", (char *)NULL);
    _exit(127);
  }
  if (child < 0)
    po_fail(PO_MISSING_TOOL, "gnuplot cannot be started: %s", strerror(errno));
  close(in[0]);
  close(out[1]);
  *to = in[1];
  *from = out[0];
  return child;
}

/* Writes the script; a gnuplot that ended early is noticed by its exit code. */
static void send(int to, const po_text *script) {
  size_t sent = 0;
  while (sent < script->length) {
    const ssize_t now = write(to, script->data + sent, script->length - sent);
    if (now < 0 && errno != EINTR)
      break;
    sent += now > 0 ? (size_t)now : 0;
  }
  close(to);
}

static void receive(int from, po_text *figure) {
  char bytes[1 << 14];
  ssize_t now;
  while ((now = read(from, bytes, sizeof bytes)) > 0 || (now < 0 && errno == EINTR))
    if (now > 0)
      po_text_add_bytes(figure, bytes, (size_t)now);
  close(from);
}

static po_status run(const po_text *script, po_text *figure) {
  int to = -1, from = -1, ending = 0;
  void (*before)(int) = signal(SIGPIPE, SIG_IGN);
  const pid_t child = start(&to, &from);
  if (child > 0) {
    send(to, script); /* gnuplot prints nothing before the last lines of the script */
    receive(from, figure);
    while (waitpid(child, &ending, 0) < 0 && errno == EINTR)
      continue;
  }
  signal(SIGPIPE, before);
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
