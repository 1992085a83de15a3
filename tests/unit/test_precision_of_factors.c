/* The precision of the factors: those of dense matrices are in double precision where the gain of
 * rounding asks for it, and not otherwise; those on panels hold the largest interactions. */
#include <math.h>
#include <string.h>

#include "po_equilibrium.h"
#include "po_initial_gap.h"
#include "po_surface.h"
#include "run.h"

enum { LEVEL = 4, PANELS = 1 << LEVEL, NODES = PANELS * PO_TABLE_ORDER };

typedef struct {
  po_scene scene;
  po_surface *surface;
  po_equilibrium *e;
  double state[NODES + 1], border[NODES + 1];
} fixture;

static const double APPROACH = -1.0;

/* A sphere, not yet in contact, on equal panels of a cut surface, or on as many equal elements. */
static void set_up(fixture *f, double tabor, double outer_radius, bool on_panels) {
  const po_mesh mesh = {PO_TRIANGLE, PO_UNIFORM, NODES, 0.0};
  memset(f, 0, sizeof *f);
  f->scene = (po_scene){.tabor = tabor, .radius = 100.0, .outer_radius = outer_radius};
  const po_status made = on_panels
                             ? po_surface_create_panels(&f->scene, outer_radius, LEVEL, &f->surface)
                             : po_surface_create(&f->scene, &mesh, outer_radius, true, &f->surface);
  ck_assert_int_eq(made, PO_OK);
  const po_surface *s = f->surface;
  ck_assert_uint_eq(s->n, NODES);
  ck_assert_int_eq(po_equilibrium_create(&f->scene, f->surface, &f->e), PO_OK);
  for (size_t j = 0; j < NODES; ++j)
    f->state[j] = po_initial_gap(&f->scene, s->node[j]) - APPROACH;
  f->state[NODES] = APPROACH;
  f->border[NODES] = 1.0;
}

static void tear_down(fixture *f) {
  po_equilibrium_destroy(f->e);
  po_surface_destroy(f->surface);
}

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
  ck_assert(!f->e->factors.is_double);
  ck_assert_int_eq(po_equilibrium_tangent(f->e, f->e->precision, tangent), PO_OK);
}

/* A border nearly perpendicular to the tangent amplifies rounding: from a gain of 30 on, the next
 * factors are in double precision. At this small Tabor parameter there is one equilibrium. */
TEST(gain_of_rounding_asks_for_double) {
  static const double PART = 0.1, BELOW = 20.0, ABOVE = 45.0;
  fixture f;
  double tangent[NODES + 1];
  set_up(&f, 0.5, 40.0, false);
  solve_state(&f, tangent);
  factorize(&f, tangent, PART);
  const double part = PART * f.e->gain;
  factorize(&f, tangent, part / BELOW);
  ck_assert_double_gt(f.e->gain, 15.0);
  factorize(&f, tangent, part / BELOW);
  ck_assert(!f.e->factors.is_double);
  ck_assert(!po_equilibrium_is_coarse(f.e));
  factorize(&f, tangent, part / ABOVE);
  ck_assert_double_gt(f.e->gain, 35.0);
  ck_assert_double_lt(f.e->gain, 50.0);
  ck_assert(!f.e->factors.is_double);
  ck_assert(po_equilibrium_is_coarse(f.e));
  factorize(&f, tangent, part / ABOVE);
  ck_assert(f.e->factors.is_double);
  ck_assert(!po_equilibrium_is_coarse(f.e));
  tear_down(&f);
}

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
 * would miss it by a factor of 600. */
LOOP_TEST(factors_hold_large_interactions, 0, 2) {
  static const double CONTACT = 687.5, END = 1000.0, APART = 100.0, TABOR[] = {1.0, 1e4};
  fixture f;
  set_up(&f, TABOR[_i], END, true);
  for (size_t j = 0; j < NODES; ++j)
    f.state[j] = f.e->surface->node[j] < CONTACT ? 0.0 : APART;
  ck_assert_int_eq(po_equilibrium_factorize(f.e, f.state, f.border), PO_OK);
  ck_assert_double_lt(error_of_smooth_change(&f, CONTACT), 0.1);
  tear_down(&f);
}
