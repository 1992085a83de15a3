/* The scene of a case file: the block `physical` in SI units, the profile, and keys that do not go
 * together. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_memory.h"
#include "po_texts.h"

/* Whether a key follows from the block, and therefore may not be given beside it. */
static bool is_derived(int key) {
  const po_key_owner owner = PO_KEYS[key].owner;
  return (owner == PO_OWNER_SCENE || owner == PO_OWNER_PROFILE) &&
         (!po_key_is_group(key) || key == PO_KEY_COUPLING);
}

static po_status refuse_both(const po_case_file *file, const po_yaml *yaml) {
  static const char NOT_BOTH[] = "none of tabor, amplitude, wavelength, radius, outer_radius, the "
                                 "profile and waves, or a group of them, beside scene.physical";
  for (int key = 0; key < PO_KEY_END; ++key) {
    if (!is_derived(key))
      continue;
    if (file->scene.values[key])
      return po_fields_refuse(yaml, NOT_BOTH, "scene.%s", PO_KEYS[key].name);
    for (unsigned k = 0; k < file->sweep_count; ++k)
      if (file->sweep[k].varied.has[key])
        return po_fields_refuse(yaml, NOT_BOTH, "sweep[%u].%s", k + 1,
                                po_case_sweep_word(&file->sweep[k]));
    if (file->drawn.has[key])
      return po_fields_refuse(yaml, NOT_BOTH, "scene.physical");
  }
  return PO_OK;
}

/* Whether a key has no value in a scene that was given in SI units: a group, a parameter of another
 * profile, waves that the scene does not have. */
static bool is_absent(const po_request *request, po_key key) {
  return po_key_is_idle(request, key) &&
         (key != PO_KEY_AMPLITUDE || po_scene_waves(&request->scene) > 1);
}

/* Keys of the scene that name the same thing in two ways, and the files of profiles. */

/* The length of the folder of the case file in its path, with the slash. */
static size_t folder_length(const po_case *kase) {
  const char *slash = strrchr(kase->path, '/');
  return slash ? (size_t)(slash - kase->path) + 1 : 0;
}

const char *po_case_profile_shown(const po_case *kase, const char *path) {
  const size_t length = folder_length(kase);
  return strncmp(path, kase->path, length) == 0 ? path + length : path;
}

po_status po_case_path(const po_case *kase, char **word) {
  po_text path = {0};
  if ((*word)[0] == '/')
    return PO_OK;
  po_text_add(&path, "%.*s%s", (int)folder_length(kase), kase->path, *word);
  if (path.failed)
    return PO_NO_MEMORY;
  free(*word);
  *word = path.data;
  return PO_OK;
}

po_status po_case_material_path(const po_case *kase, char **word) {
  if (!po_creep_file_of(*word))
    return PO_OK;
  char *file = po_copy_text(po_creep_file_of(*word));
  po_status status = file ? po_case_path(kase, &file) : PO_NO_MEMORY;
  po_text named = {0};
  if (!status)
    po_text_add(&named, "prony:%s", file);
  free(file);
  if (status || named.failed)
    return PO_NO_MEMORY;
  free(*word);
  *word = named.data;
  return PO_OK;
}

po_status po_case_refuse_for(const po_yaml *yaml, const char *where, po_status status) {
  if (status == PO_NO_MEMORY)
    return status;
  const bool named = strncmp(po_message(), where, strlen(where)) == 0;
  return po_fail(status, "%s:%zu: %s%s%s", yaml->name, po_yaml_line(yaml, where),
                 named ? "" : where, named ? "" : ": ", po_message());
}

/* The keys whose values name tables. */
static const po_key OF_FILES[] = {PO_KEY_PROFILE_FILE, PO_KEY_VISCOELASTIC};
enum { OF_FILES_COUNT = sizeof OF_FILES / sizeof *OF_FILES };

static po_status read_file(const po_case *kase, po_key key, char **word) {
  if (key == PO_KEY_VISCOELASTIC) {
    po_creep scratch = {0};
    const po_status status = po_case_material_path(kase, word);
    return status || !po_creep_file_of(*word) ? status : po_creep_read(*word, &scratch);
  }
  po_profile scratch = po_profile_sphere();
  const po_status status = po_case_path(kase, word);
  return status ? status : po_profile_set_file(&scratch, *word);
}

/* Replaces the name of a table, relative to the case file, by its path, and reads it. Given: the
 * value of a key that may name one; NULL: it has none. */
