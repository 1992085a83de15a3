#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_profile.h"
#include "po_track_parts.h"

static const double FIRST_STEP = 0.05;

const double PO_STEP_TANGENT = 1e-6;

double po_track_approach(const po_track_point *p) {
  return p->state[p->n];
}

static void shift(po_tracker *t) {
  const po_track_point oldest = t->previous;
  t->previous = t->current;
  t->current = t->next;
  t->next = oldest;
  t->has_previous = true;
}

typedef struct {
  const po_scene *scene;
  double approach;
} undeformed;

static double undeformed_gap(void *data, double r) {
  const undeformed *u = data;
  return po_profile(u->scene, r) - u->approach;
}

/* The first equilibrium: Newton at fixed approach from the undeformed gap. */
static po_status start(po_tracker *t) {
  po_equilibrium *e = t->c.e;
  undeformed u = {e->scene, fmin(po_branch_start(e), t->options.begin)}; /* begin may be NaN */
  const po_gap_field field = {undeformed_gap, &u};
  po_panels panels = *po_adaptive_panels(t->c.adaptive);
  po_status status = po_resolution_panels(&t->resolution, &field, &panels);
  if (!status)
    status = po_corrector_mesh(&t->c, &panels);
  if (status)
    return status;
  po_track_point *p = &t->current;
  for (size_t j = 0; j < e->n; ++j)
    t->c.guess[j] = p->state[j] = e->shape[j] - u.approach;
  t->c.guess[e->n] = p->state[e->n] = u.approach;
  memset(t->c.border, 0, (e->n + 1) * sizeof *t->c.border);
  t->c.border[e->n] = 1.0;
  status = po_equilibrium_factorize(e, p->state, t->c.border);
  if (!status)
    status = po_equilibrium_correct(e, p->state, t->c.guess, 0.0);
  if (!status)
    status = po_equilibrium_tangent(e, PO_STEP_TANGENT, p->tangent);
  if (status)
    return po_fail(status, "no equilibrium found far out, at approach %g", u.approach);
  po_track_point_finish(p, e, t->c.adaptive);
  e->factorized = false; /* its border is not of the arclength functional */
  return po_track_want_mesh(t, p);
}

static double least_gap(const po_track_point *p) {
  double least = INFINITY;
  for (size_t j = 0; j < p->n; ++j)
    least = fmin(least, p->state[j]);
  return least;
}

/* On from the current point until the visitor ends it, or the branch is back where it began. */
static po_status go_on(po_tracker *t) {
  po_status status = PO_OK;
  po_track_visit(t, &t->current, PO_POINT_STEP);
  while (!status && !t->ended) {
    status = po_track_advance(t);
    const bool returned = !status && least_gap(&t->next) > t->farthest;
    if (returned && !t->back)
      status = po_fail(PO_NOT_CONVERGED, "the branch led back to where it began, at approach %.6g",
                       po_track_approach(&t->next));
    if (!status)
      po_track_visit_step(t);
    if (!status && ++t->points > t->options.most_points)
      status =
          po_fail(PO_TOO_MANY_POINTS, "more than %zu points, the last at approach %.6g, load %.6g",
                  t->options.most_points, po_track_approach(&t->next), t->next.load);
    t->ended = t->ended || returned;
    shift(t);
  }
  return status;
}

po_status po_track_onwards(po_tracker *t) {
  const po_status status = start(t);
  if (status)
    return status;
  t->farthest = least_gap(&t->current);
  return go_on(t);
}

/* The steps are found anew, and nothing is kept of the way so far but where it began. */
po_status po_track_back(po_tracker *t, po_branch_visit visit_back, void *data) {
  po_track_point_turn(&t->current);
  t->c.direction = -t->c.direction;
  t->c.e->factorized = false; /* its border leads the other way */
  t->c.trouble = PO_OK;
  t->options.visit = visit_back;
  t->options.data = data;
  t->options.station[0] = t->options.station[1] = t->options.end = NAN;
  t->step = FIRST_STEP;
  t->has_previous = t->ended = false;
  t->back = true;
  t->points = 0;
  return go_on(t);
}

static size_t points_of(po_tracker *t, po_track_point **points) {
  po_track_point *const own[] = {&t->previous, &t->current, &t->next, &t->inner, &t->spare};
  size_t count = 0;
  for (size_t k = 0; k < sizeof own / sizeof *own; ++k)
    points[count++] = own[k];
  for (size_t k = 0; k < PO_MOST_EVENTS; ++k)
    points[count++] = &t->at_event[k];
  return count;
}

enum { MOST_POINTS_KEPT = 5 + PO_MOST_EVENTS };

po_status po_track_create(po_equilibrium *equilibrium, po_adaptive *adaptive, po_allowance allowed,
                          const po_branch_options *options, po_tracker **tracker) {
  po_tracker *t = *tracker = po_allocate(1, sizeof *t);
  if (!t)
    return PO_NO_MEMORY;
  t->options = *options;
  t->step = FIRST_STEP;
  po_track_point *points[MOST_POINTS_KEPT];
  const size_t count = points_of(t, points), capacity = po_adaptive_capacity(adaptive);
  po_status status = po_corrector_allocate(&t->c, equilibrium, adaptive);
  for (size_t k = 0; k < count && !status; ++k)
    status = po_track_point_allocate(points[k], capacity);
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  po_legendre_fill(rule, &t->legendre);
  t->resolution = (po_resolution){equilibrium, rule, &t->legendre, t->c.domain, allowed};
  if (!status)
    return PO_OK;
  po_track_destroy(t);
  *tracker = NULL;
  return status;
}

void po_track_destroy(po_tracker *t) {
  if (!t)
    return;
  po_track_point *points[MOST_POINTS_KEPT];
  const size_t count = points_of(t, points);
  for (size_t k = 0; k < count; ++k)
    po_track_point_free(points[k]);
  po_corrector_free(&t->c);
  free(t);
}
