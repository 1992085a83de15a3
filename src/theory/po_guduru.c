#include "po_guduru.h"

#include <math.h>
#include <stddef.h>

#include "po_root.h"
#include "po_struve.h"

/* The numbers Eq 5 is made of. */
typedef struct {
  double k;      /* 2 pi / lambda, times eps; 0: smooth */
  double hertz;  /* of a^3 in the load: 4 e/(3 pi R^2), e = E* eps/w = sqrt(R/mu^3) */
  double suck;   /* of a^(3/2): sqrt(8 e/pi)/R */
  double wave;   /* of a [x H0(x) - H1(x)]: e A/R */
  double spread; /* of sqrt(a) in the approach: sqrt(2 pi/e) */
} terms;

static terms terms_of(const po_scene *scene) {
  const double radius = scene->radius;
  const double e = sqrt(radius / (scene->tabor * scene->tabor * scene->tabor));
  const bool wavy = po_scene_is_wavy(scene);
  return (terms){.k = wavy ? 2.0 * M_PI / scene->wavelength : 0.0,
                 .hertz = 4.0 * e / (3.0 * M_PI * radius * radius),
                 .suck = sqrt(8.0 * e / M_PI) / radius,
                 .wave = wavy ? e * scene->amplitude / radius : 0.0,
                 .spread = sqrt(2.0 * M_PI / e)};
}

static bool is_inside(const po_scene *scene, double contact_radius) {
  return scene->tabor > 0.0 && scene->radius > 0.0 && contact_radius >= 0.0 &&
         (!po_scene_is_wavy(scene) || scene->wavelength > 0.0);
}

po_contact po_guduru_at(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return (po_contact){NAN, NAN, NAN};
  const terms t = terms_of(scene);
  const double a = contact_radius, x = t.k * a, h0 = po_struve(0, x), h1 = po_struve(1, x);
  return (po_contact){
      .load = t.hertz * a * a * a + t.wave * a * (x * h0 - h1) - t.suck * a * sqrt(a),
      .approach = a * a / scene->radius + scene->amplitude * M_PI_2 * x * h0 - t.spread * sqrt(a),
      .contact_radius = a};
}

/* d/dx [x H0 - H1] = x (2/pi - H1) + H1/x, since H0' = 2/pi - H1 and H1' = H0 - H1/x. */
static double rate(double a, const void *data) {
  const terms *t = data;
  const double x = t->k * a;
  const double h0 = po_struve(0, x), h1 = po_struve(1, x);
  return 3.0 * t->hertz * a * a + t->wave * x * (h0 + x * (M_2_PI - h1)) - 1.5 * t->suck * sqrt(a);
}

double po_guduru_load_rate(const po_scene *scene, double contact_radius) {
  const terms t = terms_of(scene);
  return is_inside(scene, contact_radius) ? rate(contact_radius, &t) : NAN;
}

double po_guduru_approach_rate(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return NAN;
  const terms t = terms_of(scene);
  const double a = contact_radius, x = t.k * a; /* H0' = 2/pi - H1 */
  return 2.0 * a / scene->radius +
         scene->amplitude * M_PI_2 * t.k * (po_struve(0, x) + x * (M_2_PI - po_struve(1, x))) -
         0.5 * t.spread / sqrt(a);
}

/* |x H0 - H1| <= sqrt(2x/pi) (1 + WAVE_BOUND/x) for all x > 0: the least bound that holds on 6e5
 * points from 1e-6 to 1000 is 0.104, at x = 5.3; beyond, the asymptotic form of Y_n gives it. */
static const double WAVE_BOUND = 0.2;

/* Not above the load of Eq 5 anywhere; falls, then rises. */
static double lower_bound(const terms *t, double a) {
  const double swing =
      t->wave * a * sqrt(2.0 / M_PI) * (sqrt(t->k * a) + WAVE_BOUND / sqrt(t->k * a));
  return t->hertz * a * a * a - t->suck * a * sqrt(a) - swing;
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
enum { POINTS_PER_WAVE = 16, POINTS_OF_FIRST = 400 };
/* The first wave is scanned from this part of it on: a crest's own minimum may be far inside. */
static const double FIRST_FROM = 1e-9;

po_contact po_guduru_pull_off(const po_scene *scene) {
  if (!is_inside(scene, 0.0))
    return (po_contact){NAN, NAN, NAN};
  if (!po_scene_is_wavy(scene))
    return po_jkr_pull_off(scene);
  const terms t = terms_of(scene);
  const double wave = scene->wavelength;
  po_contact best = {INFINITY, NAN, NAN};
  scan(scene, &t, FIRST_FROM * wave, wave, POINTS_OF_FIRST, true, &best);
  /* outwards from the lowest point of the bound without its second term */
  const double depth = t.suck + t.wave * sqrt(2.0 * t.k / M_PI);
  const double middle = fmax(1.0, floor(cbrt(pow(0.5 * depth / t.hertz, 2.0)) / wave));
  for (double n = middle;; n += 1.0) {
    if (n > middle + 1.0 && lower_bound(&t, n * wave) > fmin(best.load, 0.0))
      break;
    scan(scene, &t, n * wave, (n + 1.0) * wave, POINTS_PER_WAVE, false, &best);
  }
  for (double n = middle - 1.0; n >= 1.0; n -= 1.0) {
    if (n < middle - 1.0 && lower_bound(&t, (n + 1.0) * wave) > fmin(best.load, 0.0))
      break;
    scan(scene, &t, n * wave, (n + 1.0) * wave, POINTS_PER_WAVE, false, &best);
  }
  return best;
}
