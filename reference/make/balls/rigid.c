/* Rigid bodies under the Lennard-Jones law, P/(pi w R) = (2/R) int p r dr, in units of epsilon and
 * w. */
#include "balls.h"

/* -(8/3) [h^-m - h^-n/d]: m, n, d = 3, 9, 1 is the pressure, 2, 8, 4 the load of a sphere. */
static void minus_powers(arb_t result, const arb_t h, ulong m, ulong n, ulong d) {
  arb_t inverse, other;
  arb_init(inverse), arb_init(other);
  arb_inv(inverse, h, BITS);
  arb_pow_ui(result, inverse, m, BITS);
  arb_pow_ui(other, inverse, n, BITS);
  arb_div_ui(other, other, d, BITS);
  arb_sub(result, other, result, BITS);
  arb_mul_ui(result, result, 8, BITS);
  arb_div_ui(result, result, 3, BITS);
  arb_clear(inverse), arb_clear(other);
}

/* The gap at the axis, 1 - D. */
static void take_gap(arb_t gap, const parameters *p, const char *approach) {
  take(gap, p, approach);
  arb_sub_ui(gap, gap, 1, BITS);
  arb_neg(gap, gap);
}

/* The load vanishes at h^6 = 1/4 and is lowest at h = 1; the work from there to infinity is
 * (8/3) [1/h - 1/(28 h^7)]. */
void rigid_sphere(const parameters *p) {
  arb_t h, x;
  arb_init(h), arb_init(x);
  arb_one(h);
  minus_powers(x, h, 2, 8, 4);
  answer_negative("pull_off_force", x);
  take_gap(h, p, "D1");
  minus_powers(x, h, 2, 8, 4);
  answer("load_at_approach", x);
  take_gap(h, p, "D2");
  minus_powers(x, h, 2, 8, 4);
  answer("load_near", x);
  arb_set_ui(h, 4);
  arb_root_ui(h, h, 6, BITS);
  arb_inv(h, h, BITS);
  arb_sub_ui(x, h, 1, BITS);
  answer_negative("zero_load_approach", x);
  minus_powers(x, h, 1, 7, 28);
  answer_negative("work_to_separate", x);
  arb_clear(h), arb_clear(x);
}

/* A flat of the radius b on a sphere: the load is (b^2/R) p(h) more, its derivative by h
 * -2 p - (b^2/R) (8/3) [-3 h^-4 + 9 h^-10]; D1 has to be a bracket of the only root below h = 1. */
static void truncated_load(arb_t load, const arb_t h, const arb_t flat) {
  arb_t more;
  arb_init(more);
  minus_powers(more, h, 3, 9, 1);
  minus_powers(load, h, 2, 8, 4);
  arb_addmul(load, more, flat, BITS);
  arb_clear(more);
}

/* d load/dh = (16/3) (h^-3 - h^-9) + flat 8 (h^-4 - 3 h^-10). */
static void truncated_slope(arb_t slope, const arb_t h, const arb_t flat) {
  arb_t more, other;
  arb_init(more), arb_init(other);
  minus_powers(slope, h, 3, 9, 1);
  arb_mul_si(slope, slope, -2, BITS);
  arb_inv(other, h, BITS);
  arb_pow_ui(more, other, 6, BITS);
  arb_mul_si(more, more, -3, BITS);
  arb_add_ui(more, more, 1, BITS);
  arb_pow_ui(other, other, 4, BITS);
  arb_mul(more, more, other, BITS);
  arb_mul_2exp_si(more, more, 3);
  arb_addmul(slope, more, flat, BITS);
  arb_clear(more), arb_clear(other);
}

typedef void function(arb_t value, const arb_t x, const void *data);

/* Halves the interval low .. high, over which the function changes from below to above zero, by
 * proven signs. The result encloses a root. */
static void bisect(arb_t root, function *f, const void *data, const char *low, const char *high) {
  arb_t a, b, middle, value;
  arb_init(a), arb_init(b), arb_init(middle), arb_init(value);
  arb_set_str(a, low, BITS);
  arb_set_str(b, high, BITS);
  f(value, a, data);
  if (!arb_is_negative(value))
    fail("no change of sign from ", low);
  f(value, b, data);
  if (!arb_is_positive(value))
    fail("no change of sign up to ", high);
  for (int k = 0; k < GOAL; ++k) {
    arb_add(middle, a, b, BITS);
    arb_mul_2exp_si(middle, middle, -1);
    arb_get_mid_arb(middle, middle);
    f(value, middle, data);
    if (arb_contains_zero(value))
      break;
    arb_set(arb_is_negative(value) ? a : b, middle);
  }
  arb_union(root, a, b, BITS);
  arb_clear(a), arb_clear(b), arb_clear(middle), arb_clear(value);
}

