#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_continuation_internal.h"
#include "po_initial_gap.h"
#include "po_memory.h"

/* Length of the first step. The lengths of the following steps are set by the error of the
 * predictions. */
static const double FIRST_STEP = 0.05;

/* equilibrium_feedback of the initial gap below which Newton's method converges from it. */
static const double SAFE_FEEDBACK = 0.25;

enum { MOST_DOUBLINGS = 40 };

const double PO_STEP_TANGENT = 1e-6;

po_continuation_options po_continuation_options_default(void) {
  return (po_continuation_options){.station = {NAN, NAN},
                                   .station_load = NAN,
                                   .end = NAN,
                                   .begin = NAN,
                                   .largest_sagitta = INFINITY,
                                   .largest_miss = INFINITY,
                                   .sharpness = INFINITY,
                                   .most_points = 30000};
}

/* The largest row sum of coupling |G_ij| |dp/dH_j| at the state last evaluated. If it is below 1,
 * Eq 15 at given approach is a contraction near that state and the equilibrium there is unique.
 * The coefficients of the influence matrix are positive, apart from some of neighbouring panels
 * that do not matter for a sum over a row. */
static double equilibrium_feedback(po_equilibrium *e) {
  double largest = 0.0;
  for (size_t j = 0; j < e->n; ++j)
    e->scratch[j] = fabs(e->slope[j]);
  po_surface_apply(e->surface, e->scratch, e->right);
  for (size_t i = 0; i < e->n; ++i)
    largest = fmax(largest, e->right[i]);
  return e->coupling * largest;
}

static double least_gap(const po_equilibrium *e, const double *gap) {
  double least = INFINITY;
  for (size_t j = 0; j < e->n; ++j)
    least = fmin(least, gap[j]);
  return least;
}

/* Whether the law softens at every gap of a state. */
static bool softens(const po_equilibrium *e, const double *gap) {
  return least_gap(e, gap) > po_law_numbers_of(&e->scene->law)->peak_gap;
}

/* The approach, eps, at which a trace may start: the first of -2, -4, -8, ... at which
 * equilibrium_feedback of the initial gap less the approach is below 1/4, so that the equilibrium
 * is unique and Newton's method finds it; and at which the law softens, so that no minimum of the
 * load is farther out. The latter says more for a law of long range: its feedback can be small at
 * every gap. */
static double continuation_start(po_equilibrium *e) {
  double approach = -2.0;
  for (int k = 0; k < MOST_DOUBLINGS; ++k, approach *= 2.0) {
    for (size_t j = 0; j < e->n; ++j)
      e->right[j] = e->initial_gap[j] - approach;
    po_equilibrium_evaluate(e, e->right);
    if (softens(e, e->right) && equilibrium_feedback(e) < SAFE_FEEDBACK)
      break;
  }
  return approach;
}

/* The weights of the arclength functional are changed if others by this factor would suit. */
static const double OTHER_WEIGHTS = 2.0;

/* Lets the arclength functional follow the outermost contact edge. If there are
 * several edges and linear systems are solved by GMRES, approach and load keep their weight: then
 * Newton's method converges from predictions that are less close, and the amount of contact alone
 * turns back, in a corner that is a millionth of a step wide, wherever the edges of several annuli
 * move in opposite directions. With that weight a smooth sphere of mu = 10,000, which takes 630
 * points, had not ended after 1,204. */
static void reweigh(po_continuation *t) {
  po_equilibrium *e = t->c.e;
  const size_t edges = t->current.edges.count;
  const double suits = edges > 0 ? po_arclength_share(e, t->current.edges.at[edges - 1]) : 1.0;
  const double change = suits / t->edge_share;
  if (!on_panels(t))
    return;
  if (change >= OTHER_WEIGHTS || change <= 1.0 / OTHER_WEIGHTS)
    t->edge_share = suits;
  e->narrow = t->edge_share < PO_ARCLENGTH_NARROW;
  const double share = e->by_krylov && edges > 1 ? 1.0 : t->edge_share, factor = share / e->share;
  if (share == e->share)
    return;
  e->share = share;
  e->factorized = false; /* their border has the weights before */
  po_solution_reweigh(&t->current, factor);
  po_solution_reweigh(&t->previous, factor);
}

