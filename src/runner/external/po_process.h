/* Runs an external solver: in a folder and a process group of its own, with a minimal environment.
 * At its end, what is left of its process group is killed. If this process ends first, however it
 * ends, the solver is killed (PR_SET_PDEATHSIG). A program that leaves the process group lives on.
 */
#ifndef PO_PROCESS_H
#define PO_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "po_ask_folder.h"

/* How a process ended, and what it used. */
typedef struct {
  int code;         /* its exit status; -1: a signal ended it */
  int signal;       /* that signal; 0: none */
  bool flooded;     /* it wrote too much to its standard output */
  bool left;        /* it left processes of its group behind */
  double wall;      /* seconds from start to end */
  double processor; /* seconds of processor time of the process and of the children it waited for */
  char output[2048]; /* the end of its standard output and standard error */
} po_process_end;

typedef struct {
  pid_t pid;
  int handle, output; /* a descriptor of the process, and a pipe; -1: closed */
  bool running;
  double begin;
  size_t written;
  po_process_end end; /* complete when `running` is false */
} po_process;

/* Starts the program of a manifest in a folder. Standard input is empty; standard output and
 * standard error are collected. The program gets no other open file of this process. To be called
 * by the thread that waits for the end. Status: PO_CANNOT_READ (the program cannot be executed),
 * PO_CANNOT_WRITE (no process could be created), PO_NO_MEMORY. */
po_status po_process_start(const po_solver *solver, const po_ask_folder *folder,
                           po_process *process);

/* Waits for the end of the process, at most some seconds. Returned: whether it has ended. */
bool po_process_wait(po_process *process, double seconds);

/* Ends a process: sends TERM to its group and, if it has not ended after `grace` seconds, KILL.
 * Returns after its end. */
void po_process_stop(po_process *process, double grace);

#endif
