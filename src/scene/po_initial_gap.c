#include "po_initial_gap.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_scales.h"
#include "po_two_functions.h"

/* The allowed error of the load, in pi w R, where the waves are replaced by their mean: a
 * thousandth of the default tolerance. */
static const double AVERAGING_LOSS = 1e-9;

static double wave_gap(po_wave wave, double r) {
  const double half = po_sinpi(r / wave.length); /* 1 - cos(2x) = 2 sin^2 x does not cancel */
  return 2.0 * wave.amplitude * half * half;
}

static double wave_slope(po_wave wave, double r) {
  return 2.0 * M_PI * wave.amplitude / wave.length * po_sinpi(2.0 * (r / wave.length));
}

double po_initial_gap(const po_scene *scene, double r) {
  double gap = po_profile_gap(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    gap += wave_gap(po_scene_wave(scene, k), r);
  return gap;
}

double po_initial_gap_slope(const po_scene *scene, double r) {
  double slope = po_profile_slope(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    slope += wave_slope(po_scene_wave(scene, k), r);
  return slope;
}

void po_initial_gap_and_slope(const po_scene *scene, double r, double *gap, double *slope) {
  *gap = po_profile_gap(&scene->profile, scene->radius, r);
  *slope = po_profile_slope(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double x = r / wave.length, s = po_sinpi(x), c = po_cospi(x); /* sin 2x = 2 s c */
    *gap += 2.0 * wave.amplitude * s * s;
    *slope += 4.0 * M_PI * wave.amplitude / wave.length * s * c;
  }
}

po_two po_initial_gap_exact(const po_scene *scene, double r) {
  po_two gap = po_profile_gap_exact(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const po_two half = po_two_sinpi(po_two_divide(po_two_of(r), po_two_of(wave.length)));
    gap = po_two_add(gap, po_two_times(po_two_multiply(half, half), 2.0 * wave.amplitude));
  }
  return gap;
}

double po_initial_gap_mean(const po_scene *scene, double r) {
  double gap = po_profile_gap(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    gap += po_scene_wave(scene, k).amplitude;
  return gap;
}

double po_initial_gap_amplitude(const po_scene *scene) {
  if (po_scene_waves(scene) < 2)
    return scene->amplitude;
  double sum = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    sum += po_scene_wave(scene, k).amplitude * po_scene_wave(scene, k).amplitude;
  return sqrt(sum);
}

double po_initial_gap_beyond(const po_scene *scene, double r) {
  return po_profile_gap_beyond(&scene->profile, scene->radius, r);
}

double po_initial_gap_radius(const po_scene *scene, double gap) {
  return gap > 0.0 ? po_profile_radius_of_gap(&scene->profile, scene->radius, gap) : 0.0;
}

double po_initial_gap_detail(const po_scene *scene) {
  double length = po_profile_detail(&scene->profile);
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    length = fmin(length, po_scene_wave(scene, k).length);
  return length;
}

/* The wave whose phase decides where averaging begins. */
static po_wave main_wave(const po_scene *scene) {
  po_wave main = po_scene_wave(scene, 0);
  for (size_t k = 1; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    if (wave.amplitude * wave.length > main.amplitude * main.length)
      main = wave;
  }
  return main;
}

double po_averaging_phase(const po_scene *scene, double r) {
  if (!po_scene_is_wavy(scene))
    return r;
  const double half = 0.5 * main_wave(scene).length;
  /* beyond half / DBL_EPSILON, the rounding of r exceeds half the wavelength */
  return r < half / DBL_EPSILON ? half * ceil(r / half) : r;
}

/* The undeformed gap g = r^2/(2R) from which on one wave on a sphere may be averaged. */
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
  return fmin(po_pow(power, 1.0 / m), po_pow(m * scene->amplitude * power, 1.0 / (m + 1.0)));
}

/* Bound of the error of the load if all waves are averaged beyond r. */
static double averaging_error(const po_scene *scene, double r) {
  const po_law_far far = po_law_far_field(&scene->law);
  const double gap = po_initial_gap_beyond(scene, r), m = far.exponent;
  const double integrand = 2.0 / scene->radius * far.factor * po_pow(gap, -m) * r;
  const double slope = integrand * (m * po_profile_growth(&scene->profile) + 1.0) / r;
  const po_wave main = main_wave(scene);
  double error = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double per_2pi = wave.length / (2.0 * M_PI), part = fmin(1.0, m * wave.amplitude / gap);
    const bool is_main = wave.length == main.length;
    error += part * per_2pi * (is_main ? per_2pi * slope : integrand);
  }
  return error;
}

/* Factor between the radii that are tried. */
static const double LARGER = 1.05;

static double end_of_waves(const po_scene *scene, double from) {
  if (po_profile_is_sphere(&scene->profile) && po_scene_waves(scene) == 1)
    return sqrt(2.0 * scene->radius * averaging_gap(scene));
  if (isinf(po_law_far_field(&scene->law).exponent))
    return po_initial_gap_radius(scene, po_law_reach(&scene->law));
  const double allowed = AVERAGING_LOSS * po_scene_scales(scene).load;
  double r = from;
  while (averaging_error(scene, r) > allowed)
    r *= LARGER;
  return r;
}

double po_averaging_radius(const po_scene *scene, double from) {
  if (!po_scene_is_wavy(scene))
    return from;
  const double length = main_wave(scene).length;
  const double waves = ceil((end_of_waves(scene, from) - from) / length);
  return waves > 0.0 ? from + waves * length : from;
}
