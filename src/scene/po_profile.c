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

double po_averaging_radius(const po_scene *scene, double from) {
  if (!po_scene_is_wavy(scene))
    return from;
  /* The integrand of Eq 17 is (16/(3R)) g^-3 r with g = r^2/(2R), and its slope is at most 7
   * (16/(3R)) g^-3. For amplitudes that are small against g, a fraction 3 A/g of it oscillates. */
  const double per_2pi = scene->wavelength / (2.0 * M_PI);
  const double scale = 7.0 * 16.0 / (3.0 * scene->radius) * per_2pi * per_2pi;
  /* The gap from which on scale * min(1, 3 A/gap) < AVERAGING_LOSS * gap^3; then the next whole
   * wavelength. */
  const double cubed = scale / AVERAGING_LOSS;
  const double gap = fmin(cbrt(cubed), sqrt(sqrt(3.0 * scene->amplitude * cubed)));
  const double waves = ceil((sqrt(2.0 * scene->radius * gap) - from) / scene->wavelength);
  return waves > 0.0 ? from + waves * scene->wavelength : from;
}
