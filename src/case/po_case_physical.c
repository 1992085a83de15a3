/* The block `physical` of a case: a scene given in SI units. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_memory.h"
#include "po_schema.h"

/* Whether a key follows from the block, and therefore may not be given beside it. */
static bool is_derived(int key) {
  const po_key_owner owner = po_key_row_of(key)->owner;
  return (owner == PO_OWNER_SCENE || owner == PO_OWNER_PROFILE) &&
         (!po_key_is_group(key) || key == PO_KEY_COUPLING);
}

/* Parses a number of the block. */
static po_status parse(const char *text, bool may_be_inf, const char *name, double *value,
                       const po_yaml *yaml) {
  if (may_be_inf && strcmp(text, "inf") == 0) {
    *value = (double)INFINITY;
    return PO_OK;
  }
  if (po_number_parse(text, value))
    return PO_OK;
  return po_schema_refuse(yaml, may_be_inf ? "a finite number, or inf" : "a finite number",
                          "scene.physical.%s", name);
}

static po_status read_words(const po_physical_words *words, po_physical *p, const po_yaml *yaml) {
  *p = (po_physical){.outer_radius = (double)INFINITY};
  const struct {
    const char *name, *text;
    bool may_be_inf;
    double *value;
  } items[] = {{"modulus_pa", words->modulus, true, &p->modulus},
               {"work_j_per_m2", words->work, false, &p->work},
               {"distance_m", words->distance, false, &p->distance},
               {"radius_m", words->radius, false, &p->radius},
               {"amplitude_m", words->amplitude, false, &p->amplitude},
               {"wavelength_m", words->wavelength, false, &p->wavelength},
               {"outer_radius_m", words->outer_radius, true, &p->outer_radius}};
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < sizeof items / sizeof *items; ++i)
    if (items[i].text)
      status = parse(items[i].text, items[i].may_be_inf, items[i].name, items[i].value, yaml);
  return status;
}

static po_status refuse_both(const po_case_file *file, const po_yaml *yaml) {
  static const char NOT_BOTH[] = "none of tabor, amplitude, wavelength, radius, outer_radius, the "
                                 "profile and waves, or a group of them, beside scene.physical";
  for (int key = 0; key < PO_KEY_END; ++key)
    if (is_derived(key) && file->scene.values[key])
      return po_schema_refuse(yaml, NOT_BOTH, "scene.%s", po_key_name((po_key)key));
  for (unsigned k = 0; k < file->sweep_count; ++k) {
    const char *what = file->sweep[k].together ? "together" : "key";
    for (int key = 0; key < PO_KEY_END; ++key)
      if (is_derived(key) && po_sweep_varies(&file->sweep[k], (po_key)key))
        return po_schema_refuse(yaml, NOT_BOTH, "sweep[%u].%s", k + 1, what);
  }
  for (int key = 0; key < PO_KEY_END; ++key)
    if (is_derived(key) && po_case_draws(file, (po_key)key))
      return po_schema_refuse(yaml, NOT_BOTH, "scene.physical");
  return PO_OK;
}

/* Whether a key has no value in a scene that was given in SI units: a group, a parameter of another
 * profile, waves that the scene does not have. */
static bool is_absent(const po_request *request, po_key key) {
  return po_key_is_idle(request, key) &&
         (key != PO_KEY_AMPLITUDE || po_scene_waves(&request->scene) > 1);
}

/* Sets the profile of the block. */
static po_status set_profile(const po_case *kase, po_physical_words *words, double distance,
                             po_request *request, const po_yaml *yaml) {
  po_profile *profile = &request->scene.profile;
  po_status status = PO_OK;
  if (words->profile && words->profile_file)
    return po_schema_refuse(yaml, "only one of profile and profile_file",
                            "scene.physical.profile_file");
  if (words->waves && words->amplitude)
    return po_schema_refuse(yaml, "only waves, or amplitude_m and wavelength_m",
                            "scene.physical.waves");
  if (words->profile && !po_profile_set(profile, words->profile))
    return po_schema_refuse(yaml, NULL, "scene.physical.profile");
  if (words->profile && (status = po_profile_check(profile)))
    return po_case_refuse_for(yaml, "scene.physical.profile", status);
  po_profile_rescale(profile, distance);
  if (words->profile_file) {
    status = po_case_profile_path(kase, &words->profile_file);
    if (!status)
      status = po_profile_set_file(profile, words->profile_file);
    if (status)
      return po_case_refuse_for(yaml, "scene.physical.profile_file", status);
  }
  if (!words->radius && po_profile_is_sphere(profile))
    return po_schema_refuse(yaml, NULL, "scene.physical.radius_m");
  return PO_OK;
}

/* Sets the waves of the block, in metres. */
static po_status set_waves(const char *text, double distance, po_scene *scene,
                           const po_yaml *yaml) {
  po_scene metres = po_scene_default();
  if (!po_scene_set_waves(&metres, text))
    return po_schema_refuse(yaml, NULL, "scene.physical.waves");
  for (size_t k = 0; k < po_scene_waves(&metres); ++k) {
    const po_wave wave = po_scene_wave(&metres, k);
    po_scene_add_wave(scene, (po_wave){wave.amplitude / distance, wave.length / distance});
  }
  return PO_OK;
}

po_status po_case_physical_parse(po_case *kase, const po_yaml *yaml) {
  po_scene_words *words = &kase->file->scene;
  if (!words->physical)
    return PO_OK;
  po_physical physical;
  po_request request = po_request_default();
  po_status status = refuse_both(kase->file, yaml);
  if (!status)
    status = read_words(words->physical, &physical, yaml);
  if (!status && physical.distance > 0.0)
    status = set_profile(kase, words->physical, physical.distance, &request, yaml);
  if (status)
    return status;
  if (!words->physical->radius)
    physical.radius = physical.distance;
  status = po_physical_scene(&physical, &request.scene);
  if (status) {
    return po_case_refuse_for(yaml, "scene.physical", status);
  }
  if (words->physical->waves)
    status = set_waves(words->physical->waves, physical.distance, &request.scene, yaml);
  if (status)
    return status;
  kase->is_physical = true;
  kase->units = po_physical_units(&physical, &request.scene);
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char text[PO_KEY_TEXT_LENGTH];
    if (!is_derived(key) || is_absent(&request, (po_key)key))
      continue;
    po_key_print(&request, (po_key)key, text);
    words->values[key] = po_copy_text(text);
    if (!words->values[key])
      return PO_NO_MEMORY;
  }
  return PO_OK;
}
