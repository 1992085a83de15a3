#include "po_schema.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cyaml/cyaml.h>

#include "po_memory.h"
#include "po_text.h"

/* Every scalar is taken as text: libcyaml 1.3 would read the count 3.5 as 3 and accept nan and
 * hexadecimal; po_number is strict and the message can quote what is written. */
#define TEXT(key, structure, member)                                                               \
  CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER, structure, member, 1, CYAML_UNLIMITED)
#define OPTIONAL_TEXT(key, structure, member)                                                      \
  CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, structure, member, 1,      \
                         CYAML_UNLIMITED)
#define LIST(key, flags, structure, member, entry)                                                 \
  CYAML_FIELD_SEQUENCE(key, CYAML_FLAG_POINTER | (flags), structure, member, entry, 1,             \
                       CYAML_UNLIMITED)

static const cyaml_schema_value_t WORD = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char, 1, CYAML_UNLIMITED)};

static const cyaml_schema_field_t AXIS_FIELDS[] = {
    TEXT("key", po_axis, key),
    LIST("values", 0, po_axis, values, &WORD),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t AXIS = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_axis, AXIS_FIELDS)};

static const cyaml_schema_field_t RANGE_FIELDS[] = {
    TEXT("key", po_axis, key),
    LIST("values", CYAML_FLAG_OPTIONAL, po_axis, values, &WORD),
    OPTIONAL_TEXT("from", po_axis, from_text),
    OPTIONAL_TEXT("to", po_axis, to_text),
    OPTIONAL_TEXT("count", po_axis, count_text),
    OPTIONAL_TEXT("scale", po_axis, scale),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t RANGE = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_axis, RANGE_FIELDS)};

static const cyaml_schema_field_t LINE_FIELDS[] = {
    TEXT("name", po_case_line, name),
    TEXT("theory", po_case_line, theory),
    LIST("sweep", 0, po_case_line, sweep, &RANGE),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t LINE = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_case_line, LINE_FIELDS)};

static const cyaml_schema_field_t DRAW_FIELDS[] = {
    TEXT("key", po_draw, key),
    TEXT("from", po_draw, from_text),
    TEXT("to", po_draw, to_text),
    OPTIONAL_TEXT("scale", po_draw, scale),
    OPTIONAL_TEXT("times", po_draw, times),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t DRAW = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_draw, DRAW_FIELDS)};

static const cyaml_schema_field_t SAMPLE_FIELDS[] = {
    TEXT("seed", po_sample_words, seed_text),
    TEXT("count", po_sample_words, count_text),
    LIST("keys", 0, po_sample_words, keys, &DRAW),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t TRACED_FIELDS[] = {
    TEXT("seed", po_traced_words, seed_text),
    TEXT("count", po_traced_words, count_text),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t CHECK_FIELDS[] = {
    TEXT("quantity", po_check, quantity_text),
    TEXT("reference", po_check, reference),
    TEXT("tolerance", po_check, tolerance_text),
    TEXT("kind", po_check, kind_text),
    TEXT("because", po_check, because),
    OPTIONAL_TEXT("stand_in", po_check, stand_in),
    LIST("as_if", CYAML_FLAG_OPTIONAL, po_check, as_if, &AXIS),
    LIST("when", CYAML_FLAG_OPTIONAL, po_check, when, &AXIS),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t CHECK = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_check, CHECK_FIELDS)};

static const cyaml_schema_field_t PHYSICAL_FIELDS[] = {
    TEXT("modulus_pa", po_physical_words, modulus),
    TEXT("work_j_per_m2", po_physical_words, work),
    TEXT("distance_m", po_physical_words, distance),
    TEXT("radius_m", po_physical_words, radius),
    OPTIONAL_TEXT("amplitude_m", po_physical_words, amplitude),
    OPTIONAL_TEXT("wavelength_m", po_physical_words, wavelength),
    OPTIONAL_TEXT("outer_radius_m", po_physical_words, outer_radius),
    CYAML_FIELD_END,
};

#define SCENE_KEY(name, key) OPTIONAL_TEXT(name, po_scene_words, values[key])
#define SCENE_KEYS                                                                                 \
  SCENE_KEY("tabor", PO_KEY_TABOR), SCENE_KEY("amplitude", PO_KEY_AMPLITUDE),                      \
      SCENE_KEY("wavelength", PO_KEY_WAVELENGTH), SCENE_KEY("radius", PO_KEY_RADIUS),              \
      SCENE_KEY("outer_radius", PO_KEY_OUTER_RADIUS), SCENE_KEY("scheme", PO_KEY_SCHEME),          \
      SCENE_KEY("grading", PO_KEY_GRADING), SCENE_KEY("nodes", PO_KEY_NODES),                      \
      SCENE_KEY("tolerance", PO_KEY_TOLERANCE),                                                    \
      SCENE_KEY("approach_start", PO_KEY_APPROACH_START),                                          \
      SCENE_KEY("approach_end", PO_KEY_APPROACH_END), SCENE_KEY("preload", PO_KEY_PRELOAD),        \
      SCENE_KEY("preload_load", PO_KEY_PRELOAD_LOAD), SCENE_KEY("time_limit", PO_KEY_TIME_LIMIT)
static const cyaml_schema_field_t SCENE_FIELDS[] = {
    SCENE_KEYS,
    CYAML_FIELD_MAPPING_PTR("physical", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, po_scene_words,
                            physical, PHYSICAL_FIELDS),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t SETTING_FIELDS[] = {
    SCENE_KEYS,
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t SETTINGS = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_scene_words, SETTING_FIELDS)};

static const cyaml_schema_field_t SWEEP_FIELDS[] = {
    OPTIONAL_TEXT("key", po_sweep, axis.key),
    LIST("values", CYAML_FLAG_OPTIONAL, po_sweep, axis.values, &WORD),
    OPTIONAL_TEXT("from", po_sweep, axis.from_text),
    OPTIONAL_TEXT("to", po_sweep, axis.to_text),
    OPTIONAL_TEXT("count", po_sweep, axis.count_text),
    OPTIONAL_TEXT("scale", po_sweep, axis.scale),
    LIST("together", CYAML_FLAG_OPTIONAL, po_sweep, together, &SETTINGS),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t SWEEP = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_sweep, SWEEP_FIELDS)};

