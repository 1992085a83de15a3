/* What a record says about an external solver: its processes, what it covers, and the times of its
 * rounds (po_job.h). */
#ifndef PO_RECORD_SOLVER_H
#define PO_RECORD_SOLVER_H

#include "po_case_run.h"
#include "po_json_value.h"

/* Returned: the member `solver` of the record; null for a run of this program. */
json_t *po_record_solver(const po_case_run *run);

/* Returned: the member `timing` of a point in the record; null unless an external solver was timed.
 */
json_t *po_record_solver_timing(const po_case_run *run, size_t point);

/* Reads that member. Status: PO_NOT_FOUND if it is missing or incomplete. */
po_status po_record_solver_read_timing(po_case_run *run, size_t point, const json_t *timing);

/* Returned: the number of points at which the clock of the solver disagrees with the times of its
 * processes. */
size_t po_record_solver_disagreements(const po_case_run *run);

#endif
