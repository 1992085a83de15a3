#include "po_profile.h"

#include <float.h>
#include <math.h>

/* What the load may lose where single waves are replaced by their mean. */
static const double AVERAGING_LOSS = 1e-9;

double po_profile(const po_scene *scene, double r) {
  double gap = 0.5 * r * r / scene->radius;
  if (po_scene_is_wavy(scene)) {
    const double half =
        sin(M_PI * r / scene->wavelength); /* 1 - cos(2x) = 2 sin^2 x: no cancelling */
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
  return r < half / DBL_EPSILON ? half * ceil(r / half) : r; /* shorter waves than r can tell */
}

double po_averaging_radius(const po_scene *scene, double from) {
  if (!po_scene_is_wavy(scene))
    return from;
  /* The integrand is (16/(3R)) g^-3 r with g = r^2/(2R): its slope is at most 7 g^-3, of which a
   * part of 3 A/g oscillates when A is small against g. */
  const double per_2pi = scene->wavelength / (2.0 * M_PI);
  const double scale = 7.0 * 16.0 / (3.0 * scene->radius) * per_2pi * per_2pi;
  /* The gap from where on scale min(1, 3A/gap) < loss gap^3; then the next whole wave. */
  const double cubed = scale / AVERAGING_LOSS;
  const double gap = fmin(cbrt(cubed), sqrt(sqrt(3.0 * scene->amplitude * cubed)));
  const double waves = ceil((sqrt(2.0 * scene->radius * gap) - from) / scene->wavelength);
  return waves > 0.0 ? from + waves * scene->wavelength : from;
}
