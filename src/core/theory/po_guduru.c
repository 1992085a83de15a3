#include "po_guduru.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_margins.h"
#include "po_root.h"
#include "po_special.h"

/* The coefficients of Eq 5, lengths in eps, loads in pi w R, e = E* eps/w = sqrt(R/mu^3). */
typedef struct {
  double k;                 /* 2 pi/lambda; 0: smooth */
  double length;            /* lambda; 1: smooth */
  double hertz;             /* coefficient of a^3 in the load: 4 e/(3 pi R^2) */
  double adhesion;          /* coefficient of -a^(3/2) in the load: sqrt(8 e/pi)/R */
  double wave;              /* coefficient of a [x H0(x) - H1(x)] in the load: e A/R */
  double adhesion_approach; /* coefficient of -sqrt(a) in the approach: sqrt(2 pi/e) */
} coefficients;

static coefficients coefficients_of(const po_scene *scene) {
  const double radius = scene->radius;
  const double e = po_scene_stiffness(scene);
  const bool wavy = po_scene_is_wavy(scene);
  return (coefficients){.k = wavy ? 2.0 * M_PI / scene->wavelength : 0.0,
                        .length = wavy ? scene->wavelength : 1.0,
                        .hertz = 4.0 * e / (3.0 * M_PI * radius * radius),
                        .adhesion = sqrt(8.0 * e / M_PI) / radius,
                        .wave = wavy ? e * scene->amplitude / radius : 0.0,
                        .adhesion_approach = sqrt(2.0 * M_PI / e)};
}

/* x = k a, H0(x) and H1(x); all 0 for a smooth sphere */
typedef struct {
  double x, h0, h1;
} wave_terms;

static wave_terms waves_at(const coefficients *t, double a) {
  if (t->k == 0.0)
    return (wave_terms){0.0, 0.0, 0.0};
  return (wave_terms){t->k * a, po_struve_wave(0, a, t->length), po_struve_wave(1, a, t->length)};
}

static double load_at(const coefficients *t, wave_terms s, double a) {
  return t->hertz * a * a * a + t->wave * a * (s.x * s.h0 - s.h1) - t->adhesion * a * sqrt(a);
}

static bool is_inside(const po_scene *scene, double contact_radius) {
  return scene->tabor > 0.0 && scene->radius > 0.0 && contact_radius >= 0.0 &&
         (!po_scene_is_wavy(scene) || scene->wavelength > 0.0);
}

po_contact po_guduru_at(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return (po_contact){NAN, NAN, NAN};
  const coefficients t = coefficients_of(scene);
  const double a = contact_radius;
  const wave_terms s = waves_at(&t, a);
  return (po_contact){.load = load_at(&t, s, a),
                      .approach = a * a / scene->radius + scene->amplitude * M_PI_2 * s.x * s.h0 -
                                  t.adhesion_approach * sqrt(a),
                      .contact_radius = a};
}

/* dW/da of Eq 5, from d/dx [x H0 - H1] = x (2/pi - H1) + H1/x with H0' = 2/pi - H1 and H1' = H0 -
 * H1/x (Abramowitz and Stegun, Sec. 12.1). */
static double rate(double a, const void *data) {
  const coefficients *t = data;
  const wave_terms s = waves_at(t, a);
  return 3.0 * t->hertz * a * a + t->wave * s.x * (s.h0 + s.x * (M_2_PI - s.h1)) -
         1.5 * t->adhesion * sqrt(a);
}

double po_guduru_rate(const po_scene *scene, po_fixed fixed, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return NAN;
  const coefficients t = coefficients_of(scene);
  const double a = contact_radius;
  if (fixed == PO_FIXED_LOAD)
    return rate(a, &t);
  const wave_terms s = waves_at(&t, a); /* H0' = 2/pi - H1 */
  return 2.0 * a / scene->radius +
         scene->amplitude * M_PI_2 * t.k * (s.h0 + s.x * (M_2_PI - s.h1)) -
         0.5 * t.adhesion_approach / sqrt(a);
}

/* Bound of the oscillation: |x H0 - H1| <= sqrt(2x/pi) (1 + WAVE_BOUND/x^2.5). Derivation: x H0 -
 * H1 is a cosine with the modulus sqrt((x J0 - J1)^2 + (x Y0 - Y1)^2) = sqrt(2x/pi) (1 - 1/(16 x^2)
 * + ...), minus 4/(pi x^2) from the part that does not oscillate. The smallest WAVE_BOUND that
 * holds at 4000 points from x = 0.5 to 200 is 1.33, reached at x = 11.7. The resulting bound of the
 * load is attained once in each wavelength up to a relative difference of (lambda/a)^2. */
