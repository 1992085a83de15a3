/* The comparison of results with the pins of their case (po_pins.h), to the last bit, and of their
 * counters of work. A result is a point of a case; one without pins is not compared, nor is one of
 * an external solver, or of a case whose pins are of other scenes. */
#ifndef PO_IDENTITY_H
#define PO_IDENTITY_H

#include "po_run.h"
#include "po_text.h"

/* How a result compares with its pins. */
typedef struct {
  bool known;        /* it has pins; if not, the other members say nothing */
  bool same, worked; /* the same digest; the same counters of work */
  double difference; /* of the pull-off force, relative; infinite if only one result has one */
  po_pin pin;
} po_point_identity;

/* Status: PO_CANNOT_READ (a number of the table), PO_NO_MEMORY. */
po_status po_identity_point(const po_case_run *run, size_t point, po_point_identity *identity);

/* Of one case, or of several together. */
typedef struct {
  size_t compared, identical; /* results with pins, and with the same digest */
  size_t beyond;              /* different ones whose pull-off force differs by more than 1e-9 */
  size_t other_work;          /* results with other counters of work */
  size_t more_work;           /* cases of which a counter, summed over the results, is more than a
                                 tenth above that of the pins */
  size_t other_scenes;        /* cases that are not compared: their pins are of other scenes */
  size_t not_stored;          /* results of other cases that have no pins */
  double largest;             /* difference of the pull-off force of different results, relative */
  bool exact;                 /* whether every difference fails; false after a comparison */
} po_identity;

/* Compares the requested points of a finished run.
 * Returned: in *identity, what was found; in `lines`, a line if results differ: how many, the
 * largest difference and its point, and which oracles can judge it; a line if the work differs; or
 * that the pins are of other scenes, or missing.
 * Status: as above. */
po_status po_identity_compare(const po_case_run *run, po_identity *identity, po_text *lines);

/* Reports whether a case passes: no force differs by more than rounding, and there is no more work;
 * if it has to be exact, results and work are the stored ones. */
bool po_identity_passes(const po_identity *identity);

/* Reports whether a case has something to pass or to fail. */
bool po_identity_counts(const po_identity *identity);

/* Returned: the sum over several cases. */
po_identity po_identity_sum(const po_identity *identities, size_t count);

/* Adds "N of N results are identical to the last bit with the stored ones" and, if some are not, by
 * how much they differ. Adds nothing if nothing was compared. */
void po_identity_add(const po_identity *identity, po_text *text);

#endif
