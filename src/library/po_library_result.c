/* Results of the library: typed copies of the points, and the JSON document, which is built when a
 * scene has been solved, so that a result never changes afterwards. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_json.h"
#include "po_library.h"
#include "po_memory.h"
#include "po_quote.h"

static void copy_special_points(const po_special_point *from, size_t count,
                                pulloff_special_point *to) {
  for (size_t i = 0; i < count; ++i)
    to[i] = (pulloff_special_point){.kind = (pulloff_kind)from[i].kind,
                                    .unstable_modes = from[i].unstable_modes,
                                    .approach = from[i].approach,
                                    .approach_error = from[i].approach_error,
                                    .load = from[i].load,
                                    .load_error = from[i].load_error,
                                    .contact_radius = from[i].contact_radius,
                                    .energy = from[i].energy,
                                    .energy_error = from[i].energy_error,
                                    .position = from[i].position};
}

static void copy_curve(const po_curve_point *from, size_t count, pulloff_curve_point *to) {
  for (size_t i = 0; i < count; ++i)
    to[i] = (pulloff_curve_point){.position = from[i].position,
                                  .approach = from[i].approach,
                                  .load = from[i].load,
                                  .energy = from[i].energy,
                                  .energy_error = from[i].energy_error,
                                  .contact_radius = from[i].contact_radius,
                                  .approach_rate = from[i].approach_rate,
                                  .load_rate = from[i].load_rate,
                                  .unstable_modes = from[i].unstable_modes};
}

static void copy_profile(const po_profile_point *from, size_t count, pulloff_profile_point *to) {
  for (size_t i = 0; i < count; ++i)
    to[i] = (pulloff_profile_point){from[i].radius, from[i].gap, from[i].traction};
}

pulloff_result *po_library_result(const po_request *request, po_result *solved) {
  pulloff_result *r = po_allocate(1, sizeof *r);
  if (!r) {
    po_result_clear(solved);
    return NULL;
  }
  r->request = *request;
  r->result = *solved;
  *solved = po_result_none();
  const po_result *o = &r->result;
  r->folds = po_allocate(o->fold_count, sizeof *r->folds);
  r->extrema = po_allocate(o->extremum_count, sizeof *r->extrema);
  r->curve = po_allocate(o->curve_count, sizeof *r->curve);
  r->profile = po_allocate(o->profile_count, sizeof *r->profile);
  r->document = po_json_document(request, o);
  if (!r->folds || !r->extrema || !r->curve || !r->profile || !r->document) {
    pulloff_result_destroy(r);
    po_fail(PO_NO_MEMORY, "out of memory for the result of a solve");
    return NULL;
  }
  copy_special_points(o->folds, o->fold_count, r->folds);
  copy_special_points(o->extrema, o->extremum_count, r->extrema);
  copy_curve(o->curve, o->curve_count, r->curve);
  copy_profile(o->profile, o->profile_count, r->profile);
  return r;
}

void pulloff_result_destroy(pulloff_result *result) {
  if (!result)
    return;
  po_result_clear(&result->result);
  free(result->folds);
  free(result->extrema);
  free(result->curve);
  free(result->profile);
  json_decref(result->document);
  free(result);
}

pulloff_status pulloff_result_status(const pulloff_result *result) {
  return (pulloff_status)result->result.status;
}

const char *pulloff_result_reason(const pulloff_result *result) {
  return result->result.reason;
}

bool pulloff_result_pull_off(const pulloff_result *result, pulloff_pull_off *pull_off) {
  const po_result *o = &result->result;
  if (o->has_pull_off)
    *pull_off = (pulloff_pull_off){.force = o->pull_off.force,
                                   .force_error = o->pull_off.force_error,
                                   .approach = o->pull_off.approach,
                                   .approach_error = o->pull_off.approach_error,
                                   .contact_radius = o->pull_off.contact_radius,
                                   .contact_radius_error = o->pull_off.contact_radius_error};
  return o->has_pull_off;
}

const pulloff_special_point *pulloff_result_folds(const pulloff_result *result, size_t *count) {
  *count = result->result.fold_count;
  return *count ? result->folds : NULL;
}

const pulloff_special_point *pulloff_result_extrema(const pulloff_result *result, size_t *count) {
  *count = result->result.extremum_count;
  return *count ? result->extrema : NULL;
}

const pulloff_curve_point *pulloff_result_curve(const pulloff_result *result, size_t *count) {
  *count = result->result.curve_count;
  return *count ? result->curve : NULL;
}

const pulloff_profile_point *pulloff_result_profile(const pulloff_result *result, size_t *count) {
  *count = result->result.profile_count;
  return *count ? result->profile : NULL;
}

/* The member of an object, or of an array, whose name or number is the first `length` characters of
 * `name`; NULL if there is none. */
