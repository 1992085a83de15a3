/* In which order the solves of a run are done. */
#ifndef PO_TASKS_H
#define PO_TASKS_H

#include "po_run.h"

/* One solve, of a point or of the line of points that begins there. */
typedef struct {
  size_t run, point;
  unsigned round; /* below the repeats of the case */
} po_task;

/* Lists the solves of all points asked for that are not done: first those of cases that do not
 * repeat, which may run side by side, then those that are timed, round after round over the points
 * of all cases.
 * Returned: *total tasks, of which the first *shared may run side by side, to be freed; NULL
 * without memory. */
po_task *po_tasks_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total);

#endif