static const cyaml_schema_field_t LEAVE_OUT_FIELDS[] = {
    LIST("when", 0, po_leave_out, when, &AXIS),
    TEXT("because", po_leave_out, because),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t LEAVE_OUT = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_leave_out, LEAVE_OUT_FIELDS)};

static const cyaml_schema_field_t MEASURE_FIELDS[] = {
    TEXT("quantity", po_check, quantity_text),
    TEXT("reference", po_check, reference),
    LIST("when", CYAML_FLAG_OPTIONAL, po_check, when, &AXIS),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t MEASURE = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, po_check, MEASURE_FIELDS)};

static const cyaml_schema_field_t CASE_FIELDS[] = {
    TEXT("name", po_case_file, name),
    TEXT("title", po_case_file, title),
    OPTIONAL_TEXT("figure", po_case_file, figure),
    OPTIONAL_TEXT("equations", po_case_file, equations),
    OPTIONAL_TEXT("figure_script", po_case_file, figure_script),
    LIST("suites", 0, po_case_file, suite_names, &WORD),
    CYAML_FIELD_MAPPING("scene", CYAML_FLAG_DEFAULT, po_case_file, scene, SCENE_FIELDS),
    LIST("sweep", CYAML_FLAG_OPTIONAL, po_case_file, sweep, &SWEEP),
    LIST("leave_out", CYAML_FLAG_OPTIONAL, po_case_file, leave_out, &LEAVE_OUT),
    CYAML_FIELD_MAPPING_PTR("sample", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, po_case_file,
                            sample, SAMPLE_FIELDS),
    OPTIONAL_TEXT("follow", po_case_file, follow),
    OPTIONAL_TEXT("checkpoint_every", po_case_file, checkpoints_text),
    CYAML_FIELD_MAPPING_PTR("traced", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, po_case_file,
                            traced, TRACED_FIELDS),
    OPTIONAL_TEXT("repeats", po_case_file, repeats_text),
    LIST("want", 0, po_case_file, want_names, &WORD),
    LIST("checks", CYAML_FLAG_OPTIONAL, po_case_file, checks, &CHECK),
    LIST("lines", CYAML_FLAG_OPTIONAL, po_case_file, lines, &LINE),
    LIST("measure", CYAML_FLAG_OPTIONAL, po_case_file, measure, &MEASURE),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t CASE = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, po_case_file, CASE_FIELDS)};

