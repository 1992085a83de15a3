#include "po_hermite.h"

#include <math.h>

po_hermite po_hermite_at(double x, double h) {
  const double t = x / h, u = 1.0 - t;
  return (po_hermite){.f0 = (1.0 + 2.0 * t) * u * u,
                      .d0 = x * u * u,
                      .f1 = t * t * (3.0 - 2.0 * t),
                      .d1 = -x * t * u};
}

/* With t = x/h, the derivative of the cubic times h is c + 2 b t + 3 a t^2. */
typedef struct {
  double a, b, c;
} derivative;

static derivative derivative_of(double f0, double d0, double f1, double d1, double h) {
  const double c = d0 * h, e = d1 * h, jump = f1 - f0;
  return (derivative){.a = c + e - 2.0 * jump, .b = 3.0 * jump - 2.0 * c - e, .c = c};
}

double po_hermite_value(double f0, double d0, double f1, double d1, double x, double h) {
  const po_hermite w = po_hermite_at(x, h);
  return f0 + w.f1 * (f1 - f0) + w.d0 * d0 + w.d1 * d1; /* w.f0 + w.f1 = 1 */
}

double po_hermite_rate(double f0, double d0, double f1, double d1, double x, double h) {
  const derivative q = derivative_of(f0, d0, f1, d1, h);
  const double t = x / h;
  return (q.c + t * (2.0 * q.b + 3.0 * q.a * t)) / h;
}

double po_hermite_integral(const po_cubic_ends *f, const po_cubic_ends *g, double from, double to) {
  /* The three-point Gauss rule on (-1, 1), exact for f g', which has degree 5. */
  static const double NODE[] = {-0.77459666924148338, 0.0, 0.77459666924148338}; /* sqrt(3/5) */
  static const double WEIGHT[] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const double half = 0.5 * (to - from), middle = 0.5 * (from + to);
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double t = middle + half * NODE[k];
    sum += WEIGHT[k] * po_hermite_value(f->f0, f->d0, f->f1, f->d1, t, 1.0) *
           po_hermite_rate(g->f0, g->d0, g->f1, g->d1, t, 1.0);
  }
  return half * sum;
}

double po_hermite_least_rate(double f0, double d0, double f1, double d1, double h, double beyond) {
  const derivative q = derivative_of(f0, d0, f1, d1, h);
  const double end = d1 * h, largest = fmax(fabs(q.c), fabs(end));
  if (q.c * end <= 0.0)
    return 0.0;
  const double vertex = -q.b / (3.0 * q.a);
  if (!(vertex > -beyond && vertex < 1.0 + beyond))
    return 1.0;
  double least = fmin(fabs(q.c), fabs(end));
  if (vertex > 0.0 && vertex < 1.0) {
    const double there = q.c + q.b * vertex;
    least = there * end <= 0.0 ? 0.0 : fmin(least, fabs(there));
  }
  return least / largest;
}
