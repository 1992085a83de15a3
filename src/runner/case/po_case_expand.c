#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_elementary.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_quote.h"
#include "po_random.h"
#include "po_range.h"
#include "po_text.h"

/* A case with more points than this is assumed to be a mistake. */
static const size_t MOST_POINTS = 100000;

enum { GROUPS = PO_KEY_END - PO_KEY_COUNT };

/* The section `sweep` of a case. */

const char *po_case_sweep_word(const po_sweep *sweep) {
  return sweep->table ? "table" : sweep->together ? "together" : "key";
}

/* Returned: the number of settings of an item of a sweep. */
static unsigned count_of_sweep(const po_sweep *sweep) {
  return sweep->together ? sweep->together_count : sweep->axis.values_count;
}

/* Returned: the value of a key or a group in setting number `index` of an item; NULL: the setting
 * does not contain it. */
static const char *value_of_sweep(const po_sweep *sweep, unsigned index, po_key key) {
  if (sweep->together)
    return sweep->together[index].values[key];
  return strcmp(PO_KEYS[key].name, sweep->axis.key) == 0 ? sweep->axis.values[index] : NULL;
}

/* The setting of an item of the sweep in combination number `index` of sample and sweep: the last
 * item varies fastest. */
static unsigned setting_of(const po_case_file *file, size_t index, unsigned item) {
  for (unsigned i = file->sweep_count; --i > item;)
    index /= count_of_sweep(&file->sweep[i]);
  return (unsigned)(index % count_of_sweep(&file->sweep[item]));
}

const char *po_case_swept_text(const po_case *kase, const po_point *point, unsigned item,
                               po_key key) {
  return value_of_sweep(&kase->file->sweep[item], setting_of(kase->file, point->setting, item),
                        key);
}

/* Adds a key, and that which it sets if it is a group. Of one in SI units, all of the block
 * follows. */
static void add_varied_by(po_key key, po_keys *keys) {
  keys->has[key] = true;
  keys->has[po_case_is_in_si(key) ? key : po_key_target(key)] = true;
}

static void add_keys(const po_keys *from, po_keys *to) {
  for (int key = 0; key < PO_KEY_VARIABLES; ++key)
    to->has[key] = to->has[key] || from->has[key];
}

static void find_names(po_sweep *sweep) {
  for (unsigned i = 0; i < count_of_sweep(sweep); ++i)
    for (int key = 0; key < PO_KEY_VARIABLES; ++key)
      if (value_of_sweep(sweep, i, key)) {
        sweep->named.has[key] = true;
        add_varied_by(key, &sweep->varied);
      }
}

/* Numbers are compared by value: 1 and 1.0 are the same. */
static int by_value(const char *p, const char *q) {
  double x = 0, y = 0;
  return po_number_parse(p, &x) && po_number_parse(q, &y) ? (x > y) - (x < y) : strcmp(p, q);
}

static int by_settings(const void *a, const void *b, void *unused) {
  const po_scene_words *x = a, *y = b;
  int order = 0;
  (void)unused;
  for (int key = 0; key < PO_KEY_VARIABLES && !order; ++key) {
    const char *p = x->values[key], *q = y->values[key];
    order = p && q ? by_value(p, q) : (p != NULL) - (q != NULL);
  }
  return order;
}

/* Refuses a setting, or the value of a key in it; of a table with its row. Given: key -1: the
 * setting. */
static po_status refuse_setting(const po_sweep *sweep, size_t index, int key, const char *expected,
                                const char *where, const po_yaml *yaml) {
  char shown[PO_QUOTE_LENGTH];
  if (sweep->table && key >= 0)
    return po_fail(PO_BAD_INPUT, "%s: %s in row %zu is %s: expected %s", sweep->table,
                   PO_KEYS[key].name, index + 1,
                   po_quote(sweep->together[index].values[key], shown), expected);
  if (sweep->table)
    return po_fail(PO_BAD_INPUT, "%s: row %zu: expected %s", sweep->table, index + 1, expected);
  return key >= 0 ? po_fields_refuse(yaml, expected, "%s.together[%zu].%s", where, index + 1,
                                     PO_KEYS[key].name)
                  : po_fields_refuse(yaml, expected, "%s.together[%zu]", where, index + 1);
}

