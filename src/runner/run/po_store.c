#include "po_store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_input.h"
#include "po_json.h"
#include "po_lines.h"
#include "po_memory.h"
#include "po_record.h"
#include "po_result_rows.h"

static const char NAME[] = "points.jsonl";

po_status po_store_key(const po_case_run *run, size_t point, char key[PO_DIGEST_LENGTH]) {
  const po_plan *plan = run->plan;
  po_text text = {0};
  po_text_add(&text, "%s|%u|%u|", plan->program, plan->want, plan->kase->repeats);
  po_input_add_identity(&plan->kase->points[point].request, &text);
  if (plan->kase->series_length > 1 || plan->kase->repeats > 1)
    po_text_add(&text, "|%s|%zu", plan->solve_key, point);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_digest_bytes(po_text_string(&text), text.length, key);
  po_text_clear(&text);
  return status;
}

/* Appends the line of a point to a text. The request is left out, for which the key stands. */
static po_status add_line(po_case_run *run, size_t point, po_text *text) {
  char key[PO_DIGEST_LENGTH];
  const po_result *result = &run->points[point].result;
  po_status status = po_store_key(run, point, key);
  json_t *document = PO_JSON_OBJECT({"key", po_json_text(key)});
  po_json_set_all(&document, po_record_result(run, point));
  if (result->curve_count)
    po_json_set_all(&document, po_json_of(&PO_BRANCH_ROWS, result));
  if (result->profile_count)
    po_json_set_all(&document, po_json_of(&PO_SURFACE_ROWS, result));
  json_object_del(document, "input");
  if (!status)
    status = po_json_print_checked(document, true, text, run->points[point].checksum);
  json_decref(document);
  return status;
}

po_status po_store_put(po_case_run *run, size_t point, const char *folder) {
  const po_file_path path = po_path_join(folder, NAME);
  po_text line = {0};
  po_status status = po_folder_make(folder);
  if (!status)
    status = add_line(run, point, &line);
  if (!status)
    status = po_no_memory_or(PO_OK); /* the line may be incomplete */
  if (!status)
    status = po_lines_append(path.text, &line);
  po_text_clear(&line);
  return status;
}

po_status po_store_renew(po_case_run *run, const char *folder) {
  po_text text = {0};
  po_status status = po_folder_make(folder);
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i)
    if (!run->points[i].beyond)
      status = add_line(run, i, &text);
  if (!status)
    status = po_file_write(po_path_join(folder, NAME).text, po_text_string(&text), text.length);
  po_text_clear(&text);
  return status;
}

/* A point whose line is looked for. */
typedef struct {
  char key[PO_DIGEST_LENGTH];
  size_t point;
} wanted;

static int by_key(const void *a, const void *b) {
  return strcmp(((const wanted *)a)->key, ((const wanted *)b)->key);
}

typedef struct {
  po_case_run *run;
  const wanted *list; /* by key */
  size_t count;
} reading;

/* Reads a line into the points with its key: several that differ only in what has no influence have
 * the same. A result that is known from an earlier line remains if this one is not intact. */
static po_status read_line(void *data, const json_t *document, bool whole) {
  const reading *r = data;
  po_case_run *run = r->run;
  wanted sought;
  snprintf(sought.key, sizeof sought.key, "%s", document ? po_record_text(document, "key") : "");
  const wanted *found =
      document ? bsearch(&sought, r->list, r->count, sizeof *r->list, by_key) : NULL;
  po_status status = PO_OK;
  run->altered += whole && !document;
  while (found && found > r->list && by_key(found - 1, found) == 0)
    --found;
  run->untidy = run->untidy || !found || run->points[found->point].done;
  for (; !status && found && found < r->list + r->count && by_key(found, &sought) == 0; ++found) {
    po_point_run *point = &run->points[found->point];
    status = po_record_read_result(run, found->point, document);
    point->done = !status;
    snprintf(point->checksum, sizeof point->checksum, "%s",
             status ? "" : po_record_text(document, "checksum"));
  }
  return status == PO_NO_MEMORY ? status : PO_OK;
}

po_status po_store_read(po_case_run *run, const char *folder) {
  const size_t points = run->plan->kase->point_count;
  wanted *list = po_allocate(points, sizeof *list);
  size_t count = 0;
  po_status status = list ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < points; ++i)
    if (run->points[i].asked && !run->points[i].done) {
      list[count].point = i;
      status = po_store_key(run, i, list[count++].key);
    }
  if (!status && count) {
    qsort(list, count, sizeof *list, by_key);
    reading r = {run, list, count};
    status = po_lines_read(po_path_join(folder, NAME).text, read_line, &r);
  }
  free(list);
  return status;
}