static po_status __attribute__((format(printf, 5, 6)))
resolve(const po_case *kase, const po_yaml *yaml, po_key key, char **word, const char *format,
        ...) {
  if (!*word)
    return PO_OK;
  char where[2 * PO_CASE_WHERE_LENGTH];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(where, sizeof where, format, arguments);
  va_end(arguments);
  const po_status status = read_file(kase, key, word);
  return status ? po_case_refuse_for(yaml, where, status) : PO_OK;
}

static po_status resolve_axis(const po_case *kase, po_axis *axis, const char *where,
                              const po_yaml *yaml) {
  po_status status = PO_OK;
  const int key = axis->key ? po_key_of_name(axis->key) : -1;
  if (key == PO_KEY_PROFILE_FILE || key == PO_KEY_VISCOELASTIC)
    for (unsigned k = 0; k < axis->values_count && !status; ++k)
      status = resolve(kase, yaml, key, &axis->values[k], "%s.values[%u]", where, k + 1);
  return status;
}

static po_status resolve_key(const po_case *kase, const po_yaml *yaml, po_key key) {
  po_case_file *file = kase->file;
  const char *name = PO_KEYS[key].name;
  po_status status = resolve(kase, yaml, key, &file->scene.values[key], "scene.%s", name);
  for (unsigned i = 0; i < file->sweep_count; ++i)
    for (unsigned k = 0; k < file->sweep[i].together_count && !status; ++k)
      status = resolve(kase, yaml, key, &file->sweep[i].together[k].values[key],
                       "sweep[%u].together[%u].%s", i + 1, k + 1, name);
  return status;
}

po_status po_case_files_resolve(po_case *kase, const po_yaml *yaml) {
  po_status status = PO_OK;
  for (int k = 0; k < OF_FILES_COUNT && !status; ++k)
    status = resolve_key(kase, yaml, OF_FILES[k]);
  return status ? status : po_case_each_axis(kase, yaml, resolve_axis);
}

/* Keys that set the same. */
static const struct {
  po_key key, other;
  const char *expected;
} PAIRS[] = {
    {PO_KEY_PROFILE, PO_KEY_PROFILE_FILE, "only one of profile and profile_file"},
    {PO_KEY_AMPLITUDE, PO_KEY_WAVES, "only waves, or amplitude and wavelength"},
    {PO_KEY_WAVELENGTH, PO_KEY_WAVES, "only waves, or amplitude and wavelength"},
    {PO_KEY_TABOR, PO_KEY_COUPLING, "only one of tabor and coupling"},
};

static po_status check_pairs(const po_case_file *file, const po_yaml *yaml) {
  const char *const *scene = (const char *const *)file->scene.values;
  for (size_t i = 0; i < sizeof PAIRS / sizeof *PAIRS; ++i) {
    const po_key key = PAIRS[i].key, other = PAIRS[i].other;
    if (scene[other] && (scene[key] || file->varied.has[key]))
      return po_fields_refuse(yaml, PAIRS[i].expected, "scene.%s", PO_KEYS[other].name);
    if (scene[key] && file->varied.has[other])
      return po_fields_refuse(yaml, PAIRS[i].expected, "scene.%s", PO_KEYS[key].name);
    for (unsigned k = 0; k < file->sweep_count; ++k)
      for (unsigned n = 0; n < file->sweep[k].together_count; ++n)
        if (file->sweep[k].together[n].values[key] && file->sweep[k].together[n].values[other])
          return po_fields_refuse(yaml, PAIRS[i].expected, "sweep[%u].together[%u].%s", k + 1,
                                  n + 1, PO_KEYS[other].name);
  }
  return PO_OK;
}

bool po_case_is_in_si(po_key key) {
  return key >= PO_KEY_END && key < PO_KEY_PROFILE_APPROACH;
}

/* The texts of the block at a point, with what the sweep gives in its place; and the material,
 * whose table may have times in s. */
static po_texts texts_at(const po_case *kase, const po_point *point) {
  po_texts given = {.prefix = "scene.physical.", .si = true, .mixed = true};
  memcpy(given.text, kase->file->scene.physical->values, sizeof given.text);
  given.text[PO_KEY_VISCOELASTIC] = kase->file->scene.values[PO_KEY_VISCOELASTIC];
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    for (int key = PO_KEY_END; key < PO_KEY_PROFILE_APPROACH; ++key) {
      const char *value = po_case_swept_text(kase, point, i, key);
      if (value)
        given.text[key] = value;
    }
  for (unsigned i = 0; i < kase->file->sweep_count; ++i) {
    const char *material = po_case_swept_text(kase, point, i, PO_KEY_VISCOELASTIC);
    if (material)
      given.text[PO_KEY_VISCOELASTIC] = material;
  }
  return given;
}

