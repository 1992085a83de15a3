/* The record of a run, as run, explain and verify read it: record.json, and in further parts of the
 * input the curve and the profile of its first point. Tokens: @SOLVE_KEY@ and @KEY@ of the case,
 * @CURVE@ and @PROFILE@ for the checksums of the tables. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_explain.h"
#include "po_record.h"
#include "po_verdicts.h"

enum { CASES = 2 };

static const char *const NAMES[CASES] = {"plain", "followed"};

/* Two runs of each case: the first reads the input, the second reads what the first wrote. */
static po_case_run *runs[CASES], *backs[CASES];

static void write_parts(const po_case_run *run, const char *folder, const fuzz_part *parts,
                        size_t count) {
  fuzz_digests digests;
  char name[128];
  fuzz_write_tables(folder, parts, count, digests);
  const fuzz_token tokens[] = {{"@SOLVE_KEY@", run->plan->solve_key},
                               {"@KEY@", run->plan->key},
                               {"@CURVE@", digests[0]},
                               {"@PROFILE@", digests[1]}};
  fuzz_part record = fuzz_fill(&parts[0], tokens, sizeof tokens / sizeof *tokens);
  snprintf(name, sizeof name, "%s/record.json", folder);
  fuzz_write(fuzz_path(name), record.bytes, record.size);
  free(record.bytes);
}

/* A record that was read can be written, and reading it again gives the same results. */
static void require_written(po_case_run *run, po_case_run *back) {
  char name[64];
  snprintf(name, sizeof name, "back/%s", run->plan->kase->file->name);
  const char *folder = fuzz_path(name);
  run->environment = po_json_empty_object();
  po_status status = po_record_write(run, folder, 1, NULL);
  fuzz_require(!status, "a record that was read cannot be written: %s", po_message());
  status = po_record_read(back, folder);
  fuzz_require(!status, "a record that was written cannot be read: %s", po_message());
  for (size_t i = 0; i < run->plan->kase->point_count; ++i)
    fuzz_require_same_point(run, back, i);
}

/* A complete record is compared with its references, and the result is printed. */
static void tell(po_case_run *run, const char *output) {
  const po_run_options options = {.output = output, .jobs = 1};
  const po_explain_choice all = {.all = true};
  fuzz_run_reset(run);
  const po_status status = po_run(run, 1, &options);
  fuzz_require_message(status);
  if (status)
    return;
  fuzz_require(run->kept, "a record that can be read is solved again");
  po_text text = {0};
  po_explain_text(run, &all, &text);
  po_verdicts_table(run, 1, &text);
  po_verdicts_tap(run, 1, &text);
  po_verdicts_junit(run, 1, &text);
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
  fuzz_part parts[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
  const size_t count = fuzz_split(data, size, parts, 3);
  const char *output = fuzz_path("run");
  for (int c = 0; c < CASES; ++c) {
    char folder[64];
    if (!runs[c]) {
      runs[c] = fuzz_run(NAMES[c]);
      backs[c] = fuzz_run(NAMES[c]);
    }
    snprintf(folder, sizeof folder, "run/%s", NAMES[c]);
    fuzz_empty(fuzz_path(folder));
    write_parts(runs[c], folder, parts, count);
    fuzz_run_reset(runs[c]);
    fuzz_run_reset(backs[c]);
    po_message_clear();
    const po_status status = po_record_read(runs[c], fuzz_path(folder));
    fuzz_require(status == PO_OK || status == PO_NOT_FOUND, "reading a record ends in %s",
                 po_status_name(status));
    if (status)
      continue;
    require_written(runs[c], backs[c]);
    tell(runs[c], output);
  }
  free(parts[0].bytes);
  return 0;
}
