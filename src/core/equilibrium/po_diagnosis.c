#include "po_diagnosis.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "po_arclength.h"
#include "po_dd.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_memory.h"

/* Change, relative to 1 + H, at which the far part of a state has converged. The iteration
 * contracts by 1e-3 or faster, so that a few rounds suffice. */
static const double SETTLED = 1e-15;
enum { MOST_ROUNDS = 40 };

/* Work space of a diagnosis. */
typedef struct {
  double *influence;                   /* n square */
  double *matrix, *border, *x, *scale; /* (n + 1) square; n + 1 each */
  int *pivots;
  po_dd *traction, *residual; /* n, in twice the precision */
  double *size;               /* n: sum of the moduli of the terms of an equation */
  po_arena arrays;            /* all of these */
} room;

static po_status room_allocate(room *r, const po_equilibrium *e) {
  const size_t n = e->n;
  po_arena *const all = &r->arrays;
  *r = (room){0};
  r->influence = po_arena_reserve(all, n * n, sizeof *r->influence);
  r->matrix = po_arena_reserve(all, (n + 1) * (n + 1), sizeof *r->matrix);
  r->border = po_arena_allocate(all, n + 1, sizeof *r->border);
  r->x = po_arena_allocate(all, n + 1, sizeof *r->x);
  r->scale = po_arena_allocate(all, n + 1, sizeof *r->scale);
  r->pivots = po_arena_allocate(all, n + 1, sizeof *r->pivots);
  r->traction = po_arena_allocate(all, n, sizeof *r->traction);
  r->residual = po_arena_allocate(all, n, sizeof *r->residual);
  r->size = po_arena_allocate(all, n, sizeof *r->size);
  if (all->ran_out) {
    po_arena_free(all);
    return PO_NO_MEMORY;
  }
  po_surface_fill_matrix(e->surface, r->influence);
  return PO_OK;
}

/* p, Eq 16 without its factor mu. Where waves are averaged, the traction of the solver. */
static po_dd traction_at(const po_equilibrium *e, size_t j, double gap) {
  if (j >= e->surface->resolved)
    return po_dd_of(po_law_averaged(&e->scene->law, gap, e->amplitude).traction);
  return po_law_traction(&e->scene->law, gap);
}

/* The initial gap f, Eq 2. */
static po_dd initial_gap_at(const po_equilibrium *e, size_t j) {
  return j < e->surface->resolved ? po_initial_gap_exact(e->scene, e->surface->node[j])
                                  : po_dd_of(e->initial_gap[j]);
}

/* The residual of Eq 15 (see po_equilibrium_residual) in twice the precision, and for each equation
 * the sum of the moduli of its terms. */
static void fill_residual(const po_equilibrium *e, const double *state, room *r) {
  const size_t n = e->n;
  const po_dd tabor = po_dd_of(e->scene->tabor);
  const po_dd coupling =
      po_dd_multiply(tabor, po_dd_sqrt(po_dd_divide(tabor, po_dd_of(e->radius))));
  for (size_t j = 0; j < n; ++j) {
    r->traction[j] = po_dd_multiply(coupling, traction_at(e, j, state[j]));
    const po_dd initial_gap = initial_gap_at(e, j);
    r->residual[j] = po_dd_subtract(initial_gap, po_dd_sum(state[n], state[j]));
    r->size[j] = fabs(initial_gap.high) + fabs(state[n]) + fabs(state[j]);
  }
  for (size_t j = 0; j < n; ++j)
    for (size_t i = 0; i < n; ++i) {
      const po_dd term = po_dd_times(r->traction[j], r->influence[i + n * j]);
      r->residual[i] = po_dd_add(r->residual[i], term);
      r->size[i] += fabs(term.high);
    }
}

/* The Jacobian of Eq 15 at given approach, n square, with equations and unknowns relative to
 * `scale`. Given: traction and slope evaluated. */
static void fill_jacobian(const po_equilibrium *e, const room *r, size_t stride, double *to) {
  const double *scale = r->scale;
  for (size_t j = 0; j < e->n; ++j) {
    const double factor = -e->coupling * e->slope[j] * scale[j];
    for (size_t i = 0; i < e->n; ++i)
      to[i + stride * j] = factor * r->influence[i + e->n * j] / scale[i];
    to[j + stride * j] += 1.0;
  }
}

/* The scaled bordered Jacobian, n + 1 square. The border in r is not scaled. */
static void fill_bordered(const po_equilibrium *e, room *r) {
  const size_t n = e->n, order = n + 1;
  fill_jacobian(e, r, order, r->matrix);
  for (size_t i = 0; i < n; ++i) {
    r->matrix[i + order * n] = 1.0 / r->scale[i];
    r->matrix[n + order * i] = r->border[i] * r->scale[i];
  }
  r->matrix[n + order * n] = r->border[n];
}

/* Factorises the matrix of the given order. Returned: its condition number. */
static double factorize(room *r, size_t order, po_status *status) {
  const double norm = po_linear_norm(order, r->matrix, order);
  *status = po_linear_factorize(order, r->matrix, order, r->pivots);
  return *status ? INFINITY : po_linear_condition(order, r->matrix, order, norm);
}

/* The border of the arclength functional at this state. It needs the tangent, which is computed
 * with the amount of contact as the border: unlike the approach and the load, the amount of contact
 * has no extremum at the special points. Where it has an extremum elsewhere, the tangent is still
 * right, because the solution of a nearly singular system has the direction of its null vector. */
