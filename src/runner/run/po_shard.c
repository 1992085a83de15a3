#include "po_shard.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_json_digest.h"
#include "po_memory.h"
#include "po_random.h"
#include "po_record.h"
#include "po_store.h"
#include "po_text.h"

static const char SCHEMA[] = "pulloff-shard/1";

/* A group of points that belong to the same shard. */
typedef struct {
  uint64_t place; /* in the order in which the groups are assigned */
  size_t run, first, length;
} group;

static size_t group_length(const po_case *kase) {
  return kase->repeats > 1 ? kase->point_count : kase->series_length;
}

static int by_place(const void *a, const void *b) {
  const uint64_t x = ((const group *)a)->place, y = ((const group *)b)->place;
  return (x > y) - (x < y);
}

po_status po_shard_deal(po_case_run *runs, size_t count, po_shard shard) {
  size_t total = 0, filled = 0;
  for (size_t r = 0; r < count; ++r)
    total += runs[r].plan->kase->point_count / group_length(runs[r].plan->kase);
  group *groups = po_allocate(total, sizeof *groups);
  if (!groups)
    return PO_NO_MEMORY;
  for (size_t r = 0; r < count; ++r) {
    const size_t length = group_length(runs[r].plan->kase);
    for (size_t i = 0; i < runs[r].plan->kase->point_count; i += length, ++filled)
      groups[filled] = (group){po_random_mix(filled), r, i, length};
    runs[r].asked_count = 0;
  }
  qsort(groups, total, sizeof *groups, by_place);
  for (size_t p = 0; p < total; ++p) {
    po_case_run *run = &runs[groups[p].run];
    const size_t number = p % shard.count + 1;
    for (size_t i = groups[p].first; i < groups[p].first + groups[p].length; ++i) {
      run->points[i].shard = number;
      run->points[i].asked = number == shard.number;
    }
    run->asked_count += number == shard.number ? groups[p].length : 0;
  }
  free(groups);
  return PO_OK;
}

static const char *case_argument(const po_case *kase) {
  return kase->is_own ? kase->shown : kase->file->name;
}

/* Returned: what all shards of a run have in common. */
static json_t *request_json(const po_case_run *runs, size_t count, size_t of, double time_limit) {
  json_t *cases = po_json_empty_array();
  for (size_t r = 0; r < count; ++r)
    po_json_append(&cases,
                   PO_JSON_OBJECT({"case", po_json_text(runs[r].plan->kase->file->name)},
                                  {"argument", po_json_text(case_argument(runs[r].plan->kase))},
                                  {"solve_key", po_json_text(runs[r].plan->solve_key)}));
  return PO_JSON_OBJECT({"of", po_json_count(of)}, {"program", po_json_text(runs[0].plan->program)},
                        {"time_limit", po_json_number(time_limit)}, {"cases", cases});
}

po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output) {
  char name[64], digest[PO_DIGEST_LENGTH];
  po_text text = {0};
  snprintf(name, sizeof name, "shard-%zu-of-%zu.json", shard.number, shard.count);
  json_t *document =
      PO_JSON_OBJECT({"schema", po_json_text(SCHEMA)}, {"shard", po_json_count(shard.number)},
                     {"environment", po_environment_describe(jobs)});
  po_json_set_all(&document, request_json(runs, count, shard.count, time_limit));
  po_status status = po_folder_make(output);
  if (!status)
    status = po_json_print_checked(document, false, &text, digest);
  if (!status)
    status = po_file_write(po_path_join(output, name).text, text.data, text.length);
  json_decref(document);
  po_text_clear(&text);
  return status;
}

/* The merge. */

