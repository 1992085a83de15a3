/* What a check found. */
#ifndef PO_RESULT_H
#define PO_RESULT_H

#include "po_case.h"
#include "po_reference.h"

typedef enum {
  PO_WITHIN,
  PO_OUTSIDE,
  PO_NO_RESULT,         /* the solve did not deliver the quantity */
  PO_MISSING_REFERENCE, /* the reference says nothing of this scene */
} po_verdict;

typedef struct {
  char *id;     /* "pull_off_force/feng_pull_off/tabor=1" */
  size_t point; /* of the case; when `whole`, one of those the result is of */
  bool whole;   /* of all points of the case together */
  const po_check *check;
  char quantity[32]; /* "pull_off_force", "fold_approach"... */
  po_ledger ledger;
  double obtained;    /* NAN: none; for a curve none, only `error` */
  double expected;    /* NAN: none */
  double error;       /* obtained - expected, or a distance; NAN: none */
  double allowance;   /* the tolerance as an absolute number; NAN: unknown without `expected` */
  double uncertainty; /* of the reference, absolute; NAN: not given */
  double ratio;       /* |error| / allowance; NAN: none */
  po_verdict verdict;
  char note[200];
} po_result;

typedef struct {
  po_result *items;
  size_t count;
} po_results;

/* "within", "outside", "no_result", "missing_reference". */
const char *po_verdict_name(po_verdict verdict);

/* Adds a result for one number, its verdict by the tolerance of the check; `name` is the quantity
 * in the results, `suffix` ends the id ("" or "jump_in-1"). Returned: the new item; NULL without
 * memory. */
po_result *po_results_add(po_results *results, const po_case *kase, size_t point,
                          const po_check *check, const char *name, const char *suffix,
                          double obtained, po_reference_number expected);

void po_results_clear(po_results *results);

#endif
