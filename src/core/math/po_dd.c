#include "po_dd.h"

#include "po_elementary.h"

static const po_dd LN_2 = {0.6931471805599453, 2.3190468138462996e-17},
                   PI = {3.141592653589793, 1.2246467991473532e-16};

/* The exponent is divided by 2^HALVINGS after a multiple of log 2 has been taken from it: what is
 * left is below 0.0055, and the term of order 12 of the series of exp(r) - 1 is below 1e-35. */
enum { HALVINGS = 6, EXP_TERMS = 12 };

po_dd po_dd_exp(po_dd exponent) {
  const double k = rint(exponent.high / LN_2.high);
  po_dd r = po_dd_subtract(exponent, po_dd_times(LN_2, k));
  r = po_dd_times(r, 1.0 / (1 << HALVINGS));
  po_dd less_1 = {0.0, 0.0}; /* r (1 + r/2 (1 + r/3 (...))) */
  for (int i = EXP_TERMS; i > 0; --i)
    less_1 = po_dd_multiply(po_dd_add(po_dd_of(1.0), less_1), po_dd_divide(r, po_dd_of((double)i)));
  for (int i = 0; i < HALVINGS; ++i) /* (1 + e)^2 - 1 */
    less_1 = po_dd_add(po_dd_times(less_1, 2.0), po_dd_multiply(less_1, less_1));
  const po_dd power = po_dd_add(po_dd_of(1.0), less_1);
  return (po_dd){ldexp(power.high, (int)k), ldexp(power.low, (int)k)};
}

/* One step of Halley's iteration from the logarithm in double precision, whose error it cubes. */
po_dd po_dd_log(po_dd x) {
  int power;
  const double fraction = frexp(x.high, &power);
  x = (po_dd){fraction, ldexp(x.low, -power)};
  const double first = po_log(fraction);
  const po_dd e = po_dd_exp(po_dd_of(first));
  const double step = 2.0 * po_dd_value(po_dd_subtract(x, e)) / po_dd_value(po_dd_add(x, e));
  return po_dd_add(po_dd_times(LN_2, (double)power), po_dd_sum(first, step));
}

po_dd po_dd_pow(po_dd x, po_dd exponent) {
  return po_dd_exp(po_dd_multiply(exponent, po_dd_log(x)));
}

/* The series of sin(t) for |t| <= pi/4. The last term has the order 27 and is below 1e-31. */
static po_dd sine(po_dd t) {
  const po_dd square = po_dd_negative(po_dd_multiply(t, t));
  po_dd term = t, sum = t;
  for (int k = 1; k < 27; k += 2) {
    term = po_dd_divide(po_dd_multiply(term, square), po_dd_of((double)(k + 1) * (k + 2)));
    sum = po_dd_add(sum, term);
  }
  return sum;
}

po_dd po_dd_sinpi(po_dd x) {
  const double whole = rint(2.0 * x.high), turn = fmod(whole, 4.0);
  const po_dd t = po_dd_multiply(
      PI, po_dd_add(po_dd_of(x.high - 0.5 * whole), po_dd_of(x.low))); /* exact difference */
  const int quadrant = (int)(turn - 4.0 * floor(0.25 * turn));
  po_dd value = sine(t);
  if (quadrant % 2 == 1) { /* cos t = 1 - 2 sin^2(t/2) */
    const po_dd half = sine(po_dd_times(t, 0.5));
    value = po_dd_subtract(po_dd_of(1.0), po_dd_times(po_dd_multiply(half, half), 2.0));
  }
  return quadrant < 2 ? value : po_dd_negative(value);
}
