#include "po_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_lines.h"
#include "po_csv.h"
#include "po_file.h"

/* Reports whether a name is a key of the sweep. A value of the form with this name is the same
 * number and gets no second column. */
static bool is_swept(const po_case_line *line, const char *name) {
  for (unsigned i = 0; i < line->sweep_count; ++i)
    if (strcmp(line->sweep[i].key, name) == 0)
      return true;
  return false;
}

static void add_names(po_text *rows, const po_case_line *line, const po_form_values *values) {
  for (unsigned i = 0; i < line->sweep_count; ++i)
    po_text_add(rows, "%s%s", i ? "," : "", line->sweep[i].key);
  for (size_t i = 0; i < values->count; ++i)
    if (!is_swept(line, values->items[i].name))
      po_text_add(rows, ",%s", values->items[i].name);
  po_text_add(rows, "\n");
}

/* The values of the keys of the sweep: numbers, and names as in tables, with semicolons instead of
 * commas. */
static void add_swept(po_text *rows, const po_case_line *line, size_t row) {
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    const char *value = po_case_line_value(line, i, row);
    char number[PO_NUMBER_LENGTH];
    double x;
    if (po_number_parse(value, &x)) {
      po_number_print(x, number);
      value = number;
    }
    po_text_add(rows, i ? "," : "");
    for (; *value; ++value)
      po_text_add(rows, "%c", *value == ',' ? ';' : *value);
  }
}

static po_status add_rows(po_text *rows, const po_case_file *file, const po_case_line *line,
                          const volatile sig_atomic_t *stop) {
  const po_form *form = po_form_find(line->theory);
  for (size_t row = 0; row < po_case_line_rows(line); ++row) {
    if (stop && *stop)
      return PO_INTERRUPTED;
    double cells[PO_FORM_MOST_VALUES];
    po_form_values values = {.count = 0};
    const po_form_input input = po_case_line_input(file, line, row);
    size_t count = 0;
    if (isnan(input.at))
      form->fixed(&input, &values);
    else
      form->along(&input, &values);
    if (values.status)
      return values.status;
    if (row == 0)
      add_names(rows, line, &values);
    for (size_t i = 0; i < values.count; ++i)
      if (!is_swept(line, values.items[i].name))
        cells[count++] = values.items[i].value;
    add_swept(rows, line, row);
    if (line->sweep_count && count)
      po_text_add(rows, ",");
    po_csv_add_row(rows, cells, count);
  }
  return PO_OK;
}

static po_status write_line(const po_case *kase, const po_case_line *line, const char *folder,
                            const volatile sig_atomic_t *stop, json_t **entry) {
  po_text header = {0}, rows = {0}, text = {0}, name = {0};
  char digest[PO_DIGEST_LENGTH];
  po_text_add(&name, "line-%s.csv", line->name);
  po_text_add(&header,
              "# what: pulloff theory %s along a sweep\n"
              "# units: lengths and approach in epsilon; forces and load in pi w R, of a "
              "profile without a radius in pi w epsilon, load compressive > 0; work in w; tension "
              "and traction in w/epsilon\n"
              "# command: pulloff run %s\n",
              line->theory, po_case_word(kase));
  po_status status = add_rows(&rows, kase->file, line, stop);
  po_csv_seal(&header, &rows, &text, digest);
  char *path = po_path_join(folder, po_text_string(&name));
  if (!status && (text.failed || name.failed || !path))
    status = PO_NO_MEMORY;
  if (!status)
    status = po_file_write(path, text.data, text.length);
  po_json_set(entry, "table", po_json_text(po_text_string(&name)));
  po_json_set(entry, "table_sha256", po_json_text(digest));
  free(path);
  po_text_clear(&header);
  po_text_clear(&rows);
  po_text_clear(&text);
  po_text_clear(&name);
  return status;
}

po_status po_lines_write(const po_case *kase, const char *folder, const volatile sig_atomic_t *stop,
                         json_t **lines) {
  po_status status = PO_OK;
  *lines = po_json_empty_array();
  for (unsigned i = 0; !status && i < kase->file->lines_count; ++i) {
    const po_case_line *line = &kase->file->lines[i];
    json_t *entry =
        PO_JSON_OBJECT({"name", po_json_text(line->name)}, {"theory", po_json_text(line->theory)});
    status = write_line(kase, line, folder, stop, &entry);
    po_json_append(lines, entry);
  }
  return status;
}
