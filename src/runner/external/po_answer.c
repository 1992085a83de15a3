#include "po_answer.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_elementary.h"
#include "po_json_value.h"
#include "po_memory.h"
#include "po_quote.h"

/* A curve with more points, or a list of more jumps or folds, is assumed to be a mistake. */
static const size_t MOST_ITEMS = 1000000;

/* Refuses an answer: the first reason stays. */
static void __attribute__((format(printf, 2, 3)))
refuse(po_answer *answer, const char *format, ...) {
  char text[sizeof answer->result.reason];
  va_list arguments;
  if (answer->result.status == PO_INVALID)
    return;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  answer->result.status = PO_INVALID;
  po_quote_text(text, answer->result.reason, sizeof answer->result.reason);
}

/* Returned: what a value is, for a message. */
static const char *kind_of(const json_t *value) {
  return !value                   ? "missing"
         : json_is_null(value)    ? "null"
         : json_is_string(value)  ? "a text"
         : json_is_object(value)  ? "an object"
         : json_is_array(value)   ? "an array"
         : json_is_boolean(value) ? "true or false"
                                  : "a number";
}

/* Returned: a scalar, or the only item of an array of one; Octave and MATLAB do not distinguish
 * them. */
static const json_t *scalar(const json_t *value) {
  return json_is_array(value) && json_array_size(value) == 1 ? json_array_get(value, 0) : value;
}

/* Reads a number. null, "nan" and an absent value give NAN; "inf" and "-inf" an infinite number. */
static double read_number(po_answer *answer, const char *where, const json_t *value) {
  value = scalar(value);
  const char *text = json_string_value(value);
  if (json_is_number(value))
    return json_number_value(value);
  if (!value || json_is_null(value) || (text && strcmp(text, "nan") == 0))
    return (double)NAN;
  if (text && (strcmp(text, "inf") == 0 || strcmp(text, "-inf") == 0))
    return *text == '-' ? -INFINITY : INFINITY;
  refuse(answer, "%s is %s: expected a number, null, \"inf\" or \"-inf\"", where, kind_of(value));
  return (double)NAN;
}

static double read_member(po_answer *answer, const char *part, const json_t *object,
                          const char *key) {
  char where[80];
  snprintf(where, sizeof where, "%s%s%s", part, *part ? "." : "", key);
  return read_number(answer, where, json_object_get(object, key));
}

/* Returned: a part of the answer; NULL if it is absent or null, or not an object. */
static const json_t *read_part(po_answer *answer, const json_t *object, const char *key) {
  const json_t *part = scalar(json_object_get(object, key));
  if (part && !json_is_null(part) && !json_is_object(part))
    refuse(answer, "%s is %s: expected an object", key, kind_of(part));
  return json_is_object(part) ? part : NULL;
}

/* Returned: whether a list is present; a single object counts as a list of one. */
static bool read_list(po_answer *answer, const json_t *object, const char *part, const char *key,
                      size_t *count) {
  const json_t *list = json_object_get(object, key);
  *count = json_is_object(list) ? 1 : json_array_size(list);
  if (!list || json_is_null(list))
    return false;
  if (!json_is_object(list) && !json_is_array(list))
    refuse(answer, "%s%s%s is %s: expected an array of objects", part, *part ? "." : "", key,
           kind_of(list));
  else if (*count > MOST_ITEMS)
    refuse(answer, "%s has %zu items: expected at most %zu", key, *count, MOST_ITEMS);
  return answer->result.status != PO_INVALID;
}

static const json_t *list_item(const json_t *object, const char *key, size_t index) {
  const json_t *list = json_object_get(object, key);
  return json_is_object(list) ? list : json_array_get(list, index);
}

static void read_pull_off(const json_t *root, po_answer *answer) {
  const json_t *part = read_part(answer, root, "pull_off");
  po_result *o = &answer->result;
  o->has_pull_off = part != NULL;
  o->pull_off.force = read_member(answer, "pull_off", part, "force");
  o->pull_off.approach = read_member(answer, "pull_off", part, "approach");
  o->pull_off.contact_radius = read_member(answer, "pull_off", part, "contact_radius");
  o->pull_off.force_error = read_member(answer, "pull_off", part, "error_estimate");
  o->pull_off.approach_error = o->pull_off.contact_radius_error = o->pull_off.contact_radius_other =
      (double)NAN;
}

