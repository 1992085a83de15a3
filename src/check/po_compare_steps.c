#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare.h"
#include "po_compare_parts.h"

/* A number in a row of a table: its column, and its quantity in the results. */
typedef struct {
  const char *column, *name;
} number_column;

/* The check and the point that are compared, and the list to which the results are added. */
typedef struct {
  const po_case *kase;
  size_t point;
  const po_check *check;
  const po_reference *reference;
  po_check_results *check_results;
} compare_target;

static const number_column NUMBERS[] = {{"from_approach", "step_preload"},
                                        {"from_load", "step_preload_load"},
                                        {"force", "step_force"},
                                        {"approach", "step_approach"},
                                        {"energy_lost", "step_energy_lost"}};

enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

/* Under load control the first step begins with separated bodies, at no finite approach, and the
 * energy lost is infinite. So the first and the last number are not compared. Neither is the energy
 * lost, the last number, if the table does not have it. */
static size_t first_compared(po_quantity quantity) {
  return quantity == PO_STEPS ? 0 : 1;
}

static size_t count_compared(po_quantity quantity, const po_reference *reference) {
  const bool energies =
      po_csv_find_column(&reference->table, NUMBERS[NUMBER_COUNT - 1].column) >= 0;
  return NUMBER_COUNT - (quantity == PO_STEPS ? !energies : 2);
}

/* Returned: the controlled quantity, approach or load; the column of its value at the begin of a
 * step. */
static double driven(po_quantity quantity, const po_path_state *state) {
  return quantity == PO_STEPS ? state->approach : state->load;
}

static const char *driven_column(po_quantity quantity) {
  return quantity == PO_STEPS ? "from_approach" : "from_load";
}

/* The row of item number `index` of a scene in a table that may have several; the number of rows of
 * the table if there is none. */
static size_t row_of(const po_reference *reference, const po_request *request, size_t index) {
  size_t row = 0;
  for (; row < reference->table.row_count; ++row)
    if (po_reference_row_is_of(reference, row, request) && index-- == 0)
      break;
  return row;
}

/* The number of items of a scene. */
static size_t row_count_of(const po_reference *reference, const po_request *request) {
  size_t count = 0;
  for (size_t row = 0; row < reference->table.row_count; ++row)
    count += po_reference_row_is_of(reference, row, request);
  return count;
}

/* Adds a result for each of `count` numbers of a row.
 * Given: `subject`, the name of the item ("loading-1"); `where`, its place on the curve.
 * Status: PO_CANNOT_READ (a column is missing or does not hold a number), PO_NO_MEMORY. */
static po_status add_row(const compare_target *target, size_t row, const char *subject,
                         const number_column *columns, const double *obtained, size_t count,
                         po_path_state where) {
  for (size_t n = 0; n < count; ++n) {
    char suffix[64];
    po_reference_number expected = {0};
    snprintf(suffix, sizeof suffix, "%s/%s", subject, columns[n].column);
    const po_status status =
        po_reference_cell(target->reference, row, columns[n].column, &expected);
    if (status)
      return status;
    po_check_result *item =
        po_check_results_add(target->check_results, target->kase, target->point, target->check,
                             columns[n].name, suffix, obtained[n], expected);
    if (!item)
      return PO_NO_MEMORY;
    item->approach = where.approach;
    item->load = where.load;
  }
  return PO_OK;
}

/* Returned: in *most, the number with the largest uncertainty in some columns of all rows of a
 * scene. Status: as above. */
static po_status rows_uncertainty(const po_reference *reference, const po_request *request,
                                  const number_column *columns, size_t count,
                                  po_reference_number *most) {
  po_status status = PO_OK;
  *most = (po_reference_number){(double)NAN, 0};
  for (size_t row = 0; row < reference->table.row_count; ++row)
    for (size_t n = 0; n < count && !status; ++n) {
      po_reference_number number = {0};
      if (po_reference_row_is_of(reference, row, request))
        status = po_reference_cell(reference, row, columns[n].column, &number);
      if (number.uncertainty > most->uncertainty)
        *most = number;
    }
  return status;
}

/* Returned: the greatest approach (or load) up to which the table lists all steps of a scene; NAN:
 * the table has no column complete_to, or no row for the scene. */
static double table_reach(const po_reference *reference, const po_request *request) {
  const size_t row = row_of(reference, request, 0);
  po_reference_number number = {(double)NAN, 0};
  if (row < reference->table.row_count && po_csv_find_column(&reference->table, "complete_to") >= 0)
    (void)po_reference_cell(reference, row, "complete_to", &number);
  return number.value;
}

