#include "po_two.h"

#include "po_elementary.h"

static const po_two LN_2 = {0.6931471805599453, 2.3190468138462996e-17},
                    PI = {3.141592653589793, 1.2246467991473532e-16};

/* The exponent is divided by 2^HALVINGS after a multiple of log 2 has been taken from it: what is
 * left is below 0.0055, and the term of order 12 of the series of exp(r) - 1 is below 1e-35. */
enum { HALVINGS = 6, EXP_TERMS = 12 };

po_two po_two_exp(po_two exponent) {
  const double k = rint(exponent.high / LN_2.high);
  po_two r = po_two_subtract(exponent, po_two_times(LN_2, k));
  r = po_two_times(r, 1.0 / (1 << HALVINGS));
  po_two less_1 = {0.0, 0.0}; /* r (1 + r/2 (1 + r/3 (...))) */
  for (int i = EXP_TERMS; i > 0; --i)
    less_1 =
        po_two_multiply(po_two_add(po_two_of(1.0), less_1), po_two_divide(r, po_two_of((double)i)));
  for (int i = 0; i < HALVINGS; ++i) /* (1 + e)^2 - 1 */
    less_1 = po_two_add(po_two_times(less_1, 2.0), po_two_multiply(less_1, less_1));
  const po_two power = po_two_add(po_two_of(1.0), less_1);
  return (po_two){ldexp(power.high, (int)k), ldexp(power.low, (int)k)};
}

/* One step of Halley's iteration from the logarithm in double precision, whose error it cubes. */
po_two po_two_log(po_two x) {
  int power;
  const double fraction = frexp(x.high, &power);
  x = (po_two){fraction, ldexp(x.low, -power)};
  const double first = po_log(fraction);
  const po_two e = po_two_exp(po_two_of(first));
  const double step = 2.0 * po_two_value(po_two_subtract(x, e)) / po_two_value(po_two_add(x, e));
  return po_two_add(po_two_times(LN_2, (double)power), po_two_sum(first, step));
}

po_two po_two_pow(po_two x, po_two exponent) {
  return po_two_exp(po_two_multiply(exponent, po_two_log(x)));
}

/* The series of sin(t) for |t| <= pi/4. The last term has the order 27 and is below 1e-31. */
static po_two sine(po_two t) {
  const po_two square = po_two_negative(po_two_multiply(t, t));
  po_two term = t, sum = t;
  for (int k = 1; k < 27; k += 2) {
    term = po_two_divide(po_two_multiply(term, square), po_two_of((double)(k + 1) * (k + 2)));
    sum = po_two_add(sum, term);
  }
  return sum;
}

po_two po_two_sinpi(po_two x) {
  const double whole = rint(2.0 * x.high), turn = fmod(whole, 4.0);
  const po_two t = po_two_multiply(
      PI, po_two_add(po_two_of(x.high - 0.5 * whole), po_two_of(x.low))); /* exact difference */
  const int quadrant = (int)(turn - 4.0 * floor(0.25 * turn));
  po_two value = sine(t);
  if (quadrant % 2 == 1) { /* cos t = 1 - 2 sin^2(t/2) */
    const po_two half = sine(po_two_times(t, 0.5));
    value = po_two_subtract(po_two_of(1.0), po_two_times(po_two_multiply(half, half), 2.0));
  }
  return quadrant < 2 ? value : po_two_negative(value);
}
