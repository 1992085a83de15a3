#include "po_fields.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_memory.h"
#include "po_quote.h"
#include "po_suggest.h"
#include "po_text.h"

enum { PATH_LENGTH = 128 };

/* The place of the loader in the tree. The path consists of known keys and numbers of items. */
typedef struct {
  const po_yaml *yaml;
  char path[PATH_LENGTH];
} place;

/* Extends the path. Returned: its previous length, the argument of `leave`. */
static size_t __attribute__((format(printf, 2, 3))) enter(place *at, const char *format, ...) {
  const size_t length = strlen(at->path);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(at->path + length, sizeof at->path - length, format, arguments);
  va_end(arguments);
  return length;
}

static size_t enter_key(place *at, const char *key) {
  return enter(at, "%s%s", *at->path ? "." : "", key);
}

static void leave(place *at, size_t length) {
  at->path[length] = '\0';
}

/* Returned: the permitted values of a field, as in messages. */
static const char *expected_of(const po_field *field) {
  return field->expected ? field->expected : PO_KEYS[po_texts_key(field->key)].expected;
}

static po_status refuse_field(const place *at, const po_field *field) {
  return po_yaml_refuse(at->yaml, at->path, expected_of(field));
}

/* Returned: the node with a number. */
static const yaml_node_t *node_of(const place *at, int number) {
  return yaml_document_get_node(at->yaml->document, number);
}

static const char *text_of(const yaml_node_t *node) {
  return (const char *)node->data.scalar.value;
}

static po_status refuse_key(const place *at, const yaml_node_t *key, const po_field *fields) {
  po_text known = {0};
  for (const po_field *field = fields; field->key; ++field)
    po_text_add(&known, "%s%s", known.length ? ", " : "", field->key);
  char shown[PO_QUOTE_LENGTH];
  const char *name = *text_of(key) ? po_quote(text_of(key), shown) : "''";
  const po_status status = po_fail(PO_BAD_INPUT, "%s:%zu: %s%s%s is unknown: expected one of %s",
                                   at->yaml->name, key->start_mark.line + 1, at->path,
                                   *at->path ? "." : "", name, po_text_string(&known));
  po_suggest(status, name, po_text_string(&known));
  po_text_clear(&known);
  return status;
}

static po_status load_mapping(place *at, const yaml_node_t *node, const po_field *fields,
                              char *structure);

/* Returned: the text of a scalar; of the spellings of infinity in YAML, that of this program. */
static const char *scalar_of(const yaml_node_t *node) {
  static const char *const SPELLINGS[] = {".inf", ".Inf", ".INF"};
  const char *text = text_of(node);
  const bool sign = *text == '+' || *text == '-';
  for (size_t k = 0; k < sizeof SPELLINGS / sizeof *SPELLINGS; ++k)
    if (node->data.scalar.style == YAML_PLAIN_SCALAR_STYLE &&
        strcmp(text + sign, SPELLINGS[k]) == 0)
      return *text == '-' ? "-inf" : "inf";
  return text;
}

static po_status load_text(const place *at, const yaml_node_t *node, const po_field *field,
                           char **to) {
  if (node->type != YAML_SCALAR_NODE || !*text_of(node))
    return refuse_field(at, field);
  *to = po_copy_text(scalar_of(node));
  return *to ? PO_OK : PO_NO_MEMORY;
}

static po_status load_part(place *at, const yaml_node_t *node, const po_field *field, char *to) {
  return node->type == YAML_MAPPING_NODE ? load_mapping(at, node, field->fields, to)
                                         : refuse_field(at, field);
}

/* Allocates the object that a member points to. po_fields_clear frees it with the struct, whatever
 * fails later. */
static char *make_room(const po_field *field, size_t count, char *structure) {
  void *room = po_allocate(count, field->size);
  memcpy(structure + field->offset, &room, sizeof room);
  return room;
}

static po_status load_list(place *at, const yaml_node_t *node, const po_field *field,
                           char *structure) {
  if (node->type != YAML_SEQUENCE_NODE ||
      node->data.sequence.items.start == node->data.sequence.items.top)
    return refuse_field(at, field);
  const yaml_node_item_t *first = node->data.sequence.items.start;
  const size_t count = (size_t)(node->data.sequence.items.top - first);
  char *items = make_room(field, count, structure);
  if (!items)
    return PO_NO_MEMORY;
  *(unsigned *)(structure + field->count_offset) = (unsigned)count;
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < count; ++i) {
    const yaml_node_t *item = node_of(at, first[i]);
    const size_t length = enter(at, "[%zu]", i + 1);
    status = field->kind == PO_FIELD_TEXTS ? load_text(at, item, field, (char **)items + i)
                                           : load_part(at, item, field, items + i * field->size);
    leave(at, length);
  }
  return status;
}

