#include "po_profile_columns.h"

#include <string.h>

#include "po_quote.h"
#include "po_text.h"

static const char *const WANTED[] = {"r", "gap", NULL};

static const po_column_unit UNITS[] = {/* m */
                                       {"", 1.0},     {"_m", 1.0},   {"_mm", 1e-3},
                                       {"_um", 1e-6}, {"_nm", 1e-9}, {"_pm", 1e-12}};
enum { UNIT_COUNT = sizeof UNITS / sizeof *UNITS };

int po_columns_find(const po_csv *csv, const char *word, const po_column_unit *units, int count,
                    int *column, int *unit) {
  const size_t length = strlen(word);
  int found = 0;
  for (size_t c = 0; c < csv->column_count; ++c)
    for (int u = 0; u < count; ++u)
      if (strncmp(csv->columns[c], word, length) == 0 &&
          strcmp(csv->columns[c] + length, units[u].name) == 0 && found++ == 0) {
        *column = (int)c;
        *unit = u;
      }
  return found;
}

void po_columns_list(const po_csv *csv, size_t size, char *text) {
  po_text list = {0};
  for (size_t c = 0; c < csv->column_count && list.length < size; ++c)
    po_text_add(&list, "%s%s", c ? " | " : "", csv->columns[c]);
  po_quote_text(po_text_string(&list), text, size);
  po_text_clear(&list);
}

static po_status find_columns(const po_csv *csv, po_profile_columns *columns) {
  int r = 0, gap = 0;
  const int radii = po_columns_find(csv, WANTED[0], UNITS, UNIT_COUNT, &columns->r, &r);
  const int gaps = po_columns_find(csv, WANTED[1], UNITS, UNIT_COUNT, &columns->gap, &gap);
  if (!radii || !gaps) {
    char names[200];
    po_columns_list(csv, sizeof names, names);
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: of the columns r and gap, with or without a unit (r_um, gap_nm), %s "
                   "missing in this line of names, which are separated by %s: %s",
                   csv->path, csv->column_line,
                   radii  ? "gap is"
                   : gaps ? "r is"
                          : "both are",
                   po_csv_separated(csv), names);
  }
  if (radii > 1 || gaps > 1)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is given in several units: expected one",
                   csv->path, csv->column_line, radii > 1 ? "r" : "gap");
  if (!r != !gap)
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: the columns are %s and %s: expected a unit in both names, or in none",
                   csv->path, csv->column_line, csv->columns[columns->r],
                   csv->columns[columns->gap]);
  columns->r_factor = UNITS[r].size;
  columns->gap_factor = UNITS[gap].size;
  columns->in_metres = r;
  return PO_OK;
}

po_status po_profile_columns_read(const char *path, po_csv *csv, po_profile_columns *columns) {
  po_status status = po_csv_read_columns(path, path, WANTED, csv);
  if (status)
    return status;
  status = find_columns(csv, columns);
  if (status)
    po_csv_clear(csv);
  return status;
}