/* Paths without their item numbers, and what is expected there. */
static const struct {
  const char *path;
  const char *expected;
} EXPECTED[] = {
    {"name", "letters, digits, _ and -"},
    {"title", "a line of text"},
    {"figure", "the number of a figure"},
    {"equations", "the numbers of equations"},
    {"figure_script", "the name of a script"},
    {"suites", "a list of names of suites"},
    {"scene", "a mapping of scene keys"},
    {"scene.physical", "a mapping of modulus_pa, work_j_per_m2, distance_m, radius_m and more"},
    {"scene.physical.modulus_pa", "a number > 0 in Pa, or inf"},
    {"scene.physical.work_j_per_m2", "a finite number > 0 in J/m^2"},
    {"scene.physical.distance_m", "a finite number > 0 in m"},
    {"scene.physical.radius_m", "a finite number > 0 in m"},
    {"sweep", "a list of {key, values} or {together}"},
    {"sweep.from", "a finite number"},
    {"sweep.to", "a finite number > from"},
    {"sweep.count", "a whole number from 2 to 10000"},
    {"sweep.scale", "linear or log"},
    {"sweep.together", "a list of mappings of scene keys"},
    {"leave_out", "a list of {when, because}"},
    {"leave_out.because", "the reason why these are not solved"},
    {"lines", "a list of {name, theory, sweep}"},
    {"lines.sweep", "a list of {key, values}"},
    {"lines.sweep.from", "a finite number"},
    {"lines.sweep.to", "a finite number > from"},
    {"lines.sweep.count", "a whole number from 2 to 10000"},
    {"lines.sweep.scale", "linear or log"},
    {"sample", "a mapping of seed, count, keys"},
    {"sample.seed", "a whole number of at most 15 digits"},
    {"sample.count", "a whole number from 1 to 100000"},
    {"sample.keys", "a list of {key, from, to}"},
    {"sample.keys.key", "a key of the scene whose value is a number, and not a count"},
    {"sample.keys.from", "a finite number"},
    {"sample.keys.to", "a finite number > from"},
    {"sample.keys.scale", "linear or log"},
    {"sample.keys.times", "root_radius or a key given before: by scene, sweep or an earlier item"},
    {"follow", "the last key of the sweep, with a number for a value"},
    {"checkpoint_every", "a whole number from 1 to 1000, beside follow"},
    {"traced", "a mapping of seed and count, beside follow"},
    {"traced.seed", "a whole number of at most 15 digits"},
    {"traced.count", "a whole number from 1 up to all scenes between two checkpoints"},
    {"repeats", "a whole number from 1 to 1000"},
    {"want",
     "a list of pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, preload"},
    {"checks", "a list of checks"},
    {"checks.quantity",
     "pull_off_force, pull_off_approach, contact_radius, residual, moved_force, energy_defect, "
     "reverse_trace, hysteresis_force, hysteresis_approach, hysteresis_loss, jumps, pull_off_any, "
     "steps, "
     "load_steps, fold_count, folds, extrema, curve, work or solved_share"},
    {"checks.reference", "bradley, pin, every_scene, zero, traced or the path of a CSV file"},
    {"checks.tolerance", "a finite number > 0"},
    {"checks.kind", "abs, rel or ulp"},
    {"checks.because", "the reason for the tolerance"},
    {"checks.stand_in",
     "the reference of another check, which stands in while this one's is absent"},
    {"measure", "a list of {quantity, reference}"},
    {"measure.quantity",
     "pull_off_force, pull_off_approach, contact_radius, fold_count, folds, extrema or curve"},
    {"measure.reference", "bradley or the path of a CSV file"},
    {"key", "a key of the scene"},
    {"values", "a list of values"},
    {"when", "a list of {key, values}"},
    {"as_if", "a list of {key, values}, each of one value"},
};

static const char *schema_expected(const char *path) {
  char plain[128];
  size_t n = 0;
  for (const char *c = path; *c && n + 1 < sizeof plain; ++c) {
    if (*c == '[')
      c += strcspn(c, "]");
    else
      plain[n++] = *c;
  }
  plain[n] = '\0';
  const char *last = strrchr(plain, '.');
  last = last ? last + 1 : plain;
  for (size_t i = 0; i < sizeof EXPECTED / sizeof *EXPECTED; ++i)
    if (strcmp(EXPECTED[i].path, plain) == 0 || strcmp(EXPECTED[i].path, last) == 0)
      return EXPECTED[i].expected;
  const int key = po_key_of_name(last);
  return key >= 0 ? po_key_expected((po_key)key) : "a case as cases/README.md describes";
}

po_status po_schema_refuse(const po_yaml *yaml, const char *expected, const char *format, ...) {
  char path[200];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(path, sizeof path, format, arguments);
  va_end(arguments);
  return po_yaml_refuse(yaml, path, expected ? expected : schema_expected(path));
}

/* What libcyaml logs of one failure: a sentence, then a backtrace from the inside out. */
typedef struct {
  char sentence[256];
  char path[256]; /* as far as the backtrace tells */
} failure;

static void prepend(failure *heard, const char *part) {
  char whole[sizeof heard->path];
  const char *rest = heard->path;
  const int length =
      snprintf(whole, sizeof whole, "%s%s%s", part, *rest && *rest != '[' ? "." : "", rest);
  if (length > 0 && (size_t)length < sizeof whole)
    memcpy(heard->path, whole, (size_t)length + 1);
}

