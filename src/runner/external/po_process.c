#include "po_process.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/pidfd.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "po_deadline.h"
#include "po_memory.h"
#include "po_text.h"

/* The greatest size of a file that a solver writes, and of its standard output. */
static const rlim_t MOST_BYTES = (rlim_t)256 << 20;

static void free_words(char **words) {
  for (size_t i = 0; words && words[i]; ++i)
    free(words[i]);
  free(words);
}

/* The environment of a solver: what a program needs to run, one thread, and the variables that the
 * manifest names. Returned: to be freed; NULL without memory. */
static char **make_environment(const po_solver *solver, const char *folder) {
  const char *path = getenv("PATH");
  const char *const fixed[][2] = {{"PATH", path ? path : "/usr/bin:/bin"},
                                  {"HOME", folder},
                                  {"TMPDIR", folder},
                                  {"LANG", "C.UTF-8"},
                                  {"PYTHONDONTWRITEBYTECODE", "1"},
                                  {"OMP_NUM_THREADS", "1"},
                                  {"OPENBLAS_NUM_THREADS", "1"},
                                  {"MKL_NUM_THREADS", "1"},
                                  {"JULIA_NUM_THREADS", "1"},
                                  {"NUMEXPR_NUM_THREADS", "1"}};
  enum { FIXED = sizeof fixed / sizeof *fixed };
  const size_t all = FIXED + solver->file->environment_count;
  char **list = po_allocate(all + 1, sizeof *list);
  size_t count = 0;
  for (size_t i = 0; list && i < all; ++i) {
    po_text text = {0};
    const char *name = i < FIXED ? fixed[i][0] : solver->file->environment[i - FIXED];
    const char *value = i < FIXED ? fixed[i][1] : getenv(name);
    if (!value)
      continue;
    po_text_add(&text, "%s=%s", name, value);
    if (!(list[count++] = po_text_take(&text))) {
      free_words(list);
      return NULL;
    }
  }
  return list;
}

/* Returned: the command with the names of the files, to be freed; NULL without memory. */
static char **make_command(const po_solver *solver, const po_ask_folder *folder) {
  const char *const files[][2] = {{"{request}", folder->request.text},
                                  {"{table}", folder->table.text},
                                  {"{response}", folder->response.text}};
  const unsigned count = solver->file->command_count;
  char **words = po_allocate(count + 1, sizeof *words);
  for (unsigned i = 0; words && i < count; ++i) {
    words[i] = po_copy_text(solver->command[i]);
    for (size_t k = 0; words[i] && k < sizeof files / sizeof *files; ++k) {
      char *before = words[i];
      words[i] = po_solver_replace(before, files[k][0], files[k][1]);
      free(before);
    }
    if (!words[i]) {
      free_words(words);
      return NULL;
    }
  }
  return words;
}

static void limit(int what, rlim_t value) {
  struct rlimit r;
  if (getrlimit(what, &r) == 0 && (r.rlim_cur == RLIM_INFINITY || r.rlim_cur > value)) {
    r.rlim_cur = value;
    setrlimit(what, &r);
  }
}

/* Gives this process its standard streams, and closes all other files. Among them are the locks of
 * the folders of other threads: they must not outlive the program. */
static bool set_files(int output) {
  const int empty = open("/dev/null", O_RDONLY);
  return empty >= 0 && dup2(empty, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
         dup2(output, STDERR_FILENO) >= 0 &&
         syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0U) == 0;
}

/* Becomes the program; to be called in a new process. Returned: the errno of the step that failed.
 */
static int become(char *const *command, char *const *environment, const char *folder,
                  pid_t parent) {
  static const int RESET[] = {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGQUIT, SIGCHLD};
  sigset_t none;
  sigemptyset(&none);
  for (size_t i = 0; i < sizeof RESET / sizeof *RESET; ++i)
    signal(RESET[i], SIG_DFL);
  sigprocmask(SIG_SETMASK, &none, NULL); /* what came since the start of the process ends it */
  /* an interrupt at the terminal is for the main program alone */
  if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, (long)SIGKILL) != 0 || chdir(folder) != 0)
    return errno;
  if (getppid() != parent) /* it ended before the call */
    return ECHILD;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, MOST_BYTES);
  execve(command[0], command, environment);
  return errno;
}

static void close_end(int *end) {
  if (*end >= 0)
    close(*end);
  *end = -1;
}

/* Makes a pipe whose ends are none of the standard streams, which may be closed. Returned: 0, or an
 * errno. */
