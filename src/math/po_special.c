#include "po_special.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_two_functions.h"

/* B_2k/(2k (2k - 1)) of Stirling's series, k = 1, 2, ... From x = 30 on, the first term that is
 * left out is below 1e-24. */
static const po_two STIRLING[] = {{0.08333333333333333, 4.625929269271485e-18},
                                  {-0.002777777777777778, 1.0601087908747154e-19},
                                  {0.0007936507936507937, 6.883823317368282e-22},
                                  {-0.0005952380952380953, 5.36938218754726e-20},
                                  {0.0008417508417508417, 3.6870174889237694e-20},
                                  {-0.0019175269175269176, 1.0675702776872475e-19},
                                  {0.00641025641025641, 2.2240044563805217e-19},
                                  {-0.029550653594771242, 4.861760957508855e-19}};
enum { STIRLING_TERMS = sizeof STIRLING / sizeof *STIRLING };
static const double STIRLING_BEGIN = 30.0;
static const po_two HALF_LOG_2_PI = {0.9189385332046728, -3.8782941580672414e-17};

/* log Gamma(x), x > 0; smaller x by Gamma(x) = Gamma(x + n)/(x (x + 1) ... (x + n - 1)). */
static po_two log_gamma(po_two x) {
  po_two product = {1.0, 0.0};
  for (; x.high < STIRLING_BEGIN; x = po_two_add(x, po_two_of(1.0)))
    product = po_two_multiply(product, x);
  const po_two inverse = po_two_divide(po_two_of(1.0), x),
               square = po_two_multiply(inverse, inverse);
  po_two sum = {0.0, 0.0};
  for (int k = STIRLING_TERMS; k-- > 0;)
    sum = po_two_add(STIRLING[k], po_two_multiply(square, sum));
  sum = po_two_add(po_two_multiply(sum, inverse), HALF_LOG_2_PI);
  const po_two half_less = po_two_subtract(x, po_two_of(0.5));
  sum = po_two_add(sum, po_two_subtract(po_two_multiply(half_less, po_two_log(x)), x));
  return product.high == 1.0 ? sum : po_two_subtract(sum, po_two_log(product));
}

/* The largest x whose Gamma function is finite, and the range of po_two_exp. */
static const double LARGEST_GAMMA = 171.62437695630272, LARGEST_EXPONENT = 700.0;

static double exp_of(po_two exponent) {
  return fabs(exponent.high) <= LARGEST_EXPONENT ? po_two_value(po_two_exp(exponent))
                                                 : po_exp(exponent.high) * (1.0 + exponent.low);
}

double po_gamma(double x) {
  if (!(x > 0.0))
    return NAN;
  return x > LARGEST_GAMMA ? INFINITY : x < DBL_MIN ? 1.0 / x : exp_of(log_gamma(po_two_of(x)));
}

double po_beta(double a, double b) {
  if (!(a > 0.0 && b > 0.0))
    return NAN;
  const po_two both = po_two_add(log_gamma(po_two_of(a)), log_gamma(po_two_of(b)));
  return exp_of(po_two_subtract(both, log_gamma(po_two_sum(a, b))));
}

/* The sum of (a + b)_k/(a + 1)_k x^k over a */
static double beta_series(double a, double b, double x) {
  double term = 1.0, sum = 0.0;
  for (double k = 0.0; term > 0.25 * DBL_EPSILON * sum; ++k) {
    sum += term;
    term *= x * (a + b + k) / (a + 1.0 + k);
  }
  return sum / a;
}

double po_beta_incomplete(double a, double b, double x) {
  if (!(x >= 0.0 && x <= 1.0 && a > 0.0 && b > 0.0))
    return NAN;
  if (x == 0.0 || x == 1.0)
    return x == 0.0 ? 0.0 : po_beta(a, b);
  const double factor = po_pow(x, a) * po_exp(b * po_log1p(-x)); /* x^a (1 - x)^b */
  return x <= (a + 1.0) / (a + b + 2.0) ? factor * beta_series(a, b, x)
                                        : po_beta(a, b) - factor * beta_series(b, a, 1.0 - x);
}

/* Hankel's expansion is exact to rounding from this x on: its smallest term is exp(-2x). */
static const double I0_HANKEL_BEGIN = 22.0;

double po_bessel_i0_scaled(double x) {
  x = fabs(x);
  double term = 1.0, sum = 0.0;
  if (!(x < I0_HANKEL_BEGIN)) {
    for (double k = 1.0; term > 0.25 * DBL_EPSILON * sum; ++k) {
      sum += term;
      term *= (2.0 * k - 1.0) * (2.0 * k - 1.0) / (8.0 * k * x);
    }
    return isnan(x) ? x : sum / sqrt(2.0 * M_PI * x);
  }
  const double square = 0.25 * x * x;
  for (double k = 1.0; term > 0.25 * DBL_EPSILON * sum; ++k) {
    sum += term;
    term *= square / (k * k);
  }
  return po_exp(-x) * sum;
}
