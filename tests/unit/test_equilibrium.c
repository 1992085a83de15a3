/* Residual and Jacobian of Eqs 15-16, and Newton's method for them. */
#include <math.h>

#include "po_arclength.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "run.h"

enum { NODES = 81 };

typedef struct {
  po_scene scene;
  po_surface *surface;
  po_equilibrium *e;
  double state[NODES + 1], border[NODES + 1];
} fixture;

static void set_up(fixture *f, double tabor, double approach) {
  f->scene = (po_scene){tabor, 0.7, 23.85, 91.0, 60.0};
  const po_mesh mesh = {PO_TRIANGLE, PO_UNIFORM, NODES, 0.0};
  ck_assert_int_eq(po_surface_create(&f->scene, &mesh, 60.0, true, &f->surface), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&f->scene, f->surface, &f->e), PO_OK);
  for (int j = 0; j < NODES; ++j) {
    f->state[j] = fmax(-0.02, po_initial_gap(&f->scene, f->surface->node[j]) - approach);
    f->border[j] = 0.0;
  }
  f->state[NODES] = approach;
  f->border[NODES] = 1.0;
}

static void tear_down(fixture *f) {
  po_equilibrium_destroy(f->e);
  po_surface_destroy(f->surface);
}

/* Eq 15 in the variables of the paper: u, Gamma, G' and P. */
static double residual_of_paper(const fixture *f, int i) {
  const double mu = f->scene.tabor, gamma = sqrt(f->scene.radius * mu);
  const double u = f->surface->node[i] / gamma, L = f->scene.wavelength / gamma;
  double sum = 0.0;
  for (int j = 0; j < NODES; ++j) {
    const double h = 1.0 + f->state[j];
    const double P = -8.0 / 3.0 * mu * (pow(h, -3.0) - pow(h, -9.0));
    sum += f->surface->influence[i + NODES * j] / gamma * P;
  }
  return -f->state[NODES] + 0.5 * mu * u * u +
         f->scene.amplitude * (1.0 - cos(2.0 * M_PI * u / L)) + mu * sum - f->state[i];
}

static const double TABORS[] = {0.03, 0.7, 2.385, 5.0};
enum { TABOR_COUNT = sizeof TABORS / sizeof *TABORS };

LOOP_TEST(corrected_state_satisfies_eq_15, 0, TABOR_COUNT) {
  fixture f;
  set_up(&f, TABORS[_i], -0.385 - 2.0 * TABORS[_i]); /* beyond the first fold: one equilibrium */
  double base[NODES + 1];
  for (int j = 0; j <= NODES; ++j)
    base[j] = f.state[j];
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = 0; status && fresh < 5; ++fresh) { /* the chord method may need new factors */
    ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
    status = po_equilibrium_correct(f.e, f.state, base, 0.0);
  }
  ck_assert_int_eq(status, PO_OK);
  for (int i = 0; i < NODES; ++i)
    ck_assert_double_eq_tol(residual_of_paper(&f, i), 0.0, 1e-12 * (1.0 + f.state[i]));
  ck_assert_double_eq_tol(f.state[NODES], base[NODES], 1e-14);
  tear_down(&f);
}

