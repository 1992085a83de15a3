/* The closed form of the rigid smooth sphere as a reference. It applies to smooth scenes with the
 * law of the paper and an unbounded surface, whatever their Tabor parameter; the tolerance of the
 * check must include the effect of elasticity. */
#ifndef PO_REFERENCE_BRADLEY_H
#define PO_REFERENCE_BRADLEY_H

#include "po_reference_table.h"

/* Do for the closed form what po_reference_find and po_reference_points do for references. */
po_status po_bradley_find(po_quantity quantity, const po_request *request,
                          po_reference_number *number);
po_status po_bradley_points(po_quantity quantity, const po_request *request,
                            const po_result *result, po_reference_point **points, size_t *count);

#endif
