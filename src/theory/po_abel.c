#include "po_abel.h"

#include <math.h>

#include "po_abel_parts.h"
#include "po_elementary.h"
#include "po_profile_kind.h"
#include "po_special.h"
#include "po_struve.h"

static const po_abel ZERO = {0.0, 0.0, 0.0};

/* The table of the profile; NULL: it is none. */
static const po_profile_table *table_of(const po_scene *scene) {
  return scene->profile.kind == &PO_TABLE ? scene->profile.table : NULL;
}

/* The integral of sin^(n - 1) from 0 to pi/2, n > 0: B(n/2, 1/2)/2. */
static double wallis(double n) {
  static _Thread_local double of,
      value; /* the last one: a search asks for one thousands of times */
  if (n != of) {
    value = 0.5 * po_beta(0.5 * n, 0.5);
    of = n;
  }
  return value;
}

/* C r^n: g = kappa C x^n, kappa = n times wallis(n). */
static po_abel of_power(double factor, double n, double x) {
  const double slope = n * wallis(n) * factor * po_pow(x, n - 1.0);
  return (po_abel){slope * x, n * slope, n / (n + 1.0) * slope * x * x};
}

static po_abel sphere(const po_scene *scene, double x) {
  const double slope = x / scene->radius;
  return (po_abel){slope * x, 2.0 * slope, 2.0 / 3.0 * slope * x * x};
}

static po_abel power(const po_scene *scene, double x) {
  const double *of = scene->profile.parameter;
  return of_power(of[PO_POWER_C], of[PO_POWER_N], x);
}

static po_abel cone(const po_scene *scene, double x) {
  return of_power(scene->profile.parameter[PO_CONE_T], 1.0, x);
}

/* t - atan(t), which cancels for small t: there the series t^3/3 - t^5/5 + ... */
static double less_arctangent(double t) {
  static const double SERIES = 0.5, ROUNDING = 1e-17;
  if (t > SERIES)
    return t - po_atan2(t, 1.0);
  double sum = 0.0, power_of_t = t * t * t, term = power_of_t / 3.0;
  for (int k = 3; fabs(term) > ROUNDING * sum; k += 2) {
    sum += term;
    power_of_t *= -t * t;
    term = power_of_t / (k + 2);
  }
  return sum;
}

/* (r - b)^2/(2R) beyond b: g = (x/R) [s - b arccos(b/x)], s = sqrt(x^2 - b^2), here in t = s/b. */
static po_abel punch(const po_scene *scene, double x) {
  const double b = scene->profile.parameter[PO_PUNCH_B], R = scene->profile.parameter[PO_PUNCH_R];
  if (!(x > b))
    return ZERO;
  const double t = sqrt((x - b) * (x + b)) / b, q = less_arctangent(t);
  return (po_abel){b * x / R * q, b / R * (t + q),
                   b * b * b / R * (t * t * t / 6.0 + 0.5 * (1.0 + t * t) * q)};
}

/* (r^2 - b^2)/(2R) beyond b: g = x s/R. */
static po_abel truncated(const po_scene *scene, double x) {
  const double b = scene->profile.parameter[PO_TRUNCATED_B],
               R = scene->profile.parameter[PO_TRUNCATED_R];
  if (!(x > b))
    return ZERO;
  const double s = sqrt((x - b) * (x + b));
  return (po_abel){x * s / R, (s + x * (x / s)) / R, s * (2.0 * x * x + b * b) / (3.0 * R)};
}

static po_abel table(const po_scene *scene, double x) {
  return po_abel_of_table(scene->profile.table, x);
}

static const struct {
  const po_profile_kind *kind;
  po_abel (*at)(const po_scene *scene, double x);
} FORMS[] = {{&PO_SPHERE, sphere}, {&PO_POWER, power},         {&PO_CONE, cone},
             {&PO_PUNCH, punch},   {&PO_TRUNCATED, truncated}, {&PO_TABLE, table}};

po_abel po_abel_of_profile(const po_scene *scene, double x) {
  const po_profile_kind *kind = scene->profile.kind ? scene->profile.kind : &PO_SPHERE;
  for (size_t k = 0; k < sizeof FORMS / sizeof *FORMS; ++k)
    if (FORMS[k].kind == kind)
      return FORMS[k].at(scene, x);
  return (po_abel){NAN, NAN, NAN};
}

/* A (1 - cos(k r)): g = (pi/2) A y H0(y), y = k x; H0' = 2/pi - H1, and the integral of y H0 is y
 * H1 (Abramowitz and Stegun, Sec. 12.1). */
