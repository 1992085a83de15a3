/* JSON of requests and results, shared by `solve --json` and the records of a run. doc/json.md
 * defines every key. */
#ifndef PO_JSON_H
#define PO_JSON_H

#include "po_json_value.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"

/* The request: {"tabor": 1, ..., "outer_radius": number or "inf", "scheme": "triangle", ...,
 * "approach_start": number or null (chosen by the solver)}. */
json_t *po_json_input(const po_request *request);

/* The result: {"input", "status", "reason", "rigid", "followed", "start", "end", "ended": {"why",
 * "approach", "load"}, "pull_off", "pull_off_any", "folds", "extrema", "work"}, and "hysteresis",
 * "staircase" and "diagnostics" if they were requested; no arrays of points. Returned: NULL if
 * memory runs out. */
json_t *po_json_result(const po_request *request, const po_result *result);

/* The document of schema "pulloff/1": the result, and "curve", "profile_approach", "profile" and
 * "contact" if they were requested. Returned: NULL if memory runs out. */
json_t *po_json_document(const po_request *request, const po_result *result);

/* The points of the branch, and the points of the profile (gap and traction over the radius). */
json_t *po_json_curve(const po_result *result);
json_t *po_json_profile(const po_result *result);

/* The loops: {"displacement_control", "load_control", "jkr"}; "jkr" holds the two loops of the JKR
 * theory (null for a rigid scene). Each loop: {"preload", "pull_off", "energy_lost", "work",
 * "jumps"}. */
json_t *po_json_hysteresis(const po_result *result);

/* The staircases: {"displacement_control", "load_control", "jkr"}; "jkr" holds the two staircases
 * of the JKR theory (null for a rigid scene). Each staircase: {"steps": [...], "reached"}. */
json_t *po_json_staircases(const po_result *result);

/* The label of a jump, or of one of its ends. Labels are numbered from 1: "1", "2", ... in loading;
 * "a", "b", ... "z", "aa", ... in unloading. */
enum { PO_JUMP_LABEL_LENGTH = 8 };
void po_json_jump_label(bool loading, size_t number, char label[PO_JUMP_LABEL_LENGTH]);

/* The diagnostics: {"residual", "rounding", "undiagnosed", "states", "sensitivity", "moved",
 * "energy_defect", "energy_defect_at", "reverse_trace", "seconds"}. */
json_t *po_json_diagnostics(const po_result *result);

/* The inverse of po_json_result, except for `input`; arrays of points stay empty. Status:
 * PO_BAD_INPUT if a member is missing or has the wrong type; PO_NO_MEMORY. */
po_status po_json_read_result(const json_t *object, po_result *result);

/* The contact annuli at the approach of the profile (po_contact_annuli): {"approach", "compressed":
 * [{"inner", "outer"}], "held": the same, "grooves"}; "grooves" is the number of gaps between the
 * annuli that are held together. Returned: NULL if memory runs out. */
json_t *po_json_contact(const po_result *result);

/* The inverse of po_json_hysteresis; null or absent: the result has no loops. Status:
 * PO_NO_MEMORY. */
po_status po_json_read_hysteresis(const json_t *object, po_result *result);

/* The inverse of po_json_staircases; null or absent: the result has no staircases. Status:
 * PO_NO_MEMORY. */
po_status po_json_read_staircases(const json_t *object, po_result *result);

#endif
