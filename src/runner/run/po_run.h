/* Solves the points of cases in parallel, and writes a record of each case. */
#ifndef PO_RUN_H
#define PO_RUN_H

#include <signal.h>

#include "po_case_run.h"

typedef struct {
  const char *output; /* the output folder of the run */
  int jobs;           /* number of threads; 0: one for each core */
  bool fresh;         /* solve points again whose results are known */
  const bool *needed; /* one a point of the only case: the others are used if their results are
                         known, and not solved; NULL: all are needed */
  bool brief;         /* print no line for a finished case on a terminal; a summary follows */
  const volatile sig_atomic_t *stop; /* the run ends soon after this becomes nonzero */
} po_run_options;

/* Solves the requested points whose results are not known, makes the checks and writes the records.
 *
 * If a case repeats its solves, they are timed: one solve at a time, in rounds over all points and
 * all solvers, so that a temporary load of the machine does not slow one more than the others. A
 * point whose solves have taken a tenth of a second of processor time together is not repeated
 * again. Such a point is stored after the last round. If only some points of a case are requested,
 * the checks are made on these, and the store keeps the points for a later run (po_store.h). A
 * record of them is written only for an external solver, with another name, for the report
 * (po_record_write).
 *
 * Status: PO_INTERRUPTED (a case is not finished; its solved points are stored; if all cases are
 * finished, `stop` has no effect), PO_CANNOT_WRITE, PO_CANNOT_READ (a reference), PO_NO_MEMORY. A
 * failed solve does not change the status, see po_case_run_verdict. */
po_status po_run(po_case_run *runs, size_t count, const po_run_options *options);

/* Compares the results of the requested points with the references, and judges them.
 *
 * For an external solver, counts what it covers, and adapts the verdicts: a jump is located with
 * the step of the solver, and a pull-off that no stable path reaches is not_reachable. The latter
 * is decided by a solve of this program, which is made only if a check against the pull-off does
 * not pass. Status: PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_run_check(po_case_run *run, const volatile sig_atomic_t *stop);

#endif
