/* The list of reference tables, for pulloff list --references. */
#ifndef PO_LIST_REFERENCES_H
#define PO_LIST_REFERENCES_H

#include <stdbool.h>

#include "po_catalog.h"
#include "po_reference_list.h"
#include "po_status.h"

/* Prints every reference table, whether it is intact, and which cases use it. Status: after all
 * tables have been printed, PO_CANNOT_READ if one is not intact. */
po_status po_list_references(const po_catalog *catalog, bool json);

/* PO_CANNOT_READ with the message of the first table that is not intact, and how many more. */
po_status po_list_references_check(const po_reference_list *list);

#endif
