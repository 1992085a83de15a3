/* Scenes drawn at random: the section `sample` of a case. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_elementary.h"
#include "po_random.h"
#include "po_range.h"
#include "po_schema.h"

enum { GROUPS = PO_KEY_END - PO_KEY_COUNT };

static const char ROOT_RADIUS[] = "root_radius";

/* Whether a key is drawn, directly or by a group. */
static bool draws(const po_draw *draw, po_key key) {
  const int drawn = po_key_of_name(draw->key);
  return drawn == (int)key || (drawn >= 0 && po_key_target((po_key)drawn) == key);
}

bool po_case_draws(const po_case_file *file, po_key key) {
  for (unsigned i = 0; file->sample && i < file->sample->keys_count; ++i)
    if (draws(&file->sample->keys[i], key))
      return true;
  return false;
}

static bool is_swept(const po_case_file *file, po_key key) {
  for (unsigned i = 0; i < file->sweep_count; ++i)
    if (po_sweep_varies(&file->sweep[i], key))
      return true;
  return false;
}

/* Reports whether the value of a key is a number, and neither a name nor a count. */
static bool is_quantity(po_key key) {
  return key != PO_KEY_NODES && po_key_is_number(key);
}

static po_status parse_key(const po_case_file *file, unsigned index, const char *where,
                           const po_yaml *yaml) {
  po_draw *draw = &file->sample->keys[index];
  const int key = po_key_of_name(draw->key);
  if (key < 0 || !is_quantity((po_key)key))
    return po_case_refuse_key(yaml, "a key of the scene whose value is a number, and not a count",
                              is_quantity, where);
  for (unsigned k = 0; k < index; ++k)
    if (strcmp(file->sample->keys[k].key, draw->key) == 0)
      return po_schema_refuse(yaml, "each key drawn once", "%s.key", where);
  if (file->scene.values[key] || is_swept(file, (po_key)key))
    return po_schema_refuse(yaml, "a key that neither scene nor sweep gives", "%s.key", where);
  draw->drawn = (po_key)key;
  return PO_OK;
}

static po_status parse_range(po_draw *draw, const char *where, const po_yaml *yaml) {
  po_request any = po_request_default();
  if (draw->scale && !po_range_read_scale(draw->scale, &draw->log))
    return po_schema_refuse(yaml, NULL, "%s.scale", where);
  if (!po_number_parse(draw->from_text, &draw->from) ||
      !po_key_set(&any, draw->drawn, draw->from_text))
    return po_schema_refuse(yaml, po_key_expected(draw->drawn), "%s.from", where);
  if (draw->log && draw->from <= 0)
    return po_schema_refuse(yaml, "a finite number > 0, as the scale is log", "%s.from", where);
  if (!po_number_parse(draw->to_text, &draw->to) || draw->to <= draw->from)
    return po_schema_refuse(yaml, NULL, "%s.to", where);
  return PO_OK;
}

/* The value of the unit must be known when the number is drawn: the scene, the sweep or an earlier
 * item of the sample gives it. */
static po_status parse_unit(const po_case_file *file, unsigned index, const char *where,
                            const po_yaml *yaml) {
  po_draw *draw = &file->sample->keys[index];
  if (!draw->times)
    return PO_OK;
  draw->by_root = strcmp(draw->times, ROOT_RADIUS) == 0;
  const int unit = draw->by_root ? PO_KEY_RADIUS : po_key_of_name(draw->times);
  bool known =
      unit >= 0 && is_quantity((po_key)unit) && (file->scene.values[unit] || is_swept(file, unit));
  for (unsigned k = 0; k < index; ++k)
    known = known || (int)file->sample->keys[k].drawn == unit;
  if (!known)
    return po_schema_refuse(yaml, NULL, "%s.times", where);
  draw->unit = (po_key)unit;
  return PO_OK;
}

po_status po_case_sample_parse(po_case *kase, const po_yaml *yaml) {
  po_sample_words *sample = kase->file->sample;
  if (!sample)
    return PO_OK;
  size_t seed = 0;
  if (!po_number_parse_count(sample->seed_text, &seed))
    return po_schema_refuse(yaml, NULL, "sample.seed");
  if (!po_number_parse_count(sample->count_text, &sample->count) || sample->count < 1)
    return po_schema_refuse(yaml, NULL, "sample.count");
  sample->seed = seed;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < sample->keys_count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "sample.keys[%u]", i + 1);
    status = parse_key(kase->file, i, where, yaml);
    if (!status)
      status = parse_range(&sample->keys[i], where, yaml);
    if (!status)
      status = parse_unit(kase->file, i, where, yaml);
  }
  return status;
}

static double unit_of(const po_draw *draw, const po_request *request) {
  if (!draw->times)
    return 1;
  const double value = po_key_number(request, draw->unit);
  return draw->by_root ? sqrt(value) : value;
}

bool po_case_sample_draw(const po_case_file *file, size_t index, po_request *request,
                         po_text *label) {
  bool possible = true;
  char group[GROUPS][PO_NUMBER_LENGTH] = {""};
  for (unsigned i = 0; file->sample && i < file->sample->keys_count; ++i) {
    const po_draw *draw = &file->sample->keys[i];
    const double part = po_random_uniform(file->sample->seed, index, draw->key);
    const double value = draw->log ? draw->from * po_exp(part * po_log(draw->to / draw->from))
                                   : draw->from + part * (draw->to - draw->from);
    char text[PO_NUMBER_LENGTH];
    po_range_round(value * unit_of(draw, request), text);
    possible = po_key_set(request, draw->drawn, text) && possible;
    po_text_add(label, "%s%s=%s", label->length ? " " : "", draw->key, text);
    if (po_key_is_group(draw->drawn))
      memcpy(group[draw->drawn - PO_KEY_COUNT], text, sizeof text);
  }
  for (int i = 0; i < GROUPS; ++i) /* again, after all keys that the groups depend on */
    possible =
        (!*group[i] || po_key_set(request, (po_key)(PO_KEY_COUNT + i), group[i])) && possible;
  return possible;
}
