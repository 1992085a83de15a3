/* The line above a picture: the command of a scene, or its input in SI units. */
#include <math.h>
#include <string.h>

#include "po_input.h"
#include "po_plot.h"

/* Appends a quantity with the prefix that fits it. */
static void add(po_text *text, const char *symbol, double value, const char *unit) {
  static const char *const PREFIX[] = {"a", "f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};
  enum { NONE = 6, LAST = sizeof PREFIX / sizeof *PREFIX - 1 };
  int k = NONE;
  /* 0.3 nm and 0.2 N/m, but 80 mJ/m² */
  const double least = strcmp(unit, "m") == 0     ? 0.099999
                       : strcmp(unit, "N/m") == 0 ? 0.0099999
                                                  : 0.99999;
  for (; k > 0 && fabs(value) < least; --k)
    value *= 1e3;
  for (; k < LAST && fabs(value) >= 999.99; ++k)
    value /= 1e3;
  if (isfinite(value) && value != 0.0)
    po_text_add(text, "%s%s = %.5g %s%s", text->length ? ", " : "", symbol, value, PREFIX[k], unit);
}

char *po_plot_caption(const po_request *request) {
  const po_scene *scene = &request->scene;
  po_text text = {0};
  const po_units *units = &request->units;
  if (!request->in_si)
    return po_input_command(request);
  if (po_profile_is_sphere(&scene->profile)) {
    add(&text, "R", scene->radius * units->length, "m");
  } else {
    char profile[PO_KEY_TEXT_LENGTH];
    po_key_print(request, PO_KEY_PROFILE, profile);
    po_text_add(&text, "profile %s (ε)", profile);
  }
  add(&text, "w", units->work, "J/m²");
  add(&text, "E*", po_scene_stiffness(scene) * units->tension, "Pa");
  add(&text, "ε", units->length, "m");
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    add(&text, "A", po_scene_wave(scene, k).amplitude * units->length, "m");
    add(&text, "λ", po_scene_wave(scene, k).length * units->length, "m");
  }
  add(&text, "preload", request->preload.load * units->force, "N");
  add(&text, "preload", request->preload.approach * units->length, "m");
  add(&text, "spring", request->stiffness * (units->force / units->length), "N/m");
  return text.failed ? NULL : text.data;
}
