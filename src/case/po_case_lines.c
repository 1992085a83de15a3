#include "po_case_lines.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_case_parse.h"
#include "po_order.h"
#include "po_schema.h"

static const size_t MOST_ROWS = 100000;

static bool is_variable(const po_form *form, const char *key) {
  return form->along && strcmp(key, po_form_variable_name(form->variable)) == 0;
}

/* Reports whether a key of the scene can be an input of a closed form. */
static bool is_of_forms(int key) {
  return (key >= PO_KEY_TABOR && key <= PO_KEY_RADIUS) || key == PO_KEY_ALPHA ||
         key == PO_KEY_AMPLITUDE_RATIO;
}

size_t po_case_line_rows(const po_case_line *line) {
  size_t count = 1;
  for (unsigned i = 0; i < line->sweep_count && count <= MOST_ROWS; ++i)
    count *= line->sweep[i].values_count;
  return count;
}

static const char *value_of(const po_case_line *line, unsigned axis, size_t row) {
  size_t block = 1;
  for (unsigned i = axis + 1; i < line->sweep_count; ++i)
    block *= line->sweep[i].values_count;
  return line->sweep[axis].values[row / block % line->sweep[axis].values_count];
}

po_form_input po_case_line_input(const po_case_file *file, const po_case_line *line, size_t row,
                                 double swept[PO_LINE_MOST_AXES]) {
  po_request request = po_request_default();
  po_form_input input = {.alpha = (double)NAN, .at = (double)NAN};
  for (int key = 0; key < PO_KEY_END; ++key)
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

/* Returned: the input that the form needs and the scene does not give; NULL: none is missing. */
static const char *missing_input(const po_form *form, const po_form_input *input) {
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
  po_case_line *line = &file->lines[index];
  const po_form *form = po_form_find(line->theory);
  if (!po_case_is_name(line->name))
    return po_schema_refuse(yaml, NULL, "lines[%u].name", index + 1);
  if (!form)
    return po_schema_refuse(yaml, PO_FORM_NAMES, "lines[%u].theory", index + 1);
  if (line->sweep_count > PO_LINE_MOST_AXES)
    return po_schema_refuse(yaml, "a sweep of at most 5 keys", "lines[%u].sweep", index + 1);
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "lines[%u].sweep[%u]", index + 1, i + 1);
    const po_status status = parse_axis(&line->sweep[i], form, where, yaml);
    if (status)
      return status;
    for (unsigned k = 0; k < i; ++k)
      if (strcmp(line->sweep[i].key, line->sweep[k].key) == 0)
        return po_schema_refuse(yaml, "each key swept once", "%s.key", where);
  }
  if (po_case_line_rows(line) > MOST_ROWS)
    return po_schema_refuse(yaml, "fewer than 100000 combinations", "lines[%u].sweep", index + 1);
  double swept[PO_LINE_MOST_AXES];
  const po_form_input input = po_case_line_input(file, line, 0, swept);
  const char *missing = missing_input(form, &input);
  return missing ? po_schema_refuse(yaml, missing, "lines[%u].theory", index + 1) : PO_OK;
}

static int by_name(const void *a, const void *b, void *unused) {
  (void)unused;
  return strcmp(((const po_case_line *)a)->name, ((const po_case_line *)b)->name);
}

po_status po_case_lines_parse(po_case *kase, const po_yaml *yaml) {
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
