#include "po_json.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_json_digest.h"
#include "po_memory.h"
#include "po_profile_table.h"
#include "po_quote.h"
#include "po_result_rows.h"
#include "po_si.h"

/* -- Structures by their rows (po_rows.h) -- */

/* The list of which a structure is an item, and the units of its numbers; NULL: as they are. */
typedef struct {
  const void *owner;
  size_t index;
  const po_units *units;
} place;

static void add_rows(json_t **object, const po_block *block, const void *owner, place of);

static json_t *object_of(const po_block *block, const void *owner, place of) {
  json_t *object = po_json_empty_object();
  add_rows(&object, block, owner, of);
  return object;
}

static json_t *list_of(const po_row *row, const void *owner, const po_units *units) {
  json_t *array = po_json_empty_array();
  for (size_t k = 0; k < po_row_items(row, owner); ++k)
    po_json_append(&array,
                   object_of(row->block, po_row_item(row, owner, k), (place){owner, k, units}));
  return array;
}

/* Sets a number. In SI units its key has the name of the unit at its end. */
static void set_number(json_t **object, const po_row *row, const void *owner, place of) {
  const po_si_unit unit = of.units ? po_si_unit_of(of.units, row->dimension) : (po_si_unit){1.0};
  char key[64];
  snprintf(key, sizeof key, "%s%s%s", row->key, *unit.name ? "_" : "", unit.name);
  po_json_set(object, key, po_json_number(po_si_value(&unit, po_row_number(row, owner))));
}

static json_t *labels_of(const po_row *row, place of) {
  po_label label[2];
  row->label(of.owner, of.index, label);
  if (row->type == PO_ROW_LABEL)
    return po_json_text(label[0]);
  json_t *array = po_json_empty_array();
  po_json_append(&array, po_json_text(label[0]));
  po_json_append(&array, po_json_text(label[1]));
  return array;
}

static json_t *value_of(const po_row *row, const void *owner, place of) {
  const char *member = (const char *)owner + row->offset;
  if (po_row_is_absent(row, owner))
    return json_null();
  switch (row->type) {
  case PO_ROW_COUNT:
    return po_json_count(row->get ? (uint64_t)row->get(owner) : po_row_bits(row, owner));
  case PO_ROW_INTEGER:
    return po_json_count((uint64_t)po_row_number(row, owner));
  case PO_ROW_FLAG:
    return json_boolean(po_row_bits(row, owner) != 0);
  case PO_ROW_TEXT:
    return po_json_text(member);
  case PO_ROW_WORD:
    return po_json_text(row->word ? row->word(owner) : row->names[po_row_bits(row, owner)]);
  case PO_ROW_STATUS:
    return po_json_text(po_status_name(*(const po_status *)(const void *)member));
  case PO_ROW_LABEL:
  case PO_ROW_LABELS:
    return labels_of(row, of);
  case PO_ROW_PART:
    return object_of(row->block, member, of);
  case PO_ROW_LIST:
    return list_of(row, owner, of.units);
  default: /* a number, see set_number */
    return NULL;
  }
}

/* Whether a row is a number with a dimension, or has one among its parts and items. */
static bool has_dimension(const po_row *row) {
  if (!row->block)
    return row->dimension >= PO_DIMENSION_LENGTH;
  for (size_t i = 0; i < row->block->count; ++i)
    if (has_dimension(&row->block->row[i]))
      return true;
  return false;
}

static void add_rows(json_t **object, const po_block *block, const void *owner, place of) {
  for (size_t i = 0; i < block->count; ++i) {
    const po_row *row = &block->row[i];
    if (row->type == PO_ROW_INLINE)
      add_rows(object, row->block, (const char *)owner + row->offset, of);
    else if (row->hidden || (row->omitted && po_row_is_absent(row, owner)))
      continue;
    else if (row->type == PO_ROW_NUMBER)
      set_number(object, row, owner, of);
    else
      po_json_set(object, row->key, value_of(row, owner, of));
  }
}

json_t *po_json_of(const po_block *block, const void *owner) {
  return object_of(block, owner, (place){NULL, 0, NULL});
}

static po_status read_into(const json_t *object, const po_block *block, void *owner);

