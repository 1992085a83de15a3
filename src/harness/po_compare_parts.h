/* The parts of po_compare, one a sort of quantity. */
#ifndef PO_COMPARE_PARTS_H
#define PO_COMPARE_PARTS_H

#include "po_compare.h"

/* The pull-off or the number of folds that a solve delivered; NAN when it did not. */
double po_compare_obtained(po_quantity quantity, const po_outcome *outcome);

/* Folds or extrema: their number and kinds, then approach and load of each. */
po_status po_compare_landmarks(const po_case *kase, size_t point, const po_check *check,
                               const po_reference *reference, const po_outcome *outcome,
                               po_results *results);

/* The counters of work, each beside its pin. */
po_status po_compare_work(const po_case *kase, size_t point, const po_check *check,
                          const po_reference *reference, const po_outcome *outcome,
                          po_results *results);

#endif
