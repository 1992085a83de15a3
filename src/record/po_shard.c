#include "po_shard.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_json_digest.h"
#include "po_memory.h"
#include "po_random.h"

/* A group of points that belong to the same shard. */
typedef struct {
  uint64_t place; /* in the order in which the groups are assigned */
  size_t run, first, length;
} part;

static size_t part_length(const po_case *kase) {
  return kase->repeats > 1 ? kase->point_count : kase->series_length;
}

static int by_place(const void *a, const void *b) {
  const uint64_t x = ((const part *)a)->place, y = ((const part *)b)->place;
  return (x > y) - (x < y);
}

po_status po_shard_deal(po_case_run *runs, size_t count, po_shard shard) {
  size_t total = 0, filled = 0;
  for (size_t r = 0; r < count; ++r)
    total += runs[r].plan->kase->point_count / part_length(runs[r].plan->kase);
  part *parts = po_allocate(total, sizeof *parts);
  if (!parts)
    return PO_NO_MEMORY;
  for (size_t r = 0; r < count; ++r) {
    const po_case *kase = runs[r].plan->kase;
    const size_t length = part_length(kase);
    for (size_t i = 0; i < kase->point_count; runs[r].asked[i++] = false)
      if (i % length == 0) {
        parts[filled] = (part){po_random_mix(filled), r, i, length};
        ++filled;
      }
    runs[r].asked_count = 0;
  }
  qsort(parts, total, sizeof *parts, by_place);
  for (size_t p = shard.number - 1; p < total; p += shard.count) {
    po_case_run *run = &runs[parts[p].run];
    for (size_t i = parts[p].first; i < parts[p].first + parts[p].length; ++i)
      run->asked[i] = true;
    run->asked_count += parts[p].length;
  }
  free(parts);
  return PO_OK;
}

static const char *case_argument(const po_case *kase) {
  return kase->is_own ? kase->shown : kase->file->name;
}

static json_t *cases_json(const po_case_run *runs, size_t count) {
  json_t *cases = po_json_empty_array();
  for (size_t r = 0; r < count; ++r) {
    const po_plan *plan = runs[r].plan;
    po_json_append(&cases, PO_JSON_OBJECT({"case", po_json_text(plan->kase->file->name)},
                                          {"argument", po_json_text(case_argument(plan->kase))},
                                          {"solve_key", po_json_text(plan->solve_key)},
                                          {"points", po_json_count(plan->kase->point_count)},
                                          {"asked", po_json_count(runs[r].asked_count)}));
  }
  return cases;
}

po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output) {
  char name[64];
  po_text text = {0};
  snprintf(name, sizeof name, "shard-%zu-of-%zu.json", shard.number, shard.count);
  json_t *document = PO_JSON_OBJECT(
      {"schema", po_json_text(PO_SHARD_SCHEMA)}, {"shard", po_json_count(shard.number)},
      {"of", po_json_count(shard.count)}, {"program", po_json_text(runs[0].plan->program)},
      {"time_limit", po_json_number(time_limit)}, {"environment", po_environment_describe(jobs)},
      {"cases", cases_json(runs, count)});
  char *path = po_path_join(output, name);
  po_status status = path ? po_folder_make(output) : PO_NO_MEMORY;
  if (!status)
    status = po_json_print_checked(document, &text);
  if (!status)
    status = po_file_write(path, text.data, text.length);
  free(path);
  json_decref(document);
  po_text_clear(&text);
  return status;
}