static int make_pipe(int ends[2]) {
  if (pipe2(ends, O_CLOEXEC) != 0)
    return errno;
  for (int i = 0; i < 2; ++i) {
    const int low = ends[i];
    ends[i] = fcntl(low, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    close(low);
  }
  return 0;
}

/* Becomes the program in a new process, or says in its output why not. Calls only functions that
 * are safe after a fork of a program with threads. */
static _Noreturn void run_command(char *const *command, char *const *environment,
                                  const char *folder, pid_t parent, int output) {
  const bool set = set_files(output);
  const int error = set ? become(command, environment, folder, parent) : errno;
  const char *const words[] = {"it cannot be started: ", strerrordesc_np(error)};
  for (size_t k = 0; k < 2 && words[k]; ++k)
    (void)!write(set ? STDOUT_FILENO : output, words[k], strlen(words[k]));
  _exit(127);
}

/* Starts the program. */
static po_status start_command(char *const *command, char *const *environment, const char *folder,
                               po_process *process) {
  int output[2] = {-1, -1}, error = make_pipe(output);
  const pid_t parent = getpid();
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  process->begin = po_clock_wall();
  /* not fork: its handlers would stop the threads of the linear algebra library */
  process->pid = error ? -1 : _Fork();
  if (process->pid == 0)
    run_command(command, environment, folder, parent, output[1]);
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  close_end(&output[1]);
  process->output = output[0];
  if (process->pid > 0)
    setpgid(process->pid, process->pid); /* whoever comes first, the program or who stops it */
  if (!error && (process->pid < 0 || (process->handle = pidfd_open(process->pid, 0)) < 0))
    error = errno;
  process->running = !error;
  if (!error) {
    fcntl(process->output, F_SETFL, O_NONBLOCK);
    return PO_OK;
  }
  if (process->pid > 0) {
    kill(-process->pid, SIGKILL);
    while (waitpid(process->pid, NULL, 0) < 0 && errno == EINTR)
      continue;
  }
  close_end(&process->output);
  return po_fail(PO_CANNOT_WRITE, "no process can be created: %s", strerror(error));
}

po_status po_process_start(const po_solver *solver, const po_ask_folder *folder,
                           po_process *process) {
  char **command = make_command(solver, folder);
  char **environment = make_environment(solver, folder->path.text);
  po_status status = command && environment ? PO_OK : PO_NO_MEMORY;
  *process = (po_process){.handle = -1, .output = -1};
  if (!status && access(command[0], X_OK) != 0)
    status = po_fail(PO_CANNOT_READ, "%s cannot be executed: %s", command[0], strerror(errno));
  if (!status)
    status = start_command(command, environment, folder->path.text, process);
  free_words(command);
  free_words(environment);
  return status;
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
  char bytes[1 << 14];
  for (;;) {
    const ssize_t got = read(process->output, bytes, sizeof bytes);
    if (got == 0)
      close_end(&process->output);
    if (got <= 0)
      return;
    process->written += (size_t)got;
    keep_output(&process->end, bytes, (size_t)got);
    if (process->written > MOST_BYTES && !process->end.flooded) {
      process->end.flooded = true;
      kill(-process->pid, SIGKILL);
    }
  }
}

static double seconds_of(struct timeval t) {
  return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* The process has ended. While it has not been waited for, no other group can have its number. */
static void take_end(po_process *process) {
  po_process_end *end = &process->end;
  int status = 0;
  struct rusage used = {0};
  end->wall = po_clock_wall() - process->begin;
  kill(-process->pid, SIGKILL);
  while (wait4(process->pid, &status, 0, &used) < 0 && errno == EINTR)
    continue;
  end->left = kill(-process->pid, 0) == 0;
  end->processor = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  end->code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  end->signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (process->output >= 0)
    read_output(process);
  process->running = false;
  close_end(&process->handle);
  close_end(&process->output);
}

bool po_process_wait(po_process *process, double seconds) {
  const double until = po_clock_wall() + seconds;
  while (process->running) {
    struct pollfd watched[2] = {{.fd = process->handle, .events = POLLIN},
                                {.fd = process->output, .events = POLLIN}};
    const double left = until - po_clock_wall();
    const int ready = poll(watched, 2, left > 0 ? (int)ceil(1e3 * left) : 0);
    if (ready > 0 && watched[1].revents)
      read_output(process);
    if (ready > 0 && watched[0].revents)
      take_end(process);
    else if (left <= 0 || (ready < 0 && errno == EINTR))
      break;
  }
  return !process->running;
}

void po_process_stop(po_process *process, double grace) {
  if (!process->running)
    return;
  kill(-process->pid, SIGTERM);
  const double until = po_clock_wall() + grace;
  while (!po_process_wait(process, 0.05) && po_clock_wall() < until)
    continue;
  if (process->running)
    kill(-process->pid, SIGKILL);
  while (!po_process_wait(process, 1))
    continue;
}
