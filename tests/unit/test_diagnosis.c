/* Diagnostics: sensitivities against finite differences of complete solves, residuals and condition
 * numbers in cases where they are known. Diagnostics do not change the results. */
#include <math.h>

#include "po_diagnosis.h"
#include "po_equilibrium.h"
#include "po_law.h"
#include "po_result_rows.h"
#include "po_solve.h"
#include "po_surface.h"
#include "run.h"

static po_request awkward(void) {
  po_request request = po_request_default();
  request.scene = (po_scene){.tabor = 1.385,
                             .amplitude = 0.37,
                             .wavelength = 11.3,
                             .radius = 87.0,
                             .outer_radius = INFINITY};
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = 1e-9;
  return request;
}

static double force(const po_request *request) {
  po_result o;
  ck_assert_int_eq(po_solve(request, &o), PO_OK);
  const double value = o.pull_off.force;
  po_result_clear(&o);
  return value;
}

/* d ln(force) / d ln(key) by central differences, whose error is of order (1e-3)^2. */
static double difference(po_request *request, double *key) {
  const double is = *key, part = 1e-3;
  *key = is * (1.0 + part);
  const double more = force(request);
  *key = is * (1.0 - part);
  const double less = force(request);
  *key = is;
  return log(more / less) / log((1.0 + part) / (1.0 - part));
}

TEST(sensitivities_agree_with_finite_differences) {
  po_request request = awkward();
  request.want = PO_WANT_DIAGNOSTICS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_sensitivity by = o.diagnostics.force;
  ck_assert(o.diagnostics.has_sensitivity);
  request.want = 0;
  ck_assert_double_eq_tol(by.tabor, difference(&request, &request.scene.tabor), 1e-5);
  ck_assert_double_eq_tol(by.amplitude, difference(&request, &request.scene.amplitude), 1e-5);
  ck_assert_double_eq_tol(by.wavelength, difference(&request, &request.scene.wavelength), 1e-5);
  ck_assert_double_eq_tol(by.radius, difference(&request, &request.scene.radius), 1e-5);
  /* The problem stays the same if radii are multiplied by k and the radius of the sphere by k^2. */
  ck_assert_double_eq_tol(by.wavelength + 2.0 * by.radius, 0.0, 1e-6);
  po_result_clear(&o);
}

/* The sensitivities of the default output, without an adjoint solve, and those of the diagnostics.
 */
static void compare_with_adjoint_solve(po_request request) {
  po_result plain, diagnosed;
  request.want = 0;
  ck_assert_int_eq(po_solve(&request, &plain), PO_OK);
  request.want = PO_WANT_DIAGNOSTICS;
  ck_assert_int_eq(po_solve(&request, &diagnosed), PO_OK);
  ck_assert(plain.pull_off.has_sensitivity && diagnosed.diagnostics.has_sensitivity);
  const po_sensitivity *a = &plain.pull_off.sensitivity, *b = &diagnosed.diagnostics.force;
  ck_assert_double_eq_tol(a->tabor, b->tabor, 1e-6);
  ck_assert_double_eq_tol(a->amplitude, b->amplitude, 1e-6);
  ck_assert_double_eq_tol(a->wavelength, b->wavelength, 1e-6);
  ck_assert_double_eq_tol(a->radius, b->radius, 1e-6);
  ck_assert_double_gt(fabs(a->tabor), 1e-3);
  po_result_clear(&plain);
  po_result_clear(&diagnosed);
}

