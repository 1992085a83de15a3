#include "po_abel.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_order.h"
#include "po_profile_kind.h"
#include "po_profile_table.h"
#include "po_quadrature.h"
#include "po_special.h"

static const po_abel ZERO = {0.0, 0.0, 0.0};

/* The transform of a table: piecewise over the cubics of its spline, of which f', (r f')' and r^2
 * f' are integrated by dtheta = dr/sqrt(x^2 - r^2), r = x cos(theta), with Gauss rules: beside x by
 * theta, in which they are trigonometric polynomials, farther away by r, which takes no angles. */

/* Points of the Gauss rules; the greatest angles of a piece: the remainders for the third harmonic
 * are 7e-16 of 1 rad with 8 points and 2e-16 of 0.05 rad with 4; and the least distances of x from
 * an interval over its length for the rules by r: from 3 and 40 on their remainders, the power of
 * -2 n of the ellipse that passes x, are less than 1e-17. */
enum { POINTS = 8, FEW_POINTS = 4 };
static const double GREATEST_ANGLE = 1.0, SMALL_ANGLE = 0.05, AWAY = 3.0, FAR_AWAY = 40.0;

typedef struct {
  double node[POINTS], weight[POINTS], few_node[FEW_POINTS], few_weight[FEW_POINTS];
} rules;

typedef struct {
  double slope, curvature; /* f', f'' */
} derivatives;

/* The derivatives of the cubic of interval k at a distance from its row. */
static derivatives derivatives_at(const po_profile_table *t, size_t k, double distance) {
  const double h = t->r[k + 1] - t->r[k], z = distance / h, s0 = t->slope[k], s1 = t->slope[k + 1];
  const double chord = (t->gap[k + 1] - t->gap[k]) / h;
  return (derivatives){
      s0 * (1.0 - z) * (1.0 - 3.0 * z) + s1 * z * (3.0 * z - 2.0) + 6.0 * chord * z * (1.0 - z),
      (s0 * (6.0 * z - 4.0) + s1 * (6.0 * z - 2.0) + 6.0 * chord * (1.0 - 2.0 * z)) / h};
}

/* Adds the integrals over the angles from `inner` to `outer` of interval k; press over x^2. */
static void add_piece(const po_profile_table *t, const rules *rule, double x, size_t k,
                      double inner, double outer, po_abel *sum) {
  const double whole = outer - inner;
  const int pieces = (int)ceil(whole / GREATEST_ANGLE);
  const bool few = whole < SMALL_ANGLE;
  const int count = few ? FEW_POINTS : POINTS;
  const double *node = few ? rule->few_node : rule->node,
               *weight = few ? rule->few_weight : rule->weight;
  const double angle = whole / pieces;
  for (int i = 0; i < pieces * count; ++i) {
    const double theta = inner + angle * (i / count + node[i % count]), half = po_sin(0.5 * theta);
    const double cosine = 1.0 - 2.0 * half * half;
    const derivatives f = derivatives_at(t, k, (x - t->r[k]) - 2.0 * x * half * half);
    const double part = angle * weight[i % count];
    sum->g += part * f.slope;
    sum->rate += part * (f.slope + x * cosine * f.curvature);
    sum->press += part * cosine * cosine * f.slope;
  }
}

/* The same over the whole of interval k, far from x. */
static void add_far_piece(const po_profile_table *t, const rules *rule, double x, size_t k,
                          po_abel *sum) {
  const double h = t->r[k + 1] - t->r[k];
  const bool few = x - t->r[k + 1] > FAR_AWAY * h;
  const int count = few ? FEW_POINTS : POINTS;
  const double *node = few ? rule->few_node : rule->node,
               *weight = few ? rule->few_weight : rule->weight;
  const double s0 = t->slope[k], s1 = t->slope[k + 1], chord = (t->gap[k + 1] - t->gap[k]) / h;
  const double linear = 6.0 * chord - 4.0 * s0 - 2.0 * s1, square = 3.0 * (s0 + s1 - 2.0 * chord);
  double g = 0.0, rate = 0.0, press = 0.0;
  for (int i = 0; i < count; ++i) {
    const double z = node[i], r = t->r[k] + h * z, slope = s0 + z * (linear + z * square);
    const double part = weight[i] / sqrt((x - r) * (x + r));
    g += part * slope;
    rate += part * (linear + 2.0 * square * z) * r;
    press += part * r * r * slope;
  }
  sum->g += h * g;
  sum->rate += h * g + rate;
  sum->press += h * press / (x * x);
}

double po_abel_angle(double r, double x) {
  return po_atan2(sqrt((x - r) * (x + r)), r);
}

/* The incomplete integral of sin^(n - 1) over the angles from the last row outwards. */
static double part_beyond(double n, double end, double x) {
  return 0.5 * po_beta_incomplete(0.5, 0.5 * n, (x - end) / x * ((x + end) / x));
}

