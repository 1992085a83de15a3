#include "po_special.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "po_dd.h"
#include "po_elementary.h"

/* B_2k/(2k (2k - 1)) of Stirling's series, k = 1, 2, ... From x = 30 on, the first term that is
 * left out is below 1e-24. */
static const po_dd STIRLING[] = {{0.08333333333333333, 4.625929269271485e-18},
                                 {-0.002777777777777778, 1.0601087908747154e-19},
                                 {0.0007936507936507937, 6.883823317368282e-22},
                                 {-0.0005952380952380953, 5.36938218754726e-20},
                                 {0.0008417508417508417, 3.6870174889237694e-20},
                                 {-0.0019175269175269176, 1.0675702776872475e-19},
                                 {0.00641025641025641, 2.2240044563805217e-19},
                                 {-0.029550653594771242, 4.861760957508855e-19}};
enum { STIRLING_TERMS = sizeof STIRLING / sizeof *STIRLING };
static const double STIRLING_BEGIN = 30.0;
static const po_dd HALF_LOG_2_PI = {0.9189385332046728, -3.8782941580672414e-17};

/* log Gamma(x), x > 0; smaller x by Gamma(x) = Gamma(x + n)/(x (x + 1) ... (x + n - 1)). */
static po_dd log_gamma(po_dd x) {
  po_dd product = {1.0, 0.0};
  for (; x.high < STIRLING_BEGIN; x = po_dd_add(x, po_dd_of(1.0)))
    product = po_dd_multiply(product, x);
  const po_dd inverse = po_dd_divide(po_dd_of(1.0), x), square = po_dd_multiply(inverse, inverse);
  po_dd sum = {0.0, 0.0};
  for (int k = STIRLING_TERMS; k-- > 0;)
    sum = po_dd_add(STIRLING[k], po_dd_multiply(square, sum));
  sum = po_dd_add(po_dd_multiply(sum, inverse), HALF_LOG_2_PI);
  const po_dd half_less = po_dd_subtract(x, po_dd_of(0.5));
  sum = po_dd_add(sum, po_dd_subtract(po_dd_multiply(half_less, po_dd_log(x)), x));
  return product.high == 1.0 ? sum : po_dd_subtract(sum, po_dd_log(product));
}

/* The largest x whose Gamma function is finite, and the range of po_dd_exp. */
static const double LARGEST_GAMMA = 171.62437695630272, LARGEST_EXPONENT = 700.0;

static double exp_of(po_dd exponent) {
  return fabs(exponent.high) <= LARGEST_EXPONENT ? po_dd_value(po_dd_exp(exponent))
                                                 : po_exp(exponent.high) * (1.0 + exponent.low);
}

double po_gamma(double x) {
  if (!(x > 0.0))
    return NAN;
  return x > LARGEST_GAMMA ? INFINITY : x < DBL_MIN ? 1.0 / x : exp_of(log_gamma(po_dd_of(x)));
}

