/* A job: what a thread of a run does at a time. There are four kinds: the solve of a point, the
 * solves of a series, a share of the points of an external solver, and one timed round of a
 * question to it. All of them hand over their points in the same way. */
#ifndef PO_JOB_H
#define PO_JOB_H

#include <signal.h>

#include "po_case_run.h"

/* Where a job hands over its points. */
typedef struct {
  const volatile sig_atomic_t *stop; /* the job ends soon after this becomes nonzero */
  /* Called after a solve of a point, inside the critical section po_run_finish or while no other
   * job is done. Given: `last`, that the result of the point is known; a point may be handed over
   * again with another result. */
  po_status (*take)(void *context, po_case_run *run, size_t point, bool last);
  void *context;
} po_job_desk;

typedef struct po_job po_job;

/* Does a job. Status: PO_INTERRUPTED, PO_NO_MEMORY, PO_CANNOT_WRITE, that of desk->take; that of
 * po_ask for an external solver. A failed solve is a result. */
typedef po_status po_job_work(po_case_run *run, const po_job *job, const po_job_desk *desk);

struct po_job {
  size_t run;   /* number of the run of the case */
  size_t point; /* the point; the first one of a series, or of a question; the number of a share */
  unsigned round; /* number of the repetition, from 0 */
  po_job_work *work;
};

/* Solves a point. The first round gives the result, later rounds only the time. */
po_job_work po_job_solve;

/* Solves the series of scenes that begins with a point by parameter continuation. All its points
 * are solved, even if they are not requested or their results are known, because each result
 * depends on its predecessors. */
po_job_work po_job_series;

/* Asks the external solver for share number `point` of the requested points that are not done.
 * Points with equal questions are asked once. Each answer is handed over before the next one is
 * read. */
po_job_work po_job_share;

/* Does one timed round of the question of a point, unless an earlier round was the last. All points
 * with this question are handed over after the last round.
 *
 * In each round every question is a process of its own, which solves it twice, between the solves
 * of the other solvers. So the time of a process is measured from outside for each point, and the
 * first solve, which may include compilation, is apart from the second one. A process whose first
 * solve takes long is ended after it. Start and end of the program are measured by a request
 * without points, once a round. */
po_job_work po_job_round;

/* Lists the solves of all requested points that are not done: first those of cases without
 * repetitions, which may run in parallel, then the timed ones, round after round over the points of
 * all cases. In a round, each point is solved by all solvers before the next one.
 * Returned: *total jobs, of which the first *shared may run in parallel; the caller frees them.
 * NULL without memory. */
po_job *po_jobs_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total);

/* Returned: the median of the seconds of `count` rounds, without those that are NAN; NAN if all
 * are.
 */
double po_times_median(const po_round *rounds, unsigned count);

/* Returned: whether the first `count` solves of a point took a tenth of a second of processor time
 * together, so that it is not solved again. */
bool po_times_are_enough(const po_round *rounds, unsigned count);

/* Reports whether a point is the first of the requested open points with its question, for which
 * the question is asked. */
bool po_run_solver_leads(const po_case_run *run, size_t point);

/* Takes the answers that processes of an interrupted run wrote and that are not in the store, and
 * removes what is left of them. Status: PO_NO_MEMORY, PO_CANNOT_WRITE. */
po_status po_run_solver_recover(po_case_run *run);

#endif
