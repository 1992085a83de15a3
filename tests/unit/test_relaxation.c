/* The states after jumps: a relaxation of the surface in time, against the path along the branch.
 *
 * The deflection u relaxes against a local damping: du/dt = p(H) - (coupling G)^-1 u, at fixed
 * approach. A step of the implicit Euler method, multiplied by coupling G =: K, is
 *   K (u' - u)/tau + u' - K p(shape - approach + u') = 0,
 * solved by Newton's method with the Jacobian 1 + K/tau - K diag(dp/dH). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_solve.h"
#include "po_surface.h"
#include "run.h"

enum { MOST_STEPS = 3000, MOST_NEWTON = 30 };

/* Limits of the gap H: the update at which Newton's method stops; the rate of change below which
 * the surface is at rest; the largest change in one step, so that a step cannot lead to the basin
 * of another equilibrium. */
static const double SOLVED = 1e-11, AT_REST = 1e-8, FARTHEST = 0.1;
/* Distance beyond a fold, in approach, at which there is no equilibrium nearby. */
static const double BEYOND = 5e-4;
/* Change of the load over this distance if the jump ends near another fold. */
static const double CLOSE = 2e-3;
/* Error of the load at the preload, which is a point of the curve: three times the error that
 * AT_REST leaves. */
static const double AT_PRELOAD = 1e-7;
/* Discretisation error of the energy balance of a small jump on triangles. */
static const double ENERGY_OF_TRIANGLES = 2e-5;
/* Approach at the start, where there is only one equilibrium. */
static const double FAR = -12.0;

static const po_law LAW = {0}; /* of the paper */

typedef struct {
  const po_surface *surface;
  double coupling, radius;
  double *shape, *gap, *next, *jacobian, *change;
  po_law_value *law;
  int *pivots;
  size_t backwards; /* gaps that opened in loading or closed in unloading */
} relaxation;

static void evaluate(relaxation *r, double approach, double tau) {
  const size_t n = r->surface->n;
  for (size_t i = 0; i < n; ++i) {
    r->law[i] = po_law_at(&LAW, r->next[i]);
    r->change[i] = -(r->next[i] + approach - r->shape[i]);
  }
  for (size_t j = 0; j < n; ++j) {
    const double *column = r->surface->influence + n * j;
    const double force = (r->next[j] - r->gap[j]) / tau - r->law[j].traction;
    const double stiffness = 1.0 / tau - r->law[j].slope;
    for (size_t i = 0; i < n; ++i) {
      r->change[i] -= r->coupling * column[i] * force;
      r->jacobian[i + n * j] = r->coupling * column[i] * stiffness + (i == j);
    }
  }
}

/* Computes the gaps after a time step tau. Returns whether Newton's method converged. */
static bool step(relaxation *r, double approach, double tau) {
  const size_t n = r->surface->n;
  memcpy(r->next, r->gap, n * sizeof *r->gap);
  for (int k = 0; k < MOST_NEWTON; ++k) {
    evaluate(r, approach, tau);
    if (po_linear_factorize(n, r->jacobian, n, r->pivots))
      return false;
    po_linear_solve(n, r->jacobian, n, r->pivots, r->change);
    double part = 1.0, update = 0.0; /* 1 + H is at most halved */
    for (size_t j = 0; j < n; ++j) {
      update = fmax(update, fabs(r->change[j]));
      part = fmin(part, 0.5 * (1.0 + r->next[j]) / fabs(r->change[j]));
    }
    po_linear_add(n, part, r->change, r->next);
    if (update < SOLVED)
      return true;
  }
  return false;
}

static double load_of(const relaxation *r) {
  double sum = 0.0;
  for (size_t j = 0; j < r->surface->n; ++j)
    sum += r->surface->weight[j] * po_law_at(&LAW, r->gap[j]).traction;
  return 2.0 / r->radius * sum;
}

