/* What a check found. */
#ifndef PO_CHECK_RESULT_H
#define PO_CHECK_RESULT_H

#include <stdbool.h>

#include "po_case.h"
#include "po_reference.h"

typedef enum {
  PO_WITHIN,
  PO_OUTSIDE,
  PO_NO_RESULT,         /* the solve did not deliver the quantity */
  PO_MISSING_REFERENCE, /* the reference says nothing of this scene */
  /* What the ledgers say together, see po_judge.h. */
  PO_IMPROVED,         /* the pin moved, towards every oracle; or less work: bless it */
  PO_REGRESSED,        /* the pin moved, away from an oracle; or more work */
  PO_MOVED,            /* the pin moved, and no oracle says whether for the better */
  PO_WRONG_AND_FROZEN, /* the oracle fails, and the pin holds */
  PO_SLACK,            /* within, but the tolerance is so wide that it says nothing */
  PO_VERDICT_COUNT
} po_verdict;

typedef struct {
  char *id;     /* "pull_off_force/feng_pull_off/tabor=1" */
  size_t point; /* of the case; when `whole`, one of those the result is of */
  bool whole;   /* of all points of the case together */
  const po_check *check;
  char quantity[32]; /* "pull_off_force", "fold_approach"... */
  char subject[64];  /* the same of the same point in every ledger: "fold_approach/jump_in-1" */
  po_ledger ledger;
  double obtained;       /* NAN: none; for a curve none, only `error` */
  double expected;       /* NAN: none */
  double error;          /* obtained - expected, or a distance; NAN: none */
  double allowance;      /* the tolerance as an absolute number; NAN: unknown without `expected` */
  double uncertainty;    /* of the reference, absolute; NAN: not given */
  double ratio;          /* |error| / allowance; NAN: none */
  double approach, load; /* where on the curve; NAN: nowhere in particular */
  po_verdict verdict;
  char note[200];
} po_check_result;

typedef struct {
  po_check_result *items;
  size_t count;
} po_check_results;

/* "within", "outside", "no_result", "missing_reference", "improved", "regressed", "moved",
 * "wrong_and_frozen", "slack". */
const char *po_verdict_name(po_verdict verdict);

/* Whether a check with this verdict passes: within, improved and slack do. The last two are to be
 * told nevertheless. */
bool po_verdict_passes(po_verdict verdict);

/* The short name of the reference of a check: "reference/feng_pull_off.csv" -> "feng_pull_off". */
void po_check_result_reference(const po_check *check, char name[64]);

/* Adds a result for one number, its verdict by the tolerance of the check; `name` is the quantity
 * in the results, `suffix` ends the id ("" or "jump_in-1"). Returned: the new item; NULL without
 * memory. */
po_check_result *po_check_results_add(po_check_results *check_results, const po_case *kase,
                                      size_t point, const po_check *check, const char *name,
                                      const char *suffix, double obtained,
                                      po_reference_number expected);

void po_check_results_clear(po_check_results *check_results);

#endif
