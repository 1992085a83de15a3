/* Fills structs from a YAML tree. A table of fields describes the members of each struct. */
#ifndef PO_FIELDS_H
#define PO_FIELDS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_yaml.h"

typedef enum {
  PO_FIELD_TEXT,    /* a scalar as it is written, not empty; member: char * */
  PO_FIELD_TEXTS,   /* a list of such scalars, not empty; members: char **, unsigned count */
  PO_FIELD_LIST,    /* a list of mappings, not empty; members: pointer to structs, unsigned count */
  PO_FIELD_PART,    /* a mapping; member: struct */
  PO_FIELD_PART_PTR /* a mapping; member: pointer to struct */
} po_field_kind;

/* A field: a key of a mapping, and the member of the struct that holds its value. */
typedef struct po_field {
  const char *key; /* NULL ends the fields of a struct */
  po_field_kind kind;
  bool optional;        /* the member stays NULL when the key is absent */
  const char *expected; /* permitted values, as in messages; NULL: those of the key in PO_KEYS */
  size_t offset, count_offset;
  size_t size; /* size of the object, or of an item of the list, that the member points to */
  const struct po_field *fields; /* of the struct; NULL: the member is no struct */
} po_field;

/* Parses `size` bytes, as po_yaml_create, and fills a struct from the root of the tree.
 * Given: a struct whose bytes are zero. Whatever the status, po_fields_clear must free it, and
 * po_yaml_destroy the tree. Status: PO_BAD_INPUT (that of po_yaml_create, a value of the wrong
 * kind, an unknown key, a missing key); the message states file, line, path, value and what was
 * expected. PO_NO_MEMORY. */
po_status po_fields_read(const char *name, const char *bytes, size_t size, const po_field *fields,
                         void *structure, po_yaml **yaml);
void po_fields_clear(const po_field *fields, void *structure);

/* Calls po_yaml_refuse for the path that `format` and its arguments give, such as "checks[2].kind".
 * Given: `expected`, the permitted values; NULL: those of the field at this path, which exists. */
po_status po_fields_refuse(const po_yaml *yaml, const char *expected, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
