#include "po_forecast.h"

#include <math.h>

#include "po_shape.h"

/* Slope of the displacement of the coordinates to the place expected, and to a mark. */
static const double GREATEST_STRAIN = 0.5, GREATEST_STRAIN_BACK = 0.9;
/* Gaps of a forecast are taken as no smaller. */
static const double CLOSEST = -0.9;

/* Lagrange's weights of the marks at a parameter. */
static void weigh(po_forecast *f, double at) {
  for (size_t i = 0; i < f->count; ++i) {
    f->weight[i] = 1.0;
    for (size_t k = 0; k < f->count; ++k)
      if (k != i)
        f->weight[i] *= (at - f->mark[k]->at) / (f->mark[i]->at - f->mark[k]->at);
  }
}

/* Moves the fronts of the latest mark, all or the outermost alone. */
static bool move(po_forecast *f, const po_waymark *const *mark, size_t count, bool all, double at) {
  const po_fronts *latest = &mark[0]->point.fronts;
  *f = (po_forecast){.fronts = *latest};
  if (!all && latest->count > 0) {
    f->fronts.count = 1;
    f->fronts.at[0] = latest->at[latest->count - 1];
  }
  for (size_t i = 0; i < count; ++i) {
    const po_fronts *fronts = &mark[i]->point.fronts;
    if (all ? fronts->all != latest->all : (fronts->count == 0) != (latest->count == 0))
      break;
    double *back = f->back[f->count];
    for (size_t k = 0; k < f->fronts.count; ++k)
      back[k] = fronts->at[fronts->count - f->fronts.count + k] - f->fronts.at[k];
    if (po_front_strain(&f->fronts, back) > GREATEST_STRAIN_BACK)
      break;
    f->mark[f->count++] = mark[i];
  }
  weigh(f, at);
  for (size_t i = 0; i < f->count; ++i)
    for (size_t k = 0; k < f->fronts.count; ++k)
      f->shift[k] += f->weight[i] * f->back[i][k];
  return f->count == count && po_front_strain(&f->fronts, f->shift) < GREATEST_STRAIN;
}

bool po_forecast_make(const po_waymark *const *mark, size_t count, double at, po_forecast *f) {
  return move(f, mark, count, true, at) || move(f, mark, count, false, at);
}

void po_forecast_still(const po_waymark *const *mark, size_t count, double at, po_forecast *f) {
  *f = (po_forecast){.count = count};
  for (size_t i = 0; i < count; ++i)
    f->mark[i] = mark[i];
  weigh(f, at);
}

/* The gap of a mark; undeformed outside its root. */
static double gap_of(const po_waymark *m, double r) {
  if (r < m->root)
    return po_track_value_at(&m->point, &m->scene, m->root, r).gap;
  return po_shape(&m->scene, r) - m->point.state[m->point.n];
}

double po_forecast_gap(void *forecast, double r) {
  const po_forecast *f = forecast;
  const po_fronts *fronts = &f->fronts;
  const double origin = po_front_origin(fronts, f->shift, r);
  double gap = 0.0;
  for (size_t i = 0; i < f->count; ++i)
    gap += f->weight[i] *
           gap_of(f->mark[i], origin + po_front_displacement(fronts, f->back[i], origin));
  return fmax(gap, CLOSEST);
}

void po_forecast_state(po_forecast *f, const po_equilibrium *e, size_t core, double *state) {
  const size_t n = e->n;
  for (size_t j = 0; j < core; ++j)
    state[j] = po_forecast_gap(f, e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back) { /* from the approach inwards */
    double value = back > 0 ? e->shape[n - back] : 0.0;
    for (size_t i = 0; i < f->count; ++i) {
      const po_track_point *p = &f->mark[i]->point;
      value += f->weight[i] * (back > 0 ? p->deflection[p->n - back] : p->state[p->n]);
    }
    state[n - back] = value;
  }
}

double po_forecast_error(po_forecast *f, const po_track_point *solved) {
  double largest = 0.0;
  for (size_t j = 0; j < solved->leaves.count * PO_TABLE_ORDER; ++j) {
    const double expected = po_forecast_gap(f, solved->node[j]);
    largest = fmax(largest, fabs(solved->state[j] - expected) / (1.0 + solved->state[j]));
  }
  return largest;
}