LOOP_TEST(the_tangent_gives_the_sensitivities_without_a_solve, 0, 5) {
  static const struct {
    double tabor, amplitude, wavelength, outer_radius;
    const char *law;
  } SCENES[] = {{0.2, 0.0, 0.0, INFINITY, "lennard-jones"},
                {1.385, 0.37, 11.3, INFINITY, "lennard-jones"},
                {2.3, 0.8, 14.0, 87.0, "lennard-jones"},
                {4.7, 0.0, 0.0, 87.0, "morse:1.3"},
                {3.1, 0.5, 17.0, INFINITY, "mie:4,10"}};
  po_request request = awkward();
  request.mesh.tolerance = 1e-6;
  request.scene.tabor = SCENES[_i].tabor;
  request.scene.amplitude = SCENES[_i].amplitude;
  request.scene.wavelength = SCENES[_i].wavelength;
  request.scene.outer_radius = SCENES[_i].outer_radius;
  ck_assert(po_law_set(&request.scene.law, SCENES[_i].law));
  compare_with_adjoint_solve(request);
}

TEST(residuals_are_small_and_the_force_keeps_its_digits) {
  po_request request = awkward();
  request.mesh.tolerance = 1e-6;
  request.want = PO_WANT_DIAGNOSTICS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_diagnostics *d = &o.diagnostics;
  ck_assert_uint_ge(d->state_count, 3);
  ck_assert_uint_eq(d->undiagnosed, 0);
  ck_assert_double_gt(d->residual, 0.0);
  ck_assert_double_lt(d->residual, 1e-10); /* Newton's method stops at 1e-4 of the tolerance */
  ck_assert_uint_eq(d->moved.solves, 8);
  ck_assert_uint_eq(d->moved.failed, 0);
  ck_assert_double_lt(d->moved.change, 1e-12);
  ck_assert_double_lt(fabs(d->force.residual), 1e-10);
  for (size_t k = 0; k < d->state_count; ++k) {
    ck_assert_double_ge(d->states[k].found.condition, 1.0);
    if (d->states[k].at == PO_KEPT_FOLD) /* singular without the border */
      ck_assert_double_gt(d->states[k].found.condition,
                          1e4 * d->states[k].found.bordered_condition);
  }
  po_result_clear(&o);
}

TEST(diagnostics_do_not_change_the_result) {
  po_request request = awkward();
  request.mesh.tolerance = 1e-5;
  po_result plain, diagnosed;
  ck_assert_int_eq(po_solve(&request, &plain), PO_OK);
  request.want = PO_WANT_DIAGNOSTICS;
  ck_assert_int_eq(po_solve(&request, &diagnosed), PO_OK);
  ck_assert_ptr_null(plain.diagnostics.states);
  ck_assert_double_eq(plain.pull_off.force, diagnosed.pull_off.force);
  ck_assert_uint_eq(plain.work.points, diagnosed.work.points);
  ck_assert_uint_eq(plain.work.newton_iterations, diagnosed.work.newton_iterations);
  ck_assert_uint_eq(plain.work.factorizations, diagnosed.work.factorizations);
  po_result_clear(&plain);
  po_result_clear(&diagnosed);
}

/* A sphere so stiff that the tractions do not deform it, on 41 nodes. */
static void create_stiff(po_surface **surface, po_equilibrium **e) {
  static const po_scene STIFF = {.tabor = 1e-8, .radius = 87.0, .outer_radius = 87.0};
  const po_mesh mesh = {.scheme = PO_TRIANGLE, .grading = PO_UNIFORM, .nodes = 41};
  ck_assert_int_eq(po_surface_create(&STIFF, &mesh, 87.0, true, surface), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&STIFF, *surface, e), PO_OK);
}

/* The solution of the stiff sphere is the undeformed gap, and its Jacobian is the unit matrix. A
 * gap that is changed by a known fraction of 1 + H has this fraction as its residual. */
