/* The runs of external solvers. */
#ifndef PO_RUN_SOLVER_H
#define PO_RUN_SOLVER_H

#include "po_json_value.h"
#include "po_run.h"

/* Prepares the run of an external solver: points that its manifest excludes are marked as beyond
 * it, and done. Status: PO_NO_MEMORY. */
po_status po_run_solver_begin(po_case_run *run);

/* Takes the answers that processes of an interrupted run wrote and that are not in the journal, and
 * removes what is left of them. Status: PO_NO_MEMORY, PO_CANNOT_WRITE. */
po_status po_run_solver_recover(po_case_run *run, const char *output);

/* Reports whether an external solver is asked the same for two points: they differ only in the mesh
 * and the time limit of this program. */
bool po_run_solver_same(const po_case_run *run, size_t point, size_t other);

/* Returned: the question of a point. */
po_question po_run_solver_question(const po_case_run *run, size_t point);

/* Copies a result of a point. Status: PO_NO_MEMORY. */
po_status po_run_solver_copy(const po_case_run *run, size_t point, const po_result *from,
                             po_result *to);

/* Adds what processes used. The folder that they left is moved out of *log. Status: PO_NO_MEMORY.
 */
po_status po_run_solver_keep_log(po_case_run *run, po_ask_log *log);

/* Called, by one thread at a time, for each point whose result is known; `again` if another one was
 * known before. */
typedef po_status po_run_solver_taker(void *context, po_case_run *run, size_t point, bool again);

/* Asks the external solver for share number `share` of the requested points that are not done.
 * Points with equal questions are asked once. Status: as po_ask, and that of `taken`. */
po_status po_run_solver_ask(po_case_run *run, size_t share, const char *output,
                            const volatile sig_atomic_t *stop, po_run_solver_taker *taken,
                            void *context);

/* Counts what the solver covers, and adapts the verdicts: a jump is located with the step of the
 * solver, and a pull-off that no stable path reaches is not_reachable. The latter is decided by a
 * solve of this program, which is made only if a check against the pull-off does not pass.
 * Given: the results of all checks. Status: PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_run_solver_judge(po_case_run *run, const volatile sig_atomic_t *stop);

/* Returned: the member `solver` of the record; null for a run of this program. */
json_t *po_run_solver_json(const po_case_run *run);

#endif
