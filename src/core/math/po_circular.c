/* Sines, cosines and angles of po_elementary.h. */
#include <stdint.h>

#include "po_elementary.h"
#include "po_widths.h"

/* 3/2 2^52: adding it rounds a number below FEW = 2^51 to the nearest whole number. */
static const double TO_WHOLE = 6755399441055744.0, FEW = 0x1p51;

/* sin(t + low) and cos(t + low) for |t| <= pi/4 */
static inline double sin_of(po_dd t) {
  const double z = t.high * t.high, z2 = z * z;
  const double S =
      ((-0.16666666666666666 + z * 0.008333333333333331) +
       z2 * (-0.00019841269841265063 + z * 2.7557319219337312e-06)) +
      z2 * z2 *
          ((-2.5052106231802837e-08 + z * 1.6058531516797758e-10) + z2 * -7.586691094197958e-13);
  return t.high + (t.high * (z * S) + t.low * (1.0 - 0.5 * z));
}

static inline double cos_of(po_dd t) {
  const double z = t.high * t.high, z2 = z * z, half = 0.5 * z, whole = 1.0 - half;
  const double C =
      ((0.041666666666666664 + z * -0.0013888888888888887) +
       z2 * (2.4801587301584645e-05 + z * -2.755731922140179e-07)) +
      z2 * z2 *
          ((2.0876755790721963e-09 + z * -1.1470460830795304e-11) + z2 * 4.7458685530816656e-14);
  return whole + (((1.0 - whole) - half) + (z2 * C - t.high * t.low));
}

/* sin(t + quadrant pi/2) */
static inline double sin_in_quadrant(po_dd t, int64_t quadrant) {
  const double value = quadrant & 1 ? cos_of(t) : sin_of(t);
  return quadrant & 2 ? -value : value;
}

/* pi/2 in parts of 33 bits, of which a multiple below 2^20 is exact, and the rest */
static const double QUARTER[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21,
                                 8.4784276603689e-32};
static const double PER_QUARTER = 0.6366197723675814, FEW_QUARTERS = 0x1p20;

/* SCALE/(2 pi) in parts of double precision, computed with mpmath to 500 digits. The factor keeps
 * the last parts above the smallest double. */
static const double SCALE = 0x1p200;
static const double PER_TURN[] = {
    2.557521329862412e+59,   -1.5811207105011377e+43,  -8.614341926039731e+26,
    64707891327.57948,       -1.253633906566786e-06,   2.279452809062167e-23,
    -1.2593422864080042e-39, -3.0662364721772555e-56,  1.0252352120156718e-72,
    -9.292613327435653e-90,  -3.1684616228373614e-106, 2.1750423337512702e-122,
    5.014572660437609e-139,  -5.3943702290524304e-157, -1.699764610862518e-173,
    4.4083931971523214e-190, 1.891441371248264e-207,   -8.66819313595062e-224,
    -7.536645368197566e-241, -4.401670495793663e-258,  -2.332896904867989e-274,
    3.195228745614716e-292,  -2.112225852076927e-308};
enum { PARTS = sizeof PER_TURN / sizeof *PER_TURN };

/* The rest t of x less a multiple of pi/2, for large x (M. H. Payne, R. N. Hanek, ACM SIGNUM
 * Newsletter 18, 19 (1983)): the products of x and the parts of 1/(2 pi) are exact, and their whole
 * parts do not count. */
static po_dd rest_of_large(double x, int64_t *quadrant) {
  static const double NEGLIGIBLE = 0x1p-120;
  static const po_dd TURN = {6.283185307179586, 2.4492935982947064e-16};
  po_dd part = {0.0, 0.0}, turns = {1.0, 0.0};
  for (int i = 0; i < PARTS && fabs(turns.high) > NEGLIGIBLE; ++i) {
    turns = po_dd_product(x / SCALE, PER_TURN[i]);
    part = po_dd_add(part, po_dd_sum(turns.high - rint(turns.high), turns.low - rint(turns.low)));
    part = po_dd_add(part, po_dd_of(-rint(part.high)));
  }
  const double quarters = rint(4.0 * part.high);
  *quadrant = (int64_t)quarters;
  return po_dd_multiply(TURN, po_dd_add(part, po_dd_of(-0.25 * quarters)));
}

