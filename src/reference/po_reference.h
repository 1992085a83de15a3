/* Reference data: numbers from elsewhere that ours are set beside.
 *
 * A reference is a table (reference/NAME.csv), the closed form named "bradley", our own blessed
 * values ("pin"), "every_scene", the share 1 of the scenes that have equilibria to be found,
 * "zero", of diagnostics, or "traced", of what is followed. In a table a column with the name of a
 * scene key (tabor, ...) says which scene a row is for, a header with such a name says it for all
 * rows, and the other columns are named as in the records: of the pull-off force and approach
 * (force_uncertainty, approach_uncertainty), of a special point kind, approach and load
 * (approach_uncertainty, load_uncertainty), of a point of the curve approach and load
 * (uncertainty). Rows for one scene follow the branch. */
#ifndef PO_REFERENCE_H
#define PO_REFERENCE_H

#include "po_reference_table.h"

/* Opens the reference a case names, relative to the data folder, and checks it: the headers what,
 * source, kind, method, units, uncertainty, generator, command, date, sha256, and the checksum.
 * Status: PO_CANNOT_READ with file and line. `name` must outlive the reference. */
po_status po_reference_open(const char *data_folder, const char *name, po_reference *reference);

/* The same for a check; where one says what stands in for its reference, that may be absent, and is
 * of kind published when it is there. */
po_status po_reference_open_check(const char *data_folder, const po_check *check,
                                  po_reference *reference);

/* What it says of `quantity` (pull_off_force, pull_off_approach, contact_radius) for a scene.
 * Status: PO_NOT_FOUND: nothing, of this scene; PO_CANNOT_READ: a column is missing or not a
 * number. */
po_status po_reference_find(const po_reference *reference, po_quantity quantity,
                            const po_request *request, po_reference_number *number);

/* Its folds, extrema or curve points (by `quantity`) for a scene, along the branch: *points of
 * *count, to be freed. `result` says where ours ran, for a closed form that has no end of its own.
 * Status: as above. */
po_status po_reference_points(const po_reference *reference, po_quantity quantity,
                              const po_request *request, const po_result *result,
                              po_reference_point **points, size_t *count);

/* Up to which approach its special points of a scene are complete: all there are along the branch
 * until the approach first exceeds that (column complete_to; infinite when there is no such
 * column). Status: PO_CANNOT_READ: not a number. */
po_status po_reference_complete_to(const po_reference *reference, const po_request *request,
                                   double *approach);

#endif
