#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare.h"

/* A number in a row of a table: its column, and its quantity in the results. */
typedef struct {
  const char *column, *name;
} number_column;

static const number_column NUMBERS[] = {{"from_approach", "step_preload"},
                                        {"from_load", "step_preload_load"},
                                        {"force", "step_force"},
                                        {"approach", "step_approach"},
                                        {"energy_lost", "step_energy_lost"}};

enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

static const number_column JUMP_NUMBERS[] = {{"approach", "jump_approach"},
                                             {"load_before", "jump_load_before"},
                                             {"load_after", "jump_load_after"},
                                             {"energy_lost", "jump_energy_lost"}};

enum { NUMBERS_OF_JUMP = sizeof JUMP_NUMBERS / sizeof *JUMP_NUMBERS };

/* Under load control the first step begins with separated bodies, at no finite approach, and the
 * energy lost is infinite. So the first and the last number are not compared. Neither is the energy
 * lost, the last number, if the table does not have it. */
static size_t first_compared(po_quantity quantity) {
  return quantity == PO_LOAD_STEPS;
}

/* Returned: the compared numbers of a jump or a step, *count of them. */
static const number_column *compared_numbers(po_quantity quantity, const po_reference *reference,
                                             size_t *count) {
  *count = NUMBERS_OF_JUMP;
  if (quantity == PO_JUMPS)
    return JUMP_NUMBERS;
  const bool energies =
      po_csv_find_column(&reference->table, NUMBERS[NUMBER_COUNT - 1].column) >= 0;
  *count = NUMBER_COUNT - (quantity == PO_STEPS ? !energies : 2);
  return NUMBERS + first_compared(quantity);
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
static size_t row_of(const po_compare_input *c, size_t index) {
  size_t row = 0;
  while (po_reference_next_row(c->reference, &c->request, &row) && index-- > 0)
    ++row;
  return row;
}

/* Returned: the loading and unloading, or the staircase, that the check refers to. */
static const po_loop *loop_of(const po_compare_input *c) {
  return &c->result->hysteresis.of[PO_AT_APPROACH];
}

static const po_staircase *staircase_of(const po_compare_input *c) {
  return &c->result->staircase.of[c->check->quantity == PO_LOAD_STEPS];
}

/* Adds a result for each compared number of a row.
 * Given: `subject`, the name of the item ("loading-1"); `where`, its place on the curve.
 * Status: PO_CANNOT_READ (a column is missing or does not hold a number), PO_NO_MEMORY. */
static po_status add_row(const po_compare_input *c, size_t row, const char *subject,
                         const double *obtained, po_path_state where) {
  size_t count = 0;
  const number_column *columns = compared_numbers(c->check->quantity, c->reference, &count);
  for (size_t n = 0; n < count; ++n) {
    char suffix[64];
    po_reference_number expected = {0};
    snprintf(suffix, sizeof suffix, "%s/%s", subject, columns[n].column);
    const po_status status = po_reference_cell(c->reference, row, columns[n].column, &expected);
    if (status)
      return status;
    po_check_result *item = po_compare_add(c, columns[n].name, suffix, obtained[n], expected);
    if (!item)
      return PO_NO_MEMORY;
    item->approach = where.approach;
    item->load = where.load;
  }
  return PO_OK;
}

/* A relative tolerance of a value that is 0, or 0 within its uncertainty, allows nothing that can
 * be said in numbers. */
static bool is_relative_to_zero(const po_check *check, po_reference_number expected) {
  return check->kind != PO_TOLERANCE_ABS &&
         (expected.value == 0 || fabs(expected.value) <= expected.uncertainty);
}

static bool too_tight(const po_check *check, po_reference_number expected) {
  return is_relative_to_zero(check, expected) ||
         (!isnan(expected.uncertainty) &&
          po_check_allowance(check, expected.value) < expected.uncertainty);
}

/* Returned: in *most, the number for which a tolerance is the least against its uncertainty, among
 * the jumps or the steps of a scene. Status: as above. */
static po_status tightest_number(const po_check *check, const po_reference *reference,
                                 const po_request *request, po_reference_number *most) {
  size_t count = 0;
  double ratio = 0;
  const number_column *columns = compared_numbers(check->quantity, reference, &count);
  *most = (po_reference_number){(double)NAN, 0};
  for (size_t row = 0; po_reference_next_row(reference, request, &row); ++row)
    for (size_t n = 0; n < count; ++n) {
      po_reference_number number = {0};
      const po_status status = po_reference_cell(reference, row, columns[n].column, &number);
      if (status)
        return status;
      const double own = is_relative_to_zero(check, number)
                             ? (double)INFINITY
                             : number.uncertainty / po_check_allowance(check, number.value);
      if (own > ratio) {
        ratio = own;
        *most = number;
      }
    }
  return PO_OK;
}

/* Counts the steps of a result up to where the table lists all, and the rows whose steps begin
 * within the range of loading. */
static po_status count_steps(const po_compare_input *c, size_t *ours, size_t *theirs) {
  const po_quantity quantity = c->check->quantity;
  const po_staircase *steps = staircase_of(c);
  const double loaded = driven(quantity, &steps->reached);
  double reach; /* the approach or the load up to which the table lists all steps */
  po_status status = po_reference_complete_to(c->reference, &c->request, &reach);
  while (*ours < steps->count && !(driven(quantity, &steps->step[*ours].preload) > reach))
    *ours += 1;
  for (size_t row = 0; !status && po_reference_next_row(c->reference, &c->request, &row); ++row) {
    po_reference_number from = {0};
    status = po_reference_cell(c->reference, row, driven_column(quantity), &from);
    *theirs += from.value <= loaded;
  }
  return status;
}

static po_status add_step(const po_compare_input *c, size_t index) {
  const po_step *step = &staircase_of(c)->step[index];
  const double obtained[NUMBER_COUNT] = {step->preload.approach, step->preload.load,
                                         -step->pull_off.load, step->pull_off.approach,
                                         step->cycle[0].loss.energy};
  char subject[48];
  snprintf(subject, sizeof subject, "step-%zu", index + 1);
  return add_row(c, row_of(c, index), subject, obtained + first_compared(c->check->quantity),
                 step->pull_off);
}

static const char *phase_of(const po_jump *jump) {
  return jump->loading ? "loading" : "unloading";
}

static bool phases_agree(const po_compare_input *c, const po_loop *loop, size_t column) {
  for (size_t k = 0; k < loop->jump_count; ++k)
    if (strcmp(po_csv_cell(&c->reference->table, row_of(c, k), column),
               phase_of(&loop->jumps[k])) != 0)
      return false;
  return true;
}

static po_status add_jump(const po_compare_input *c, size_t index) {
  const po_loop *loop = loop_of(c);
  const po_jump *jump = &loop->jumps[index];
  const double obtained[NUMBERS_OF_JUMP] = {jump->before.approach, jump->before.load,
                                            jump->after.load, jump->energy_lost};
  char subject[48];
  snprintf(subject, sizeof subject, "%s-%zu", phase_of(jump),
           jump->loading ? index + 1 : index + 1 - loop->loading_jumps);
  return add_row(c, row_of(c, index), subject, obtained, jump->before);
}

po_status po_compare_steps(const po_compare_input *c) {
  const bool jumps = c->check->quantity == PO_JUMPS;
  const po_csv *table = &c->reference->table;
  const po_loop *loop = loop_of(c);
  const bool solved =
      c->result->status == PO_OK && (jumps ? c->result->has_hysteresis : c->result->has_staircases);
  const int phase = po_csv_find_column(table, "phase");
  size_t rows = 0, ours = jumps ? loop->jump_count : 0, theirs = 0;
  po_status status = PO_OK;
  for (size_t row = 0; po_reference_next_row(c->reference, &c->request, &row); ++row)
    rows += 1;
  if (jumps && phase < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column phase is missing", table->path,
                   table->column_line);
  if (jumps)
    theirs = rows;
  else if (solved)
    status = count_steps(c, &ours, &theirs);
  if (status)
    return status;
  po_check_result *item = po_compare_add(
      c, jumps ? "jump_count" : "step_count", "count", solved ? (double)ours : (double)NAN,
      (po_reference_number){rows ? (double)theirs : (double)NAN, 0});
  if (!item)
    return PO_NO_MEMORY;
  if (!solved || !rows)
    return PO_OK;
  if (ours != theirs || (jumps && !phases_agree(c, loop, (size_t)phase))) {
    item->verdict = PO_OUTSIDE;
    if (jumps)
      snprintf(item->note, sizeof item->note, "jumps in loading: %zu, in unloading: %zu",
               loop->loading_jumps, loop->jump_count - loop->loading_jumps);
    return PO_OK;
  }
  for (size_t k = 0; k < ours && !status; ++k)
    status = jumps ? add_jump(c, k) : add_step(c, k);
  return status;
}

/* A tolerance in other units than the uncertainty is stated with what it allows. */
static po_status refuse_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                  const po_reference *reference, po_reference_number expected) {
  char text[PO_NUMBER_LENGTH], allows[64] = "", value[PO_NUMBER_LENGTH], of_value[64] = "";
  po_number_print(expected.uncertainty, text);
  po_number_print(expected.value, value);
  if (expected.uncertainty > 0)
    snprintf(of_value, sizeof of_value, " with an uncertainty of %s", text);
  if (is_relative_to_zero(check, expected))
    return po_fail(PO_BAD_INPUT,
                   "%s:%zu: checks[%u].kind is %s, but %s has the value %s%s, to which no "
                   "tolerance can be relative: expected kind: abs, with a tolerance in the unit of "
                   "%s",
                   kase->shown, check->tolerance_line, number, check->kind_text, reference->name,
                   value, of_value, check->quantity_text);
  if (check->kind != PO_TOLERANCE_ABS)
    snprintf(allows, sizeof allows, " %.3s, which allows %.15g", check->kind_text,
             po_check_allowance(check, expected.value));
  return po_fail(
      PO_BAD_INPUT,
      "%s:%zu: checks[%u].tolerance is %s%s: expected at least %s, the uncertainty of %s",
      kase->shown, check->tolerance_line, number, check->tolerance_text, allows, text,
      reference->name);
}

