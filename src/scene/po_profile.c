#include "po_profile.h"

#include <float.h>
#include <math.h>

/* The allowed error of the load, in pi w R, where the waviness is replaced by its mean: a
 * thousandth of the default tolerance. */
static const double AVERAGING_LOSS = 1e-9;

double po_profile(const po_scene *scene, double r) {
  double gap = 0.5 * r * r / scene->radius;
  if (po_scene_is_wavy(scene)) {
    const double half =
        sin(M_PI * r / scene->wavelength); /* 1 - cos(2x) = 2 sin^2 x does not cancel */
    gap += 2.0 * scene->amplitude * half * half;
  }
  return gap;
}

double po_profile_slope(const po_scene *scene, double r) {
  double slope = r / scene->radius;
  if (po_scene_is_wavy(scene))
    slope +=
        2.0 * M_PI * scene->amplitude / scene->wavelength * sin(2.0 * M_PI * r / scene->wavelength);
  return slope;
}

double po_profile_mean(const po_scene *scene, double r) {
  return 0.5 * r * r / scene->radius + scene->amplitude;
}

double po_averaging_phase(const po_scene *scene, double r) {
  if (!po_scene_is_wavy(scene))
    return r;
  const double half = 0.5 * scene->wavelength;
  /* beyond half / DBL_EPSILON, the rounding of r exceeds half the wavelength */
  return r < half / DBL_EPSILON ? half * ceil(r / half) : r;
}

/* The undeformed gap g = r^2/(2R) from which on the waves may be averaged. */
static double averaging_gap(const po_scene *scene) {
  const po_law_far far = po_law_far_field(&scene->law);
  if (isinf(far.exponent))
    return po_law_reach(&scene->law);
  /* The integrand of Eq 17 is (2k/R) g^-m r, k g^-m the far field: its slope is at most
   * (2k/R)(2m + 1) g^-m, of which a part of m A/g oscillates when A is small against g. */
  const double per_2pi = scene->wavelength / (2.0 * M_PI), m = far.exponent;
  const double scale = (2.0 * m + 1.0) * 2.0 * far.factor / scene->radius * per_2pi * per_2pi;
  /* From where on scale min(1, m A/g) < loss g^m. */
  const double power = scale / AVERAGING_LOSS;
  return fmin(pow(power, 1.0 / m), pow(m * scene->amplitude * power, 1.0 / (m + 1.0)));
}

double po_averaging_radius(const po_scene *scene, double from) {
  if (!po_scene_is_wavy(scene))
    return from;
  const double gap = averaging_gap(scene);
  const double waves = ceil((sqrt(2.0 * scene->radius * gap) - from) / scene->wavelength);
  return waves > 0.0 ? from + waves * scene->wavelength : from;
}
