#include "po_scales.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_margins.h"

/* W = 0 in Eq 7 at a contact radius of 2.42 Gamma. */
static const double CONTACT_OF_SPHERE = 2.42;

/* Points of the rules, of which some percent are asked. */
enum { ABEL_POINTS = 48, LOAD_POINTS = 200, APPROACHES = 24 };

/* g(a) = a times the integral of f'(a sin t) over t from 0 to pi/2: the Abel transform of the
 * profile without waves, to some percent. */
static double scales_abel(const po_scene *scene, double a) {
  double sum = 0.0;
  for (int k = 0; k < ABEL_POINTS; ++k) {
    const double t = (k + 0.5) / ABEL_POINTS * M_PI_2;
    sum += po_profile_slope(&scene->profile, scene->radius, a * po_sin(t));
  }
  return a * M_PI_2 / ABEL_POINTS * sum;
}

/* The load of rigid bodies, pi w R, by the midpoint rule in the square root of the radius. */
static double rigid_load(const po_scene *scene, double approach, double end) {
  double sum = 0.0;
  for (int k = 0; k < LOAD_POINTS; ++k) {
    const double x = (k + 0.5) / LOAD_POINTS, r = end * x * x;
    const double gap = po_profile_gap(&scene->profile, scene->radius, r) - approach;
    sum += po_law_at(&scene->law, gap).traction * r * 2.0 * x * end / LOAD_POINTS;
  }
  return 2.0 / scene->radius * sum;
}

static double rigid_pull_off(const po_scene *scene) {
  const double end = fmin(scene->outer_radius,
                          po_initial_gap_radius(scene, po_law_numbers_of(&scene->law)->reach));
  const double near = -po_law_numbers_of(&scene->law)->peak_gap,
               far = -0.5 * po_law_numbers_of(&scene->law)->closest;
  double least = 0.0;
  for (int k = 0; k < APPROACHES; ++k)
    least = fmin(least, rigid_load(scene, near + (far - near) * k / (APPROACHES - 1), end));
  return -least;
}

/* JKR theory of the profile, over contact radii from a small to a large one. */
typedef struct {
  double pull_off, contact; /* pi w R, eps; contact: at zero load */
} jkr;

/* Contact radii of the search, relative to the radius at which the initial gap is the smallest and
 * the largest. */
static const double SMALLEST_GAP = 1e-6, LARGEST_GAP = 1e9;

/* Given: the factor of the work of adhesion in the adhesive term. */
static jkr jkr_of(const po_scene *scene, double adhesion) {
  const double coupling = po_scene_coupling(scene);
  const double end = fmin(scene->outer_radius, po_initial_gap_radius(scene, LARGEST_GAP));
  double a = fmin(end, po_initial_gap_radius(scene, SMALLEST_GAP)), area = 0.0, before = 0.0;
  double g = scales_abel(scene, a);
  jkr j = {0.0, a};
  area = 0.5 * a * g;
  for (; a <= end; a *= PO_NEXT_RADIUS) {
    before = g;
    g = scales_abel(scene, a);
    area += 0.5 * (g + before) * a * (1.0 - 1.0 / PO_NEXT_RADIUS);
    const double load = 2.0 / (M_PI * scene->radius * coupling) *
                        (a * g - area - sqrt(2.0 * M_PI * coupling * adhesion * a * a * a));
    if (load < 0.0)
      j.contact = a;
    if (load < -j.pull_off)
      j.pull_off = -load;
    else if (load > j.pull_off)
      break;
  }
  return j;
}

/* The greatest factor of the work of adhesion by waves. Internal cracks limit it: in Figure 11 of
 * the paper it is about 8, at A/lambda ~ 0.1. */
static const double MOST_ADHESION = 8.0;

/* The factor by which waves may increase the work of adhesion: Eq 24, (1 + 1/(sqrt(pi)
 * alpha_KLJ))^2 with alpha_KLJ^2 = 2 coupling lambda/(pi A)^2. The oscillations that waves add to
 * the approach of JKR theory go as sqrt(a), as does the adhesive term; those of several waves add.
 */
static double adhesion_of_waves(const po_scene *scene) {
  double root = 1.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    root += wave.amplitude * sqrt(M_PI / (2.0 * po_scene_coupling(scene) * wave.length));
  }
  return fmin(MOST_ADHESION, root * root);
}

