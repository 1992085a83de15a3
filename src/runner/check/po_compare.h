/* Compares results with references: the results of checks, and their verdicts. */
#ifndef PO_COMPARE_H
#define PO_COMPARE_H

#include <stdbool.h>

#include "po_case.h"
#include "po_reference.h"

typedef enum {
  PO_WITHIN,
  PO_OUTSIDE,
  PO_NO_RESULT,         /* the solve did not deliver the quantity */
  PO_MISSING_REFERENCE, /* the reference has no value for this scene */
  PO_SLACK,             /* within, but the tolerance is too wide to detect an error */
  PO_NOT_REACHABLE,     /* outside, but an external solver that follows stable equilibria cannot see
                           the expected value */
  PO_VERDICT_COUNT
} po_verdict;

typedef struct {
  char *id;     /* "pull_off_force/feng_pull_off/tabor=1"; with "/check-2" for the second check of
                   the case if an earlier one has the same id */
  size_t point; /* number of the point in the case; if `whole`, an example */
  bool whole;   /* the result belongs to all points of the case together */
  const po_check *check;
  char quantity[32]; /* "pull_off_force", "fold_approach"... */
  char subject[64];  /* identifies the number in a point, e.g. "fold_approach/jump_in-1"; equal in
                        checks of the same number against different references */
  const po_reference *reference;
  po_ledger ledger;
  double obtained;       /* NAN: no result, or a curve, which has only an error */
  double expected;       /* NAN: no reference value, or a curve */
  double error;          /* obtained - expected, or the distance of curves; NAN: not known */
  double allowance;      /* the tolerance as an absolute number; NAN: not known */
  double uncertainty;    /* of the reference, absolute; NAN: not given */
  double ratio;          /* |error| / allowance; NAN: not known */
  double approach, load; /* place on the curve; NAN: the number has no place */
  po_verdict verdict;
  char note[200];
} po_check_result;

typedef struct {
  po_check_result *items;
  size_t count;
} po_check_results;

extern const char *const PO_VERDICTS[PO_VERDICT_COUNT]; /* the name of each verdict */

/* Reports whether a check with this verdict passes: within, slack or not_reachable. The user is
 * told of all verdicts but within. */
bool po_verdict_passes(po_verdict verdict);

/* Returned: in `name`, the short name of the reference of a check: "feng_pull_off" for
 * "reference/feng_pull_off.csv". */
void po_check_result_reference(const po_check *check, char name[64]);

/* The result of a point and the reference of a check, and the list to which the results of their
 * comparison are added. */
typedef struct {
  const po_case *kase;
  size_t point;
  const po_check *check;
  const po_reference *reference;
  const po_result *result;
  const po_result *trace; /* the full trace of the scene, which is the reference `traced` */
  po_check_results *check_results;
  po_request request; /* the scene that is looked up in the reference */
} po_compare_input;

/* Adds the result of the comparison of one number; the tolerance of the check decides the verdict.
 * Given: `name`, the quantity in the results; `suffix`, the end of the id ("" or
 * "jump_in-1/load").
 * Returned: the new item; NULL without memory. */
po_check_result *po_compare_add(const po_compare_input *c, const char *name, const char *suffix,
                                double obtained, po_reference_number expected);

/* Appends to the note of a result; "; " separates it from what the note has. */
void po_check_result_note(po_check_result *item, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

void po_check_results_clear(po_check_results *check_results);

/* Returned: the value of a quantity that is a single number; NAN if the solve did not deliver it.
 */
double po_compare_obtained(po_quantity quantity, const po_result *result);

/* Returned: the estimated error of a quantity of the pull-off; NAN if there is none. */
double po_compare_stated_error(po_quantity quantity, const po_result *result);

/* Compares the result of one point with the reference of one check, unless the check does not apply
 * to the point, and adds the results. Given: all members but the request. A result
 * without the quantity, or a reference without the scene, leads to a verdict, not to a status.
 * Status: PO_CANNOT_READ (the reference lacks a column), PO_NO_MEMORY. */
po_status po_compare(const po_compare_input *comparison);

/* The part of po_compare for the jumps of loading and unloading at given approach, and for the
 * steps of the staircase at given approach or at given load: their number, and, if it agrees, of
 * each jump the approach, the load before and after, and the energy lost; of each step, over the
 * range of preload that result and table share, the preload at which it begins, force and approach
 * of its pull-off, and (at given approach) the energy lost. Status: as po_compare. */
po_status po_compare_steps(const po_compare_input *c);

/* Refuses a tolerance that is smaller than the uncertainty of the reference: an error of the
 * reference could make such a check fail or pass. Status: PO_BAD_INPUT with the line of the
 * tolerance. */
po_status po_compare_check_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                     const po_reference *reference);

/* Finds the checks whose tolerance is slack: more than a thousand times the largest error of all
 * points of the case, because the same tolerance applies to all of them. Errors below the
 * uncertainty of the reference, or below rounding, are replaced by these. The tolerance of integers
 * (numbers of folds, shares of solved points) is never slack. */
void po_judge_tolerances(po_check_results *check_results);

#endif
