/* Short forms for the rows of a table of fields (po_fields.h). For a list, the structure has a
 * second member, whose name ends in _count.
 *
 * Every scalar is stored as text. The parsers of po_number are stricter than YAML, and messages can
 * quote the text as written. */
#ifndef PO_FIELD_TABLE_H
#define PO_FIELD_TABLE_H

#include <stddef.h>

#include "po_fields.h"

#define TEXT(key, structure, member, expected)                                                     \
  { key, PO_FIELD_TEXT, false, expected, offsetof(structure, member), 0, 0, NULL }
#define OPTIONAL_TEXT(key, structure, member, expected)                                            \
  { key, PO_FIELD_TEXT, true, expected, offsetof(structure, member), 0, 0, NULL }
#define LIST_OF(kind, optional, key, structure, member, fields, expected)                          \
  {                                                                                                \
    key, kind, optional, expected, offsetof(structure, member),                                    \
        offsetof(structure, member##_count), sizeof *((structure *)0)->member, fields              \
  }
#define TEXTS(key, structure, member, expected)                                                    \
  LIST_OF(PO_FIELD_TEXTS, false, key, structure, member, NULL, expected)
#define OPTIONAL_TEXTS(key, structure, member, expected)                                           \
  LIST_OF(PO_FIELD_TEXTS, true, key, structure, member, NULL, expected)
#define LIST(key, structure, member, fields, expected)                                             \
  LIST_OF(PO_FIELD_LIST, false, key, structure, member, fields, expected)
#define OPTIONAL_LIST(key, structure, member, fields, expected)                                    \
  LIST_OF(PO_FIELD_LIST, true, key, structure, member, fields, expected)
#define PART(key, structure, member, fields, expected)                                             \
  { key, PO_FIELD_PART, false, expected, offsetof(structure, member), 0, 0, fields }
#define OPTIONAL_PART(key, structure, member, fields, expected)                                    \
  {                                                                                                \
    key, PO_FIELD_PART_PTR, true, expected, offsetof(structure, member), 0,                        \
        sizeof *((structure *)0)->member, fields                                                   \
  }

#endif
