/* Prints the rows of a result, one a line, cells between tabs: definition, key, type, dimension,
 * error, null, omitted, definition of the part or words, says. tests/cli/rows.py makes tables of
 * doc/json.md and definitions of the JSON Schema of them. */
#include <stdio.h>
#include <string.h>

#include "po_result_rows.h"

static const char *const TYPES[] = {"number", "count", "integer", "flag", "text",   "word",
                                    "status", "label", "labels",  "part", "inline", "list"};
static const char *const UNITS[PO_DIMENSION_COUNT] = {"",    "",     "s",     "ε",     "",
                                                      "πwR", "πwRε", "πwR/ε", "w/(με)"};

enum { MOST_BLOCKS = 64 };
static const po_block *seen[MOST_BLOCKS];
static int seen_count;

static void print_block(const po_block *block);

static void print_rows(const char *name, const po_block *block) {
  for (size_t i = 0; i < block->count; ++i) {
    const po_row *row = &block->row[i];
    if (row->type == PO_ROW_INLINE)
      print_rows(name, row->block);
    if (row->type == PO_ROW_INLINE || row->hidden)
      continue;
    printf("%s\t%s\t%s\t%s\t%s\t%s\t%d\t", name, row->key, TYPES[row->type], UNITS[row->dimension],
           row->error, row->null, row->omitted);
    for (const char *const *word = row->names; word && *word; ++word)
      printf("%s%s", word == row->names ? "" : " ", *word);
    printf("%s%s\t%s\n", row->block ? row->block->name : "", row->take ? " status" : "", row->says);
  }
}

/* Prints a block once, and the blocks of its parts. */
static void print_block(const po_block *block) {
  for (int k = 0; k < seen_count; ++k)
    if (seen[k] == block)
      return;
  seen[seen_count++] = block;
  print_rows(block->name, block);
  for (size_t i = 0; i < block->count; ++i)
    if (block->row[i].block)
      print_block(block->row[i].block);
}

int main(void) {
  print_block(&PO_RESULT_ROWS);
  print_block(&PO_WANTED_ROWS);
  print_block(&PO_CONTACT_ROWS);
  print_block(&PO_CURVE_ROWS);
  print_block(&PO_PROFILE_ROWS);
  return 0;
}
