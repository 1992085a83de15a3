/* What readers of JSON share: inside the harness. */
#ifndef PO_JSON_PARTS_H
#define PO_JSON_PARTS_H

#include <jansson.h>
#include <stdint.h>

#include "po_outcome.h"

/* A count, or 0 for what is absent. */
uint64_t po_json_count_of(const json_t *object, const char *key);

/* The inverse of po_json_diagnostics; NULL: there are none. Status: PO_NO_MEMORY. */
po_status po_json_read_diagnostics(const json_t *object, po_outcome *outcome);

#endif