/* Checks the description of a shard. */
static po_status check_part(const po_merge_part *part, bool intact) {
  const json_t *root = part->root, *number = json_object_get(root, "shard");
  const double limit = po_json_read_number(root, "time_limit");
  if (strcmp(po_record_text(root, "schema"), SCHEMA) != 0 || json_integer_value(number) < 1 ||
      json_integer_value(number) > json_integer_value(json_object_get(root, "of")) ||
      json_array_size(json_object_get(root, "cases")) == 0 || limit <= 0 ||
      !json_is_object(json_object_get(root, "environment")))
    return po_fail(PO_CANNOT_READ, "%s is damaged: expected the description of a shard",
                   part->path.text);
  if (!intact)
    return po_fail(PO_CANNOT_READ, "%s was altered: it does not have its checksum",
                   part->path.text);
  return PO_OK;
}

/* Reads the file of a shard. */
static po_status read_part(po_merge *merge, const char *folder, const char *name) {
  po_merge_part *parts = po_resize(merge->parts, merge->count + 1, sizeof *parts);
  if (!parts)
    return PO_NO_MEMORY;
  merge->parts = parts;
  po_merge_part *part = &parts[merge->count++];
  *part = (po_merge_part){.path = po_path_join(folder, name), .folder = folder};
  char *bytes = NULL;
  size_t size = 0;
  bool intact = false;
  po_status status = po_file_read(part->path.text, &bytes, &size);
  if (!status)
    status = po_json_parse_checked(bytes, size, &part->root, &intact);
  free(bytes);
  if (status == PO_NO_MEMORY || (status && !size))
    return status;
  return check_part(part, intact);
}

static po_status read_folder(po_merge *merge, const char *folder) {
  char **names = NULL;
  size_t count = 0, found = 0;
  po_status status = po_folder_list(folder, ".json", &names, &count);
  for (size_t i = 0; !status && i < count; ++i) {
    if (strncmp(names[i], "shard-", strlen("shard-")) != 0)
      continue;
    status = read_part(merge, folder, names[i]);
    ++found;
  }
  po_names_free(names, count);
  if (!status && !found)
    status =
        po_fail(PO_CANNOT_READ,
                "the folder %s contains no shard: expected the output folder of the run of a shard",
                folder);
  return status;
}

/* Returned: the first case of a shard that differs from that of a request. */
static const char *other_case(const json_t *part, const json_t *request) {
  const json_t *mine = json_object_get(part, "cases"), *theirs = json_object_get(request, "cases");
  size_t i = 0;
  while (json_equal(json_array_get(mine, i), json_array_get(theirs, i)))
    ++i;
  const json_t *found = json_array_get(mine, i);
  return po_record_text(found ? found : json_array_get(theirs, i), "case");
}

/* Checks that a shard belongs to the same run as another one, or as a request. */
static po_status check_same(const po_merge_part *part, const json_t *request, const char *whose) {
  static const struct {
    const char *key, *what;
  } SAME[] = {{"of", "another number of shards"},
              {"program", "another program"},
              {"time_limit", "another time limit"},
              {"cases", "other cases, or other scenes, at case "}};
  for (size_t k = 0; k < sizeof SAME / sizeof *SAME; ++k)
    if (!json_equal(json_object_get(part->root, SAME[k].key),
                    json_object_get(request, SAME[k].key)))
      return po_fail(PO_BAD_INPUT, "%s is of a run with %s%s than %s: expected shards of one run",
                     part->path.text, SAME[k].what,
                     strcmp(SAME[k].key, "cases") == 0 ? other_case(part->root, request) : "",
                     whose);
  return PO_OK;
}

/* Reads what the cases and their time limit were, which all shards have in common. */
static po_status take_request(po_merge *merge) {
  const json_t *cases = json_object_get(merge->parts[0].root, "cases");
  merge->time_limit = po_json_read_number(merge->parts[0].root, "time_limit");
  merge->of = (size_t)po_json_count_of(merge->parts[0].root, "of");
  merge->case_count = json_array_size(cases);
  merge->cases = po_allocate(merge->case_count, sizeof *merge->cases);
  for (size_t i = 0; merge->cases && i < merge->case_count; ++i)
    merge->cases[i] = (char *)po_record_text(json_array_get(cases, i), "argument");
  return merge->cases ? PO_OK : PO_NO_MEMORY;
}

