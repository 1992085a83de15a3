#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_csv.h"
#include "po_memory.h"
#include "po_order.h"

static const size_t MOST_ROWS = 100000;

/* Largest number of keys in the sweep of a line: tabor, amplitude, wavelength, radius, law and
 * profile with a parameter of one of them, and the variable of the form. */
enum { MOST_AXES = 8 };

static bool is_variable(const po_form *form, const char *key) {
  return form->along && strcmp(key, PO_FORM_VARIABLES[form->variable]) == 0;
}

/* Reports whether a form depends on a key of the scene. Files of profiles are given in the scene.
 */
static bool is_of_form(const po_form *form, int key) {
  if (key < 0)
    return false;
  switch (PO_KEYS[key].owner) {
  case PO_OWNER_LAW:
    return form->takes & PO_TAKES_LAW;
  case PO_OWNER_PROFILE:
    return form->takes & PO_TAKES_PROFILE && key != PO_KEY_TABLE_SCALE && key != PO_KEY_SMOOTH &&
           key != PO_KEY_PROFILE_FILE;
  default: /* the closed forms are for the unbounded half-space */
    if (key == PO_KEY_UNLOAD_SPEED)
      return form->takes & PO_TAKES_RATE;
    return PO_KEYS[key].owner == PO_OWNER_SCENE && po_key_target(key) != PO_KEY_OUTER_RADIUS;
  }
}

/* Reports whether the key gives a law, a profile or waves: then the forms of any profile apply. */
static bool is_general(int key) {
  const po_key_owner owner = PO_KEYS[key].owner;
  return owner == PO_OWNER_LAW || owner == PO_OWNER_PROFILE;
}

/* Returned: the number of combinations in the sweep of a line. */
static size_t rows_of(const po_case_line *line) {
  size_t count = 1;
  for (unsigned i = 0; i < line->sweep_count && count <= MOST_ROWS; ++i)
    count *= line->sweep[i].values_count;
  return count;
}

/* The number of consecutive rows in which a key of the sweep keeps its value. */
static size_t block_of(const po_case_line *line, unsigned axis) {
  size_t block = 1;
  for (unsigned i = axis + 1; i < line->sweep_count; ++i)
    block *= line->sweep[i].values_count;
  return block;
}

/* Returned: the value of a key of the sweep, as written, in combination number `row`. */
static const char *swept_value(const po_case_line *line, unsigned axis, size_t row) {
  return line->sweep[axis].values[row / block_of(line, axis) % line->sweep[axis].values_count];
}

/* The value of a key in one row: that of the sweep, otherwise that of the scene. A group of the
 * scene does not apply if the key that it sets is swept. NULL: the default. */
static const char *value_of(const po_case_file *file, const po_case_line *line, size_t row,
                            int key) {
  bool target = false;
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    const int swept = po_key_of_name(line->sweep[i].key);
    if (swept == key)
      return swept_value(line, i, row);
    target = target || swept == po_key_target(key);
  }
  return po_key_is_group(key) && target ? NULL : file->scene.values[key];
}

/* Returned: the input of the form for combination number `row`. */
static po_form_input input_of(const po_case_file *file, const po_case_line *line, size_t row) {
  const unsigned takes = po_form_find(line->theory)->takes;
  po_request request = po_request_default();
  po_form_input input = {.alpha = (double)NAN, .at = (double)NAN};
  /* the groups, which depend on other keys, are last */
  for (int key = 0; key < PO_KEY_END; ++key) {
    const char *text = value_of(file, line, row, key);
    if (!text)
      continue;
    po_key_set(&request, key, text);
    input.general = input.general || (is_general(key) && takes & PO_TAKES_PROFILE);
  }
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    const int key = po_key_of_name(line->sweep[i].key);
    if (key < 0 || key == PO_KEY_ALPHA)
      po_number_parse(swept_value(line, i, row), key < 0 ? &input.at : &input.alpha);
  }
  input.scene = request.scene;
  if (takes & PO_TAKES_RATE) {
    input.creep = request.creep;
    input.unload_speed = request.unload_speed;
    input.preload = request.preload;
    input.has_preload = isfinite(request.preload.approach) || !isnan(request.preload.load);
  }
  if (isnan(input.alpha) && po_scene_is_wavy(&input.scene))
    input.alpha = po_scene_alpha(&input.scene);
  return input;
}

/* Returned: the input that the form needs and the scene does not give; NULL: none is missing. */
static const char *missing_input(const po_form *form, const po_form_input *input) {
  const po_scene *scene = &input->scene;
  const bool paper = po_scene_is_of_paper(scene);
  if (!paper && !(form->takes & PO_TAKES_PROFILE))
    return "one of rigid, jkr, maugis and persson-brener, as the scene is no sphere with one wave "
           "or none";
  if (form->needs & PO_NEEDS_ELASTIC && !(scene->tabor > 0))
    return "a tabor > 0";
  if (po_form_lacks_rate(form, input))
    return "viscoelastic and unload_speed";
  if (!paper || input->general)
    return NULL;
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
  if (!is_variable(form, axis->key) && !is_of_form(form, key))
    return po_fields_refuse(yaml,
                            "tabor, coupling, amplitude, wavelength, radius, alpha, "
                            "amplitude_ratio, the variable of the form, the speed of "
                            "persson-brener, or a law, a profile or "
                            "waves if the form takes them",
                            "%s.key", where);
  const po_status status = po_axis_fill(axis, where, yaml);
  if (status)
    return status;
  po_request scratch = po_request_default();
  for (unsigned i = 0; i < axis->values_count; ++i) {
    double value = 0;
    if ((key < 0 || po_key_is_number(key)) && !po_number_parse(axis->values[i], &value))
      return po_fields_refuse(yaml, "a finite number", "%s.values[%u]", where, i + 1);
    if (key >= 0 && !po_key_set(&scratch, key, axis->values[i]))
      return po_fields_refuse(yaml, PO_KEYS[key].expected, "%s.values[%u]", where, i + 1);
  }
  return PO_OK;
}

