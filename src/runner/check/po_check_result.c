#include "po_compare.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_text.h"

const char *const PO_VERDICTS[PO_VERDICT_COUNT] = {
    [PO_WITHIN] = "within",       [PO_OUTSIDE] = "outside",
    [PO_NO_RESULT] = "no_result", [PO_MISSING_REFERENCE] = "missing_reference",
    [PO_SLACK] = "slack",         [PO_NOT_REACHABLE] = "not_reachable",
};

bool po_verdict_passes(po_verdict verdict) {
  return verdict == PO_WITHIN || verdict == PO_SLACK || verdict == PO_NOT_REACHABLE;
}

void po_check_result_reference(const po_check *check, char name[64]) {
  const char *slash = strrchr(check->reference, '/');
  const char *base = slash ? slash + 1 : check->reference;
  const char *dot = strrchr(base, '.'), *row = strchr(base, '#');
  if (row) /* that of a table */
    snprintf(name, 64, "%s", row + 1);
  else
    snprintf(name, 64, "%.*s", (int)(dot ? (size_t)(dot - base) : strlen(base)), base);
}

/* Reports whether two checks have the same quantity and references of the same short name. */
static bool have_same_names(const po_check *a, const po_check *b) {
  char of_a[64], of_b[64];
  po_check_result_reference(a, of_a);
  po_check_result_reference(b, of_b);
  return strcmp(a->quantity_text, b->quantity_text) == 0 && strcmp(of_a, of_b) == 0;
}

/* Returned: the number of a check in its case, from 1, if an earlier check has the same names at
 * the point; 0 if none has, and for a measurement. */
static unsigned repeated(const po_compare_input *c) {
  const po_case_file *file = c->kase->file;
  const po_request *request = &c->kase->points[c->point].request;
  bool same = false;
  for (unsigned i = 0; i < file->checks_count; ++i) {
    const po_check *other = &file->checks[i];
    if (other == c->check)
      return same ? i + 1 : 0;
    same = same || (have_same_names(other, c->check) &&
                    (c->check->quantity == PO_SOLVED_SHARE || po_check_concerns(other, request)));
  }
  return 0;
}

/* The share of solved points belongs to no point. */
static char *make_id(const po_compare_input *c, const char *suffix) {
  po_text text = {0};
  char reference[64];
  const bool whole = c->check->quantity == PO_SOLVED_SHARE;
  const unsigned number = repeated(c);
  po_check_result_reference(c->check, reference);
  po_text_add(&text, "%s/%s%s%s%s%s", c->check->quantity_text, reference, whole ? "" : "/",
              whole ? "" : c->kase->points[c->point].label, *suffix ? "/" : "", suffix);
  if (number)
    po_text_add(&text, "/check-%u", number);
  return po_text_take(&text);
}

/* Composes the subject of the quantity and, for a special point, its name. The quantity says
 * whether the number is its approach or its load. */
static void name_subject(po_check_result *item, const char *suffix) {
  const size_t length = strcspn(suffix, "/");
  const bool special = suffix[length] == '/';
  snprintf(item->subject, sizeof item->subject, "%s%s%.*s", item->quantity, special ? "/" : "",
           special ? (int)length : 0, suffix);
}

static po_verdict judge_number(const po_check_result *check_result) {
  if (isnan(check_result->expected))
    return PO_MISSING_REFERENCE;
  if (isnan(check_result->obtained))
    return PO_NO_RESULT;
  return fabs(check_result->error) <= check_result->allowance ? PO_WITHIN : PO_OUTSIDE;
}

