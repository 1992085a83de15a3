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
#include "po_order.h"
#include "po_random.h"
#include "po_record.h"
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
    const po_case *kase = runs[r].plan->kase;
    const size_t length = group_length(kase);
    for (size_t i = 0; i < kase->point_count; runs[r].points[i++].asked = false)
      if (i % length == 0) {
        groups[filled] = (group){po_random_mix(filled), r, i, length};
        ++filled;
      }
    runs[r].asked_count = 0;
  }
  qsort(groups, total, sizeof *groups, by_place);
  for (size_t p = shard.number - 1; p < total; p += shard.count) {
    po_case_run *run = &runs[groups[p].run];
    for (size_t i = groups[p].first; i < groups[p].first + groups[p].length; ++i)
      run->points[i].asked = true;
    run->asked_count += groups[p].length;
  }
  free(groups);
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
      {"schema", po_json_text(SCHEMA)}, {"shard", po_json_count(shard.number)},
      {"of", po_json_count(shard.count)}, {"program", po_json_text(runs[0].plan->program)},
      {"time_limit", po_json_number(time_limit)}, {"environment", po_environment_describe(jobs)},
      {"cases", cases_json(runs, count)});
  po_status status = po_folder_make(output);
  if (!status)
    status = po_json_print_checked(document, &text);
  if (!status)
    status = po_file_write(po_path_join(output, name).text, text.data, text.length);
  json_decref(document);
  po_text_clear(&text);
  return status;
}

/* The merge. */

static const json_t *cases_of(const po_merge_part *part) {
  return json_object_get(part->root, "cases");
}

