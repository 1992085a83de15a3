#include "po_wavy_rigid.h"

#include <math.h>
#include <stdbool.h>

#include "po_elementary.h"
#include "po_quadrature.h"
#include "po_root.h"

double po_bradley_load(double approach) {
  if (!(approach < 1.0))
    return NAN;
  const double x = 1.0 / (1.0 - approach), x2 = x * x;
  return -2.0 / 3.0 * x2 * (4.0 - x2 * x2 * x2);
}

/* POINTS: points of the Gauss rule on a panel, whose length in t is at most 1. DIRECT_WAVES:
 * wavelengths that are integrated one by one; the first neglected term of the Euler-Maclaurin
 * formula is then below 1e-10 of the load. SCAN_POINTS: intervals, equal in ln(1 - approach), of
 * the search for the pull-off; neighbouring values of 1 - approach differ by 2 to 3 per cent. */
enum { POINTS = 16, DIRECT_WAVES = 128, SCAN_POINTS = 160 };

/* Eq 21 as y = 1 + H = x + c s^2 + A (1 - cos phi) with s = theta = 2 pi nu + phi; nu is the number
 * of the wavelength. */
typedef struct {
  double x, c, amplitude;
  double node[POINTS], weight[POINTS];
} wave_field;

/* Integrals over phi of one wavelength, with the law l(y) = y^-3 - y^-9 of Eq 22. */
typedef struct {
  double load;        /* of s l(y) */
  double load_slope;  /* of d(s l)/ds */
  double rate;        /* of s l'(y) */
  double rate_slope;  /* of d(s l')/ds */
  double beyond;      /* of e(y)/(4 pi c), e' = -l: the integral of all wavelengths from nu on */
  double beyond_rate; /* of -l(y)/(4 pi c): its derivative */
} wave_sums;

static void add_point(const wave_field *f, double nu, double phi, double weight, wave_sums *sums) {
  const double half = po_sin(0.5 * phi), s = 2.0 * M_PI * nu + phi;
  const double y = f->x + f->c * s * s + 2.0 * f->amplitude * half * half;
  const double v = 1.0 / y, v2 = v * v, v3 = v2 * v, v6 = v3 * v3;
  const double law = v3 * (1.0 - v6), first = -3.0 * v2 * v2 * (1.0 - 3.0 * v6);
  const double second = 12.0 * v2 * v3 - 90.0 * v6 * v3 * v2;
  const double s_dy_ds = 2.0 * f->c * s * s;
  sums->load += weight * s * law;
  sums->load_slope += weight * (law + s_dy_ds * first);
  sums->rate += weight * s * first;
  sums->rate_slope += weight * (first + s_dy_ds * second);
  sums->beyond += weight * (0.5 * v2 - 0.125 * v6 * v2) / (4.0 * M_PI * f->c);
  sums->beyond_rate -= weight * law / (4.0 * M_PI * f->c);
}

/* The integration over t ends at this distance: y grows as exp(2t), so that the integrands decrease
 * at least as exp(-3t), to 1e-21 at the end. The limit bounds the work for steep crests, whose
 * width is a small fraction of the wavelength. */
static const double FARTHEST = 16.0;

/* Adds the integrals from `crest` to `end`, with the substitution phi = crest + width sinh(t). */
static void add_side(const wave_field *f, double nu, double crest, double end, double width,
                     wave_sums *sums) {
  const double whole = po_asinh((end - crest) / width);
  const double span = copysign(fmin(fabs(whole), FARTHEST), whole);
  const int panels = (int)ceil(fabs(span));
  for (int p = 0; p < panels; ++p)
    for (int i = 0; i < POINTS; ++i) {
      const double t = span * (p + f->node[i]) / panels;
      const double grown = 0.5 * width * po_exp(t), shrunk = 0.25 * width * width / grown;
      add_point(f, nu, crest + (grown - shrunk),
                f->weight[i] * fabs(span) / panels * (grown + shrunk), sums);
    }
}

static double angle_of_sine(double sine) {
  return po_atan2(sine, sqrt((1.0 - sine) * (1.0 + sine)));
}

