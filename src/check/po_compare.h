/* Compares results with references. */
#ifndef PO_COMPARE_H
#define PO_COMPARE_H

#include "po_check_result.h"

/* Returned: the value of a quantity that is a single number; NAN if the solve did not deliver it.
 */
double po_compare_obtained(po_quantity quantity, const po_result *result);

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

#endif
