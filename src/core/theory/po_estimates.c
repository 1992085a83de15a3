#include "po_estimates.h"

#include <math.h>
#include <stddef.h>

#include "po_elementary.h"
#include "po_root.h"

/* Returned: whether radius, amplitude and wavelength are valid; a smooth sphere needs no
 * wavelength. */
static bool is_inside(const po_scene *scene) {
  return scene->radius > 0.0 &&
         (scene->amplitude == 0.0 || (scene->amplitude > 0.0 && scene->wavelength > 0.0));
}

/* Returned: A/lambda; 0 for a smooth sphere; NaN outside the domain. */
static double steepness(const po_scene *scene) {
  if (!is_inside(scene))
    return NAN;
  return po_scene_is_wavy(scene) ? scene->amplitude / scene->wavelength : 0.0;
}

double po_johnson_parameter(const po_scene *scene) {
  if (!(is_inside(scene) && scene->tabor > 0.0))
    return NAN;
  if (!po_scene_is_wavy(scene))
    return INFINITY;
  const double e = po_scene_stiffness(scene);
  return sqrt(2.0 * scene->wavelength / e) / (M_PI * scene->amplitude);
}

double po_kesari_lew_work(const po_scene *scene) {
  const double root = 1.0 + 1.0 / (sqrt(M_PI) * po_johnson_parameter(scene));
  return root * root;
}

po_contact po_kesari_lew_edge(const po_scene *scene, double contact_radius, int side) {
  const double relative_change = 1.0 / (sqrt(M_PI) * po_johnson_parameter(scene));
  if (!(contact_radius >= 0.0) || isnan(relative_change))
    return (po_contact){NAN, NAN, NAN};
  const double factor = side < 0 ? 1.0 + relative_change : 1.0 - relative_change;
  const double a = contact_radius / po_scene_gamma(scene), cube = a * a * a;
  return (po_contact){.load = 4.0 / (3.0 * M_PI) * cube - factor * sqrt(8.0 / M_PI * cube),
                      .approach =
                          scene->tabor * (a * a - factor * sqrt(2.0 * M_PI * a)) + scene->amplitude,
                      .contact_radius = contact_radius};
}

po_persson_tosatti po_persson_tosatti_of(const po_scene *scene) {
  const double ratio = steepness(scene), slope = M_PI * ratio;
  const double johnson = po_johnson_parameter(scene);
  const double area = 1.0 + slope * slope, work = 1.0 - 1.0 / (2.0 * M_PI * johnson * johnson);
  return (po_persson_tosatti){.area = area,
                              .area_printed = 1.0 + M_PI * ratio * ratio,
                              .work = work,
                              .work_with_area = work + (area - 1.0)};
}

double po_rumpf_rabinowicz_ratio(double alpha, double radius) {
  if (!(alpha >= 0.0 && radius > 0.0))
    return NAN;
  const double curvature = 4.0 * M_PI * M_PI * alpha, second = 1.0 / (1.0 + radius / curvature);
  return 1.0 / (1.0 + curvature) + second * second;
}

/* The zeros of this function are the extrema of sin(x)/x: x^2 times its derivative, negated. */
static double sinc_slope(double x, const void *unused) {
  (void)unused;
  return po_sin(x) - x * po_cos(x);
}

po_compactness po_compactness_of(const po_scene *scene) {
  /* the first minimum of sin(x)/x, where tan x = x */
  const double x = po_root(sinc_slope, NULL, M_PI, 2.0 * M_PI);
  return (po_compactness){-4.0 * M_PI * M_PI * po_sin(x) / x,
                          2.0 * M_PI * steepness(scene) * scene->radius};
}

po_crest po_crest_of(const po_scene *scene) {
  const double wave = scene->wavelength / (2.0 * M_PI), alpha = po_scene_alpha(scene);
  const double radius = !is_inside(scene)         ? (double)NAN
                        : po_scene_is_wavy(scene) ? wave * wave / scene->amplitude
                                                  : INFINITY;
  return (po_crest){radius, 1.0 / (1.0 / scene->radius + 1.0 / radius),
                    alpha >= 0.0 ? 2.0 / (1.0 + 4.0 * M_PI * M_PI * alpha) : (double)NAN};
}

double po_lennard_jones_traction(double gap) {
  if (!(gap > -1.0))
    return NAN;
  const double x = 1.0 / (1.0 + gap);
  return 8.0 / 3.0 * x * x * x *
         po_expm1(-6.0 * po_log1p(gap)); /* x^9 - x^3 without cancellation */
}

po_lennard_jones_peak po_lennard_jones_greatest(void) {
  return (po_lennard_jones_peak){16.0 / (9.0 * sqrt(3.0)), sqrt(po_cbrt(3.0))};
}
