/* References: the numbers with which checks compare the results.
 *
 * A reference is one of:
 *   a table, reference/NAME.csv;
 *   "bradley", the closed form of the rigid smooth sphere;
 *   "every_scene", the share 1: every scene has an equilibrium;
 *   "zero", for diagnostics, which vanish for an exact solution;
 *   "traced", for a series: the full trace of the scene;
 *   a row of a table, reference/NAME.csv#PROBLEM:QUANTITY: that with these words in the columns
 *   problem and quantity. It has one number, in the columns value and half_width, for any scene.
 *
 * In a table, a column with the name of a scene key (tabor, ...) selects the scene of a row, and a
 * header with such a name selects the scene of all rows. The other columns have the names of the
 * records, with columns NAME_uncertainty: force and approach for the pull-off; kind, approach and
 * load for a special point; approach and load for a point of the curve. The rows of one scene are
 * in the order of the branch. */
#ifndef PO_REFERENCE_H
#define PO_REFERENCE_H

#include "po_check.h"
#include "po_csv.h"
#include "po_file.h"
#include "po_input.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"
#include "po_text.h"

typedef enum { PO_LEDGER_ORACLE, PO_LEDGER_PUBLISHED } po_ledger;

typedef struct {
  const char *name; /* as in the case file */
  const char *row; /* PROBLEM:QUANTITY of a row of a table, part of the name; NULL: a whole table */
  po_ledger ledger;
  po_reference_type type;
  po_csv table;                  /* if the reference is a table */
  char digest[PO_DIGEST_LENGTH]; /* of the whole file; of the name if there is no file */
  char *converted;               /* cells of the table that were in SI units; NULL: none */
} po_reference;

/* A number of a reference. */
typedef struct {
  double value;
  double uncertainty; /* absolute; NAN: not given */
} po_reference_number;

extern const char *const PO_LEDGERS[]; /* the name of each ledger */

/* Returned: the path of the table in the name of a reference, without #PROBLEM:QUANTITY. */
po_file_path po_reference_file(const char *name);

/* Opens a reference and checks it: the headers what, source, kind, method, units, uncertainty,
 * generator, command, date and sha256 must exist, and the checksum must agree.
 * Given: `name` as in the case file, relative to the data folder; it must outlive the reference.
 * Status: PO_CANNOT_READ with file and line. */
po_status po_reference_open(const char *data_folder, const char *name, po_reference *reference);

/* Checks all cells of a table, of which a check reads only those of its scenes: the values of the
 * keys of a scene, and the numbers in every other column that has a number, or whose name is that
 * of a number which checks read. inf, -inf and - stand for no number in columns that no check
 * reads. Status: PO_CANNOT_READ with file and line. */
po_status po_reference_check_cells(const po_reference *reference);

/* Looks up the value of a quantity that is a single number (e.g. pull_off_force) for a scene.
 * Status: PO_NOT_FOUND (the reference has no value for the scene), PO_CANNOT_READ (a column is
 * missing or does not hold a number). */
po_status po_reference_find(const po_reference *reference, po_quantity quantity,
                            const po_request *request, po_reference_number *number);

/* Looks up the folds, the extrema or the points of the curve for a scene.
 * Given: `quantity`; `result`, whose range of approach limits the points of a closed form.
 * Returned: *count points in the order of the branch, with approach, load and the uncertainties of
 * the reference as their errors (NAN: not given), and of special points the kind; the caller frees
 * *points.
 * Status: as above. */
po_status po_reference_points(const po_reference *reference, po_quantity quantity,
                              const po_request *request, const po_result *result,
                              po_special_point **points, size_t *count);

/* Looks up the column complete_to: the table contains every special point of the branch of a scene
 * up to the place where the approach first exceeds this value. Infinite without such a column.
 * Status: PO_CANNOT_READ (the cell does not hold a number). */
po_status po_reference_complete_to(const po_reference *reference, const po_request *request,
                                   double *approach);

/* The table of a reference: the rows of a scene, and the numbers in a row. */

/* Reads a table, checks its headers and its checksum, and fills reference->table, digest and
 * ledger.
 * Given: `shown`, the name of the file in messages.
 * Status: PO_CANNOT_READ with file and line. */
po_status po_reference_read(const char *path, const char *shown, po_reference *reference);
void po_reference_close(po_reference *reference);

/* Converts the columns and the headers whose names end in an SI unit, such as force_nN, radius_m or
 * load_uncertainty_nN, to the dimensionless ones without it. An uncertainty without a unit has that
 * of all such columns. Given: the units of the scene that is compared. Status: PO_CANNOT_READ with
 * file and line; PO_NO_MEMORY. */
po_status po_reference_use_units(po_reference *reference, const po_units *units);

/* Whether a table has such columns or headers. */
bool po_reference_has_units(const po_reference *reference);

/* Finds the first row from number *row on that belongs to a scene: all columns and headers that are
 * keys of the scene have its values. Returned: whether there is one; its number in *row. */
bool po_reference_next_row(const po_reference *reference, const po_request *request, size_t *row);

/* Says which row is nearest to a scene that the table does not contain, and by what they differ:
 * "nearest is line 7: tabor 0.5 instead of 0.51". Returned: false for a table without rows. */
bool po_reference_nearest(const po_reference *reference, const po_request *request, po_text *words);

/* Reads a number of a row with its uncertainty. The uncertainty is in the column NAME_uncertainty,
 * else in the column or the header `uncertainty`. Status: PO_CANNOT_READ (the column is missing or
 * does not hold a number). */
po_status po_reference_cell(const po_reference *reference, size_t row, const char *name,
                            po_reference_number *number);

#endif
