#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_csv.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"
#include "po_scan.h"

/* Fewer rows do not tell an axis. */
enum { LEAST_ROWS = 32 };

/* Units as files write them, and as they are written here. */
static const struct {
  const char *text, *unit;
  double size; /* m */
} UNITS[] = {{"m", "m", 1.0},           {"mm", "mm", 1e-3},
             {"um", "um", 1e-6},        {"\xC2\xB5m", "um", 1e-6}, /* micro sign */
             {"\xCE\xBCm", "um", 1e-6},                            /* Greek mu */
             {"micron", "um", 1e-6},    {"microns", "um", 1e-6},
             {"nm", "nm", 1e-9},        {"pm", "pm", 1e-12}};
enum { UNIT_COUNT = sizeof UNITS / sizeof *UNITS };
static const char UNITS_EXPECTED[] = "m, mm, um, nm or pm";

static bool take_unit(const char *text, size_t length, po_scan_column *column) {
  for (int u = 0; u < UNIT_COUNT; ++u)
    if (strlen(UNITS[u].text) == length && strncmp(UNITS[u].text, text, length) == 0) {
      column->unit = UNITS[u].unit;
      column->size = UNITS[u].size;
      return true;
    }
  return false;
}

/* Takes the unit at the end of a name: x_um, x (um), x [um], x/um, x um; or a name that is one. */
static void take_unit_of_name(const char *name, po_scan_column *column) {
  size_t end = strlen(name);
  while (end && strchr(" )]}", name[end - 1]))
    --end;
  size_t begin = end;
  while (begin && !strchr(" _([{/", name[begin - 1]))
    --begin;
  take_unit(name + begin, end - begin, column);
}

/* Splits "A,B" into two words. Returned: false if there are not two. */
static bool split_pair(const char *pair, const char *word[2], size_t length[2]) {
  const char *comma = strchr(pair, ',');
  word[0] = pair;
  word[1] = comma ? comma + 1 : pair;
  length[0] = comma ? (size_t)(comma - pair) : 0;
  length[1] = strlen(word[1]);
  return length[0] && length[1] && !strchr(word[1], ',');
}

static po_status take_units(const po_scan_request *request, po_scan *scan) {
  const char *word[2];
  size_t length[2];
  if (!request->units)
    return PO_OK;
  if (!split_pair(request->units, word, length) ||
      !take_unit(word[0], length[0], &scan->column[0]) ||
      !take_unit(word[1], length[1], &scan->column[1]))
    return po_fail(PO_BAD_INPUT, "units is %s: expected two of %s with a comma between",
                   request->units, UNITS_EXPECTED);
  return PO_OK;
}

/* The number of a column from its name or its number, from 1. Returned: -1 if there is none. */
static int find_column(const po_csv *csv, const char *word, size_t length) {
  for (size_t c = 0; c < csv->column_count; ++c)
    if (strlen(csv->columns[c]) == length && strncmp(csv->columns[c], word, length) == 0)
      return (int)c;
  char number[8] = "";
  double value = 0.0;
  if (length < sizeof number)
    memcpy(number, word, length);
  return po_number_parse(number, &value) && value >= 1.0 && value <= (double)csv->column_count &&
                 value == floor(value)
             ? (int)value - 1
             : -1;
}

static po_status find_columns(const po_scan_request *request, const po_csv *csv, po_scan *scan,
                              size_t column[2]) {
  const char *word[2];
  size_t length[2];
  if (request->columns && !split_pair(request->columns, word, length))
    return po_fail(PO_BAD_INPUT, "columns is %s: expected two names or numbers, X,Z",
                   request->columns);
  /* a column without a name is the numbers of the rows */
  const int first = csv->column_count > 2 && strcmp(csv->columns[0], "index") == 0;
  for (int i = 0; i < 2; ++i) {
    const int found = request->columns ? find_column(csv, word[i], length[i]) : first + i;
    if (found < 0 || (size_t)found >= csv->column_count)
      return po_fail(PO_CANNOT_READ, "%s:%zu: there is no column %.*s: expected one of the %zu",
                     csv->path, csv->column_line, request->columns ? (int)length[i] : 1,
                     request->columns ? word[i] : "2", csv->column_count);
    column[i] = (size_t)found;
    scan->column[i] = (po_scan_column){.unit = "", .size = 1.0};
    po_quote_text(csv->columns[found], scan->column[i].name, sizeof scan->column[i].name);
    take_unit_of_name(csv->columns[found], &scan->column[i]);
  }
  const po_status status = take_units(request, scan);
  if (status)
    return status;
  return !*scan->column[0].unit == !*scan->column[1].unit
             ? PO_OK
             : po_fail(PO_CANNOT_READ,
                       "%s:%zu: of the columns %s and %s one has a unit at the end of its name: "
                       "expected %s for both, or the option units",
                       csv->path, csv->column_line, scan->column[0].name, scan->column[1].name,
                       UNITS_EXPECTED);
}

typedef struct {
  double x, z;
} point;

static int by_x(const void *a, const void *b) {
  const double x = ((const point *)a)->x, y = ((const point *)b)->x;
  return (x > y) - (x < y);
}

/* Stores the points, heights at the same place as their mean. */
static po_status keep_points(point *points, size_t count, po_scan *scan) {
  qsort(points, count, sizeof *points, by_x);
  scan->x = po_allocate(count, sizeof *scan->x);
  scan->z = po_allocate(count, sizeof *scan->z);
  if (!scan->x || !scan->z)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < count;) {
    size_t next = k;
    double sum = 0.0;
    for (; next < count && points[next].x == points[k].x; ++next)
      sum += points[next].z;
    scan->x[scan->rows] = points[k].x;
    scan->z[scan->rows++] = sum / (double)(next - k);
    k = next;
  }
  return PO_OK;
}

/* Reads the rows. A height that is no number is one that the instrument did not measure. */
static po_status read_points(const po_csv *csv, const size_t column[2], po_scan *scan) {
  point *points = po_allocate(csv->row_count, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  size_t count = 0;
  po_status status = PO_OK;
  for (size_t k = 0; k < csv->row_count && !status; ++k) {
    const bool empty = !*po_csv_cell(csv, k, column[0]);
    status = empty ? PO_OK : po_csv_number(csv, k, column[0], &points[count].x);
    if (!status && !empty && po_number_parse(po_csv_cell(csv, k, column[1]), &points[count].z) &&
        isfinite(points[count].z))
      ++count;
  }
  scan->left_out = csv->row_count - count;
  if (!status)
    status = keep_points(points, count, scan);
  free(points);
  if (!status && scan->rows < LEAST_ROWS)
    status = po_fail(PO_CANNOT_READ, "%s: %zu rows with a height are too few: expected at least %d",
                     csv->path, scan->rows, LEAST_ROWS);
  return status;
}

po_status po_scan_read_rows(const po_scan_request *request, po_scan *scan) {
  po_csv csv;
  size_t column[2];
  po_status status = po_csv_read_export(request->path, request->path, &csv);
  if (status)
    return status;
  status = find_columns(request, &csv, scan, column);
  if (!status)
    status = read_points(&csv, column, scan);
  po_csv_clear(&csv);
  return status;
}
