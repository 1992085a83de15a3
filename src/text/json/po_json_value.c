#define PO_JSON_VALUE_IS_MADE_HERE
#include "po_json_value.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

#include "po_quote.h"

/* Reports lack of memory: texts are converted to valid UTF-8 before jansson reads them, so that no
 * other failure is possible. */
static json_t *checked(json_t *value) {
  if (!value)
    po_fail(PO_NO_MEMORY, "out of memory while a JSON document was written");
  return value;
}

json_t *po_json_number(double value) {
  return isfinite(value) ? checked(json_real(value)) : json_null();
}

json_t *po_json_count(uint64_t value) {
  return checked(json_integer((json_int_t)value));
}

json_t *po_json_text(const char *text) {
  if (!text)
    return json_null();
  char *copy = po_quote_utf8(text);
  json_t *value = copy ? checked(json_string_nocheck(copy)) : NULL;
  free(copy);
  return value;
}

json_t *po_json_take_text(char *text) {
  json_t *value = text ? po_json_text(text) : NULL;
  free(text);
  return value;
}

json_t *po_json_empty_object(void) {
  return checked(json_object());
}

json_t *po_json_empty_array(void) {
  return checked(json_array());
}

json_t *po_json_texts(char *const *texts, size_t count) {
  json_t *array = po_json_empty_array();
  for (size_t k = 0; k < count; ++k)
    po_json_append(&array, po_json_text(texts[k]));
  return array;
}

json_t *po_json_object_of(const po_json_member *members, size_t count) {
  json_t *object = po_json_empty_object();
  for (size_t i = 0; i < count; ++i)
    po_json_set(&object, members[i].key, members[i].value);
  return object;
}

/* Releases a container to which a value could not be added. */
static void release_container(json_t **container) {
  json_decref(*container);
  *container = NULL;
  checked(NULL);
}

void po_json_set(json_t **object, const char *key, json_t *value) {
  if (!*object || !value) {
    json_decref(value);
    release_container(object);
  } else if (json_object_set_new(*object, key, value) != 0)
    release_container(object);
}

void po_json_append(json_t **array, json_t *value) {
  if (!*array || !value) {
    json_decref(value);
    release_container(array);
  } else if (json_array_append_new(*array, value) != 0)
    release_container(array);
}

/* This function replaces json_object_update_missing, which omits members without an error if memory
 * runs out. */
void po_json_set_all(json_t **object, json_t *members) {
  const char *key;
  json_t *value;
  if (!members)
    release_container(object);
  json_object_foreach(members, key, value) {
    if (!json_object_get(*object, key))
      po_json_set(object, key, json_incref(value));
  }
  json_decref(members);
}

static int take_piece(const char *piece, size_t size, void *text) {
  po_text_add_bytes(text, piece, size);
  return 0;
}

/* Prints into a po_text, which detects lack of memory. In jansson 2.14 json_dumps continues after a
 * failed allocation and returns a damaged document. */
static po_status print_document(const json_t *document, size_t layout, po_text *text) {
  const int failed =
      !document || json_dump_callback(document, take_piece, text, layout | JSON_REAL_PRECISION(17));
  text->failed = text->failed || failed;
  po_text_add_bytes(text, "\n", 1);
  return text->failed ? po_fail(PO_NO_MEMORY, "out of memory while a JSON document was written")
                      : PO_OK;
}

po_status po_json_print(const json_t *document, po_text *text) {
  return print_document(document, JSON_INDENT(2), text);
}

po_status po_json_print_line(const json_t *document, po_text *text) {
  return print_document(document, JSON_COMPACT, text);
}

/* In jansson 2.14 the parser continues after a failed allocation, so that a number may lose digits.
 * Therefore its allocations are monitored. */
static _Thread_local bool ran_out;

static void *allocate(size_t size) {
  void *memory = malloc(size);
  ran_out = ran_out || !memory;
  return memory;
}

static void watch_allocations(void) {
  json_set_alloc_funcs(allocate, free);
}

po_status po_json_parse(const char *bytes, size_t size, json_t **document) {
  static pthread_once_t watched = PTHREAD_ONCE_INIT;
  json_error_t error = {.line = 0};
  pthread_once(&watched, watch_allocations);
  ran_out = false;
  *document = json_loadb(bytes, size, JSON_REJECT_DUPLICATES, &error);
  if (ran_out) {
    json_decref(*document);
    *document = NULL;
    return po_fail(PO_NO_MEMORY, "out of memory while a JSON document was read");
  }
  if (*document)
    return PO_OK;
  return po_fail(PO_CANNOT_READ, "line %d: %s", error.line, error.text);
}

double po_json_read_number(const json_t *object, const char *key) {
  const json_t *item = json_object_get(object, key);
  return json_is_number(item) ? json_number_value(item) : (double)NAN;
}

uint64_t po_json_count_of(const json_t *object, const char *key) {
  return (uint64_t)json_integer_value(json_object_get(object, key));
}
