/* Tables in CSV format: header lines `# key: value`, one line of column names, then rows with one
 * cell for each column. As spreadsheets write them, a table may begin with a byte order mark, its
 * cells may be quoted, with blanks around them, and its lines may end in CR LF; blank lines may
 * follow the rows. */
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
  char *path; /* the name of the file in messages */
  char *text; /* the content of the file; the pointers below point into it */
  po_csv_header *headers;
  size_t header_count;
  char **columns;
  size_t column_count;
  char **cells;  /* row_count x column_count, stored row by row */
  size_t *lines; /* the line number of each row in the file, from 1 */
  size_t row_count;
  size_t column_line;
  char separator;                /* of the cells in the file: , ; tab, or ' ' for blanks */
  char digest[PO_DIGEST_LENGTH]; /* SHA-256 of all bytes except the line `# sha256: ...` */
} po_csv;

/* Reads and checks a table. Given: `name`, the name of the file in messages. Returned: csv, to be
 * cleared with po_csv_clear. Status: PO_CANNOT_READ, with file and line, if the file cannot be read
 * or is empty, has bytes that are not text, a header line that is not `# key: value`, a repeated
 * key or column, no line of column names, or a row with an empty cell or the wrong number of cells.
 * A table with a line `# sha256:` is read strictly, and needs a newline after the last line; others
 * may have any form of po_csv_form.h. */
po_status po_csv_read(const char *path, const char *name, po_csv *csv);

/* As po_csv_read, for measured curves, as instruments export them: columns without names are called
 * "column 1" and so on, names may be repeated, cells may be empty. */
po_status po_csv_read_export(const char *path, const char *name, po_csv *csv);

/* As po_csv_read, for a table with the wanted columns (po_csv_form.h). */
po_status po_csv_read_columns(const char *path, const char *name, const char *const *wanted,
                              po_csv *csv);

/* Returned: what separates the cells in the file, in words. */
const char *po_csv_separated(const po_csv *csv);

/* Frees the table and sets it to zero. */
void po_csv_clear(po_csv *csv);

/* Returned: the header with this key, or NULL. */
const po_csv_header *po_csv_find_header(const po_csv *csv, const char *key);

/* Returned: the index of the column with this name, or -1. */
int po_csv_find_column(const po_csv *csv, const char *column);

/* Returned: the text of a cell. */
const char *po_csv_cell(const po_csv *csv, size_t row, size_t column);

/* Reads the finite number in a cell. Status: PO_CANNOT_READ, with file, line, column and
 * content. */
po_status po_csv_number(const po_csv *csv, size_t row, size_t column, double *value);

/* Appends a table to `file`: the header lines, the line `# sha256: DIGEST`, the line of column
 * names and the rows. The checksum covers everything except its own line. Returned: the checksum,
 * the same that po_csv_read computes. */
void po_csv_seal(const po_text *header, const po_text *rows, po_text *file,
                 char digest[PO_DIGEST_LENGTH]);

/* Checks that the table has a header sha256, and that it is the checksum of the table. Status:
 * PO_CANNOT_READ with file and line. */
po_status po_csv_check_seal(const po_csv *csv);

/* Appends one row of numbers. Each number is printed so that it reads back to the same double. */
void po_csv_add_row(po_text *text, const double *values, size_t count);

#endif