static const double WAVE_BOUND = 1.5;

/* Returned: a lower bound of the load of Eq 5 at contact radius a; it decreases and then increases
 * with a. */
static double lower_bound(const coefficients *t, double a) {
  if (t->wave == 0.0)
    return t->hertz * a * a * a - t->adhesion * a * sqrt(a);
  const double x = t->k * a,
               modulus = sqrt(2.0 / M_PI * x) * (1.0 + WAVE_BOUND / (x * x * sqrt(x)));
  return t->hertz * a * a * a - t->adhesion * a * sqrt(a) - t->wave * a * modulus;
}

/* Searches (from, to) for minima of the load and updates *best with the lowest one. Given: `count`
 * intervals of equal length (or ratio, if geometric), in each of which dW/da changes sign at most
 * once. */
static void scan(const po_scene *scene, const coefficients *t, double from, double to, int count,
                 bool geometric, po_contact *best) {
  double left = from;
  for (int i = 1; i <= count; ++i) {
    const double part = (double)i / count;
    const double right = geometric ? from * po_pow(to / from, part) : from + (to - from) * part;
    if (rate(left, t) < 0.0 && rate(right, t) >= 0.0) {
      const po_contact found = po_guduru_at(scene, po_root(rate, t, left, right));
      if (found.load < best->load)
        *best = found;
    }
    left = right;
  }
}

/* POINTS_OF_FIRST: points in the first wavelength if it is scanned from PO_GUDURU_FIRST; the last
 * two are then nearer to each other than those of other waves, as log(1/PO_GUDURU_FIRST) is less
 * than 25. MOST_POINTS: limit of the latter for extreme scenes. */
enum { POINTS_OF_FIRST = 25 * PO_POINTS_PER_WAVE, MOST_POINTS = 40000 };
const double PO_GUDURU_FIRST = 1e-9;
/* If the contact contains more wavelengths than this, the pull-off is taken from the envelope: the
 * spacing of doubles is then 1e-8 wavelengths, so that a minimum could be located only to 1e-15 of
 * the load. */
static const double MOST_WAVES = 1e8;
/* Differences below this fraction of the largest term of the load are rounding. */
static const double ROUNDING = 8.0 * DBL_EPSILON;

/* The depth of the envelope hertz a^3 - depth a^(3/2). */
static double depth_of(const coefficients *t) {
  return t->adhesion + t->wave * sqrt(2.0 * t->k / M_PI);
}

/* The pull-off on the envelope, at the trough x = 2 pi (m + 7/8) of Y0(x) nearest to its minimum.
 * The neglected part is 1/x^2 of the terms, at most 3e-18. */
static po_contact envelope_pull_off(const po_scene *scene, const coefficients *t, double lowest) {
  const double a = t->length * (floor(lowest / t->length) + 0.875);
  const double modulus = sqrt(2.0 / M_PI * t->k * a);
  return (po_contact){.load = t->hertz * a * a * a - depth_of(t) * a * sqrt(a),
                      .approach = a * a / scene->radius +
                                  scene->amplitude * (1.0 - M_PI_2 * modulus) -
                                  t->adhesion_approach * sqrt(a),
                      .contact_radius = a};
}

/* The contact radius at pull-off of the crest at the axis alone: JKR with the composite radius of
 * Eq 19. */
static double crest_contact(const po_scene *scene) {
  const double curvature_ratio = 1.0 + 4.0 * M_PI * M_PI * po_scene_alpha(scene);
  return po_jkr_pull_off(scene).contact_radius / po_cbrt(curvature_ratio * curvature_ratio);
}

/* Scans wavelengths from number n outwards (step 1) or inwards (step -1), as long as they may
 * contain a lower load than *best. Given: lowest, the contact radius at which the lower bound is
 * lowest. */
static void scan_waves(const po_scene *scene, const coefficients *t, double lowest, double n,
                       double step, po_contact *best) {
  for (; n >= 1.0; n += step) {
    const double near =
        step > 0.0 ? fmax(n * t->length, lowest) : fmin((n + 1.0) * t->length, lowest);
    const double hidden = ROUNDING * t->hertz * near * near * near;
    if (!(lower_bound(t, near) < fmin(best->load, 0.0) - hidden)) /* 0 is the load at a = 0 */
      return;
    scan(scene, t, n * t->length, (n + 1.0) * t->length, PO_POINTS_PER_WAVE, false, best);
  }
}