/* Reads the file of a shard. */
static po_status read_part(po_merge *merge, const char *folder, const char *name) {
  po_merge_part *parts = po_resize(merge->parts, merge->count + 1, sizeof *parts);
  if (!parts)
    return PO_NO_MEMORY;
  merge->parts = parts;
  po_merge_part *part = &parts[merge->count++];
  *part = (po_merge_part){.path = po_path_join(folder, name), .folder = folder};
  const char *path = part->path.text;
  char *bytes = NULL;
  size_t size = 0;
  po_status status = po_file_read(path, &bytes, &size);
  bool intact = false;
  if (!status &&
      (status = po_json_parse_checked(bytes, size, &part->root, &intact)) == PO_CANNOT_READ)
    status = PO_OK; /* reported below, like a file that does not describe a shard */
  free(bytes);
  if (status)
    return status;
  const json_int_t number = json_integer_value(json_object_get(part->root, "shard"));
  const json_int_t of = json_integer_value(json_object_get(part->root, "of"));
  if (strcmp(po_record_text(part->root, "schema"), SCHEMA) != 0 || number < 1 || number > of ||
      json_array_size(cases_of(part)) == 0 ||
      !json_is_object(json_object_get(part->root, "environment")))
    return po_fail(PO_CANNOT_READ, "%s is damaged: expected the description of a shard", path);
  if (!intact)
    return po_fail(PO_CANNOT_READ, "%s was altered: it does not have its checksum", path);
  if (of > PO_MOST_SHARDS)
    return po_fail(PO_CANNOT_READ, "%s is damaged: it is one of %lld shards, expected at most %d",
                   path, (long long)of, PO_MOST_SHARDS);
  const double limit = po_json_read_number(part->root, "time_limit");
  if (limit <= 0)
    return po_fail(PO_CANNOT_READ, "%s is damaged: time_limit is %g, expected a number > 0 or null",
                   path, limit);
  part->shard = (po_shard){(size_t)number, (size_t)of};
  return PO_OK;
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

/* Returned: the name of a case that only one of two shards has; NULL if their cases agree. */
static const char *other_case(const po_merge_part *a, const po_merge_part *b) {
  const json_t *mine = cases_of(a), *theirs = cases_of(b);
  for (size_t i = 0; i < json_array_size(mine) || i < json_array_size(theirs); ++i) {
    const json_t *x = json_array_get(mine, i), *y = json_array_get(theirs, i);
    if (strcmp(po_record_text(x, "case"), po_record_text(y, "case")) != 0)
      return po_record_text(y ? y : x, "case");
  }
  return NULL;
}

/* Refuses a shard that solves a case otherwise than the first one. */
static po_status refuse_scenes(const po_merge_part *first, const po_merge_part *part,
                               const char *name) {
  char limits[2][PO_NUMBER_LENGTH] = {"none", "none"};
  const double mine = po_json_read_number(part->root, "time_limit"),
               other = po_json_read_number(first->root, "time_limit");
  if (!isnan(mine))
    po_number_print(mine, limits[0]);
  if (!isnan(other))
    po_number_print(other, limits[1]);
  if (strcmp(limits[0], limits[1]) != 0)
    return po_fail(PO_BAD_INPUT, "%s: time_limit is %s: expected %s, as in %s", part->path.text,
                   limits[0], limits[1], first->path.text);
  return po_fail(PO_BAD_INPUT, "%s has other scenes of case %s than %s: expected the same",
                 part->path.text, name, first->path.text);
}

/* Compares a shard with the first one: program, cases and scenes must agree. */
static po_status check_part(const po_merge_part *first, const po_merge_part *part) {
  if (part->shard.count != first->shard.count)
    return po_fail(PO_BAD_INPUT, "%s is one of %zu %s: expected one of %zu, as %s is",
                   part->path.text, part->shard.count,
                   po_one_or_more(part->shard.count, "shard", "shards"), first->shard.count,
                   first->path.text);
  if (strcmp(po_record_text(first->root, "program"), po_record_text(part->root, "program")) != 0)
    return po_fail(PO_BAD_INPUT,
                   "%s was computed by another program than %s: expected the same program",
                   part->path.text, first->path.text);
  const char *other = other_case(first, part);
  if (other)
    return po_fail(PO_BAD_INPUT,
                   "%s has other cases than %s: expected the same, but only one has %s",
                   part->path.text, first->path.text, other);
  for (size_t i = 0; i < json_array_size(cases_of(part)); ++i) {
    const json_t *entry = json_array_get(cases_of(part), i);
    if (strcmp(po_record_text(entry, "solve_key"),
               po_record_text(json_array_get(cases_of(first), i), "solve_key")) != 0)
      return refuse_scenes(first, part, po_record_text(entry, "case"));
  }
  return PO_OK;
}

static int by_number(const void *a, const void *b, void *unused) {
  const size_t x = ((const po_merge_part *)a)->shard.number;
  const size_t y = ((const po_merge_part *)b)->shard.number;
  (void)unused;
  return (x > y) - (x < y);
}

/* The message names at most this many missing shards, and states the number of the others. */
static const size_t MOST_NAMED = 10;

static po_status refuse_missing(const po_merge *merge) {
  const size_t of = merge->parts[0].shard.count, count = of - merge->count;
  bool *there = po_allocate(of, sizeof *there);
  if (!there)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < merge->count; ++i)
    there[merge->parts[i].shard.number - 1] = true;
  po_text missing = {0};
  for (size_t number = 1, named = 0; number <= of && named < MOST_NAMED; ++number)
    if (!there[number - 1])
      po_text_add(&missing, "%s%zu/%zu", named++ ? ", " : "", number, of);
  if (count > MOST_NAMED)
    po_text_add(&missing, " and %zu more", count - MOST_NAMED);
  const po_status status =
      po_fail(PO_BAD_INPUT, "%s missing: %s; expected all %zu shards",
              po_one_or_more(count, "a shard is", "shards are"), po_text_string(&missing), of);
  po_text_clear(&missing);
  free(there);
  return status;
}

/* Checks that each shard exists exactly once. */
static po_status check_complete(const po_merge *merge) {
  po_repeat repeat;
  const po_status status = po_order_find_repeat(merge->parts, merge->count, sizeof *merge->parts,
                                                by_number, NULL, &repeat);
  if (status)
    return status;
  if (repeat.found)
    return po_fail(PO_BAD_INPUT, "%s overlaps %s: expected each shard once",
                   merge->parts[repeat.again].path.text, merge->parts[repeat.first].path.text);
  return merge->count < merge->parts[0].shard.count ? refuse_missing(merge) : PO_OK;
}

