#include "po_refine.h"

#include <limits.h>
#include <math.h>

#include "po_initial_gap.h"
#include "po_margins.h"
#include "po_profile.h"

/* Secant steps for a special point on the finer mesh. */
enum { MOST_SOLVES = 5 };

/* On the finer mesh a panel is halved if its estimated error (po_resolution_excess_of) is at least
 * this part of the largest of all panels. With 1e-3, the change of the value of one fold in 200 was
 * a quarter of its error, since the estimate of a panel may be small by chance. If that mesh takes
 * too many panels or nodes, the part is multiplied by COARSER until it exceeds MOST_CONTRIBUTES. */
static const double CONTRIBUTES = 1e-4, COARSER = 10.0, MOST_CONTRIBUTES = 0.1;

/* The secant method ends when its next step is shorter than PO_LOCATED, or than this at the first
 * step, whose slope may be wrong by some percent. */
static const double AT_ROOT = 1e-11;

/* First step of the secant method along the arclength functional if the slope is unknown. Narrow
 * minima of the load are a hundred times as wide. */
static const double TRIAL_STEP = 1e-5;

/* Factor of the precision of Newton's method in the stated error of a special point. */
static const double FLOOR = 10.0;

/* Part of the change of the other quantity of a fold, approach or load, that is added to the error
 * of one: the change of one may be near zero by chance. In 235 scenes that was so for one fold of
 * 742; the changes of approach and load are usually equal within a factor 50. */
static const double OF_OTHER = 0.02;

/* A panel that is longer than a wave. The Legendre coefficients of such a panel do not show its
 * error; with 2.5 wavelengths on a panel, halving it does not either. */
static bool spans_waves(void *equilibrium, po_panel panel) {
  const po_equilibrium *e = equilibrium;
  return e->surface->core_radius * po_panel_size(panel) > po_initial_gap_detail(e->scene);
}

/* Halvings of the panel with the kink of the profile. The error of that panel goes as the square of
 * its length, not as a high power, so one halving leaves too much of it. Without it the force of a
 * truncated sphere with three waves was off by 1.4 times what is stated. */
enum { KINK_HALVINGS = 4 };

static bool has_kink(void *equilibrium, po_panel panel) {
  const po_equilibrium *e = equilibrium;
  const double domain = e->surface->core_radius;
  return po_profile_has_kink_between(&e->scene->profile, domain * po_panel_begin(panel),
                                     domain * po_panel_end(panel));
}

/* The panels of p, with those halved whose excess is above a part of the largest. The last panel of
 * a cut surface is always halved: the deflection has an infinite slope at the end of the traction,
 * which the excess does not show. */
static bool halve_excess(const po_resolution *r, const po_solution *p, double part,
                         po_panels *panels) {
  const double least = part * po_resolution_excess(r, p->panels, p->state);
  po_panels_copy(p->panels, panels);
  for (size_t k = 0; k < panels->count; ++k)
    panels->marked[k] = po_resolution_excess_of(r, panels, p->state, k) > least;
  if (isfinite(r->e->scene->outer_radius))
    panels->marked[panels->count - 1] = true;
  return po_panels_split(panels);
}

/* The finer mesh: panels that contribute to the error are halved, and panels of several waves are
 * split, unless that takes too many panels. */
static bool finer_panels(po_corrector *c, const po_solution *p, double part, po_panels *panels) {
  if (!halve_excess(&c->resolution, p, part, panels))
    return false;
  if (!po_panels_refine(panels, INT_MAX, spans_waves, c->e))
    halve_excess(&c->resolution, p, part, panels);
  po_panels_refine(panels, KINK_HALVINGS, has_kink, c->e);
  return true;
}

/* Where rounding and the ripple of the mesh disturb the rate, the root is extrapolated: if that
 * changes the extremal value by less than PO_LOCATED, relative to 1 + its modulus, from at most
 * FARTHEST along the arclength functional. */
static const double FARTHEST = 1e-3;

/* Moves a solution along its tangent, by a step of the arclength functional of `from`. */
static void move(po_corrector *c, const po_solution *from, double step, po_solution *p) {
  const double by = step / po_solution_cosine(from, p);
  for (size_t j = 0; j <= p->n; ++j)
    p->state[j] += by * p->tangent[j];
  po_equilibrium_evaluate(c->e, p->state);
  if (c->e->narrow) /* the rates hardly change, and would be less precise */
    po_solution_take_state(p, c->e);
  else
    po_solution_finish(p, c->e);
}

po_status po_refine_locate(po_corrector *c, const po_solution *from, double at, po_event_kind of,
                           double *slope, po_solution *out, double value[2]) {
  po_sample last = {.at = NAN};
  for (int k = 0; k < MOST_SOLVES; ++k) {
    const po_status status = po_corrector_solve(c, from, at, k > 0, c->e->precision, out);
    if (status)
      return status;
    const po_sample s = po_corrector_sample(from, out);
    const double before = k > 0 ? fabs(s.at - last.at) : 0.0;
    if (before > PO_LOCATED) /* a shorter secant is inaccurate because of rounding */
      *slope = (s.rate[of] - last.rate[of]) / (s.at - last.at);
    const double step = isnan(*slope) ? TRIAL_STEP : -s.rate[of] / *slope;
    if (!isfinite(step))
      return PO_NOT_CONVERGED;
    if (fabs(step) < (k > 0 ? PO_LOCATED : AT_ROOT)) {
      move(c, from, step, out);
      value[0] = out->state[out->n];
      value[1] = out->load;
      return PO_OK;
    }
    at = s.at + step;
    last = s;
    po_corrector_guess_near(c, out, step / po_solution_cosine(from, out));
  }
  return PO_NOT_CONVERGED;
}

