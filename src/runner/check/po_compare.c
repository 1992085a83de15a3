#include "po_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_curve.h"
#include "po_elementary.h"
#include "po_memory.h"
#include "po_result_rows.h"
#include "po_text.h"

static const po_reference_number UNKNOWN = {(double)NAN, (double)NAN};

/* Reports whether a quantity is a single number in the reference. The number of folds is that of
 * the listed folds over the common range. */
static bool is_single(po_quantity quantity) {
  return *PO_QUANTITIES[quantity].path && quantity != PO_FOLD_COUNT;
}

double po_compare_obtained(po_quantity quantity, const po_result *result) {
  if (result->status != PO_OK || !result->has_pull_off)
    return (double)NAN;
  return po_block_number(&PO_ALL_ROWS, result, PO_QUANTITIES[quantity].path);
}

double po_compare_stated_error(po_quantity quantity, const po_result *result) {
  static const char OF_PULL_OFF[] = "pull_off.";
  const char *path = PO_QUANTITIES[quantity].path;
  if (!path || strncmp(path, OF_PULL_OFF, strlen(OF_PULL_OFF)) != 0)
    return NAN;
  const po_row *row = po_block_find(&PO_PULL_OFF_ROWS, NULL, path + strlen(OF_PULL_OFF)).row;
  return row && row->error ? po_block_number(&PO_PULL_OFF_ROWS, result, row->error) : (double)NAN;
}

/* Notes the correct digits, the log relative error, of a number that a row of a table certifies to
 * a number of digits. */
static po_status note_digits(const po_compare_input *c, po_check_result *item) {
  const po_csv *table = &c->reference->table;
  const int column = po_csv_find_column(table, "digits");
  size_t row = 0;
  double certified = 0;
  if (column < 0 || !isfinite(item->error) ||
      !po_reference_next_row(c->reference, &c->request, &row))
    return PO_OK;
  const po_status status = po_csv_number(table, row, (size_t)column, &certified);
  const double error = fabs(item->error), correct = po_log10(fabs(item->expected) / error);
  if (!status)
    po_check_result_note(item, "%.1f of %g digits",
                         error <= item->uncertainty ? certified : fmin(certified, fmax(0, correct)),
                         certified);
  return status;
}

static po_status compare_single(const po_compare_input *c) {
  const po_quantity quantity = c->check->quantity;
  const po_result *result = c->result;
  po_reference_number expected = UNKNOWN;
  po_status status = PO_OK;
  if (c->reference->type == PO_REFERENCE_TRACED)
    expected = (po_reference_number){po_compare_obtained(quantity, c->trace),
                                     po_compare_stated_error(quantity, c->trace)};
  else
    status = po_reference_find(c->reference, quantity, &c->request, &expected);
  if (status && status != PO_NOT_FOUND)
    return status;
  po_check_result *item =
      po_compare_add(c, PO_QUANTITIES[quantity].name, "", po_compare_obtained(quantity, result),
                     status ? UNKNOWN : expected);
  if (!item)
    return PO_NO_MEMORY;
  if (result->has_pull_off) {
    item->approach = result->pull_off.approach;
    item->load = -result->pull_off.force;
  }
  return c->reference->row ? note_digits(c, item) : PO_OK;
}

static po_status compare_planes(const po_result *result, const po_special_point *theirs,
                                size_t count, bool ordered, double tolerance,
                                po_curve_verdict *verdict) {
  po_curve_point *points = po_allocate(count, sizeof *points);
  po_status status = points ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; points && i < count; ++i)
    points[i] = (po_curve_point){.approach = theirs[i].approach, .load = theirs[i].load};
  const po_plane_curve reference = {points, count, false};
  const po_plane_curve ours = {/* those of an external solver have no rates */
                               result->curve, result->curve_count,
                               result->curve_count && !isnan(result->curve->approach_rate)};
  if (!status)
    status = po_curve_compare(&ours, &reference, ordered, tolerance, verdict);
  free(points);
  return status;
}

static po_status compare_curve(const po_compare_input *c) {
  po_special_point *theirs = NULL;
  size_t count = 0;
  po_curve_verdict found = {0};
  po_status status =
      po_reference_points(c->reference, PO_CURVE, &c->request, c->result, &theirs, &count);
  const bool known = status == PO_OK;
  double uncertainty = (double)NAN;
  for (size_t i = 0; known && i < count; ++i)
    uncertainty = fmax(uncertainty, fmax(theirs[i].approach_error, theirs[i].load_error));
  if (known)
    /* published points are markers read off a figure, which are not in the order of the branch */
    status = compare_planes(c->result, theirs, count, c->reference->ledger != PO_LEDGER_PUBLISHED,
                            c->check->tolerance, &found);
  free(theirs);
  if (status && status != PO_NOT_FOUND)
    return status;
  const bool compared = known && found.compared > 0 && c->result->status == PO_OK;
  po_check_result *item =
      po_compare_add(c, "curve", "", compared ? found.distance : (double)NAN,
                     (po_reference_number){known ? 0 : (double)NAN, uncertainty});
  if (!item)
    return PO_NO_MEMORY;
  item->obtained = item->expected = (double)NAN;
  if (!compared)
    return PO_OK;
  item->approach = found.where.approach;
  item->load = found.where.load;
  if (!found.same_folds)
    item->verdict = PO_OUTSIDE;
  if (found.note[0])
    snprintf(item->note, sizeof item->note, "%s", found.note);
  else
    snprintf(item->note, sizeof item->note,
             "largest distance near approach %.4g, load %.4g; %zu %s compared, %zu beyond the "
             "ends",
             found.where.approach, found.where.load, found.compared,
             po_one_or_more(found.compared, "point", "points"), found.left_out);
  return PO_OK;
}