static po_status check_points(const po_case *kase, const po_check *check, unsigned number,
                              const po_reference *reference, const po_request *request) {
  /* The range of the trace is not known yet; this one extends from large separation to contact. */
  po_curve_point ends[] = {{.approach = -10}, {.approach = 0.2}};
  const po_result everywhere = {
      .start = -10, .ended.approach = 0.2, .curve = ends, .curve_count = 2};
  po_special_point *points = NULL;
  size_t count = 0;
  po_status status =
      po_reference_points(reference, check->quantity, request, &everywhere, &points, &count);
  for (size_t i = 0; !status && i < count; ++i) {
    const po_reference_number approach = {points[i].approach, points[i].approach_error},
                              load = {points[i].load, points[i].load_error};
    if (too_tight(check, approach) || too_tight(check, load))
      status = refuse_tolerance(kase, check, number, reference,
                                too_tight(check, approach) ? approach : load);
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
    const po_request asked = po_check_request(check, &kase->points[i].request), *request = &asked;
    if (check->quantity == PO_FOLD_COUNT || !po_check_concerns(check, &kase->points[i].request))
      continue; /* a number of folds has no uncertainty */
    po_status status = PO_OK;
    if (check->quantity == PO_FOLDS || check->quantity == PO_EXTREMA || check->quantity == PO_CURVE)
      status = check_points(kase, check, number, reference, request);
    else {
      po_reference_number expected = {0};
      status = po_quantity_is_steps(check->quantity)
                   ? tightest_number(check, reference, request, &expected)
                   : po_reference_find(reference, check->quantity, request, &expected);
      if (!status && too_tight(check, expected))
        status = refuse_tolerance(kase, check, number, reference, expected);
    }
    if (status && status != PO_NOT_FOUND)
      return status;
  }
  return PO_OK;
}
