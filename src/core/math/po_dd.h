/* Numbers of twice the precision: the unevaluated sum of two doubles. Unlike long double, they are
 * the same on every machine. Source: T. J. Dekker, Numer. Math. 18, 224 (1971); Y. Hida, X. S. Li,
 * D. H. Bailey, Proc. 15th IEEE Symposium on Computer Arithmetic, 155 (2001). A fused
 * multiply-add, which some processors do not have, is not used. */
#ifndef PO_DD_H
#define PO_DD_H

#include <math.h>

typedef struct {
  double high, low; /* |low| is at most half a unit in the last place of high */
} po_dd;

/* Returned: a + b exactly. */
static inline po_dd po_dd_sum(double a, double b) {
  const double s = a + b, c = s - a;
  return (po_dd){s, (a - (s - c)) + (b - c)};
}

/* As po_dd_sum. Given: |a| >= |b|, or a = 0. */
static inline po_dd po_dd_ordered_sum(double a, double b) {
  const double s = a + b;
  return (po_dd){s, b - (s - a)};
}

/* Returned: a b exactly. Given: |a| and |b| below 1e300, and the product not below 1e-290. */
static inline po_dd po_dd_product(double a, double b) {
  static const double SPLIT = 134217729.0; /* 2^27 + 1 */
  const double p = a * b, x = SPLIT * a, y = SPLIT * b;
  const double a1 = x - (x - a), b1 = y - (y - b), a2 = a - a1, b2 = b - b1;
  return (po_dd){p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

/* The arithmetic of two such numbers. Accuracy: 2^-102 of the result; of the sum, if the operands
 * have the same sign or a difference does not cancel (tests/theory/test_tables_math.c). */
static inline po_dd po_dd_of(double x) {
  return (po_dd){x, 0.0};
}

static inline po_dd po_dd_negative(po_dd x) {
  return (po_dd){-x.high, -x.low};
}

static inline po_dd po_dd_add(po_dd a, po_dd b) {
  const po_dd high = po_dd_sum(a.high, b.high), low = po_dd_sum(a.low, b.low);
  const po_dd sum = po_dd_ordered_sum(high.high, high.low + low.high);
  return po_dd_ordered_sum(sum.high, sum.low + low.low);
}

static inline po_dd po_dd_subtract(po_dd a, po_dd b) {
  return po_dd_add(a, po_dd_negative(b));
}

static inline po_dd po_dd_multiply(po_dd a, po_dd b) {
  const po_dd p = po_dd_product(a.high, b.high);
  return po_dd_ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static inline po_dd po_dd_times(po_dd a, double b) {
  return po_dd_multiply(a, po_dd_of(b));
}

static inline po_dd po_dd_divide(po_dd a, po_dd b) {
  const double q = a.high / b.high;
  const po_dd rest = po_dd_subtract(a, po_dd_times(b, q));
  const double r = rest.high / b.high;
  const po_dd last = po_dd_subtract(rest, po_dd_times(b, r));
  return po_dd_add(po_dd_ordered_sum(q, r), po_dd_of(last.high / b.high));
}

/* Given: x >= 0. */
static inline po_dd po_dd_sqrt(po_dd x) {
  const double root = sqrt(x.high);
  if (root == 0.0)
    return po_dd_of(0.0);
  const po_dd rest = po_dd_subtract(x, po_dd_product(root, root));
  return po_dd_ordered_sum(root, 0.5 * rest.high / root);
}

static inline double po_dd_value(po_dd x) {
  return x.high + x.low;
}

/* Elementary functions, for what is computed seldom or needs more digits than a double has.
 * po_dd_sinpi: of pi x. Given:
 * |exponent| <= 700 of the exponential; x > 0 for the logarithm and the power. Accuracy: 1e-29 of
 * the result; of the exponential times 1 + |exponent|; of the power times 1 + |exponent| +
 * |logarithm of the result|; of the logarithm and the sine in the vicinity of a zero absolutely
 * (tests/theory/test_tables_math.c). */
po_dd po_dd_exp(po_dd exponent);
po_dd po_dd_log(po_dd x);
po_dd po_dd_pow(po_dd x, po_dd exponent);
po_dd po_dd_sinpi(po_dd x);

#endif