/* Writes the reason why the reverse trace has no result. */
static void explain_no_reverse_trace(po_check_result *item, const po_result *result) {
  const po_reverse_trace *w = &result->diagnostics.reverse_trace;
  const size_t size = sizeof item->note;
  if (!w->made)
    snprintf(item->note, size, "only elastic scenes on panels have a reverse trace");
  else if (w->status)
    snprintf(item->note, size, "on the reverse trace: %.170s", w->reason);
  else
    snprintf(item->note, size, "%zu %s on the trace, %zu on the reverse trace; extrema %zu and %zu",
             result->fold_count, po_one_or_more(result->fold_count, "fold", "folds"), w->folds,
             result->extremum_count, w->extrema);
}

/* Writes the reason into the note if nothing was compared, or if the scene was traced twice. */
static void explain_no_comparison(po_check_result *item, const po_compare_input *c) {
  const po_reference *reference = c->reference;
  const po_result *result = c->result;
  const size_t size = sizeof item->note;
  const bool traced = reference->type == PO_REFERENCE_TRACED;
  if (traced && c->trace->status)
    snprintf(item->note, size, "the trace failed: %.160s", c->trace->reason);
  else if (traced && !result->status)
    snprintf(item->note, size, "%s",
             result->followed ? "" : "not computed by continuation: the scene was traced");
  else if ((traced || item->verdict == PO_NO_RESULT) && result->status)
    snprintf(item->note, size, "%.190s", result->reason);
  else if (item->verdict == PO_NO_RESULT && strcmp(item->quantity, "reverse_trace") == 0)
    explain_no_reverse_trace(item, result);
  else if (item->verdict == PO_NO_RESULT)
    snprintf(item->note, size, "%s",
             c->check->quantity == PO_CURVE ? "result and reference have no common range"
             : c->check->quantity == PO_MOVED_FORCE && isnan(result->pull_off.force_error)
                 ? "only scenes on panels have the error estimates to which moved_force is relative"
                 : "the solve has no value of this quantity");
  else if (item->verdict == PO_MISSING_REFERENCE) {
    po_text nearest = {0};
    const bool found = reference->type == PO_REFERENCE_TABLE &&
                       po_reference_nearest(reference, &c->request, &nearest);
    snprintf(item->note, size, "the reference does not contain this scene%s%.150s",
             found ? "; " : "", po_text_string(&nearest));
    po_text_clear(&nearest);
  }
}

/* The folds or the extrema of a branch. */
typedef struct {
  const po_special_point *points;
  size_t count;
} point_list;

/* Those of a result and of the reference, over the common range. */
typedef struct {
  point_list ours, theirs;
  po_special_point *found; /* all of the reference, to be freed */
  bool known, solved;      /* the reference contains the scene; the scene was solved */
} point_lists;

/* Removes the special points before the start of the traced branch (NAN: the branch has no limited
 * start), which are those that the traced branch lacks. Only the first ones of the list are
 * removed: later on the branch the approach can again be smaller than at the start. */
static void drop_before_start(point_list *list, size_t traced, double start) {
  for (; list->count > traced && list->points->approach < start; list->count -= 1)
    list->points += 1;
}

/* Counts the special points up to the end of the shorter of two branches. On a wavy sphere the
 * number of folds is unlimited, and later folds may have a smaller approach than the end of the
 * shorter branch. If that branch ends while its approach increases, the next fold of the longer
 * branch is a jump_in at a larger approach than the end; this fold and all later ones have no
 * counterpart.
 * Given: `found`, the number of special points of the shorter branch, which all have a counterpart;
 * `end`, the approach of its end. */
static size_t count_up_to(const point_list *list, size_t found, double end) {
  for (size_t i = found; i < list->count; ++i)
    if (list->points[i].approach > end)
      return i;
  return list->count;
}

/* Finds both lists over the common range. */
static po_status find_lists(const po_compare_input *c, bool folds, point_lists *l) {
  const po_result *result = c->result;
  *l = (point_lists){.ours = folds ? (point_list){result->folds, result->fold_count}
                                   : (point_list){result->extrema, result->extremum_count},
                     .solved = result->status == PO_OK};
  po_status status = po_reference_points(c->reference, folds ? PO_FOLDS : PO_EXTREMA, &c->request,
                                         result, &l->found, &l->theirs.count);
  l->theirs.points = l->found;
  if (status == PO_NOT_FOUND)
    return PO_OK;
  double complete_to = (double)INFINITY;
  if (!status)
    status = po_reference_complete_to(c->reference, &c->request, &complete_to);
  if (status)
    return status;
  l->known = true;
  if (!l->solved)
    return PO_OK;
  drop_before_start(&l->theirs, l->ours.count, result->start);
  const size_t ours = l->ours.count, theirs = l->theirs.count;
  l->ours.count = count_up_to(&l->ours, theirs, complete_to);
  l->theirs.count = count_up_to(&l->theirs, ours, result->ended.approach);
  return PO_OK;
}

