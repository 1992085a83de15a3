/* Prints the keys of a scene and the rows of a result, one a line, cells between tabs: definition,
 * key, type, unit, name of the SI unit, error, null, omitted, definition of the part or words,
 * says; of a key says is its owner. tools/rows.py makes tables of doc/json.md and definitions of
 * the JSON Schema of them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_law_kind.h"
#include "po_profile_kind.h"
#include "po_result_rows.h"
#include "po_si.h"

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
    const po_si_unit si = po_si_unit_of(&(po_units){1.0, 1.0, 1.0}, row->dimension);
    printf("%s\t%s\t%s\t%s\t%s\t%s\t%s\t%d\t", name, row->key, TYPES[row->type],
           UNITS[row->dimension], row->dimension >= PO_DIMENSION_LENGTH ? si.name : "", row->error,
           row->null, row->omitted);
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

/* The type of the value of a key that is a number. */
static const char *type_of_number(int key) {
  if (key == PO_KEY_NODES)
    return "count";
  const char *expected = PO_KEYS[key].expected;
  return strstr(expected, "inf") ? "extended" : strstr(expected, "auto") ? "automatic" : "number";
}

static void print_words(int key) {
#define LAW(law, text) printf("%s ", PO_##law.name);
#define PROFILE(profile, text) printf("%s ", PO_##profile.name);
  if (key == PO_KEY_LAW) {
    PO_LAW_ROWS(LAW)
  } else if (key == PO_KEY_PROFILE) {
    PO_PROFILE_ROWS(PROFILE)
    PROFILE(TABLE, "")
  }
  for (int k = 0; key == PO_KEY_SCHEME && PO_SCHEMES[k]; ++k)
    printf("%s ", PO_SCHEMES[k]);
  for (int k = 0; key == PO_KEY_GRADING && PO_GRADINGS[k]; ++k)
    printf("%s ", PO_GRADINGS[k]);
  for (int k = 0; key == PO_KEY_RANGE && PO_RANGES[k]; ++k)
    printf("%s ", PO_RANGES[k]);
}

static void print_keys(void) {
  static const char *const OWNERS[] = {"scene", "law", "profile", "mesh", "trace"};
  const po_request usual = po_input_default();
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    const bool number = po_key_is_number((po_key)key);
    const bool creeps = po_key_is_of_time(key);
    const bool text =
        key == PO_KEY_PROFILE_FILE || key == PO_KEY_WAVES || key == PO_KEY_VISCOELASTIC;
    const bool null = text || creeps || (number && isnan(po_key_number(&usual, (po_key)key)));
    printf("input\t%s\t%s\t\t\t\t%s\t%d\t", PO_KEYS[key].name,
           number ? type_of_number(key)
           : text ? "text"
                  : "word",
           null ? "if not given" : "", creeps);
    print_words(key);
    printf("\t%s\n", OWNERS[PO_KEYS[key].owner]);
  }
}

int main(void) {
  print_keys();
  print_block(&PO_RESULT_ROWS);
  print_block(&PO_WANTED_ROWS);
  print_block(&PO_CONTACT_ROWS);
  print_block(&PO_CURVE_ROWS);
  print_block(&PO_PROFILE_ROWS);
  return 0;
}
