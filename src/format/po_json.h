/* JSON of what is asked and what was read off: shared by `solve --json` and the records of a run.
 */
#ifndef PO_JSON_H
#define PO_JSON_H

#include "po_json_value.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"

/* The scene as asked: {"tabor": 1, ..., "outer_radius": number or "inf", "scheme": "triangle", ...,
 * "approach_start": number or null (chosen by the solver)}. */
json_t *po_json_input(const po_request *request);

/* {"input", "status", "reason", "rigid", "followed", "start", "end", "ended": {"why", "approach",
 * "load"}, "pull_off", "pull_off_any", "folds", "extrema", "work"}, "hysteresis", "staircase"
 * and "diagnostics" where these were wanted: no arrays of points. NULL without memory. */
json_t *po_json_result(const po_request *request, const po_result *result);

/* The points of the branch, and of the profile. */
json_t *po_json_curve(const po_result *result);
json_t *po_json_profile(const po_result *result);

/* {"displacement_control", "load_control", "jkr"}: both loops, and the two of the JKR theory (null
 * for a rigid scene). Each loop: {"preload", "pull_off", "energy_lost", "work", "jumps"}. */
json_t *po_json_hysteresis(const po_result *result);

/* {"displacement_control", "load_control", "jkr"}: the staircases, and those of the JKR theory
 * (null for a rigid scene). Each: {"steps": [...], "reached"}. */
json_t *po_json_staircases(const po_result *result);

/* The label of a jump, or of an end of one, numbered from 1: "1", "2"... in loading, "a", "b"...
 * "z", "aa"... in unloading. */
enum { PO_JUMP_LABEL_LENGTH = 8 };
void po_json_jump_label(bool loading, size_t number, char label[PO_JUMP_LABEL_LENGTH]);

/* {"residual", "rounding", "undiagnosed", "states", "sensitivity", "moved", "energy_defect",
 * "energy_defect_at", "reverse_trace", "seconds"}. */
json_t *po_json_diagnostics(const po_result *result);

/* The inverse of po_json_result but for `input`; arrays of points stay empty.
 * Status: PO_BAD_INPUT when something is missing or of the wrong type. */
po_status po_json_read_result(const json_t *object, po_result *result);

/* {"approach", "compressed": [{"inner", "outer"}], "held": the same, "grooves"}: the contact annuli
 * at the approach of the profile (po_contact_annuli), and how many grooves lie between those held
 * together. NULL without memory. */
json_t *po_json_contact(const po_result *result);

/* The inverse of po_json_hysteresis; null or absent: none. */
po_status po_json_read_hysteresis(const json_t *object, po_result *result);

/* The inverse of po_json_staircases; null or absent: none. */
po_status po_json_read_staircases(const json_t *object, po_result *result);

#endif