/* Reads the block, of the texts at a point. */
static po_status read_physical(po_texts *texts, const po_yaml *yaml, po_request *request) {
  const po_status status = po_texts_read(texts, request);
  if (!status)
    return PO_OK;
  const po_texts given = *texts;
  char where[PO_CASE_WHERE_LENGTH];
  snprintf(where, sizeof where, "%s%s", given.prefix, PO_KEYS[given.wrong].name);
  return po_case_refuse_for(yaml, given.text[given.wrong] ? where : "scene.physical", status);
}

/* Whether the texts of the block give a key. */
static bool is_given_by(const po_texts *given, int key) {
  const int si = po_key_in_si(key);
  return PO_KEYS[key].owner == PO_OWNER_TRACE ? si >= 0 && given->text[si] : is_derived(key);
}

po_status po_case_scene_set_physical(const po_case *kase, const po_yaml *yaml, po_point *point) {
  po_texts given = texts_at(kase, point);
  po_request request = po_request_default();
  const po_status status = read_physical(&given, yaml, &request);
  for (int key = 0; key < PO_KEY_COUNT && !status; ++key) {
    char text[PO_KEY_TEXT_LENGTH];
    if (!is_given_by(&given, key) || is_absent(&request, key))
      continue;
    po_key_print(&request, key, text);
    po_key_set(&point->request, key, text);
  }
  point->request.units = request.units;
  return status;
}

static po_status parse_physical(po_case *kase, const po_yaml *yaml) {
  po_scene_words *words = &kase->file->scene;
  if (!words->physical)
    return PO_OK;
  po_request request = po_request_default();
  po_status status = refuse_both(kase->file, yaml);
  if (!status && words->physical->values[PO_KEY_PROFILE_FILE])
    status = po_case_path(kase, &words->physical->values[PO_KEY_PROFILE_FILE]);
  const po_point first = {.setting = 0};
  po_texts given = {.text = {NULL}};
  if (!status) {
    given = texts_at(kase, &first);
    status = read_physical(&given, yaml, &request);
  }
  if (status)
    return status;
  kase->is_physical = true;
  for (int key = PO_KEY_END; key < PO_KEY_PROFILE_APPROACH; ++key)
    kase->varies_units = kase->varies_units || kase->file->swept.has[key];
  kase->units = request.units;
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char text[PO_KEY_TEXT_LENGTH];
    if (!is_given_by(&given, key) || is_absent(&request, key))
      continue;
    if (words->values[key])
      return po_fields_refuse(yaml, "only this key, or that of scene.physical", "scene.%s",
                              PO_KEYS[key].name);
    po_key_print(&request, key, text);
    words->values[key] = po_copy_text(text);
    if (!words->values[key])
      return PO_NO_MEMORY;
  }
  return PO_OK;
}

/* The section `scene` of a case, and the keys that scene, sweep and sample must give together. */

static const po_key NEEDED[] = {PO_KEY_TABOR,  PO_KEY_RADIUS, PO_KEY_OUTER_RADIUS,
                                PO_KEY_SCHEME, PO_KEY_NODES,  PO_KEY_WAVELENGTH};

enum { NEEDED_COUNT = sizeof NEEDED / sizeof *NEEDED };

/* A key that one setting gives must be in all settings. Exceptions are keys that follow from the
 * others: nodes of panels, the wavelength of a smooth sphere, tabor of a coupling, the radius of a
 * profile. */
static po_status check_settings(const po_sweep *sweep, unsigned number, const po_yaml *yaml) {
  for (unsigned i = 0; i < sweep->together_count; ++i) {
    const char *const *given = (const char *const *)sweep->together[i].values;
    const bool panels = given[PO_KEY_SCHEME] && strcmp(given[PO_KEY_SCHEME], "panel") == 0;
    for (size_t k = 0; k < NEEDED_COUNT; ++k) {
      const po_key key = NEEDED[k];
      if (given[key] || !sweep->varied.has[key] || (key == PO_KEY_NODES && panels) ||
          (key == PO_KEY_TABOR && given[PO_KEY_COUPLING]) ||
          (key == PO_KEY_RADIUS && (given[PO_KEY_PROFILE] || given[PO_KEY_PROFILE_FILE])) ||
          (key == PO_KEY_WAVELENGTH && !given[PO_KEY_AMPLITUDE]))
        continue;
      return po_fields_refuse(yaml, PO_KEYS[key].expected, "sweep[%u].together[%u].%s", number,
                              i + 1, PO_KEYS[key].name);
    }
  }
  return PO_OK;
}

