#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_schema.h"
#include "po_text.h"

/* A case with more points than this is assumed to be a mistake. */
static const size_t MOST_POINTS = 100000;

enum { GROUPS = PO_KEY_END - PO_KEY_COUNT };

/* The section `sweep` of a case. */

/* Returned: the number of settings of an item of a sweep. */
static unsigned count_of_sweep(const po_sweep *sweep) {
  return sweep->together ? sweep->together_count : sweep->axis.values_count;
}

/* Returned: the value of a key or a group in setting number `index` of an item; NULL: the setting
 * does not contain it. */
static const char *value_of_sweep(const po_sweep *sweep, unsigned index, po_key key) {
  if (sweep->together)
    return sweep->together[index].values[key];
  return po_key_of_name(sweep->axis.key) == (int)key ? sweep->axis.values[index] : NULL;
}

static void find_names(po_sweep *sweep) {
  sweep->named = 0;
  for (unsigned i = 0; i < count_of_sweep(sweep); ++i)
    for (int key = 0; key < PO_KEY_END; ++key)
      if (value_of_sweep(sweep, i, (po_key)key))
        sweep->named |= UINT64_C(1) << key;
}

bool po_sweep_varies(const po_sweep *sweep, po_key key) {
  if (po_sweep_names(sweep, key))
    return true;
  for (int other = 0; other < PO_KEY_END; ++other)
    if (po_key_target((po_key)other) == key && po_sweep_names(sweep, (po_key)other))
      return true;
  return false;
}

static int by_settings(const void *a, const void *b, void *unused) {
  const po_scene_words *x = a, *y = b;
  int order = 0;
  (void)unused;
  for (int key = 0; key < PO_KEY_END && !order; ++key) {
    const char *p = x->values[key], *q = y->values[key];
    order = p && q ? strcmp(p, q) : (p != NULL) - (q != NULL);
  }
  return order;
}

static po_status check_together(const po_sweep *sweep, const char *where, const po_yaml *yaml) {
  for (unsigned i = 0; i < sweep->together_count; ++i) {
    const po_scene_words *words = &sweep->together[i];
    po_request request = po_request_default();
    unsigned given = 0;
    for (int key = 0; key < PO_KEY_END; ++key) {
      given += words->values[key] != NULL;
      if (words->values[key] && !po_key_set(&request, (po_key)key, words->values[key]))
        return po_schema_refuse(yaml, po_key_expected((po_key)key), "%s.together[%u].%s", where,
                                i + 1, po_key_name((po_key)key));
    }
    if (!given)
      return po_schema_refuse(yaml, "keys of the scene", "%s.together[%u]", where, i + 1);
  }
  po_repeat repeat;
  const po_status status = po_order_find_repeat(
      sweep->together, sweep->together_count, sizeof *sweep->together, by_settings, NULL, &repeat);
  if (!status && repeat.found)
    return po_schema_refuse(yaml, "each setting once", "%s.together[%zu]", where, repeat.again + 1);
  return status;
}

/* Checks the form and the values of one item. */
static po_status check_item(po_sweep *sweep, const char *where, const po_yaml *yaml) {
  po_axis *axis = &sweep->axis;
  const bool ranged = axis->from_text || axis->to_text || axis->count_text || axis->scale;
  if (sweep->together && !axis->key && !axis->values && !ranged)
    return check_together(sweep, where, yaml);
  if (sweep->together)
    return po_schema_refuse(yaml, "key and values, or together alone", "%s.together", where);
  if (!axis->key)
    return po_case_refuse_key(yaml, "a key of the scene", NULL, where);
  const po_status status = po_axis_fill(axis, where, yaml);
  return status ? status : po_case_axis_check(axis, where, yaml);
}

/* Reports whether the item varies alpha or amplitude_ratio. A sweep may contain one of them:
 * amplitude and wavelength would have to be computed from both at once. */
static bool has_waviness(const po_sweep *sweep) {
  const int key = sweep->axis.key ? po_key_of_name(sweep->axis.key) : -1;
  return key == PO_KEY_ALPHA || key == PO_KEY_AMPLITUDE_RATIO;
}

po_status po_case_sweep_check(const po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->sweep_count; ++i) {
    po_sweep *sweep = &file->sweep[i];
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "sweep[%u]", i + 1);
    const po_status status = check_item(sweep, where, yaml);
    if (status)
      return status;
    find_names(sweep);
    for (unsigned k = 0; k < i; ++k)
      if (has_waviness(sweep) && has_waviness(&file->sweep[k]))
        return po_schema_refuse(yaml, "one of alpha and amplitude_ratio", "%s.key", where);
    for (int key = 0; key < PO_KEY_COUNT; ++key) {
      bool twice = false;
      if (!po_sweep_varies(sweep, (po_key)key))
        continue;
      for (unsigned k = 0; k < i; ++k)
        twice = twice || po_sweep_varies(&file->sweep[k], (po_key)key);
      if (twice || file->scene.values[key])
        return po_schema_refuse(
            yaml, twice ? "each key swept once" : "a key that the scene does not give", "%s.%s",
            where, sweep->together ? "together" : "key");
    }
  }
  return PO_OK;
}

static po_status count_points(po_case *kase, const po_yaml *yaml) {
  const po_sample_words *sample = kase->file->sample;
  size_t count = 1;
  if (sample && sample->count > MOST_POINTS)
    return po_schema_refuse(yaml, NULL, "sample.count");
  for (unsigned i = 0; i < kase->file->sweep_count; ++i) {
    count *= count_of_sweep(&kase->file->sweep[i]);
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
    const char *value = value_of_sweep(sweep, setting, (po_key)key);
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
    const unsigned settings = count_of_sweep(sweep);
    block /= settings;
    const unsigned setting = (unsigned)(index / block % settings);
    for (int key = PO_KEY_COUNT; key < PO_KEY_END; ++key)
      if (value_of_sweep(sweep, setting, (po_key)key))
        group[key - PO_KEY_COUNT] = value_of_sweep(sweep, setting, (po_key)key);
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
