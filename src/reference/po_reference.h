/* References: the numbers with which checks compare the results.
 *
 * A reference is one of:
 *   a table, reference/NAME.csv;
 *   "bradley", the closed form of the rigid smooth sphere;
 *   "pin", the blessed values of this program;
 *   "every_scene", the share 1: every scene has an equilibrium;
 *   "zero", for diagnostics, which vanish for an exact solution;
 *   "traced", for a series: the full trace of the scene.
 *
 * In a table, a column with the name of a scene key (tabor, ...) selects the scene of a row, and a
 * header with such a name selects the scene of all rows. The other columns have the names of the
 * records, with columns NAME_uncertainty: force and approach for the pull-off; kind, approach and
 * load for a special point; approach and load for a point of the curve. The rows of one scene are
 * in the order of the branch. */
#ifndef PO_REFERENCE_H
#define PO_REFERENCE_H

#include "po_reference_table.h"

/* Opens a reference and checks it: the headers what, source, kind, method, units, uncertainty,
 * generator, command, date and sha256 must exist, and the checksum must agree.
 * Given: `name` as in the case file, relative to the data folder; it must outlive the reference.
 * Status: PO_CANNOT_READ with file and line. */
po_status po_reference_open(const char *data_folder, const char *name, po_reference *reference);

/* Looks up the value of a quantity that is a single number (e.g. pull_off_force) for a scene.
 * Status: PO_NOT_FOUND (the reference has no value for the scene), PO_CANNOT_READ (a column is
 * missing or does not hold a number). */
po_status po_reference_find(const po_reference *reference, po_quantity quantity,
                            const po_request *request, po_reference_number *number);

/* Looks up the folds, the extrema or the points of the curve for a scene.
 * Given: `quantity`; `result`, whose range of approach limits the points of a closed form.
 * Returned: *count points in the order of the branch; the caller frees *points.
 * Status: as above. */
po_status po_reference_points(const po_reference *reference, po_quantity quantity,
                              const po_request *request, const po_result *result,
                              po_reference_point **points, size_t *count);

/* Looks up the column complete_to: the table contains every special point of the branch of a scene
 * up to the place where the approach first exceeds this value. Infinite without such a column.
 * Status: PO_CANNOT_READ (the cell does not hold a number). */
po_status po_reference_complete_to(const po_reference *reference, const po_request *request,
                                   double *approach);

#endif