/* The tangent is the derivative of the equilibrium with respect to the approach. */
LOOP_TEST(tangent_agrees_with_finite_differences, 0, TABOR_COUNT) {
  fixture f;
  set_up(&f, TABORS[_i], -0.385 - 2.0 * TABORS[_i]);
  double base[NODES + 1], tangent[NODES + 1], at[2][NODES + 1], load[2];
  const double step = 1e-4;
  po_status status = PO_NOT_CONVERGED;
  for (int j = 0; j <= NODES; ++j)
    base[j] = f.state[j];
  for (int fresh = 0; status && fresh < 5; ++fresh) {
    ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
    status = po_equilibrium_correct(f.e, f.state, base, 0.0);
  }
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
  ck_assert_int_eq(po_equilibrium_tangent(f.e, f.e->precision, tangent), PO_OK);
  const double rate = po_equilibrium_load_rate(f.e, tangent);
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j <= NODES; ++j)
      at[k][j] = f.state[j];
    ck_assert_int_eq(po_equilibrium_correct(f.e, at[k], f.state, k ? step : -step), PO_OK);
    load[k] = po_equilibrium_load(f.e);
  }
  for (int j = 0; j <= NODES; ++j)
    ck_assert_double_eq_tol((at[1][j] - at[0][j]) / (2.0 * step), tangent[j],
                            1e-6 * (1.0 + fabs(tangent[j])));
  ck_assert_double_eq_tol((load[1] - load[0]) / (2.0 * step), rate, 1e-6 * (1.0 + fabs(rate)));
  tear_down(&f);
}

TEST(load_does_not_depend_on_nodes_left_out_of_the_jacobian) {
  double load[2];
  for (int all = 0; all < 2; ++all) {
    fixture f;
    set_up(&f, 2.385, -5.3);
    f.e->gain = all ? INFINITY : f.e->gain; /* nothing is neglected */
    double base[NODES + 1];
    for (int j = 0; j <= NODES; ++j)
      base[j] = f.state[j];
    ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
    ck_assert_int_eq(po_equilibrium_correct(f.e, f.state, base, 0.0), PO_OK);
    load[all] = po_equilibrium_load(f.e);
    ck_assert_int_eq(f.e->active == NODES, all);
    tear_down(&f);
  }
  ck_assert_double_eq_tol(load[0], load[1], 1e-12);
}

TEST(gaps_stay_above_the_singularity_of_the_law) { /* from a bad initial guess */
  fixture f;
  set_up(&f, 3.0, -6.2);
  double base[NODES + 1];
  for (int j = 0; j <= NODES; ++j)
    base[j] = f.state[j];
  for (int j = 0; j < 20; ++j)
    f.state[j] = -0.6;
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
  po_equilibrium_correct(f.e, f.state, base, 0.0);
  for (int j = 0; j < NODES; ++j)
    ck_assert_double_gt(f.state[j], -1.0);
  tear_down(&f);
}

/* Where a gap of the state of the factors is closed so far that the law is 1e9 times as stiff, a
 * gap there hardly changes, whatever its error. */
TEST(a_state_that_does_not_move_is_no_equilibrium) {
  enum { CLOSED = 30 };
  fixture f;
  set_up(&f, 2.385, -5.3);
  double base[NODES + 1], closed[NODES + 1], state[NODES + 1];
  for (int j = 0; j <= NODES; ++j)
    base[j] = f.state[j];
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
  ck_assert_int_eq(po_equilibrium_correct(f.e, f.state, base, 0.0), PO_OK);
  for (int j = 0; j <= NODES; ++j)
    closed[j] = state[j] = f.state[j];
  closed[CLOSED] = -0.9;
  state[CLOSED] += 0.01;
  ck_assert_int_eq(po_equilibrium_factorize(f.e, closed, f.border), PO_OK);
  ck_assert_int_eq(po_equilibrium_correct(f.e, state, f.state, 0.0), PO_NOT_CONVERGED);
  tear_down(&f);
}

/* Computes an equilibrium, its tangent, and the rates of the nodal arclength along the tangent. */
static void solve(fixture *f, double *tangent, double *rate) {
  double base[NODES + 1];
  for (int j = 0; j <= NODES; ++j)
    base[j] = f->state[j];
  ck_assert_int_eq(po_equilibrium_factorize(f->e, f->state, f->border), PO_OK);
  ck_assert_int_eq(po_equilibrium_correct(f->e, f->state, base, 0.0), PO_OK);
  ck_assert_int_eq(po_equilibrium_factorize(f->e, f->state, f->border), PO_OK);
  ck_assert_int_eq(po_equilibrium_tangent(f->e, f->e->precision, tangent), PO_OK);
  po_arclength_rates(PO_ARCLENGTH_NODAL, f->e, f->state, tangent, rate);
}