static void hear(cyaml_log_t level, void *context, const char *format, va_list arguments) {
  failure *heard = context;
  char line[256], part[128], name[100];
  vsnprintf(line, sizeof line, format, arguments);
  line[strcspn(line, "\n")] = '\0';
  (void)level;
  if (sscanf(line, " in mapping field '%99[^']'", name) == 1)
    prepend(heard, name);
  else if (sscanf(line, " in sequence entry '%99[^']'", name) == 1) {
    snprintf(part, sizeof part, "[%s]", name);
    prepend(heard, part);
  } else if (!heard->sentence[0])
    snprintf(heard->sentence, sizeof heard->sentence, "%s",
             strncmp(line, "Load: ", 6) == 0 ? line + 6 : line);
}

/* The fields of the mapping at a path, by descending the schema; NULL when it is no mapping. */
static const cyaml_schema_field_t *fields_at(const char *path) {
  const cyaml_schema_field_t *fields = CASE_FIELDS;
  while (*path && fields) {
    path += *path == '.';
    const size_t length = strcspn(path, ".[");
    const cyaml_schema_field_t *field = fields;
    while (field->key && (strncmp(field->key, path, length) != 0 || field->key[length]))
      ++field;
    path += length;
    if (*path == '[')
      path += strcspn(path, "]") + 1;
    if (!field->key)
      return NULL;
    const cyaml_schema_value_t *value = &field->value;
    if (value->type == CYAML_SEQUENCE)
      value = value->sequence.entry;
    fields = value->type == CYAML_MAPPING ? value->mapping.fields : NULL;
  }
  return fields;
}

static po_status refuse_key(const po_yaml *yaml, const char *mapping, const char *key) {
  char path[400];
  snprintf(path, sizeof path, "%s%s%s", mapping, *mapping ? "." : "", key);
  po_text known = {0};
  for (const cyaml_schema_field_t *field = fields_at(mapping); field && field->key; ++field)
    po_text_add(&known, "%s%s", known.length ? ", " : "", field->key);
  const po_status status =
      po_fail(PO_BAD_INPUT, "%s:%zu: %s is unknown: expected one of %s", po_yaml_name(yaml),
              po_yaml_line(yaml, path), path, po_text_string(&known));
  po_text_clear(&known);
  return status;
}

/* The path of the mapping a sentence is about: libcyaml names the field it read last in it, too. */
static void to_mapping(const po_yaml *yaml, char *path) {
  const char *value = po_yaml_value(yaml, path);
  if (*path && (!value || strcmp(value, "a mapping") != 0)) {
    char *dot = strrchr(path, '.');
    *(dot ? dot : path) = '\0';
  }
}

static po_status refuse(const po_yaml *yaml, failure *heard) {
  char key[100], path[400];
  if (sscanf(heard->sentence, "Unexpected key: %99s", key) == 1) {
    to_mapping(yaml, heard->path);
    return refuse_key(yaml, heard->path, key);
  }
  if (sscanf(heard->sentence, "Missing required mapping field: %99s", key) == 1) {
    /* The last field read may itself be a mapping: go up until the key belongs. */
    for (;;) {
      const cyaml_schema_field_t *field = fields_at(heard->path);
      while (field && field->key && strcmp(field->key, key) != 0)
        ++field;
      if ((field && field->key) || !*heard->path)
        break;
      char *dot = strrchr(heard->path, '.');
      *(dot ? dot : heard->path) = '\0';
    }
    snprintf(path, sizeof path, "%s%s%s", heard->path, *heard->path ? "." : "", key);
    return po_yaml_refuse(yaml, path, schema_expected(path));
  }
  /* An empty list is reported at its entry 0; entries count from 1. */
  char *entry = strrchr(heard->path, '[');
  if (entry && strcmp(entry, "[0]") == 0)
    *entry = '\0';
  return po_yaml_refuse(yaml, heard->path, schema_expected(heard->path));
}

static const cyaml_config_t *config(failure *heard, cyaml_config_t *space) {
  *space = (cyaml_config_t){
      .log_fn = hear, .log_ctx = heard, .mem_fn = cyaml_mem, .log_level = CYAML_LOG_ERROR};
  return space;
}

po_status po_schema_load(const po_yaml *yaml, const char *bytes, size_t size, po_case_file **file) {
  failure heard = {{0}, {0}};
  cyaml_config_t space;
  *file = NULL;
  po_memory_watch();
  const cyaml_err_t error = cyaml_load_data((const uint8_t *)bytes, size, config(&heard, &space),
                                            &CASE, (cyaml_data_t **)file, NULL);
  if (!error && *file)
    return PO_OK;
  *file = NULL;
  if (error == CYAML_ERR_OOM || po_memory_ran_out()) /* libyaml's is any other error to libcyaml */
    return po_fail(PO_NO_MEMORY, "%s: no memory for the case", po_yaml_name(yaml));
  return refuse(yaml, &heard);
}

void po_schema_free(po_case_file *file) {
  failure heard = {{0}, {0}};
  cyaml_config_t space;
  if (file)
    cyaml_free(config(&heard, &space), &CASE, file, 0);
}