/* Refuses the sweep of a parameter that the law or the profile of a row does not have. */
static po_status check_parameters(const po_case_file *file, const po_case_line *line,
                                  unsigned index, const po_yaml *yaml) {
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    const int key = po_key_of_name(line->sweep[i].key);
    const bool of_law = po_key_is_parameter(key, PO_OWNER_LAW);
    const int owner = of_law ? PO_KEY_LAW : PO_KEY_PROFILE;
    if (!of_law && !po_key_is_parameter(key, PO_OWNER_PROFILE))
      continue;
    const po_axis *names = NULL;
    for (unsigned k = 0; k < line->sweep_count; ++k)
      if (po_key_of_name(line->sweep[k].key) == owner)
        names = &line->sweep[k];
    for (unsigned k = 0; k < (names ? names->values_count : 1); ++k) {
      po_request request = po_request_default();
      const char *name = names ? names->values[k] : file->scene.values[owner];
      if (name)
        po_key_set(&request, owner, name);
      if (isnan(po_key_number(&request, key)))
        return po_fields_refuse(yaml, "a parameter of the law or the profile of every row",
                                "lines[%u].sweep[%u].key", index + 1, i + 1);
    }
  }
  return PO_OK;
}

/* Checks the scene of the first row, and those that differ from it in one key: a scene depends on
 * its keys separately, but for law and profile far out, which the forms check. */
static po_status check_scenes(const po_case_file *file, const po_case_line *line, unsigned index,
                              const po_yaml *yaml) {
  for (unsigned i = 0; i < line->sweep_count; ++i)
    for (unsigned k = 0; k < line->sweep[i].values_count; ++k) {
      const po_form_input input = input_of(file, line, k * block_of(line, i));
      if (!input.general || po_scene_check(&input.scene) == PO_OK)
        continue;
      char where[PO_CASE_WHERE_LENGTH];
      snprintf(where, sizeof where, "lines[%u].sweep", index + 1);
      return po_fail(PO_BAD_INPUT, "%s:%zu: %s (%s=%s): %s", yaml->name, po_yaml_line(yaml, where),
                     where, line->sweep[i].key, line->sweep[i].values[k], po_message());
    }
  return PO_OK;
}

static po_status parse_line(po_case_file *file, unsigned index, const po_yaml *yaml) {
  po_case_line *line = &file->lines[index];
  const po_form *form = po_form_find(line->theory);
  if (!po_case_is_name(line->name))
    return po_fields_refuse(yaml, NULL, "lines[%u].name", index + 1);
  if (!form)
    return po_fields_refuse(yaml, PO_FORM_NAMES, "lines[%u].theory", index + 1);
  if (line->sweep_count > MOST_AXES)
    return po_fields_refuse(yaml, "a sweep of at most 8 keys", "lines[%u].sweep", index + 1);
  for (unsigned i = 0; i < line->sweep_count; ++i) {
    char where[PO_CASE_WHERE_LENGTH];
    snprintf(where, sizeof where, "lines[%u].sweep[%u]", index + 1, i + 1);
    const po_status status = parse_axis(&line->sweep[i], form, where, yaml);
    if (status)
      return status;
    for (unsigned k = 0; k < i; ++k)
      if (strcmp(line->sweep[i].key, line->sweep[k].key) == 0)
        return po_fields_refuse(yaml, "each key swept once", "%s.key", where);
  }
  if (rows_of(line) > MOST_ROWS)
    return po_fields_refuse(yaml, "fewer than 100000 combinations", "lines[%u].sweep", index + 1);
  po_status status = check_parameters(file, line, index, yaml);
  if (!status)
    status = check_scenes(file, line, index, yaml);
  if (status)
    return status;
  const po_form_input input = input_of(file, line, 0);
  const char *missing = missing_input(form, &input);
  return missing ? po_fields_refuse(yaml, missing, "lines[%u].theory", index + 1) : PO_OK;
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
             ? po_fields_refuse(yaml, "each name once", "lines[%zu].name", repeat.again + 1)
             : status;
}

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
    const char *value = swept_value(line, i, row);
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

po_status po_case_line_table(const po_case_file *file, const po_case_line *line,
                             const volatile sig_atomic_t *stop, po_text *rows) {
  const po_form *form = po_form_find(line->theory);
  for (size_t row = 0; row < rows_of(line); ++row) {
    if (stop && *stop)
      return PO_INTERRUPTED;
    double cells[PO_FORM_MOST_VALUES];
    po_form_values values = {.count = 0};
    const po_form_input input = input_of(file, line, row);
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