/* The values at the root from the solution at that place, with the given slope. */
static po_status extrapolate(po_corrector *c, const po_solution *from, double at, po_event_kind of,
                             double slope, po_solution *out, double value[2]) {
  po_corrector_guess(c, from);
  const po_status status = po_corrector_solve(c, from, at, false, c->e->precision, out);
  if (status)
    return status;
  const po_sample s = po_corrector_sample(from, out);
  const double left = -s.rate[of] / slope;
  if (!(fabs(left) < FARTHEST && po_special_point_is_close(&s, of, left, PO_LOCATED)))
    return PO_NOT_CONVERGED;
  for (int q = 0; q < 2; ++q)
    value[q] = s.value[q] + (q == (int)of ? 0.5 : 1.0) * s.rate[q] * left;
  return PO_OK;
}

double po_refine_error(double precision, double change, double value) {
  return PO_SAFETY * fabs(change) + FLOOR * precision * (1.0 + fabs(value));
}

/* Corrects the values of a special point from the place at which it was located to the root of its
 * rate. */
static void place_at_root(const po_refinement *how, po_refined *r) {
  const double rate[2] = {r->point->tangent[r->point->n], r->point->load_rate};
  const double step = -rate[how->of] / how->slope;
  for (int q = 0; q < 2 && fabs(step) < PO_LOCATED; ++q)
    r->value[q] += step * rate[q];
}

/* Solves a special point on the current mesh, which is finer than its own: by a search that begins
 * at a value of the arclength functional, or extrapolated from there. */
static po_status solve_from(po_corrector *c, const po_refinement *how, const po_solution *point,
                            double at, po_solution *finer, double value[2]) {
  po_corrector_guess(c, point);
  double slope = how->slope;
  const po_status status = po_refine_locate(c, point, at, how->of, &slope, finer, value);
  return status == PO_NOT_CONVERGED ? extrapolate(c, point, at, how->of, how->slope, finer, value)
                                    : status;
}

/* Solves a special point on a finer mesh. Returned: the solution in finer, its approach and load in
 * value. A second search begins where the functional is for the interpolated state of the point. At
 * a fold beside a groove of a wavy cone that is 1e-3 off, for which the contact edge moves by so
 * many of its widths that Newton's method fails. */
static po_status solve_on(po_corrector *c, const po_panels *panels, const po_refinement *how,
                          const po_solution *point, po_solution *finer, double value[2]) {
  po_status status = po_corrector_mesh(c, panels);
  if (!status)
    status = solve_from(c, how, point, 0.0, finer, value);
  if (status != PO_NOT_CONVERGED)
    return status;
  po_corrector_guess(c, point);
  const double at = po_corrector_place_of_guess(c, point);
  return solve_from(c, how, point, at, finer, value);
}

/* Solves for the special point on the finer mesh for the estimate, to the precision of rounding. If
 * that mesh takes too many panels, fewer of them are halved. Returned: also the errors, in r. */
static po_status solve_finer(po_corrector *c, const po_refinement *how, po_refined *r,
                             po_solution *finer, double value[2]) {
  const double precision = c->e->precision;
  po_status status = PO_OUT_OF_NODES;
  c->e->precision = PO_FINEST_PRECISION;
  for (double part = CONTRIBUTES; status == PO_OUT_OF_NODES && part <= MOST_CONTRIBUTES;
       part *= COARSER) {
    po_panels *const panels = c->e->surface->draft;
    c->trouble = PO_OK;
    status = finer_panels(c, r->point, part, panels)
                 ? solve_on(c, panels, how, r->point, finer, value)
                 : po_fail(PO_OUT_OF_NODES, "a finer mesh needs more panels than are possible");
    if (c->trouble)
      status = c->trouble;
  }
  c->e->precision = precision;
  const double reached = c->e->reached;
  for (int q = 0; q < 2 && !status; ++q) {
    r->error[q] = po_refine_error(reached, value[q] - r->value[q], r->value[q]);
    if (how->of == PO_OF_APPROACH)
      r->error[q] += OF_OTHER * fabs(value[1 - q] - r->value[1 - q]);
  }
  r->finer = status ? NULL : finer;
  return status;
}

/* The errors, by one finer mesh; and by a second one if the first does not suffice. */
static po_status estimate(po_corrector *c, const po_refinement *how, po_refined *r) {
  place_at_root(how, r);
  po_refined finer = *r;
  po_status status = solve_finer(c, how, r, how->spare[0], finer.value);
  finer.point = how->spare[0];
  if (status || r->error[1] <= how->enough)
    return status;
  double value[2];
  if (!solve_finer(c, how, &finer, how->spare[1], value) && finer.error[1] < r->error[1])
    *r = finer;
  return PO_OK;
}

/* The orientation is not required: compressed factors of a stiff scene may have the wrong sign, and
 * a solution on another strand of the branch would show as a large change. */
po_status po_refine(po_corrector *c, const po_refinement *how, po_refined *r) {
  po_panels *const before = how->spare[0]->wanted;
  po_panels_copy(po_surface_panels(c->e->surface), before);
  const int direction = c->direction;
  c->direction = 0;
  const po_status status = estimate(c, how, r);
  const po_status trouble = c->trouble;
  c->direction = direction;
  po_corrector_mesh(c, before);
  c->trouble = trouble;
  return status;
}