static size_t count_ours(po_quantity quantity, const po_staircase *ours, double reach) {
  size_t count = 0;
  while (count < ours->count && !(driven(quantity, &ours->step[count].preload) > reach))
    ++count;
  return count;
}

/* Counts the rows whose steps begin within the range of loading, up to `reach`. */
static size_t count_theirs(po_quantity quantity, const po_reference *reference,
                           const po_request *request, double reach, po_status *status) {
  const size_t all = row_count_of(reference, request);
  size_t count = 0;
  for (size_t k = 0; k < all && !*status; ++k) {
    po_reference_number from = {0};
    *status =
        po_reference_cell(reference, row_of(reference, request, k), driven_column(quantity), &from);
    count += from.value <= reach;
  }
  return count;
}

static po_status add_step(const compare_target *target, size_t row, const po_step *step,
                          size_t index) {
  const po_quantity quantity = target->check->quantity;
  const size_t first = first_compared(quantity);
  const double obtained[NUMBER_COUNT] = {step->preload.approach, step->preload.load,
                                         -step->pull_off.load, step->pull_off.approach,
                                         step->cycle[0].loss.energy};
  char subject[48];
  snprintf(subject, sizeof subject, "step-%zu", index + 1);
  return add_row(target, row, subject, NUMBERS + first, obtained + first,
                 count_compared(quantity, target->reference), step->pull_off);
}

po_status po_compare_steps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results) {
  const po_request request = po_check_request(check, &kase->points[point].request);
  const po_staircase *ours = &result->staircase.of[check->quantity == PO_LOAD_STEPS];
  const bool solved = result->status == PO_OK && result->has_staircases;
  const bool known = row_count_of(reference, &request) > 0;
  po_status status = PO_OK;
  const size_t theirs = solved ? count_theirs(check->quantity, reference, &request,
                                              driven(check->quantity, &ours->reached), &status)
                               : 0;
  const size_t count =
      solved ? count_ours(check->quantity, ours, table_reach(reference, &request)) : 0;
  if (status)
    return status;
  const po_reference_number expected = {known ? (double)theirs : (double)NAN, 0};
  po_check_result *item =
      po_check_results_add(check_results, kase, point, check, "step_count", "count",
                           solved ? (double)count : (double)NAN, expected);
  if (!item)
    return PO_NO_MEMORY;
  if (!solved || !known)
    return PO_OK;
  if (count != theirs) {
    item->verdict = PO_OUTSIDE;
    return PO_OK;
  }
  const compare_target target = {kase, point, check, reference, check_results};
  for (size_t k = 0; k < count && !status; ++k)
    status = add_step(&target, row_of(reference, &request, k), &ours->step[k], k);
  return status;
}

/* Returned: in *most, the number with the largest uncertainty among the steps of a scene. */
static po_status uncertainty_of_steps(po_quantity quantity, const po_reference *reference,
                                      const po_request *request, po_reference_number *most) {
  return rows_uncertainty(reference, request, NUMBERS + first_compared(quantity),
                          count_compared(quantity, reference), most);
}

static const number_column JUMP_NUMBERS[] = {{"approach", "jump_approach"},
                                             {"load_before", "jump_load_before"},
                                             {"load_after", "jump_load_after"},
                                             {"energy_lost", "jump_energy_lost"}};

enum { NUMBERS_OF_JUMP = sizeof JUMP_NUMBERS / sizeof *JUMP_NUMBERS };

static const char *phase_of(const po_jump *jump) {
  return jump->loading ? "loading" : "unloading";
}

static bool phases_agree(const po_reference *reference, const po_request *request,
                         const po_loop *loop, size_t column) {
  for (size_t k = 0; k < loop->jump_count; ++k)
    if (strcmp(po_csv_cell(&reference->table, row_of(reference, request, k), column),
               phase_of(&loop->jumps[k])) != 0)
      return false;
  return true;
}

static po_status add_jump(const compare_target *target, size_t row, const po_loop *loop,
                          size_t index) {
  const po_jump *jump = &loop->jumps[index];
  const double obtained[NUMBERS_OF_JUMP] = {jump->before.approach, jump->before.load,
                                            jump->after.load, jump->energy_lost};
  char subject[48];
  snprintf(subject, sizeof subject, "%s-%zu", phase_of(jump),
           jump->loading ? index + 1 : index + 1 - loop->loading_jumps);
  return add_row(target, row, subject, JUMP_NUMBERS, obtained, NUMBERS_OF_JUMP, jump->before);
}

