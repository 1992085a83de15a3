#include "po_bless_list.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare_parts.h"
#include "po_memory.h"

/* Adds a value, unless another check has added it already. */
static po_status add(po_pin_list *list, size_t point, const char *name, double value) {
  for (size_t i = 0; i < list->count; ++i)
    if (list->items[i].point == point && strcmp(list->items[i].name, name) == 0)
      return PO_OK;
  po_pin *items = po_resize(list->items, list->count + 1, sizeof *items);
  if (!items)
    return PO_NO_MEMORY;
  list->items = items;
  po_pin *pin = &items[list->count++];
  *pin = (po_pin){.point = point, .value = value};
  snprintf(pin->name, sizeof pin->name, "%s", name);
  return PO_OK;
}

static po_status add_special_points(po_pin_list *list, size_t point, po_quantity quantity,
                                    const po_result *result) {
  const bool folds = quantity == PO_FOLDS, solved = result->status == PO_OK;
  const po_special_point *marks = folds ? result->folds : result->extrema;
  const size_t count = folds ? result->fold_count : result->extremum_count;
  char name[PO_PIN_NAME_LENGTH];
  snprintf(name, sizeof name, "%s/count", po_quantity_name(quantity));
  po_status status = add(list, point, name, solved ? (double)count : (double)NAN);
  for (size_t i = 0; !status && solved && i < count; ++i)
    for (int load = 0; !status && load < 2; ++load) {
      po_pins_name_special_point(quantity, marks[i].kind, i, load, name);
      status = add(list, point, name, load ? marks[i].load : marks[i].approach);
    }
  return status;
}

static po_status add_work(po_pin_list *list, size_t point, const po_result *result) {
  po_status status = PO_OK;
  for (int counter = 0; !status && counter < PO_WORK_COUNTERS; ++counter) {
    char name[PO_PIN_NAME_LENGTH];
    snprintf(name, sizeof name, "work/%s", po_work_name(counter));
    status = add(list, point, name,
                 result->status == PO_OK ? po_work_count(&result->work, counter) : (double)NAN);
  }
  return status;
}

static po_status add_check(const po_case_run *run, const po_check *check, size_t point,
                           po_pin_list *list) {
  const po_result *result = &run->results[point];
  if (!po_check_is_pin(check) || !po_check_concerns(check, &run->plan->kase->points[point].request))
    return PO_OK;
  if (check->quantity == PO_WORK)
    return add_work(list, point, result);
  if (check->quantity == PO_FOLDS || check->quantity == PO_EXTREMA)
    return add_special_points(list, point, check->quantity, result);
  return add(list, point, po_quantity_name(check->quantity),
             po_compare_obtained(check->quantity, result));
}

po_status po_pin_list_make(const po_case_run *run, po_pin_list *list) {
  const po_case *kase = run->plan->kase;
  po_status status = PO_OK;
  *list = (po_pin_list){0};
  for (size_t point = 0; !status && point < kase->point_count; ++point)
    for (unsigned c = 0; !status && c < kase->file->checks_count; ++c)
      status = add_check(run, &kase->file->checks[c], point, list);
  return status;
}

void po_pin_list_clear(po_pin_list *list) {
  free(list->items);
  *list = (po_pin_list){0};
}

/* Reports whether a key has the same value for all scenes of the list. Returned: in `text`, this
 * value. */
static bool is_shared(const po_case *kase, const po_pin_list *list, po_key key,
                      char text[PO_KEY_TEXT_LENGTH]) {
  strcpy(text, "-");
  for (size_t i = 0; i < list->count; ++i) {
    char other[PO_KEY_TEXT_LENGTH];
    po_pins_key_text(&kase->points[list->items[i].point].request, key, i ? other : text);
    if (i && strcmp(other, text) != 0)
      return false;
  }
  return true;
}

void po_pin_list_headers(const po_case *kase, const po_pin_list *list, po_text *text) {
  char value[PO_KEY_TEXT_LENGTH];
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (is_shared(kase, list, (po_key)key, value) && strcmp(value, "-") != 0)
      po_text_add(text, "# %s: %s\n", po_key_name((po_key)key), value);
}

void po_pin_list_rows(const po_case *kase, const po_pin_list *list, po_text *rows) {
  bool column[PO_KEY_COUNT];
  char value[PO_KEY_TEXT_LENGTH];
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    column[key] = !is_shared(kase, list, (po_key)key, value);
    if (column[key])
      po_text_add(rows, "%s,", po_key_name((po_key)key));
  }
  po_text_add(rows, "quantity,value\n");
  for (size_t i = 0; i < list->count; ++i) {
    const po_pin *pin = &list->items[i];
    for (int key = 0; key < PO_KEY_COUNT; ++key)
      if (column[key]) {
        po_pins_key_text(&kase->points[pin->point].request, (po_key)key, value);
        po_text_add(rows, "%s,", value);
      }
    po_number_print(pin->value, value);
    po_text_add(rows, "%s,%s\n", pin->name, value);
  }
}