/* The integrals over the wavelength centred at s = 2 pi nu; for nu = 0 over its outer half. */
static wave_sums wave(const wave_field *f, double nu) {
  wave_sums sums = {0};
  const double slope = 4.0 * M_PI * f->c * nu;
  const double crest = slope < f->amplitude ? -angle_of_sine(slope / f->amplitude) : -M_PI_2;
  const double half = po_sin(0.5 * crest), s = 2.0 * M_PI * nu + crest;
  const double y = f->x + f->c * s * s + 2.0 * f->amplitude * half * half;
  const double curvature = f->amplitude * po_cos(crest) + 2.0 * f->c;
  const double width = fmin(1.0, sqrt(2.0 * y / curvature));
  add_side(f, nu, crest, M_PI, width, &sums);
  if (nu > 0.0)
    add_side(f, nu, crest, -M_PI, width, &sums);
  return sums;
}

static void integrate(double amplitude, double alpha, double approach, double *load, double *rate) {
  wave_field f = {
      .x = 1.0 - approach, .c = amplitude / (8.0 * M_PI * M_PI * alpha), .amplitude = amplitude};
  *load = *rate = NAN;
  if (po_gauss_rule(POINTS, f.node, f.weight))
    return;
  /* Euler-Maclaurin formula: sum over n >= N of I(n) = integral of I from N - 1/2 + I'(N - 1/2)/24
   * - ..., ds = 2 pi dnu */
  const wave_sums tail = wave(&f, DIRECT_WAVES - 0.5);
  double sum = tail.beyond + 2.0 * M_PI / 24.0 * tail.load_slope;
  double sum_rate = tail.beyond_rate + 2.0 * M_PI / 24.0 * tail.rate_slope;
  for (int n = DIRECT_WAVES - 1; n >= 0; --n) {
    const wave_sums sums = wave(&f, n);
    sum += sums.load;
    sum_rate += sums.rate;
  }
  *load = -32.0 / 3.0 * f.c * sum; /* the factor of Eq 22: 4 A/(3 pi^2 alpha) = 32 c/3 */
  *rate = 32.0 / 3.0 * f.c * sum_rate;
}

static bool is_inside(double amplitude, double alpha, double approach) {
  return amplitude > 0.0 && isfinite(amplitude) && alpha > 0.0 && isfinite(alpha) &&
         approach < 1.0 && isfinite(approach);
}

double po_wavy_rigid_load(double amplitude, double alpha, double approach) {
  double load = NAN, rate;
  if (amplitude == 0.0)
    return po_bradley_load(approach);
  if (is_inside(amplitude, alpha, approach))
    integrate(amplitude, alpha, approach, &load, &rate);
  return load;
}

double po_wavy_rigid_rate(double amplitude, double alpha, double approach) {
  double load, rate = NAN;
  if (is_inside(amplitude, alpha, approach))
    integrate(amplitude, alpha, approach, &load, &rate);
  return rate;
}

typedef struct {
  double amplitude, alpha;
} scene_numbers;

static double rate_at(double approach, const void *data) {
  const scene_numbers *s = data;
  return po_wavy_rigid_rate(s->amplitude, s->alpha, approach);
}

po_rigid_pull_off po_wavy_rigid_pull_off(double amplitude, double alpha) {
  if (amplitude == 0.0)
    return (po_rigid_pull_off){2.0, 0.0};
  po_rigid_pull_off best = {NAN, NAN};
  if (!is_inside(amplitude, alpha, 0.0))
    return best;
  /* The minimum lies between these values of x = 1 - approach: below `least` the repulsion of the
   * first crest alone exceeds all attraction; above 3^(1/6) (text after Eq 9) the tension decreases
   * with the gap everywhere. */
  const double least = po_pow(4.0 * (1.0 + 4.0 * M_PI * M_PI * alpha), -1.0 / 6.0);
  const double most = 1.01 * sqrt(po_cbrt(3.0)), ratio = po_pow(most / least, 1.0 / SCAN_POINTS);
  const scene_numbers data = {amplitude, alpha};
  double x = most, right = 1.0 - x, right_rate = rate_at(right, &data);
  for (int i = 0; i < SCAN_POINTS; ++i) {
    const double left = right, left_rate = right_rate;
    x /= ratio;
    right = 1.0 - x;
    right_rate = rate_at(right, &data);
    if (!(left_rate < 0.0 && right_rate >= 0.0))
      continue;
    const double approach = po_root(rate_at, &data, left, right);
    const double force = -po_wavy_rigid_load(amplitude, alpha, approach);
    if (!(force <= best.force))
      best = (po_rigid_pull_off){force, approach};
  }
  return best;
}
