#include "po_lines.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parse.h"
#include "po_csv.h"
#include "po_file.h"
#include "po_forms.h"
#include "po_order.h"
#include "po_schema.h"

/* So many swept keys in one line at most: tabor, amplitude, wavelength, radius and the variable. */
enum { MOST_AXES = 5, WHERE_LENGTH = 64, MOST_CELLS = MOST_AXES + PO_FORM_MOST_VALUES };

static const size_t MOST_ROWS = 100000;

static bool is_variable(const po_form *form, const char *key) {
  return form->along && strcmp(key, po_form_variable_name(form->variable)) == 0;
}

/* A key that a closed form knows of. */
static bool is_of_forms(int key) {
  return (key >= PO_KEY_TABOR && key <= PO_KEY_RADIUS) || key == PO_KEY_ALPHA ||
         key == PO_KEY_AMPLITUDE_RATIO;
}

static size_t row_count(const po_series *line) {
  size_t count = 1;
  for (unsigned i = 0; i < line->sweep_count && count <= MOST_ROWS; ++i)
    count *= line->sweep[i].values_count;
  return count;
}

static const char *value_of(const po_series *line, unsigned axis, size_t row) {
  size_t block = 1;
  for (unsigned i = axis + 1; i < line->sweep_count; ++i)
    block *= line->sweep[i].values_count;
  return line->sweep[axis].values[row / block % line->sweep[axis].values_count];
}

/* What the form is asked of in one row, and the swept values. */
static po_form_input input_of(const po_case_file *file, const po_series *line, size_t row,
                              double *swept) {
  po_request request = po_request_default();
  po_form_input input = {.alpha = (double)NAN, .at = (double)NAN};
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (file->scene.values[key])
      po_key_set(&request, (po_key)key, file->scene.values[key]);
  for (int groups = 0; groups < 2; ++groups)
    for (unsigned i = 0; i < line->sweep_count; ++i) {
      const int key = po_key_of_name(line->sweep[i].key);
      const char *text = value_of(line, i, row);
      double value = (double)NAN;
      po_number_parse(text, &value);
      swept[i] = value;
      if (key < 0)
        input.at = value;
      else if (po_key_is_group(key) == (groups > 0))
        po_key_set(&request, (po_key)key, text);
      if (key == PO_KEY_ALPHA)
        input.alpha = value;
    }
  input.scene = request.scene;
  if (isnan(input.alpha) && po_scene_is_wavy(&input.scene))
    input.alpha = po_scene_alpha(&input.scene);
  return input;
}

static const char *lacking(const po_form *form, const po_form_input *input) {
  const po_scene *scene = &input->scene;
  if (form->needs & PO_NEEDS_ELASTIC && !(scene->tabor > 0))
    return "a tabor > 0";
  if (form->needs & PO_NEEDS_AMPLITUDE && !(scene->amplitude > 0))
    return "an amplitude > 0";
  if (form->needs & PO_NEEDS_ALPHA && isnan(input->alpha))
    return "alpha, or amplitude and wavelength";
  if (form->needs & PO_NEEDS_WAVES && !(scene->amplitude == 0 || scene->wavelength > 0))
    return "amplitude and wavelength";
  return NULL;
}

static po_status parse_axis(po_axis *axis, const po_form *form, const char *where,
                            const po_yaml *yaml) {
  const int key = po_key_of_name(axis->key);
  if (!is_variable(form, axis->key) && !is_of_forms(key))
    return po_schema_refuse(yaml,
                            "tabor, amplitude, wavelength, radius, alpha, amplitude_ratio or "
                            "the variable of the form",
                            "%s.key", where);
  const po_status status = po_axis_fill(axis, where, yaml);
  if (status)
    return status;
  po_request scratch = po_request_default();
  for (unsigned i = 0; i < axis->values_count; ++i) {
    double value = 0;
    if (!po_number_parse(axis->values[i], &value))
      return po_schema_refuse(yaml, "a finite number", "%s.values[%u]", where, i + 1);
    if (key >= 0 && !po_key_set(&scratch, (po_key)key, axis->values[i]))
      return po_schema_refuse(yaml, po_key_expected((po_key)key), "%s.values[%u]", where, i + 1);
  }
  return PO_OK;
}