static po_abel of_wave(po_wave wave, double x) {
  const double k = 2.0 * M_PI / wave.length, y = k * x, factor = M_PI_2 * wave.amplitude;
  const double h0 = po_struve_wave(0, x, wave.length), h1 = po_struve_wave(1, x, wave.length);
  return (po_abel){factor * y * h0, factor * k * (h0 + y * (M_2_PI - h1)),
                   factor * x * (y * h0 - h1)};
}

po_abel po_abel_at(const po_scene *scene, double x) {
  po_abel sum = po_abel_of_profile(scene, x);
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_abel wave = of_wave(po_scene_wave(scene, k), x);
    sum.g += wave.g;
    sum.rate += wave.rate;
    sum.press += wave.press;
  }
  return sum;
}

double po_abel_fall(const po_scene *scene) {
  const po_profile_table *t = table_of(scene);
  return t ? -po_abel_table_least_rate(t) : 0.0;
}

double po_abel_greatest_drop(const po_scene *scene, double low, double high) {
  const po_profile_table *t = table_of(scene);
  return t && !po_scene_is_wavy(scene) ? po_abel_table_greatest_drop(t, high, high - low)
                                       : INFINITY;
}

double po_abel_greatest_rate(const po_scene *scene, double x) {
  const po_profile_table *t = table_of(scene);
  double sum = t ? po_abel_table_greatest_rate(t, x) : po_abel_of_profile(scene, x).rate;
  if (x > po_profile_kink(&scene->profile))
    sum = INFINITY; /* the rate may fall beyond a kink */
  /* H0(y) + y (2/pi - H1(y)) <= (4/pi) y: its series begins so, and the largest ratio at 2e6 points
   * up to y = 3000 is that at 0 */
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double per_length = 2.0 * M_PI / wave.length;
    sum += 2.0 * wave.amplitude * per_length * per_length * x;
  }
  return sum;
}

/* y H0(y) >= -sqrt(2y/pi) for all y >= 0; the smallest ratio at 2e6 points up to y = 3000 is
 * -0.9998. y H0 - H1 >= -sqrt(2y/pi) (1 + 1.5/y^2.5) (po_guduru.c); it is positive below the first
 * zero, y = 3.63. Both bounds fall beyond that zero. |H0 + y (2/pi - H1)| <= sqrt(2y/pi) + 0.22:
 * the largest difference at these points is 0.2137. */
static const double FIRST_ZERO = 3.6, BOUND = 1.5, RATE_BOUND = 0.22;

/* What g of a wave loses at most from the lower end of an interval that is shorter than the wave;
 * INFINITY for others, for which the first bounds are better. */
static double greatest_loss(po_wave wave, double low, double high) {
  const double k = 2.0 * M_PI / wave.length;
  return high - low < wave.length
             ? (high - low) * M_PI_2 * wave.amplitude * k * (sqrt(M_2_PI * k * high) + RATE_BOUND)
             : INFINITY;
}

double po_abel_waves_least_g(const po_scene *scene, double low, double high) {
  double sum = 0.0;
  for (size_t i = 0; i < po_scene_waves(scene); ++i) {
    const po_wave wave = po_scene_wave(scene, i);
    const double bound = -M_PI_2 * wave.amplitude * sqrt(4.0 * high / wave.length),
                 loss = greatest_loss(wave, low, high);
    sum += isinf(loss) ? bound : fmax(bound, of_wave(wave, low).g - loss);
  }
  return sum;
}

double po_abel_waves_least_press(const po_scene *scene, double low, double high) {
  double sum = 0.0;
  for (size_t i = 0; i < po_scene_waves(scene); ++i) {
    const po_wave wave = po_scene_wave(scene, i);
    const double y = 2.0 * M_PI / wave.length * high, loss = greatest_loss(wave, low, high);
    double bound = 0.0;
    if (y > FIRST_ZERO)
      bound =
          -M_PI_2 * wave.amplitude * high * sqrt(M_2_PI * y) * (1.0 + BOUND / (y * y * sqrt(y)));
    sum += isinf(loss) ? bound : fmax(bound, of_wave(wave, low).press - high * loss);
  }
  return sum;
}

double po_abel_longest_wave(const po_scene *scene) {
  double longest = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    longest = fmax(longest, po_scene_wave(scene, k).length);
  return longest;
}

/* Parts of the radius and of a wavelength. The rate has two zeros in a wavelength. */
static const double PART_OF_RADIUS = 0.05, PART_OF_WAVE = 1.0 / 16.0;

double po_abel_detail(const po_scene *scene, double x) {
  double detail = PART_OF_RADIUS * x;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    detail = fmin(detail, PART_OF_WAVE * po_scene_wave(scene, k).length);
  const po_profile_table *t = table_of(scene);
  const size_t next = t ? po_abel_table_next(t, x) : 0;
  return t && next < t->rows ? fmin(detail, t->r[next] - t->r[next - 1]) : detail;
}
