#include "po_yaml.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_order.h"
#include "po_quote.h"
#include "po_suggest.h"

/* Returned: the value of a key in a mapping, and in *line the line of the key; NULL: no such key.
 */
static yaml_node_t *mapping_find(yaml_document_t *document, const yaml_node_t *mapping,
                                 const char *key, size_t length, size_t *line) {
  for (yaml_node_pair_t *pair = mapping->data.mapping.pairs.start;
       pair < mapping->data.mapping.pairs.top; ++pair) {
    const yaml_node_t *name = yaml_document_get_node(document, pair->key);
    if (name->type == YAML_SCALAR_NODE && name->data.scalar.length == length &&
        memcmp(name->data.scalar.value, key, length) == 0) {
      *line = name->start_mark.line + 1;
      return yaml_document_get_node(document, pair->value);
    }
  }
  return NULL;
}

/* Orders the pairs of a mapping by the bytes of their keys. */
static int by_key(const void *a, const void *b, void *document) {
  const yaml_node_t *x = yaml_document_get_node(document, ((const yaml_node_pair_t *)a)->key);
  const yaml_node_t *y = yaml_document_get_node(document, ((const yaml_node_pair_t *)b)->key);
  const size_t m = x->data.scalar.length, n = y->data.scalar.length;
  const int order = memcmp(x->data.scalar.value, y->data.scalar.value, m < n ? m : n);
  return order ? order : (m > n) - (m < n);
}

static po_status check_mapping(const po_yaml *yaml, const yaml_node_t *mapping) {
  yaml_document_t *document = yaml->document;
  const yaml_node_pair_t *pairs = mapping->data.mapping.pairs.start;
  const size_t count = (size_t)(mapping->data.mapping.pairs.top - pairs);
  for (size_t i = 0; i < count; ++i) {
    const yaml_node_t *key = yaml_document_get_node(document, pairs[i].key);
    if (key->type != YAML_SCALAR_NODE)
      return po_fail(PO_BAD_INPUT, "%s:%zu: a key is not a word: expected key: value", yaml->name,
                     key->start_mark.line + 1);
  }
  po_repeat repeat;
  const po_status status =
      po_order_find_repeat(pairs, count, sizeof *pairs, by_key, document, &repeat);
  if (status || !repeat.found)
    return status;
  const yaml_node_t *first = yaml_document_get_node(document, pairs[repeat.first].key);
  const yaml_node_t *again = yaml_document_get_node(document, pairs[repeat.again].key);
  char shown[PO_QUOTE_LENGTH];
  return po_fail(PO_BAD_INPUT, "%s:%zu: %s is given twice, first on line %zu: expected it once",
                 yaml->name, again->start_mark.line + 1,
                 po_quote((const char *)again->data.scalar.value, shown),
                 first->start_mark.line + 1);
}

/* Escapes such as "\\0" and "\\e" are the only way to write control characters in YAML. A zero byte
 * would end a string early; a terminal would execute an escape sequence. */
static po_status check_scalar(const po_yaml *yaml, const yaml_node_t *node) {
  const char *text = (const char *)node->data.scalar.value;
  const char *bad = po_quote_find(text, node->data.scalar.length);
  return bad ? po_fail(PO_BAD_INPUT,
                       "%s:%zu: a text contains the control character \\x%02x: expected none",
                       yaml->name, node->start_mark.line + 1, (unsigned char)*bad)
             : PO_OK;
}

/* Refuses aliases: a node with an alias has two places in the file, and a message could report the
 * line of the wrong one. */
static po_status check_tree(const po_yaml *yaml) {
  yaml_document_t *document = yaml->document;
  const ptrdiff_t count = document->nodes.top - document->nodes.start;
  int *uses = po_allocate((size_t)count + 1, sizeof *uses);
  if (!uses)
    return PO_NO_MEMORY;
  po_status status = PO_OK;
  for (int i = 1; !status && i <= count; ++i) {
    const yaml_node_t *node = yaml_document_get_node(document, i);
    if (node->type == YAML_MAPPING_NODE) {
      status = check_mapping(yaml, node);
      for (yaml_node_pair_t *p = node->data.mapping.pairs.start;
           !status && p < node->data.mapping.pairs.top; ++p)
        uses[p->value] += 1;
    } else if (node->type == YAML_SCALAR_NODE) {
      status = check_scalar(yaml, node);
    } else if (node->type == YAML_SEQUENCE_NODE)
      for (yaml_node_item_t *p = node->data.sequence.items.start; p < node->data.sequence.items.top;
           ++p)
        uses[*p] += 1;
  }
  for (int i = 1; !status && i <= count; ++i)
    if (uses[i] > 1)
      status = po_fail(PO_BAD_INPUT, "%s:%zu: an alias refers to this value: expected none",
                       yaml->name, yaml_document_get_node(document, i)->start_mark.line + 1);
  free(uses);
  return status;
}

