/* The columns of a table of radii and gaps. */
#ifndef PO_PROFILE_COLUMNS_H
#define PO_PROFILE_COLUMNS_H

#include <stdbool.h>

#include "po_csv.h"

/* The end of the name of a column, and the unit that it means. */
typedef struct {
  const char *name;
  double size;
} po_column_unit;

/* Finds the columns that are named `word`, with any of `count` units. Returned: their number; the
 * column and the unit of the first. */
int po_columns_find(const po_csv *csv, const char *word, const po_column_unit *units, int count,
                    int *column, int *unit);

/* Writes the names as they are in the file, as far as there is space. */
void po_columns_list(const po_csv *csv, size_t size, char *text);

typedef struct {
  int r, gap;                  /* columns of the table */
  double r_factor, gap_factor; /* unit, m; 1 without a unit */
  bool in_metres;              /* whether the names have units */
} po_profile_columns;

/* Reads a table with the columns r and gap, whose names may end in a unit of length: r_um, gap_nm.
 * Status: PO_CANNOT_READ (see po_csv_read; a column is missing, or only one has a unit);
 * PO_NO_MEMORY. */
po_status po_profile_columns_read(const char *path, po_csv *csv, po_profile_columns *columns);

#endif