static void shift(po_continuation *t) {
  po_solution_exchange(&t->previous, &t->current);
  po_solution_exchange(&t->current, &t->next);
  t->has_previous = true;
  reweigh(t);
}

typedef struct {
  const po_scene *scene;
  double approach;
} undeformed;

static double undeformed_gap(void *data, double r) {
  const undeformed *u = data;
  return po_initial_gap(u->scene, r) - u->approach;
}

static uint32_t finest_level(const po_panels *panels) {
  uint32_t finest = 0;
  for (size_t k = 0; k < panels->count; ++k)
    finest = panels->panel[k].level > finest ? panels->panel[k].level : finest;
  return finest;
}

/* Makes panels that resolve the traction of the undeformed gap the current mesh. On a surface that
 * is cut far out the first panels are many times as long as the attraction is wide. */
static po_status mesh_undeformed(po_continuation *t, double approach) {
  undeformed u = {t->c.e->scene, approach};
  const po_gap_field field = {undeformed_gap, &u};
  po_panels *const panels = t->c.e->surface->draft;
  po_panels_copy(po_surface_panels(t->c.e->surface), panels);
  po_status status;
  uint32_t before;
  do {
    before = finest_level(panels);
    status = po_resolution_panels(&t->c.resolution, &field, panels);
  } while (!status && finest_level(panels) >= before + PO_MOST_HALVINGS);
  return status ? status : po_corrector_mesh(&t->c, panels);
}

/* The approach of the first equilibrium, at most `begin` (may be NaN), on a mesh that resolves its
 * undeformed gap. Only such a mesh shows the feedback of a law of short range at a sharp tip. */
static po_status mesh_start(po_continuation *t, double begin, double *approach) {
  *approach = fmin(continuation_start(t->c.e), begin);
  while (on_panels(t)) {
    const po_status status = mesh_undeformed(t, *approach);
    const double seen = continuation_start(t->c.e);
    if (status || !(seen < *approach))
      return status;
    *approach = seen;
  }
  return PO_OK;
}

/* Newton's method at given approach from the undeformed gap. */
static po_status solve_start(po_continuation *t, double approach) {
  po_equilibrium *e = t->c.e;
  po_solution *p = &t->current;
  for (size_t j = 0; j < e->n; ++j)
    t->c.guess[j] = p->state[j] = e->initial_gap[j] - approach;
  t->c.guess[e->n] = p->state[e->n] = approach;
  memset(t->c.border, 0, (e->n + 1) * sizeof *t->c.border);
  t->c.border[e->n] = 1.0;
  const po_status status = po_equilibrium_factorize(e, p->state, t->c.border);
  return status ? status : po_equilibrium_correct(e, p->state, t->c.guess, 0.0);
}

/* The first equilibrium and the direction of the branch there. */
static po_status start(po_continuation *t) {
  po_equilibrium *e = t->c.e;
  po_solution *p = &t->current;
  double approach, begin = t->options.begin;
  po_status status;
  int doublings = 0;
  do {
    status = mesh_start(t, begin, &approach);
    if (status)
      return status;
    status = solve_start(t, approach);
    begin = 2.0 * approach;
  } while (!status && !softens(e, p->state) && ++doublings < MOST_DOUBLINGS);
  if (!status)
    status = po_equilibrium_tangent(e, PO_STEP_TANGENT, p->tangent);
  if (status == PO_INTERRUPTED || status == PO_OUT_OF_TIME)
    return status;
  if (status)
    return po_fail(status, "no equilibrium was found at the start of the trace, approach %g",
                   approach * po_scene_length_unit(e->scene));
  po_solution_finish(p, e);
  e->factorized = false; /* their border is the approach, not the arclength functional */
  return po_corrector_want_mesh(&t->c, p);
}