static bool find_kind(const char *text, bool folds, po_special_kind *kind) {
  for (int k = folds ? PO_JUMP_IN : PO_MINIMUM; k <= (folds ? PO_JUMP_OUT : PO_MAXIMUM); ++k)
    if (text && strcmp(text, PO_SPECIAL_KINDS[k]) == 0) {
      *kind = (po_special_kind)k;
      return true;
    }
  return false;
}

static po_status read_special_points(const json_t *root, bool folds, po_answer *answer) {
  const char *key = folds ? "folds" : "extrema";
  size_t count = 0;
  if (!read_list(answer, root, "", key, &count))
    return PO_OK;
  po_special_point *list = po_allocate(count, sizeof *list);
  if (!list)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i) {
    const json_t *item = list_item(root, key, i);
    char where[40];
    snprintf(where, sizeof where, "%s[%zu]", key, i + 1);
    list[i] = (po_special_point){.energy = NAN,
                                 .energy_error = NAN,
                                 .approach_error = NAN,
                                 .load_error = NAN,
                                 .contact_radius = NAN,
                                 .contact_radius_error = NAN,
                                 .contact_radius_other = NAN,
                                 .position = (double)i};
    if (!find_kind(json_string_value(json_object_get(item, "kind")), folds, &list[i].kind))
      refuse(answer, "%s.kind: expected %s", where,
             folds ? "jump_in or jump_out" : "minimum or maximum");
    list[i].approach = read_member(answer, where, item, "approach");
    list[i].load = read_member(answer, where, item, "load");
    if (!isfinite(list[i].approach) || !isfinite(list[i].load))
      refuse(answer, "%s: expected finite numbers approach and load", where);
  }
  if (folds) {
    answer->result.folds = list;
    answer->result.fold_count = count;
  } else {
    answer->result.extrema = list;
    answer->result.extremum_count = count;
  }
  return PO_OK;
}

/* The points of the curve, with the length along it as their position; their rates are not known.
 */
static po_status read_curve(const json_t *root, po_answer *answer) {
  const json_t *part = read_part(answer, root, "curve");
  const json_t *approach = json_object_get(part, "approach"), *load = json_object_get(part, "load");
  const size_t count = json_array_size(approach);
  if (!part)
    return PO_OK;
  if (!json_is_array(approach) || !json_is_array(load) || json_array_size(load) != count ||
      count < 3 || count > MOST_ITEMS) {
    refuse(answer,
           "curve: expected two arrays of equal length, approach and load, of 3 to %zu numbers",
           MOST_ITEMS);
    return PO_OK;
  }
  po_curve_point *points = po_allocate(count, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  answer->result.curve = points;
  answer->result.curve_count = count;
  for (size_t i = 0; i < count; ++i) {
    points[i] = (po_curve_point){
        .approach = read_number(answer, "curve.approach", json_array_get(approach, i)),
        .load = read_number(answer, "curve.load", json_array_get(load, i)),
        .energy = NAN,
        .contact_radius = NAN,
        .approach_rate = NAN,
        .load_rate = NAN};
    if (!isfinite(points[i].approach) || !isfinite(points[i].load))
      refuse(answer, "point %zu of curve: expected finite numbers", i + 1);
    if (i > 0)
      points[i].position =
          points[i - 1].position + po_hypot(points[i].approach - points[i - 1].approach,
                                            points[i].load - points[i - 1].load);
  }
  return PO_OK;
}

static const po_path_state UNKNOWN = {(double)NAN, (double)NAN, (double)NAN, (double)NAN,
                                      (double)NAN};

static po_jump read_jump(const json_t *item, size_t number, po_answer *answer) {
  char where[40];
  snprintf(where, sizeof where, "hysteresis.jumps[%zu]", number);
  const char *phase = json_string_value(json_object_get(item, "phase"));
  const bool loading = phase && strcmp(phase, "loading") == 0;
  if (!loading && !(phase && strcmp(phase, "unloading") == 0))
    refuse(answer, "%s.phase: expected loading or unloading", where);
  po_jump jump = {.loading = loading,
                  .before = UNKNOWN,
                  .after = UNKNOWN,
                  .energy_lost = read_member(answer, where, item, "energy_lost"),
                  .energy_lost_error = (double)NAN};
  jump.before.approach = jump.after.approach = read_member(answer, where, item, "approach");
  jump.before.load = read_member(answer, where, item, "load_before");
  jump.after.load = read_member(answer, where, item, "load_after");
  if (!isfinite(jump.before.approach))
    refuse(answer, "%s.approach: expected a finite number", where);
  return jump;
}

static po_loop unknown_loop(po_control control) {
  return (po_loop){.control = control,
                   .preload = UNKNOWN,
                   .pull_off = UNKNOWN,
                   .pull_off_error = {NAN, NAN},
                   .energy_lost = (double)NAN,
                   .energy_lost_error = (double)NAN,
                   .work = (double)NAN,
                   .work_error = (double)NAN,
                   .energy_error = (double)NAN};
}

static po_status read_hysteresis(const json_t *root, po_answer *answer) {
  const json_t *part = read_part(answer, root, "hysteresis");
  po_result *o = &answer->result;
  po_loop *loop = &o->hysteresis.of[PO_AT_APPROACH];
  size_t count = 0;
  if (!part)
    return PO_OK;
  o->has_hysteresis = o->hysteresis.has_load = true;
  *loop = unknown_loop(PO_DISPLACEMENT_CONTROL);
  loop->energy_lost = read_member(answer, "hysteresis", part, "energy_lost");
  o->hysteresis.of[PO_AT_LOAD] = unknown_loop(PO_LOAD_CONTROL);
  loop->pull_off.load = -read_member(answer, "hysteresis", part, "force");
  loop->pull_off.approach = read_member(answer, "hysteresis", part, "approach");
  if (!read_list(answer, part, "hysteresis", "jumps", &count))
    return PO_OK;
  loop->jumps = po_allocate(count, sizeof *loop->jumps);
  if (!loop->jumps)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i) {
    loop->jumps[i] = read_jump(list_item(part, "jumps", i), i + 1, answer);
    if (loop->jumps[i].loading && loop->loading_jumps < i)
      refuse(answer, "hysteresis.jumps[%zu].phase is loading: expected those of loading first",
             i + 1);
    loop->loading_jumps += loop->jumps[i].loading;
    loop->jump_count = i + 1;
  }
  return PO_OK;
}