static po_status load_value(place *at, const yaml_node_t *node, const po_field *field,
                            char *structure) {
  char *room = NULL;
  switch (field->kind) {
  case PO_FIELD_TEXT:
    return load_text(at, node, field, (char **)(structure + field->offset));
  case PO_FIELD_PART:
    return load_part(at, node, field, structure + field->offset);
  case PO_FIELD_PART_PTR:
    room = make_room(field, 1, structure);
    return room ? load_part(at, node, field, room) : PO_NO_MEMORY;
  default:
    return load_list(at, node, field, structure);
  }
}

static bool has_key(const place *at, const yaml_node_t *mapping, const char *key) {
  const yaml_node_pair_t *pair = mapping->data.mapping.pairs.start;
  while (pair < mapping->data.mapping.pairs.top &&
         strcmp(text_of(node_of(at, pair->key)), key) != 0)
    ++pair;
  return pair < mapping->data.mapping.pairs.top;
}

static po_status load_mapping(place *at, const yaml_node_t *node, const po_field *fields,
                              char *structure) {
  po_status status = PO_OK;
  for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start;
       !status && pair < node->data.mapping.pairs.top; ++pair) {
    const yaml_node_t *key = node_of(at, pair->key);
    const po_field *field = fields;
    while (field->key && strcmp(field->key, text_of(key)) != 0)
      ++field;
    if (!field->key)
      return refuse_key(at, key, fields);
    const size_t length = enter_key(at, field->key);
    status = load_value(at, node_of(at, pair->value), field, structure);
    leave(at, length);
  }
  for (const po_field *field = fields; !status && field->key; ++field)
    if (!field->optional && !has_key(at, node, field->key)) {
      enter_key(at, field->key);
      status = refuse_field(at, field);
    }
  return status;
}

po_status po_fields_read(const char *name, const char *bytes, size_t size, const po_field *fields,
                         void *structure, po_yaml **yaml) {
  const po_status status = po_yaml_create(name, bytes, size, yaml);
  if (status)
    return status;
  (*yaml)->fields = fields;
  place at = {.yaml = *yaml};
  return load_mapping(&at, yaml_document_get_root_node((*yaml)->document), fields, structure);
}

void po_fields_clear(const po_field *fields, void *structure) {
  for (const po_field *field = fields; field->key; ++field) {
    char *member = (char *)structure + field->offset;
    if (field->kind == PO_FIELD_PART) {
      po_fields_clear(field->fields, member);
      continue;
    }
    char *room = NULL;
    memcpy(&room, member, sizeof room);
    const bool single = field->kind == PO_FIELD_TEXT || field->kind == PO_FIELD_PART_PTR;
    const unsigned count =
        single ? room != NULL : *(unsigned *)((char *)structure + field->count_offset);
    for (unsigned i = 0; i < count; ++i) {
      if (field->kind == PO_FIELD_TEXTS)
        free(((char **)room)[i]);
      else if (field->fields)
        po_fields_clear(field->fields, room + i * field->size);
    }
    free(room);
  }
}

/* Returned: the field at a path; NULL: no such field. */
static const po_field *find_field(const po_field *fields, const char *path) {
  const po_field *field = NULL;
  while (*path) {
    path += *path == '.';
    const size_t length = strcspn(path, ".[");
    for (field = fields; field && field->key; ++field)
      if (strncmp(field->key, path, length) == 0 && !field->key[length])
        break;
    if (!field || !field->key)
      return NULL;
    fields = field->fields;
    path += length;
    if (*path == '[')
      path += strcspn(path, "]") + 1;
  }
  return field;
}

po_status po_fields_refuse(const po_yaml *yaml, const char *expected, const char *format, ...) {
  char path[200];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(path, sizeof path, format, arguments);
  va_end(arguments);
  return po_yaml_refuse(yaml, path,
                        expected ? expected : expected_of(find_field(yaml->fields, path)));
}
