#include "po_root.h"

#include <float.h>
#include <math.h>

/* A limit that is not reached in practice: bisection from the widest interval of doubles, 2^1024,
 * to the narrowest, 2^-1074, takes 2098 steps. */
enum { STEPS_MAX = 2200 };

double po_root(po_function f, const void *data, double a, double b) {
  double fa = f(a, data), fb = f(b, data);
  if (fa == 0.0)
    return a;
  if (fb == 0.0)
    return b;
  if (!(fa < 0.0 ? fb > 0.0 : fa > 0.0 && fb < 0.0))
    return NAN;
  double wa = fa, wb = fb; /* the value of an end that stays is halved (Illinois) */
  for (int step = 0; step < STEPS_MAX; ++step) {
    const double width = fabs(b - a);
    if (width <= 2.0 * DBL_EPSILON * fmax(fabs(a), fabs(b)))
      break;
    double x = step % 3 == 2 ? 0.5 * (a + b) : b - wb * (b - a) / (wb - wa);
    if (!(fmin(a, b) < x && x < fmax(a, b)))
      x = 0.5 * (a + b);
    const double fx = f(x, data);
    if (fx == 0.0)
      return x;
    if ((fx > 0.0) == (fb > 0.0)) {
      b = x, fb = wb = fx;
      wa *= 0.5;
    } else {
      a = x, fa = wa = fx;
      wb *= 0.5;
    }
  }
  return fabs(fa) < fabs(fb) ? a : b;
}

/* 2^-60 of the initial bracket is below its rounding. */
enum { HALVINGS = 60 };

void po_bisect(po_side is_low, const void *data, double tolerance, double *low, double *high) {
  for (int k = 0; k < HALVINGS && (*high - *low) > tolerance * *high; ++k) {
    const double middle = 0.5 * (*low + *high);
    if (is_low(middle, data))
      *low = middle;
    else
      *high = middle;
  }
}
