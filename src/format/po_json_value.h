/* JSON documents that are complete or NULL. A value that could not be made is NULL, and so is every
 * object and array that would contain it; po_json_print checks this once, at the end. Functions of
 * jansson that may lose a value without reporting it cannot be called where this header is
 * included. */
#ifndef PO_JSON_VALUE_H
#define PO_JSON_VALUE_H

#include <stdbool.h>
#include <stdint.h>

#include <jansson.h>

#include "po_status.h"
#include "po_text.h"

/* A finite number; null for NaN and infinities, which JSON cannot represent. */
json_t *po_json_number(double value);

json_t *po_json_count(uint64_t value);
json_t *po_json_integer(int value);
json_t *po_json_flag(bool value);

/* A text, made UTF-8 where it is not (po_text_utf8); null for NULL. */
json_t *po_json_text(const char *text);

/* The same for an allocated text, of which it takes ownership; NULL for NULL, a text whose
 * allocation failed. */
json_t *po_json_take_text(char *text);

/* An object of members {"key", value}, which it takes:
 *   PO_JSON_OBJECT({"approach", po_json_number(x)}, {"load", po_json_number(y)}).
 * A key that is there twice has the later value. */
typedef struct {
  const char *key;
  json_t *value;
} po_json_member;
#define PO_JSON_OBJECT(...)                                                                        \
  po_json_object_of((const po_json_member[]){__VA_ARGS__},                                         \
                    sizeof((const po_json_member[]){__VA_ARGS__}) / sizeof(po_json_member))
json_t *po_json_object_of(const po_json_member *members, size_t count);

json_t *po_json_empty_object(void);
json_t *po_json_empty_array(void);

/* Adds a value, which they take, to an object or an array of the caller. When either is NULL, or
 * memory runs out, the whole is released and *object or *array is NULL from then on. */
void po_json_set(json_t **object, const char *key, json_t *value);
void po_json_append(json_t **array, json_t *value);

/* Adds the members of another object, which it takes; those that are there already stay. */
void po_json_set_all(json_t **object, json_t *members);

/* Appends a document to a text with 17 significant digits, and a newline: indented, or in one line.
 * Status: PO_NO_MEMORY, also of a document that is NULL. */
po_status po_json_print(const json_t *document, po_text *text);
po_status po_json_print_line(const json_t *document, po_text *text);

/* Reads a document of `size` bytes, in which no key is given twice.
 * Status: PO_CANNOT_READ, with what is wrong and where as the message; PO_NO_MEMORY. */
po_status po_json_parse(const char *bytes, size_t size, json_t **document);

/* A member that is a number, or NaN for null and what is absent; a count, or 0. */
double po_json_read_number(const json_t *object, const char *key);
uint64_t po_json_count_of(const json_t *object, const char *key);

#ifndef PO_JSON_VALUE_IS_MADE_HERE
#pragma GCC poison json_object json_array json_string json_stringn json_integer json_real json_pack
#pragma GCC poison json_object_set json_object_set_new json_object_update json_object_update_missing
#pragma GCC poison json_array_append json_array_append_new json_array_insert_new json_sprintf
#pragma GCC poison json_dumps json_dumpb json_dumpf json_dump_callback json_loads json_loadb       \
    json_load_file json_copy
#endif

#endif