static po_status check_together(const po_sweep *sweep, const char *where, const po_yaml *yaml) {
  for (unsigned i = 0; i < sweep->together_count; ++i) {
    const po_scene_words *words = &sweep->together[i];
    po_request request = po_request_default();
    unsigned given = 0;
    for (int key = 0; key < PO_KEY_VARIABLES; ++key) {
      given += words->values[key] != NULL;
      if (words->values[key] && !po_key_set(&request, key, words->values[key]))
        return refuse_setting(sweep, i, key, PO_KEYS[key].expected, where, yaml);
    }
    if (!given)
      return refuse_setting(sweep, i, -1, "keys of the scene", where, yaml);
  }
  po_repeat repeat;
  const po_status status = po_order_find_repeat(
      sweep->together, sweep->together_count, sizeof *sweep->together, by_settings, NULL, &repeat);
  if (!status && repeat.found)
    return refuse_setting(sweep, repeat.again, -1, "each setting once", where, yaml);
  return status;
}

/* Checks the form and the values of one item. */
static po_status check_item(po_sweep *sweep, const char *where, const po_yaml *yaml) {
  po_axis *axis = &sweep->axis;
  const bool ranged = axis->from_text || axis->to_text || axis->count_text || axis->scale;
  if (sweep->together && !axis->key && !axis->values && !ranged)
    return check_together(sweep, where, yaml);
  if (sweep->together)
    return po_fields_refuse(yaml, "key and values, or together alone", "%s.together", where);
  if (!axis->key)
    return po_case_refuse_key(yaml, "a key of the scene", NULL, where);
  const po_status status = po_axis_fill(axis, where, yaml);
  return status ? status : po_case_axis_check(NULL, axis, where, yaml);
}

/* A case may vary one of these groups: amplitude and wavelength would have to be computed from both
 * at once. */
static bool have_group(const po_keys *keys) {
  return keys->has[PO_KEY_ALPHA] || keys->has[PO_KEY_AMPLITUDE_RATIO];
}
static const char ONE_GROUP[] = "one of alpha and amplitude_ratio";

/* Checks that keys in SI units are varied beside the block `physical`, which does not give them. */
static po_status check_in_si(const po_case_file *file, const po_sweep *sweep, const char *where,
                             const po_yaml *yaml) {
  const po_scene_words *physical = file->scene.physical;
  for (int key = PO_KEY_END; key < PO_KEY_VARIABLES; ++key) {
    if (!sweep->varied.has[key])
      continue;
    const char *expected = !po_case_is_in_si(key) ? "a key of the scene"
                           : !physical            ? "it beside scene.physical, as it is in SI units"
                           : physical->values[key] ? "a key that scene.physical does not give"
                           : file->swept.has[key]  ? "each key swept once"
                                                   : NULL;
    if (expected)
      return po_fields_refuse(yaml, expected, "%s.%s", where, po_case_sweep_word(sweep));
  }
  return PO_OK;
}

static po_status check_sweep(po_case *kase, const po_yaml *yaml) {
  po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->sweep_count; ++i) {
    po_sweep *sweep = &file->sweep[i];
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "sweep[%u]", i + 1);
    po_status status = sweep->table ? po_case_table_read(kase, sweep, where, yaml) : PO_OK;
    if (!status)
      status = po_case_uncertain_sweep(kase, i, where, yaml);
    if (!status)
      status = check_item(sweep, where, yaml);
    if (status)
      return status;
    find_names(sweep);
    status = check_in_si(file, sweep, where, yaml);
    if (status)
      return status;
    if (have_group(&sweep->named) && have_group(&file->swept))
      return po_fields_refuse(yaml, ONE_GROUP, "%s.key", where);
    for (int key = 0; key < PO_KEY_COUNT; ++key) {
      const bool twice = file->swept.has[key];
      if (sweep->varied.has[key] && (twice || file->scene.values[key]))
        return po_fields_refuse(
            yaml, twice ? "each key swept once" : "a key that the scene does not give", "%s.%s",
            where, po_case_sweep_word(sweep));
    }
    add_keys(&sweep->varied, &file->swept);
  }
  return PO_OK;
}