static void slope_of_truncated(arb_t value, const arb_t h, const void *data) {
  truncated_slope(value, h, data);
}

/* The load falls from h = 0 and rises from h = 3^(1/6) < 1.21 on: both terms fall and rise there;
 * it is lowest between 1 and 3^(1/6), where one of them rises and one falls. */
void rigid_truncated(const parameters *p) {
  arb_t h, flat, x;
  arb_init(h), arb_init(flat), arb_init(x);
  take(flat, p, "b");
  arb_mul(flat, flat, flat, BITS);
  take(x, p, "R");
  arb_div(flat, flat, x, BITS);
  bisect(h, slope_of_truncated, flat, "1", "1.21");
  truncated_load(x, h, flat);
  answer_negative("pull_off_force", x);
  arb_sub_ui(x, h, 1, BITS);
  answer_negative("pull_off_approach", x);
  take_gap(h, p, "D1");
  truncated_load(x, h, flat);
  answer("load_at_approach", x);
  arb_clear(h), arb_clear(flat), arb_clear(x);
}

/* The wavy sphere, h = 1 - D + r^2/(2R) + A (1 - cos(2 pi r/L)) for r < cut. */
typedef struct {
  arb_t radius, amplitude, length, cut, approach;
  bool slope; /* the derivative of the load by D instead of the load */
} wavy;

static void wavy_gap(acb_t h, const acb_t r, const wavy *w) {
  acb_t x;
  acb_init(x);
  acb_div_arb(x, r, w->length, BITS);
  acb_mul_2exp_si(x, x, 1);
  acb_cos_pi(x, x, BITS);
  acb_sub_ui(x, x, 1, BITS);
  acb_neg(x, x);
  acb_mul_arb(x, x, w->amplitude, BITS);
  acb_mul(h, r, r, BITS);
  acb_div_arb(h, h, w->radius, BITS);
  acb_mul_2exp_si(h, h, -1);
  acb_add(h, h, x, BITS);
  acb_sub_arb(h, h, w->approach, BITS);
  acb_add_ui(h, h, 1, BITS);
  acb_clear(x);
}

/* (2/R) p(h) r, or (2/R) (-dp/dh) r: a rational function of h, analytic where h is not 0, and not
 * finite in a ball that contains 0. */
static int wavy_integrand(acb_ptr out, const acb_t r, void *data, slong order, slong bits) {
  const wavy *w = data;
  acb_t inverse, sixth;
  (void)order, (void)bits;
  acb_init(inverse), acb_init(sixth);
  wavy_gap(inverse, r, w);
  acb_inv(inverse, inverse, BITS);
  acb_pow_ui(sixth, inverse, 6, BITS);
  acb_mul_si(out, sixth, w->slope ? -3 : -1, BITS);
  acb_add_ui(out, out, 1, BITS); /* 1 - h^-6, or 1 - 3 h^-6 */
  acb_pow_ui(inverse, inverse, w->slope ? 4 : 3, BITS);
  acb_mul(out, out, inverse, BITS);
  acb_mul(out, out, r, BITS);
  acb_mul_si(out, out, w->slope ? -48 : -16, BITS);
  acb_div_arb(out, out, w->radius, BITS);
  acb_div_ui(out, out, 3, BITS);
  acb_clear(inverse), acb_clear(sixth);
  return 0;
}

static void wavy_at(arb_t value, const arb_t approach, const void *data) {
  wavy *w = (wavy *)data;
  arb_t zero;
  arb_init(zero);
  arb_set(w->approach, approach);
  integral(value, wavy_integrand, w, zero, w->cut);
  arb_clear(zero);
}

/* The minimum of the load between the approaches -0.5 and 0.5. */
void rigid_wavy(const parameters *p) {
  wavy w;
  arb_t approach, x;
  arb_init(w.radius), arb_init(w.amplitude), arb_init(w.length), arb_init(w.cut);
  arb_init(w.approach), arb_init(approach), arb_init(x);
  take(w.radius, p, "R");
  take(w.amplitude, p, "A");
  take(w.length, p, "wavelength");
  take(w.cut, p, "outer_radius");
  w.slope = true;
  bisect(approach, wavy_at, &w, "-0.5", "0.5");
  answer("pull_off_approach", approach);
  w.slope = false;
  wavy_at(x, approach, &w);
  answer_negative("pull_off_force", x);
  take(approach, p, "D1");
  wavy_at(x, approach, &w);
  answer("load_at_approach", x);
  arb_clear(w.radius), arb_clear(w.amplitude), arb_clear(w.length), arb_clear(w.cut);
  arb_clear(w.approach), arb_clear(approach), arb_clear(x);
}