po_status po_compare_jumps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results) {
  const po_request request = po_check_request(check, &kase->points[point].request);
  const po_loop *loop = &result->hysteresis.displacement;
  const bool solved = result->status == PO_OK && result->has_hysteresis;
  const size_t rows = row_count_of(reference, &request);
  const int column = po_csv_find_column(&reference->table, "phase");
  if (column < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column phase is missing", reference->table.path,
                   reference->table.column_line);
  const po_reference_number expected = {rows ? (double)rows : (double)NAN, 0};
  po_check_result *item =
      po_check_results_add(check_results, kase, point, check, "jump_count", "count",
                           solved ? (double)loop->jump_count : (double)NAN, expected);
  if (!item)
    return PO_NO_MEMORY;
  if (!solved || !rows)
    return PO_OK;
  if (loop->jump_count != rows || !phases_agree(reference, &request, loop, (size_t)column)) {
    item->verdict = PO_OUTSIDE;
    snprintf(item->note, sizeof item->note, "jumps in loading: %zu, in unloading: %zu",
             loop->loading_jumps, loop->jump_count - loop->loading_jumps);
    return PO_OK;
  }
  const compare_target target = {kase, point, check, reference, check_results};
  po_status status = PO_OK;
  for (size_t k = 0; k < rows && !status; ++k)
    status = add_jump(&target, row_of(reference, &request, k), loop, k);
  return status;
}

/* Returned: in *most, the number with the largest uncertainty among the jumps of a scene. */
static po_status uncertainty_of_jumps(const po_reference *reference, const po_request *request,
                                      po_reference_number *most) {
  return rows_uncertainty(reference, request, JUMP_NUMBERS, NUMBERS_OF_JUMP, most);
}

static po_status refuse(const po_case *kase, const po_check *check, unsigned number,
                        const po_reference *reference, double uncertainty) {
  char text[PO_NUMBER_LENGTH];
  po_number_print(uncertainty, text);
  return po_fail(PO_BAD_INPUT,
                 "%s:%zu: checks[%u].tolerance is %s: expected at least %s, the uncertainty of %s",
                 kase->shown, check->tolerance_line, number, check->tolerance_text, text,
                 reference->name);
}

static bool too_tight(const po_check *check, double expected, double uncertainty) {
  return !isnan(uncertainty) && po_check_allowance(check, expected) < uncertainty;
}

static po_status check_points(const po_case *kase, const po_check *check, unsigned number,
                              const po_reference *reference, const po_request *request) {
  /* The range of the trace is not known yet; this one extends from large separation to contact. */
  po_curve_point ends[] = {{.approach = -10}, {.approach = 0.2}};
  const po_result everywhere = {
      .start = -10, .ended.approach = 0.2, .curve = ends, .curve_count = 2};
  po_reference_point *points = NULL;
  size_t count = 0;
  po_status status =
      po_reference_points(reference, check->quantity, request, &everywhere, &points, &count);
  for (size_t i = 0; !status && i < count; ++i) {
    if (too_tight(check, points[i].approach, points[i].approach_uncertainty))
      status = refuse(kase, check, number, reference, points[i].approach_uncertainty);
    else if (too_tight(check, points[i].load, points[i].load_uncertainty))
      status = refuse(kase, check, number, reference, points[i].load_uncertainty);
  }
  free(points);
  return status;
}

po_status po_compare_check_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                     const po_reference *reference) {
  if (check->quantity == PO_SOLVED_SHARE ||
      reference->type == PO_REFERENCE_TRACED) /* has no value before the run */
    return PO_OK;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_request asked = po_check_request(check, &kase->points[i].request);
    const po_request *request = &asked;
    if (check->quantity == PO_FOLD_COUNT || !po_check_concerns(check, &kase->points[i].request))
      continue; /* a number of folds has no uncertainty */
    po_status status = PO_OK;
    if (check->quantity == PO_FOLDS || check->quantity == PO_EXTREMA || check->quantity == PO_CURVE)
      status = check_points(kase, check, number, reference, request);
    else {
      po_reference_number expected = {0};
      status = po_quantity_is_steps(check->quantity)
                   ? uncertainty_of_steps(check->quantity, reference, request, &expected)
               : check->quantity == PO_JUMPS
                   ? uncertainty_of_jumps(reference, request, &expected)
                   : po_reference_find(reference, check->quantity, request, &expected);
      if (!status && too_tight(check, expected.value, expected.uncertainty))
        status = refuse(kase, check, number, reference, expected.uncertainty);
    }
    if (status && status != PO_NOT_FOUND)
      return status;
  }
  return PO_OK;
}
