/* Parts of a result as JSON, and their inverses; one table defines the keys of numbers and counts
 * for both directions. */
#include <stddef.h>

#include "po_json.h"
#include "po_json_parts.h"

/* The key and the offset of a member of a structure. */
typedef struct {
  const char *key;
  size_t offset;
} field;

#define LENGTH(fields) (sizeof(fields) / sizeof *(fields))

static const field SPECIAL_POINT[] = {
    {"approach", offsetof(po_special_point, approach)},
    {"load", offsetof(po_special_point, load)},
    {"energy", offsetof(po_special_point, energy)},
    {"energy_error_estimate", offsetof(po_special_point, energy_error)},
    {"error_estimate", offsetof(po_special_point, approach_error)},
    {"load_error_estimate", offsetof(po_special_point, load_error)},
    {"contact_radius", offsetof(po_special_point, contact_radius)},
    {"contact_radius_error_estimate", offsetof(po_special_point, contact_radius_error)},
    {"contact_radius_other", offsetof(po_special_point, contact_radius_other)},
    {"position", offsetof(po_special_point, position)},
};

static const field PULL_OFF[] = {
    {"force", offsetof(po_result, pull_off.force)},
    {"approach", offsetof(po_result, pull_off.approach)},
    {"contact_radius", offsetof(po_result, pull_off.contact_radius)},
    {"error_estimate", offsetof(po_result, pull_off.force_error)},
    {"approach_error_estimate", offsetof(po_result, pull_off.approach_error)},
    {"contact_radius_error_estimate", offsetof(po_result, pull_off.contact_radius_error)},
    {"contact_radius_other", offsetof(po_result, pull_off.contact_radius_other)},
};

static const field WORK[] = {
    {"points", offsetof(po_work, points)},
    {"newton_iterations", offsetof(po_work, newton_iterations)},
    {"factorizations", offsetof(po_work, factorizations)},
    {"kernel_evaluations", offsetof(po_work, kernel_evaluations)},
    {"nodes", offsetof(po_work, nodes)},
    {"factorized_nodes", offsetof(po_work, factorized_nodes)},
    {"meshes", offsetof(po_work, meshes)},
};

static void write_numbers(json_t **object, const field *fields, size_t count, const void *from) {
  for (size_t i = 0; i < count; ++i) {
    const double *number = (const void *)((const char *)from + fields[i].offset);
    po_json_set(object, fields[i].key, po_json_number(*number));
  }
}

static void read_numbers(const json_t *object, const field *fields, size_t count, void *to) {
  for (size_t i = 0; i < count; ++i) {
    double *number = (void *)((char *)to + fields[i].offset);
    *number = po_json_read_number(object, fields[i].key);
  }
}

json_t *po_json_pressed(const po_pressed *pressed) {
  return PO_JSON_OBJECT({"approach", po_json_number(pressed->approach)},
                        {"load", po_json_number(pressed->load)});
}

po_pressed po_json_read_pressed(const json_t *object) {
  return (po_pressed){po_json_read_number(object, "approach"), po_json_read_number(object, "load")};
}

json_t *po_json_special_point(const po_special_point *special) {
  json_t *object = PO_JSON_OBJECT({"kind", po_json_text(po_special_kind_name(special->kind))});
  write_numbers(&object, SPECIAL_POINT, LENGTH(SPECIAL_POINT), special);
  po_json_set(&object, "unstable_modes", po_json_integer(special->unstable_modes));
  return object;
}

void po_json_read_special_point(const json_t *object, po_special_point *special) {
  read_numbers(object, SPECIAL_POINT, LENGTH(SPECIAL_POINT), special);
  special->unstable_modes = (int)json_integer_value(json_object_get(object, "unstable_modes"));
}

json_t *po_json_pull_off(const po_result *result) {
  if (!result->has_pull_off)
    return json_null();
  json_t *object = po_json_empty_object();
  write_numbers(&object, PULL_OFF, LENGTH(PULL_OFF), result);
  po_json_set(&object, "preload", po_json_pressed(&result->pull_off.pressed));
  po_json_set(&object, "until", po_json_pressed(&result->pull_off.until));
  return object;
}

void po_json_read_pull_off(const json_t *object, po_result *result) {
  result->has_pull_off = json_is_object(object);
  read_numbers(object, PULL_OFF, LENGTH(PULL_OFF), result);
  result->pull_off.pressed = po_json_read_pressed(json_object_get(object, "preload"));
  result->pull_off.until = po_json_read_pressed(json_object_get(object, "until"));
}

json_t *po_json_work(const po_work *work) {
  json_t *object = po_json_empty_object();
  for (size_t i = 0; i < LENGTH(WORK); ++i) {
    const uint64_t *number = (const void *)((const char *)work + WORK[i].offset);
    po_json_set(&object, WORK[i].key, po_json_count(*number));
  }
  po_json_set(&object, "seconds", po_json_number(work->seconds));
  return object;
}

void po_json_read_work(const json_t *object, po_work *work) {
  for (size_t i = 0; i < LENGTH(WORK); ++i) {
    uint64_t *number = (void *)((char *)work + WORK[i].offset);
    *number = po_json_count_of(object, WORK[i].key);
  }
  work->seconds = po_json_read_number(object, "seconds");
}

json_t *po_json_pull_off_any(const po_result *o) {
  if (!o->pull_off_any.is_known)
    return json_null();
  return PO_JSON_OBJECT({"force", po_json_number(o->pull_off_any.force)},
                        {"error_estimate", po_json_number(o->pull_off_any.force_error)},
                        {"approach", po_json_number(o->pull_off_any.approach)},
                        {"approach_error_estimate", po_json_number(o->pull_off_any.approach_error)},
                        {"preload", po_json_pressed(&o->pull_off_any.pressed)},
                        {"complete", po_json_flag(o->pull_off_any.complete)},
                        {"searched", po_json_pressed(&o->pull_off_any.searched)});
}

void po_json_read_pull_off_any(const json_t *object, po_result *o) {
  o->pull_off_any.is_known = json_is_object(object);
  o->pull_off_any.force = po_json_read_number(object, "force");
  o->pull_off_any.force_error = po_json_read_number(object, "error_estimate");
  o->pull_off_any.approach = po_json_read_number(object, "approach");
  o->pull_off_any.approach_error = po_json_read_number(object, "approach_error_estimate");
  o->pull_off_any.pressed = po_json_read_pressed(json_object_get(object, "preload"));
  o->pull_off_any.complete = json_is_true(json_object_get(object, "complete"));
  o->pull_off_any.searched = po_json_read_pressed(json_object_get(object, "searched"));
}
