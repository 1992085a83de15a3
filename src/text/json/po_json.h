/* JSON of requests and results, shared by `solve --json` and the records of a run: structures by
 * their rows, in both directions. doc/json.md defines every key. */
#ifndef PO_JSON_H
#define PO_JSON_H

#include <jansson.h>

#include "po_json_value.h"
#include "po_physical.h"
#include "po_request.h"
#include "po_result.h"
#include "po_rows.h"
#include "po_status.h"

/* The request: {"tabor": 1, ..., "outer_radius": number or "inf", "scheme": "triangle", ...,
 * "approach_start": number or null (chosen by the solver)}. */
json_t *po_json_input(const po_request *request);

/* The result: "input", and the keys of PO_RESULT_ROWS and PO_WANTED_ROWS; no arrays of points.
 * Returned: NULL if memory runs out. */
json_t *po_json_result(const po_request *request, const po_result *result);

/* The document of schema "pulloff/1": the result, and "curve", "profile_approach", "profile" and
 * "contact" if they were requested. Returned: NULL if memory runs out. */
json_t *po_json_document(const po_request *request, const po_result *result);

/* The inverse of po_json_result, except for `input`, with the curve, the profile and the contact if
 * the object has them. Status: PO_BAD_INPUT if a member is missing or has the wrong type;
 * PO_NO_MEMORY. */
po_status po_json_read_result(const json_t *object, po_result *result);

/* Returned: a structure as an object; NULL if memory runs out. */
json_t *po_json_of(const po_block *block, const void *owner);

/* The units of dimensionless numbers: {"length_m", "force_n", "traction_pa"}. */
json_t *po_json_units(const po_units *units);

/* The result in SI units: of the keys of PO_RESULT_ROWS and PO_WANTED_ROWS the numbers with a
 * dimension, and the parts and lists that have some. The key of a number has the unit at its end:
 * "force_n". Returned: NULL if memory runs out. */
json_t *po_json_result_in_si(const po_units *units, const po_result *result);

/* The same with "curve", "profile_approach_m", "profile" and "contact" if they were requested. */
json_t *po_json_document_in_si(const po_request *request, const po_result *result);

#endif
