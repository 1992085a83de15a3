#include "po_profile_thin.h"

#include <math.h>

#include "po_hermite.h"

/* The difference of the slopes, relative to the greatest slope so far. */
static const double THIN = 1e-7;

/* The difference between the slope of the cubic from row i to row j and that of the spline. */
static double difference(const po_profile_table *t, size_t i, size_t j, size_t k, double at) {
  return po_hermite_rate(t->gap[i], t->slope[i], t->gap[j], t->slope[j], at - t->r[i],
                         t->r[j] - t->r[i]) -
         po_hermite_rate(t->gap[k], t->slope[k], t->gap[k + 1], t->slope[k + 1], at - t->r[k],
                         t->r[k + 1] - t->r[k]);
}

/* Whether one cubic stands for the intervals from row i to row j. In each the difference is a
 * parabola, bounded by its three Bezier points. Given: the greatest slope up to row i. */
static bool is_one_cubic(const po_profile_table *t, size_t i, size_t j, double steepest) {
  for (size_t k = i; k < j; ++k) {
    const double begin = difference(t, i, j, k, t->r[k]), end = difference(t, i, j, k, t->r[k + 1]),
                 middle = difference(t, i, j, k, 0.5 * (t->r[k] + t->r[k + 1]));
    const double bound =
        fmax(fmax(fabs(begin), fabs(end)), fabs(2.0 * middle - 0.5 * (begin + end)));
    steepest = fmax(steepest, fabs(t->slope[k + 1]));
    if (!(bound <= THIN * fmax(steepest, 1.0 / t->r[k + 1])))
      return false;
  }
  return true;
}

size_t po_profile_thin(const po_profile_table *t, size_t *kept) {
  const size_t last = t->rows - 1;
  double steepest = fabs(t->slope[0]);
  size_t count = 0;
  for (size_t i = 0; i < last;) {
    size_t step = 1;
    kept[count++] = i;
    while (i + 2 * step <= last && is_one_cubic(t, i, i + 2 * step, steepest))
      step *= 2;
    for (size_t k = i; k < i + step; ++k)
      steepest = fmax(steepest, fabs(t->slope[k + 1]));
    i += step;
  }
  kept[count++] = last;
  return count;
}