/* If the border is changed, the old factors give the tangent, scaled to the new border. This takes
 * at most one iteration more than new factors. */
LOOP_TEST(changed_border_gives_the_tangent_of_new_factors, 0, TABOR_COUNT) {
  fixture f;
  set_up(&f, TABORS[_i], -0.385 - 2.0 * TABORS[_i]);
  double tangent[NODES + 1], rate[NODES + 1], border[NODES + 1], changed[NODES + 1];
  solve(&f, tangent, rate);
  po_arclength_border(PO_ARCLENGTH_NODAL, f.e, f.state, rate, border);
  const double scale = po_arclength_along(NODES + 1, border, tangent);
  po_equilibrium_change_border(f.e, border);
  f.e->factorized = true; /* whatever the scale of the border */
  const uint64_t iterations = f.e->tangent_iterations;
  ck_assert_int_eq(po_equilibrium_tangent(f.e, f.e->precision, changed), PO_OK);
  const uint64_t with_changed = f.e->tangent_iterations - iterations;
  for (int j = 0; j <= NODES; ++j)
    ck_assert_double_eq_tol(changed[j] * scale, tangent[j], 1e-11 * (1.0 + fabs(tangent[j])));
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, border), PO_OK);
  ck_assert_int_eq(po_equilibrium_tangent(f.e, f.e->precision, changed), PO_OK);
  ck_assert_uint_le(with_changed, f.e->tangent_iterations - iterations - with_changed + 1);
  tear_down(&f);
}

TEST(factors_are_discarded_if_the_border_reverses) {
  fixture f;
  set_up(&f, 2.385, -5.3);
  double tangent[NODES + 1], rate[NODES + 1];
  solve(&f, tangent, rate);
  po_equilibrium_change_border(f.e, f.border);
  ck_assert(f.e->factorized);
  f.border[NODES] = -1.0;
  po_equilibrium_change_border(f.e, f.border);
  ck_assert(!f.e->factorized);
  tear_down(&f);
}

/* The border is the gradient of direction . coordinates, and the rates are the derivatives of the
 * coordinates. Both are compared with finite differences along a change of the state. */
LOOP_TEST(arclength_derivatives_agree_with_finite_differences, 0, 2) {
  const po_arclength a = _i ? PO_ARCLENGTH_NODAL : PO_ARCLENGTH_GLOBAL;
  const size_t size = po_arclength_size(a, NODES);
  ck_assert_uint_eq(size, _i ? NODES + 1 : PO_ARCLENGTH_GLOBAL_SIZE);
  fixture f;
  set_up(&f, 2.385, 0.613);
  f.e->share = 0.7;
  f.e->load_weight = 0.3;
  const double step = 1e-5;
  double change[NODES + 1], state[NODES + 1], rate[NODES + 1], direction[NODES + 1];
  double border[NODES + 1], at[2][NODES + 1];
  for (int j = 0; j <= NODES; ++j)
    change[j] = sin(0.7 * j) * (1.0 + (j < NODES ? f.state[j] : 0.0));
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j <= NODES; ++j)
      state[j] = f.state[j] + (k ? step : -step) * change[j];
    po_equilibrium_evaluate(f.e, state);
    po_arclength_coordinates(a, f.e, state, at[k]);
  }
  po_equilibrium_evaluate(f.e, f.state);
  po_arclength_rates(a, f.e, f.state, change, rate);
  for (size_t i = 0; i < size; ++i) {
    ck_assert_double_eq_tol((at[1][i] - at[0][i]) / (2.0 * step), rate[i], 1e-7);
    direction[i] = cos(1.3 * (double)i);
  }
  po_arclength_border(a, f.e, f.state, direction, border);
  ck_assert_double_eq_tol(po_arclength_along(NODES + 1, border, change),
                          po_arclength_along(size, direction, rate), 1e-12);
  tear_down(&f);
}