/* Relaxes the surface at a given approach until it is at rest. Returns the load. */
static double relax(relaxation *r, double approach, bool loading) {
  const size_t n = r->surface->n;
  double tau = 0.05, moved = INFINITY;
  int steps = 0;
  for (; steps < MOST_STEPS && moved > AT_REST * tau; ++steps) {
    const bool found = step(r, approach, tau);
    moved = 0.0;
    for (size_t j = 0; j < n; ++j)
      moved = fmax(moved, fabs(r->next[j] - r->gap[j]));
    if (!found || moved > FARTHEST) {
      tau *= 0.5;
      moved = INFINITY;
      continue;
    }
    for (size_t j = 0; j < n; ++j)
      r->backwards += (loading ? 1.0 : -1.0) * (r->next[j] - r->gap[j]) > 1e-9;
    memcpy(r->gap, r->next, n * sizeof *r->gap);
    tau *= 1.3;
  }
  ck_assert_int_lt(steps, MOST_STEPS);
  return load_of(r);
}

static relaxation begin(const po_request *request, po_surface *surface, double approach) {
  const po_scene *scene = &request->scene;
  const size_t n = surface->n;
  relaxation r = {.surface = surface,
                  .coupling = scene->tabor * sqrt(scene->tabor / scene->radius),
                  .radius = scene->radius,
                  .shape = calloc(n, sizeof(double)),
                  .gap = calloc(n, sizeof(double)),
                  .next = calloc(n, sizeof(double)),
                  .jacobian = calloc(n * n, sizeof(double)),
                  .change = calloc(n, sizeof(double)),
                  .law = calloc(n, sizeof(po_law_value)),
                  .pivots = calloc(n, sizeof(int))};
  for (size_t j = 0; j < n; ++j) {
    r.shape[j] = po_initial_gap(scene, surface->node[j]);
    r.gap[j] = r.shape[j] - approach;
  }
  return r;
}

static void end(relaxation *r) {
  free(r->shape);
  free(r->gap);
  free(r->next);
  free(r->jacobian);
  free(r->change);
  free(r->law);
  free(r->pivots);
}

/* Scenes with several stable equilibria at the approach of a jump: their contact edges are two
 * waves apart, or the groove inside the contact is open or closed. */
static const struct {
  po_scene scene;
  double preload;
} LOOPS[] = {{{4.0, 0.4, 10.0, 100.0, 60.0}, 4.0}, {{4.0, 3.0, 10.0, 100.0, 70.0}, 14.0}};

LOOP_TEST(relaxation_after_a_jump_agrees_with_the_path, 0, 2) {
  po_request request = po_request_default();
  request.scene = LOOPS[_i].scene;
  request.mesh = (po_mesh){PO_TRIANGLE, PO_UNIFORM, 141, 0.0};
  request.want = PO_WANT_HYSTERESIS;
  request.preload.approach = LOOPS[_i].preload;
  po_result o;
  po_surface *surface = NULL;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_int_eq(po_surface_create(&request.scene, &request.mesh, NAN, true, &surface), PO_OK);
  const po_loop *loop = &o.hysteresis.of[PO_AT_APPROACH];
  ck_assert_uint_ge(loop->loading_jumps, 3); /* the coarse mesh adds some */
  relaxation r = begin(&request, surface, FAR);
  for (size_t k = 0; k < loop->jump_count; ++k) {
    const po_jump *jump = &loop->jumps[k];
    const double beyond = jump->before.approach + (jump->loading ? BEYOND : -BEYOND);
    if (k == loop->loading_jumps)
      ck_assert_double_eq_tol(relax(&r, loop->preload.approach, true), loop->preload.load,
                              AT_PRELOAD);
    ck_assert_double_eq_tol(relax(&r, beyond, jump->loading), jump->after.load, CLOSE);
    ck_assert_double_gt(jump->energy_lost, -ENERGY_OF_TRIANGLES);
  }
  ck_assert_uint_eq(r.backwards, 0); /* in loading gaps only close, in unloading they only open */
  end(&r);
  po_surface_destroy(surface);
  po_result_clear(&o);
}
