/* The block `physical` of a case: a scene given in SI units. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parse.h"
#include "po_memory.h"
#include "po_schema.h"

/* The keys that follow from the block, and therefore may not be given beside it. */
static const po_key DERIVED[] = {PO_KEY_TABOR, PO_KEY_AMPLITUDE, PO_KEY_WAVELENGTH, PO_KEY_RADIUS,
                                 PO_KEY_OUTER_RADIUS};
enum { DERIVED_COUNT = sizeof DERIVED / sizeof *DERIVED };

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
  static const char NOT_BOTH[] = "none of tabor, amplitude, wavelength, radius, outer_radius, or a "
                                 "group of them, beside scene.physical";
  for (int i = 0; i < DERIVED_COUNT; ++i)
    if (file->scene.values[DERIVED[i]])
      return po_schema_refuse(yaml, NOT_BOTH, "scene.%s", po_key_name(DERIVED[i]));
  for (unsigned k = 0; k < file->sweep_count; ++k) {
    const char *what = file->sweep[k].together ? "together" : "key";
    for (int i = 0; i < DERIVED_COUNT; ++i)
      if (po_sweep_varies(&file->sweep[k], DERIVED[i]))
        return po_schema_refuse(yaml, NOT_BOTH, "sweep[%u].%s", k + 1, what);
  }
  for (int i = 0; i < DERIVED_COUNT; ++i)
    if (po_case_draws(file, DERIVED[i]))
      return po_schema_refuse(yaml, NOT_BOTH, "scene.physical");
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
  if (status)
    return status;
  status = po_physical_scene(&physical, &request.scene);
  if (status) {
    char *why = po_copy_text(po_message());
    status = po_fail(PO_BAD_INPUT, "%s:%zu: scene.physical: %s", po_yaml_name(yaml),
                     po_yaml_line(yaml, "scene.physical"), why ? why : "refused");
    free(why);
    return status;
  }
  kase->is_physical = true;
  kase->units = po_physical_units(&physical, &request.scene);
  for (int i = 0; i < DERIVED_COUNT; ++i) {
    char text[PO_KEY_TEXT_LENGTH];
    if (DERIVED[i] == PO_KEY_WAVELENGTH && !(physical.amplitude > 0.0))
      continue;
    po_key_print(&request, DERIVED[i], text);
    words->values[DERIVED[i]] = po_copy_text(text);
    if (!words->values[DERIVED[i]])
      return PO_NO_MEMORY;
  }
  return PO_OK;
}
