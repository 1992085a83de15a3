#include "po_guduru.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "po_root.h"
#include "po_struve.h"

/* The numbers Eq 5 is made of. */
typedef struct {
  double k;      /* 2 pi / lambda, times eps; 0: smooth */
  double length; /* lambda / eps; 1: smooth */
  double hertz;  /* of a^3 in the load: 4 e/(3 pi R^2), e = E* eps/w = sqrt(R/mu^3) */
  double suck;   /* of a^(3/2): sqrt(8 e/pi)/R */
  double wave;   /* of a [x H0(x) - H1(x)]: e A/R */
  double spread; /* of sqrt(a) in the approach: sqrt(2 pi/e) */
} terms;

static terms terms_of(const po_scene *scene) {
  const double radius = scene->radius;
  const double e = po_scene_stiffness(scene);
  const bool wavy = po_scene_is_wavy(scene);
  return (terms){.k = wavy ? 2.0 * M_PI / scene->wavelength : 0.0,
                 .length = wavy ? scene->wavelength : 1.0,
                 .hertz = 4.0 * e / (3.0 * M_PI * radius * radius),
                 .suck = sqrt(8.0 * e / M_PI) / radius,
                 .wave = wavy ? e * scene->amplitude / radius : 0.0,
                 .spread = sqrt(2.0 * M_PI / e)};
}

/* x = ka, H0(x), H1(x); without waves 0. */
typedef struct {
  double x, h0, h1;
} wave_terms;

static wave_terms waves_at(const terms *t, double a) {
  if (t->k == 0.0)
    return (wave_terms){0.0, 0.0, 0.0};
  return (wave_terms){t->k * a, po_struve_wave(0, a, t->length), po_struve_wave(1, a, t->length)};
}

static bool is_inside(const po_scene *scene, double contact_radius) {
  return scene->tabor > 0.0 && scene->radius > 0.0 && contact_radius >= 0.0 &&
         (!po_scene_is_wavy(scene) || scene->wavelength > 0.0);
}

po_contact po_guduru_at(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return (po_contact){NAN, NAN, NAN};
  const terms t = terms_of(scene);
  const double a = contact_radius;
  const wave_terms s = waves_at(&t, a);
  return (po_contact){
      .load = t.hertz * a * a * a + t.wave * a * (s.x * s.h0 - s.h1) - t.suck * a * sqrt(a),
      .approach =
          a * a / scene->radius + scene->amplitude * M_PI_2 * s.x * s.h0 - t.spread * sqrt(a),
      .contact_radius = a};
}

/* d/dx [x H0 - H1] = x (2/pi - H1) + H1/x, since H0' = 2/pi - H1 and H1' = H0 - H1/x. */
static double rate(double a, const void *data) {
  const terms *t = data;
  const wave_terms s = waves_at(t, a);
  return 3.0 * t->hertz * a * a + t->wave * s.x * (s.h0 + s.x * (M_2_PI - s.h1)) -
         1.5 * t->suck * sqrt(a);
}

double po_guduru_load_rate(const po_scene *scene, double contact_radius) {
  const terms t = terms_of(scene);
  return is_inside(scene, contact_radius) ? rate(contact_radius, &t) : NAN;
}

double po_guduru_approach_rate(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return NAN;
  const terms t = terms_of(scene);
  const double a = contact_radius;
  const wave_terms s = waves_at(&t, a); /* H0' = 2/pi - H1 */
  return 2.0 * a / scene->radius +
         scene->amplitude * M_PI_2 * t.k * (s.h0 + s.x * (M_2_PI - s.h1)) -
         0.5 * t.spread / sqrt(a);
}

/* |x H0 - H1| <= sqrt(2x/pi) (1 + WAVE_BOUND/x^2.5): it is the modulus sqrt((x J0 - J1)^2 + (x Y0 -
 * Y1)^2) = sqrt(2x/pi) (1 - 1/(16 x^2) + ...) times a cosine, less 4/(pi x^2) of the part that does
 * not oscillate. The least bound that holds on 4000 points from 0.5 to 200 is 1.33, at x = 11.7. So
 * the bound of the load below is met once in every wave, to (lambda/a)^2. */
static const double WAVE_BOUND = 1.5;

/* Not above the load of Eq 5 anywhere; falls, then rises. */
static double lower_bound(const terms *t, double a) {
  if (t->wave == 0.0)
    return t->hertz * a * a * a - t->suck * a * sqrt(a);
  const double x = t->k * a,
               modulus = sqrt(2.0 / M_PI * x) * (1.0 + WAVE_BOUND / (x * x * sqrt(x)));
  return t->hertz * a * a * a - t->suck * a * sqrt(a) - t->wave * a * modulus;
}

/* The deepest minimum in (from, to), where the rate changes sign at most once between neighbours of
 * `count` points spaced evenly (or geometrically). */
static void scan(const po_scene *scene, const terms *t, double from, double to, int count,
                 bool geometric, po_contact *best) {
  double left = from;
  for (int i = 1; i <= count; ++i) {
    const double part = (double)i / count;
    const double right = geometric ? from * pow(to / from, part) : from + (to - from) * part;
    if (rate(left, t) < 0.0 && rate(right, t) >= 0.0) {
      const po_contact found = po_guduru_at(scene, po_root(rate, t, left, right));
      if (found.load < best->load)
        *best = found;
    }
    left = right;
  }
}

/* Points a wave: the rate has two zeros in one, and bends on the scale of a quarter of it. */
enum { POINTS_PER_WAVE = 16, POINTS_OF_FIRST = 400, MOST_POINTS = 40000 };
const double PO_GUDURU_FIRST = 1e-9;
/* From so many waves within the contact on, the pull-off is where the load meets its envelope: the
 * next double is a part of 1e-8 of a wave away, and a minimum between two of them would be missed
 * by 1e-15 of the load. */
