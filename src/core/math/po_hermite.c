#include "po_hermite.h"

#include <math.h>
#include <stdlib.h>

#include "po_memory.h"

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

/* The tridiagonal system below[k] s[k-1] + diagonal[k] s[k] + above[k] s[k+1] = right[k]. Its rows
 * but for the first and the last are diagonally dominant, and elimination needs no pivots. */
static void eliminate(size_t count, const double *below, double *diagonal, const double *above,
                      double *right) {
  for (size_t k = 1; k < count; ++k) {
    const double factor = below[k] / diagonal[k - 1];
    diagonal[k] -= factor * above[k - 1];
    right[k] -= factor * right[k - 1];
  }
  for (size_t k = count; k-- > 0;)
    right[k] = (right[k] - (k + 1 < count ? above[k] * right[k + 1] : 0.0)) / diagonal[k];
}

/* The slope of the chord over interval k. */
static double chord(const double *x, const double *y, size_t k) {
  return (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
}

po_status po_spline_slopes(size_t count, const double *x, const double *y, double *slope) {
  double *room = po_allocate(3 * count, sizeof *room);
  if (!room)
    return PO_NO_MEMORY;
  double *const below = room, *const diagonal = room + count, *const above = room + 2 * count;
  const size_t last = count - 1;
  for (size_t k = 1; k < last; ++k) { /* continuous second derivative */
    const double left = x[k] - x[k - 1], right = x[k + 1] - x[k];
    below[k] = right;
    diagonal[k] = 2.0 * (left + right);
    above[k] = left;
    slope[k] = 3.0 * (right * chord(x, y, k - 1) + left * chord(x, y, k));
  }
  /* "not a knot": the third derivative is continuous at the second point, and at the last but one.
   * The neighbouring row is subtracted, so that the system stays tridiagonal. */
  const double h0 = x[1] - x[0], h1 = x[2] - x[1];
  diagonal[0] = h1;
  above[0] = h0 + h1;
  slope[0] = ((h0 + 2.0 * (h0 + h1)) * h1 * chord(x, y, 0) + h0 * h0 * chord(x, y, 1)) / (h0 + h1);
  const double g0 = x[last] - x[last - 1], g1 = x[last - 1] - x[last - 2];
  diagonal[last] = g1;
  below[last] = g0 + g1;
  slope[last] =
      ((g0 + 2.0 * (g0 + g1)) * g1 * chord(x, y, last - 1) + g0 * g0 * chord(x, y, last - 2)) /
      (g0 + g1);
  eliminate(count, below, diagonal, above, slope);
  free(room);
  return PO_OK;
}

/* Largest slope of a monotone cubic, relative to the smaller of the chords beside. */
static const double STEEPEST = 3.0;

/* The slope at an end. Given: the chord there and that beside. */
static double limit_end(double chord_there, double beside, double slope) {
  if (!(chord_there * beside > 0.0))
    return slope;
  const double part = copysign(1.0, chord_there) * slope;
  return copysign(fmin(fmax(part, 0.0), STEEPEST * fabs(chord_there)), chord_there);
}

void po_spline_limit(size_t count, const double *x, const double *y, double *slope) {
  for (size_t k = 1; k + 2 < count; ++k) {
    const double before = chord(x, y, k - 1), here = chord(x, y, k), after = chord(x, y, k + 1);
    if (!(before * here > 0.0 && here * after > 0.0))
      continue;
    const double left = STEEPEST * fmin(fabs(before), fabs(here));
    const double right = STEEPEST * fmin(fabs(here), fabs(after));
    slope[k] = copysign(fmin(fmax(copysign(1.0, here) * slope[k], 0.0), left), here);
    slope[k + 1] = copysign(fmin(fmax(copysign(1.0, here) * slope[k + 1], 0.0), right), here);
  }
  const size_t last = count - 1;
  slope[0] = limit_end(chord(x, y, 0), chord(x, y, 1), slope[0]);
  slope[last] = limit_end(chord(x, y, last - 1), chord(x, y, last - 2), slope[last]);
}
