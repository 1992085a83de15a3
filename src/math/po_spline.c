#include "po_spline.h"

#include <math.h>
#include <stdlib.h>

#include "po_memory.h"

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