static po_status find_border(const po_equilibrium *e, const double *state, room *r) {
  static const double first[PO_ARCLENGTH_GLOBAL_SIZE] = {[2] = 1.0};
  po_arclength_border(PO_ARCLENGTH_GLOBAL, e, state, first, r->border);
  fill_bordered(e, r);
  po_status status;
  factorize(r, e->n + 1, &status);
  if (status)
    return status;
  memset(r->x, 0, e->n * sizeof *r->x);
  r->x[e->n] = 1.0;
  po_linear_solve(e->n + 1, r->matrix, e->n + 1, r->pivots, r->x);
  for (size_t j = 0; j < e->n; ++j)
    r->x[j] *= r->scale[j];
  double rate[PO_ARCLENGTH_GLOBAL_SIZE];
  po_arclength_rates(PO_ARCLENGTH_GLOBAL, e, state, r->x, rate);
  const double length = sqrt(po_arclength_along(PO_ARCLENGTH_GLOBAL_SIZE, rate, rate));
  for (int k = 0; k < PO_ARCLENGTH_GLOBAL_SIZE; ++k)
    rate[k] /= length;
  po_arclength_border(PO_ARCLENGTH_GLOBAL, e, state, rate, r->border);
  return PO_OK;
}

static void begin(po_equilibrium *e, const double *state, room *r) {
  po_equilibrium_evaluate(e, state);
  for (size_t j = 0; j < e->n; ++j)
    r->scale[j] = po_law_size(&e->scene->law, state[j]);
}

po_status po_diagnosis_complete(po_equilibrium *e, size_t core, double *state) {
  const size_t n = e->n;
  double change = INFINITY;
  for (size_t i = core; i < n; ++i)
    state[i] = e->initial_gap[i] - state[n];
  for (int round = 0; round < MOST_ROUNDS && change > SETTLED && core < n; ++round) {
    po_equilibrium_evaluate(e, state);
    po_surface_apply(e->surface, e->traction, e->deflection);
    change = 0.0;
    for (size_t i = core; i < n; ++i) {
      const double gap = e->initial_gap[i] - state[n] + e->coupling * e->deflection[i];
      change = fmax(change, fabs(gap - state[i]) / po_law_size(&e->scene->law, state[i]));
      state[i] = gap;
    }
  }
  return core == n || change <= SETTLED * 8.0 ? PO_OK : PO_NOT_CONVERGED;
}

po_status po_diagnosis_make(po_equilibrium *e, const double *state, po_diagnosis *made) {
  room r;
  po_status status = room_allocate(&r, e), singular;
  if (status)
    return status;
  *made = (po_diagnosis){.condition = NAN, .bordered_condition = NAN};
  begin(e, state, &r);
  fill_residual(e, state, &r);
  for (size_t i = 0; i < e->n; ++i) {
    made->residual = fmax(made->residual, fabs(r.residual[i].high) / r.scale[i]);
    made->rounding = fmax(made->rounding, 0.5 * DBL_EPSILON * r.size[i] / r.scale[i]);
  }
  fill_jacobian(e, &r, e->n, r.matrix);
  made->condition = factorize(&r, e->n, &singular); /* may be singular at a fold */
  status = find_border(e, state, &r);
  if (!status) {
    fill_bordered(e, &r);
    made->bordered_condition = factorize(&r, e->n + 1, &status);
  }
  po_arena_free(&r.arrays);
  return status;
}

po_sensitivity po_sensitivity_sources(const po_scene *scene, double r, bool resolved,
                                      double deflection) {
  po_sensitivity s = {.tabor = 1.5 * deflection, .radius = -0.5 * deflection};
  if (po_profile_is_sphere(&scene->profile))
    s.radius -= 0.5 * r * r / scene->radius;
  if (!po_scene_is_wavy(scene))
    return s;
  const double waves = r / scene->wavelength, half = po_sinpi(waves);
  s.amplitude = scene->amplitude * (resolved ? 2.0 * half * half : 1.0);
  s.wavelength = resolved ? -2.0 * M_PI * waves * scene->amplitude * po_sinpi(2.0 * waves) : 0.0;
  return s;
}

po_status po_sensitivity_make(po_equilibrium *e, const double *state, po_sensitivity *made) {
  const size_t n = e->n;
  room r;
  po_status status = room_allocate(&r, e);
  if (status)
    return status;
  *made = (po_sensitivity){0};
  begin(e, state, &r);
  fill_residual(e, state, &r);
  fill_jacobian(e, &r, n, r.matrix);
  factorize(&r, n, &status);
  for (size_t j = 0; j < n; ++j) /* gradient of the load with respect to H / scale */
    r.x[j] = 2.0 / e->radius * e->surface->weight[j] * e->slope[j] * r.scale[j];
  if (!status)
    po_linear_solve_transposed(n, r.matrix, n, r.pivots, r.x);
  po_surface_apply(e->surface, e->traction, e->deflection);
  for (size_t j = 0; !status && j < n; ++j) {
    const double adjoint = r.x[j] / r.scale[j];
    const po_sensitivity s = po_sensitivity_sources(
        e->scene, e->surface->node[j], j < e->surface->resolved, e->coupling * e->deflection[j]);
    made->tabor += adjoint * s.tabor;
    made->amplitude += adjoint * s.amplitude;
    made->wavelength += adjoint * s.wavelength;
    made->radius += adjoint * s.radius;
    made->residual += adjoint * r.residual[j].high;
    made->rounding += fabs(adjoint) * 0.5 * DBL_EPSILON * r.size[j];
  }
  made->radius -= po_equilibrium_load(e); /* the 1/R of Eq 17 */
  po_arena_free(&r.arrays);
  return status;
}
