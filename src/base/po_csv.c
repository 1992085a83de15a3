#include "po_csv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "po_csv_form.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"

static const char BLANKS[] = " \t";

typedef struct {
  bool comments;  /* whether lines that begin with # may stand among the rows */
  bool is_export; /* see po_csv_read_export */
} table_rules;

static bool is_blank(const char *line) {
  return line[strspn(line, BLANKS)] == '\0';
}

/* Cuts the blanks at the end off a text. */
static void trim(char *text) {
  size_t length = strlen(text);
  while (length > 0 && strchr(BLANKS, text[length - 1]))
    --length;
  text[length] = '\0';
}

/* A name, by its address, in a list of them. */
static int name_order(const void *a, const void *b) {
  const char *const x = **(char *const *const *)a, *const y = **(char *const *const *)b;
  const int order = strcmp(x, y);
  return order ? order : (x > y) - (x < y); /* all are parts of one text, in its order */
}

/* Finds the first name that is also the name of one before it. Given: the names are `step` bytes
 * apart. Returned: *index, `count` if there is none. Status: PO_NO_MEMORY. */
static po_status find_repeated(const void *names, size_t count, size_t step, size_t *index) {
  char *const **sorted = po_allocate(count + 1, sizeof *sorted);
  if (!sorted)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i)
    sorted[i] = (char *const *)((const char *)names + i * step);
  qsort(sorted, count, sizeof *sorted, name_order);
  *index = count;
  for (size_t i = 1; i < count; ++i) {
    const size_t k = (size_t)((const char *)sorted[i] - (const char *)names) / step;
    if (k < *index && strcmp(*sorted[i - 1], *sorted[i]) == 0)
      *index = k;
  }
  free(sorted);
  return PO_OK;
}

static po_status check_headers(const po_csv *csv) {
  size_t k = 0;
  const po_csv_header *const headers = csv->headers;
  if (csv->header_count == 0)
    return PO_OK;
  if (find_repeated(&headers->key, csv->header_count, sizeof *headers, &k))
    return PO_NO_MEMORY;
  return k == csv->header_count ? PO_OK
                                : po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is given twice",
                                          csv->path, headers[k].line, headers[k].key);
}

static po_status add_header(po_csv *csv, char *line, size_t number) {
  char *key = line + 1 + strspn(line + 1, " \t");
  char *colon = strchr(key, ':'), shown[PO_QUOTE_LENGTH];
  if (!colon || colon == key)
    return po_fail(PO_CANNOT_READ, "%s:%zu: '%s' is not a header: expected '# key: value'",
                   csv->path, number, po_quote(line, shown));
  *colon = '\0';
  trim(colon + 1);
  /* if the count is 0 or a power of 2, double the memory */
  if ((csv->header_count & (csv->header_count - 1)) == 0) {
    const size_t count = csv->header_count ? 2 * csv->header_count : 1;
    po_csv_header *headers = po_resize(csv->headers, count, sizeof *headers);
    if (!headers)
      return PO_NO_MEMORY;
    csv->headers = headers;
  }
  csv->headers[csv->header_count++] =
      (po_csv_header){.key = key, .value = colon + 1 + strspn(colon + 1, " \t"), .line = number};
  return PO_OK;
}

static po_status refuse_quote(const po_csv *csv, size_t number) {
  return po_fail(PO_CANNOT_READ,
                 "%s:%zu: a quoted cell does not end with its quote: expected \"...\" on one line",
                 csv->path, number);
}

static size_t most_cells(const char *line) {
  size_t most = 1;
  for (const char *c = line; *c; ++c)
    most += *c == ',';
  return most;
}

/* Names the columns of a table without names. */
static po_status number_columns(po_csv *csv, const char *line, size_t number) {
  enum { LENGTH = sizeof "column " + 20 };
  csv->column_line = number;
  csv->column_count = most_cells(line);
  csv->columns = po_allocate(csv->column_count, sizeof *csv->columns + LENGTH);
  char *name = (char *)(csv->columns + csv->column_count);
  for (size_t i = 0; csv->columns && i < csv->column_count; ++i, name += LENGTH) {
    snprintf(name, LENGTH, "column %zu", i + 1);
    csv->columns[i] = name;
  }
  return csv->columns ? PO_OK : PO_NO_MEMORY;
}