static inline po_dd rest_of(double x, int64_t *quadrant) {
  const double quarters = (x * PER_QUARTER + TO_WHOLE) - TO_WHOLE;
  if (!(fabs(quarters) < FEW_QUARTERS))
    return rest_of_large(x, quadrant);
  *quadrant = (int64_t)quarters;
  const po_dd first = po_dd_sum(x - quarters * QUARTER[0], -quarters * QUARTER[1]);
  const po_dd second = po_dd_sum(first.high, -quarters * QUARTER[2]);
  return po_dd_ordered_sum(second.high, first.low + second.low - quarters * QUARTER[3]);
}

/* pi x less a multiple of pi/2. pi has a part of 26 bits and the rest. */
static inline po_dd rest_of_half_turns(double x, int64_t *quadrant) {
  static const double PI_HIGH = 3.1415926218032837, PI_LOW = 3.178650954705639e-08;
  x = fabs(x) < FEW ? x - 2.0 * ((0.5 * x + TO_WHOLE) - TO_WHOLE) : fmod(x, 2.0);
  const double quarters = (2.0 * x + TO_WHOLE) - TO_WHOLE, part = x - 0.5 * quarters,
               high = (double)(float)part;
  *quadrant = (int64_t)quarters;
  return po_dd_ordered_sum(high * PI_HIGH, high * PI_LOW + (part - high) * (PI_HIGH + PI_LOW));
}

/* The sine of x, a quarter of a turn farther for the cosine. Given: rest, one of the functions
 * above. */
PO_INLINE double sine(double x, po_dd (*rest)(double x, int64_t *quadrant), int64_t farther) {
  int64_t quadrant;
  if (!isfinite(x))
    return NAN;
  const po_dd t = rest(x, &quadrant);
  return sin_in_quadrant(t, quadrant + farther);
}

double po_sin(double x) {
  return x == 0.0 ? x : sine(x, rest_of, 0);
}

double po_cos(double x) {
  return sine(x, rest_of, 1);
}

double po_sinpi(double x) {
  return sine(x, rest_of_half_turns, 0);
}

double po_cospi(double x) {
  return sine(x, rest_of_half_turns, 1);
}

/* atan(k/8) */
static const po_dd ARCTANGENT[] = {{0.0, 0.0},
                                   {0.12435499454676144, -3.1253241424539383e-18},
                                   {0.24497866312686414, 1.0698755618734451e-17},
                                   {0.35877067027057225, -2.4623815582638635e-17},
                                   {0.4636476090008061, 2.2698777452961687e-17},
                                   {0.5585993153435624, -5.4556305485916264e-18},
                                   {0.6435011087932844, 1.5834785051444286e-17},
                                   {0.7188299996216245, -2.1478388444456983e-17},
                                   {0.7853981633974483, 3.061616997868383e-17}};
static const po_dd PI = {3.141592653589793, 1.2246467991473532e-16},
                   HALF_PI = {1.5707963267948966, 6.123233995736766e-17};

/* The angle of (x, y), 0 <= y <= x, x > 0: atan(k/8) and the series of what is left, whose tangent
 * is at most 1/16. */
static po_dd first_octant(double y, double x) {
  const double k = rint(8.0 * (y / x)), c = 0.125 * k;
  const po_dd t = po_dd_divide(po_dd_add(po_dd_of(y), po_dd_product(-c, x)),
                               po_dd_add(po_dd_of(x), po_dd_product(c, y)));
  const double z = t.high * t.high;
  double series = 0.0;
  for (int n = 15; n > 1; n -= 2)
    series = z * ((n % 4 == 1 ? 1.0 : -1.0) / n + series);
  return po_dd_add(ARCTANGENT[(int)k], po_dd_add(t, po_dd_of(t.high * series)));
}

double po_atan2(double y, double x) {
  double a = fabs(x), b = fabs(y);
  if (isnan(x) || isnan(y))
    return NAN;
  if (isinf(a) && isinf(b))
    a = b = 1.0;
  int power;
  frexp(fmax(a, b), &power); /* so that no product overflows or underflows */
  a = isinf(a) ? 1.0 : isinf(b) ? 0.0 : ldexp(a, -power);
  b = isinf(b) ? 1.0 : isinf(x) ? 0.0 : ldexp(b, -power);
  po_dd angle = {0.0, 0.0};
  if (b > a)
    angle = po_dd_subtract(HALF_PI, first_octant(a, b));
  else if (a > 0.0)
    angle = b < 0x1p-500 ? po_dd_of(b / a) : first_octant(b, a);
  if (signbit(x))
    angle = po_dd_subtract(PI, angle);
  return copysign(angle.high, y);
}
