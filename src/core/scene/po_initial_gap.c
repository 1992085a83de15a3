#include "po_initial_gap.h"

#include <math.h>

#include "po_dd.h"
#include "po_elementary.h"

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

po_dd po_initial_gap_exact(const po_scene *scene, double r) {
  po_dd gap = po_profile_gap_exact(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const po_dd half = po_dd_sinpi(po_dd_divide(po_dd_of(r), po_dd_of(wave.length)));
    gap = po_dd_add(gap, po_dd_times(po_dd_multiply(half, half), 2.0 * wave.amplitude));
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
  double length = po_profile_shape(&scene->profile).detail;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    length = fmin(length, po_scene_wave(scene, k).length);
  return length;
}
