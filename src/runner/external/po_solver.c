#include "po_solver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case.h"
#include "po_field_table.h"
#include "po_file.h"
#include "po_input.h"
#include "po_memory.h"
#include "po_text.h"

/* Seconds, where the manifest gives none. The start of Octave, Julia or MATLAB takes up to half a
 * minute on a machine with other work. */
static const double START_LIMIT = 60, TIME_LIMIT = 600;

static const char NAMES[] = "a list of names of quantities that a solver can compute: "
                            "pull_off_force, pull_off_approach, contact_radius, hysteresis_force, "
                            "hysteresis_approach, hysteresis_loss, jumps, fold_count, folds, "
                            "extrema, curve",
                  SECONDS[] = "a finite number of seconds > 0";

static const po_field KEY[] = {
    TEXT("key", po_solver_key, axis.key, "a key of the scene"),
    OPTIONAL_TEXTS("values", po_solver_key, axis.values, "a list of values"),
    OPTIONAL_TEXT("from", po_solver_key, axis.from_text, "a finite number"),
    OPTIONAL_TEXT("to", po_solver_key, axis.to_text, "a finite number >= from"),
    {0},
};

static const po_field CAN[] = {
    LIST("scene", po_solver_can, scene, KEY, "a list of {key}, {key, values} or {key, from, to}"),
    TEXTS("quantities", po_solver_can, quantities, NAMES),
    TEXT("unstable", po_solver_can, unstable, "true or false"),
    {0},
};

static const po_field KNOB[] = {
    TEXT("name", po_solver_knob, name, "the name of the knob"),
    TEXTS("values", po_solver_knob, values, "a list of values, from coarse to fine"),
    {0},
};

static const po_field MANIFEST[] = {
    TEXT("protocol", po_solver_file, protocol, PO_SOLVER_PROTOCOL),
    TEXT("solver", po_solver_file, name, "letters, digits, _ and -; not pulloff"),
    TEXTS("command", po_solver_file, command, "a list of words: a program and its arguments"),
    OPTIONAL_TEXTS("files", po_solver_file, files, "a list of files, relative to the manifest"),
    OPTIONAL_TEXTS("environment", po_solver_file, environment,
                   "a list of names of environment variables"),
    PART("can", po_solver_file, can, CAN, "a mapping of scene, quantities and unstable"),
    OPTIONAL_PART("knob", po_solver_file, knob, KNOB, "a mapping of name and values"),
    OPTIONAL_TEXT("approach_step", po_solver_file, approach_step_text, "a finite number >= 0"),
    OPTIONAL_TEXT("start_limit", po_solver_file, start_limit_text, SECONDS),
    OPTIONAL_TEXT("time_limit", po_solver_file, time_limit_text, SECONDS),
    {0},
};

/* Parses an item of can.scene. */
static po_status parse_key(const po_yaml *yaml, po_solver_key *item, unsigned number) {
  const po_axis *axis = &item->axis;
  const int key = po_key_of_name(axis->key);
  if (key < 0 || !po_key_is_of_scene(key))
    return po_fields_refuse(yaml, NULL, "can.scene[%u].key", number);
  for (unsigned v = 0; v < axis->values_count; ++v) {
    po_request request = po_input_default();
    if (!po_key_set(&request, key, axis->values[v]))
      return po_fields_refuse(yaml, PO_KEYS[key].expected, "can.scene[%u].values[%u]", number,
                              v + 1);
  }
  item->from = -INFINITY;
  item->to = INFINITY;
  if (axis->from_text && !po_number_parse(axis->from_text, &item->from))
    return po_fields_refuse(yaml, NULL, "can.scene[%u].from", number);
  if (axis->to_text && !po_number_parse(axis->to_text, &item->to))
    return po_fields_refuse(yaml, NULL, "can.scene[%u].to", number);
  if ((axis->from_text || axis->to_text) && (axis->values || !po_key_is_number(key)))
    return po_fields_refuse(yaml, "either values, or from and to for a number", "can.scene[%u]",
                            number);
  return item->from > item->to ? po_fields_refuse(yaml, NULL, "can.scene[%u].to", number) : PO_OK;
}

/* Reports whether a quantity describes parts of the branch on which equilibria are unstable. */
static bool needs_unstable(po_quantity quantity) {
  return quantity == PO_FOLD_COUNT || quantity == PO_FOLDS || quantity == PO_EXTREMA ||
         quantity == PO_CURVE;
}

/* Reports whether an external solver can compute a quantity: it has a place in an answer. */
static bool has_answer(po_quantity quantity) {
  return po_quantity_is(quantity, PO_OF_PULL_OFF) || po_quantity_is(quantity, PO_OF_LOOP) ||
         needs_unstable(quantity);
}

