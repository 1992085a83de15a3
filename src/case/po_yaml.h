/* A YAML file as a tree that knows its lines.
 *
 * A path is written as in messages: "scene.radius", "checks[2].kind" (items counted from 1). */
#ifndef PO_YAML_H
#define PO_YAML_H

#include <stddef.h>

#include <yaml.h>

#include "po_status.h"

typedef struct po_yaml po_yaml;

/* Parses `size` bytes. `name` is what messages call the file.
 * Status: PO_BAD_INPUT with file and line: empty, not text, not YAML, more than one document, a key
 * twice in a mapping, an alias, a control character. */
po_status po_yaml_create(const char *name, const char *bytes, size_t size, po_yaml **yaml);
void po_yaml_destroy(po_yaml *yaml);

/* The tree itself, as libyaml has it: its root is a mapping, and keys are scalars. */
yaml_document_t *po_yaml_document(const po_yaml *yaml);

/* The name given at creation. */
const char *po_yaml_name(const po_yaml *yaml);

/* The line of the value at `path`, from 1; when it is absent, the line of the nearest thing on the
 * way to it. */
size_t po_yaml_line(const po_yaml *yaml, const char *path);

/* PO_BAD_INPUT with the message `file:line: path is VALUE: expected EXPECTED`, or `... is missing`.
 */
po_status po_yaml_refuse(const po_yaml *yaml, const char *path, const char *expected);

#endif
