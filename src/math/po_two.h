/* Numbers of twice the precision: the unevaluated sum of two doubles. Unlike long double, they are
 * the same on every machine. Source: T. J. Dekker, Numer. Math. 18, 224 (1971); Y. Hida, X. S. Li,
 * D. H. Bailey, Proc. 15th IEEE Symposium on Computer Arithmetic, 155 (2001). A fused
 * multiply-add, which some processors do not have, is not used. */
#ifndef PO_TWO_H
#define PO_TWO_H

#include <math.h>

typedef struct {
  double high, low; /* |low| is at most half a unit in the last place of high */
} po_two;

/* Returned: a + b exactly. */
static inline po_two po_two_sum(double a, double b) {
  const double s = a + b, c = s - a;
  return (po_two){s, (a - (s - c)) + (b - c)};
}

/* As po_two_sum. Given: |a| >= |b|, or a = 0. */
static inline po_two po_two_ordered_sum(double a, double b) {
  const double s = a + b;
  return (po_two){s, b - (s - a)};
}

/* Returned: a b exactly. Given: |a| and |b| below 1e300, and the product not below 1e-290. */
static inline po_two po_two_product(double a, double b) {
  static const double SPLIT = 134217729.0; /* 2^27 + 1 */
  const double p = a * b, x = SPLIT * a, y = SPLIT * b;
  const double a1 = x - (x - a), b1 = y - (y - b), a2 = a - a1, b2 = b - b1;
  return (po_two){p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

/* The arithmetic of two such numbers. Accuracy: 2^-102 of the result; of the sum, if the operands
 * have the same sign or a difference does not cancel (tests/theory/test_tables_math.c). */
static inline po_two po_two_of(double x) {
  return (po_two){x, 0.0};
}

static inline po_two po_two_negative(po_two x) {
  return (po_two){-x.high, -x.low};
}

static inline po_two po_two_add(po_two a, po_two b) {
  const po_two high = po_two_sum(a.high, b.high), low = po_two_sum(a.low, b.low);
  const po_two sum = po_two_ordered_sum(high.high, high.low + low.high);
  return po_two_ordered_sum(sum.high, sum.low + low.low);
}

static inline po_two po_two_subtract(po_two a, po_two b) {
  return po_two_add(a, po_two_negative(b));
}

static inline po_two po_two_multiply(po_two a, po_two b) {
  const po_two p = po_two_product(a.high, b.high);
  return po_two_ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static inline po_two po_two_times(po_two a, double b) {
  return po_two_multiply(a, po_two_of(b));
}

static inline po_two po_two_divide(po_two a, po_two b) {
  const double q = a.high / b.high;
  const po_two rest = po_two_subtract(a, po_two_times(b, q));
  const double r = rest.high / b.high;
  const po_two last = po_two_subtract(rest, po_two_times(b, r));
  return po_two_add(po_two_ordered_sum(q, r), po_two_of(last.high / b.high));
}

/* Given: x >= 0. */
static inline po_two po_two_sqrt(po_two x) {
  const double root = sqrt(x.high);
  if (root == 0.0)
    return po_two_of(0.0);
  const po_two rest = po_two_subtract(x, po_two_product(root, root));
  return po_two_ordered_sum(root, 0.5 * rest.high / root);
}

static inline double po_two_value(po_two x) {
  return x.high + x.low;
}

/* Elementary functions, for what is computed seldom or needs more digits than a double has.
 * po_two_sinpi: of pi x. Given:
 * |exponent| <= 700 of the exponential; x > 0 for the logarithm and the power. Accuracy: 1e-29 of
 * the result; of the exponential times 1 + |exponent|; of the power times 1 + |exponent| +
 * |logarithm of the result|; of the logarithm and the sine in the vicinity of a zero absolutely
 * (tests/theory/test_tables_math.c). */
po_two po_two_exp(po_two exponent);
po_two po_two_log(po_two x);
po_two po_two_pow(po_two x, po_two exponent);
po_two po_two_sinpi(po_two x);

#endif
