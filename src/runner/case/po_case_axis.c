/* Axes: their values, as written or computed from a range, and the evaluation of conditions. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_memory.h"
#include "po_range.h"

static po_status parse_range(const po_axis *axis, const char *where, const po_yaml *yaml,
                             po_range *r) {
  if (!axis->from_text || !po_number_parse(axis->from_text, &r->from))
    return po_fields_refuse(yaml, NULL, "%s.from", where);
  if (!axis->to_text || !po_number_parse(axis->to_text, &r->to) || !(r->to > r->from))
    return po_fields_refuse(yaml, NULL, "%s.to", where);
  if (!axis->count_text || !po_number_parse_count(axis->count_text, &r->count) || r->count < 2 ||
      r->count > PO_MOST_VALUES)
    return po_fields_refuse(yaml, NULL, "%s.count", where);
  if (axis->scale && !po_range_read_scale(axis->scale, &r->log))
    return po_fields_refuse(yaml, NULL, "%s.scale", where);
  if (r->log && r->from <= 0)
    return po_fields_refuse(yaml, "a finite number > 0, as the scale is log", "%s.from", where);
  return PO_OK;
}

po_status po_axis_fill(po_axis *axis, const char *where, const po_yaml *yaml) {
  po_range r = {0};
  const bool ranged = axis->from_text || axis->to_text || axis->count_text || axis->scale;
  if (axis->values)
    return ranged
               ? po_fields_refuse(yaml, "either values, or from, to and count", "%s.values", where)
               : PO_OK;
  if (!ranged)
    return po_fields_refuse(yaml, "a list of values, or from, to and count", "%s.values", where);
  const po_status status = parse_range(axis, where, yaml, &r);
  if (status)
    return status;
  axis->values = po_allocate(r.count, sizeof *axis->values);
  if (!axis->values)
    return PO_NO_MEMORY;
  for (; axis->values_count < r.count; ++axis->values_count) {
    char text[PO_NUMBER_LENGTH];
    po_range_print(&r, axis->values_count, text);
    char *copy = po_copy_text(text);
    if (!copy)
      return PO_NO_MEMORY;
    axis->values[axis->values_count] = copy;
  }
  return PO_OK;
}

/* Values with at most this relative difference are equal, as in po_key_matches. */
static const double SAME_VALUE = 4 * DBL_EPSILON;

static bool is_same(double a, double b) {
  return a == b || (isfinite(b) && fabs(a - b) <= SAME_VALUE * fabs(b));
}

static int by_number(const void *a, const void *b) {
  const po_axis_value *x = a, *y = b;
  if (x->number != y->number)
    return x->number > y->number ? 1 : -1;
  return (x->index > y->index) - (x->index < y->index);
}

/* Returned: whether two texts are the same value of a key. */
static bool key_same(po_key key, const char *a, const char *b) {
  po_request request = po_request_default();
  return po_key_set(&request, key, a) && po_key_matches(&request, key, b);
}

/* Returned: the least index of a value that equals an earlier one; `count` if all differ. Different
 * names can have the same number: mie:3,9 and mie:4,10. */
static unsigned find_same(const po_axis *axis, po_key key) {
  const po_axis_value *ascending = axis->ascending;
  unsigned found = axis->values_count;
  for (unsigned n = 1; n < axis->values_count; ++n)
    for (unsigned m = n; m-- > 0 && is_same(ascending[m].number, ascending[n].number);) {
      const unsigned x = ascending[m].index, y = ascending[n].index, later = x > y ? x : y;
      if (later < found &&
          (po_key_is_number(key) || key_same(key, axis->values[x], axis->values[y])))
        found = later;
    }
  return found;
}

po_status po_case_refuse_key(const po_yaml *yaml, const char *what, bool (*fits)(po_key key),
                             const char *where) {
  po_text expected = {0};
  po_text_add(&expected, "%s", what);
  for (int key = 0, named = 0; key < PO_KEY_END; ++key)
    if (!fits || fits(key))
      po_text_add(&expected, "%s%s", named++ ? ", " : ": ", PO_KEYS[key].name);
  const po_status status = po_fields_refuse(yaml, po_text_string(&expected), "%s.key", where);
  po_text_clear(&expected);
  return status;
}

