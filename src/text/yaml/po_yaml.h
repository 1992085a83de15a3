/* A YAML file as a tree whose nodes have line numbers.
 *
 * A path is written as in messages: "scene.radius", "checks[2].kind" (items counted from 1). */
#ifndef PO_YAML_H
#define PO_YAML_H

#include <stddef.h>

#include <yaml.h>

#include "po_status.h"

typedef struct {
  char *name;                    /* of the file in messages */
  yaml_document_t *document;     /* its root is a mapping, and all keys are scalars */
  const struct po_field *fields; /* those of the root, see po_fields.h */
} po_yaml;

/* Parses `size` bytes.
 * Given: `name`, the name of the file in messages.
 * Status: PO_BAD_INPUT with file and line: the file is empty, no text, no YAML, has more than
 * one document, a repeated key in a mapping, an alias, or a control character, or so many levels,
 * anchors or directives that libyaml would read it for minutes. */
po_status po_yaml_create(const char *name, const char *bytes, size_t size, po_yaml **yaml);
void po_yaml_destroy(po_yaml *yaml);

/* Returned: the line of the value at `path`, counted from 1. If the value is absent, the line of
 * the innermost existing mapping or list on the path. */
size_t po_yaml_line(const po_yaml *yaml, const char *path);

/* Status: PO_BAD_INPUT with the message `file:line: path is VALUE: expected EXPECTED`, or
 * `file:line: path is missing: expected EXPECTED` if the value is absent. */
po_status po_yaml_refuse(const po_yaml *yaml, const char *path, const char *expected);

#endif
