/* The parts of reading a case file: its content is checked, and the points are computed from it. */
#ifndef PO_CASE_INTERNAL_H
#define PO_CASE_INTERNAL_H

#include "po_case.h"
#include "po_fields.h"
#include "po_text.h"

/* The fields of po_case_file: the schema of case files. */
extern const po_field PO_CASE_FIELDS[];

/* Checks the sections `sweep` and `sample`, if there are any, and fills them. Status: PO_BAD_INPUT;
 * the message states file, line, path, value and what was expected. */
po_status po_case_sweep_parse(po_case *kase, const po_yaml *yaml);

/* Checks the section `lines`: the names, the forms, the keys of the sweeps, and that every input of
 * each form is given. Status: as above. */
po_status po_case_lines_parse(po_case *kase, const po_yaml *yaml);

/* Size of a buffer for the path of a value in a case, e.g. checks[2].when[1]. */
enum { PO_CASE_WHERE_LENGTH = 64 };

/* Computes the values of an axis that gives from, to and count instead of values. Status: as above.
 */
po_status po_axis_fill(po_axis *axis, const char *where, const po_yaml *yaml);

/* What is done with an axis of a case; `where` is its path, e.g. "checks[1].when[2]". */
typedef po_status po_case_axis_act(const po_case *kase, po_axis *axis, const char *where,
                                   const po_yaml *yaml);

/* Checks the key and the values of an axis and sorts the values, unless the axis has no key, or was
 * checked. Status: as above. */
po_case_axis_act po_case_axis_check;

/* Does something with each axis of the sweep and of all conditions, until a status is not PO_OK.
 * Returned: that status. */
po_status po_case_each_axis(const po_case *kase, const po_yaml *yaml, po_case_axis_act *act);

/* Refuses the key at WHERE.key. The message says that `what` was expected and lists all keys of the
 * scene that `fits` accepts (NULL: all keys). Status: as above. */
po_status po_case_refuse_key(const po_yaml *yaml, const char *what, bool (*fits)(po_key key),
                             const char *where);

/* Converts the block `physical`, if there is one, to the dimensionless scene and stores its units.
 * Checks the scene, that no two keys set the same, as tabor and coupling, and that scene, sweep and
 * sample together give every key that has no default. Keys that follow from others may be absent:
 * nodes of panels, the wavelength of a smooth sphere. Status: as above. */
po_status po_case_scene_parse(po_case *kase, const po_yaml *yaml);

/* The word of a case file that says what an item of the sweep varies: key, together or table. */
const char *po_case_sweep_word(const po_sweep *sweep);

/* Replaces a name relative to the case file by its path. Status: PO_NO_MEMORY. */
po_status po_case_path(const po_case *kase, char **word);

/* Reads the table of an item of the sweep: a CSV file, by its path relative to the case file, whose
 * columns are keys and whose rows are settings; - is a key that is not given, and semicolons stand
 * for commas. Returned: sweep->together. Status: as above; PO_CANNOT_READ. */
po_status po_case_table_read(const po_case *kase, po_sweep *sweep, const char *where,
                             const po_yaml *yaml);

/* Cuts the uncertainties off the numbers of the scene, "0.05+-0.002", and adds them to those of the
 * case. Status: PO_BAD_INPUT; PO_NO_MEMORY. */
po_status po_case_uncertain_scene(po_case *kase, const po_yaml *yaml);

/* The same for an item of the sweep. Given: its index; its path. */
po_status po_case_uncertain_sweep(po_case *kase, unsigned item, const char *where,
                                  const po_yaml *yaml);

/* Completes the request of a point with its uncertain numbers less and more. Status: as above, also
 * of a number that is refused when it is moved. */
po_status po_case_uncertain_point(po_case *kase, po_point *point, const po_yaml *yaml);

/* Frees the uncertain numbers of a point. */
void po_case_uncertain_clear(po_point *point);

/* Makes the request of a point, whose setting is given. Given: whether the scene was changed after
 * it was parsed, so that what follows from the block `physical` is computed again; a label that is
 * completed. Status: as above. */
po_status po_case_make_request(const po_case *kase, const po_yaml *yaml, bool changed,
                               po_point *point, po_text *label);

/* Fails with the present message, preceded by the line and the path of a value in the case, unless
 * the message names it. Returned: the status. */
po_status po_case_refuse_for(const po_yaml *yaml, const char *where, po_status status);

/* Whether a key is one in SI units, which a sweep beside the block `physical` may vary. */
bool po_case_is_in_si(po_key key);

/* Sets what follows from the block `physical` for a point whose sweep varies keys in SI units, and
 * the units of its request. Status: as above. */
po_status po_case_scene_set_physical(const po_case *kase, const po_yaml *yaml, po_point *point);

/* Checks that the law or the profile of a point or of a line has each parameter that scene, sweep
 * and sample give; the points must be computed. Status: as above. */
po_status po_case_scene_check(po_case *kase, const po_yaml *yaml);

/* As po_case_path, for the table of a material, "prony:FILE"; other materials stay. */
po_status po_case_material_path(const po_case *kase, char **word);

/* Replaces the names of tables of profiles and materials, which are relative to the case file, by
 * their paths, and reads the tables. Status: as above; PO_CANNOT_READ. */
po_status po_case_files_resolve(po_case *kase, const po_yaml *yaml);

/* Computes kase->points: every drawn scene with every combination of the sweep, without those that
 * a rule of `leave_out` excludes; and draws the scenes of `traced`. Status: as above;
 * PO_NO_MEMORY. */
po_status po_case_expand(po_case *kase, const po_yaml *yaml);

#endif