/* Reports whether the two lists have the same kinds of special points in the same order. */
static bool lists_correspond(const point_lists *l) {
  bool same = l->ours.count == l->theirs.count;
  for (size_t i = 0; same && i < l->ours.count; ++i)
    same = l->ours.points[i].kind == l->theirs.points[i].kind;
  return same;
}

/* Describes the difference of two lists: names the special point of the longer list that is
 * furthest from all points of its kind in the other list. */
static void describe_difference(const point_lists *l, char *note, size_t size) {
  const bool missing = l->theirs.count > l->ours.count;
  const point_list *more = missing ? &l->theirs : &l->ours,
                   *fewer = missing ? &l->ours : &l->theirs;
  double furthest = -1;
  const po_special_point *named = NULL;
  for (size_t i = 0; i < more->count; ++i) {
    const po_special_point *a = &more->points[i];
    double nearest = (double)INFINITY;
    for (size_t j = 0; j < fewer->count; ++j) {
      const po_special_point *b = &fewer->points[j];
      if (a->kind == b->kind)
        nearest = fmin(nearest, po_hypot(a->approach - b->approach, a->load - b->load));
    }
    if (nearest > furthest) {
      furthest = nearest;
      named = a;
    }
  }
  if (named)
    snprintf(note, size, "%s %s near approach %.4g, load %.4g (%zu found, reference %zu)",
             missing ? "missing" : "spurious", PO_SPECIAL_KINDS[named->kind], named->approach,
             named->load, l->ours.count, l->theirs.count);
}

static po_status add_pairs(const po_compare_input *c, const point_lists *l) {
  static const char *const NAMES[2][2] = {{"extremum_approach", "extremum_load"},
                                          {"fold_approach", "fold_load"}};
  for (size_t i = 0; i < l->ours.count; ++i)
    for (int load = 0; load < 2; ++load) {
      const po_special_point *ours = &l->ours.points[i], *theirs = &l->theirs.points[i];
      char suffix[64];
      snprintf(suffix, sizeof suffix, "%s-%zu/%s", PO_SPECIAL_KINDS[ours->kind], i + 1,
               load ? "load" : "approach");
      const po_reference_number expected =
          load ? (po_reference_number){theirs->load, theirs->load_error}
               : (po_reference_number){theirs->approach, theirs->approach_error};
      po_check_result *item = po_compare_add(c, NAMES[c->check->quantity == PO_FOLDS][load], suffix,
                                             load ? ours->load : ours->approach, expected);
      if (!item)
        return PO_NO_MEMORY;
      item->approach = ours->approach;
      item->load = ours->load;
    }
  return PO_OK;
}

/* Compares folds or extrema: their number and kinds, and, if these agree, approach and load of
 * each. Status: as po_compare. */
static po_status compare_special_points(const po_compare_input *c) {
  const bool count_only = c->check->quantity == PO_FOLD_COUNT;
  const bool folds = c->check->quantity != PO_EXTREMA;
  point_lists l;
  po_status status = find_lists(c, folds, &l);
  if (!status) {
    const po_reference_number expected = {l.known ? (double)l.theirs.count : (double)NAN, 0};
    po_check_result *item =
        po_compare_add(c, folds ? "fold_count" : "extremum_count", count_only ? "" : "count",
                       l.solved ? (double)l.ours.count : (double)NAN, expected);
    if (!item)
      status = PO_NO_MEMORY;
    else if (!l.known || !l.solved || (count_only && l.ours.count == l.theirs.count))
      status = PO_OK;
    else if (!lists_correspond(&l)) {
      if (!count_only)
        item->verdict = PO_OUTSIDE;
      describe_difference(&l, item->note, sizeof item->note);
    } else
      status = add_pairs(c, &l);
  }
  free(l.found);
  return status;
}

po_status po_compare(const po_compare_input *comparison) {
  po_compare_input c = *comparison;
  const po_check *check = c.check;
  const po_request *request = &c.kase->points[c.point].request;
  if (c.reference->type == PO_REFERENCE_ABSENT || !po_check_concerns(check, request))
    return PO_OK;
  const size_t before = c.check_results->count;
  c.request = po_check_request(check, request);
  const po_status status = is_single(check->quantity)              ? compare_single(&c)
                           : check->quantity == PO_CURVE           ? compare_curve(&c)
                           : po_quantity_is_steps(check->quantity) ? po_compare_steps(&c)
                                                                   : compare_special_points(&c);
  for (size_t i = before; i < c.check_results->count; ++i)
    explain_no_comparison(&c.check_results->items[i], &c);
  return status;
}
