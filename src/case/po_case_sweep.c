/* The section `sweep` of a case. */
#include <stdio.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_order.h"
#include "po_schema.h"

unsigned po_sweep_count(const po_sweep *sweep) {
  return sweep->together ? sweep->together_count : sweep->axis.values_count;
}

const char *po_sweep_value(const po_sweep *sweep, unsigned index, po_key key) {
  if (sweep->together)
    return sweep->together[index].values[key];
  return po_key_of_name(sweep->axis.key) == (int)key ? sweep->axis.values[index] : NULL;
}

static void find_names(po_sweep *sweep) {
  sweep->named = 0;
  for (unsigned i = 0; i < po_sweep_count(sweep); ++i)
    for (int key = 0; key < PO_KEY_END; ++key)
      if (po_sweep_value(sweep, i, (po_key)key))
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
