/* When the factors of panels are in double precision: where the growth of rounding, the gain of
 * rounding, the size of the interactions or a slow iteration asks for it, and not otherwise. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_adaptive.h"
#include "po_elimination.h"
#include "po_equilibrium.h"
#include "po_initial_gap.h"
#include "run.h"

enum { LEVEL = 4, PANELS = 1 << LEVEL, NODES = PANELS * PO_TABLE_ORDER };

typedef struct {
  po_scene scene;
  po_adaptive *panels;
  po_equilibrium *e;
  double state[NODES + 1], border[NODES + 1];
} fixture;

static const double APPROACH = -1.0;

/* A sphere of small Tabor parameter, not yet in contact, on equal panels of a cut surface: there is
 * one equilibrium. */
static void set_up_scene(fixture *f, double tabor, double outer_radius) {
  memset(f, 0, sizeof *f);
  f->scene = (po_scene){.tabor = tabor, .radius = 100.0, .outer_radius = outer_radius};
  ck_assert_int_eq(po_adaptive_create(&f->scene, outer_radius, LEVEL, &f->panels), PO_OK);
  const po_surface *s = po_adaptive_surface(f->panels);
  ck_assert_uint_eq(s->n, NODES);
  ck_assert_int_eq(po_equilibrium_create(&f->scene, s, NODES, &f->e), PO_OK);
  for (size_t j = 0; j < NODES; ++j)
    f->state[j] = po_initial_gap(&f->scene, s->node[j]) - APPROACH;
  f->state[NODES] = APPROACH;
  f->border[NODES] = 1.0;
}

static void set_up(fixture *f) {
  set_up_scene(f, 0.5, 40.0);
}

static void tear_down(fixture *f) {
  po_equilibrium_destroy(f->e);
  po_adaptive_destroy(f->panels);
}

/* Panels in the middle of the domain with the same factor at all nodes; the others have none. */
static void fill_factors(size_t panels, double value, double *factor) {
  memset(factor, 0, NODES * sizeof *factor);
  for (size_t j = 0; j < panels * PO_TABLE_ORDER; ++j)
    factor[PANELS / 2 * PO_TABLE_ORDER + j] = value;
}

static int sign_at(po_elimination *e, size_t panels, double value) {
  double factor[NODES];
  fill_factors(panels, value, factor);
  ck_assert_int_eq(po_elimination_factorize(e, factor, true), PO_OK);
  return po_elimination_sign(e);
}

/* The least positive factor of these panels for which the matrix is singular. */
static double singular_factor(po_elimination *e, size_t panels) {
  double low = 0.0, high = 0.01;
  while (sign_at(e, panels, high) > 0)
    high *= 1.1;
  while (high - low > 1e-14 * high) {
    const double middle = 0.5 * (low + high);
    *(sign_at(e, panels, middle) > 0 ? &low : &high) = middle;
  }
  return high;
}

static void solve(po_elimination *e, double *x) {
  double border[NODES + 1] = {0};
  border[NODES] = 1.0;
  po_elimination_border(e, border);
  for (size_t j = 0; j <= NODES; ++j)
    x[j] = cos(3.0 * (double)j);
  po_elimination_solve(e, x);
}

/* Close to a singular matrix of one panel, or of two halves of a cell, rounding grows: the factors
 * are those that are asked for in double precision, and give the same solution. Far from it they
 * are in single precision, before and after. */
START_TEST(growth_of_rounding_asks_for_double) {
  static const double CLOSE = 1e-5, FAR = 0.5;
  const size_t panels = (size_t)_i + 1;
  fixture f;
  double far_factor[NODES], factor[NODES], chosen[NODES + 1], full[NODES + 1];
  set_up(&f);
  po_elimination *e, *other;
  const po_hierarchy *h = po_adaptive_surface(f.panels)->hierarchy;
  ck_assert_int_eq(po_elimination_create(h, &e), PO_OK);
  ck_assert_int_eq(po_elimination_create(h, &other), PO_OK);
  const double singular = singular_factor(other, panels);
  fill_factors(panels, (1.0 + CLOSE) * singular, factor);
  fill_factors(panels, FAR * singular, far_factor);
  ck_assert_int_eq(po_elimination_factorize(e, far_factor, false), PO_OK);
  ck_assert(!po_elimination_is_double(e));
  ck_assert_int_eq(po_elimination_factorize(e, factor, false), PO_OK);
  ck_assert(po_elimination_is_double(e));
  solve(e, chosen);
  ck_assert_int_eq(po_elimination_factorize(other, factor, true), PO_OK);
  solve(other, full);
  ck_assert_mem_eq(chosen, full, sizeof full);
  for (int k = 0; k < 2; ++k) /* the first after a large growth may be in double precision, too */
    ck_assert_int_eq(po_elimination_factorize(e, far_factor, false), PO_OK);
  ck_assert(!po_elimination_is_double(e));
  po_elimination_destroy(e);
  po_elimination_destroy(other);
  tear_down(&f);
}
END_TEST

/* Factorises with a border whose product with the tangent is `part` of that of the border of given
 * approach, and measures the gain, which grows as 1 / part. */
