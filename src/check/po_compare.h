/* Our numbers beside those of the references. */
#ifndef PO_COMPARE_H
#define PO_COMPARE_H

#include "po_check_result.h"

/* Compares the result of one point with what the reference of one check says, and adds the
 * results. Status: PO_CANNOT_READ when the reference lacks a column; PO_NO_MEMORY. A result that
 * lacks the quantity, or a reference that does not speak of the scene, is a verdict and no failure.
 */
po_status po_compare(const po_case *kase, size_t point, const po_check *check,
                     const po_reference *reference, const po_result *result,
                     po_check_results *check_results);

/* The share of the points asked for (one flag a point) that a check concerns whose solve succeeded,
 * beside 1: one result for all of them. A failure without a reason is outside whatever the share.
 * Status: PO_NO_MEMORY. */
po_status po_compare_share(const po_case *kase, const bool *asked, const po_check *check,
                           const po_reference *reference, const po_result *results,
                           po_check_results *check_results);

/* The pull-off of each point asked for that is traced as well (one result a point), beside that
 * trace: a result for each. Status: PO_NO_MEMORY. */
po_status po_compare_traced(const po_case *kase, const bool *asked, const po_check *check,
                            const po_reference *reference, const po_result *results,
                            const po_result *traces, po_check_results *check_results);

/* Refuses a tolerance tighter than the uncertainty of what it is compared with: such a check could
 * fail, or pass, by the fault of the reference. Status: PO_BAD_INPUT with the line of the
 * tolerance. */
po_status po_compare_check_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                     const po_reference *reference);

#endif
