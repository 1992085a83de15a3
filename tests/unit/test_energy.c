/* The potential energy: its derivative with respect to the approach is the load, along every branch
 * and through its folds. In the rigid limit it has a closed form. */
#include <math.h>
#include <stdlib.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_quadrature.h"
#include "po_rigid.h"
#include "po_rigid_trace.h"
#include "po_scales.h"
#include "run.h"
#include "trace.h"

/* The integral of W d approach along a branch, and the change of energy. */
typedef struct {
  po_branch_point last;
  bool has_last;
  double work, first_energy, last_energy, worst, enough;
  int folds;
} balance;

/* Integral of W d approach along the arc between two points: the trapezium below the chord, and the
 * area between chord and arc, where the arc is a cubic over the chord with the slopes of both ends.
 * The formula uses only the curve in the plane, so it also holds through folds. */
static double integral(const po_branch_point *a, const po_branch_point *b) {
  const double dx = b->approach - a->approach, dy = b->load - a->load, square = dx * dx + dy * dy;
  const double trapezium = 0.5 * (a->load + b->load) * dx;
  const double rise_a =
      (dx * a->load_rate - dy * a->approach_rate) / (dx * a->approach_rate + dy * a->load_rate);
  const double rise_b =
      (dx * b->load_rate - dy * b->approach_rate) / (dx * b->approach_rate + dy * b->load_rate);
  return square > 0.0 ? trapezium + square / 12.0 * (rise_a - rise_b) : 0.0;
}

static bool look(const po_branch_point *p, void *data) {
  balance *b = data;
  if (b->has_last)
    b->work += integral(&b->last, p);
  else
    b->first_energy = p->energy;
  b->last = *p;
  b->has_last = true;
  b->folds += p->kind == PO_POINT_APPROACH_MAX || p->kind == PO_POINT_APPROACH_MIN;
  b->worst = fmax(b->worst, fabs(p->energy - b->first_energy - b->work));
  return p->load > b->enough && p->unstable_modes == 0;
}

/* Scenes with folds: smooth and wavy, on unbounded and bounded surfaces. */
static const po_scene SCENES[] = {{1.0, 0.0, 0.0, 100.0, INFINITY},
                                  {2.385, 0.0, 0.0, 83.0, INFINITY},
                                  {1.3, 0.7, 23.85, 100.0, INFINITY},
                                  {0.67, 1.0, 20.0, 100.0, 100.0}};
enum { SCENE_COUNT = sizeof SCENES / sizeof *SCENES };

/* The largest defect of the balance, and the number of folds, with triangles or rings. */
static balance of_triangles_or_rings(const po_scene *scene, po_scheme scheme, size_t nodes) {
  const po_mesh mesh = {scheme, PO_UNIFORM, nodes, 0.0};
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  ck_assert_int_eq(po_surface_create(scene, &mesh, po_surface_core(scene, NAN), true, &surface),
                   PO_OK);
  ck_assert_int_eq(po_equilibrium_create(scene, surface, &e), PO_OK);
  balance b = {.enough = 0.5};
  po_continuation_options options = po_continuation_options_default();
  options.largest_sagitta = 2e-3;
  options.visit = look;
  options.data = &b;
  ck_assert_int_eq(trace_fixed(e, &options), PO_OK);
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
  return b;
}

