#include "po_key_table.h"

#include <string.h>

#include "po_memory.h"

/* Whether values of a key have commas, which are semicolons in tables. */
static bool has_commas(po_key key) {
  return po_key_is_list(key) || key == PO_KEY_LAW || key == PO_KEY_PROFILE;
}

po_status po_key_table_keys(const po_csv *csv, int *keys) {
  if (!csv->row_count)
    return po_fail(PO_BAD_INPUT, "%s has no rows: expected one for each point", csv->path);
  for (size_t c = 0; c < csv->column_count; ++c) {
    keys[c] = po_texts_key(csv->columns[c]);
    if (keys[c] < 0 || keys[c] >= PO_KEY_PROFILE_APPROACH || keys[c] == PO_KEY_PROFILE_FILE)
      return po_fail(PO_BAD_INPUT, "%s:%zu: the column %s is unknown: expected names of keys",
                     csv->path, csv->column_line, csv->columns[c]);
  }
  return PO_OK;
}

char *po_key_table_text(const po_csv *csv, size_t row, size_t column, po_key key, bool *failed) {
  const char *cell = po_csv_cell(csv, row, column);
  if (strcmp(cell, "-") == 0)
    return NULL;
  char *text = po_copy_text(cell);
  *failed = *failed || !text;
  for (char *c = text; c && has_commas(key) && *c; ++c)
    if (*c == ';')
      *c = ',';
  return text;
}
