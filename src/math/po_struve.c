#include "po_struve.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_special.h"

/* Above this x the integral is used instead of the power series, which is summed in twice the
 * precision, because its largest terms are 1e3 here; the Gauss-Laguerre rule is exact to rounding
 * from here on. */
static const double SERIES_END = 9.0;

/* The Gauss-Laguerre rule of 24 points, computed with mpmath to 50 digits, without the 5 points
 * whose weight is below 1e-19. For an integrand with singularities at +-i x its error is
 * exp(-sqrt(8 * 24 x)), 1e-18 at x = 9. */
static const double LAGUERRE[][2] = {
    {0.059019852181507976973, 0.14281197333478185108},
    {0.31123914619848372686, 0.25877410751742390266},
    {0.76609690554593664624, 0.25880670727286980203},
    {1.4255975908036130863, 0.18332268897777802489},
    {2.292562058632190295, 0.098166272629918892193},
    {3.3707742642089977162, 0.040732478151408646025},
    {4.6650837034671707921, 0.013226019405120156687},
    {6.1815351187367654118, 0.003369349058478303552},
    {7.9275392471721521794, 0.00067216256409354788999},
    {9.9120980150777060188, 0.00010446121465927518047},
    {12.14610271172976555, 0.000012544721977993333207},
    {14.642732289596674342, 1.1513158127372799199e-6},
    {17.417992646508978726, 7.9608129591336302572e-8},
    {20.491460082616424707, 4.0728589875499996652e-9},
    {23.887329848169733175, 1.5070082262925849164e-10},
    {27.63593717433271742, 3.9177365150584513852e-12},
    {31.776041352374723288, 6.8941810529580856858e-14},
    {36.358405801651621653, 7.8198003824594484691e-16},
    {41.451720484870767051, 5.3501888130100376029e-18},
};
enum { LAGUERRE_COUNT = sizeof LAGUERRE / sizeof *LAGUERRE };

/* The power series (Abramowitz and Stegun 12.1.3): (x/2)^(n+1) times the sum over k of (-1)^k
 * (x/2)^2k / (Gamma(k + 3/2) Gamma(k + n + 3/2)). */
static double series(int n, double x) {
  static const po_two FOUR_PER_PI = {1.2732395447351628, -7.871470670072994e-17};
  static const double ROUNDING = 1e-20;
  const po_two half = po_two_of(0.5 * x),
               square = po_two_negative(po_two_product(0.5 * x, 0.5 * x));
  po_two term = po_two_multiply(FOUR_PER_PI, half); /* the first term for n = 0 */
  for (int j = 1; j <= n; ++j)
    term = po_two_divide(po_two_multiply(term, half), po_two_of(j + 0.5));
  po_two sum = {0.0, 0.0};
  for (int k = 1; fabs(term.high) > ROUNDING * fabs(sum.high) || k * k < -square.high; ++k) {
    sum = po_two_add(sum, term);
    term = po_two_divide(po_two_multiply(term, square), po_two_of((k + 0.5) * (k + n + 0.5)));
  }
  return po_two_value(sum);
}

/* The integral of exp(-s) (1 + s^2/x^2)^(n - 1/2) over s > 0 (Abramowitz and Stegun 12.1.8), n = 0
 * or 1. */
static double laplace(int n, double x) {
  double sum = 0.0;
  for (int i = 0; i < LAGUERRE_COUNT; ++i) {
    const double s = LAGUERRE[i][0] / x, root = sqrt(1.0 + s * s);
    sum += LAGUERRE[i][1] * (n == 0 ? 1.0 / root : root);
  }
  return sum;
}

/* The order 2 by the recurrence f_2 = 2 f_1/x + 2 x/(3 pi) - f_0, whose middle term dominates, so
 * that it does not cancel. */
static double second_order(double f0, double f1, double x) {
  return 2.0 * f1 / x + 2.0 / (3.0 * M_PI) * x - f0;
}

static double integral_difference(int n, double x) {
  if (n == 0)
    return 2.0 / (M_PI * x) * laplace(0, x);
  if (n == 1)
    return 2.0 / M_PI * laplace(1, x);
  return second_order(integral_difference(0, x), integral_difference(1, x), x);
}

/* Hankel's expansion is exact to rounding from this x on: its smallest term is exp(-2x). */
static const double HANKEL_BEGIN = 25.0;

/* The sine and cosine of x, of which the caller may know the multiple of 2 pi. */
typedef struct {
  double sine, cosine;
} phase;

/* Y_n(x) for n = 0 or 1 at large x by Hankel's expansion (Abramowitz and Stegun 9.2.6). */
static double hankel(int n, double x, phase of_x) {
  double even = 0.0, odd = 0.0, term = 1.0; /* `term` is the modulus of the term of order k */
  const double order = 4.0 * n * n;
  for (int k = 0; fabs(term) > 0.25 * DBL_EPSILON; ++k) {
    *(k % 2 ? &odd : &even) += k % 4 < 2 ? term : -term;
    term *= (order - (2.0 * k + 1.0) * (2.0 * k + 1.0)) / (8.0 * (k + 1.0) * x);
  }
  /* sqrt(2) times the sine and cosine of x - pi/4 (n = 0) or x - 3 pi/4 (n = 1) */
  const double s = of_x.sine, c = of_x.cosine, sine = n == 0 ? s - c : -s - c,
               cosine = n == 0 ? s + c : s - c;
  return (even * sine + odd * cosine) / sqrt(M_PI * x);
}

static double bessel(int n, double x, phase of_x) {
  if (n == 2)
    return 2.0 * bessel(1, x, of_x) / x - bessel(0, x, of_x);
  return x >= HANKEL_BEGIN ? hankel(n, x, of_x) : po_bessel_y(n, x);
}

static double struve(int n, double x, phase of_x) {
  if (!(x >= 0.0 && n >= 0 && n <= 2))
    return NAN;
  if (x <= SERIES_END)
    return series(n, x);
  if (isinf(x))
    return n == 0 ? 0.0 : n == 1 ? 2.0 / M_PI : INFINITY;
  if (n == 2)
    return second_order(struve(0, x, of_x), struve(1, x, of_x), x);
  return integral_difference(n, x) + bessel(n, x, of_x);
}

double po_struve(int n, double x) {
  return struve(n, x, x >= HANKEL_BEGIN ? (phase){po_sin(x), po_cos(x)} : (phase){0});
}

double po_struve_wave(int n, double distance, double wavelength) {
  const double turns = distance / wavelength, x = 2.0 * M_PI * turns;
  if (!(x >= HANKEL_BEGIN))
    return struve(n, x, (phase){0});
  const double half_turns = 2.0 * (remainder(distance, wavelength) / wavelength);
  return struve(n, x, (phase){po_sinpi(half_turns), po_cospi(half_turns)});
}

double po_struve_minus_bessel(int n, double x) {
  if (!(x >= 0.0 && n >= 0 && n <= 2))
    return NAN;
  if (x == 0.0)
    return INFINITY;
  if (x <= SERIES_END)
    return series(n, x) - bessel(n, x, (phase){0});
  return integral_difference(n, x);
}