/* The time of libyaml grows with the square of these numbers; a case has no anchor or directive,
 * and values on six levels at most. */
enum { MOST_LEVELS = 64, MOST_ANCHORS = 64, MOST_DIRECTIVES = 64 };

static po_status refuse_many(const po_yaml *yaml, size_t line, int most, const char *what) {
  return po_fail(PO_BAD_INPUT, "%s:%zu: the file has more than %d %s: expected a case", yaml->name,
                 line, most, what);
}

/* Lines of directives begin with a percent sign; libyaml reads all of them before its first event.
 */
static po_status check_directives(const po_yaml *yaml, const char *bytes, size_t size) {
  size_t line = 1;
  int count = 0;
  for (const char *at = bytes, *end = bytes + size; at < end; ++line) {
    if (*at == '%' && ++count > MOST_DIRECTIVES)
      return refuse_many(yaml, line, MOST_DIRECTIVES, "lines that begin with %");
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    at = stop ? stop + 1 : end;
  }
  return PO_OK;
}

/* Reads the file without building its tree. A file that is not YAML is refused when it is loaded.
 */
static po_status check_limits(po_yaml *yaml, yaml_parser_t *parser) {
  po_status status = PO_OK;
  int level = 0, anchors = 0;
  for (bool more = true; more && !status;) {
    yaml_event_t event;
    if (!yaml_parser_parse(parser, &event))
      return PO_OK;
    const size_t line = event.start_mark.line + 1;
    const bool list = event.type == YAML_SEQUENCE_START_EVENT;
    const bool mapping = event.type == YAML_MAPPING_START_EVENT;
    level += list || mapping;
    level -= event.type == YAML_SEQUENCE_END_EVENT || event.type == YAML_MAPPING_END_EVENT;
    anchors += (list && event.data.sequence_start.anchor) ||
               (mapping && event.data.mapping_start.anchor) ||
               (event.type == YAML_SCALAR_EVENT && event.data.scalar.anchor);
    if (level > MOST_LEVELS)
      status = refuse_many(yaml, line, MOST_LEVELS, "levels of lists and mappings");
    else if (anchors > MOST_ANCHORS)
      status = refuse_many(yaml, line, MOST_ANCHORS, "anchors");
    more = event.type != YAML_STREAM_END_EVENT;
    yaml_event_delete(&event);
  }
  return status;
}

/* Reads the next document. */
static po_status load_document(const po_yaml *yaml, yaml_parser_t *parser,
                               yaml_document_t *document) {
  po_memory_watch();
  if (yaml_parser_load(parser, document))
    return PO_OK;
  if (parser->error == YAML_MEMORY_ERROR || po_memory_ran_out())
    return po_fail(PO_NO_MEMORY, "%s: no memory to read it", yaml->name);
  return po_fail(PO_BAD_INPUT, "%s:%zu: not YAML: %s", yaml->name, parser->problem_mark.line + 1,
                 parser->problem ? parser->problem : "unreadable");
}

static po_status parse_document(po_yaml *yaml, yaml_parser_t *parser) {
  yaml_document_t document, more;
  po_status status = load_document(yaml, parser, &document);
  if (status)
    return status;
  yaml->document = po_allocate(1, sizeof document);
  if (!yaml->document) {
    yaml_document_delete(&document);
    return PO_NO_MEMORY;
  }
  *yaml->document = document;
  const yaml_node_t *root = yaml_document_get_root_node(yaml->document);
  if (!root)
    return po_fail(PO_BAD_INPUT, "%s:1: the file is empty: expected a case", yaml->name);
  if (root->type != YAML_MAPPING_NODE)
    return po_fail(PO_BAD_INPUT, "%s:%zu: not a case: expected key: value", yaml->name,
                   root->start_mark.line + 1);
  status = check_tree(yaml);
  if (!status)
    status = load_document(yaml, parser, &more);
  if (status)
    return status;
  const yaml_node_t *second = yaml_document_get_root_node(&more);
  const size_t line = second ? second->start_mark.line + 1 : 0;
  yaml_document_delete(&more);
  if (second)
    return po_fail(PO_BAD_INPUT, "%s:%zu: a second document begins: expected one case a file",
                   yaml->name, line);
  return PO_OK;
}

