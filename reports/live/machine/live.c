/* The door of the module: a request in, a document out, both JSON. */
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_initial_gap.h"
#include "po_json_value.h"
#include "po_library.h"
#include "po_memory.h"
#include "po_profile_table.h"
#include "po_range.h"
#include "po_series.h"
#include "po_solve.h"

/* Functions of the page. Progress: a point of the trace, or the number of a scene of a series that
 * is solved. Profile: gap and traction at the point of the curve with this number, in rows of
 * radius, gap, traction and initial gap. */
__attribute__((import_module("page"), import_name("progress"))) void page_progress(double approach,
                                                                                   double load);
__attribute__((import_module("page"), import_name("profile"))) void
page_profile(int number, const double *rows, int count);

static void tell_progress(void *scene, double approach, double load) {
  (void)scene;
  page_progress(approach, load);
}

enum { ROW = 4 }; /* numbers of a row of a profile */

static void tell_profile(void *scene, size_t number, const po_profile_point *profile,
                         size_t count) {
  double *rows = po_allocate(count, ROW * sizeof *rows);
  for (size_t k = 0; rows && k < count; ++k) {
    const po_profile_point *p = &profile[k];
    memcpy(&rows[ROW * k],
           (double[ROW]){p->radius, p->gap, p->traction, po_initial_gap(scene, p->radius)},
           ROW * sizeof *rows);
  }
  if (rows)
    page_profile((int)number, rows, (int)count);
  free(rows);
}

/* The files of the request that is answered, {NAME: TEXT}. */
static json_t *files;

/* Replaces that of po_file.c, which is not in the module. */
po_status po_file_read(const char *path, char **data, size_t *size) {
  const char *text = json_string_value(json_object_get(files, path));
  if (!text)
    return po_fail(PO_CANNOT_READ, "%s is no file of the request", path);
  *size = strlen(text);
  *data = po_copy_text(text);
  return *data ? PO_OK : PO_NO_MEMORY;
}

/* As pulloff_solve, with progress and profiles for the page. */
static pulloff_status solve(const pulloff_scene *scene, pulloff_result **result,
                            pulloff_message *message) {
  po_library_call call;
  po_status status = po_library_enter(&call);
  if (status)
    return po_library_end(status, message);
  po_request request;
  po_result solved = {0};
  status = po_library_request(scene, -1, NULL, &request);
  if (!status) {
    request.watch = tell_progress;
    request.show = tell_profile;
    request.watcher = &request.scene;
    status = po_solve(&request, &solved);
    if (status && !solved.reason[0])
      snprintf(solved.reason, sizeof solved.reason, "%.250s", po_message());
  }
  if (status >= 0) {
    *result = po_library_result(&request, &solved);
    status = *result ? PO_OK : PO_NO_MEMORY;
  } else {
    po_result_clear(&solved);
  }
  return po_library_leave(&call, status, message);
}

static double number_of(const json_t *object, const char *name, double absent) {
  const json_t *value = json_object_get(object, name);
  return json_is_number(value) ? json_number_value(value) : absent;
}

/* Sets the keys of a scene: a text each. */
static pulloff_status set_keys(pulloff_scene *scene, json_t *keys, pulloff_message *message) {
  const char *name;
  json_t *value;
  pulloff_status status = PULLOFF_OK;
  json_object_foreach(keys, name, value) {
    if (!status)
      status = pulloff_scene_set(scene, name, json_string_value(value), message);
  }
  return status;
}

/* The units of the results of a scene in SI units, for the answer. */
static void add_units(const pulloff_scene *scene, json_t **answer) {
  pulloff_units units;
  if (!pulloff_scene_units(scene, &units, NULL))
    po_json_set(answer, "units",
                PO_JSON_OBJECT({"length", po_json_number(units.length)},
                               {"force", po_json_number(units.force)},
                               {"work", po_json_number(units.work)},
                               {"traction", po_json_number(units.traction)}));
}

/* For each theory of a result, its words and those of the assumption that decides. */
static json_t *words_of(const po_result *result) {
  json_t *words = po_json_empty_array();
  for (size_t k = 0; k < result->theory_count; ++k) {
    const po_theory_row *row = &result->theories[k];
    po_json_append(&words,
                   PO_JSON_OBJECT({"theory", po_json_text(PO_THEORIES[row->theory].words)},
                                  {"decided_by", po_json_text(PO_ASSUMPTIONS[row->decided_by])}));
  }
  return words;
}

/* The numbers of one scene of a series. */
static json_t *row_of(double value, const po_result *result) {
  const bool found = result->has_pull_off;
  return PO_JSON_OBJECT(
      {"value", po_json_number(value)}, {"status", po_json_text(po_status_text(result->status))},
      {"force", po_json_number(found ? result->pull_off.force : NAN)},
      {"error_estimate", po_json_number(found ? result->pull_off.force_error : NAN)},
      {"approach", po_json_number(found ? result->pull_off.approach : NAN)});
}

static void tell_scene(void *number, double approach, double load) {
  (void)approach;
  page_progress((double)(size_t)number, load);
}

