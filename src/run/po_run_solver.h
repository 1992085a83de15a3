/* The runs of external solvers. */
#ifndef PO_RUN_SOLVER_H
#define PO_RUN_SOLVER_H

#include "po_case_run.h"

/* Takes the answers that processes of an interrupted run wrote and that are not in the journal, and
 * removes what is left of them. Status: PO_NO_MEMORY, PO_CANNOT_WRITE. */
po_status po_run_solver_recover(po_case_run *run);

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

#endif
