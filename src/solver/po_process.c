#include "po_process.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "po_clock.h"
#include "po_supervisor.h"

/* Sends a message to the supervisor. It may have ended: then there is nothing to do. */
static void order(const po_process *process, char what) {
  (void)!send(process->control, &what, 1, MSG_NOSIGNAL);
}

static void close_pipe(int *end) {
  if (*end >= 0)
    close(*end);
  *end = -1;
}

static void close_all(po_process *process) {
  close_pipe(&process->control);
  close_pipe(&process->report);
  close_pipe(&process->output);
}

po_status po_process_start(const po_process_request *request, po_process *process) {
  int control[2] = {-1, -1}, report[2] = {-1, -1}, output[2] = {-1, -1};
  *process = (po_process){.control = -1, .report = -1, .output = -1};
  if (access(request->command[0], X_OK) != 0)
    return po_fail(PO_CANNOT_READ, "%s cannot be executed: %s", request->command[0],
                   strerror(errno));
  po_process_hide();
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, control) != 0 ||
      pipe2(report, O_CLOEXEC) != 0 || pipe2(output, O_CLOEXEC) != 0)
    process->supervisor = -1;
  else {
    process->begin = po_clock_wall();
    /* not fork: its handlers would stop the threads of the linear algebra library */
    process->supervisor = _Fork();
  }
  if (process->supervisor == 0)
    po_supervise(request, control[0], report[1], output[1]);
  const int error = errno;
  close_pipe(&control[0]);
  close_pipe(&report[1]);
  close_pipe(&output[1]);
  process->control = control[1];
  process->report = report[0];
  process->output = output[0];
  process->most_bytes = request->most_bytes;
  process->running = process->supervisor > 0;
  if (process->running) {
    fcntl(process->output, F_SETFL, O_NONBLOCK);
    return PO_OK;
  }
  close_all(process);
  return po_fail(PO_CANNOT_WRITE, "no process can be created: %s", strerror(error));
}

/* Appends to the end of the output, and forgets what is older. */
static void keep_output(po_process_end *end, const char *bytes, size_t size) {
  const size_t room = sizeof end->output - 1;
  if (size > room) {
    bytes += size - room;
    size = room;
  }
  size_t had = strlen(end->output);
  const size_t lost = had + size > room ? had + size - room : 0;
  memmove(end->output, end->output + lost, had - lost);
  had -= lost;
  for (size_t i = 0; i < size; ++i)
    end->output[had + i] = (char)(bytes[i] ? bytes[i] : '?');
  end->output[had + size] = '\0';
}

/* Reads what the process has printed. */
static void read_output(po_process *process) {
  char bytes[65536];
  for (;;) {
    const ssize_t got = read(process->output, bytes, sizeof bytes);
    if (got == 0)
      close_pipe(&process->output);
    if (got <= 0)
      return;
    process->written += (size_t)got;
    keep_output(&process->end, bytes, (size_t)got);
    if (process->written > process->most_bytes && !process->end.flooded) {
      process->end.flooded = process->end.stopped = true;
      order(process, PO_SUPERVISOR_KILL);
    }
  }
}

/* Reads the report of the supervisor, whose pipe closes when nothing of the process is left. */
static void read_report(po_process *process) {
  po_supervisor_report found = {.start_error = ECHILD};
  ssize_t got = 0;
  while ((got = read(process->report, &found, sizeof found)) < 0 && errno == EINTR)
    continue;
  po_process_end *end = &process->end;
  end->wall = po_clock_wall() - process->begin;
  end->processor = got == (ssize_t)sizeof found ? found.processor : (double)NAN;
  end->left = found.left;
  end->code = WIFEXITED(found.status) ? WEXITSTATUS(found.status) : -1;
  end->signal = WIFSIGNALED(found.status) ? WTERMSIG(found.status) : 0;
  if (process->output >= 0)
    read_output(process);
  if (found.start_error) {
    end->code = 127;
    snprintf(end->output, sizeof end->output, "it cannot be started: %s",
             strerror(found.start_error));
  }
  while (waitpid(process->supervisor, NULL, 0) < 0 && errno == EINTR)
    continue;
  process->running = false;
  close_all(process);
}

bool po_process_wait(po_process *process, double seconds) {
  const double until = po_clock_wall() + seconds;
  while (process->running) {
    struct pollfd watched[2] = {{.fd = process->report, .events = POLLIN},
                                {.fd = process->output, .events = POLLIN}};
    const double left = until - po_clock_wall();
    const int ready = poll(watched, 2, left > 0 ? (int)ceil(1e3 * left) : 0);
    if (ready > 0 && watched[1].revents)
      read_output(process);
    if (ready > 0 && watched[0].revents)
      read_report(process);
    else if (left <= 0 || (ready < 0 && errno == EINTR))
      break;
  }
  return !process->running;
}

void po_process_stop(po_process *process, double grace) {
  if (!process->running)
    return;
  process->end.stopped = true;
  order(process, PO_SUPERVISOR_TERM);
  const double until = po_clock_wall() + grace;
  while (!po_process_wait(process, 0.05) && po_clock_wall() < until)
    continue;
  if (process->running)
    order(process, PO_SUPERVISOR_KILL);
  while (!po_process_wait(process, 1))
    continue;
}
