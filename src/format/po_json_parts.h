/* Functions that writers and readers of JSON share; private to this folder. */
#ifndef PO_JSON_PARTS_H
#define PO_JSON_PARTS_H

#include <jansson.h>
#include <stdint.h>

#include "po_result.h"

/* Parts of a result as JSON, and their inverses: a special point (read without its kind), the
 * pull-off (null if there is none), the work. */
json_t *po_json_special_point(const po_special_point *special);
void po_json_read_special_point(const json_t *object, po_special_point *special);
json_t *po_json_pull_off(const po_result *result);
void po_json_read_pull_off(const json_t *object, po_result *result);
json_t *po_json_pressed(const po_pressed *pressed);
po_pressed po_json_read_pressed(const json_t *object);
json_t *po_json_pull_off_any(const po_result *result);
void po_json_read_pull_off_any(const json_t *object, po_result *result);
json_t *po_json_work(const po_work *work);
void po_json_read_work(const json_t *object, po_work *work);

/* The inverse of po_json_diagnostics; NULL: there are no diagnostics. Status: PO_NO_MEMORY. */
po_status po_json_read_diagnostics(const json_t *object, po_result *result);

#endif