static const double MOST_WAVES = 1e8;
/* Steps of searches for a contact radius. */
static const double GROWTH = 1.3, FINEST = 1e-3;
/* Of the terms of the load: what their rounding hides. */
static const double ROUNDING = 8.0 * DBL_EPSILON;

/* The pull-off on the envelope hertz a^3 - depth a^(3/2), at the trough x = 2 pi (m + 7/8) of Y0(x)
 * next to its minimum. What is left out is 1/x^2 of the terms, 3e-18 and less. */
static po_contact envelope_pull_off(const po_scene *scene, const terms *t, double depth,
                                    double lowest) {
  const double a = t->length * (floor(lowest / t->length) + 0.875);
  const double modulus = sqrt(2.0 / M_PI * t->k * a);
  return (po_contact){.load = t->hertz * a * a * a - depth * a * sqrt(a),
                      .approach = a * a / scene->radius +
                                  scene->amplitude * (1.0 - M_PI_2 * modulus) - t->spread * sqrt(a),
                      .contact_radius = a};
}

/* The contact radius at pull-off of a crest by itself: JKR with the composite radius of Eq 19. */
static double crest_contact(const po_scene *scene) {
  const double sharper = 1.0 + 4.0 * M_PI * M_PI * po_scene_alpha(scene);
  return po_jkr_pull_off(scene).contact_radius / cbrt(sharper * sharper);
}

/* Scans waves from number n on, inwards or outwards, while they may hold what is deeper. Given:
 * where the bound is lowest. */
static void scan_waves(const po_scene *scene, const terms *t, double lowest, double n, double step,
                       po_contact *best) {
  for (; n >= 1.0; n += step) {
    const double near =
        step > 0.0 ? fmax(n * t->length, lowest) : fmin((n + 1.0) * t->length, lowest);
    const double hidden = ROUNDING * t->hertz * near * near * near;
    if (!(lower_bound(t, near) < fmin(best->load, 0.0) - hidden)) /* 0: the load at a = 0 */
      return;
    scan(scene, t, n * t->length, (n + 1.0) * t->length, POINTS_PER_WAVE, false, best);
  }
}

po_contact po_guduru_pull_off(const po_scene *scene) {
  const po_contact none = {NAN, NAN, NAN};
  if (!is_inside(scene, 0.0))
    return none;
  if (!po_scene_is_wavy(scene))
    return po_jkr_pull_off(scene);
  const terms t = terms_of(scene);
  /* the lowest point of the bound without its second term */
  const double depth = t.suck + t.wave * sqrt(2.0 * t.k / M_PI);
  const double lowest = cbrt(pow(0.5 * depth / t.hertz, 2.0)), wave = t.length;
  if (!(isfinite(lowest / wave) && isfinite(t.hertz * lowest * lowest * lowest)))
    return none;
  po_contact best = {INFINITY, NAN, NAN};
  const double from = fmin(PO_GUDURU_FIRST * wave, 0.01 * crest_contact(scene));
  const double points = ceil(POINTS_OF_FIRST * log10(wave / from) / -log10(PO_GUDURU_FIRST));
  if (!(from > DBL_MIN && points < MOST_POINTS))
    return none;
  scan(scene, &t, from, wave, (int)points, true, &best);
  if (lowest > MOST_WAVES * wave) {
    const po_contact far = envelope_pull_off(scene, &t, depth, lowest);
    return far.load < best.load ? far : best;
  }
  const double middle = fmax(1.0, floor(lowest / wave));
  scan_waves(scene, &t, lowest, middle, 1.0, &best);
  scan_waves(scene, &t, lowest, middle - 1.0, -1.0, &best);
  return isfinite(best.load) ? best : none;
}

/* The load of Eq 5 less a given one. */
typedef struct {
  terms t;
  double load;
} above;

static double load_above(double a, const void *data) {
  const above *f = data;
  const wave_terms s = waves_at(&f->t, a);
  return f->t.hertz * a * a * a + f->t.wave * a * (s.x * s.h0 - s.h1) - f->t.suck * a * sqrt(a) -
         f->load;
}

/* The contact radius in (left, right) at which the load has a minimum not above the given one,
 * where the rate changes sign at most once; NAN: there is none. */
static double minimum_within(const above *f, double left, double right) {
  if (!(rate(left, &f->t) < 0.0 && rate(right, &f->t) >= 0.0))
    return NAN;
  const double least = po_root(rate, &f->t, left, right);
  return load_above(least, f) <= 0.0 ? least : NAN;
}

/* A contact radius beyond which the lower bound, and so the load, is above a load. */
static double bound_above(const terms *t, double load) {
  const double depth = t->suck + t->wave * sqrt(2.0 * t->k / M_PI);
  double a = fmax(cbrt(pow(0.5 * depth / t->hertz, 2.0)), t->k > 0.0 ? t->length : 0.0);
  while (lower_bound(t, a) <= load)
    a *= GROWTH;
  return a;
}

double po_guduru_last_minimum(const po_scene *scene, double load, double excess) {
  if (!is_inside(scene, 0.0) || !(load < 0.0))
    return NAN;
  above f = {terms_of(scene), load};
  f.t.suck *= 1.0 + excess;
  double right = bound_above(&f.t, load);
  if (!isfinite(right))
    return NAN;
  const double step = po_scene_is_wavy(scene) ? f.t.length / POINTS_PER_WAVE : FINEST * right;
  while (right > FINEST * step) {
    const double left = fmax(right - step, 0.5 * right);
    const double last = minimum_within(&f, left, right);
    if (last > 0.0)
      return last;
    right = left;
  }
  return 0.0;
}