static po_status parse_quantities(const po_yaml *yaml, po_solver *solver) {
  const po_solver_can *can = &solver->file->can;
  for (unsigned i = 0; i < can->quantities_count; ++i) {
    const int quantity = po_quantity_of_name(can->quantities[i]);
    if (quantity == PO_QUANTITY_COUNT || !has_answer((po_quantity)quantity))
      return po_fields_refuse(yaml, NAMES, "can.quantities[%u]", i + 1);
    if (!solver->unstable && needs_unstable((po_quantity)quantity))
      return po_fields_refuse(
          yaml,
          "a quantity of stable equilibria, because can.unstable is false: "
          "pull_off_force, pull_off_approach, contact_radius, hysteresis_force, "
          "hysteresis_approach, hysteresis_loss or jumps",
          "can.quantities[%u]", i + 1);
    solver->quantities |= 1U << quantity;
  }
  return PO_OK;
}

static po_status parse_numbers(const po_yaml *yaml, po_solver *solver) {
  const po_solver_file *file = solver->file;
  const struct {
    const char *path, *text;
    double absent, *number;
  } items[] = {{"approach_step", file->approach_step_text, 0, &solver->approach_step},
               {"start_limit", file->start_limit_text, START_LIMIT, &solver->start_limit},
               {"time_limit", file->time_limit_text, TIME_LIMIT, &solver->time_limit}};
  for (size_t i = 0; i < sizeof items / sizeof *items; ++i) {
    double number = items[i].absent;
    const bool good = !items[i].text || po_number_parse(items[i].text, &number);
    if (!good || number < 0 || (number == 0 && items[i].absent > 0))
      return po_fields_refuse(yaml, NULL, "%s", items[i].path);
    *items[i].number = number;
  }
  return PO_OK;
}

/* Chooses the value of the knob, and composes the name of the solver. */
static po_status choose_knob(po_solver *solver, const char *wanted) {
  const po_solver_knob *knob = solver->file->knob;
  const unsigned last = knob ? knob->values_count - 1 : 0;
  po_text name = {0};
  for (unsigned i = 0; knob && i <= last; ++i)
    if (!wanted ? i == last : strcmp(knob->values[i], wanted) == 0)
      solver->knob = knob->values[i];
  if (wanted && !solver->knob)
    return po_fail(PO_BAD_INPUT, "--knob is %s: expected %s", wanted,
                   knob ? "one of the values of the knob in the manifest"
                        : "no such option, as the manifest has no knob");
  po_text_add(&name, "%s", solver->file->name);
  if (knob && solver->knob != knob->values[last])
    po_text_add(&name, "@%s", solver->knob);
  solver->name = po_text_take(&name);
  return solver->name ? PO_OK : PO_NO_MEMORY;
}

static po_status parse_manifest(const po_yaml *yaml, const char *knob, po_solver *solver) {
  const po_solver_file *file = solver->file;
  po_status status = PO_OK;
  if (strcmp(file->protocol, PO_SOLVER_PROTOCOL) != 0)
    return po_fields_refuse(yaml, NULL, "protocol");
  if (!po_case_is_name(file->name) || strcmp(file->name, "pulloff") == 0)
    return po_fields_refuse(yaml, NULL, "solver");
  solver->unstable = strcmp(file->can.unstable, "true") == 0;
  if (!solver->unstable && strcmp(file->can.unstable, "false") != 0)
    return po_fields_refuse(yaml, NULL, "can.unstable");
  for (unsigned i = 0; !status && i < file->can.scene_count; ++i)
    status = parse_key(yaml, &file->can.scene[i], i + 1);
  if (!status)
    status = parse_quantities(yaml, solver);
  for (unsigned i = 0; !status && file->knob && i < file->knob->values_count; ++i)
    if (strchr(file->knob->values[i], '/'))
      status = po_fields_refuse(yaml, NULL, "knob.values");
  if (!status)
    status = parse_numbers(yaml, solver);
  return status ? status : choose_knob(solver, knob);
}

char *po_solver_replace(const char *word, const char *name, const char *value) {
  po_text text = {0};
  po_text_add(&text, "%s", "");
  for (const char *at = word; *at;) {
    const char *next = strstr(at, name);
    po_text_add_bytes(&text, at, next ? (size_t)(next - at) : strlen(at));
    if (next)
      po_text_add(&text, "%s", value);
    at = next ? next + strlen(name) : at + strlen(at);
  }
  return po_text_take(&text);
}

static po_status make_command(const po_yaml *yaml, po_solver *solver) {
  const po_solver_file *file = solver->file;
  solver->command = po_allocate(file->command_count + 1, sizeof *solver->command);
  if (!solver->command)
    return PO_NO_MEMORY;
  for (unsigned i = 0; i < file->command_count; ++i)
    if (!(solver->command[i] = po_solver_replace(file->command[i], "{here}", solver->here.text)))
      return PO_NO_MEMORY;
  const bool absolute = solver->command[0][0] == '/';
  const po_file_path found = po_program_find(solver->command[0]);
  if (!*found.text || (!absolute && strchr(solver->command[0], '/')))
    return po_yaml_refuse(
        yaml, "command[1]",
        absolute ? "a program that can be executed"
                 : "a program in PATH, an absolute path, or a path that begins with {here}");
  free(solver->command[0]);
  solver->command[0] = po_copy_text(found.text);
  return solver->command[0] ? PO_OK : PO_NO_MEMORY;
}

