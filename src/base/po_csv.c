#include "po_csv.h"

#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"

static po_status add_header(po_csv *csv, char *line, size_t number) {
  char *key = line + 1 + strspn(line + 1, " \t");
  char *colon = strchr(key, ':'), shown[PO_QUOTE_LENGTH];
  if (!colon || colon == key)
    return po_fail(PO_CANNOT_READ, "%s:%zu: '%s' is not a header: expected '# key: value'",
                   csv->path, number, po_quote(line, shown));
  *colon = '\0';
  if (po_csv_find_header(csv, key))
    return po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is given twice", csv->path, number, key);
  po_csv_header *headers = po_resize(csv->headers, csv->header_count + 1, sizeof *headers);
  if (!headers)
    return PO_NO_MEMORY;
  csv->headers = headers;
  headers[csv->header_count++] =
      (po_csv_header){.key = key, .value = colon + 1 + strspn(colon + 1, " \t"), .line = number};
  return PO_OK;
}

static size_t count_cells(const char *line) {
  size_t count = 1;
  for (; *line; ++line)
    count += *line == ',';
  return count;
}

/* Splits a line at its commas into `cells`. */
static void split(char *line, char **cells) {
  for (size_t i = 0;; ++i) {
    cells[i] = line;
    char *comma = strchr(line, ',');
    if (!comma)
      return;
    *comma = '\0';
    line = comma + 1;
  }
}

static po_status set_columns(po_csv *csv, char *line, size_t number) {
  csv->column_count = count_cells(line);
  csv->column_line = number;
  csv->columns = po_allocate(csv->column_count, sizeof *csv->columns);
  if (!csv->columns)
    return PO_NO_MEMORY;
  split(line, csv->columns);
  for (size_t i = 0; i < csv->column_count; ++i) {
    if (csv->columns[i][0] == '\0')
      return po_fail(PO_CANNOT_READ, "%s:%zu: column %zu has no name", csv->path, number, i + 1);
    double value = 0;
    if (po_number_parse(csv->columns[i], &value))
      return po_fail(PO_CANNOT_READ,
                     "%s:%zu: the column %zu is named %s: expected a line with the names of the "
                     "columns before the rows",
                     csv->path, number, i + 1, csv->columns[i]);
    if (po_csv_find_column(csv, csv->columns[i]) != (int)i)
      return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is given twice", csv->path, number,
                     csv->columns[i]);
  }
  return PO_OK;
}

static po_status add_row(po_csv *csv, char *line, size_t number) {
  const size_t count = count_cells(line), n = csv->column_count;
  if (count != n)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the row has %zu %s: expected %zu", csv->path, number,
                   line[0] ? count : 0, count == 1 && line[0] ? "cell" : "cells", n);
  /* if the row count is 0 or a power of 2, double the memory */
  if ((csv->row_count & (csv->row_count - 1)) == 0) {
    const size_t rows = csv->row_count ? 2 * csv->row_count : 1;
    char **cells = po_resize(csv->cells, rows * n, sizeof *cells);
    if (!cells)
      return PO_NO_MEMORY;
    csv->cells = cells;
    size_t *lines = po_resize(csv->lines, rows, sizeof *lines);
    if (!lines)
      return PO_NO_MEMORY;
    csv->lines = lines;
  }
  char **cells = csv->cells + csv->row_count * n;
  split(line, cells);
  for (size_t i = 0; i < n; ++i)
    if (cells[i][0] == '\0')
      return po_fail(PO_CANNOT_READ, "%s:%zu: the cell of column %s is empty", csv->path, number,
                     csv->columns[i]);
  csv->lines[csv->row_count++] = number;
  return PO_OK;
}

/* Computes the checksum of the text without the line that contains the checksum. */
static void compute_digest(po_csv *csv, size_t size) {
  static const char CHECKSUM_KEY[] = "# sha256:";
  const char *line = csv->text, *end = csv->text + size;
  while (line < end && strncmp(line, CHECKSUM_KEY, sizeof CHECKSUM_KEY - 1) != 0) {
    const char *stop = strchr(line, '\n');
    line = stop ? stop + 1 : end;
  }
  const char *stop = line < end ? strchr(line, '\n') : NULL;
  const char *rest = stop ? stop + 1 : end;
  po_digest_two(csv->text, (size_t)(line - csv->text), rest, (size_t)(end - rest), csv->digest);
}

