/* The order of the solves of a run. */
#ifndef PO_TASKS_H
#define PO_TASKS_H

#include "po_run.h"

/* The solve of a point, or of the series that begins with this point. For an external solver, a
 * process that is asked for a share of the points, `point` being the number of the share, or, if
 * the case is timed, a process that is asked for the question of this point. */
typedef struct {
  size_t run, point;
  unsigned round; /* number of the repetition, from 0 */
} po_task;

/* Lists the solves of all requested points that are not done: first those of cases without
 * repetitions, which may run in parallel, then the timed ones, round after round over the points of
 * all cases. In a round, each point is solved by all solvers before the next one.
 * Returned: *total tasks, of which the first *shared may run in parallel; the caller frees them.
 * NULL without memory. */
po_task *po_tasks_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total);

#endif