const po_profile_table *po_abel_table(const po_scene *scene) {
  const po_profile_table *t = scene->profile.kind == &PO_TABLE ? scene->profile.table : NULL;
  return t && t->thin ? t->thin : t;
}

static po_abel table(const po_scene *scene, double x) {
  const po_profile_table *t = po_abel_table(scene);
  rules rule;
  po_abel sum = {0.0, 0.0, 0.0};
  if (po_gauss_rule(POINTS, rule.node, rule.weight) ||
      po_gauss_rule(FEW_POINTS, rule.few_node, rule.few_weight))
    return (po_abel){NAN, NAN, NAN};
  if (!(x > 0.0))
    return (po_abel){0.0, M_PI_2 * t->slope[0], 0.0};
  const size_t last = t->rows - 1;
  size_t k = 0;
  for (; k < last && x - t->r[k + 1] > AWAY * (t->r[k + 1] - t->r[k]); ++k)
    add_far_piece(t, &rule, x, k, &sum);
  for (double outer = po_abel_angle(t->r[k], x); k < last && t->r[k] < x; ++k) {
    const double inner = t->r[k + 1] < x ? po_abel_angle(t->r[k + 1], x) : 0.0;
    add_piece(t, &rule, x, k, inner, outer, &sum);
    outer = inner;
  }
  const double end = t->r[last], n = t->growth;
  if (x > end) {
    const double slope = n * t->gap[last] / x * po_pow(x / end, n), part = part_beyond(n, end, x);
    sum.g += slope * part;
    sum.rate += n * slope * part;
    sum.press += slope * part_beyond(n + 2.0, end, x);
  }
  return (po_abel){x * sum.g, sum.rate, x * x * sum.press};
}

/* The extrema of (r f')' in interval k, where it is a parabola: at the ends and between. */
static void widen(const po_profile_table *t, size_t k, double *least, double *most) {
  const double h = t->r[k + 1] - t->r[k];
  double value[3];
  for (int i = 0; i < 3; ++i) {
    const double distance = 0.5 * i * h;
    const derivatives f = derivatives_at(t, k, distance);
    value[i] = f.slope + (t->r[k] + distance) * f.curvature;
    *least = fmin(*least, value[i]);
    *most = fmax(*most, value[i]);
  }
  const double bend = value[0] - 2.0 * value[1] + value[2], tilt = 0.5 * (value[2] - value[0]);
  if (fabs(tilt) < fabs(bend)) {
    const double extremum = value[1] - 0.5 * tilt * tilt / bend;
    *least = fmin(*least, extremum);
    *most = fmax(*most, extremum);
  }
}

/* The maximum over all radii up to x of (pi/2) (r f')', which bounds the rate of the transform. */
static double greatest_rate(const po_profile_table *t, double x) {
  const size_t last = t->rows - 1;
  double least = 0.0, most = 0.0;
  for (size_t k = 0; k < last && t->r[k] < x; ++k)
    widen(t, k, &least, &most);
  if (x > t->r[last]) /* (r f')' = n f' beyond the end */
    most =
        fmax(most, t->growth * t->slope[last] * fmax(1.0, po_pow(x / t->r[last], t->growth - 1.0)));
  return M_PI_2 * most;
}

/* The greatest drop of (pi/2) (r f')' from any radius up to `end` to another one that is larger, by
 * less than `reach`. Radii are collected in bins that are longer than the reach: what is less than
 * it apart is in one bin or in two neighbours. */