static void read_times(const json_t *root, po_answer *answer) {
  const json_t *part = read_part(answer, root, "seconds");
  answer->setup = read_member(answer, "seconds", part, "setup");
  answer->solve = read_member(answer, "seconds", part, "solve");
  if (answer->setup < 0 || answer->solve < 0 || isinf(answer->setup) || isinf(answer->solve))
    refuse(answer, "seconds: expected finite numbers >= 0");
  answer->result.work.seconds = answer->solve;
}

static void read_status(const json_t *root, po_answer *answer) {
  const char *status = json_string_value(json_object_get(root, "status"));
  const char *reason = json_string_value(json_object_get(root, "reason"));
  po_result *o = &answer->result;
  po_quote_text(reason ? reason : "", o->reason, sizeof o->reason);
  po_status found = PO_INVALID;
  if (po_status_find(status, &found) &&
      (found == PO_OK || found == PO_UNSUPPORTED || found == PO_FAILED))
    o->status = found;
  else
    refuse(answer, "status is %s: expected ok, unsupported or failed",
           status ? status : kind_of(json_object_get(root, "status")));
  if ((o->status == PO_UNSUPPORTED || o->status == PO_FAILED) && !*o->reason)
    snprintf(o->reason, sizeof o->reason, "%s, without a reason", po_status_text(o->status));
}

/* Reads the id, a text or a whole number, and the number of the repeat. */
static void read_id(const json_t *root, po_answer *answer) {
  const json_t *id = scalar(json_object_get(root, "id"));
  const json_t *repeat = scalar(json_object_get(root, "repeat"));
  if (json_is_integer(id))
    snprintf(answer->id, sizeof answer->id, "%lld", (long long)json_integer_value(id));
  else if (json_is_string(id))
    snprintf(answer->id, sizeof answer->id, "%s", json_string_value(id));
  else
    refuse(answer, "id is %s: expected that of a point of the request", kind_of(id));
  answer->repeat = 1;
  const double number = json_number_value(repeat);
  if (repeat &&
      !(json_is_number(repeat) && number >= 1 && number <= 1000 && number == floor(number)))
    refuse(answer, "repeat is %s: expected a whole number from 1", kind_of(repeat));
  else if (repeat)
    answer->repeat = (unsigned)number;
}