double po_beta(double a, double b) {
  if (!(a > 0.0 && b > 0.0))
    return NAN;
  const po_dd both = po_dd_add(log_gamma(po_dd_of(a)), log_gamma(po_dd_of(b)));
  return exp_of(po_dd_subtract(both, log_gamma(po_dd_sum(a, b))));
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

/* Up to this x the power series is used as a Chebyshev series, beyond it an integral. */
static const double SERIES_END = 9.0;

enum { PHASE_TERMS = 14, SERIES_TERMS = 18 };

/* Chebyshev series, the coefficients computed with mpmath to 50 digits; the terms that are left out
 * are below 1e-18. Of H_n(x) (9/x)^(n + 1), n = 0 and 1, in (x/9)^2 from 0 to 1: */
static const double SERIES[][SERIES_TERMS] = {
    {1.0599974340575419186, -1.5792556182102753115, 1.5792321991042712592, -1.0432273399312089408,
     0.37359622305073912671, -0.081128330584850368829, 0.011803494718460843209,
     -0.0012336644348618280963, 9.7324420918452520281e-5, -6.0111855952652287779e-6,
     2.9893902124254971274e-7, -1.2238017548966560628e-8, 4.1989928378531349413e-10,
     -1.2255700868425316907e-11, 3.0812074768205888664e-13, -6.7441816316476597763e-15,
     1.2970843672434443053e-16, -2.20970429712628703e-18},
    {4.4653909735074264084, -6.5009085358836738883, 4.0781523235874503058, -1.6483101379309434471,
     0.41667583490819168324, -0.070130457324257579401, 0.0083677241650608470971,
     -7.4376637236442406473e-4, 5.1163740628667965442e-5, -2.806040888082106791e-6,
     1.2563159418554330561e-7, -4.6807009023078720301e-9, 1.4744147918713969771e-10,
     -3.9793511377879364719e-12, 9.3071538035351021702e-14, -1.9049376026860279626e-15,
     3.4411388734168444943e-17, -5.5275279040835854853e-19},
};
/* and, in (9/x)^2 from 0 to 1, of P_n and of Q_n x/9, with which Y_n is
 * sqrt(2/(pi x)) (P_n sin u + Q_n cos u), u = x - (2 n + 1) pi/4 (Abramowitz and Stegun 9.2.6). */
static const double IN_PHASE[][PHASE_TERMS] = {
    {0.99957207827708736024, -4.2593413919883444368e-4, 1.9600039314717762956e-6,
     -2.6849254882821837995e-8, 7.0046936070615510656e-10, -2.8349833841965117061e-11,
     1.5838038650345242756e-12, -1.1340432899092933487e-13, 9.8953485176080375155e-15,
     -1.0150283324779488331e-15, 1.1918088008680217042e-16, -1.569661318468590274e-17,
     2.2824481396367568003e-18, -3.6184014609393710349e-19},
    {1.0007154988259476306, 7.12928703063408807e-4, -2.5372711907062929652e-6,
     3.2015750416084947222e-8, -8.023518535789913009e-10, 3.1711691175122377431e-11,
     -1.7441244216740708505e-12, 1.2350627432398671424e-13, -1.0687868789592113218e-14,
     1.0892817035950940787e-15, -1.2724062554949928232e-16, 1.6687170662512818697e-17,
     -2.4178736273492479642e-18, 3.8214998290574270534e-19},
};
static const double IN_QUADRATURE[][PHASE_TERMS] = {
    {-0.01383999757848260099, 4.8458775287233340276e-5, -4.2382487993548424587e-7,
     8.4124874906630765929e-9, -2.8293547883950049927e-10, 1.3838514848538997517e-11,
     -8.9719313035739754909e-13, 7.2534024555784835332e-14, -7.0073326523411641748e-15,
     7.842798536913645724e-16, -9.9357961337242692631e-17, 1.3994866965460472609e-17,
     -2.1609343381056790123e-18, 3.6166193093617214642e-19},
    {0.041597986323535096187, -6.8148650487273258764e-5, 5.2156426077290473137e-7,
     -9.7924595528894151951e-9, 3.195215368353170089e-10, -1.5334041088160138055e-11,
     9.8130769880310020837e-13, -7.8586243123051565452e-14, 7.5373850405502988344e-15,
     -8.3880853365811846594e-16, 1.0577553899654216779e-16, -1.4841728068387731932e-17,
     2.2842778918204527634e-18, -3.8124313866049001872e-19},
};

/* A Chebyshev series at y from 0 to 1, by Clenshaw's recurrence. */
static double chebyshev(size_t count, const double *coefficient, double y) {
  const double twice = 4.0 * y - 2.0;
  double sum = 0.0, last = 0.0;
  for (size_t k = count; k-- > 1;) {
    const double next = twice * sum - last + coefficient[k];
    last = sum;
    sum = next;
  }
  return 0.5 * twice * sum - last + coefficient[0];
}

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

/* H_n - Y_n, for large x. */
static double struve_less_bessel(int n, double x) {
  return 2.0 / M_PI * laplace(n, x) / (n == 0 ? x : 1.0);
}

/* Y_n(x) at large x, with the sine and cosine of x. */
static double bessel_y(int n, double x, double sine, double cosine) {
  const double from = SERIES_END / x, y = from * from;
  /* sqrt(2) times the sine and cosine of u */
  const double s = n == 0 ? sine - cosine : -sine - cosine;
  const double c = n == 0 ? sine + cosine : sine - cosine;
  return (chebyshev(PHASE_TERMS, IN_PHASE[n], y) * s +
          from * chebyshev(PHASE_TERMS, IN_QUADRATURE[n], y) * c) /
         sqrt(M_PI * x);
}

/* H_n at x <= SERIES_END. */
static double struve_series(int n, double x) {
  const double part = x / SERIES_END;
  return chebyshev(SERIES_TERMS, SERIES[n], part * part) * part * (n == 0 ? 1.0 : part);
}

double po_struve(int n, double x) {
  if (!(x >= 0.0 && (n == 0 || n == 1)))
    return NAN;
  if (x <= SERIES_END)
    return struve_series(n, x);
  return isinf(x) ? n * (2.0 / M_PI)
                  : struve_less_bessel(n, x) + bessel_y(n, x, po_sin(x), po_cos(x));
}

double po_struve_wave(int n, double distance, double wavelength) {
  const double x = 2.0 * M_PI * (distance / wavelength);
  if (!(x > SERIES_END && x < INFINITY))
    return po_struve(n, x);
  const double half_turns = 2.0 * (remainder(distance, wavelength) / wavelength);
  return struve_less_bessel(n, x) + bessel_y(n, x, po_sinpi(half_turns), po_cospi(half_turns));
}
