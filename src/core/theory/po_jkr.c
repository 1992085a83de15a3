#include "po_jkr.h"

#include <math.h>

#include "po_elementary.h"

po_contact po_jkr_at(const po_scene *scene, double contact_radius) {
  if (!(scene->tabor > 0.0 && scene->radius > 0.0 && contact_radius >= 0.0))
    return (po_contact){NAN, NAN, NAN};
  /* Eq 7 and Eq 8 with a/Gamma = (2 pi beta)^(1/3) a/lambda */
  const double a = contact_radius / po_scene_gamma(scene), cube = a * a * a;
  return (po_contact){.load = 4.0 / (3.0 * M_PI) * cube - sqrt(8.0 / M_PI * cube),
                      .approach = scene->tabor * (a * a - sqrt(2.0 * M_PI * a)),
                      .contact_radius = contact_radius};
}

po_contact po_dmt_at(const po_scene *scene, double contact_radius) {
  if (!(scene->tabor > 0.0 && scene->radius > 0.0 && contact_radius >= 0.0))
    return (po_contact){NAN, NAN, NAN};
  const double a = contact_radius / po_scene_gamma(scene);
  return (po_contact){.load = 4.0 / (3.0 * M_PI) * (a * a * a) - 2.0,
                      .approach = scene->tabor * (a * a),
                      .contact_radius = contact_radius};
}

double po_dmt_radius(const po_scene *scene, po_fixed fixed, double value) {
  return po_scene_gamma(scene) * (fixed == PO_FIXED_LOAD ? po_cbrt(0.75 * M_PI * (value + 2.0))
                                                         : sqrt(value / scene->tabor));
}

/* dW/da = 0 at (a/Gamma)^3 = 9 pi/8; dDelta/da = 0 at (a/Gamma)^3 = pi/8. */
po_contact po_jkr_pull_off(const po_scene *scene) {
  return po_jkr_at(scene, po_cbrt(9.0 * M_PI / 8.0) * po_scene_gamma(scene));
}

po_contact po_jkr_last(const po_scene *scene) {
  return po_jkr_at(scene, po_cbrt(M_PI / 8.0) * po_scene_gamma(scene));
}

double po_maugis_parameter(double tabor, double tension) {
  return tension * po_cbrt(4.5 / M_PI) * tabor;
}

double po_transition_alpha(double lambda) {
  return -po_expm1(-lambda / 0.924) / 1.02;
}

double po_carpick_force(double lambda) {
  return 2.0 - 0.5 / (1.0 + 1.0 / (4.04 * po_pow(lambda, 1.4))); /* the same, also at infinity */
}

double po_pietrement_force(double lambda) {
  const double alpha = po_transition_alpha(lambda);
  return (0.267 * alpha - 0.767) * alpha + 2.0;
}

double po_schwarz_force(double lambda) {
  const double alpha = po_transition_alpha(lambda);
  return 6.0 / (3.0 + alpha * alpha);
}
