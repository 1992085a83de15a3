#include "po_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const void *at(const po_row *row, const void *owner) {
  return (const char *)owner + row->offset;
}

uint64_t po_row_bits(const po_row *row, const void *owner) {
  uint64_t wide = 0;
  uint32_t narrow = 0;
  uint8_t byte = 0;
  switch (row->size) {
  case sizeof wide:
    memcpy(&wide, at(row, owner), sizeof wide);
    return wide;
  case sizeof narrow:
    memcpy(&narrow, at(row, owner), sizeof narrow);
    return narrow;
  default:
    memcpy(&byte, at(row, owner), sizeof byte);
    return byte;
  }
}

void po_row_put_bits(const po_row *row, void *owner, uint64_t bits) {
  char *member = (char *)owner + row->offset;
  if (row->size == sizeof bits)
    memcpy(member, &bits, sizeof bits);
  else if (row->size == sizeof(uint32_t))
    memcpy(member, &(uint32_t){(uint32_t)bits}, sizeof(uint32_t));
  else
    memcpy(member, &(uint8_t){(uint8_t)bits}, sizeof(uint8_t));
}

double po_row_number(const po_row *row, const void *owner) {
  if (row->get)
    return row->get(owner);
  switch (row->type) {
  case PO_ROW_NUMBER:
    return *(const double *)at(row, owner);
  case PO_ROW_INTEGER:
    return *(const int *)at(row, owner);
  case PO_ROW_COUNT:
  case PO_ROW_FLAG:
    return (double)po_row_bits(row, owner);
  case PO_ROW_LIST:
    return (double)po_row_items(row, owner);
  default:
    return (double)NAN;
  }
}

void po_row_put(const po_row *row, void *owner, double value) {
  if (row->set)
    row->set(owner, value);
  else if (!row->get)
    *(double *)(void *)((char *)owner + row->offset) = value;
}

bool po_row_is_absent(const po_row *row, const void *owner) {
  return (row->present && !*(const bool *)((const char *)owner + row->present)) ||
         (row->omitted && row->count && po_row_items(row, owner) == 0) ||
         (row->absent && row->absent(owner));
}

size_t po_row_items(const po_row *row, const void *owner) {
  return *(const size_t *)(const void *)((const char *)owner + row->count);
}

void *po_row_item(const po_row *row, const void *owner, size_t index) {
  char *list = NULL;
  memcpy(&list, at(row, owner), sizeof list);
  return list + index * row->block->size;
}

/* Finds the rest of a path below a row. */
static po_field below(const po_row *row, const void *owner, const char *rest) {
  const bool there = owner && !po_row_is_absent(row, owner);
  if (row->type == PO_ROW_PART)
    return po_block_find(row->block, there ? at(row, owner) : NULL, rest);
  if (row->type != PO_ROW_LIST)
    return (po_field){NULL, NULL};
  char *end = NULL;
  const size_t index = strtoul(rest, &end, 10);
  if (end == rest || *end != '.')
    return (po_field){NULL, NULL};
  return po_block_find(
      row->block, there && index < po_row_items(row, owner) ? po_row_item(row, owner, index) : NULL,
      end + 1);
}

po_field po_block_find(const po_block *block, const void *owner, const char *path) {
  const size_t length = strcspn(path, ".");
  for (size_t i = 0; i < block->count; ++i) {
    const po_row *row = &block->row[i];
    po_field found = {NULL, NULL};
    if (row->type == PO_ROW_INLINE)
      found = po_block_find(row->block, owner ? at(row, owner) : NULL, path);
    else if (strncmp(row->key, path, length) == 0 && !row->key[length])
      found = path[length] ? below(row, owner, path + length + 1)
                           : (po_field){row, owner && po_row_is_absent(row, owner) ? NULL : owner};
    if (found.row)
      return found;
  }
  return (po_field){NULL, NULL};
}

double po_block_number(const po_block *block, const void *owner, const char *path) {
  const po_field field = po_block_find(block, owner, path);
  return field.row && field.owner ? po_row_number(field.row, field.owner) : (double)NAN;
}