static po_status count_points(po_case *kase, const po_yaml *yaml) {
  const po_sample_words *sample = kase->file->sample;
  size_t count = 1;
  if (sample && sample->count > MOST_POINTS)
    return po_fields_refuse(yaml, NULL, "sample.count");
  for (unsigned i = 0; i < kase->file->sweep_count; ++i) {
    count *= count_of_sweep(&kase->file->sweep[i]);
    if (count > MOST_POINTS)
      return po_fail(PO_BAD_INPUT, "%s:%zu: sweep has more than %zu points: expected fewer",
                     yaml->name, po_yaml_line(yaml, "sweep"), MOST_POINTS);
  }
  if (sample && (count *= sample->count) > MOST_POINTS)
    return po_fail(PO_BAD_INPUT,
                   "%s:%zu: sample and sweep make more than %zu points: expected fewer", yaml->name,
                   po_yaml_line(yaml, "sample.count"), MOST_POINTS);
  kase->point_count = count;
  kase->points = po_allocate(count, sizeof *kase->points);
  return kase->points ? PO_OK : PO_NO_MEMORY;
}

/* Sets the keys of a point to the values of one setting of an item of the sweep. A group is set
 * later, when the keys that it depends on have their values. */
static void add_setting(const po_case *kase, po_point *point, const po_sweep *sweep,
                        unsigned setting, po_text *label) {
  for (int key = 0; key < PO_KEY_VARIABLES; ++key) {
    const char *value = value_of_sweep(sweep, setting, key);
    if (!value)
      continue;
    if (key < PO_KEY_COUNT)
      po_key_set(&point->request, key, value);
    const char *material = key == PO_KEY_VISCOELASTIC ? po_creep_file_of(value) : NULL;
    const char *file = key == PO_KEY_PROFILE_FILE ? value : material;
    po_text_add(label, "%s%s=%s%s", label->length ? " " : "", PO_KEYS[key].name,
                material ? "prony:" : "", file ? po_case_profile_shown(kase, file) : value);
  }
}

/* Scenes drawn at random: the section `sample` of a case. */

static const char ROOT_RADIUS[] = "root_radius";

/* Reports whether the value of a key is a number, and neither a name nor a count. */
static bool is_quantity(po_key key) {
  return key != PO_KEY_NODES && po_key_is_number(key);
}

static po_status parse_key(po_case_file *file, unsigned index, const char *where,
                           const po_yaml *yaml) {
  po_draw *draw = &file->sample->keys[index];
  const int key = po_key_of_name(draw->key);
  if (key < 0 || !is_quantity(key))
    return po_case_refuse_key(yaml, "a key of the scene whose value is a number, and not a count",
                              is_quantity, where);
  const po_key target = po_key_target(key);
  if (file->drawn.has[target])
    return po_fields_refuse(yaml, "each key drawn once", "%s.key", where);
  if (file->scene.values[key] || file->scene.values[target] || file->swept.has[target])
    return po_fields_refuse(yaml, "a key that neither scene nor sweep gives", "%s.key", where);
  if ((key == PO_KEY_ALPHA || key == PO_KEY_AMPLITUDE_RATIO) &&
      (have_group(&file->swept) || have_group(&file->drawn)))
    return po_fields_refuse(yaml, ONE_GROUP, "%s.key", where);
  draw->drawn = key;
  add_varied_by(key, &file->drawn);
  return PO_OK;
}

static const char WITHOUT_UNCERTAINTY[] =
    "a number without uncertainty, as scenes are drawn between from and to; other numbers of the "
    "scene may have one";

static po_status parse_range(po_draw *draw, const char *where, const po_yaml *yaml) {
  po_request any = po_request_default();
  const bool from = strstr(draw->from_text, "+-") != NULL;
  if (from || strstr(draw->to_text, "+-"))
    return po_fields_refuse(yaml, WITHOUT_UNCERTAINTY, "%s.%s", where, from ? "from" : "to");
  if (draw->scale && !po_range_read_scale(draw->scale, &draw->log))
    return po_fields_refuse(yaml, NULL, "%s.scale", where);
  if (!po_number_parse(draw->from_text, &draw->from) ||
      !po_key_set(&any, draw->drawn, draw->from_text))
    return po_fields_refuse(yaml, PO_KEYS[draw->drawn].expected, "%s.from", where);
  if (draw->log && draw->from <= 0)
    return po_fields_refuse(yaml, "a finite number > 0, as the scale is log", "%s.from", where);
  if (!po_number_parse(draw->to_text, &draw->to) || draw->to <= draw->from)
    return po_fields_refuse(yaml, NULL, "%s.to", where);
  return PO_OK;
}

