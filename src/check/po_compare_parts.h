/* The parts of po_compare, one for each type of quantity. */
#ifndef PO_COMPARE_PARTS_H
#define PO_COMPARE_PARTS_H

#include "po_check_result.h"

/* The result of a point and the reference of a check, and the list to which the results of their
 * comparison are added. */
typedef struct {
  const po_case *kase;
  size_t point;
  const po_check *check;
  const po_reference *reference;
  const po_result *result;
  po_check_results *check_results;
  po_request request; /* the scene that is looked up in the reference */
} po_comparison;

/* Adds the result of one number, as po_check_results_add. */
po_check_result *po_compare_add(const po_comparison *c, const char *name, const char *suffix,
                                double obtained, po_reference_number expected);

/* Compares the jumps of loading and unloading at given approach: their number, and, if it agrees,
 * the approach, the load before and after, and the energy lost of each. Status: as po_compare. */
po_status po_compare_jumps(const po_comparison *c);

/* Compares the steps of the staircase at given approach or at given load, over the range of preload
 * that result and table share: their number, and, if it agrees, the preload at which each step
 * begins, force and approach of its pull-off, and (at given approach) the energy lost. Status: as
 * po_compare. */
po_status po_compare_steps(const po_comparison *c);

#endif
