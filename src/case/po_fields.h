/* Structs filled from a YAML tree by a description of their members. */
#ifndef PO_FIELDS_H
#define PO_FIELDS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_yaml.h"

typedef enum {
  PO_FIELD_TEXT,    /* char *: a scalar as it is written, not empty */
  PO_FIELD_TEXTS,   /* char **, and unsigned count: a list of these, not empty */
  PO_FIELD_LIST,    /* a pointer to structs, and unsigned count: a list of mappings, not empty */
  PO_FIELD_PART,    /* a struct: a mapping */
  PO_FIELD_PART_PTR /* a pointer to a struct: a mapping */
} po_field_kind;

/* A key of a mapping, and the member of the struct that holds its value. */
typedef struct po_field {
  const char *key; /* NULL ends the fields of a struct */
  po_field_kind kind;
  bool optional;        /* the member stays NULL when the key is absent */
  const char *expected; /* as messages say it; NULL: what po_key_expected says of the key */
  size_t offset, count_offset;
  size_t size;                   /* of what the member points to; of lists, of each */
  const struct po_field *fields; /* of the struct; NULL: it is none */
} po_field;

/* Fills a struct, zeroed before, from the root of a tree. Status: PO_BAD_INPUT with file, line,
 * path, value and what was expected: a value of another kind, an unknown key, a missing one;
 * PO_NO_MEMORY. What was filled until then is to be cleared. */
po_status po_fields_load(const po_yaml *yaml, const po_field *fields, void *structure);
void po_fields_clear(const po_field *fields, void *structure);

/* The field of a path such as "checks[2].kind"; NULL: there is none. */
const po_field *po_fields_find(const po_field *fields, const char *path);

/* What its value must be. */
const char *po_field_expected(const po_field *field);

#endif
