/* The journal of an interrupted run, points.jsonl, and in further parts of the input the curve and
 * the profile of point 0. Tokens: @KEY0@, @KEY1@ for the keys of the points, @CURVE@ and @PROFILE@
 * for the checksums of the tables. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_file.h"
#include "po_json_value.h"
#include "po_record.h"

enum { POINTS = 2 };

static po_case_run *run, *back;
static char keys[POINTS][PO_DIGEST_LENGTH];

/* The keys of the points appear in the written journal. */
static void find_keys(void) {
  for (size_t i = 0; i < POINTS; ++i) {
    char *bytes = NULL;
    size_t size = 0;
    fuzz_empty(fuzz_path("keys/plain"));
    fuzz_require(po_journal_add(run, i, fuzz_path("keys/plain")) == PO_OK &&
                     po_file_read(fuzz_path("keys/plain/points.jsonl"), &bytes, &size) == PO_OK,
                 "a point cannot be written: %s", po_message());
    json_t *entry = NULL;
    fuzz_require(po_json_parse(bytes, size, &entry) == PO_OK, "the line of a point is no JSON: %s",
                 po_message());
    snprintf(keys[i], sizeof keys[i], "%s", json_string_value(json_object_get(entry, "key")));
    json_decref(entry);
    free(bytes);
  }
}

static void write_parts(const fuzz_part *parts, size_t count) {
  fuzz_digests digests;
  fuzz_write_tables("run/plain", parts, count, digests);
  const fuzz_token tokens[] = {
      {"@KEY0@", keys[0]}, {"@KEY1@", keys[1]}, {"@CURVE@", digests[0]}, {"@PROFILE@", digests[1]}};
  fuzz_part journal = fuzz_fill(&parts[0], tokens, sizeof tokens / sizeof *tokens);
  fuzz_write(fuzz_path("run/plain/points.jsonl"), journal.bytes, journal.size);
  free(journal.bytes);
}

static void require_same(const char *folder, size_t point) {
  fuzz_run_reset(back);
  fuzz_require(po_journal_read(back, folder) == PO_OK, "a journal cannot be read: %s",
               po_message());
  fuzz_require(back->points[point].done, "point %zu was added to a journal and is not found in it",
               point);
  fuzz_require_same_point(run, back, point);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part parts[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
  const size_t count = fuzz_split(data, size, parts, 3);
  if (!run) {
    run = fuzz_run("plain");
    back = fuzz_run("plain");
    find_keys();
  }
  fuzz_empty(fuzz_path("run/plain"));
  write_parts(parts, count);
  fuzz_run_reset(run);
  fuzz_require_message(po_journal_read(run, fuzz_path("run/plain")));
  fuzz_empty(fuzz_path("back/plain"));
  for (size_t i = 0; i < POINTS; ++i) {
    if (!run->points[i].done)
      continue;
    /* A point that was read, written to a new journal, is read again as the same point. */
    po_status status = po_journal_add(run, i, fuzz_path("back/plain"));
    fuzz_require(!status, "a point that was read cannot be written: %s", po_message());
    require_same(fuzz_path("back/plain"), i);
  }
  /* A point that is added to the journal of the input is found in it, however that journal ends. */
  if (!run->points[0].done)
    run->points[0].result.status = PO_NOT_CONVERGED;
  const po_status status = po_journal_add(run, 0, fuzz_path("run/plain"));
  fuzz_require(!status, "a point cannot be added: %s", po_message());
  require_same(fuzz_path("run/plain"), 0);
  free(parts[0].bytes);
  return 0;
}
