/* The parts of po_compare, one a sort of quantity. */
#ifndef PO_COMPARE_PARTS_H
#define PO_COMPARE_PARTS_H

#include "po_compare.h"

/* The pull-off or the number of folds that a solve delivered; NAN when it did not. */
double po_compare_obtained(po_quantity quantity, const po_result *result);

/* Folds or extrema: their number and kinds, then approach and load of each. */
po_status po_compare_special_points(const po_case *kase, size_t point, const po_check *check,
                                    const po_reference *reference, const po_result *result,
                                    po_check_results *check_results);

/* Tables that list several things of a scene, a row each: the row of number `index` of a scene (the
 * number of rows: none), how many there are. */
size_t po_compare_row(const po_reference *reference, const po_request *request, size_t index);
size_t po_compare_row_count(const po_reference *reference, const po_request *request);

/* A number of such a row: its column, and its quantity in the results. */
typedef struct {
  const char *column, *name;
} po_compare_column;

/* What is compared, and where the results go. */
typedef struct {
  const po_case *kase;
  size_t point;
  const po_check *check;
  const po_reference *reference;
  po_check_results *check_results;
} po_compare_target;

/* Adds a result for each of `count` numbers of a row; `subject` is what the row is about
 * ("loading-1"), `where` its place on the curve. Status: PO_CANNOT_READ (a column is missing or
 * holds no number), PO_NO_MEMORY. */
po_status po_compare_row_add(const po_compare_target *target, size_t row, const char *subject,
                             const po_compare_column *columns, const double *obtained, size_t count,
                             po_path_state where);

/* The most uncertain of the numbers in some columns of all rows of a scene. Status: as above. */
po_status po_compare_rows_doubt(const po_reference *reference, const po_request *request,
                                const po_compare_column *columns, size_t count,
                                po_reference_number *most);

/* The jumps of loading and unloading at given approach: their number, then of each the approach,
 * the load before and after, and the energy lost. */
po_status po_compare_jumps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

/* Of all numbers a table has of the jumps of a scene, the most uncertain. */
po_status po_compare_jumps_doubt(const po_reference *reference, const po_request *request,
                                 po_reference_number *most);

/* The steps of the staircase at given approach, or at given load: their number, as far as both list
 * them, then of each the preload from which it holds, force and approach of the pull-off, and (at
 * given approach) the energy lost. */
po_status po_compare_steps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results);

/* Of all numbers a table has of the steps of a scene, the most uncertain. */
po_status po_compare_steps_doubt(po_quantity quantity, const po_reference *reference,
                                 const po_request *request, po_reference_number *most);

/* The counters of work, each beside its pin. */
po_status po_compare_work(const po_case *kase, size_t point, const po_check *check,
                          const po_reference *reference, const po_result *result,
                          po_check_results *check_results);

#endif