/* The value of the unit must be known when the number is drawn: the scene, the sweep or an earlier
 * item of the sample gives it by itself, because groups are read after the draw. */
static po_status parse_unit(const po_case_file *file, unsigned index, const char *where,
                            const po_yaml *yaml) {
  po_draw *draw = &file->sample->keys[index];
  if (!draw->times)
    return PO_OK;
  draw->by_root = strcmp(draw->times, ROOT_RADIUS) == 0;
  const int unit = draw->by_root ? PO_KEY_RADIUS : po_key_of_name(draw->times);
  const bool is_key = unit >= 0 && is_quantity(unit) && !po_key_is_group(unit);
  bool known = is_key && file->scene.values[unit];
  for (unsigned k = 0; is_key && k < file->sweep_count; ++k)
    known = known || file->sweep[k].named.has[unit];
  for (unsigned k = 0; is_key && k < index; ++k)
    known = known || file->sample->keys[k].drawn == unit;
  if (!known)
    return po_fields_refuse(yaml, NULL, "%s.times", where);
  draw->unit = unit;
  return PO_OK;
}

static po_status parse_sample(po_case_file *file, const po_yaml *yaml) {
  po_sample_words *sample = file->sample;
  if (!sample)
    return PO_OK;
  size_t seed = 0;
  if (!po_number_parse_count(sample->seed_text, &seed))
    return po_fields_refuse(yaml, NULL, "sample.seed");
  if (!po_number_parse_count(sample->count_text, &sample->count) || sample->count < 1)
    return po_fields_refuse(yaml, NULL, "sample.count");
  sample->seed = seed;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < sample->keys_count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "sample.keys[%u]", i + 1);
    status = parse_key(file, i, where, yaml);
    if (!status)
      status = parse_range(&sample->keys[i], where, yaml);
    if (!status)
      status = parse_unit(file, i, where, yaml);
  }
  return status;
}

po_status po_case_sweep_parse(po_case *kase, const po_yaml *yaml) {
  po_case_file *file = kase->file;
  po_status status = check_sweep(kase, yaml);
  if (!status)
    status = parse_sample(file, yaml);
  file->varied = file->swept;
  add_keys(&file->drawn, &file->varied);
  return status;
}

static double unit_of(const po_draw *draw, const po_request *request) {
  if (!draw->times)
    return 1;
  const double value = po_key_number(request, draw->unit);
  return draw->by_root ? sqrt(value) : value;
}

/* Draws the values of scene number `index` and stores them in `request`, which already holds the
 * values of scene and sweep; adds them to the label. Returned: false if a drawn value is not
 * possible for its key. */
static bool case_sample_draw(const po_case_file *file, size_t index, po_request *request,
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
    possible = (!*group[i] || po_key_set(request, PO_KEY_COUNT + i, group[i])) && possible;
  return possible;
}

po_status po_case_make_request(const po_case *kase, const po_yaml *yaml, bool changed,
                               po_point *point, po_text *label) {
  const po_case_file *file = kase->file;
  point->request = po_input_default();
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (file->scene.values[key])
      po_key_set(&point->request, key, file->scene.values[key]);
  point->request.units = kase->units;
  if (kase->varies_units || (changed && kase->is_physical)) {
    const po_status status = po_case_scene_set_physical(kase, yaml, point);
    if (status)
      return status;
  }
  const size_t block = kase->point_count / (file->sample ? file->sample->count : 1);
  const size_t scene = point->setting / block;
  const char *group[GROUPS];
  for (int i = 0; i < GROUPS; ++i)
    group[i] = file->scene.values[PO_KEY_COUNT + i];
  for (unsigned i = 0; i < file->sweep_count; ++i) {
    const po_sweep *sweep = &file->sweep[i];
    const unsigned setting = setting_of(file, point->setting, i);
    for (int key = PO_KEY_COUNT; key < PO_KEY_END; ++key)
      if (value_of_sweep(sweep, setting, key))
        group[key - PO_KEY_COUNT] = value_of_sweep(sweep, setting, key);
    add_setting(kase, point, sweep, setting, label);
  }
  bool possible = case_sample_draw(file, scene, &point->request, label);
  for (int i = 0; i < GROUPS; ++i) /* after the keys that the groups depend on */
    possible = (!group[i] || po_key_set(&point->request, PO_KEY_COUNT + i, group[i])) && possible;
  if (!label->length)
    po_text_add(label, "scene");
  if (label->failed)
    return PO_NO_MEMORY;
  return possible ? PO_OK
                  : po_fail(PO_BAD_INPUT,
                            "%s:%zu: sample draws %s: expected permitted values of these keys",
                            yaml->name, po_yaml_line(yaml, "sample.keys"), po_text_string(label));
}

