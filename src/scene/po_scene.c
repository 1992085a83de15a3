#include "po_scene.h"

#include <math.h>

po_scene po_scene_default(void) {
  return (po_scene){
      .tabor = 1.0, .radius = 100.0, .outer_radius = INFINITY, .law = po_law_lennard_jones()};
}

static po_status require(bool holds, const char *key, double value, const char *expected) {
  return holds ? PO_OK : po_fail(PO_BAD_INPUT, "%s is %g: expected %s", key, value, expected);
}

/* On an unbounded surface the interaction energy, of which (1 + H)^(1 - m) r dr is the far part,
 * must be finite. */
static const double LEAST_EXPONENT = 2.0;

static po_status check_far_field(const po_scene *scene) {
  const po_law_far far = po_law_far_field(&scene->law);
  return far.exponent > LEAST_EXPONENT || isfinite(scene->outer_radius)
             ? PO_OK
             : po_fail(
                   PO_BAD_INPUT,
                   "mie_m is %g: on an unbounded surface the energy of the far field is infinite; "
                   "expected more than %g, or an outer radius",
                   far.exponent, LEAST_EXPONENT);
}

po_status po_scene_check(const po_scene *scene) {
  po_status status = require(isfinite(scene->tabor) && scene->tabor >= 0.0, "tabor", scene->tabor,
                             "a finite number >= 0");
  if (!status)
    status = require(isfinite(scene->amplitude) && scene->amplitude >= 0.0, "amplitude",
                     scene->amplitude, "a finite number >= 0");
  if (!status)
    status = require(isfinite(scene->wavelength) && scene->wavelength >= 0.0, "wavelength",
                     scene->wavelength, "a finite number >= 0");
  if (!status)
    status = require(scene->amplitude == 0.0 || scene->wavelength > 0.0, "wavelength",
                     scene->wavelength, "a finite number > 0 when amplitude is not 0");
  if (!status)
    status = require(isfinite(scene->radius) && scene->radius > 0.0, "radius", scene->radius,
                     "a finite number > 0");
  if (!status)
    status = require(scene->outer_radius > 0.0, "outer_radius", scene->outer_radius,
                     "a number > 0, or inf");
  if (!status)
    status = po_law_check(&scene->law);
  if (!status)
    status = check_far_field(scene);
  return status;
}

bool po_scene_is_wavy(const po_scene *scene) {
  return scene->amplitude > 0.0;
}

double po_scene_gamma(const po_scene *scene) {
  const double product = scene->radius * scene->tabor;
  return isnormal(product) ? sqrt(product) : sqrt(scene->radius) * sqrt(scene->tabor);
}

double po_scene_stiffness(const po_scene *scene) {
  const double mu = scene->tabor, ratio = scene->radius / (mu * mu * mu);
  return isnormal(mu * mu * mu) && isnormal(ratio) ? sqrt(ratio) : sqrt(scene->radius / mu) / mu;
}

double po_scene_alpha(const po_scene *scene) {
  if (!po_scene_is_wavy(scene))
    return 0.0;
  return scene->amplitude * scene->radius / (scene->wavelength * scene->wavelength);
}
