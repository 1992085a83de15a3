#include "po_elementary.h"

#include <float.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Polynomials: the Chebyshev interpolants, computed with mpmath to 60 digits and rounded to double,
 * so that the error of each function is below 2^-57 of its value. They are evaluated in pairs of
 * terms, which a processor can compute side by side. */

/* log 2 = LN_2_HIGH + LN_2_LOW to 2^-89, and k LN_2_HIGH is exact for |k| < 2^20. */
static const double LN_2_HIGH = 0.6931471804855391, LN_2_LOW = 7.440617110012397e-11,
                    PER_LN_2 = 1.4426950408889634;
/* 3/2 2^52: adding it rounds a number below 2^51 to the nearest whole number. */
static const double TO_WHOLE = 6755399441055744.0;
/* exp of more overflows; of less it is zero. */
static const double LARGEST_EXPONENT = 709.782712893384, LEAST_EXPONENT = -745.1332191019412;

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static double of_bits(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* (exp(r) - 1 - r - r^2/2)/r^3 for |r| <= log(2)/2 */
static inline double exp_tail(double r) {
  const double r2 = r * r, r4 = r2 * r2;
  return ((0.16666666666666669 + r * 0.041666666666666664) +
          r2 * (0.008333333333330062 + r * 0.0013888888888886552)) +
         r4 * (((0.00019841269863053618 + r * 2.4801587317144498e-05) +
                r2 * (2.7557268459997064e-06 + r * 2.755728296954995e-07)) +
               r4 * (2.510038549551032e-08 + r * 2.0911236630261545e-09));
}

/* exp(r) - 1 = high + low with |r| <= log(2)/2, and the number of times that log 2 was taken off
 * the exponent high + low, |high| < 1000. */
static inline po_dd reduced_exp(double high, double low, int *k) {
  const double whole = (high * PER_LN_2 + TO_WHOLE) - TO_WHOLE;
  const po_dd r = po_dd_sum(high - whole * LN_2_HIGH, low - whole * LN_2_LOW);
  *k = (int)whole;
  const double square = r.high * r.high;
  const double tail = (r.low + r.low * r.high) + square * (0.5 + r.high * exp_tail(r.high));
  return po_dd_ordered_sum(r.high, tail);
}

/* exp(high + low), |low| being small */
static inline double exp_of(double high, double low) {
  if (!(high <= LARGEST_EXPONENT && high >= LEAST_EXPONENT))
    return high > 0.0 ? INFINITY : high < 0.0 ? 0.0 : NAN;
  int k;
  const po_dd less_1 = reduced_exp(high, low, &k);
  const double power = 1.0 + less_1.high;
  if (k < -1021 || k > 1022) /* below the normal numbers or close to the largest one */
    return ldexp(power + ((1.0 - power + less_1.high) + less_1.low), k);
  return (1.0 + (less_1.high + less_1.low)) * of_bits((uint64_t)(k + 1023) << 52);
}

double po_exp(double x) {
  return exp_of(x, 0.0);
}

/* exp(x) - 1 to 2^-58 of its value. Given: |x| < 700. */
static po_dd precise_expm1(double x) {
  int k;
  const po_dd less_1 = reduced_exp(x, 0.0, &k);
  const double power = of_bits((uint64_t)(k + 1023) << 52);
  return k == 0
             ? less_1
             : po_dd_add(po_dd_sum(power, -1.0), (po_dd){power * less_1.high, power * less_1.low});
}

double po_expm1(double x) {
  if (!(fabs(x) < 40.0)) /* exp(-40) is below the rounding of 1 */
    return x < 0.0 ? -1.0 : exp_of(x, 0.0);
  return x == 0.0 ? x : precise_expm1(x).high;
}

/* exp(|x|)/2, for x so large that exp(-|x|) does not matter */
static const double LARGE = 40.0;
static double half_exp(double x) {
  const po_dd exponent = po_dd_sum(fabs(x), -LN_2_HIGH);
  return exp_of(exponent.high, exponent.low - LN_2_LOW);
}

/* With e = exp(|x|) - 1: 2 sinh(|x|) = e + e/(1 + e), 2 cosh(x) = 1 + e + 1/(1 + e). */
double po_sinh(double x) {
  if (!(fabs(x) < LARGE))
    return isnan(x) ? x : copysign(half_exp(x), x);
  const po_dd e = precise_expm1(fabs(x)), power = po_dd_add(po_dd_of(1.0), e);
  return copysign(0.5 * po_dd_add(e, po_dd_divide(e, power)).high, x);
}

double po_cosh(double x) {
  if (!(fabs(x) < LARGE))
    return isnan(x) ? x : half_exp(x);
  const po_dd power = po_dd_add(po_dd_of(1.0), precise_expm1(fabs(x)));
  return 0.5 * po_dd_add(power, po_dd_divide(po_dd_of(1.0), power)).high;
}

/* x = 2^k m with m from sqrt(1/2) to sqrt(2). Given: 0 < x < INFINITY. */
static inline double fraction_of(double x, int *k) {
  int shift = 0;
  if (x < DBL_MIN) {
    x *= 0x1p54;
    shift = -54;
  }
  const uint64_t bits = bits_of(x) - 0x3fe6a09e667f3bcdu; /* sqrt(1/2) */
  *k = (int)((int64_t)bits >> 52) + shift;
  return of_bits((bits & 0x000fffffffffffffu) + 0x3fe6a09e667f3bcdu);
}

static double log_outside(double x) {
  return x == 0.0 ? -INFINITY : x > 0.0 ? x : NAN;
}

/* With s = f/(2 + f), log(1 + f) = 2 artanh(s) = f - f^2/2 + s (f^2/2 + s^2 R(s^2)). */
double po_log(double x) {
  if (!(x > 0.0 && x < INFINITY))
    return log_outside(x);
  int power;
  const double f = fraction_of(x, &power) - 1.0, k = power;
  const double s = f / (2.0 + f), half = 0.5 * f * f, z = s * s, z2 = z * z;
  const double R =
      (0.666666666666667 + z * 0.39999999999899444) +
      z2 * ((0.2857142862600327 + z * 0.22222211130259878) +
            z2 * ((0.18182889455674947 + z * 0.15331710618210773) + z2 * 0.14616585424888623));
  return k * LN_2_HIGH - ((half - (s * (half + z * R) + k * LN_2_LOW)) - f);
}

/* For each 64th of the range of m: 128/c, c a number close to all m, and log c, computed with
 * mpmath, whose first part is a multiple of 2^-42. */
static const struct {
  double inverse, high, low;
} CENTRE[] = {
    {180, -0.34092658697068146, 8.82452633212564e-14},
    {178, -0.32975328637257917, 1.1118671389559323e-13},
    {176, -0.31845373111855224, 1.7625431312172662e-14},
    {174, -0.30702503529482783, -8.403156304792425e-14},
    {172, -0.2954642128938758, 3.993416384387844e-14},
    {171, -0.28963329258294834, -9.43339818951269e-14},
    {169, -0.27786845100354185, 8.554360006566322e-14},
    {167, -0.2659635484972114, 7.343591369867797e-14},
    {165, -0.25391520998095984, -3.600176732637335e-15},
    {164, -0.2478361639045943, 1.3029797173308663e-14},
    {162, -0.23556607131286, 9.30945949519689e-14},
    {161, -0.22937410106487732, 3.149265065191484e-14},
    {159, -0.21687393830052315, -9.120937249914984e-14},
    {158, -0.21056476910735, 3.6507188831790577e-16},
    {156, -0.19782574332998593, 6.604544877082384e-14},
    {155, -0.19139485299956505, -6.440856150696892e-14},
    {153, -0.17840765747291698, 9.86835038673495e-14},
    {152, -0.17185025692674571, 8.649239607212071e-14},
    {150, -0.15860503017665906, 2.0472357800461955e-14},
    {149, -0.15191604202573217, -1.0980754099855238e-13},
    {148, -0.14518200984457508, 7.718001336828099e-14},
    {146, -0.13157635778861732, -1.0195735223708473e-13},
    {145, -0.1247034785010328, 7.556920687451337e-14},
    {144, -0.11778303565643, 4.654729747598445e-14},
    {142, -0.10379679368156758, -7.598636597194141e-14},
    {141, -0.09672962645845473, -9.638067658552277e-14},
    {140, -0.08961215868976069, 7.355770219435029e-14},
    {139, -0.08244366921098845, -8.614512936087814e-14},
    {138, -0.07522342123752424, -6.329065958724544e-14},
    {137, -0.06795066190852594, 1.8195060030168815e-14},
    {135, -0.053244514518837605, 2.532168943117445e-14},
    {134, -0.0458095360313564, 6.219834199475792e-14},
    {133, -0.03831886430202758, -1.0902154302203302e-13},
    {132, -0.03077165866670839, -4.529814257790929e-14},
    {131, -0.023167059281604452, 7.007359704310036e-14},
    {130, -0.015504186535963527, -1.7274567499706107e-15},
    {129, -0.0077821404420319595, -2.298941004620351e-14},
    {128, 0.0, 0.0},
    {126, 0.01574835696806076, 7.840703382506278e-14},
    {124, 0.03174869831468641, -1.0610652735224087e-13},
    {122, 0.04800921918626955, 9.106054379130929e-14},
    {120, 0.0645385211375924, -2.1225608044809997e-14},
    {119, 0.07290677080800378, 8.399594274044337e-14},
    {117, 0.08985632912185793, 3.1218748807418837e-15},
    {115, 0.10709813555627079, 9.631011033519217e-14},
    {114, 0.11583181552509814, 2.3568822182038756e-14},
    {112, 0.13353139262449076, 3.1859736349078334e-14},
    {111, 0.14250006260726877, 1.4256439478199035e-14},
    {109, 0.16068238169054894, -7.547106028244807e-14},
    {108, 0.16989903679541385, -1.6376276414097503e-14},
    {106, 0.18859116980752333, 2.6693431578015818e-14},
    {105, 0.19806991376208316, 1.0634128304268335e-14},
    {104, 0.20763936477828793, -4.3425422595242564e-14},
    {102, 0.22705745063535687, -1.078736749871691e-14},
    {101, 0.2369097470784709, -1.1318526912023687e-13},
    {100, 0.2468600779316148, -8.899851356560444e-14},
    {99, 0.25691041378513546, -1.0822171646799124e-13},
    {98, 0.2670627852489815, 6.371947269815667e-14},
    {96, 0.28768207245184385, -6.292357389008195e-14},
    {95, 0.29815337231912054, -4.4204083338755686e-14},
    {94, 0.30873548164959175, 2.1522127491642888e-14},
    {93, 0.3194307707663029, 5.834357420090924e-14},
    {92, 0.33024168687052224, 5.4612144489920215e-14},
    {91, 0.3411707574027787, -1.156568624616423e-14},
};

/* log(x) to 2^-64 of its value: with m = c (1 + r), |r| < 2^-6, it is k log 2 + log c + r - r^2/2 +
 * r^3 P(r). The first part of m, of 21 bits, makes the products with 1/c and the square of r exact.
 * Given: 0 < x < INFINITY. */
static po_dd precise_log(double x) {
  int power;
  const double m = fraction_of(x, &power), k = power;
  const size_t i = ((bits_of(m) - 0x3fe6a09e667f3bcdu) >> 46) & 63;
  const double inverse = 0.0078125 * CENTRE[i].inverse;
  const double first = of_bits((bits_of(m) + 0x80000000u) & ~(uint64_t)0xffffffffu);
  const double r1 = first * inverse - 1.0, r2 = (m - first) * inverse;
  const po_dd r = po_dd_ordered_sum(r1, r2);
  const double z = r.high * r.high, z2 = z * z;
  const double P =
      ((0.3333333333333333 - r.high * 0.25) + z * (0.2 - r.high * 0.16666666666666666)) +
      z2 * ((0.14285714285714285 - r.high * 0.125) + z * (0.1111111111111111 - r.high * 0.1));
  const po_dd sum = po_dd_ordered_sum(k * LN_2_HIGH + CENTRE[i].high, r.high),
              all = po_dd_ordered_sum(sum.high, -0.5 * (r1 * r1));
  const double low =
      sum.low + all.low +
      ((k * LN_2_LOW + CENTRE[i].low) + (r.low - r2 * (r1 + 0.5 * r2)) + r.high * (z * P));
  return po_dd_ordered_sum(all.high, low);
}

/* Given: x > 0, not close to 1 but exactly. */
static double log_of_pair(po_dd x) {
  const po_dd whole = precise_log(x.high);
  return whole.high + (whole.low + x.low / x.high);
}

double po_log1p(double x) {
  if (!(x > -1.0 && x < INFINITY))
    return x == -1.0 ? -INFINITY : x > 0.0 ? x : NAN;
  const po_dd sum = po_dd_sum(1.0, x);
  return sum.high == 1.0 ? x : log_of_pair(sum);
}

/* log(|x| + sqrt(x^2 + 1)); of small x the series, of large x log(2 |x|) */
double po_asinh(double x) {
  static const double SMALL_ONE = 1e-5, LARGE_ONE = 1e9;
  const double a = fabs(x);
  if (!(a >= SMALL_ONE && a < INFINITY))
    return isinf(x) ? x : x - x * x * x / 6.0;
  if (a > LARGE_ONE)
    return copysign(po_log(a) + (LN_2_HIGH + LN_2_LOW), x);
  const po_dd root = po_dd_sqrt(po_dd_add(po_dd_product(a, a), po_dd_of(1.0)));
  return copysign(log_of_pair(po_dd_add(po_dd_of(a), root)), x);
}

double po_log10(double x) {
  static const po_dd PER_LN_10 = {0.4342944819032518, 1.098319650216765e-17};
  if (!(x > 0.0 && x < INFINITY))
    return log_outside(x);
  return po_dd_value(po_dd_multiply(precise_log(x), PER_LN_10));
}

/* Returned: x rounded towards zero to 26 bits, so that the product of two is exact. */
static inline double first_bits(double x) {
  return of_bits(bits_of(x) & ~(uint64_t)0x7ffffff);
}

po_base po_base_of(double x) {
  if (!(x > 0.0 && x < INFINITY))
    return (po_base){x, {log_outside(x), 0.0}};
  const po_dd logarithm = precise_log(x);
  const double first = first_bits(logarithm.high);
  return (po_base){x, {first, (logarithm.high - first) + logarithm.low}};
}

double po_power(po_base base, double exponent) {
  if (exponent == 0.0 || base.x == 1.0)
    return 1.0;
  const double product = exponent * base.logarithm.high;
  if (!(fabs(product) < 800.0)) /* too large or too small for exp */
    return exp_of(product, 0.0);
  const double first = first_bits(exponent), high = first * base.logarithm.high;
  return exp_of(high, (exponent - first) * base.logarithm.high + exponent * base.logarithm.low);
}

double po_pow(double x, double exponent) {
  return po_power(po_base_of(x), exponent);
}

/* One step of Newton's iteration in twice the precision. With x = 8^n m, 1/2 <= m < 4, nothing
 * overflows. */
double po_cbrt(double x) {
  if (x == 0.0 || !isfinite(x))
    return x;
  int power;
  double m = frexp(fabs(x), &power);
  const int rest = ((power % 3) + 3) % 3, third = (power - rest) / 3;
  m = ldexp(m, rest);
  const double y = po_exp(po_log(m) / 3.0);
  const po_dd cube = po_dd_times(po_dd_product(y, y), y);
  const double root = y - po_dd_value(po_dd_subtract(cube, po_dd_of(m))) / (3.0 * y * y);
  return copysign(ldexp(root, third), x);
}

double po_hypot(double x, double y) {
  if (isinf(x) || isinf(y))
    return INFINITY;
  int power;
  const double large = fmax(fabs(x), fabs(y)); /* NaN only if both are */
  if (isnan(x) || isnan(y) || large == 0.0)
    return x + y == 0.0 ? 0.0 : x + y;
  frexp(large, &power);
  const double a = ldexp(x, -power), b = ldexp(y, -power);
  const po_dd root = po_dd_sqrt(po_dd_add(po_dd_product(a, a), po_dd_product(b, b)));
  return ldexp(root.high, power);
}
