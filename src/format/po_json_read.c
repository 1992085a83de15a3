#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "po_json.h"
#include "po_json_parts.h"
#include "po_memory.h"
#include "po_quote.h"

static bool read_kind(const json_t *object, po_special_kind *kind) {
  const char *name = json_string_value(json_object_get(object, "kind"));
  for (int k = PO_JUMP_IN; name && k <= PO_MAXIMUM; ++k)
    if (strcmp(name, po_special_kind_name((po_special_kind)k)) == 0) {
      *kind = (po_special_kind)k;
      return true;
    }
  return false;
}

static void read_ended(const json_t *object, po_result *result) {
  const char *why = json_string_value(json_object_get(object, "why"));
  result->ended.approach = po_json_read_number(object, "approach");
  result->ended.load = po_json_read_number(object, "load");
  if (!po_end_cause_find(why, &result->ended.cause)) /* the status states the reason */
    result->ended.cause = PO_END_NONE;
}

static po_status read_annuli(const json_t *array, po_contact_annulus **list, size_t *count) {
  const size_t size = json_array_size(array);
  *list = po_allocate(size, sizeof **list);
  if (!*list)
    return PO_NO_MEMORY;
  *count = size;
  for (size_t i = 0; i < size; ++i) {
    const json_t *item = json_array_get(array, i);
    (*list)[i].inner = po_json_read_number(item, "inner");
    (*list)[i].outer = po_json_read_number(item, "outer");
  }
  return PO_OK;
}

static po_status read_contact(const json_t *object, po_result *result) {
  po_contact_annuli *a = &result->annuli;
  result->profile_approach = po_json_read_number(object, "approach");
  const po_status status =
      read_annuli(json_object_get(object, "compressed"), &a->compressed, &a->compressed_count);
  return status ? status : read_annuli(json_object_get(object, "held"), &a->held, &a->held_count);
}

static po_status read_special_points(const json_t *array, po_special_point **list, size_t *count) {
  const size_t size = json_array_size(array);
  *list = po_allocate(size, sizeof **list);
  if (!*list)
    return PO_NO_MEMORY;
  *count = size;
  for (size_t i = 0; i < size; ++i) {
    const json_t *item = json_array_get(array, i);
    po_special_point *special = &(*list)[i];
    const json_int_t modes = json_integer_value(json_object_get(item, "unstable_modes"));
    if (!read_kind(item, &special->kind))
      return po_fail(PO_BAD_INPUT, "special point %zu has no kind", i);
    if (modes < 0 || modes > INT_MAX)
      return po_fail(PO_BAD_INPUT, "special point %zu has no number of unstable modes", i);
    po_json_read_special_point(item, special);
  }
  return PO_OK;
}

po_status po_json_read_result(const json_t *object, po_result *result) {
  *result = (po_result){0};
  if (!po_status_find(json_string_value(json_object_get(object, "status")), &result->status))
    return po_fail(PO_BAD_INPUT, "a point has no status");
  const char *reason = json_string_value(json_object_get(object, "reason"));
  po_quote_text(reason ? reason : "", result->reason, sizeof result->reason);
  result->rigid = json_is_true(json_object_get(object, "rigid"));
  result->start = po_json_read_number(object, "start");
  read_ended(json_object_get(object, "ended"), result);
  result->followed = json_is_true(json_object_get(object, "followed"));
  po_json_read_pull_off(json_object_get(object, "pull_off"), result);
  po_json_read_pull_off_any(json_object_get(object, "pull_off_any"), result);
  po_json_read_work(json_object_get(object, "work"), &result->work);
  po_status status = read_contact(json_object_get(object, "contact"), result);
  if (!status)
    status =
        read_special_points(json_object_get(object, "folds"), &result->folds, &result->fold_count);
  if (!status)
    status = read_special_points(json_object_get(object, "extrema"), &result->extrema,
                                 &result->extremum_count);
  if (!status)
    status = po_json_read_hysteresis(json_object_get(object, "hysteresis"), result);
  if (!status)
    status = po_json_read_staircases(json_object_get(object, "staircase"), result);
  if (!status)
    status = po_json_read_diagnostics(json_object_get(object, "diagnostics"), result);
  if (status)
    po_result_clear(result);
  return status;
}
