/* Runs a program of the user: in a folder and a process group of its own, with a minimal
 * environment, and such that nothing of it remains after its end.
 *
 * Between this program and the other one is a supervisor, a copy of this process that does nothing
 * else. It adopts every descendant whose parent has ended, also one that has left the process group
 * (PR_SET_CHILD_SUBREAPER), and kills what is left when the program ends. If this process ends
 * first, however it ends, a socket closes and the supervisor does the same. */
#ifndef PO_PROCESS_H
#define PO_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "po_status.h"

typedef struct {
  char *const *command;     /* ends with NULL; the first word is the path of the program */
  char *const *environment; /* ends with NULL: the whole environment of the program */
  const char *folder;       /* absolute path; the only folder in which it can write, see below */
  size_t most_bytes;        /* that it may write to one file, or to its standard output */
} po_process_request;

/* How a process ended, and what it used. */
typedef struct {
  int code;          /* its exit status; -1: a signal ended it */
  int signal;        /* that signal; 0: none */
  bool stopped;      /* by po_process_stop, or because it wrote too much */
  bool flooded;      /* it wrote more than `most_bytes` to its standard output */
  size_t left;       /* number of processes that it left behind, which were killed */
  double wall;       /* seconds from start to end */
  double processor;  /* seconds of processor time of the process and its descendants */
  char output[2048]; /* the end of its standard output and standard error */
} po_process_end;

typedef struct {
  pid_t supervisor;
  int control, report, output; /* a socket and two pipes; -1: closed */
  bool running;
  double begin;
  size_t most_bytes, written;
  po_process_end end; /* complete when `running` is false */
} po_process;

/* Starts a process. Standard input is empty; standard output and standard error are collected. The
 * program gets no other open file of this process. Where the kernel has Landlock (Linux 5.13), it
 * can write in its folder and in /dev only. It cannot read the environment or the memory of this
 * process and of the supervisor, see po_process_hide, which this function calls. Status:
 * PO_CANNOT_READ (the program cannot be executed), PO_CANNOT_WRITE (no process could be created).
 */
po_status po_process_start(const po_process_request *request, po_process *process);

/* Waits for the end of the process, at most some seconds. Returned: whether it has ended. */
bool po_process_wait(po_process *process, double seconds);

/* Ends a process: sends TERM to its group and, if it has not ended after `grace` seconds, KILL to
 * it and all its descendants. Returns after its end. */
void po_process_stop(po_process *process, double grace);

/* Closes the files /proc/PID/environ and /proc/PID/mem of this process, and of the supervisors that
 * are copied from it, to other processes of the user: their environment may contain secrets. Until
 * its end this process writes no core file, and a debugger can be attached only by root. */
void po_process_hide(void);

/* Reports whether this kernel can confine the files that a process writes to a folder. */
bool po_process_confines(void);

#endif
