/* Reference tables and tables of pins: they are read, checked and queried. In an input @SHA256@
 * stands for the checksum of the table. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_csv.h"
#include "po_pins.h"
#include "po_reference.h"

/* Adds a cell in quotes: without them a cell that begins with '#' is a header, and one of blanks no
 * cell. */
static void add_cell(po_text *text, size_t column, const char *cell) {
  po_text_add(text, column ? ",\"" : "\"");
  for (const char *c = cell; *c; ++c) {
    if (*c == '"')
      po_text_add(text, "\"");
    po_text_add(text, "%c", *c);
  }
  po_text_add(text, "\"");
}

/* A table that was read and written is read again as the same table. */
static void require_written(const po_csv *csv) {
  po_text text = {0};
  po_csv back;
  for (size_t i = 0; i < csv->header_count; ++i)
    po_text_add(&text, "# %s: %s\n", csv->headers[i].key, csv->headers[i].value);
  for (size_t c = 0; c < csv->column_count; ++c)
    add_cell(&text, c, csv->columns[c]);
  po_text_add(&text, "\n");
  for (size_t r = 0; r < csv->row_count; ++r) {
    for (size_t c = 0; c < csv->column_count; ++c)
      add_cell(&text, c, po_csv_cell(csv, r, c));
    po_text_add(&text, "\n");
  }
  fuzz_require(!text.failed, "no memory for a table");
  const char *path = fuzz_path("back.csv");
  fuzz_write(path, text.data, text.length);
  po_text_clear(&text);
  fuzz_require(po_csv_read(path, "back.csv", &back) == PO_OK,
               "a table that was read is refused: %s", po_message());
  fuzz_require(back.header_count == csv->header_count && back.row_count == csv->row_count &&
                   back.column_count == csv->column_count,
               "a table has another shape when it is read back");
  for (size_t i = 0; i < csv->header_count; ++i)
    fuzz_require(strcmp(back.headers[i].key, csv->headers[i].key) == 0 &&
                     strcmp(back.headers[i].value, csv->headers[i].value) == 0,
                 "the header %s is another when it is read back", csv->headers[i].key);
  for (size_t i = 0; i < csv->row_count * csv->column_count; ++i)
    fuzz_require(strcmp(back.cells[i], csv->cells[i]) == 0,
                 "a cell is another when it is read back");
  po_csv_clear(&back);
}

/* The scene of a row, from its columns and the header. */
static po_request request_of(const po_csv *csv, size_t row) {
  po_request request = po_request_default();
  for (int key = 0; key < PO_KEY_END; ++key) {
    const po_csv_header *header = po_csv_find_header(csv, PO_KEYS[key].name);
    const int column = po_csv_find_column(csv, PO_KEYS[key].name);
    if (header)
      po_key_set(&request, (po_key)key, header->value);
    if (column >= 0)
      po_key_set(&request, (po_key)key, po_csv_cell(csv, row, (size_t)column));
  }
  return request;
}

static void ask(const po_reference *reference, const po_request *request) {
  for (int quantity = 0; quantity < PO_QUANTITY_COUNT; ++quantity) {
    po_reference_number number = {0};
    po_special_point *points = NULL;
    size_t count = 0;
    if (quantity < PO_FOLD_COUNT)
      fuzz_require_message(po_reference_find(reference, (po_quantity)quantity, request, &number));
    else if (quantity <= PO_CURVE) {
      const po_status status =
          po_reference_points(reference, (po_quantity)quantity, request, NULL, &points, &count);
      fuzz_require(!status || count == 0, "a reference that fails has points");
      fuzz_require_message(status);
    }
    free(points);
  }
  double approach = 0;
  fuzz_require_message(po_reference_complete_to(reference, request, &approach));
}

static void ask_all(const po_reference *reference) {
  const po_request any = po_request_default();
  const size_t rows = reference->table.row_count;
  ask(reference, &any);
  for (size_t row = 0; row < rows && row < 4; ++row) {
    const po_request request = request_of(&reference->table, row);
    ask(reference, &request);
  }
}

static void open_reference(const fuzz_part *table) {
  po_reference reference;
  fuzz_write(fuzz_path("table.csv"), table->bytes, table->size);
  char folder[4096];
  snprintf(folder, sizeof folder, "%s", fuzz_path("table.csv"));
  *strrchr(folder, '/') = '\0';
  const po_status status = po_reference_open(folder, "table.csv", &reference);
  fuzz_require_message(status);
  if (status)
    return;
  ask_all(&reference);
  po_reference_close(&reference);
}

static void open_pins(const fuzz_part *table) {
  po_case_file file = {.name = (char *)"table"};
  const po_case kase = {
      .path = (char *)fuzz_path("case.yaml"), .shown = (char *)"case.yaml", .file = &file};
  po_pins pins;
  fuzz_write(fuzz_path("pins/table.csv"), table->bytes, table->size);
  const po_status status = po_pins_open(&kase, &pins);
  fuzz_require_message(status);
  for (size_t row = 0; !status && row < pins.table.row_count; ++row) {
    size_t at = 0;
    po_pin pin;
    fuzz_require(po_pins_find(&pins, row, po_csv_cell(&pins.table, row, 0), &at),
                 "the pins of a point are not found");
    fuzz_require_message(po_pins_read(&pins, at, &pin));
  }
  po_pins_close(&pins);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part given;
  po_csv csv;
  fuzz_split(data, size, &given, 1);
  fuzz_write(fuzz_path("given.csv"), given.bytes, given.size);
  const po_status status = po_csv_read(fuzz_path("given.csv"), "table.csv", &csv);
  fuzz_require_message(status);
  if (!status) {
    const fuzz_token digest = {"@SHA256@", csv.digest};
    fuzz_part table = fuzz_fill(&given, &digest, 1);
    require_written(&csv);
    open_reference(&table);
    open_pins(&table);
    free(table.bytes);
    po_csv_clear(&csv);
  }
  free(given.bytes);
  return 0;
}
