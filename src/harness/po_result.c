#include "po_result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_text.h"

const char *po_verdict_name(po_verdict verdict) {
  static const char *const NAMES[] = {"within", "outside", "no_result", "missing_reference"};
  return NAMES[verdict];
}

/* "reference/feng_pull_off.csv" -> "feng_pull_off". */
static void add_short_name(po_text *text, const char *reference) {
  const char *slash = strrchr(reference, '/');
  const char *name = slash ? slash + 1 : reference;
  const char *dot = strrchr(name, '.');
  po_text_add(text, "%.*s", (int)(dot ? (size_t)(dot - name) : strlen(name)), name);
}

static char *make_id(const po_case *kase, size_t point, const po_check *check, const char *suffix) {
  po_text text = {0};
  po_text_add(&text, "%s/", check->quantity_text);
  add_short_name(&text, check->reference);
  po_text_add(&text, "/%s%s%s", kase->points[point].label, *suffix ? "/" : "", suffix);
  if (text.failed)
    po_text_clear(&text);
  return text.data;
}

static po_verdict judge(const po_result *result) {
  if (isnan(result->expected))
    return PO_MISSING_REFERENCE;
  if (isnan(result->obtained))
    return PO_NO_RESULT;
  return fabs(result->error) <= result->allowance ? PO_WITHIN : PO_OUTSIDE;
}

po_result *po_results_add(po_results *results, const po_case *kase, size_t point,
                          const po_check *check, const char *name, const char *suffix,
                          double obtained, po_reference_number expected) {
  po_result *items = po_resize(results->items, results->count + 1, sizeof *items);
  if (!items)
    return NULL;
  results->items = items;
  po_result *item = &items[results->count];
  *item = (po_result){.point = point,
                      .check = check,
                      .obtained = obtained,
                      .expected = expected.value,
                      .error = obtained - expected.value,
                      .allowance = po_check_allowance(check, expected.value),
                      .uncertainty = expected.uncertainty};
  item->id = make_id(kase, point, check, suffix);
  if (!item->id) {
    po_fail(PO_NO_MEMORY, "no memory for a verdict");
    return NULL;
  }
  snprintf(item->quantity, sizeof item->quantity, "%s", name);
  item->ratio = fabs(item->error) / item->allowance;
  item->verdict = judge(item);
  results->count += 1;
  return item;
}

void po_results_clear(po_results *results) {
  for (size_t i = 0; i < results->count; ++i)
    free(results->items[i].id);
  free(results->items);
  *results = (po_results){0};
}
