#include <stdio.h>
#include <stdlib.h>

#include "po_case_parts.h"
#include "po_memory.h"
#include "po_schema.h"
#include "po_text.h"

/* A case with more points than this is assumed to be a mistake. */
static const size_t MOST_POINTS = 100000;

enum { GROUPS = PO_KEY_END - PO_KEY_COUNT };

static po_status count_points(po_case *kase, const po_yaml *yaml) {
  const po_sample_words *sample = kase->file->sample;
  size_t count = 1;
  if (sample && sample->count > MOST_POINTS)
    return po_schema_refuse(yaml, NULL, "sample.count");
  for (unsigned i = 0; i < kase->file->sweep_count; ++i) {
    count *= po_sweep_count(&kase->file->sweep[i]);
    if (count > MOST_POINTS)
      return po_fail(PO_BAD_INPUT, "%s:%zu: sweep has more than %zu points: expected fewer",
                     po_yaml_name(yaml), po_yaml_line(yaml, "sweep"), MOST_POINTS);
  }
  if (sample && (count *= sample->count) > MOST_POINTS)
    return po_fail(PO_BAD_INPUT,
                   "%s:%zu: sample and sweep make more than %zu points: expected fewer",
                   po_yaml_name(yaml), po_yaml_line(yaml, "sample.count"), MOST_POINTS);
  kase->point_count = count;
  kase->points = po_allocate(count, sizeof *kase->points);
  return kase->points ? PO_OK : PO_NO_MEMORY;
}

/* Sets the keys of a point to the values of one setting of an item of the sweep. A group is set
 * later, when the keys that it depends on have their values. */
static void add_setting(const po_case *kase, po_point *point, const po_sweep *sweep,
                        unsigned setting, po_text *label) {
  for (int key = 0; key < PO_KEY_END; ++key) {
    const char *value = po_sweep_value(sweep, setting, (po_key)key);
    if (!value)
      continue;
    if (!po_key_is_group(key))
      po_key_set(&point->request, (po_key)key, value);
    po_text_add(label, "%s%s=%s", label->length ? " " : "", po_key_name((po_key)key),
                key == PO_KEY_PROFILE_FILE ? po_case_profile_shown(kase, value) : value);
  }
}

/* Fills point number `index` of the product of sample and sweep. The scene of the sample varies
 * slowest, the last key of the sweep fastest. */
static po_status fill_point(const po_case *kase, size_t index, const po_yaml *yaml) {
  po_point *point = &kase->points[index];
  const po_case_file *file = kase->file;
  point->request = po_input_default();
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (file->scene.values[key])
      po_key_set(&point->request, (po_key)key, file->scene.values[key]);
  size_t block = kase->point_count / (file->sample ? file->sample->count : 1);
  const size_t scene = index / block;
  const char *group[GROUPS];
  for (int i = 0; i < GROUPS; ++i)
    group[i] = file->scene.values[PO_KEY_COUNT + i];
  po_text label = {0};
  for (unsigned i = 0; i < file->sweep_count; ++i) {
    const po_sweep *sweep = &file->sweep[i];
    const unsigned settings = po_sweep_count(sweep);
    block /= settings;
    const unsigned setting = (unsigned)(index / block % settings);
    for (int key = PO_KEY_COUNT; key < PO_KEY_END; ++key)
      if (po_sweep_value(sweep, setting, (po_key)key))
        group[key - PO_KEY_COUNT] = po_sweep_value(sweep, setting, (po_key)key);
    add_setting(kase, point, sweep, setting, &label);
  }
  bool possible = po_case_sample_draw(file, scene, &point->request, &label);
  for (int i = 0; i < GROUPS; ++i) /* after the keys that the groups depend on */
    possible = (!group[i] || po_key_set(&point->request, (po_key)(PO_KEY_COUNT + i), group[i])) &&
               possible;
  if (!label.length)
    po_text_add(&label, "scene");
  point->label = label.data;
  if (label.failed)
    return PO_NO_MEMORY;
  if (!possible)
    return po_fail(PO_BAD_INPUT, "%s:%zu: sample draws %s: expected permitted values of these keys",
                   po_yaml_name(yaml), po_yaml_line(yaml, "sample.keys"), point->label);
  if (po_request_check(&point->request) == PO_OK)
    return PO_OK;
  char *why = po_copy_text(po_message());
  const po_status status =
      po_fail(PO_BAD_INPUT, "%s:%zu: scene (%s): %s", po_yaml_name(yaml),
              po_yaml_line(yaml, "scene"), point->label, why ? why : "refused");
  free(why);
  return status;
}

static bool is_left_out(po_case_file *file, const po_request *request) {
  for (unsigned i = 0; i < file->leave_out_count; ++i) {
    po_leave_out *rule = &file->leave_out[i];
    if (po_axes_hold(rule->when, rule->when_count, request)) {
      rule->points += 1;
      return true;
    }
  }
  return false;
}

/* Keeps the points that no rule excludes, and numbers them from 0. */
static po_status keep_points(po_case *kase, const po_yaml *yaml) {
  size_t kept = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    po_point *point = &kase->points[i];
    if (is_left_out(kase->file, &point->request)) {
      free(point->label);
      continue;
    }
    snprintf(point->id, sizeof point->id, "%zu", kept);
    kase->points[kept++] = *point;
  }
  kase->point_count = kept;
  return kept ? PO_OK : po_schema_refuse(yaml, "rules that do not exclude all points", "leave_out");
}

po_status po_case_expand(po_case *kase, const po_yaml *yaml) {
  po_status status = count_points(kase, yaml);
  for (size_t i = 0; !status && i < kase->point_count; ++i)
    status = fill_point(kase, i, yaml);
  return status ? status : keep_points(kase, yaml);
}