static double greatest_drop(const po_profile_table *t, double end, double reach) {
  const size_t last = t->rows - 1;
  double before = -INFINITY, here = -INFINITY, begin = 0.0, drop = 0.0;
  for (size_t k = 0; k < last && t->r[k] < end; ++k) {
    double least = INFINITY, most = -INFINITY;
    widen(t, k, &least, &most);
    if (t->r[k] > begin + reach) {
      before = here;
      here = -INFINITY;
      begin = t->r[k];
    }
    here = fmax(here, most);
    drop = fmax(drop, fmax(before, here) - least);
  }
  if (end > t->r[last]) /* n f' beyond the last row */
    drop = t->growth < 1.0 ? INFINITY : fmax(drop, fmax(before, here) - t->growth * t->slope[last]);
  return M_PI_2 * drop;
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

/* The series t^3/3 + square t^5/5 + square^2 t^7/7 + ..., square = -1 or 1: of t - atan(t) and of
 * artanh(t) - t, which cancel for small t. */
static const double SERIES = 0.5, ROUNDING = 1e-17;

static double odd_series(double t, double square) {
  double sum = 0.0, power_of_t = t * t * t, term = power_of_t / 3.0;
  for (int k = 3; fabs(term) > ROUNDING * sum; k += 2) {
    sum += term;
    power_of_t *= square * t * t;
    term = power_of_t / (k + 2);
  }
  return sum;
}

/* t - atan(t) */
static double less_arctangent(double t) {
  return t > SERIES ? t - po_atan2(t, 1.0) : odd_series(t, -1.0);
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

/* R - sqrt(R^2 - r^2) up to the end e of the sphere, h = sqrt(R^2 - e^2): g = x L with L =
 * artanh(x/R) (Sneddon 1965). Beyond, where the slope is r/h, s = sqrt(x^2 - e^2): g = x L + x s/h,
 * L = ln((R + x)/(h + s)). */
static po_abel exact_sphere(const po_scene *scene, double x) {
  const double R = scene->profile.parameter[PO_EXACT_SPHERE_R],
               e = po_profile_shape(&scene->profile).kink;
  if (x > e) {
    const double h = sqrt((R - e) * (R + e)), s = sqrt((x - e) * (x + e));
    const double L = po_log((R + x) / (h + s));
    return (po_abel){x * L + x * s / h, L + x / (R + x) + s / h + x * x / (h * (h + s)),
                     0.5 * (h * s - R * x + (R * R + x * x) * L) + s * (x * x - s * s / 3.0) / h};
  }
  const double u = x / R, L = 0.5 * po_log1p(2.0 * x / (R - x));
  const double more = u > SERIES ? L - u : odd_series(u, 1.0); /* L - u */
  return (po_abel){x * L, L + u / ((1.0 - u) * (1.0 + u)), 0.5 * (R * R * more + x * x * L)};
}

/* t (sqrt(r^2 + b^2) - b): g = t x arctan(x/b). */
static po_abel hyperboloid(const po_scene *scene, double x) {
  const double t = scene->profile.parameter[PO_HYPERBOLOID_T],
               b = scene->profile.parameter[PO_HYPERBOLOID_B], u = x / b, turn = po_atan2(x, b);
  return (po_abel){t * x * turn, t * (turn + u / (1.0 + u * u)),
                   0.5 * t * (x * x * turn + b * b * less_arctangent(u))};
}

static const struct {
  const po_profile_kind *kind;
  po_abel (*at)(const po_scene *scene, double x);
} FORMS[] = {{&PO_SPHERE, sphere},
             {&PO_POWER, power},
             {&PO_CONE, cone},
             {&PO_PUNCH, punch},
             {&PO_TRUNCATED, truncated},
             {&PO_TABLE, table},
             {&PO_EXACT_SPHERE, exact_sphere},
             {&PO_HYPERBOLOID, hyperboloid}};

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
  const po_profile_table *t = po_abel_table(scene);
  double least = 0.0, most = 0.0; /* of (r f')'; times pi/2 they bound the rate of the transform */
  for (size_t k = 0; t && k + 1 < t->rows; ++k)
    widen(t, k, &least, &most);
  return least < 0.0 ? -M_PI_2 * least : 0.0;
}

double po_abel_greatest_drop(const po_scene *scene, double low, double high) {
  const po_profile_table *t = po_abel_table(scene);
  return t && !po_scene_is_wavy(scene) ? greatest_drop(t, high, high - low) : INFINITY;
}

double po_abel_greatest_rate(const po_scene *scene, double x) {
  const po_profile_table *t = po_abel_table(scene);
  double sum = t ? greatest_rate(t, x) : po_abel_of_profile(scene, x).rate;
  if (x > po_profile_shape(&scene->profile).kink)
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

/* On an interval that is shorter than the wave, g loses at most what its rate allows. */
po_abel po_abel_waves_least(const po_scene *scene, double low, double high) {
  po_abel sum = ZERO;
  for (size_t i = 0; i < po_scene_waves(scene); ++i) {
    const po_wave wave = po_scene_wave(scene, i);
    const double k = 2.0 * M_PI / wave.length, y = k * high, factor = M_PI_2 * wave.amplitude;
    double g = -factor * sqrt(4.0 * high / wave.length), press = 0.0;
    if (y > FIRST_ZERO)
      press = -factor * high * sqrt(M_2_PI * y) * (1.0 + BOUND / (y * y * sqrt(y)));
    if (high - low < wave.length) {
      const po_abel first = of_wave(wave, low);
      const double loss =
          (high - low) * M_PI_2 * wave.amplitude * k * (sqrt(M_2_PI * k * high) + RATE_BOUND);
      g = fmax(g, first.g - loss);
      press = fmax(press, first.press - high * loss);
    }
    sum.g += g;
    sum.press += press;
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
  const po_profile_table *t = po_abel_table(scene);
  const size_t row = t ? po_order_last_up_to(t->r, t->rows, x) : 0;
  return t && row + 1 < t->rows ? fmin(detail, t->r[row + 1] - t->r[row]) : detail;
}
