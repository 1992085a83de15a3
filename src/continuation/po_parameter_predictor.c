#include "po_parameter_predictor.h"

#include <math.h>

#include "po_initial_gap.h"

/* The weights of the marks in Lagrange's polynomial at a parameter. */
static void weigh(po_predictor *f, double at) {
  for (size_t i = 0; i < f->count; ++i) {
    f->weight[i] = 1.0;
    for (size_t k = 0; k < f->count; ++k)
      if (k != i)
        f->weight[i] *= (at - f->mark[k]->at) / (f->mark[i]->at - f->mark[k]->at);
  }
}

/* Predicts the shifts of the contact edges of the latest mark: of all, or of the outermost only.
 * Returned: whether the coordinates can move by them. */
static bool move(po_predictor *f, const po_predictor_point *const *mark, size_t count, bool all,
                 double at) {
  const po_moving_edges *latest = &mark[0]->point.edges;
  *f = (po_predictor){.edges = *latest};
  if (!all && latest->count > 0) {
    f->edges.count = 1;
    f->edges.at[0] = latest->at[latest->count - 1];
  }
  for (size_t i = 0; i < count; ++i) {
    const po_moving_edges *edges = &mark[i]->point.edges;
    if (all ? edges->all != latest->all : (edges->count == 0) != (latest->count == 0))
      break;
    double *back = f->back[f->count];
    for (size_t k = 0; k < f->edges.count; ++k)
      back[k] = edges->at[edges->count - f->edges.count + k] - f->edges.at[k];
    if (!po_edge_may_relate(&f->edges, back))
      break;
    f->mark[f->count++] = mark[i];
  }
  weigh(f, at);
  for (size_t i = 0; i < f->count; ++i)
    for (size_t k = 0; k < f->edges.count; ++k)
      f->shift[k] += f->weight[i] * f->back[i][k];
  return f->count == count && po_edge_may_move(&f->edges, f->shift);
}

bool po_predictor_make(const po_predictor_point *const *mark, size_t count, double at,
                       po_predictor *f) {
  return move(f, mark, count, true, at) || move(f, mark, count, false, at);
}

void po_predictor_still(const po_predictor_point *const *mark, size_t count, double at,
                        po_predictor *f) {
  *f = (po_predictor){.count = count};
  for (size_t i = 0; i < count; ++i)
    f->mark[i] = mark[i];
  weigh(f, at);
}

/* The gap of a mark; outside its domain the undeformed gap. */
static double gap_of(const po_predictor_point *m, double r, size_t *panel) {
  if (r < m->domain)
    return po_solution_gap_near(&m->point, &m->scene, m->domain, r, panel);
  return po_initial_gap(&m->scene, r) - m->point.state[m->point.n];
}

double po_predictor_gap(void *predictor, double r) {
  po_predictor *f = predictor;
  const po_edge_place origin = po_edge_origin(&f->edges, f->shift, r, f->edge);
  f->edge = origin.outer;
  double gap = 0.0;
  for (size_t i = 0; i < f->count; ++i)
    gap += f->weight[i] *
           gap_of(f->mark[i], origin.r + po_edge_displacement(&origin, f->back[i]), &f->panel[i]);
  return po_law_expected_gap(&f->mark[0]->scene.law, gap);
}

void po_predictor_state(po_predictor *f, const po_equilibrium *e, size_t core, double *state) {
  const size_t n = e->n;
  for (size_t j = 0; j < core; ++j)
    state[j] = po_predictor_gap(f, e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back) { /* from the approach inwards */
    double value = back > 0 ? e->initial_gap[n - back] : 0.0;
    for (size_t i = 0; i < f->count; ++i) {
      const po_solution *p = &f->mark[i]->point;
      value += f->weight[i] * (back > 0 ? p->deflection[p->n - back] : p->state[p->n]);
    }
    state[n - back] = value;
  }
}

double po_predictor_error(po_predictor *f, const po_solution *solved) {
  double largest = 0.0;
  for (size_t j = 0; j < solved->core; ++j) {
    const double expected = po_predictor_gap(f, solved->node[j]);
    largest = fmax(largest, fabs(solved->state[j] - expected) /
                                po_law_size(&f->mark[0]->scene.law, solved->state[j]));
  }
  return largest;
}
