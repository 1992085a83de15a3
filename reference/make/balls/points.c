/* Points of a curve: roots whose number is proven, values, the work between two points. */
#include <arb_calc.h>

#include "balls.h"

/* The coefficients of approach and load about a real or complex x. */
static bool expand(acb_poly_t approach, acb_poly_t load, const acb_t x, const curve *c,
                   slong length) {
  acb_poly_t start;
  acb_poly_init(start);
  acb_poly_set_coeff_acb(start, 0, x);
  acb_poly_set_coeff_si(start, 1, 1);
  const bool analytic = c->at(approach, load, start, c, length);
  acb_poly_clear(start);
  return analytic;
}

typedef struct {
  const curve *c;
  vanishing what;
  arb_srcptr target;
} equation;

/* The function of arb_calc: `order` coefficients about x. */
static int evaluate(arb_ptr out, const arb_t x, void *data, slong order, slong bits) {
  const equation *e = data;
  acb_poly_t approach, load;
  acb_t place;
  (void)bits;
  acb_poly_init(approach), acb_poly_init(load), acb_init(place);
  acb_set_arb(place, x);
  const bool is_slope = e->what == LOAD_SLOPE || e->what == APPROACH_SLOPE;
  expand(approach, load, place, e->c, order + is_slope);
  acb_poly_struct *chosen = e->what == LOAD || e->what == LOAD_SLOPE ? load : approach;
  if (is_slope)
    acb_poly_derivative(chosen, chosen, BITS);
  for (slong k = 0; k < order; ++k) {
    acb_poly_get_coeff_acb(place, chosen, k);
    arb_set(out + k, acb_realref(place));
  }
  if (e->target)
    arb_sub(out, out, e->target, BITS);
  acb_poly_clear(approach), acb_poly_clear(load), acb_clear(place);
  return 0;
}

/* Isolates the roots on the range of the curve. Returned: their number, which is proven; root: the
 * greatest one. */
slong roots(arb_t root, const curve *c, vanishing what, arb_srcptr target) {
  equation e = {c, what, target};
  arf_interval_t range, fine;
  arf_interval_ptr blocks;
  int *flags;
  arf_interval_init(range), arf_interval_init(fine);
  arb_get_lbound_arf(&range->a, c->low, BITS);
  arb_get_ubound_arf(&range->b, c->high, BITS);
  const slong count =
      arb_calc_isolate_roots(&blocks, &flags, evaluate, &e, range, 400, 1000000, 100, BITS);
  for (slong k = 0; k < count; ++k)
    if (flags[k] != 1)
      fail("a root is not isolated", "");
  if (count > 0) {
    arb_calc_refine_root_bisect(fine, evaluate, &e, blocks + count - 1, GOAL + 40, BITS);
    arf_interval_get_arb(root, fine, BITS);
  }
  _arf_interval_vec_clear(blocks, count);
  flint_free(flags);
  arf_interval_clear(range), arf_interval_clear(fine);
  return count;
}

void the_root(arb_t root, const curve *c, vanishing what, arb_srcptr target) {
  if (roots(root, c, what, target) != 1)
    fail("expected one root", "");
}

/* Whether the second derivative has one sign over the ball x. */
bool has_curvature(const curve *c, vanishing what, const arb_t x) {
  const equation e = {c, what, NULL};
  arb_struct slope[2];
  arb_init(&slope[0]), arb_init(&slope[1]);
  evaluate(slope, x, (void *)&e, 2, BITS);
  const bool sure = !arb_contains_zero(&slope[1]);
  arb_clear(&slope[0]), arb_clear(&slope[1]);
  return sure;
}

void value_at(arb_t approach, arb_t load, const arb_t x, const curve *c) {
  acb_poly_t d, p;
  acb_t place;
  acb_poly_init(d), acb_poly_init(p), acb_init(place);
  acb_set_arb(place, x);
  expand(d, p, place, c, 1);
  acb_poly_get_coeff_acb(place, d, 0);
  arb_set(approach, acb_realref(place));
  acb_poly_get_coeff_acb(place, p, 0);
  arb_set(load, acb_realref(place));
  acb_poly_clear(d), acb_poly_clear(p), acb_clear(place);
}

/* P dD/dx, whose integral is the work of the grips. */
static int power_of_grips(acb_ptr out, const acb_t x, void *data, slong order, slong bits) {
  acb_poly_t approach, load;
  acb_t slope;
  (void)bits;
  acb_poly_init(approach), acb_poly_init(load), acb_init(slope);
  const bool analytic = expand(approach, load, x, data, 2);
  acb_poly_get_coeff_acb(out, load, 0);
  acb_poly_get_coeff_acb(slope, approach, 1);
  acb_mul(out, out, slope, BITS);
  if (order > 0 && !analytic)
    acb_indeterminate(out);
  acb_poly_clear(approach), acb_poly_clear(load), acb_clear(slope);
  return 0;
}

void integral(arb_t result, acb_calc_func_t function, void *data, const arb_t from,
              const arb_t to) {
  acb_t low, high, sum;
  mag_t tolerance;
  acb_init(low), acb_init(high), acb_init(sum), mag_init(tolerance);
  acb_set_arb(low, from);
  acb_set_arb(high, to);
  mag_set_ui_2exp_si(tolerance, 1, -BITS);
  acb_calc_integrate(sum, function, data, low, high, GOAL, tolerance, NULL, BITS);
  arb_set(result, acb_realref(sum));
  acb_clear(low), acb_clear(high), acb_clear(sum), mag_clear(tolerance);
}

/* The work of grips that move the bodies apart from x = from to x = to. */
void work_between(arb_t work, curve *c, const arb_t from, const arb_t to) {
  integral(work, power_of_grips, c, from, to);
}
