/* A table of settings as an item of the sweep: one row a point, the columns are keys. */
#include <stdlib.h>

#include "po_case_internal.h"
#include "po_key_table.h"
#include "po_memory.h"

static po_status fill_sweep(const po_case *kase, const po_csv *csv, const int *keys,
                            po_sweep *sweep) {
  bool failed = false;
  sweep->together = po_allocate(csv->row_count, sizeof *sweep->together);
  if (!sweep->together)
    return PO_NO_MEMORY;
  for (; sweep->together_count < csv->row_count && !failed; ++sweep->together_count)
    for (size_t c = 0; c < csv->column_count && !failed; ++c) {
      char **value = &sweep->together[sweep->together_count].values[keys[c]];
      *value = po_key_table_text(csv, sweep->together_count, c, keys[c], &failed);
      if (*value && keys[c] == PO_KEY_VISCOELASTIC)
        failed = po_case_material_path(kase, value) != PO_OK;
    }
  return failed ? PO_NO_MEMORY : PO_OK;
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
  if (!status)
    status = po_key_table_keys(&csv, keys);
  if (!status)
    status = fill_sweep(kase, &csv, keys, sweep);
  free(keys);
  po_csv_clear(&csv);
  return status;
}
