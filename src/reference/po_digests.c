#include "po_digests.h"

#include <math.h>
#include <string.h>

#include "po_file.h"
#include "po_pins.h"

enum { POINT, DIGEST, FORCE, COLUMNS };

static po_status check_columns(const po_csv *table) {
  static const char *const NAMES[COLUMNS] = {"point", "digest", "pull_off_force"};
  for (size_t c = 0; c < COLUMNS; ++c)
    if (table->column_count != COLUMNS || strcmp(table->columns[c], NAMES[c]) != 0)
      return po_fail(PO_CANNOT_READ, "%s:%zu: expected the columns point, digest, pull_off_force",
                     table->path, table->column_line);
  return PO_OK;
}

po_status po_digests_open(const po_case *kase, po_reference *digests) {
  *digests = (po_reference){.name = "digests", .type = PO_REFERENCE_PINS};
  digests->path = po_pins_path(kase->path, kase->file->name, NULL, ".digests.csv");
  digests->shown = po_pins_path(kase->shown, kase->file->name, NULL, ".digests.csv");
  po_status status = digests->path && digests->shown ? PO_OK : PO_NO_MEMORY;
  if (!status && po_path_exists(digests->path)) {
    status = po_reference_read(digests->path, digests->shown, digests);
    if (!status)
      status = check_columns(&digests->table);
  }
  if (status)
    po_reference_close(digests);
  return status;
}

po_status po_digests_find(const po_reference *digests, size_t point, const char *id,
                          const char **digest, double *force) {
  const po_csv *table = &digests->table;
  size_t row = point; /* where it is unless the case has been changed */
  if (row >= table->row_count || strcmp(po_csv_cell(table, row, POINT), id) != 0)
    for (row = 0; row < table->row_count && strcmp(po_csv_cell(table, row, POINT), id) != 0;)
      ++row;
  if (row >= table->row_count)
    return PO_NOT_FOUND;
  *digest = po_csv_cell(table, row, DIGEST);
  *force = (double)NAN;
  return strcmp(po_csv_cell(table, row, FORCE), "-") == 0 ? PO_OK
                                                          : po_csv_number(table, row, FORCE, force);
}