static po_status set_columns(po_csv *csv, char *line, size_t number, bool repeated) {
  const size_t most = most_cells(line);
  csv->column_line = number;
  csv->columns = po_allocate(most, sizeof *csv->columns);
  if (!csv->columns)
    return PO_NO_MEMORY;
  csv->column_count = po_csv_split(line, ',', csv->columns, most);
  if (csv->column_count == 0)
    return refuse_quote(csv, number);
  for (size_t i = 0; i < csv->column_count; ++i) {
    if (csv->columns[i][0] == '\0')
      return po_fail(PO_CANNOT_READ, "%s:%zu: column %zu has no name", csv->path, number, i + 1);
    double value = 0;
    if (po_number_parse(csv->columns[i], &value))
      return po_fail(PO_CANNOT_READ,
                     "%s:%zu: the column %zu is named %s: expected a line with the names of the "
                     "columns before the rows",
                     csv->path, number, i + 1, csv->columns[i]);
  }
  size_t twice = 0;
  if (repeated)
    return PO_OK;
  if (find_repeated(csv->columns, csv->column_count, sizeof *csv->columns, &twice))
    return PO_NO_MEMORY;
  return twice == csv->column_count
             ? PO_OK
             : po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is given twice", csv->path, number,
                       csv->columns[twice]);
}

static po_status refuse_count(const po_csv *csv, size_t number, size_t count) {
  return po_fail(PO_CANNOT_READ, "%s:%zu: the row has %zu %s: expected %zu, separated by %s%s",
                 csv->path, number, count, count == 1 ? "cell" : "cells", csv->column_count,
                 po_csv_separated(csv),
                 count > csv->column_count && csv->separator == ','
                     ? " (decimal commas need another separator)"
                     : "");
}

static po_status add_row(po_csv *csv, char *line, size_t number, bool empty) {
  const size_t n = csv->column_count;
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
  const size_t count = po_csv_split(line, ',', cells, n);
  if (count == 0)
    return refuse_quote(csv, number);
  if (count != n)
    return refuse_count(csv, number, count);
  for (size_t i = 0; i < n && !empty; ++i)
    if (cells[i][0] == '\0')
      return po_fail(PO_CANNOT_READ, "%s:%zu: the cell of column %s is empty", csv->path, number,
                     csv->columns[i]);
  csv->lines[csv->row_count++] = number;
  return PO_OK;
}

/* Computes the checksum of the text without the line that contains the checksum. Returned: whether
 * there is such a line. */
static bool compute_digest(const po_text *text, char digest[PO_DIGEST_LENGTH]) {
  static const char CHECKSUM_KEY[] = "# sha256:";
  const char *line = text->data, *end = text->data + text->length;
  while (line < end && strncmp(line, CHECKSUM_KEY, sizeof CHECKSUM_KEY - 1) != 0) {
    const char *stop = memchr(line, '\n', (size_t)(end - line));
    line = stop ? stop + 1 : end;
  }
  const char *stop = line < end ? memchr(line, '\n', (size_t)(end - line)) : NULL;
  const char *rest = stop ? stop + 1 : end;
  po_digest_two(text->data, (size_t)(line - text->data), rest, (size_t)(end - rest), digest);
  return line < end;
}

/* Whether the first cell of a line is a number, and not a name such as "1st height". */
static bool begins_with_number(const char *line) {
  char cell[PO_NUMBER_LONGEST];
  double value = 0;
  line += strspn(line, " \t\"");
  const size_t length = strcspn(line, ",\"");
  if (length >= sizeof cell)
    return false;
  memcpy(cell, line, length);
  cell[length] = '\0';
  trim(cell);
  return po_number_parse(cell, &value);
}

/* Takes the line of names; if the first line is a row, names the columns and takes the row. */
static po_status begin_columns(po_csv *csv, char *line, size_t number, table_rules rules) {
  if (!rules.is_export || !begins_with_number(line))
    return set_columns(csv, line, number, rules.is_export);
  const po_status status = number_columns(csv, line, number);
  return status ? status : add_row(csv, line, number, true);
}

