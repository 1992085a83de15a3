/* Compares results with references. */
#ifndef PO_COMPARE_H
#define PO_COMPARE_H

#include "po_check_result.h"

/* Returned: the value of a quantity that is a single number; NAN if the solve did not deliver it.
 */
double po_compare_obtained(po_quantity quantity, const po_result *result);

/* Compares the result of one point with the reference of one check, and adds the results. A result
 * without the quantity, or a reference without the scene, leads to a verdict, not to a status.
 * Status: PO_CANNOT_READ (the reference lacks a column), PO_NO_MEMORY. */
po_status po_compare(const po_case *kase, size_t point, const po_check *check,
                     const po_reference *reference, const po_result *result,
                     po_check_results *check_results);

/* Refuses a tolerance that is smaller than the uncertainty of the reference: an error of the
 * reference could make such a check fail or pass. Status: PO_BAD_INPUT with the line of the
 * tolerance. */
po_status po_compare_check_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                     const po_reference *reference);

#endif