static po_status read_list(const json_t *array, const po_row *row, void *owner) {
  const size_t count = json_array_size(array);
  char *list = po_allocate(count, row->block->size);
  memcpy((char *)owner + row->offset, &list, sizeof list);
  po_status status = list ? PO_OK : PO_NO_MEMORY;
  if (list)
    memset(list, 0, count * row->block->size);
  for (size_t k = 0; k < count && !status; ++k) {
    status = read_into(json_array_get(array, k), row->block, list + k * row->block->size);
    memcpy((char *)owner + row->count, &(size_t){k + 1}, sizeof k);
  }
  return status;
}

static po_status read_integer(const json_t *item, const char *key, int *value) {
  const json_int_t number = json_integer_value(item);
  if (number < 0 || number > INT_MAX)
    return po_fail(PO_BAD_INPUT, "%s is no whole number >= 0", key);
  *value = (int)number;
  return PO_OK;
}

static po_status read_word(const char *text, const po_row *row, void *owner) {
  if (row->take) {
    row->take(owner, text);
    return PO_OK;
  }
  for (uint64_t k = 0; text && row->names[k]; ++k)
    if (strcmp(text, row->names[k]) == 0) {
      po_row_put_bits(row, owner, k);
      return PO_OK;
    }
  return po_fail(PO_BAD_INPUT, "%s is missing or an unknown word", row->key);
}

static po_status read_status(const char *text, const po_row *row, void *owner) {
  void *member = (char *)owner + row->offset;
  return po_status_find(text, member)
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "%s is missing or an unknown word", row->key);
}

/* Reads the member of a row. Given: NULL if the object is absent; then only numbers and parts,
 * which state that they are absent, are written. */
static po_status read_row(const json_t *object, const po_row *row, void *owner) {
  const json_t *item = json_object_get(object, row->key);
  char *member = (char *)owner + row->offset;
  const char *text = json_string_value(item);
  if (row->present)
    *(bool *)((char *)owner + row->present) = item && !json_is_null(item);
  if (row->type == PO_ROW_NUMBER)
    po_row_put(row, owner, po_json_read_number(object, row->key));
  if (row->type == PO_ROW_PART)
    return read_into(json_is_object(item) ? item : NULL, row->block, member);
  if (!object)
    return PO_OK;
  switch (row->type) {
  case PO_ROW_COUNT:
    if (!row->get)
      po_row_put_bits(row, owner, po_json_count_of(object, row->key));
    return PO_OK;
  case PO_ROW_INTEGER:
    return row->omitted && !item ? PO_OK : read_integer(item, row->key, (int *)(void *)member);
  case PO_ROW_FLAG:
    po_row_put_bits(row, owner, json_is_true(item));
    return PO_OK;
  case PO_ROW_TEXT:
    po_quote_text(text ? text : "", member, row->size);
    return PO_OK;
  case PO_ROW_WORD:
    return read_word(text, row, owner);
  case PO_ROW_STATUS:
    return read_status(text, row, owner);
  case PO_ROW_LIST:
    return read_list(item, row, owner);
  default:
    return PO_OK;
  }
}

/* Fills a structure, which must be empty, from an object; NULL is an absent object. A number that
 * is absent or null is NAN. Status: PO_BAD_INPUT, PO_NO_MEMORY; what was read before is in the
 * structure. */
static po_status read_into(const json_t *object, const po_block *block, void *owner) {
  po_status status = PO_OK;
  for (size_t i = 0; i < block->count && !status; ++i) {
    const po_row *row = &block->row[i];
    if (row->type == PO_ROW_INLINE)
      status = read_into(object, row->block, (char *)owner + row->offset);
    else if (!row->hidden)
      status = read_row(object, row, owner);
  }
  if (block->settle)
    block->settle(owner);
  return status;
}

/* -- Requests and results -- */

json_t *po_json_input(const po_request *request) {
  json_t *object = po_json_empty_object();
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    const double value = po_key_number(request, key);
    if (po_key_is_of_time(key) && isnan(value))
      continue;
    char text[PO_KEY_TEXT_LENGTH];
    po_key_print(request, key, text);
    json_t *item = NULL;
    if (!po_key_is_number(key) || isinf(value))
      item = strcmp(text, "-") == 0 ? json_null() : po_json_text(text);
    else if (key == PO_KEY_NODES)
      item = po_json_count(request->mesh.nodes);
    else
      item = po_json_number(value);
    po_json_set(&object, PO_KEYS[key].name, item);
  }
  po_json_set(&object, "load_unit", po_json_text(po_input_load_unit(request)));
  return object;
}