LOOP_TEST(energy_derivative_is_the_load_on_panels, 0, SCENE_COUNT) {
  const po_scene *scene = &SCENES[_i];
  const double core = po_surface_core(scene, NAN);
  const double domain = isfinite(scene->outer_radius)
                            ? core
                            : po_averaging_radius(scene, po_averaging_phase(scene, core));
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  ck_assert_int_eq(po_surface_create_panels(scene, domain, 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(scene, panels, &e), PO_OK);
  balance b = {.enough = 0.5};
  po_continuation_options options = po_continuation_options_default();
  options.largest_sagitta = 5e-6;
  options.visit = look;
  options.data = &b;
  po_continuation *continuation = NULL;
  ck_assert_int_eq(po_continuation_create(e, (po_allowance){1e-5, 1e-9}, &options, &continuation),
                   PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  po_continuation_destroy(continuation);
  ck_assert_int_ge(b.folds, 2);
  ck_assert_double_lt(b.worst, 4e-9); /* measured: 2e-11, 3e-11, 3e-10, 1.2e-9 */
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
}

LOOP_TEST(energy_derivative_is_the_load_to_second_order, 0, 2 * SCENE_COUNT) {
  const po_scene *scene = &SCENES[_i / 2];
  const po_scheme scheme = _i % 2 ? PO_RING : PO_TRIANGLE;
  const balance coarse = of_triangles_or_rings(scene, scheme, 151);
  const balance fine = of_triangles_or_rings(scene, scheme, 301);
  ck_assert_int_ge(fine.folds, 2);
  ck_assert_double_lt(fine.worst, 0.02);
  ck_assert_double_eq_tol(log2(coarse.worst / fine.worst), 2.0, 0.2);
}

/* The integral of Eq 23 over the approach is -8/(3x) + 2/(21 x^7) with x = 1 - approach. It is
 * twice the integral of the energy per area over the gap, since r dr = R dH. */
LOOP_TEST(smooth_rigid_energy_agrees_with_its_closed_form, 0, 5) {
  static const double APPROACHES[] = {-30.0, -2.385, 0.0, 0.385, 0.8};
  const po_scene scene = {0.0, 0.0, 0.0, 83.0, INFINITY};
  const double x = 1.0 - APPROACHES[_i];
  const double exact = -8.0 / (3.0 * x) + 2.0 / (21.0 * pow(x, 7.0));
  double energy = NAN;
  ck_assert_int_eq(po_rigid_energy(&scene, APPROACHES[_i], &energy), PO_OK);
  ck_assert_double_eq_tol(energy, exact, 1e-10 * fmax(1.0, fabs(exact)));
}

LOOP_TEST(rigid_energy_derivative_is_the_load, 0, 2) {
  const po_scene scene = {0.0, 0.7, 23.85, 100.0, _i ? 77.0 : (double)INFINITY};
  balance b = {.enough = INFINITY};
  po_continuation_options options = po_continuation_options_default();
  options.largest_sagitta = 1e-5;
  options.end = po_rigid_approach_of_crest(&scene, 4.0);
  options.visit = look;
  options.data = &b;
  ck_assert_int_eq(po_rigid_trace(&scene, -12.0, &options), PO_OK);
  ck_assert_double_lt(b.worst, 1e-8);
}

/* If the Tabor parameter tends to 0, the energy of an elastic sphere tends to the closed form of
 * the rigid sphere. */
LOOP_TEST(elastic_energy_tends_to_rigid, 0, 2) {
  const po_scene scene = {1e-4, 0.0, 0.0, 100.0, INFINITY};
  const balance b = of_triangles_or_rings(&scene, _i ? PO_RING : PO_TRIANGLE, 501);
  const double x = 1.0 - b.last.approach;
  const double exact = -8.0 / (3.0 * x) + 2.0 / (21.0 * pow(x, 7.0));
  ck_assert_double_eq_tol(b.last.energy, exact,
                          2e-4); /* error of the elements and effect of elasticity */
}

/* Far fields of every kind: the traction and the energy fall as powers of the radius that are not
 * whole, or too high for the rule of the panel, or are one power only far beyond the mesh; and the
 * sphere of the paper. */
static const struct {
  const char *profile, *law;
} FAR_FIELDS[] = {{"sphere", "lennard-jones"},         {"sphere", "mie:3.3,9.7"},
                  {"sphere", "mie:2.1,2.3"},           {"power:0.0056,2.25", "lennard-jones"},
                  {"power:0.02,1.7", "mie:4,10"},      {"power:0.02,1.7", "mie:2.5,6.3"},
                  {"power:3e-5,4.5", "mie:3.3,9.7"},   {"power:1e-10,10.5", "lennard-jones"},
                  {"power:1e-10,10.5", "mie:2.5,6.3"}, {"power:1e-20,20", "lennard-jones"},
                  {"power:1e-20,21.7", "mie:2.1,4"},   {"punch:8,40", "mie:3.3,9.7"}};
static const double FAR_APPROACHES[] = {-2.385, -300.0};
enum { FAR_FIELD_COUNT = sizeof FAR_FIELDS / sizeof *FAR_FIELDS };

typedef struct {
  const po_scene *scene;
  double approach;
} initial_gap;

static double energy_over_logarithm(double log_r, void *data) {
  const initial_gap *g = data;
  const double r = exp(log_r), gap = po_initial_gap(g->scene, r);
  return gap < 1e149 ? po_law_energy(&g->scene->law, gap - g->approach) * r * r : 0.0;
}

/* The integral of phi over the initial gap, over the logarithm of the radius from 1e-4 to 1e87, or
 * to the radius at which the gap, which is not let overflow, ends to grow. */
static double energy_of_initial_gap(const po_scene *scene, double approach) {
  initial_gap g = {scene, approach};
  double sum = 0.0;
  for (int k = -10; k < 200; ++k) {
    double part = NAN;
    ck_assert_int_eq(po_integrate(energy_over_logarithm, &g, k, k + 1, 1e-14, 1e-12, &part), PO_OK);
    sum += part;
  }
  return 2.0 / scene->radius * sum;
}

/* The energy of a surface that does not deflect is the integral of the law's energy over the
 * initial gap. On the unbounded half-space the weights of the traction were taken for the energy,
 * too, which falls more slowly: a power profile with n = 10.5 lost -3.4e15 in a jump, with n = 4.5
 * it was off by 3e-3, while dU/d(approach) was the load. */
LOOP_TEST(energy_without_deflection_is_that_of_the_initial_gap, 0, 2 * FAR_FIELD_COUNT) {
  po_scene scene = {1e-9, 0.0, 0.0, 100.0, INFINITY};
  scene.profile = po_profile_sphere();
  ck_assert(po_profile_set(&scene.profile, FAR_FIELDS[_i / 2].profile));
  ck_assert(po_law_set(&scene.law, FAR_FIELDS[_i / 2].law));
  const double approach = FAR_APPROACHES[_i % 2];
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  ck_assert_int_eq(po_surface_create_panels(&scene, po_surface_core(&scene, NAN), 6, &panels),
                   PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&scene, panels, &e), PO_OK);
  double *state = malloc((e->n + 1) * sizeof *state), rigid = NAN;
  for (size_t j = 0; j < e->n; ++j)
    state[j] = e->initial_gap[j] - approach;
  state[e->n] = approach;
  po_equilibrium_evaluate(e, state);
  ck_assert_int_eq(po_rigid_energy(&scene, approach, &rigid), PO_OK);
  const double exact = energy_of_initial_gap(&scene, approach);
  ck_assert_double_lt(exact, 0.0);
  ck_assert_double_eq_tol(rigid, exact, 1e-8 * fmax(1.0, fabs(exact)));
  ck_assert_double_eq_tol(po_equilibrium_energy(e, state), exact, 1e-8 * fmax(1.0, fabs(exact)));
  free(state);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
}