static const json_t *member(const json_t *value, const char *name, size_t length) {
  char part[80], *end;
  if (length >= sizeof part)
    return NULL;
  memcpy(part, name, length);
  part[length] = '\0';
  if (!json_is_array(value))
    return json_object_get(value, part);
  const unsigned long long index = strtoull(part, &end, 10);
  return *part >= '0' && *part <= '9' && !*end ? json_array_get(value, (size_t)index) : NULL;
}

/* The value at a path, names with points between; NULL if there is none. */
static const json_t *find(const json_t *value, const char *path) {
  while (value) {
    const size_t length = strcspn(path, ".");
    value = member(value, path, length);
    if (!path[length])
      break;
    path += length + 1;
  }
  return value;
}

static po_status refuse(const char *path, const char *expected) {
  char shown[PO_QUOTE_LENGTH];
  return po_fail(PO_NOT_FOUND, "the result has no %s %s", expected, po_quote(path, shown));
}

/* A number; NAN for null, which stands for NaN and infinities; INFINITY for "inf". */
static bool number_of(const json_t *item, double *value) {
  const char *text = json_string_value(item);
  if (!json_is_number(item) && !json_is_null(item) && !(text && strcmp(text, "inf") == 0))
    return false;
  *value = json_is_number(item) ? json_number_value(item) : text ? (double)INFINITY : (double)NAN;
  return true;
}

pulloff_status pulloff_result_number(const pulloff_result *result, const char *path, double *value,
                                     pulloff_message *message) {
  const bool found = number_of(find(result->document, path), value);
  return po_library_end(found ? PO_OK : refuse(path, "number"), message);
}

pulloff_status pulloff_result_text(const pulloff_result *result, const char *path,
                                   const char **text, pulloff_message *message) {
  const char *found = json_string_value(find(result->document, path));
  if (found)
    *text = found;
  return po_library_end(found ? PO_OK : refuse(path, "text"), message);
}

pulloff_status pulloff_result_count(const pulloff_result *result, const char *path, size_t *count,
                                    pulloff_message *message) {
  const json_t *array = find(result->document, path);
  if (json_is_array(array))
    *count = json_array_size(array);
  return po_library_end(json_is_array(array) ? PO_OK : refuse(path, "array"), message);
}

pulloff_status pulloff_result_column(const pulloff_result *result, const char *path,
                                     const char *name, double *values, size_t count,
                                     pulloff_message *message) {
  const json_t *array = find(result->document, path);
  if (!json_is_array(array) || json_array_size(array) != count)
    return po_library_end(
        json_is_array(array)
            ? po_fail(PO_NOT_FOUND, "%zu numbers are asked for: expected %zu, the count of %.80s",
                      count, json_array_size(array), path)
            : refuse(path, "array"),
        message);
  for (size_t i = 0; i < count; ++i)
    if (!number_of(json_object_get(json_array_get(array, i), name), &values[i]))
      return po_library_end(refuse(name, "column"), message);
  return po_library_end(PO_OK, message);
}

static po_status print(const json_t *document, char **text) {
  po_text printed = {0};
  const po_status status = po_json_print(document, &printed);
  *text = po_text_take(&printed);
  return status;
}

pulloff_status pulloff_result_json(const pulloff_result *result, char **text,
                                   pulloff_message *message) {
  *text = NULL;
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : print(result->document, text), message);
}

void pulloff_free(char *text) {
  free(text);
}

bool pulloff_result_units(const pulloff_result *result, pulloff_units *units) {
  if (result->request.in_si)
    *units = po_library_units(&result->request);
  return result->request.in_si;
}
