/* JSON documents that are either complete or NULL. A value whose allocation failed is NULL, and so
 * is every object and array that would contain it; po_json_print checks this once, at the end.
 * Functions of jansson that may lose a value without reporting it cannot be called where this
 * header is included. */
#ifndef PO_JSON_VALUE_H
#define PO_JSON_VALUE_H

#include <stdbool.h>
#include <stdint.h>

#include <jansson.h>

#include "po_status.h"
#include "po_text.h"

/* Returned: a finite number; null for NaN and infinities, which JSON cannot represent. */
json_t *po_json_number(double value);

json_t *po_json_count(uint64_t value);

/* Returned: a text, converted to valid UTF-8 if necessary (po_quote_utf8); null for NULL. */
json_t *po_json_text(const char *text);

/* As po_json_text, for an allocated text, which it frees; NULL for NULL, i.e. for a text whose
 * allocation failed. */
json_t *po_json_take_text(char *text);

/* Creates an object from members {"key", value} and takes ownership of the values:
 *   PO_JSON_OBJECT({"approach", po_json_number(x)}, {"load", po_json_number(y)}).
 * If a key occurs twice, the later value counts. */
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

/* An array of texts. */
json_t *po_json_texts(char *const *texts, size_t count);

/* Adds a value to an object or an array, and takes ownership of the value. If either is NULL, or
 * memory runs out, the container is released and *object or *array becomes NULL. */
void po_json_set(json_t **object, const char *key, json_t *value);
void po_json_append(json_t **array, json_t *value);

/* Adds the members of another object, of which it takes ownership; members that exist already are
 * kept. */
void po_json_set_all(json_t **object, json_t *members);

/* Appends a document and a newline to a text: indented, or in one line; numbers have 17 significant
 * digits. Status: PO_NO_MEMORY, also for a document that is NULL; then the text has failed, too. */
po_status po_json_print(const json_t *document, po_text *text);
po_status po_json_print_line(const json_t *document, po_text *text);

/* Parses a document of `size` bytes. Repeated keys are errors. Status: PO_CANNOT_READ with the line
 * and the error; PO_NO_MEMORY. */
po_status po_json_parse(const char *bytes, size_t size, json_t **document);

/* Returned: a numeric member, NaN for null or an absent member; and a count, 0 for an absent
 * member. */
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