/* Solves the scenes in which one key varies, as `pulloff follow`. */
static po_status follow_scenes(const pulloff_scene *scene, int key, const po_range *range,
                               po_request *requests, po_result *results, json_t **answer) {
  po_status status = PO_OK;
  char text[PO_NUMBER_LENGTH];
  for (size_t k = 0; k < range->count && !status; ++k) {
    po_range_print(range, k, text);
    status = po_library_request(scene, key, text, &requests[k]);
    requests[k].search = PO_SEARCH_NONE;
    requests[k].watch = tell_scene;
    requests[k].watcher = (void *)k;
  }
  if (!status)
    status = po_series_pull_offs(requests, range->count, PO_CHECKPOINT_EVERY, results);
  json_t *rows = po_json_empty_array();
  for (size_t k = 0; k < range->count && !status; ++k)
    po_json_append(&rows, row_of(po_key_number(&requests[k], (po_key)key), &results[k]));
  if (status)
    json_decref(rows);
  else
    po_json_set(answer, "series", rows);
  if (!status)
    po_json_set(answer, "load_unit", po_json_text(po_input_load_unit(&requests[0])));
  return status;
}

static pulloff_status follow(const json_t *series, const pulloff_scene *scene, json_t **answer,
                             pulloff_message *message) {
  po_library_call call;
  po_status status = po_library_enter(&call);
  if (status)
    return po_library_end(status, message);
  const char *name = json_string_value(json_object_get(series, "key"));
  const int key = name ? po_key_of_name(name) : -1;
  const po_range range = {number_of(series, "from", NAN), number_of(series, "to", NAN),
                          (size_t)number_of(series, "points", 0.0),
                          json_is_true(json_object_get(series, "log"))};
  po_request *requests = po_allocate(range.count, sizeof *requests);
  po_result *results = po_allocate(range.count, sizeof *results);
  if (!requests || !results)
    status = PO_NO_MEMORY;
  else if (!po_key_is_continuous(key))
    status =
        po_fail(PO_BAD_INPUT, "the parameter of a series is %s: expected a number of the scene",
                name ? name : "absent");
  else if (range.count < 2 || !(range.from < range.to) || (range.log && range.from <= 0.0))
    status = po_fail(PO_BAD_INPUT, "%s from %g to %g: expected two values%s, the smaller one first",
                     name, range.from, range.to, range.log ? " > 0" : "");
  else
    status = po_no_memory_or(follow_scenes(scene, key, &range, requests, results, answer));
  for (size_t k = 0; results && k < range.count; ++k)
    po_result_clear(&results[k]);
  free(requests);
  free(results);
  return po_library_leave(&call, status, message);
}

/* Answers a request about one scene. */
static pulloff_status answer_to_scene(const json_t *request, const pulloff_scene *scene,
                                      json_t **answer, pulloff_message *message) {
  const char *theory = json_string_value(json_object_get(request, "theory"));
  pulloff_result *result = NULL;
  const pulloff_status status =
      theory ? pulloff_theory(theory, scene, number_of(request, "alpha", NAN),
                              number_of(request, "at", NAN), &result, message)
             : solve(scene, &result, message);
  if (!status) {
    po_json_set(answer, "document", json_incref(result->document));
    po_json_set(answer, "words", words_of(&result->result));
  }
  pulloff_result_destroy(result);
  return status;
}

/* Answers a request {"keys": {NAME: TEXT}, "files": {NAME: TEXT},
 * "theory": NAME, "alpha": NUMBER, "at": NUMBER, "series": {"key": NAME, "from": NUMBER, "to":
 * NUMBER, "points": NUMBER, "log": BOOLEAN}}, all optional: with neither `theory` nor `series`, the
 * scene is solved. */
static pulloff_status answer_to(const json_t *request, pulloff_scene *scene, json_t **answer,
                                pulloff_message *message) {
  const json_t *series = json_object_get(request, "series");
  files = json_object_get(request, "files");
  po_profile_table_clear(); /* a file may have another content than in the last request */
  const pulloff_status status = set_keys(scene, json_object_get(request, "keys"), message);
  if (status)
    return status;
  add_units(scene, answer);
  return series ? follow(series, scene, answer, message)
                : answer_to_scene(request, scene, answer, message);
}

/* Given: a request, as text. Returned: {"document": ..., "words": ...} or {"series": ...}, with
 * "units" for a scene in SI units; or {"error": MESSAGE}; to be freed. NULL if memory runs out. */
__attribute__((export_name("po_live"))) char *po_live(const char *text) {
  pulloff_message message = {""};
  pulloff_scene *scene = NULL;
  json_t *answer = po_json_empty_object(), *request = NULL;
  pulloff_status status = pulloff_scene_create(&scene, &message);
  if (!status)
    status = (pulloff_status)po_json_parse(text, strlen(text), &request);
  if (status)
    po_library_end((po_status)status, &message);
  else
    status = answer_to(request, scene, &answer, &message);
  if (status) {
    json_decref(answer);
    answer = PO_JSON_OBJECT({"error", po_json_text(message.text)});
  }
  po_text printed = {0};
  po_json_print_line(answer, &printed);
  json_decref(answer);
  json_decref(request);
  pulloff_scene_destroy(scene);
  return printed.data;
}
