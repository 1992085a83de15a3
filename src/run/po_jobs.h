/* The order of the jobs of a run. */
#ifndef PO_JOBS_H
#define PO_JOBS_H

#include "po_job.h"

/* Lists the solves of all requested points that are not done: first those of cases without
 * repetitions, which may run in parallel, then the timed ones, round after round over the points of
 * all cases. In a round, each point is solved by all solvers before the next one.
 * Returned: *total jobs, of which the first *shared may run in parallel; the caller frees them.
 * NULL without memory. */
po_job *po_jobs_list(const po_case_run *runs, size_t count, size_t *shared, size_t *total);

#endif
