#include "po_pins.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_number.h"

const char *const PO_WORK_COUNTER_NAMES[PO_WORK_COUNTERS] = {
    "points", "newton_iterations", "factorizations", "kernel_evaluations", "nodes"};

double po_work_count(const po_work *work, int counter) {
  const uint64_t counts[PO_WORK_COUNTERS] = {work->points, work->newton_iterations,
                                             work->factorizations, work->kernel_evaluations,
                                             work->nodes};
  return (double)counts[counter];
}

enum { POINT, DIGEST, FORCE, WORK, COLUMNS = WORK + PO_WORK_COUNTERS };

static const char *column_name(size_t column) {
  static const char *const NAMES[WORK] = {"point", "digest", "pull_off_force"};
  return column < WORK ? NAMES[column] : PO_WORK_COUNTER_NAMES[column - WORK];
}

/* Of a number that a result does not have. */
static const char NONE[] = "-";

void po_pins_add_columns(po_text *text) {
  for (size_t c = 0; c < COLUMNS; ++c)
    po_text_add(text, "%s%s", c ? "," : "", column_name(c));
  po_text_add(text, "\n");
}

void po_pins_add(const char *id, const char *digest, const po_result *result, po_text *text) {
  char number[PO_NUMBER_LENGTH];
  snprintf(number, sizeof number, "%s", NONE);
  if (result->has_pull_off)
    po_number_print(result->pull_off.force, number);
  po_text_add(text, "%s,%s,%s", id, digest, number);
  for (int counter = 0; counter < PO_WORK_COUNTERS; ++counter)
    if (result->status)
      po_text_add(text, ",%s", NONE);
    else
      po_text_add(text, ",%.0f", po_work_count(&result->work, counter));
  po_text_add(text, "\n");
}

void po_pins_add_stored(const po_pins *pins, size_t row, po_text *text) {
  for (size_t c = 0; c < COLUMNS; ++c)
    po_text_add(text, "%s%s", c ? "," : "", po_csv_cell(&pins->table, row, c));
  po_text_add(text, "\n");
}

static po_status digest_scenes(const po_case *kase, char digest[PO_DIGEST_LENGTH]) {
  po_text text = {0};
  for (size_t i = 0; i < kase->point_count; ++i) {
    po_request request = kase->points[i].request;
    request.time_limit = (double)NAN; /* may be that of one run, and does not change the results */
    po_input_add_identity(&request, &text);
    po_text_add(&text, "\n");
  }
  po_digest_bytes(po_text_string(&text), text.length, digest);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

/* Returned: FOLDER/pins/NAME.csv for a case file in FOLDER. */
static po_file_path path_of(const char *case_path, const char *case_name) {
  const char *slash = strrchr(case_path, '/');
  const int length = slash ? (int)(slash - case_path + 1) : 0;
  po_file_path path;
  snprintf(path.text, sizeof path.text, "%.*spins/%s.csv", length, case_path, case_name);
  return path;
}

static po_status check_columns(const po_csv *table) {
  bool same = table->column_count == COLUMNS;
  for (size_t c = 0; same && c < COLUMNS; ++c)
    same = strcmp(table->columns[c], column_name(c)) == 0;
  if (same)
    return PO_OK;
  po_text expected = {0};
  po_pins_add_columns(&expected);
  const po_status status =
      po_fail(PO_CANNOT_READ, "%s:%zu: expected the columns %.*s", table->path, table->column_line,
              (int)strcspn(po_text_string(&expected), "\n"), po_text_string(&expected));
  po_text_clear(&expected);
  return status;
}

po_status po_pins_open(const po_case *kase, po_pins *pins) {
  *pins = (po_pins){.path = path_of(kase->path, kase->file->name),
                    .shown = path_of(kase->shown, kase->file->name)};
  po_status status = digest_scenes(kase, pins->scenes);
  if (status || !po_path_exists(pins->path.text))
    return status;
  status = po_csv_read(pins->path.text, pins->shown.text, &pins->table);
  if (!status)
    status = po_csv_check_seal(&pins->table);
  if (!status)
    status = check_columns(&pins->table);
  if (status)
    return status;
  const po_csv_header *stored = po_csv_find_header(&pins->table, "scenes");
  pins->other_scenes = !stored || strcmp(stored->value, pins->scenes) != 0;
  if (pins->other_scenes)
    pins->table.row_count = 0;
  return PO_OK;
}

void po_pins_close(po_pins *pins) {
  po_csv_clear(&pins->table);
  *pins = (po_pins){0};
}

bool po_pins_find(const po_pins *pins, size_t point, const char *id, size_t *row) {
  const po_csv *table = &pins->table;
  *row = point; /* where it is unless the table was edited */
  if (*row >= table->row_count || strcmp(po_csv_cell(table, *row, POINT), id) != 0)
    for (*row = 0; *row < table->row_count && strcmp(po_csv_cell(table, *row, POINT), id) != 0;)
      *row += 1;
  return *row < table->row_count;
}

static po_status read_number(const po_csv *table, size_t row, size_t column, double *number) {
  *number = (double)NAN;
  return strcmp(po_csv_cell(table, row, column), NONE) == 0
             ? PO_OK
             : po_csv_number(table, row, column, number);
}

po_status po_pins_read(const po_pins *pins, size_t row, po_pin *pin) {
  pin->digest = po_csv_cell(&pins->table, row, DIGEST);
  po_status status = read_number(&pins->table, row, FORCE, &pin->force);
  for (size_t counter = 0; !status && counter < PO_WORK_COUNTERS; ++counter)
    status = read_number(&pins->table, row, WORK + counter, &pin->work[counter]);
  return status;
}
