/* The rigid smooth sphere in closed form, as a reference. It speaks of smooth scenes that are not
 * cut, whatever their Tabor parameter: how far from rigid they may be, the case says in its
 * tolerance. */
#ifndef PO_REFERENCE_BRADLEY_H
#define PO_REFERENCE_BRADLEY_H

#include "po_reference_table.h"

/* As po_reference_find and po_reference_points. */
po_status po_bradley_find(po_quantity quantity, const po_request *request,
                          po_reference_number *number);
po_status po_bradley_points(po_quantity quantity, const po_request *request,
                            const po_result *result, po_reference_point **points, size_t *count);

#endif
