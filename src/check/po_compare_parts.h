/* The parts of po_compare, one for each type of quantity. */
#ifndef PO_COMPARE_PARTS_H
#define PO_COMPARE_PARTS_H

#include "po_check_result.h"

/* Returned: the value of a quantity that is a single number; NAN if the solve did not deliver it.
 */
double po_compare_obtained(po_quantity quantity, const po_result *result);

/* Compares the jumps of loading and unloading at given approach: their number, and, if it agrees,
 * the approach, the load before and after, and the energy lost of each. Status: as po_compare. */
po_status po_compare_jumps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

/* Compares the steps of the staircase at given approach or at given load, over the range of preload
 * that result and table share: their number, and, if it agrees, the preload at which each step
 * begins, force and approach of its pull-off, and (at given approach) the energy lost. Status: as
 * po_compare. */
po_status po_compare_steps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

#endif
