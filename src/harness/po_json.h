/* JSON of what is asked and what was read off: shared by `solve --json` and the records of a run.
 */
#ifndef PO_JSON_H
#define PO_JSON_H

#include <jansson.h>

#include "po_outcome.h"
#include "po_status.h"
#include "po_text.h"

/* A finite number; null for NaN and infinities, which JSON cannot say. */
json_t *po_json_number(double value);

/* The scene as asked: {"tabor": 1, ..., "outer_radius": number or "inf", "scheme": "triangle", ...,
 * "approach_start": number or null (chosen by the solver)}. */
json_t *po_json_input(const po_request *request);

/* {"input", "status", "reason", "rigid", "pull_off", "folds", "extrema", "work"}: no arrays of
 * points. NULL without memory. */
json_t *po_json_outcome(const po_request *request, const po_outcome *outcome);

/* The points of the branch, and of the profile. */
json_t *po_json_curve(const po_outcome *outcome);
json_t *po_json_profile(const po_outcome *outcome);

/* Writes a document with 17 significant digits, indented, ending in a newline. */
po_status po_json_print(const json_t *document, po_text *text);

/* The inverse of po_json_outcome but for `input`; arrays of points stay empty.
 * Status: PO_BAD_INPUT when something is missing or of the wrong type. */
po_status po_json_read_outcome(const json_t *object, po_outcome *outcome);

#endif