typedef po_status reader(po_yaml *yaml, yaml_parser_t *parser);

static po_status with_parser(po_yaml *yaml, const char *bytes, size_t size, reader *read) {
  yaml_parser_t parser;
  if (!yaml_parser_initialize(&parser))
    return po_fail(PO_NO_MEMORY, "%s: no memory for the parser", yaml->name);
  yaml_parser_set_input_string(&parser, (const unsigned char *)bytes, size);
  const po_status status = read(yaml, &parser);
  yaml_parser_delete(&parser);
  return status;
}

po_status po_yaml_create(const char *name, const char *bytes, size_t size, po_yaml **yaml) {
  *yaml = NULL;
  if (memchr(bytes, '\0', size))
    return po_fail(PO_BAD_INPUT,
                   "%s:1: the file is not text, it contains a zero byte, as UTF-16 does: expected "
                   "a case in UTF-8",
                   name);
  po_yaml *made = po_allocate(1, sizeof *made);
  if (!made)
    return PO_NO_MEMORY;
  made->name = po_copy_text(name);
  po_status status = made->name ? check_directives(made, bytes, size) : PO_NO_MEMORY;
  if (!status)
    status = with_parser(made, bytes, size, check_limits);
  if (!status)
    status = with_parser(made, bytes, size, parse_document);
  if (status)
    po_yaml_destroy(made);
  else
    *yaml = made;
  return status;
}

void po_yaml_destroy(po_yaml *yaml) {
  if (!yaml)
    return;
  if (yaml->document)
    yaml_document_delete(yaml->document);
  free(yaml->document);
  free(yaml->name);
  free(yaml);
}

/* Returned: the node at a path; NULL if it is absent. *line is the line of the innermost existing
 * node on the path. */
static yaml_node_t *find_node(const po_yaml *yaml, const char *path, size_t *line) {
  yaml_node_t *node = yaml_document_get_root_node(yaml->document);
  *line = node->start_mark.line + 1;
  while (*path && node) {
    if (*path == '[') {
      char *end = NULL;
      const long item = strtol(path + 1, &end, 10);
      path = *end == ']' ? end + 1 : end;
      if (node->type != YAML_SEQUENCE_NODE || item < 1 ||
          item > node->data.sequence.items.top - node->data.sequence.items.start)
        return NULL;
      node = yaml_document_get_node(yaml->document, node->data.sequence.items.start[item - 1]);
      *line = node->start_mark.line + 1;
    } else {
      path += *path == '.';
      const size_t length = strcspn(path, ".[");
      if (node->type != YAML_MAPPING_NODE)
        return NULL;
      node = mapping_find(yaml->document, node, path, length, line);
      path += length;
    }
  }
  return node;
}

size_t po_yaml_line(const po_yaml *yaml, const char *path) {
  size_t line = 1;
  find_node(yaml, path, &line);
  return line;
}

po_status po_yaml_refuse(const po_yaml *yaml, const char *path, const char *expected) {
  size_t line = 1;
  const yaml_node_t *node = find_node(yaml, path, &line);
  if (!node)
    return po_fail(PO_BAD_INPUT, "%s:%zu: %s is missing: expected %s", yaml->name, line, path,
                   expected);
  const char *value = node->type == YAML_MAPPING_NODE    ? "a mapping"
                      : node->type == YAML_SEQUENCE_NODE ? "a list"
                                                         : (const char *)node->data.scalar.value;
  char shown[PO_QUOTE_LENGTH];
  return po_suggest(po_fail(PO_BAD_INPUT, "%s:%zu: %s is %s: expected %s", yaml->name, line, path,
                            po_quote(value, shown), expected),
                    value, expected);
}
