/* Structures as JSON, by their rows (po_rows.h), in both directions. */
#ifndef PO_JSON_ROWS_H
#define PO_JSON_ROWS_H

#include <jansson.h>

#include "po_physical.h"
#include "po_rows.h"
#include "po_status.h"

/* Returned: the object, or the array of the objects of a list; NULL if memory runs out. */
json_t *po_json_of(const po_block *block, const void *owner);
json_t *po_json_list_of(const po_block *block, const void *list, size_t count);

/* Fills a structure, which must be empty, from an object; NULL is an absent object. A number that
 * is absent or null is NAN. Status: PO_BAD_INPUT, PO_NO_MEMORY; what was read before is in the
 * structure. */
po_status po_json_into(const json_t *object, const po_block *block, void *owner);

/* A view of a structure in SI units: the members with the keys of a list, which ends with NULL. The
 * key of a number gets the name of its unit at its end. */
json_t *po_json_si(const po_block *block, const void *owner, const po_units *units,
                   const char *const *keys);
json_t *po_json_si_list(const po_block *block, const void *list, size_t count,
                        const po_units *units, const char *const *keys);

#endif
