/* A table of settings as an item of the sweep: one row a point, the columns are keys. */
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_csv.h"
#include "po_memory.h"

/* Whether values of a key have commas, which are semicolons in tables. */
static bool has_commas(po_key key) {
  return po_key_is_list(key) || key == PO_KEY_LAW || key == PO_KEY_PROFILE;
}

/* Returned: a copy of a cell as case files write it; NULL without memory. */
static char *value_of(const char *cell, po_key key) {
  char *value = po_copy_text(cell);
  for (char *c = value; c && has_commas(key) && *c; ++c)
    if (*c == ';')
      *c = ',';
  return value;
}

/* The keys of the columns. Status: PO_BAD_INPUT. */
static po_status find_keys(const po_csv *csv, int *keys) {
  for (size_t c = 0; c < csv->column_count; ++c) {
    keys[c] = po_texts_key(csv->columns[c]);
    if (keys[c] < 0 || keys[c] >= PO_KEY_PROFILE_APPROACH || keys[c] == PO_KEY_PROFILE_FILE)
      return po_fail(PO_BAD_INPUT, "%s:%zu: the column %s is unknown: expected names of keys",
                     csv->path, csv->column_line, csv->columns[c]);
  }
  return PO_OK;
}

static po_status fill_sweep(const po_case *kase, const po_csv *csv, const int *keys,
                            po_sweep *sweep) {
  sweep->together = po_allocate(csv->row_count, sizeof *sweep->together);
  if (!sweep->together)
    return PO_NO_MEMORY;
  for (; sweep->together_count < csv->row_count; ++sweep->together_count)
    for (size_t c = 0; c < csv->column_count; ++c) {
      const char *cell = po_csv_cell(csv, sweep->together_count, c);
      char **value = &sweep->together[sweep->together_count].values[keys[c]];
      if (strcmp(cell, "-") == 0) /* not given */
        continue;
      *value = value_of(cell, keys[c]);
      if (!*value || (keys[c] == PO_KEY_VISCOELASTIC && po_case_material_path(kase, value))) {
        sweep->together_count += 1;
        return PO_NO_MEMORY;
      }
    }
  return PO_OK;
}

po_status po_case_table_read(const po_case *kase, po_sweep *sweep, const char *where,
                             const po_yaml *yaml) {
  po_csv csv = {0};
  if (sweep->together || sweep->axis.key || sweep->axis.values)
    return po_fields_refuse(yaml, "table alone in its item", "%s.table", where);
  po_status status = po_case_path(kase, &sweep->table);
  if (!status)
    status = po_csv_read(sweep->table, sweep->table, &csv);
  int *keys = status ? NULL : po_allocate(csv.column_count, sizeof *keys);
  if (!status && !keys)
    status = PO_NO_MEMORY;
  if (!status && !csv.row_count)
    status = po_fail(PO_BAD_INPUT, "%s has no rows: expected one for each point", sweep->table);
  if (!status)
    status = find_keys(&csv, keys);
  if (!status)
    status = fill_sweep(kase, &csv, keys, sweep);
  free(keys);
  po_csv_clear(&csv);
  return status;
}