/* Fills point number `index` of the product of sample and sweep. The scene of the sample varies
 * slowest, the last key of the sweep fastest. */
static po_status fill_point(po_case *kase, size_t index, const po_yaml *yaml) {
  po_point *point = &kase->points[index];
  po_text label = {0};
  point->setting = index;
  po_status status = po_case_make_request(kase, yaml, false, point, &label);
  point->label = label.data;
  if (!status)
    status = po_case_uncertain_point(kase, point, yaml);
  if (status || (status = po_request_check(&point->request)) == PO_OK)
    return status;
  return po_fail(PO_BAD_INPUT, "%s:%zu: scene (%s): %s", yaml->name, po_yaml_line(yaml, "scene"),
                 point->label, po_message());
}

static bool is_left_out(po_case_file *file, const po_request *request) {
  bool excluded = false;
  for (unsigned i = 0; i < file->leave_out_count; ++i) {
    po_leave_out *rule = &file->leave_out[i];
    if (po_axes_hold(rule->when, rule->when_count, request)) {
      rule->points += 1;
      excluded = true;
    }
  }
  return excluded;
}

/* Keeps the points that no rule excludes, and numbers them from 0. */
static po_status keep_points(po_case *kase, const po_yaml *yaml) {
  size_t kept = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    po_point *point = &kase->points[i];
    if (is_left_out(kase->file, &point->request)) {
      free(point->label);
      po_case_uncertain_clear(point);
      continue;
    }
    snprintf(point->id, sizeof point->id, "%zu", kept);
    kase->points[kept++] = *point;
  }
  kase->point_count = kept;
  return kept ? PO_OK : po_fields_refuse(yaml, "rules that do not exclude all points", "leave_out");
}

/* Reports whether a point lies between two checkpoints. Checkpoints, and the last scene of a
 * series, are always traced. */
static bool is_between(const po_case *kase, size_t point) {
  const size_t place = point % kase->series_length;
  return place % kase->checkpoints != 0 && place + 1 != kase->series_length;
}

static po_status draw_traced(po_case *kase, const po_yaml *yaml) {
  const po_traced_words *words = kase->file->traced;
  size_t seed = 0, count = 0, between = 0;
  if (!words)
    return PO_OK;
  for (size_t i = 0; i < kase->point_count; ++i)
    between += is_between(kase, i);
  if (!po_number_parse_count(words->seed_text, &seed))
    return po_fields_refuse(yaml, NULL, "traced.seed");
  if (!po_number_parse_count(words->count_text, &count) || count < 1 || count > between)
    return po_fields_refuse(yaml, NULL, "traced.count");
  for (uint64_t draw = 0; count > 0; ++draw) { /* skips checkpoints and repeated scenes */
    const double part = po_random_uniform(seed, draw, "traced");
    const size_t i = (size_t)floor(part * (double)kase->point_count);
    if (!is_between(kase, i) || kase->points[i].traced)
      continue;
    kase->points[i].traced = true;
    count -= 1;
  }
  return PO_OK;
}

po_status po_case_expand(po_case *kase, const po_yaml *yaml) {
  po_status status = count_points(kase, yaml);
  for (size_t i = 0; !status && i < kase->point_count; ++i)
    status = fill_point(kase, i, yaml);
  if (!status)
    status = keep_points(kase, yaml);
  return status ? status : draw_traced(kase, yaml);
}
