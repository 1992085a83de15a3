/* The parts of po_compare, one for each type of quantity. */
#ifndef PO_COMPARE_PARTS_H
#define PO_COMPARE_PARTS_H

#include "po_check_result.h"

/* Returned: the value of a quantity that is a single number; NAN if the solve did not deliver it.
 */
double po_compare_obtained(po_quantity quantity, const po_result *result);

/* For tables with several rows for a scene.
 * Returned: the row of item number `index` of a scene, or the number of rows of the table if there
 * is none; the number of items. */
size_t po_compare_row(const po_reference *reference, const po_request *request, size_t index);
size_t po_compare_row_count(const po_reference *reference, const po_request *request);

/* A number in such a row: its column, and its quantity in the results. */
typedef struct {
  const char *column, *name;
} po_compare_column;

/* The check and the point that are compared, and the list to which the results are added. */
typedef struct {
  const po_case *kase;
  size_t point;
  const po_check *check;
  const po_reference *reference;
  po_check_results *check_results;
} po_compare_target;

/* Adds a result for each of `count` numbers of a row.
 * Given: `subject`, the name of the item ("loading-1"); `where`, its place on the curve.
 * Status: PO_CANNOT_READ (a column is missing or does not hold a number), PO_NO_MEMORY. */
po_status po_compare_row_add(const po_compare_target *target, size_t row, const char *subject,
                             const po_compare_column *columns, const double *obtained, size_t count,
                             po_path_state where);

/* Returned: in *most, the number with the largest uncertainty in some columns of all rows of a
 * scene. Status: as above. */
po_status po_compare_rows_uncertainty(const po_reference *reference, const po_request *request,
                                      const po_compare_column *columns, size_t count,
                                      po_reference_number *most);

/* Compares the jumps of loading and unloading at given approach: their number, and, if it agrees,
 * the approach, the load before and after, and the energy lost of each. Status: as po_compare. */
po_status po_compare_jumps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

/* Returned: in *most, the number with the largest uncertainty among the jumps of a scene. */
po_status po_compare_jumps_uncertainty(const po_reference *reference, const po_request *request,
                                       po_reference_number *most);

/* Compares the steps of the staircase at given approach or at given load, over the range of preload
 * that result and table share: their number, and, if it agrees, the preload at which each step
 * begins, force and approach of its pull-off, and (at given approach) the energy lost. Status: as
 * po_compare. */
po_status po_compare_steps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

/* Returned: in *most, the number with the largest uncertainty among the steps of a scene. */
po_status po_compare_steps_uncertainty(po_quantity quantity, const po_reference *reference,
                                       const po_request *request, po_reference_number *most);

#endif