static void factorize(fixture *f, const double *tangent, double part) {
  double border[NODES + 1] = {0};
  border[NODES] = 1.0;
  border[0] = (part - 1.0) * tangent[NODES] / tangent[0];
  ck_assert_int_eq(po_equilibrium_factorize(f->e, f->state, border), PO_OK);
  po_equilibrium_measure_noise(f->e, f->state);
}

/* Corrects the state; the tangent at given approach. */
static void solve_state(fixture *f, double *tangent) {
  double base[NODES + 1];
  po_status status = PO_NOT_CONVERGED;
  memcpy(base, f->state, sizeof base);
  for (int k = 0; status && k < 20; ++k) {
    ck_assert_int_eq(po_equilibrium_factorize(f->e, f->state, f->border), PO_OK);
    status = po_equilibrium_correct(f->e, f->state, base, 0.0);
  }
  ck_assert_int_eq(status, PO_OK);
  ck_assert_int_eq(po_equilibrium_factorize(f->e, f->state, f->border), PO_OK);
  ck_assert(!po_elimination_is_double(f->e->elimination));
  ck_assert_int_eq(po_equilibrium_tangent(f->e, f->e->precision, tangent), PO_OK);
}

/* A border nearly perpendicular to the tangent amplifies rounding, though no matrix of a panel or
 * of a cell does: from a gain of 30 on, the next factors are in double precision. */
START_TEST(gain_of_rounding_asks_for_double) {
  static const double PART = 0.1, BELOW = 20.0, ABOVE = 45.0;
  fixture f;
  double tangent[NODES + 1];
  set_up(&f);
  solve_state(&f, tangent);
  factorize(&f, tangent, PART);
  const double part = PART * f.e->gain;
  factorize(&f, tangent, part / BELOW);
  ck_assert_double_gt(f.e->gain, 15.0);
  factorize(&f, tangent, part / BELOW);
  ck_assert(!po_elimination_is_double(f.e->elimination));
  ck_assert(!po_equilibrium_is_coarse(f.e));
  factorize(&f, tangent, part / ABOVE);
  ck_assert_double_gt(f.e->gain, 35.0);
  ck_assert_double_lt(f.e->gain, 50.0);
  ck_assert(!po_elimination_is_double(f.e->elimination));
  ck_assert(po_equilibrium_is_coarse(f.e));
  factorize(&f, tangent, part / ABOVE);
  ck_assert(po_elimination_is_double(f.e->elimination));
  ck_assert(!po_equilibrium_is_coarse(f.e));
  tear_down(&f);
}
END_TEST

/* The largest error of the factors in the contact, radius `contact`, for a change of 1 of all gaps
 * at given approach: of precondition(J change). */
static double error_of_smooth_change(fixture *f, double contact) {
  po_equilibrium *e = f->e;
  double product[NODES + 1], change[NODES + 1], worst = 0.0;
  po_equilibrium_deflect(e, e->slope, product);
  for (size_t j = 0; j < NODES; ++j)
    product[j] = 1.0 - product[j];
  product[NODES] = 0.0;
  po_equilibrium_precondition(e, product, change);
  for (size_t j = 0; e->surface->node[j] < contact; ++j)
    worst = fmax(worst, fabs(change[j] - 1.0));
  return worst;
}

/* Surfaces pressed together on a wide soft area: the interactions are 1e9 times the unit matrix,
 * and tractions that nearly cancel give the change of the gap. In single precision the factors
 * would miss it by a factor of 600. At mu = 1 single precision suffices. */
START_TEST(large_interactions_ask_for_double) {
  static const double CONTACT = 687.5, END = 1000.0, APART = 100.0, TABOR[] = {1.0, 1e4};
  fixture f;
  set_up_scene(&f, TABOR[_i], END);
  for (size_t j = 0; j < NODES; ++j)
    f.state[j] = f.e->surface->node[j] < CONTACT ? 0.0 : APART;
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
  ck_assert(po_elimination_is_double(f.e->elimination) == (_i == 1));
  ck_assert_double_lt(error_of_smooth_change(&f, CONTACT), 0.1);
  tear_down(&f);
}
END_TEST

/* After an iteration that was too slow, some factorisations are in double precision. */
START_TEST(distrust_asks_for_double) {
  fixture f;
  double tangent[NODES + 1];
  int count = 0;
  set_up(&f);
  solve_state(&f, tangent);
  ck_assert(po_equilibrium_distrust_single(f.e));
  for (; count < 100; ++count) {
    ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
    if (!po_elimination_is_double(f.e->elimination))
      break;
    ck_assert(!po_equilibrium_distrust_single(f.e)); /* nothing more accurate can be had */
  }
  ck_assert_int_gt(count, 1);
  ck_assert_int_lt(count, 100);
  tear_down(&f);
}
END_TEST

static void add(TCase *tests) {
  tcase_add_loop_test(tests, growth_of_rounding_asks_for_double, 0, 2);
  tcase_add_test(tests, gain_of_rounding_asks_for_double);
  tcase_add_loop_test(tests, large_interactions_ask_for_double, 0, 2);
  tcase_add_test(tests, distrust_asks_for_double);
}

int main(void) {
  return run_case("precision of factors", add);
}