/* Finds the id in a line that is not JSON, so that the right point is blamed. */
static void guess_id(const char *line, size_t length, po_answer *answer) {
  static const char KEY[] = "\"id\"";
  char *text = po_resize(NULL, length + 1, 1);
  if (!text)
    return;
  memcpy(text, line, length);
  text[length] = '\0';
  const char *at = strstr(text, KEY);
  if (at) {
    at += strlen(KEY);
    at += strspn(at, " \t:\"[");
    const size_t size = strspn(at, "0123456789");
    if (size > 0 && size < sizeof answer->id &&
        (at[size] == '"' || at[size] == ',' || at[size] == ']'))
      snprintf(answer->id, sizeof answer->id, "%.*s", (int)size, at);
  }
  free(text);
}

static po_status read_all(const json_t *root, po_answer *answer) {
  read_id(root, answer);
  if (answer->result.status != PO_INVALID)
    read_status(root, answer);
  read_times(root, answer);
  if (answer->result.status != PO_OK)
    return PO_OK;
  answer->result.start = read_member(answer, "", root, "start");
  answer->result.ended.approach = read_member(answer, "", root, "end");
  read_pull_off(root, answer);
  po_status status = read_hysteresis(root, answer);
  if (!status)
    status = read_special_points(root, true, answer);
  if (!status)
    status = read_special_points(root, false, answer);
  return status ? status : read_curve(root, answer);
}

po_status po_answer_read(const char *line, size_t length, po_answer *answer) {
  json_t *root = NULL;
  *answer = (po_answer){.result = po_result_none(), .repeat = 1, .setup = NAN, .solve = NAN};
  answer->result.work.seconds = (double)NAN;
  po_status status = po_json_parse(line, length, &root);
  if (status == PO_NO_MEMORY)
    return status;
  if (status) {
    refuse(answer, "a line is not JSON: %s", po_message());
    guess_id(line, length, answer);
    status = PO_OK;
  } else if (!json_is_object(root))
    refuse(answer, "a line is %s: expected an object", kind_of(root));
  else
    status = read_all(root, answer);
  json_decref(root);
  return status;
}

static bool lacks(const po_question *question, po_quantity quantity, double value) {
  return (question->want & (1U << quantity)) && !isfinite(value);
}

static bool wants(const po_question *question, po_quantity quantity) {
  return (question->want & (1U << quantity)) != 0;
}

void po_answer_check(const po_question *question, po_answer *answer) {
  const po_result *o = &answer->result;
  const po_loop *loop = &o->hysteresis.of[PO_AT_APPROACH];
  if (o->status != PO_OK)
    return;
  const struct {
    bool lacking;
    const char *what;
  } PARTS[] = {
      {lacks(question, PO_PULL_OFF_FORCE, o->pull_off.force), "pull_off.force"},
      {lacks(question, PO_PULL_OFF_APPROACH, o->pull_off.approach), "pull_off.approach"},
      {lacks(question, PO_CONTACT_RADIUS, o->pull_off.contact_radius), "pull_off.contact_radius"},
      {lacks(question, PO_HYSTERESIS_FORCE, o->has_hysteresis ? loop->pull_off.load : NAN),
       "hysteresis.force"},
      {lacks(question, PO_HYSTERESIS_APPROACH, o->has_hysteresis ? loop->pull_off.approach : NAN),
       "hysteresis.approach"},
      {lacks(question, PO_HYSTERESIS_LOSS, o->has_hysteresis ? loop->energy_lost : NAN),
       "hysteresis.energy_lost"},
      {wants(question, PO_JUMPS) && !loop->jumps, "hysteresis.jumps"},
      {(wants(question, PO_FOLDS) || wants(question, PO_FOLD_COUNT)) && !o->folds, "folds"},
      {wants(question, PO_EXTREMA) && !o->extrema, "extrema"},
      {wants(question, PO_CURVE) && !o->curve, "curve"},
  };
  for (size_t i = 0; i < sizeof PARTS / sizeof *PARTS; ++i)
    if (PARTS[i].lacking)
      refuse(answer, "%s is missing or not a finite number, though the point wants it",
             PARTS[i].what);
}
