/* Timed rounds of external solvers.
 *
 * In each round every question is a process of its own, which solves it twice, between the solves
 * of the other solvers. So the time of a process is measured from outside for each point, and the
 * first solve, which may include compilation, is apart from the second one. A process whose first
 * solve takes long is ended after it. Start and end of the program are measured by a request
 * without points, once a round. */
#ifndef PO_ROUNDS_H
#define PO_ROUNDS_H

#include "po_case_run.h"

/* Reports whether a point is the first of the requested open points with its question, for which
 * the question is asked. */
bool po_rounds_leads(const po_case_run *run, size_t point);

#endif
