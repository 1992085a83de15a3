/* The store of a case, points.jsonl, as run, explain and verify read it, and in a further part of
 * the input the record beside it. Tokens: @KEY0@, @KEY1@, ... for the keys of the points, @KEY@ for
 * that of the case. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_explain.h"
#include "po_record.h"
#include "po_store.h"
#include "po_verdicts.h"

enum { CASES = 2, MOST_POINTS = 8 };

static const char *const NAMES[CASES] = {"plain", "followed"};

/* Two runs of each case: the first reads the input, the second reads what the first wrote. */
static po_case_run *runs[CASES], *backs[CASES];

static void write_part(const po_case_run *run, const char *folder, const char *name,
                       const fuzz_part *part) {
  char keys[MOST_POINTS][PO_DIGEST_LENGTH], names[MOST_POINTS][8];
  fuzz_token tokens[MOST_POINTS + 1] = {{"@KEY@", run->plan->key}};
  size_t count = 1;
  for (size_t i = 0; i < run->plan->kase->point_count && i < MOST_POINTS; ++i) {
    fuzz_require(po_store_key(run, i, keys[i]) == PO_OK, "point %zu has no key", i);
    snprintf(names[i], sizeof names[i], "@KEY%d@", (int)i);
    tokens[count++] = (fuzz_token){names[i], keys[i]};
  }
  char path[128];
  fuzz_part filled = fuzz_fill(part, tokens, count);
  snprintf(path, sizeof path, "%s/%s", folder, name);
  fuzz_write(fuzz_path(path), filled.bytes, filled.size);
  free(filled.bytes);
}

/* Requires that a point of a run is read from a store as it is. */
static void require_same(const po_case_run *run, po_case_run *back, const char *folder,
                         size_t point) {
  fuzz_run_reset(back);
  fuzz_require(po_store_read(back, folder) == PO_OK, "a store cannot be read: %s", po_message());
  fuzz_require(back->points[point].done, "point %zu was stored and is not found", point);
  fuzz_require_same_point(run, back, point);
}

/* A point that was read can be stored anew, alone or after what the input has, however that ends.
 */
static void require_stored(po_case_run *run, po_case_run *back, const char *folder,
                           const char *other) {
  size_t done = 0;
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    if (!run->points[i].done)
      continue;
    ++done;
    fuzz_require(po_store_put(run, i, other) == PO_OK && po_store_put(run, i, folder) == PO_OK,
                 "a point that was read cannot be stored: %s", po_message());
    require_same(run, back, other, i);
    require_same(run, back, folder, i);
  }
  if (done < run->plan->kase->point_count)
    return;
  fuzz_require(po_store_renew(run, folder) == PO_OK, "a store cannot be renewed: %s", po_message());
  for (size_t i = 0; i < done; ++i)
    require_same(run, back, folder, i);
  fuzz_require(!back->untidy && !back->altered, "a store that was renewed is not tidy");
}

/* Results that are all known are compared with their references, and the verdicts are printed. */
static void tell(po_case_run *run, const char *output) {
  const po_run_options options = {.output = output, .jobs = 1};
  const po_explain_choice all = {.all = true};
  fuzz_run_reset(run);
  const po_status status = po_run(run, 1, &options);
  fuzz_require_message(status);
  if (status)
    return;
  fuzz_require(run->kept, "results that can be read are solved again");
  const po_identity none = {0};
  po_text text = {0};
  po_explain_text(run, &all, &text);
  po_verdicts_table(run, 1, &text);
  po_verdicts_tap(run, &none, 1, &text);
  po_verdicts_junit(run, &none, 1, &text);
  fuzz_require(!text.failed, "the verdicts cannot be printed: %s", po_message());
  fuzz_require_words("a verdict", po_text_string(&text), true);
  po_text_clear(&text);
  json_t *document = po_explain_json(run, &all);
  fuzz_require(document != NULL, "there is no document of the verdicts");
  fuzz_require(json_array_size(json_object_get(document, "checks")) == run->check_results.count,
               "%zu checks are made, %zu are in the document", run->check_results.count,
               json_array_size(json_object_get(document, "checks")));
  json_decref(document);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part parts[2] = {{NULL, 0}, {NULL, 0}};
  const size_t count = fuzz_split(data, size, parts, 2);
  const char *output = fuzz_path("run");
  for (int c = 0; c < CASES; ++c) {
    char folder[64], other[64];
    if (!runs[c]) {
      runs[c] = fuzz_run(NAMES[c]);
      backs[c] = fuzz_run(NAMES[c]);
    }
    snprintf(folder, sizeof folder, "run/%s", NAMES[c]);
    snprintf(other, sizeof other, "back/%s", NAMES[c]);
    fuzz_empty(fuzz_path(folder));
    fuzz_empty(fuzz_path(other));
    write_part(runs[c], folder, "points.jsonl", &parts[0]);
    if (count > 1)
      write_part(runs[c], folder, "record.json", &parts[1]);
    fuzz_run_reset(runs[c]);
    po_message_clear();
    fuzz_require_message(po_store_read(runs[c], fuzz_path(folder)));
    const bool all = !po_case_run_lacking(runs[c]);
    require_stored(runs[c], backs[c], fuzz_path(folder), fuzz_path(other));
    if (all)
      tell(runs[c], output);
  }
  free(parts[0].bytes);
  return 0;
}
