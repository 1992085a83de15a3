/* From what a case file says to what it means. */
#ifndef PO_CASE_PARSE_H
#define PO_CASE_PARSE_H

#include "po_case.h"
#include "po_text.h"
#include "po_yaml.h"

/* Checks every value of kase->file and fills want, repeats, checks and points.
 * Status: PO_BAD_INPUT with file, line, path, value and what was expected. */
po_status po_case_parse(po_case *kase, const po_yaml *yaml);

/* Checks and parses the section `sample`, if there is one. Status: as above. */
po_status po_case_sample_parse(po_case *kase, const po_yaml *yaml);

/* Whether a key is drawn. */
bool po_case_draws(const po_case_file *file, po_key key);

/* Puts the drawn values of scene number `index` into a request that has those of scene and sweep,
 * and adds them to its label. False when one of them is not possible for its key. */
bool po_case_sample_draw(const po_case_file *file, size_t index, po_request *request,
                         po_text *label);

/* Letters, digits, _ and -. */
bool po_case_is_name(const char *text);

/* Room for the path of a value in a case, e.g. checks[2].when[0]. */
enum { PO_CASE_WHERE_LENGTH = 64 };

/* Makes the values of an axis that has its ends and their number instead. Status: as above. */
po_status po_axis_fill(po_axis *axis, const char *where, const po_yaml *yaml);

/* Reads `follow` and what it asks of the rest of the case: only pull-offs are wanted and checked.
 * Status: as above. */
po_status po_case_follow_parse(po_case *kase, const po_yaml *yaml);

/* Reads `traced`, and whether it and the checks against it go together; when there are points,
 * draws those that are traced. Status: as above. */
po_status po_case_traced_parse(const po_case *kase, const po_yaml *yaml);
po_status po_case_traced_draw(po_case *kase, const po_yaml *yaml);

/* Checks the section `sweep`, if there is one, and fills it. Status: as above. */
po_status po_case_sweep_check(const po_case *kase, const po_yaml *yaml);

/* Checks the key and the values of an axis and sorts these; `where` is its path, e.g.
 * "checks[1].when[2]". */
po_status po_case_axis_check(po_axis *axis, const char *where, const po_yaml *yaml);

/* Refuses the key at WHERE.key: expected is `what`, followed by the names of all keys of the scene
 * that `fits` accepts (NULL: all). */
po_status po_case_refuse_key(const po_yaml *yaml, const char *what, bool (*fits)(po_key key),
                             const char *where);

/* Frees what checking the axes of a case made. */
void po_case_axes_clear(po_case_file *file);

/* Swept or drawn. */
bool po_case_varies(const po_case_file *file, po_key key);

/* What a case leaves unsaid a reader would have to guess: the keys that must be given, but for what
 * follows from the rest. Status: as above. */
po_status po_case_scene_check(const po_case *kase, const po_yaml *yaml);

/* The drawn scenes, each with every combination of the sweep but those left out: kase->points. */
po_status po_case_expand(po_case *kase, const po_yaml *yaml);

/* Makes the dimensionless scene of a block `physical`, if there is one, and its units. */
po_status po_case_physical_parse(po_case *kase, const po_yaml *yaml);

#endif
