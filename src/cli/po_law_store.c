#include "po_law_store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_json_digest.h"
#include "po_lines.h"

static const char NAME[] = "laws.jsonl";

/* The numbers of a law, by their names in a line. */
static const struct {
  const char *name;
  size_t place;
} NUMBERS[] = {{"jump_in", offsetof(po_law_stored, numbers.jump_in)},
               {"jump_out", offsetof(po_law_stored, numbers.jump_out)},
               {"pull_off", offsetof(po_law_stored, numbers.pull_off)},
               {"pull_off_overlap", offsetof(po_law_stored, numbers.pull_off_overlap)},
               {"energy_lost", offsetof(po_law_stored, numbers.energy_lost)},
               {"energy_lost_error", offsetof(po_law_stored, numbers.energy_lost_error)},
               {"force_error", offsetof(po_law_stored, error)},
               {"parabola_excess", offsetof(po_law_stored, parabola_excess)},
               {"seconds", offsetof(po_law_stored, seconds)}};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

static const char *text_of(const json_t *line, const char *key) {
  const char *text = json_string_value(json_object_get(line, key));
  return text ? text : "";
}

/* Keeps a line in place of an earlier one with its key; one that was altered is made again. */
static po_status visit(void *data, const json_t *line, bool whole) {
  po_law_store *store = data;
  (void)whole;
  if (line)
    po_json_set(&store->lines, text_of(line, "key"), json_incref((json_t *)(uintptr_t)line));
  return store->lines ? PO_OK : PO_NO_MEMORY;
}

po_status po_law_store_open(const char *folder, po_law_store *store) {
  *store = (po_law_store){.lines = po_json_empty_object()};
  store->folder = po_path_join("", folder);
  po_status status = store->lines ? po_environment_program(store->program) : PO_NO_MEMORY;
  if (!status)
    status = po_lines_read(po_path_join(folder, NAME).text, visit, store);
  return status;
}

void po_law_store_clear(po_law_store *store) {
  json_decref(store->lines);
  store->lines = NULL;
}

po_status po_law_store_key(const po_law_store *store, const po_law_line *line,
                           char key[PO_DIGEST_LENGTH]) {
  po_text text = {0};
  po_text_add(&text, "%s|%s|", store->program, line->name);
  po_law_line_add_command(line, &text);
  po_text_add(&text, "|");
  po_input_add_identity(&line->request, &text); /* with the content of a profile's file */
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_digest_bytes(po_text_string(&text), text.length, key);
  po_text_clear(&text);
  return status;
}

/* Whether the file of a law is the one that was written. */
static bool is_unchanged(const po_law_store *store, const char *file, const char *stated) {
  char *data = NULL, digest[PO_DIGEST_LENGTH];
  size_t size = 0;
  const po_status status = po_file_read(po_path_join(store->folder.text, file).text, &data, &size);
  if (!status)
    po_digest_bytes(data, size, digest);
  free(data);
  po_message_clear();
  return !status && po_digest_agrees(stated, digest);
}

bool po_law_store_find(const po_law_store *store, const char *key, const char *file,
                       po_law_stored *stored) {
  const json_t *line = json_object_get(store->lines, key);
  *stored = (po_law_stored){.reason = text_of(line, "reason")};
  if (!line)
    return false;
  stored->status = *stored->reason ? PO_BAD_INPUT : PO_OK;
  for (size_t k = 0; k < NUMBER_COUNT; ++k)
    *(double *)(void *)((char *)stored + NUMBERS[k].place) =
        po_json_read_number(line, NUMBERS[k].name);
  return stored->status || is_unchanged(store, file, text_of(line, "sha256"));
}

po_status po_law_store_put(const po_law_store *store, const char *key, const po_law_stored *stored,
                           const po_text *content) {
  char digest[PO_DIGEST_LENGTH], checksum[PO_DIGEST_LENGTH];
  po_text text = {0};
  po_digest_bytes(po_text_string(content), content->length, digest);
  json_t *line =
      PO_JSON_OBJECT({"key", po_json_text(key)}, {"reason", po_json_text(stored->reason)},
                     {"sha256", po_json_text(digest)});
  for (size_t k = 0; k < NUMBER_COUNT; ++k)
    po_json_set(
        &line, NUMBERS[k].name,
        po_json_number(*(const double *)(const void *)((const char *)stored + NUMBERS[k].place)));
  po_status status = po_json_print_checked(line, true, &text, checksum);
  if (!status)
    status = po_no_memory_or(PO_OK); /* the line may be incomplete */
  if (!status)
    status = po_lines_append(po_path_join(store->folder.text, NAME).text, &text);
  json_decref(line);
  po_text_clear(&text);
  return status;
}