/* Returned: the contact radius at which the lower bound without the term WAVE_BOUND is lowest. */
static double lowest_of(const coefficients *t) {
  const double root = po_cbrt(0.5 * depth_of(t) / t->hertz);
  return root * root;
}

po_contact po_guduru_pull_off(const po_scene *scene) {
  const po_contact none = {NAN, NAN, NAN};
  if (!is_inside(scene, 0.0))
    return none;
  if (!po_scene_is_wavy(scene))
    return po_jkr_pull_off(scene);
  const coefficients t = coefficients_of(scene);
  const double lowest = lowest_of(&t), wave = t.length;
  if (!(isfinite(lowest / wave) && isfinite(t.hertz * lowest * lowest * lowest)))
    return none;
  po_contact best = {INFINITY, NAN, NAN};
  const double from = fmin(PO_GUDURU_FIRST * wave, 0.01 * crest_contact(scene));
  const double points = ceil(POINTS_OF_FIRST * po_log10(wave / from) / -po_log10(PO_GUDURU_FIRST));
  if (!(from > DBL_MIN && points < MOST_POINTS))
    return none;
  scan(scene, &t, from, wave, (int)points, true, &best);
  if (lowest > MOST_WAVES * wave) {
    const po_contact far = envelope_pull_off(scene, &t, lowest);
    return far.load < best.load ? far : best;
  }
  const double middle = fmax(1.0, floor(lowest / wave));
  scan_waves(scene, &t, lowest, middle, 1.0, &best);
  scan_waves(scene, &t, lowest, middle - 1.0, -1.0, &best);
  return isfinite(best.load) ? best : none;
}

/* Returned: the contact radius in (left, right), where dW/da changes sign at most once, at which
 * the load has a minimum not above the given load; NAN if there is none. */
static double minimum_within(const coefficients *t, double load, double left, double right) {
  if (!(rate(left, t) < 0.0 && rate(right, t) >= 0.0))
    return NAN;
  const double least = po_root(rate, t, left, right);
  return load_at(t, waves_at(t, least), least) - load <= 0.0 ? least : NAN;
}

/* Returned: a contact radius beyond which the lower bound, and therefore the load, is above
 * `load`. */
static double radius_beyond(const coefficients *t, double load) {
  double a = fmax(lowest_of(t), t->k > 0.0 ? t->length : 0.0);
  while (lower_bound(t, a) <= load)
    a *= PO_FARTHER;
  return a;
}

/* The largest contact radius between two at which the lower bound is not above `load`, to
 * rounding. Given: the bound is above the load at `high` and not at `low`, and increases. */
static double radius_of_bound(const coefficients *t, double load, double low, double high) {
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    *(lower_bound(t, middle) > load ? &high : &low) = middle;
  return high;
}

/* The radius from which the search for the last minimum of a wavy sphere goes on inwards, beyond
 * the steps in which the bound excludes a minimum. These are made one by one, for the sake of the
 * same brackets and therefore the same bits, unless they are many: from MANY_WAVES on. */
static const double MANY_WAVES = 1e4;

static double skip_excluded(const coefficients *t, double load, double lowest, double step,
                            double right) {
  const double wave = t->length;
  const bool many = right > MANY_WAVES * wave;
  if (many && right > lowest)
    right = lower_bound(t, lowest) > load ? wave : radius_of_bound(t, load, lowest, right);
  /* below `lowest` the bound grows inwards, up to the first wave */
  while (right > wave && right < MOST_WAVES * wave &&
         lower_bound(t, fmin(fmax(right - step, lowest), right)) > load)
    right = many && right <= lowest ? wave : right - step;
  return right;
}

double po_guduru_last_minimum(const po_scene *scene, double load, double excess) {
  if (!is_inside(scene, 0.0) || !(load < 0.0))
    return NAN;
  coefficients t = coefficients_of(scene);
  t.adhesion *= 1.0 + excess;
  double right = radius_beyond(&t, load);
  if (!isfinite(right))
    return NAN;
  const bool wavy = po_scene_is_wavy(scene);
  const double step = wavy ? t.length / PO_POINTS_PER_WAVE : right;
  const double lowest = lowest_of(&t);
  while (right > PO_NEAR_AXIS * step) {
    if (wavy)
      right = skip_excluded(&t, load, lowest, step, right);
    if (wavy && right > MOST_WAVES * t.length)
      return right;
    const double left = fmax(right - step, 0.5 * right);
    const double last = minimum_within(&t, load, left, right);
    if (last > 0.0)
      return last;
    right = left;
  }
  return 0.0;
}
