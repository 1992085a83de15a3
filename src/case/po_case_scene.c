/* The section `scene` of a case, and the keys that scene, sweep and sample must give together. */
#include <stdio.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_schema.h"

bool po_case_varies(const po_case_file *file, po_key key) {
  for (unsigned i = 0; i < file->sweep_count; ++i)
    if (po_sweep_varies(&file->sweep[i], key))
      return true;
  return po_case_draws(file, key);
}

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
      if (given[key] || !po_sweep_varies(sweep, key) || (key == PO_KEY_NODES && panels) ||
          (key == PO_KEY_TABOR && given[PO_KEY_COUPLING]) ||
          (key == PO_KEY_RADIUS && (given[PO_KEY_PROFILE] || given[PO_KEY_PROFILE_FILE])) ||
          (key == PO_KEY_WAVELENGTH && !given[PO_KEY_AMPLITUDE]))
        continue;
      return po_schema_refuse(yaml, po_key_expected(key), "sweep[%u].together[%u].%s", number,
                              i + 1, po_key_name(key));
    }
  }
  return PO_OK;
}

po_status po_case_scene_check(const po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  po_request request = po_request_default();
  for (int key = 0; key < PO_KEY_END; ++key)
    if (file->scene.values[key] && !po_key_set(&request, (po_key)key, file->scene.values[key]))
      return po_schema_refuse(yaml, NULL, "scene.%s", po_key_name((po_key)key));
  const bool panels = request.mesh.scheme == PO_PANEL && !po_case_varies(file, PO_KEY_SCHEME);
  const bool wavy = request.scene.amplitude > 0 || po_case_varies(file, PO_KEY_AMPLITUDE);
  const bool waves = file->scene.values[PO_KEY_WAVES] || po_case_varies(file, PO_KEY_WAVES);
  const bool sphere =
      po_profile_is_sphere(&request.scene.profile) && !po_case_varies(file, PO_KEY_PROFILE);
  for (size_t i = 0; i < NEEDED_COUNT; ++i) {
    const po_key key = NEEDED[i];
    if (file->scene.values[key] || po_case_varies(file, key) ||
        (key == PO_KEY_WAVELENGTH && (waves || !wavy)) || (key == PO_KEY_NODES && panels) ||
        (key == PO_KEY_TABOR && file->scene.values[PO_KEY_COUPLING]) ||
        (key == PO_KEY_RADIUS && !sphere))
      continue;
    char expected[128];
    snprintf(expected, sizeof expected, "%s, here, in the sweep or in the sample",
             po_key_expected(key));
    return po_schema_refuse(yaml, expected, "scene.%s", po_key_name(key));
  }
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->sweep_count; ++i)
    status = check_settings(&file->sweep[i], i + 1, yaml);
  return status;
}