/* Whether the branch has returned to its beginning: the approach is below the first one, and the
 * bodies are nowhere as near as they were there. The least gap alone does not show it: it is that
 * of the nodes, and at the tip of a cone it changes with the mesh by more than in a step. The
 * approach alone does not either: adhesion may hold the bodies together beyond the first one. */
static bool is_back(const po_continuation *t) {
  return po_solution_approach(&t->next) < t->first_approach &&
         least_gap(t->c.e, t->next.state) > t->farthest;
}

/* Traces from the current point until the visitor ends the trace, or the branch returns to its
 * beginning. */
static po_status go_on(po_continuation *t) {
  po_status status = PO_OK;
  po_continuation_visit(t, &t->current, PO_POINT_STEP);
  while (!status && !t->ended) {
    status = po_continuation_advance(t);
    const bool returned = !status && is_back(t);
    if (returned && !t->back)
      status = po_fail(PO_NOT_CONVERGED, "the branch returned to its beginning, at approach %.6g",
                       po_solution_approach(&t->next) * po_scene_length_unit(t->c.e->scene));
    if (!status)
      po_continuation_visit_step(t);
    if (!status && ++t->points > t->options.most_points)
      status =
          po_fail(PO_TOO_MANY_POINTS, "more than %zu points, the last at approach %.6g, load %.6g",
                  t->options.most_points,
                  po_solution_approach(&t->next) * po_scene_length_unit(t->c.e->scene),
                  t->next.load * po_scene_load_unit(t->c.e->scene));
    t->ended = t->ended || returned;
    shift(t);
  }
  return status;
}

po_status po_continuation_run(po_continuation *t) {
  const po_status status = start(t);
  if (status)
    return status;
  t->first_approach = po_solution_approach(&t->current);
  t->farthest = least_gap(t->c.e, t->current.state);
  return go_on(t);
}

/* Steps and meshes are those of the reverse trace: of the forward trace only the last point, and
 * approach and least gap of the first point are used. */
po_status po_continuation_reverse(po_continuation *t, po_branch_visit visit_back, void *data) {
  po_solution_turn(&t->current);
  t->c.direction = -t->c.direction;
  t->c.e->factorized = false; /* their border has the forward direction */
  t->c.trouble = PO_OK;
  t->options.visit = visit_back;
  t->options.data = data;
  t->options.station[0] = t->options.station[1] = t->options.end = NAN;
  t->options.station_load = NAN;
  t->step = FIRST_STEP;
  t->error_factor = NAN;
  t->has_previous = t->ended = false;
  t->back = true;
  t->points = 0;
  return go_on(t);
}

po_status po_continuation_create(po_equilibrium *equilibrium, po_allowance allowed,
                                 const po_continuation_options *options,
                                 po_continuation **continuation) {
  po_continuation *t = *continuation = po_allocate(1, sizeof *t);
  if (!t)
    return PO_NO_MEMORY;
  t->options = *options;
  t->step = FIRST_STEP;
  t->edge_share = 1.0;
  t->error_factor = NAN;
  const size_t capacity = equilibrium->surface->capacity;
  po_status status = po_corrector_allocate(&t->c, equilibrium, allowed);
  po_solution *const points[] = {&t->previous, &t->current, &t->next, &t->inner, &t->spare};
  for (size_t k = 0; k < sizeof points / sizeof *points && !status; ++k)
    status = po_solution_allocate(points[k], capacity, &t->c.arrays);
  for (size_t k = 0; k < PO_MOST_EVENTS && !status; ++k)
    status = po_solution_allocate(&t->at_event[k], capacity, &t->c.arrays);
  if (!status)
    return PO_OK;
  po_continuation_destroy(t);
  *continuation = NULL;
  return status;
}

void po_continuation_destroy(po_continuation *t) {
  if (!t)
    return;
  po_arena_free(&t->c.arrays);
  free(t);
}