static po_status parse_line(po_case_file *file, unsigned index, const po_yaml *yaml) {
  po_series *line = &file->lines[index];
  const po_form *form = po_form_find(line->theory);
  if (!po_case_is_name(line->name))
    return po_schema_refuse(yaml, NULL, "lines[%u].name", index + 1);
  if (!form)
    return po_schema_refuse(yaml, PO_FORM_NAMES, "lines[%u].theory", index + 1);
  if (line->sweep_count > MOST_AXES)
    return po_schema_refuse(yaml, "a sweep of at most 5 keys", "lines[%u].sweep", index + 1);
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    char where[WHERE_LENGTH];
    snprintf(where, sizeof where, "lines[%u].sweep[%u]", index + 1, i + 1);
    const po_status status = parse_axis(&line->sweep[i], form, where, yaml);
    if (status)
      return status;
    for (unsigned k = 0; k < i; ++k)
      if (strcmp(line->sweep[i].key, line->sweep[k].key) == 0)
        return po_schema_refuse(yaml, "each key swept once", "%s.key", where);
  }
  if (row_count(line) > MOST_ROWS)
    return po_schema_refuse(yaml, "fewer than 100000 combinations", "lines[%u].sweep", index + 1);
  double swept[MOST_AXES];
  const po_form_input input = input_of(file, line, 0, swept);
  const char *lack = lacking(form, &input);
  return lack ? po_schema_refuse(yaml, lack, "lines[%u].theory", index + 1) : PO_OK;
}

static int by_name(const void *a, const void *b, void *unused) {
  (void)unused;
  return strcmp(((const po_series *)a)->name, ((const po_series *)b)->name);
}

po_status po_lines_parse(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->lines_count; ++i)
    status = parse_line(kase->file, i, yaml);
  po_repeat repeat = {.found = false};
  if (!status)
    status = po_order_find_repeat(file->lines, file->lines_count, sizeof *file->lines, by_name,
                                  NULL, &repeat);
  return repeat.found
             ? po_schema_refuse(yaml, "each name once", "lines[%zu].name", repeat.again + 1)
             : status;
}

/* Names in a table stay apart: a contact radius swept and one given back are the same number. */
static bool is_swept(const po_series *line, const char *name) {
  for (unsigned i = 0; i < line->sweep_count; ++i)
    if (strcmp(line->sweep[i].key, name) == 0)
      return true;
  return false;
}

static void add_names(po_text *rows, const po_series *line, const po_form_values *values) {
  for (unsigned i = 0; i < line->sweep_count; ++i)
    po_text_add(rows, "%s%s", i ? "," : "", line->sweep[i].key);
  for (size_t i = 0; i < values->count; ++i)
    if (!is_swept(line, values->items[i].name))
      po_text_add(rows, ",%s", values->items[i].name);
  po_text_add(rows, "\n");
}

static po_status add_rows(po_text *rows, const po_case_file *file, const po_series *line,
                          const volatile sig_atomic_t *stop) {
  const po_form *form = po_form_find(line->theory);
  for (size_t row = 0; row < row_count(line); ++row) {
    if (stop && *stop)
      return PO_INTERRUPTED;
    double cells[MOST_CELLS];
    po_form_values values = {.count = 0};
    const po_form_input input = input_of(file, line, row, cells);
    size_t count = line->sweep_count;
    if (isnan(input.at))
      form->fixed(&input, &values);
    else
      form->along(&input, &values);
    if (row == 0)
      add_names(rows, line, &values);
    for (size_t i = 0; i < values.count; ++i)
      if (!is_swept(line, values.items[i].name))
        cells[count++] = values.items[i].value;
    po_csv_add_row(rows, cells, count);
  }
  return PO_OK;
}

static po_status write_line(const po_case *kase, const po_series *line, const char *folder,
                            const volatile sig_atomic_t *stop, json_t **entry) {
  po_text header = {0}, rows = {0}, text = {0}, name = {0};
  char digest[PO_DIGEST_LENGTH];
  po_text_add(&name, "line-%s.csv", line->name);
  po_text_add(&header,
              "# what: pulloff theory %s along a sweep\n"
              "# units: lengths and approach in epsilon; forces and load in pi w R, load "
              "compressive > 0; work in w; tension and traction in w/epsilon\n"
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
    const po_series *line = &kase->file->lines[i];
    json_t *entry =
        PO_JSON_OBJECT({"name", po_json_text(line->name)}, {"theory", po_json_text(line->theory)});
    status = write_line(kase, line, folder, stop, &entry);
    po_json_append(lines, entry);
  }
  return status;
}
