/* Tables in CSV: lines `# key: value`, one line of column names, rows of as many cells.
 *
 * No quoting: no cell of ours holds a comma. */
#ifndef PO_CSV_H
#define PO_CSV_H

#include <stddef.h>

#include "po_digest.h"
#include "po_status.h"
#include "po_text.h"

typedef struct {
  char *key;
  char *value;
  size_t line;
} po_csv_header;

typedef struct {
  char *path; /* as in messages */
  char *text; /* what the pointers below point into */
  po_csv_header *headers;
  size_t header_count;
  char **columns;
  size_t column_count;
  char **cells;  /* row after row */
  size_t *lines; /* of each row in the file, from 1 */
  size_t row_count;
  size_t column_line;
  char digest[PO_DIGEST_LENGTH]; /* of all its bytes but the line `# sha256: ...` */
} po_csv;

/* Reads and checks a table. `name` is what messages call it.
 * Status: PO_CANNOT_READ with file and line: unreadable, empty, bytes that are not text, a header
 * line that is not `# key: value`, a key or a column twice, no column line, a row with too few or
 * too many cells or an empty one, a last line that does not end (a truncated file). */
po_status po_csv_read(const char *path, const char *name, po_csv *csv);

/* Frees and zeroes. */
void po_csv_clear(po_csv *csv);

/* The header of that key, or NULL. */
const po_csv_header *po_csv_find_header(const po_csv *csv, const char *key);

/* The number of that column, or -1. */
int po_csv_find_column(const po_csv *csv, const char *column);

/* The text of a cell. */
const char *po_csv_cell(const po_csv *csv, size_t row, size_t column);

/* The finite number in a cell. Status: PO_CANNOT_READ with file, line, column and what is there. */
po_status po_csv_number(const po_csv *csv, size_t row, size_t column, double *value);

/* Appends a table to `file`: the lines of its header, `# sha256: DIGEST` of header and rows, and
 * the rows with their line of column names. Returned: that digest, as po_csv_read finds it. */
void po_csv_seal(const po_text *header, const po_text *rows, po_text *file,
                 char digest[PO_DIGEST_LENGTH]);

/* Appends one row of numbers, each printed so that it reads back exactly. */
void po_csv_add_row(po_text *text, const double *values, size_t count);

#endif