po_status po_merge_open(char *const *folders, size_t count, po_merge *merge) {
  *merge = (po_merge){0};
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < count; ++i)
    status = read_folder(merge, folders[i]);
  for (size_t i = 1; !status && i < merge->count; ++i)
    status = check_same(&merge->parts[i], merge->parts[0].root, merge->parts[0].path.text);
  return status ? status : take_request(merge);
}

void po_merge_close(po_merge *merge) {
  for (size_t i = 0; i < merge->count; ++i)
    json_decref(merge->parts[i].root);
  free(merge->parts);
  free(merge->cases);
  *merge = (po_merge){0};
}

/* The message names at most this many shards. */
static const size_t MOST_NAMED = 10;

static int by_number(const void *a, const void *b) {
  const size_t x = *(const size_t *)a, y = *(const size_t *)b;
  return (x > y) - (x < y);
}

/* Refuses a case of which points are lacking, and names the shards to which they belong. */
static po_status refuse_lacking(const po_merge *merge, const po_case_run *run) {
  const size_t points = run->plan->kase->point_count, lacking = po_case_run_lacking(run);
  size_t *numbers = po_allocate(lacking, sizeof *numbers), count = 0, named = 0;
  po_text text = {0};
  if (!numbers)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < points; ++i)
    if (!run->points[i].done)
      numbers[count++] = run->points[i].shard;
  qsort(numbers, count, sizeof *numbers, by_number);
  for (size_t k = 0; k < count; ++k)
    if ((k == 0 || numbers[k] != numbers[k - 1]) && named++ < MOST_NAMED)
      po_text_add(&text, "%s%zu/%zu", named > 1 ? ", " : "", numbers[k], merge->of);
  if (named > MOST_NAMED)
    po_text_add(&text, " and %zu more", named - MOST_NAMED);
  const po_status status = po_fail(
      PO_CANNOT_READ,
      "%zu of %zu %s of %s %s%s: expected all %zu shards, each finished; missing or not finished: "
      "%s",
      lacking, points, po_one_or_more(points, "point", "points"), run->plan->kase->file->name,
      po_one_or_more(lacking, "is lacking", "are lacking"),
      run->altered ? ", and stored results were altered or damaged" : "", merge->of,
      po_text_string(&text));
  po_text_clear(&text);
  free(numbers);
  return status;
}

/* Reads the points of a case from the stores of all shards. The environment of the case is that of
 * the shard that has its first point. */
static po_status fill_case(const po_merge *merge, po_case_run *run) {
  po_status status = PO_OK;
  po_case_run_ask(run, &(po_point_range){0, run->plan->kase->point_count}, 1);
  for (size_t p = 0; !status && p < merge->count && po_case_run_lacking(run); ++p) {
    const po_merge_part *part = &merge->parts[p];
    status = po_store_read(run, po_path_join(part->folder, run->plan->kase->file->name).text);
    if (!run->environment && run->points[0].done)
      run->environment = json_incref(json_object_get(part->root, "environment"));
  }
  if (!status && po_case_run_lacking(run))
    return refuse_lacking(merge, run);
  run->altered = 0; /* an intact copy was found */
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    const double seconds = run->points[i].result.work.seconds;
    run->elapsed += isnan(seconds) ? 0 : seconds; /* of an external solver, not reported */
  }
  return status;
}

po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count) {
  json_t *request = request_json(runs, count, merge->of, merge->time_limit);
  po_status status = request ? check_same(&merge->parts[0], request, "this one") : PO_NO_MEMORY;
  json_decref(request);
  if (!status)
    status = po_shard_deal(runs, count, (po_shard){1, merge->of});
  for (size_t r = 0; !status && r < count; ++r)
    status = fill_case(merge, &runs[r]);
  return status;
}