po_check_result *po_compare_add(const po_compare_input *c, const char *name, const char *suffix,
                                double obtained, po_reference_number expected) {
  po_check_results *check_results = c->check_results;
  po_check_result *items = po_resize(check_results->items, check_results->count + 1, sizeof *items);
  if (!items)
    return NULL;
  check_results->items = items;
  po_check_result *item = &items[check_results->count];
  *item = (po_check_result){.point = c->point,
                            .check = c->check,
                            .reference = c->reference,
                            .ledger = c->reference->ledger,
                            .obtained = obtained,
                            .expected = expected.value,
                            .error = obtained - expected.value,
                            .allowance = po_check_allowance(c->check, expected.value),
                            .uncertainty = expected.uncertainty,
                            .approach = (double)NAN,
                            .load = (double)NAN};
  item->id = make_id(c, suffix);
  if (!item->id) {
    po_fail(PO_NO_MEMORY, "no memory for a verdict");
    return NULL;
  }
  snprintf(item->quantity, sizeof item->quantity, "%s", name);
  name_subject(item, suffix);
  item->ratio = item->error == 0 ? 0 : fabs(item->error) / item->allowance;
  item->verdict = judge_number(item);
  check_results->count += 1;
  return item;
}

void po_check_result_note(po_check_result *item, const char *format, ...) {
  const size_t had = strlen(item->note);
  char words[sizeof item->note];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(words, sizeof words, format, arguments);
  va_end(arguments);
  snprintf(item->note + had, sizeof item->note - had, "%s%s", had ? "; " : "", words);
}

void po_check_results_clear(po_check_results *check_results) {
  for (size_t i = 0; i < check_results->count; ++i)
    free(check_results->items[i].id);
  free(check_results->items);
  *check_results = (po_check_results){0};
}

/* Tolerances are judged by all results of a check. */

/* With a tolerance this many times the largest error, the check would not detect errors that are a
 * hundred times larger. */
static const double SLACK = 1000;

/* Relative errors below this are rounding errors of a long sum, not errors of the method. */
static const double ROUNDING = 4 * DBL_EPSILON;

/* Returned: the error below which a reference cannot distinguish two values. */
static double resolution(const po_check_result *item) {
  const double rounding = ROUNDING * fmax(fabs(item->obtained), fabs(item->expected));
  return fmax(isnan(rounding) ? 0 : rounding, isnan(item->uncertainty) ? 0 : item->uncertainty);
}

/* Reports whether a number is a count, which has no numerical error. */
static bool is_exact(const po_check_result *item) {
  return item->whole || strcmp(item->quantity, "fold_count") == 0 ||
         strcmp(item->quantity, "extremum_count") == 0 || strcmp(item->quantity, "jump_count") == 0;
}

/* Finds the result with the largest error in units of the tolerance among the results of one check.
 * Given: `first`, the first of these results.
 * Returned: that result, and in *largest the ratio; NULL if a result is not within, or if there is
 * no error. In *last, the index after the last result of the check.
 */
static po_check_result *worst_of_check(po_check_results *check_results, size_t first, size_t *last,
                                       double *largest) {
  const po_check *check = check_results->items[first].check;
  po_check_result *worst = NULL;
  bool measurable = true;
  *largest = 0.0;
  for (*last = first; *last < check_results->count && check_results->items[*last].check == check;
       ++*last) {
    po_check_result *item = &check_results->items[*last];
    measurable = measurable && item->verdict == PO_WITHIN;
    /* The tolerance of the case, which can be reduced: without the step of a solver. */
    const double allowance = po_check_allowance(check, item->expected);
    const double error = fmax(fabs(item->error), resolution(item)) / allowance;
    if (!is_exact(item) && error > *largest) {
      *largest = error;
      worst = item;
    }
  }
  return measurable ? worst : NULL;
}

void po_judge_tolerances(po_check_results *check_results) {
  for (size_t first = 0, last = 0; first < check_results->count; first = last) {
    double largest = 0;
    po_check_result *worst = worst_of_check(check_results, first, &last, &largest);
    if (!worst || largest * SLACK >= 1)
      continue;
    worst->verdict = PO_SLACK;
    po_check_result_note(
        worst, "the tolerance is %.0f times the largest error of this check, which is here",
        1 / largest);
  }
}
