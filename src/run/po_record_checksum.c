#include <stdlib.h>

#include "po_input.h"
#include "po_record.h"

po_status po_record_key(const po_case_run *run, size_t point, char key[PO_DIGEST_LENGTH]) {
  const po_plan *plan = run->plan;
  po_text text = {0};
  char *command = po_input_identity(&plan->kase->points[point].request);
  po_text_add(&text, "%s|%u|%u|%s", plan->program, plan->want, plan->kase->repeats,
              command ? command : "");
  if (plan->kase->series_length > 1)
    po_text_add(&text, "|%s", plan->solve_key);
  const bool made = command && !text.failed;
  po_digest_bytes(po_text_string(&text), text.length, key);
  free(command);
  po_text_clear(&text);
  return made ? PO_OK : PO_NO_MEMORY;
}

/* The checksum of an entry that has none yet: of the key of its point and of all its members. */
static po_status compute(const po_case_run *run, size_t point, const json_t *entry,
                         char digest[PO_DIGEST_LENGTH]) {
  char key[PO_DIGEST_LENGTH];
  po_text text = {0};
  po_status status = po_record_key(run, point, key);
  po_text_add(&text, "%s ", status ? "" : key);
  if (!status)
    status = po_json_print_line(entry, &text);
  po_digest_bytes(po_text_string(&text), text.length, digest);
  po_text_clear(&text);
  return status;
}

po_status po_record_add_checksum(const po_case_run *run, size_t point, json_t **entry) {
  char digest[PO_DIGEST_LENGTH];
  const po_status status = compute(run, point, *entry, digest);
  po_json_set(entry, "checksum", po_json_text(digest));
  return status;
}

po_status po_record_check(const po_case_run *run, size_t point, json_t *entry) {
  char digest[PO_DIGEST_LENGTH];
  if (!json_is_object(entry))
    return PO_NOT_FOUND;
  json_t *stated = json_incref(json_object_get(entry, "checksum"));
  json_object_del(entry, "checksum");
  const char *text = json_string_value(stated);
  po_status status = compute(run, point, entry, digest);
  if (!status && !po_digest_agrees(text ? text : "", digest))
    status = PO_NOT_FOUND;
  json_decref(stated);
  return status;
}