/* The table of the profile of a scene, which must have one. */
static json_t *table_of(const po_profile *profile) {
  const po_profile_table *table = profile->table;
  json_t *object = PO_JSON_OBJECT({"rows", po_json_count(po_profile_table_points(table))},
                                  {"end_radius", po_json_number(po_profile_shape(profile).end)},
                                  {"exponent", po_json_number(table->growth)},
                                  {"uncertainty", po_json_number(table->uncertainty)},
                                  {"sha256", po_json_text(table->digest)});
  const po_smoothing *s = &table->smoothing;
  const double unit = 1.0 / table->scale;
  if (s->knots)
    po_json_set(&object, "smoothing",
                PO_JSON_OBJECT({"deviation", po_json_number(s->deviation * unit)},
                               {"residual", po_json_number(s->residual * unit)},
                               {"removed_rms", po_json_number(s->rms * unit)},
                               {"removed_greatest", po_json_number(s->greatest * unit)},
                               {"parameters", po_json_number(s->parameters)},
                               {"knots", po_json_count(s->knots)}));
  return object;
}

json_t *po_json_result(const po_request *request, const po_result *result) {
  json_t *object = PO_JSON_OBJECT({"input", po_json_input(request)});
  po_json_set_all(&object, po_json_of(&PO_RESULT_ROWS, result));
  if (po_profile_is_table(&request->scene.profile))
    po_json_set(&object, "profile_table", table_of(&request->scene.profile));
  po_json_set_all(&object, po_json_of(&PO_WANTED_ROWS, result));
  return object;
}

po_status po_json_read_result(const json_t *object, po_result *result) {
  *result = (po_result){0};
  po_status status = read_into(object, &PO_RESULT_ROWS, result);
  if (!status)
    status = read_into(object, &PO_WANTED_ROWS, result);
  if (!status)
    status = read_into(object, &PO_BRANCH_ROWS, result);
  if (!status)
    status = read_into(object, &PO_SURFACE_ROWS, result);
  if (status)
    po_result_clear(result);
  return status;
}

/* Adds the arrays of points that were requested. */
static void add_points(json_t **document, const po_request *request, const po_result *result,
                       const po_units *units) {
  if (request->want & PO_WANT_CURVE)
    add_rows(document, &PO_BRANCH_ROWS, result, (place){NULL, 0, units});
  if (request->want & PO_WANT_PROFILE)
    add_rows(document, &PO_SURFACE_ROWS, result, (place){NULL, 0, units});
}

json_t *po_json_document(const po_request *request, const po_result *result) {
  json_t *document = PO_JSON_OBJECT({"schema", po_json_text("pulloff/1")});
  po_json_set_all(&document, po_json_result(request, result));
  add_points(&document, request, result, NULL);
  po_json_seal(&document);
  return document;
}

/* Adds the numbers of a block with a dimension, and the parts and lists that have some, in SI
 * units.
 */
static void add_in_si(json_t **object, const po_block *block, const po_result *result,
                      const po_units *units) {
  for (size_t i = 0; i < block->count; ++i)
    if (has_dimension(&block->row[i]))
      add_rows(object, &(po_block){.row = &block->row[i], .count = 1}, result,
               (place){NULL, 0, units});
}

json_t *po_json_units(const po_units *units) {
  return PO_JSON_OBJECT({"length_m", po_json_number(units->length)},
                        {"force_n", po_json_number(units->force)},
                        {"traction_pa", po_json_number(units->traction)});
}

json_t *po_json_result_in_si(const po_units *units, const po_result *result) {
  json_t *object = po_json_empty_object();
  add_in_si(&object, &PO_RESULT_ROWS, result, units);
  add_in_si(&object, &PO_WANTED_ROWS, result, units);
  return object;
}

json_t *po_json_document_in_si(const po_request *request, const po_result *result) {
  json_t *object = po_json_result_in_si(&request->units, result);
  add_points(&object, request, result, &request->units);
  return object;
}
