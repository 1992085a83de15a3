/* What will be computed for a case, and what will not, and why. */
#ifndef PO_PLAN_H
#define PO_PLAN_H

#include "po_case.h"
#include "po_digest.h"
#include "po_environment.h"
#include "po_reference.h"

typedef struct {
  const po_case *kase;
  po_reference *references; /* one a check, open */
  po_reference *measures;   /* one a measurement, open */
  unsigned want;            /* PO_WANT_...: of every point */
  char **lines;             /* the plan in words, one line each */
  size_t line_count;
  po_arithmetic arithmetic;         /* what computes it, or computed it */
  char program[PO_DIGEST_LENGTH];   /* the digest of that */
  char solve_key[PO_DIGEST_LENGTH]; /* changes with what determines the numbers: scenes, program */
  char key[PO_DIGEST_LENGTH];       /* changes with that, the case text and the references */
} po_plan;

/* Makes the plan of a case: opens its references, refuses tolerances tighter than these, decides.
 * Status: PO_CANNOT_READ (a reference), PO_BAD_INPUT (a tolerance, a figure script), PO_NO_MEMORY.
 */
po_status po_plan_create(const po_case *kase, const char *data_folder, po_plan **result);

/* The same of what is computed, or was, by another arithmetic than that of this process. */
po_status po_plan_create_for(const po_case *kase, const char *data_folder,
                             const po_arithmetic *arithmetic, po_plan **result);
void po_plan_destroy(po_plan *plan);

/* What a check or a measurement is against, as a path or a name: "reference/feng_pull_off.csv",
 * "bradley", "cases/pins/smoke.csv". */
const char *po_plan_reference_of(const po_plan *plan, const po_check *check);

/* The request of a point as planned. */
po_request po_plan_request(const po_plan *plan, size_t point);

#endif
