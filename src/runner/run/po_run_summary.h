/* The points of a run as one CSV table. */
#ifndef PO_RUN_SUMMARY_H
#define PO_RUN_SUMMARY_H

#include "po_case_run.h"

/* Writes one row for each requested point of all cases, with the columns case, point, the keys that
 * vary (nan: not in this case), status, force, force_error, approach, approach_error,
 * contact_radius, contact_radius_error, energy_lost, energy_lost_error, work and work_error, nan
 * where a point has no such number. The last four are those of the loop that a test records:
 * through the spring, without one at given approach. If all cases are in SI units, so is the
 * table, with the unit at the end of each name; the prefixes are those of the first case. Given:
 * finished runs; the path "-" is standard output. Status: PO_BAD_INPUT if some cases are in SI
 * units and others are not; PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_run_summary_write(const char *path, const po_case_run *runs, size_t count);

#endif