/* Adds the digest of a file to a text, if it is one. */
static po_status add_file(const po_solver *solver, const char *name, bool needed, po_text *text) {
  const po_file_path path = po_path_join(solver->here.text, name);
  char *bytes = NULL, digest[PO_DIGEST_LENGTH];
  size_t size = 0;
  po_status status = PO_OK;
  if (needed || po_path_exists(path.text))
    status = po_file_read(path.text, &bytes, &size);
  if (status == PO_CANNOT_READ && !needed)
    status = PO_OK; /* a folder, for example */
  if (bytes) {
    po_digest_bytes(bytes, size, digest);
    po_text_add(text, "%s|", digest);
  }
  free(bytes);
  return status;
}

/* The manifest, the files that its command names, and those that it lists. */
static po_status make_digest(const char *bytes, size_t size, po_solver *solver) {
  const po_solver_file *file = solver->file;
  po_text text = {0};
  po_text_add(&text, PO_SOLVER_PROTOCOL "|%s|", solver->knob ? solver->knob : "");
  po_text_add_bytes(&text, bytes, size);
  po_status status = PO_OK;
  for (unsigned i = 1; !status && i < file->command_count; ++i)
    status = add_file(solver, solver->command[i], false, &text);
  for (unsigned i = 0; !status && i < file->files_count; ++i)
    status = add_file(solver, file->files[i], true, &text);
  if (!status && text.failed)
    status = PO_NO_MEMORY;
  po_digest_bytes(po_text_string(&text), text.length, solver->digest);
  po_text_clear(&text);
  return status;
}

/* Finds the absolute path of the folder of a file. */
static po_status find_folder(const char *path, po_file_path *folder) {
  if (!realpath(path, folder->text))
    return po_fail(PO_CANNOT_READ, "the folder of %s cannot be found", path);
  char *slash = strrchr(folder->text, '/');
  slash[slash == folder->text] = '\0';
  return PO_OK;
}

po_status po_solver_read(const char *path, const char *knob, po_solver **result) {
  char *bytes = NULL;
  size_t size = 0;
  po_yaml *yaml = NULL;
  *result = NULL;
  po_solver *solver = po_allocate(1, sizeof *solver);
  if (!solver)
    return PO_NO_MEMORY;
  solver->file = po_allocate(1, sizeof *solver->file);
  solver->path = po_path_join("", path);
  po_status status = solver->file ? po_file_read(path, &bytes, &size) : PO_NO_MEMORY;
  if (!status)
    status = find_folder(path, &solver->here);
  if (!status)
    status = po_fields_read(path, bytes, size, MANIFEST, solver->file, &yaml);
  if (!status)
    status = parse_manifest(yaml, knob, solver);
  if (!status)
    status = make_command(yaml, solver);
  if (!status)
    status = make_digest(bytes, size, solver);
  po_yaml_destroy(yaml);
  free(bytes);
  if (status)
    po_solver_destroy(solver);
  else
    *result = solver;
  return status;
}

void po_solver_destroy(po_solver *solver) {
  if (!solver)
    return;
  for (unsigned i = 0; solver->command && i < solver->file->command_count; ++i)
    free(solver->command[i]);
  free(solver->command);
  if (solver->file)
    po_fields_clear(MANIFEST, solver->file);
  free(solver->file);
  free(solver->name);
  free(solver);
}

po_file_path po_solver_folder(const po_solver *solver, const char *output) {
  return po_path_join(po_path_join(output, PO_CASE_FOLDER_OF_SOLVERS).text, solver->name);
}

const po_solver_key *po_solver_find_key(const po_solver *solver, po_key key) {
  const po_solver_can *can = &solver->file->can;
  for (unsigned i = 0; i < can->scene_count; ++i)
    if (strcmp(can->scene[i].axis.key, PO_KEYS[key].name) == 0)
      return &can->scene[i];
  return NULL;
}

static bool accepts_value(const po_solver_key *item, const po_request *request, po_key key) {
  for (unsigned v = 0; v < item->axis.values_count; ++v)
    if (po_key_matches(request, key, item->axis.values[v]))
      return true;
  if (item->axis.values)
    return false;
  const double value = po_key_is_number(key) ? po_key_number(request, key) : 0;
  return !po_key_is_number(key) || (value >= item->from && value <= item->to);
}

bool po_solver_accepts(const po_solver *solver, const po_request *request,
                       char why[PO_SOLVER_WHY]) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!po_key_is_of_scene(key) || po_key_is_idle(request, key))
      continue;
    char value[PO_KEY_TEXT_LENGTH];
    const po_solver_key *item = po_solver_find_key(solver, key);
    if (item && accepts_value(item, request, key))
      continue;
    po_key_print(request, key, value);
    snprintf(why, PO_SOLVER_WHY, "%s is %.60s: %s", PO_KEYS[key].name, value,
             item ? "outside the values that the manifest declares"
                  : "the manifest does not declare this key");
    return false;
  }
  return true;
}
