/* The comparison of results with the stored digests of their cases (po_pins.h), and of pins, to
 * the last bit. A result is a point of a case; one without a stored digest is not compared, nor is
 * one of an external solver, or of a case whose digests are of other scenes. */
#ifndef PO_IDENTITY_H
#define PO_IDENTITY_H

#include "po_run.h"
#include "po_text.h"

typedef struct {
  size_t compared, identical; /* results with a stored digest, and with the same digest */
  size_t beyond;              /* different ones whose pull-off force differs by more than 1e-9 */
  size_t pins;                /* pins that have not the same bits, counters of work among them */
  size_t other_scenes;        /* cases that are not compared: their digests are of other scenes */
  double largest;             /* difference of the pull-off force of different results, relative */
} po_identity;

/* Reads the stored digests of the cases, so that a damaged table is found before the run. Status:
 * PO_CANNOT_READ, PO_NO_MEMORY. */
po_status po_identity_check(const po_case_run *runs, size_t count);

/* Compares the requested points of finished runs.
 * Returned: in *identity, what was found; in `lines`, one line for each case with a difference: how
 * many, the largest and its point, and which oracles can judge it; or that its digests are of other
 * scenes.
 * Status: PO_CANNOT_READ (a table of digests), PO_NO_MEMORY. */
po_status po_identity_compare(const po_case_run *runs, size_t count, po_identity *identity,
                              po_text *lines);

/* Adds "N of N results are identical to the last bit with the stored ones" and, if some are not, by
 * how much they differ. Adds nothing if nothing was compared. */
void po_identity_add(const po_identity *identity, po_text *text);

#endif
