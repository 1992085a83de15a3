/* Timed rounds of external solvers.
 *
 * In each round every question is a process of its own, which solves it twice, between the solves
 * of the other solvers. So the time of a process is measured from outside for each point, and the
 * first solve, which may include compilation, is apart from the second one. A process whose first
 * solve takes long is ended after it. Start and end of the program are measured by a request
 * without points, once a round. */
#ifndef PO_ROUNDS_H
#define PO_ROUNDS_H

#include "po_json_value.h"
#include "po_run.h"

/* Number of solves in a process, unless the first one takes long. */
enum { PO_ROUND_SOLVES = 2 };

/* Seconds of one round of a point. NAN: unknown. */
typedef struct po_round {
  double first, later; /* of the first and the second solve, as reported; without a second one the
                          same */
  double reported;     /* sum of all times that the process reports */
  double wall, processor;             /* of the process */
  double start_wall, start_processor; /* of the process that was asked nothing */
} po_round;

/* Allocates the times of a run of an external solver that is timed. Status: PO_NO_MEMORY. */
po_status po_rounds_create(po_case_run *run);

/* Reports whether a point is the first of the requested open points with its question, for which
 * the question is asked. */
bool po_rounds_leads(const po_case_run *run, size_t point);

/* Asks the question of a point in a process of its own, and stores the times; the first round gives
 * the result. Status: as po_ask. */
po_status po_rounds_ask(po_case_run *run, size_t point, unsigned round, const char *folder,
                        const volatile sig_atomic_t *stop);

/* Reports whether a point needs no further round: `round` was the last one, it failed, or its
 * solves took long enough (po_times.h). */
bool po_rounds_are_enough(const po_case_run *run, size_t point, unsigned round);

/* To be called after the last round of a point, which is number `round`: computes the medians. */
void po_rounds_end(po_case_run *run, size_t point, unsigned round);

/* Copies result and times of a point to another one with the same question, if it is requested and
 * open. Returned: in *copied, whether it is such a point. Status: PO_NO_MEMORY. */
po_status po_rounds_copy(po_case_run *run, size_t point, size_t to, bool *copied);

/* What the times of a point say about the clock of the solver. "more": a process reported more time
 * than it took. "less": in every round it reported clearly less than it took beyond its start.
 * "none": it reports no times, or has no result. Otherwise "agrees". */
const char *po_rounds_clock(const po_case_run *run, size_t point);

/* Returned: the number of points at which the clock does not agree. */
size_t po_rounds_disagreements(const po_case_run *run);

/* Returned: the member `timing` of a point in the record; null unless an external solver was timed.
 */
json_t *po_rounds_json(const po_case_run *run, size_t point);

/* Reads that member. Status: PO_NOT_FOUND if it is missing or incomplete. */
po_status po_rounds_read(po_case_run *run, size_t point, const json_t *timing);

#endif