TEST(residual_and_condition_of_a_stiff_sphere_are_exact) {
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  create_stiff(&surface, &e);
  double state[42];
  for (size_t j = 0; j < 41; ++j)
    state[j] = e->initial_gap[j] + 0.3;
  state[41] = -0.3;
  po_diagnosis d;
  ck_assert_int_eq(po_diagnosis_make(e, state, &d), PO_OK);
  ck_assert_double_lt(d.residual, 1e-10);
  ck_assert_double_eq_tol(d.condition, 1.0, 1e-9);
  state[7] += 0.0123;
  ck_assert_int_eq(po_diagnosis_make(e, state, &d), PO_OK);
  ck_assert_double_eq_tol(d.residual, 0.0123 / (1.0 + state[7]), 1e-10);
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
}

/* The 1-norm of the matrix [I u; v w], where I is the unit matrix of size n. */
static double bordered_norm(size_t n, const double *u, const double *v, double w) {
  double last = fabs(w), largest = 0.0;
  for (size_t j = 0; j < n; ++j) {
    largest = fmax(largest, 1.0 + fabs(v[j]));
    last += fabs(u[j]);
  }
  return fmax(largest, last);
}

/* The 1-norm of its inverse, [I + u v/s, -u/s; -v/s, 1/s] with s = w - v.u. */
static double inverse_norm(size_t n, const double *u, const double *v, double w) {
  double s = w, sum = 0.0, largest = 0.0;
  for (size_t j = 0; j < n; ++j) {
    s -= v[j] * u[j];
    sum += fabs(u[j]);
  }
  for (size_t j = 0; j < n; ++j)
    largest = fmax(largest, fabs(1.0 + u[j] * v[j] / s) + (sum - fabs(u[j])) * fabs(v[j] / s) +
                                fabs(v[j] / s));
  return fmax(largest, (sum + 1.0) / fabs(s));
}

/* If tractions do not deform the sphere, an approach larger by 1 reduces every gap by 1. So the
 * tangent of the branch is known, and with it the border and the inverse of the bordered Jacobian
 * in closed form. */
LOOP_TEST(bordered_condition_of_a_stiff_sphere_is_exact, 0, 4) {
  static const double APPROACH[] = {-2.385, -0.3, 0.0, 0.385};
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  create_stiff(&surface, &e);
  double state[42], u[41], v[41], load = 0.0, contact = 0.0;
  state[41] = APPROACH[_i];
  for (size_t j = 0; j < 41; ++j) {
    state[j] = e->initial_gap[j] - APPROACH[_i];
    load -= 2.0 / 87.0 * surface->weight[j] * po_law_at(&e->scene->law, state[j]).slope;
    contact += 2.0 * surface->length[j] / pow(1.0 + state[j], 3.0) / sqrt(2.0 * 87.0);
  }
  const double approach = 0.5 / (1.0 + 1e-8), length = hypot(hypot(approach, load), contact);
  for (size_t j = 0; j < 41; ++j) {
    const double scale = 1.0 + state[j];
    u[j] = 1.0 / scale;
    v[j] = load / length * 2.0 / 87.0 * surface->weight[j] *
               po_law_at(&e->scene->law, state[j]).slope * scale -
           contact / length * 2.0 * surface->length[j] / pow(scale, 2.0) / sqrt(2.0 * 87.0);
  }
  const double w = approach / length * approach;
  const double condition = bordered_norm(41, u, v, w) * inverse_norm(41, u, v, w);
  po_diagnosis d;
  ck_assert_int_eq(po_diagnosis_make(e, state, &d), PO_OK);
  ck_assert_double_eq_tol(d.bordered_condition, condition, 1e-6 * condition);
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
}

static double digits_kept(double change) {
  po_result o = po_result_none();
  o.diagnostics.moved = (po_moved){.solves = 1, .change = change};
  return po_block_number(&PO_ALL_ROWS, &o, "diagnostics.moved.digits_kept");
}

TEST(number_of_digits_follows_from_the_relative_change) {
  ck_assert_double_eq_tol(digits_kept(2.5e-9), 8.602, 1e-3);
  ck_assert_double_eq_tol(digits_kept(0.0), 15.95, 0.01);
  ck_assert_double_nan(digits_kept((double)NAN));
}
