#include "po_refine.h"

#include <math.h>

#include "po_hermite.h"
#include "po_initial_gap.h"

enum { MOST_SOLVES = 5 };

/* Panels with an excess below this part of the largest are not halved. */
static const double CONTRIBUTES = 0.01;

/* Greatest number of wavelengths on a panel. The Legendre coefficients of a longer panel do not
 * show its error. */
static const double TELLING_WAVES = 2.5;

/* The secant method ends when its next step is shorter than PO_LOCATED, or than this part of its
 * last step. */
static const double SMALL_STEP = 1e-3;
/* First step of the secant method along the arclength functional if the slope is unknown. Narrow
 * minima of the load are a hundred times as wide. */
static const double TRIAL_STEP = 1e-5;
/* Factors of the stated error of a special point: of the change on a finer mesh, and of the
 * precision of Newton's method. */
static const double SAFETY = 3.0, FLOOR = 10.0;

/* Splits panels until none spans more than TELLING_WAVES wavelengths. If that takes too many
 * panels, none is split. */
static void split_waves(const po_resolution *r, po_panels *panels) {
  const po_scene *scene = r->e->scene;
  const po_panels before = *panels;
  const double longest = TELLING_WAVES * po_initial_gap_detail(scene);
  bool any = isfinite(longest);
  while (any) {
    bool split[PO_MOST_PANELS];
    any = false;
    for (size_t k = 0; k < panels->count; ++k) {
      const double length = r->domain * po_panel_size(panels->panel[k]);
      split[k] = length > longest;
      any = any || split[k];
    }
    if (any && !po_panels_split(panels, split)) {
      *panels = before;
      return;
    }
  }
}

/* The finer mesh: panels of p that contribute to the error are halved, panels of several waves are
 * split. */
static bool finer_panels(const po_resolution *r, const po_solution *p, po_panels *panels) {
  double excess[PO_MOST_PANELS], largest = 0.0;
  bool split[PO_MOST_PANELS];
  po_resolution_excesses(r, &p->panels, p->state, excess);
  for (size_t k = 0; k < p->panels.count; ++k)
    largest = fmax(largest, excess[k]);
  for (size_t k = 0; k < p->panels.count; ++k)
    split[k] = excess[k] > CONTRIBUTES * largest;
  *panels = p->panels;
  if (!po_panels_split(panels, split))
    return false;
  split_waves(r, panels);
  return true;
}

/* By differences on the cubic of the interval. */
double po_refine_slope(const po_event *ev, double cosine) {
  const po_sample *a = &ev->low, *b = &ev->high;
  const double h = b->at - a->at, x = ev->root - a->at, by = 0.01 * h;
  double rate[2];
  for (int k = 0; k < 2; ++k)
    rate[k] = po_hermite_rate(a->value[ev->of], a->rate[ev->of], b->value[ev->of], b->rate[ev->of],
                              x + (k ? by : -by), h);
  return (rate[1] - rate[0]) / (2.0 * by) * cosine * cosine;
}

/* Approach and load at the root of the rate between two samples. */
static void values_at_root(const po_sample *a, const po_sample *b, po_event_kind of,
                           double value[2]) {
  const double h = b->at - a->at, x = -a->rate[of] * h / (b->rate[of] - a->rate[of]);
  for (int q = 0; q < 2; ++q)
    value[q] = po_hermite_value(a->value[q], a->rate[q], b->value[q], b->rate[q], x, h);
}

po_status po_refine_locate(po_corrector *c, const po_solution *from, po_event_kind of,
                           double *slope, po_solution *out, double value[2]) {
  double at = 0.0;
  po_sample last = {.at = NAN}, s;
  for (int k = 0; k < MOST_SOLVES; ++k) {
    const po_status status = po_corrector_solve(c, from, at, k > 0, c->e->precision, out);
    if (status)
      return status;
    s = po_corrector_sample(from, out);
    for (int q = 0; q < 2; ++q)
      value[q] = s.value[q];
    if (k > 0) {
      *slope = (s.rate[of] - last.rate[of]) / (s.at - last.at);
      values_at_root(&last, &s, of, value);
    }
    const double step = isnan(*slope) ? TRIAL_STEP : -s.rate[of] / *slope;
    if (!isfinite(step))
      return PO_NOT_CONVERGED;
    if (fabs(step) < PO_LOCATED || (k > 0 && fabs(step) < SMALL_STEP * fabs(s.at - last.at)))
      return PO_OK;
    at = s.at + step;
    last = s;
    for (size_t j = 0; j <= out->n; ++j)
      c->guess[j] = out->state[j] + step / po_solution_cosine(from, out) * out->tangent[j];
  }
  return PO_NOT_CONVERGED;
}

double po_refine_error(double precision, double change, double value) {
  return SAFETY * fabs(change) + FLOOR * precision * (1.0 + fabs(value));
}

/* Solves a special point on a finer mesh. Returned: the solution in finer, its approach and load in
 * value, and the errors in r. */
static po_status solve_finer(po_corrector *c, const po_resolution *resolution,
                             const po_refinement *how, po_refined *r, po_solution *finer,
                             double value[2]) {
  po_panels panels;
  if (!finer_panels(resolution, r->point, &panels))
    return po_fail(PO_OUT_OF_NODES, "a finer mesh needs more panels than are possible");
  po_status status = po_corrector_mesh(c, &panels);
  if (status)
    return status;
  po_corrector_guess(c, r->point);
  double slope = how->slope;
  status = po_refine_locate(c, r->point, how->of, &slope, finer, value);
  for (int q = 0; q < 2 && !status; ++q)
    r->error[q] = po_refine_error(c->e->precision, value[q] - r->value[q], r->value[q]);
  r->finer = status ? NULL : finer;
  return status;
}

po_status po_refine(po_corrector *c, const po_resolution *resolution, const po_refinement *how,
                    po_refined *r) {
  po_refined finer = *r;
  po_status status = solve_finer(c, resolution, how, r, how->spare[0], finer.value);
  finer.point = how->spare[0];
  if (status || r->error[1] <= how->enough)
    return status;
  double value[2];
  if (!solve_finer(c, resolution, how, &finer, how->spare[1], value) &&
      finer.error[1] < r->error[1])
    *r = finer;
  return PO_OK;
}