static po_status parse(po_csv *csv, size_t size) {
  if (size == 0)
    return po_fail(PO_CANNOT_READ, "%s is empty: expected a table", csv->path);
  if (memchr(csv->text, '\0', size))
    return po_fail(PO_CANNOT_READ, "%s is not a text file: it contains a NUL byte", csv->path);
  compute_digest(csv, size);
  po_status status = PO_OK;
  size_t number = 1;
  for (char *line = csv->text, *end = csv->text + size; !status && line < end; ++number) {
    char *stop = strchr(line, '\n');
    if (!stop)
      return po_fail(PO_CANNOT_READ, "%s:%zu: the last line has no newline: the file is truncated",
                     csv->path, number);
    const bool is_header = line[0] == '#';
    const char *bad = po_quote_find(line, (size_t)(stop - line));
    if (bad)
      return po_fail(PO_CANNOT_READ,
                     "%s:%zu: the byte \\x%02x is a control character or not UTF-8: expected text",
                     csv->path, number, (unsigned char)*bad);
    *stop = '\0';
    if (stop > line && stop[-1] == '\r')
      stop[-1] = '\0';
    if (!csv->columns && is_header)
      status = add_header(csv, line, number);
    else if (!csv->columns)
      status = set_columns(csv, line, number);
    else
      status = add_row(csv, line, number);
    line = stop + 1;
  }
  if (!status && !csv->columns)
    return po_fail(PO_CANNOT_READ, "%s:%zu: there is no line of column names", csv->path, number);
  return status;
}

po_status po_csv_read(const char *path, const char *name, po_csv *csv) {
  *csv = (po_csv){0};
  size_t size = 0;
  po_status status = po_file_read(path, &csv->text, &size);
  if (!status && !(csv->path = po_copy_text(name)))
    status = PO_NO_MEMORY;
  if (!status)
    status = parse(csv, size);
  if (status)
    po_csv_clear(csv);
  return status;
}

void po_csv_clear(po_csv *csv) {
  free(csv->path);
  free(csv->text);
  free(csv->headers);
  free(csv->columns);
  free(csv->cells);
  free(csv->lines);
  *csv = (po_csv){0};
}

const po_csv_header *po_csv_find_header(const po_csv *csv, const char *key) {
  for (size_t i = 0; i < csv->header_count; ++i)
    if (strcmp(csv->headers[i].key, key) == 0)
      return &csv->headers[i];
  return NULL;
}

int po_csv_find_column(const po_csv *csv, const char *column) {
  for (size_t i = 0; i < csv->column_count; ++i)
    if (strcmp(csv->columns[i], column) == 0)
      return (int)i;
  return -1;
}

const char *po_csv_cell(const po_csv *csv, size_t row, size_t column) {
  return csv->cells[row * csv->column_count + column];
}

po_status po_csv_number(const po_csv *csv, size_t row, size_t column, double *value) {
  const char *cell = po_csv_cell(csv, row, column);
  if (po_number_parse(cell, value))
    return PO_OK;
  return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected a finite number", csv->path,
                 csv->lines[row], csv->columns[column], cell);
}

void po_csv_seal(const po_text *header, const po_text *rows, po_text *file,
                 char digest[PO_DIGEST_LENGTH]) {
  po_digest_two(po_text_string(header), header->length, po_text_string(rows), rows->length, digest);
  po_text_add_bytes(file, po_text_string(header), header->length);
  po_text_add(file, "# sha256: %s\n", digest);
  po_text_add_bytes(file, po_text_string(rows), rows->length);
  file->failed = file->failed || header->failed || rows->failed;
}

void po_csv_add_row(po_text *text, const double *values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    char number[PO_NUMBER_LENGTH];
    po_number_print(values[i], number);
    po_text_add(text, "%s%s", i ? "," : "", number);
  }
  po_text_add(text, "\n");
}