po_scales po_scene_scales(const po_scene *scene) {
  const double mu = scene->tabor, per_stretch = 0.5 * CONTACT_OF_SPHERE * CONTACT_OF_SPHERE;
  const bool sphere = po_profile_is_sphere(&scene->profile);
  const double rigid = sphere ? 1.0 : 0.5 * rigid_pull_off(scene);
  if (!(mu > 0.0))
    return (po_scales){.load = rigid, .load_factor = 1.0};
  const double adhesion = adhesion_of_waves(scene), root = po_cbrt(adhesion);
  if (sphere)
    return (po_scales){.load = 1.0,
                       .load_factor = adhesion,
                       .stretch = mu,
                       .wavy_stretch = mu * root * root,
                       .contact_gap = per_stretch * mu * root * root};
  const jkr smooth = jkr_of(scene, 1.0), wavy = adhesion > 1.0 ? jkr_of(scene, adhesion) : smooth;
  const double gap = po_profile_gap(&scene->profile, scene->radius, smooth.contact);
  const double wavy_gap = po_profile_gap(&scene->profile, scene->radius, wavy.contact);
  const double load = fmin(rigid, smooth.pull_off / 1.5), stretch = gap / per_stretch;
  const double usual = stretch > 1.0 ? smooth.pull_off / 1.5 : rigid;
  const double by_waves = fmax(adhesion, wavy.pull_off / smooth.pull_off);
  return (po_scales){.load = load,
                     .load_factor = load > 0.0 ? usual / load * by_waves : 1.0,
                     .stretch = stretch,
                     .wavy_stretch = wavy_gap / per_stretch,
                     .contact_gap = wavy_gap};
}

/* The allowed error of the load, in pi w R, where the waves are replaced by their mean: a
 * thousandth of the default tolerance. */
static const double AVERAGING_LOSS = 1e-9;

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
  const po_law_numbers *far = po_law_numbers_of(&scene->law);
  if (isinf(far->exponent))
    return po_law_numbers_of(&scene->law)->reach;
  /* The integrand of Eq 17 is (2k/R) g^-m r, k g^-m the far field: its slope is at most
   * (2k/R)(2m + 1) g^-m, of which a part of m A/g oscillates when A is small against g. */
  const double per_2pi = scene->wavelength / (2.0 * M_PI), m = far->exponent;
  const double scale = (2.0 * m + 1.0) * 2.0 * far->factor / scene->radius * per_2pi * per_2pi;
  /* From where on scale min(1, m A/g) < loss g^m. */
  const double power = scale / AVERAGING_LOSS;
  return fmin(po_pow(power, 1.0 / m), po_pow(m * scene->amplitude * power, 1.0 / (m + 1.0)));
}

/* Bound of the error of the load if all waves are averaged beyond r. */
static double averaging_error(const po_scene *scene, double r) {
  const po_law_numbers *far = po_law_numbers_of(&scene->law);
  const double gap = po_initial_gap_beyond(scene, r), m = far->exponent;
  const double integrand = 2.0 / scene->radius * far->factor * po_pow(gap, -m) * r;
  const double slope = integrand * (m * po_profile_shape(&scene->profile).growth + 1.0) / r;
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

static double end_of_waves(const po_scene *scene, double from) {
  if (po_profile_is_sphere(&scene->profile) && po_scene_waves(scene) == 1)
    return sqrt(2.0 * scene->radius * averaging_gap(scene));
  if (isinf(po_law_numbers_of(&scene->law)->exponent))
    return po_initial_gap_radius(scene, po_law_numbers_of(&scene->law)->reach);
  const double allowed = AVERAGING_LOSS * po_scene_scales(scene).load;
  double r = from;
  while (averaging_error(scene, r) > allowed)
    r *= PO_NEXT_RADIUS;
  return r;
}

double po_averaging_radius(const po_scene *scene, double from) {
  if (!po_scene_is_wavy(scene))
    return from;
  const double length = main_wave(scene).length;
  const double waves = ceil((end_of_waves(scene, from) - from) / length);
  return waves > 0.0 ? from + waves * length : from;
}
