#include "po_check_result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_text.h"

const char *po_verdict_name(po_verdict verdict) {
  static const char *const NAMES[PO_VERDICT_COUNT] = {
      [PO_IDENTICAL] = "identical",
      [PO_WITHIN] = "within",
      [PO_OUTSIDE] = "outside",
      [PO_NO_RESULT] = "no_result",
      [PO_MISSING_REFERENCE] = "missing_reference",
      [PO_IMPROVED] = "improved",
      [PO_REGRESSED] = "regressed",
      [PO_MOVED] = "moved",
      [PO_WRONG_AND_FROZEN] = "wrong_and_frozen",
      [PO_SLACK] = "slack",
      [PO_NOT_REACHABLE] = "not_reachable",
  };
  return NAMES[verdict];
}

bool po_verdict_passes(po_verdict verdict) {
  return po_verdict_is_plain(verdict) || verdict == PO_IMPROVED || verdict == PO_SLACK ||
         verdict == PO_NOT_REACHABLE;
}

bool po_verdict_is_plain(po_verdict verdict) {
  return verdict == PO_IDENTICAL || verdict == PO_WITHIN;
}

void po_check_result_reference(const po_check *check, char name[64]) {
  const char *slash = strrchr(check->reference, '/');
  const char *base = slash ? slash + 1 : check->reference;
  const char *dot = strrchr(base, '.');
  snprintf(name, 64, "%.*s", (int)(dot ? (size_t)(dot - base) : strlen(base)), base);
}

static char *make_id(const po_compare_input *c, const char *suffix) {
  po_text text = {0};
  char reference[64];
  po_check_result_reference(c->check, reference);
  po_text_add(&text, "%s/%s/%s%s%s", c->check->quantity_text, reference,
              c->kase->points[c->point].label, *suffix ? "/" : "", suffix);
  if (text.failed)
    po_text_clear(&text);
  return text.data;
}

/* Composes the subject of the quantity and, for a special point, its name. The quantity says
 * whether the number is its approach or its load. */
static void name_subject(po_check_result *item, const char *suffix) {
  const size_t length = strcspn(suffix, "/");
  const bool special = suffix[length] == '/';
  snprintf(item->subject, sizeof item->subject, "%s%s%.*s", item->quantity, special ? "/" : "",
           special ? (int)length : 0, suffix);
}

static po_verdict judge(const po_check_result *check_result) {
  if (isnan(check_result->expected))
    return PO_MISSING_REFERENCE;
  if (isnan(check_result->obtained))
    return PO_NO_RESULT;
  if (check_result->check->type == PO_REFERENCE_PINS && check_result->error == 0)
    return PO_IDENTICAL;
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
  item->verdict = judge(item);
  check_results->count += 1;
  return item;
}

void po_check_results_clear(po_check_results *check_results) {
  for (size_t i = 0; i < check_results->count; ++i)
    free(check_results->items[i].id);
  free(check_results->items);
  *check_results = (po_check_results){0};
}