/* Reads what the cases and their time limit were, which all shards have in common. */
static po_status take_request(po_merge *merge) {
  const json_t *cases = cases_of(&merge->parts[0]);
  merge->time_limit = po_json_read_number(merge->parts[0].root, "time_limit");
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
    status = check_part(&merge->parts[0], &merge->parts[i]);
  if (!status)
    status = check_complete(merge);
  return status ? status : take_request(merge);
}

void po_merge_close(po_merge *merge) {
  for (size_t i = 0; i < merge->count; ++i)
    json_decref(merge->parts[i].root);
  free(merge->parts);
  free(merge->cases);
  *merge = (po_merge){0};
}

/* Checks that the shards were computed by this program, for the scenes of these cases. */
static po_status check_runs(const po_merge_part *first, const po_case_run *runs, size_t count) {
  if (strcmp(po_record_text(first->root, "program"), runs[0].plan->program) != 0)
    return po_fail(
        PO_BAD_INPUT,
        "%s was computed by another program: expected the program that merges the shards",
        first->path.text);
  for (size_t r = 0; r < count; ++r) {
    const json_t *entry = json_array_get(cases_of(first), r);
    if (strcmp(po_record_text(entry, "case"), runs[r].plan->kase->file->name) != 0 ||
        strcmp(po_record_text(entry, "solve_key"), runs[r].plan->solve_key) != 0)
      return po_fail(PO_BAD_INPUT, "%s has other scenes of case %s than %s: expected the same",
                     first->path.text, po_record_text(entry, "case"), runs[r].plan->kase->shown);
  }
  return PO_OK;
}

/* Reads the points from the journal, and those that it lacks from a record: a shard that solved all
 * points of a case has a record in place of a journal. */
static po_status read_results(po_case_run *run, const char *output) {
  const po_file_path folder = po_path_join(output, run->plan->kase->file->name);
  po_status status = po_journal_read(run, folder.text);
  if (!status && po_case_run_lacking(run))
    status = po_record_read(run, folder.text);
  run->kept = run->finished = false;
  run->old_key[0] = '\0';
  return status == PO_NOT_FOUND ? PO_OK : status;
}

/* Reads the points that belong to a shard. Other points in its folder are ignored. */
static po_status read_points(const po_merge_part *part, po_case_run *run) {
  const po_status status = read_results(run, part->folder);
  const size_t lacking = po_case_run_lacking(run);
  if (!status && lacking)
    return po_fail(PO_CANNOT_READ,
                   "%s lacks %zu of %zu %s of %s%s: expected the complete shard %zu/%zu; run it "
                   "again",
                   part->folder, lacking, run->asked_count,
                   po_one_or_more(run->asked_count, "point", "points"), run->plan->kase->file->name,
                   run->altered ? ", whose stored results were altered" : "", part->shard.number,
                   part->shard.count);
  if (!status && run->damaged)
    return po_fail(PO_CANNOT_READ, "%s: the record of %s was altered: run the shard again",
                   part->folder, run->plan->kase->file->name);
  if (!status && run->points[0].asked) {
    json_decref(run->environment);
    run->environment = json_incref(json_object_get(part->root, "environment"));
  }
  return status;
}

po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count) {
  po_status status = check_runs(&merge->parts[0], runs, count);
  for (size_t p = 0; !status && p < merge->count; ++p) {
    const po_merge_part *part = &merge->parts[p];
    status = po_shard_deal(runs, count, part->shard);
    for (size_t r = 0; !status && r < count; ++r)
      if (runs[r].asked_count)
        status = read_points(part, &runs[r]);
  }
  for (size_t r = 0; r < count; ++r) {
    const size_t points = runs[r].plan->kase->point_count;
    po_case_run_ask(&runs[r], &(po_point_range){0, points}, 1);
    runs[r].elapsed = 0;
    for (size_t i = 0; i < points; ++i) {
      const double seconds = runs[r].points[i].result.work.seconds;
      runs[r].elapsed += isnan(seconds) ? 0 : seconds; /* of an external solver, not reported */
    }
  }
  return status;
}