static po_status check_keys(const po_case_file *file, const po_yaml *yaml) {
  po_request request = po_request_default();
  for (int key = 0; key < PO_KEY_END; ++key)
    if (file->scene.values[key] && !po_key_set(&request, key, file->scene.values[key]))
      return po_fields_refuse(yaml, NULL, "scene.%s", PO_KEYS[key].name);
  const bool panels = request.mesh.scheme == PO_PANEL && !file->varied.has[PO_KEY_SCHEME];
  const bool wavy = request.scene.amplitude > 0 || file->varied.has[PO_KEY_AMPLITUDE];
  const bool waves = file->scene.values[PO_KEY_WAVES] || file->varied.has[PO_KEY_WAVES];
  const bool sphere =
      po_profile_is_sphere(&request.scene.profile) && !file->varied.has[PO_KEY_PROFILE];
  for (size_t i = 0; i < NEEDED_COUNT; ++i) {
    const po_key key = NEEDED[i];
    if (file->scene.values[key] || file->varied.has[key] ||
        (key == PO_KEY_WAVELENGTH && (waves || !wavy)) || (key == PO_KEY_NODES && panels) ||
        (key == PO_KEY_TABOR && file->scene.values[PO_KEY_COUPLING]) ||
        (key == PO_KEY_RADIUS && !sphere))
      continue;
    char expected[128];
    snprintf(expected, sizeof expected, "%s, here, in the sweep or in the sample",
             PO_KEYS[key].expected);
    return po_fields_refuse(yaml, expected, "scene.%s", PO_KEYS[key].name);
  }
  if (file->varied.has[PO_KEY_ALPHA] && !wavy)
    return po_fields_refuse(yaml,
                            "a number > 0, here, in the sweep or in the sample, as alpha varies",
                            "scene.amplitude");
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->sweep_count; ++i)
    status = check_settings(&file->sweep[i], i + 1, yaml);
  return status;
}

po_status po_case_scene_parse(po_case *kase, const po_yaml *yaml) {
  po_status status = parse_physical(kase, yaml);
  if (!status)
    status = check_pairs(kase->file, yaml);
  return status ? status : check_keys(kase->file, yaml);
}

/* Whether a value of an axis is a law or a profile that has a parameter. */
static bool axis_has_parameter(const po_axis *axis, po_key key) {
  const int named = po_key_of_name(axis->key);
  if (named != PO_KEY_LAW && named != PO_KEY_PROFILE)
    return false;
  for (unsigned i = 0; i < axis->values_count; ++i) {
    po_request request = po_request_default();
    po_key_set(&request, named, axis->values[i]);
    po_key_set(&request, key, "1");
    if (!isnan(po_key_number(&request, key))) /* one that the law or the profile lacks is NAN */
      return true;
  }
  return false;
}

static bool is_parameter_of_none(const po_case *kase, int key) {
  if (!po_key_is_parameter(key, PO_OWNER_LAW) && !po_key_is_parameter(key, PO_OWNER_PROFILE))
    return false;
  for (size_t k = 0; k < kase->point_count; ++k)
    if (!isnan(po_key_number(&kase->points[k].request, key)))
      return false;
  for (unsigned i = 0; i < kase->file->lines_count; ++i)
    for (unsigned k = 0; k < kase->file->lines[i].sweep_count; ++k)
      if (axis_has_parameter(&kase->file->lines[i].sweep[k], key))
        return false;
  return true;
}

po_status po_case_scene_check(po_case *kase, const po_yaml *yaml) {
  static const char EXPECTED[] = "a parameter of the law or the profile of a point or a line";
  const po_case_file *file = kase->file;
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!is_parameter_of_none(kase, key))
      continue;
    if (file->scene.values[key])
      return po_fields_refuse(yaml, EXPECTED, "scene.%s", PO_KEYS[key].name);
    for (unsigned i = 0; i < file->sweep_count; ++i)
      if (file->sweep[i].varied.has[key])
        return po_fields_refuse(yaml, EXPECTED, "sweep[%u]", i + 1);
    if (file->drawn.has[key])
      return po_fields_refuse(yaml, EXPECTED, "sample");
  }
  return PO_OK;
}