po_status po_case_axis_check(const po_case *kase, po_axis *axis, const char *where,
                             const po_yaml *yaml) {
  (void)kase;
  if (!axis->key || axis->ascending)
    return PO_OK;
  const bool swept = strncmp(where, "sweep[", strlen("sweep[")) == 0;
  const int key = swept ? po_texts_key(axis->key) : po_key_of_name(axis->key);
  if (key < 0 || key >= PO_KEY_PROFILE_APPROACH)
    return po_case_refuse_key(yaml, "a key of the scene", NULL, where);
  po_request request = po_request_default();
  request.scene.amplitude = request.scene.wavelength = 1; /* so that groups of them have a value */
  axis->ascending = po_allocate(axis->values_count, sizeof *axis->ascending);
  if (!axis->ascending)
    return PO_NO_MEMORY;
  for (unsigned i = 0; i < axis->values_count; ++i) {
    if (!po_key_set(&request, key, axis->values[i]))
      return po_fields_refuse(yaml, PO_KEYS[key].expected, "%s.values[%u]", where, i + 1);
    double number = key < PO_KEY_END ? po_key_number(&request, key) : (double)NAN;
    if (po_key_is_list(key))
      number = i;
    else if (isnan(number)) /* a parameter of another law or profile than that of the request */
      po_number_parse(axis->values[i], &number);
    axis->ascending[i] = (po_axis_value){number, i};
  }
  qsort(axis->ascending, axis->values_count, sizeof *axis->ascending, by_number);
  const unsigned same = find_same(axis, key);
  if (same < axis->values_count)
    return po_fields_refuse(yaml, "each value once", "%s.values[%u]", where, same + 1);
  return PO_OK;
}

static po_status each_of_list(const po_case *kase, const po_yaml *yaml, po_case_axis_act *act,
                              po_axis *axes, unsigned count, const char *list, unsigned number,
                              const char *member) {
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "%s[%u].%s[%u]", list, number, member, i + 1);
    status = act(kase, &axes[i], where, yaml);
  }
  return status;
}

po_status po_case_each_axis(const po_case *kase, const po_yaml *yaml, po_case_axis_act *act) {
  const po_case_file *file = kase->file;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->sweep_count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "sweep[%u]", i + 1);
    status = act(kase, &file->sweep[i].axis, where, yaml);
  }
  for (unsigned i = 0; !status && i < file->leave_out_count; ++i)
    status = each_of_list(kase, yaml, act, file->leave_out[i].when, file->leave_out[i].when_count,
                          "leave_out", i + 1, "when");
  for (unsigned i = 0; !status && i < file->checks_count; ++i) {
    const po_check *check = &file->checks[i];
    status = each_of_list(kase, yaml, act, check->when, check->when_count, "checks", i + 1, "when");
    if (!status)
      status =
          each_of_list(kase, yaml, act, check->as_if, check->as_if_count, "checks", i + 1, "as_if");
  }
  for (unsigned i = 0; !status && i < file->measure_count; ++i)
    status = each_of_list(kase, yaml, act, file->measure[i].when, file->measure[i].when_count,
                          "measure", i + 1, "when");
  return status;
}

/* Returned: the place in `ascending` of the least value that is not below a number; values_count if
 * all are below it. */
static unsigned first_from(const po_axis *axis, double number) {
  unsigned begin = 0, end = axis->values_count;
  while (begin < end) {
    const unsigned middle = begin + (end - begin) / 2;
    if (axis->ascending[middle].number < number)
      begin = middle + 1;
    else
      end = middle;
  }
  return begin;
}

/* A group is computed from other keys and has a larger rounding error. */
static const double NEAR_VALUE = 16 * DBL_EPSILON;

static bool axis_holds(const po_axis *axis, const po_request *request) {
  const po_key key = po_key_of_name(axis->key);
  const double number = po_key_number(request, key);
  const double margin = isfinite(number) ? NEAR_VALUE * fabs(number) : 0;
  for (unsigned n = first_from(axis, number - margin);
       n < axis->values_count && axis->ascending[n].number <= number + margin; ++n)
    if (po_key_matches(request, key, axis->values[axis->ascending[n].index]))
      return true;
  return false;
}

bool po_axes_hold(const po_axis *axes, unsigned count, const po_request *request) {
  for (unsigned i = 0; i < count; ++i)
    if (!axis_holds(&axes[i], request))
      return false;
  return true;
}