static po_status parse(po_csv *csv, size_t size, table_rules rules) {
  if (size == 0)
    return po_fail(PO_CANNOT_READ, "%s is empty: expected a table", csv->path);
  if (memchr(csv->text, '\0', size))
    return po_fail(PO_CANNOT_READ, "%s is not a text file: it contains a NUL byte", csv->path);
  po_status status = PO_OK;
  size_t number = 1, blank = 0;
  for (char *line = csv->text + po_quote_mark(csv->text), *end = csv->text + size;
       !status && line < end; ++number) {
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
    for (char *last = stop; last > line && last[-1] == '\r';)
      *--last = '\0';
    if (is_blank(line))
      blank = blank || !csv->columns ? blank : number;
    else if (!csv->columns && is_header)
      status = add_header(csv, line, number);
    else if (!csv->columns)
      status = begin_columns(csv, line, number, rules);
    else if (rules.comments && is_header)
      ; /* left out */
    else if (is_header)
      status =
          po_fail(PO_CANNOT_READ,
                  "%s:%zu: a line with # stands after the names of the columns: expected a row",
                  csv->path, number);
    else if (blank) /* not after the rows */
      status = refuse_count(csv, blank, 0);
    else
      status = add_row(csv, line, number, rules.is_export);
    line = stop + 1;
  }
  if (!status)
    status = check_headers(csv);
  if (!status && !csv->columns)
    return po_fail(PO_CANNOT_READ, "%s:%zu: there is no line of column names", csv->path, number);
  return status;
}

const char *po_csv_separated(const po_csv *csv) {
  return csv->separator == ';'    ? "semicolons"
         : csv->separator == '\t' ? "tabs"
         : csv->separator == ' '  ? "blanks"
                                  : "commas";
}

static po_status read_table(const char *path, const char *name, const char *const *wanted,
                            bool is_export, po_csv *csv) {
  *csv = (po_csv){.separator = ','};
  po_text text = {0};
  po_status status = po_file_read(path, &text.data, &text.length);
  text.capacity = text.length + 1;
  if (!status && !(csv->path = po_copy_text(name)))
    status = PO_NO_MEMORY;
  const bool sealed = !status && compute_digest(&text, csv->digest);
  if (!status && text.length && !sealed)
    status = po_csv_make_plain(name, wanted, &text, &csv->separator);
  csv->text = text.data;
  if (!status)
    status = parse(csv, text.length, (table_rules){wanted && !sealed, is_export});
  if (status)
    po_csv_clear(csv);
  return status;
}

po_status po_csv_read(const char *path, const char *name, po_csv *csv) {
  return read_table(path, name, NULL, false, csv);
}

po_status po_csv_read_export(const char *path, const char *name, po_csv *csv) {
  return read_table(path, name, NULL, true, csv);
}

po_status po_csv_read_columns(const char *path, const char *name, const char *const *wanted,
                              po_csv *csv) {
  return read_table(path, name, wanted, false, csv);
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
  bool units = row == 0 && strcasecmp(cell, "nan") != 0; /* a first row without digits */
  for (size_t c = 0; c < csv->column_count; ++c)
    units = units && !strpbrk(po_csv_cell(csv, row, c), "0123456789");
  char shown[PO_QUOTE_LENGTH];
  return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected a finite number%s", csv->path,
                 csv->lines[row], csv->columns[column], po_quote(cell, shown),
                 units ? "; units belong in the names of the columns, as in r_um"
                       : po_number_fault(cell));
}

void po_csv_seal(const po_text *header, const po_text *rows, po_text *file,
                 char digest[PO_DIGEST_LENGTH]) {
  po_digest_two(po_text_string(header), header->length, po_text_string(rows), rows->length, digest);
  po_text_add_bytes(file, po_text_string(header), header->length);
  po_text_add(file, "# sha256: %s\n", digest);
  po_text_add_bytes(file, po_text_string(rows), rows->length);
  file->failed = file->failed || header->failed || rows->failed;
}

po_status po_csv_check_seal(const po_csv *csv) {
  const po_csv_header *digest = po_csv_find_header(csv, "sha256");
  if (!digest)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the header sha256 is missing", csv->path,
                   csv->column_line);
  if (strcmp(digest->value, csv->digest) != 0)
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: sha256 is %.16s...: expected %.16s..., the digest of all other lines "
                   "(damaged, or edited by hand)",
                   csv->path, digest->line, digest->value, csv->digest);
  return PO_OK;
}

void po_csv_add_row(po_text *text, const double *values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    char number[PO_NUMBER_LENGTH];
    po_number_print(values[i], number);
    po_text_add(text, "%s%s", i ? "," : "", number);
  }
  po_text_add(text, "\n");
}
