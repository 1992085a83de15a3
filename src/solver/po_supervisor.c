#include "po_supervisor.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <string.h>
#include <sys/pidfd.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/* Numbers of the descriptors of the supervisor, above those of standard input and output. */
enum { CONTROL = 3, REPORT, OUTPUT, FIRST_FREE };

/* Milliseconds between two searches for descendants that have not ended yet. */
static const int SWEEP_PAUSE = 2;

/* Entries of /proc, as getdents64 gives them. opendir would allocate memory. */
typedef struct {
  uint64_t inode;
  int64_t offset;
  unsigned short length;
  unsigned char type;
  char name[];
} entry;

/* Returned: the parent of a process, from the fourth field of /proc/PID/stat; 0: unknown. The
 * second field is the name of the program in parentheses, which may contain anything. */
static pid_t parent_of(int proc, const char *name) {
  char path[64], text[512];
  size_t length = strlen(name);
  if (length > 20)
    return 0;
  memcpy(path, name, length);
  memcpy(path + length, "/stat", sizeof "/stat");
  const int file = openat(proc, path, O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return 0;
  const ssize_t got = read(file, text, sizeof text - 1);
  close(file);
  text[got > 0 ? got : 0] = '\0';
  const char *at = strrchr(text, ')');
  pid_t parent = 0;
  if (!at || at[1] != ' ' || !at[2] || at[3] != ' ')
    return 0;
  for (at += 4; *at >= '0' && *at <= '9'; ++at)
    parent = 10 * parent + (*at - '0');
  return parent;
}

static pid_t number_of(const char *name) {
  pid_t number = 0;
  for (; *name >= '0' && *name <= '9'; ++name)
    number = 10 * number + (*name - '0');
  return *name ? 0 : number;
}

/* Sends KILL to all children of this process. Those of a child become children of this process when
 * it ends. */
static void kill_children(void) {
  static char buffer[16384];
  const pid_t self = getpid();
  const int proc = open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  long got = 0;
  while (proc >= 0 && (got = syscall(SYS_getdents64, proc, buffer, sizeof buffer)) > 0)
    for (long at = 0; at < got;) {
      const entry *e = (const void *)(buffer + at);
      const pid_t pid = number_of(e->name);
      if (pid > 0 && parent_of(proc, e->name) == self)
        kill(pid, SIGKILL);
      at += e->length;
    }
  if (proc >= 0)
    close(proc);
}

/* Ends all descendants. Returned: how many there were. */
static size_t sweep(void) {
  size_t count = 0;
  for (;;) {
    const pid_t pid = waitpid(-1, NULL, WNOHANG);
    if (pid > 0)
      ++count;
    else if (pid < 0 && errno == ECHILD)
      return count;
    else if (pid == 0) {
      kill_children();
      poll(NULL, 0, SWEEP_PAUSE);
    }
  }
}

static double seconds_of(struct timeval t) {
  return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

static void limit(int what, rlim_t value) {
  struct rlimit r;
  if (getrlimit(what, &r) == 0 && (r.rlim_cur == RLIM_INFINITY || r.rlim_cur > value)) {
    r.rlim_cur = value;
    setrlimit(what, &r);
  }
}

/* Becomes the program. Returns only if that fails. Returned: the errno. */
static int become(const po_process_request *request) {
  static const int RESET[] = {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGQUIT, SIGCHLD};
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, NULL);
  for (size_t i = 0; i < sizeof RESET / sizeof *RESET; ++i)
    signal(RESET[i], SIG_DFL);
  if (setpgid(0, 0) != 0 || chdir(request->folder) != 0)
    return errno;
  const int empty = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (empty < 0 || dup2(empty, STDIN_FILENO) < 0 || dup2(OUTPUT, STDOUT_FILENO) < 0 ||
      dup2(OUTPUT, STDERR_FILENO) < 0)
    return errno;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, request->most_bytes);
  po_blind();
  const int confined = po_confine(request->folder);
  if (confined && confined != ENOSYS && confined != EOPNOTSUPP)
    return confined;
  execve(request->command[0], request->command, request->environment);
  return errno;
}

/* Starts the program. Returned: its process; in *error, the errno of a failed start, or 0. */
static pid_t start(const po_process_request *request, int *error) {
  int started[2];
  *error = 0;
  if (pipe2(started, O_CLOEXEC) != 0) {
    *error = errno;
    return -1;
  }
  const pid_t pid = _Fork();
  if (pid == 0) {
    const int failed = become(request);
    (void)!write(started[1], &failed, sizeof failed);
    _exit(127);
  }
  if (pid < 0)
    *error = errno;
  close(started[1]);
  /* a successful execve closes the pipe without a message */
  int failed = 0;
  if (pid > 0 && read(started[0], &failed, sizeof failed) == (ssize_t)sizeof failed)
    *error = failed;
  close(started[0]);
  return pid;
}

/* Waits for the end of the process and does what the control socket says meanwhile. Returned: 0, or
 * an errno; then the process has been killed. */
static int wait_for_end(pid_t pid) {
  struct pollfd watched[2] = {{.fd = pidfd_open(pid, 0), .events = POLLIN},
                              {.fd = CONTROL, .events = POLLIN}};
  if (watched[0].fd < 0) {
    const int error = errno;
    kill(-pid, SIGKILL);
    return error;
  }
  for (;;) {
    watched[0].revents = watched[1].revents = 0;
    (void)poll(watched, 2, -1);
    if (watched[0].revents)
      return 0;
    if (!watched[1].revents)
      continue;
    char order = PO_SUPERVISOR_KILL;
    const ssize_t got = read(CONTROL, &order, 1);
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      watched[1].fd = -1;
    kill(-pid, got == 1 && order == PO_SUPERVISOR_TERM ? SIGTERM : SIGKILL);
  }
}

/* Moves the descriptors to their places and closes all others. */
static void arrange(int control, int report, int output) {
  const int high[3] = {fcntl(control, F_DUPFD, 16), fcntl(report, F_DUPFD, 16),
                       fcntl(output, F_DUPFD, 16)};
  for (int i = 0; i < 3; ++i)
    dup3(high[i], CONTROL + i, O_CLOEXEC);
  syscall(SYS_close_range, (unsigned)FIRST_FREE, ~0U, 0U);
}

_Noreturn void po_supervise(const po_process_request *request, int control, int report,
                            int output) {
  po_supervisor_report found = {0};
  struct rusage used;
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_IGN);
  signal(SIGHUP, SIG_IGN);
  signal(SIGPIPE, SIG_IGN);
  setpgid(0, 0); /* an interrupt at the terminal is for the main program alone */
  arrange(control, report, output);
  prctl(PR_SET_CHILD_SUBREAPER, 1L);
  const pid_t pid = start(request, &found.start_error);
  close(OUTPUT);
  if (pid > 0) {
    const int error = wait_for_end(pid);
    if (error)
      found.start_error = error;
    while (waitpid(pid, &found.status, 0) < 0 && errno == EINTR)
      continue;
    kill(-pid, SIGKILL);
    found.left = sweep();
  }
  if (getrusage(RUSAGE_CHILDREN, &used) == 0)
    found.processor = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  (void)!write(REPORT, &found, sizeof found);
  _exit(0);
}
