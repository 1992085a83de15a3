/* The plan of a case: what will be computed, what will not, and why. */
#ifndef PO_PLAN_H
#define PO_PLAN_H

#include "po_case.h"
#include "po_digest.h"
#include "po_json_value.h"
#include "po_pins.h"
#include "po_reference.h"
#include "po_solver.h"
#include "po_text.h"

typedef struct {
  const po_case *kase;
  const po_solver *solver;          /* that computes the results; NULL: this program */
  char *name;                       /* in printed lines: of the case, or "SOLVER:CASE" */
  po_reference *references;         /* one a check, then one a measurement (po_case_check), open */
  po_pins pins;                     /* of the case, for results of this program */
  unsigned want;                    /* bit set of PO_WANT_..., for every point */
  char program[PO_DIGEST_LENGTH];   /* digest of the program or the solver */
  char solve_key[PO_DIGEST_LENGTH]; /* digest of all that determines the results: scenes, program */
  char key[PO_DIGEST_LENGTH];       /* digest of that, the text of the case and the references */
} po_plan;

/* Creates the plan of a case: opens its references, refuses tolerances below their uncertainty, and
 * decides what is computed. Given: an external solver, which must outlive the plan, and of which
 * only what it computes is wanted; NULL: this program.
 * Status: PO_CANNOT_READ (a reference), PO_BAD_INPUT (a tolerance), PO_NO_MEMORY. */
po_status po_plan_create(const po_case *kase, const char *data_folder, const po_solver *solver,
                         po_plan **result);
void po_plan_destroy(po_plan *plan);

/* Adds the options of a run that its results depend on: " --solver MANIFEST --knob VALUE" of an
 * external solver, whose name says whether the knob has another value than the last, and
 * " --time-limit S" if it replaces those of the case. */
void po_plan_add_options(const po_plan *plan, po_text *text);

/* Adds the command that solves one point of the case again, and the series to which it belongs, and
 * prints its verdicts. */
void po_plan_add_rerun(const po_plan *plan, size_t point, po_text *text);

/* Reports whether a check or a measurement is made: an external solver may not compute its
 * quantity. Every check is made on results of this program. */
bool po_plan_covers(const po_plan *plan, const po_check *check);

/* Returned: the quantities that an external solver is asked for: bit set of 1 << po_quantity. */
unsigned po_plan_asked(const po_plan *plan);

/* Returned: the request of a point, with the results that the plan needs. */
po_request po_plan_request(const po_plan *plan, size_t point);

/* Returned: the lines that describe the plan; NULL without memory. */
json_t *po_plan_describe(const po_plan *plan);

#endif
