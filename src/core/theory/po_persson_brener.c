#include "po_persson_brener.h"

#include <math.h>

#include "po_elementary.h"
#include "po_jkr_profile.h"
#include "po_maugis.h"
#include "po_root.h"
#include "po_theory_forces.h"

po_edge_law po_persson_brener_at(const po_creep_terms *terms, double x) {
  double sum = 0.0;
  for (size_t m = 0; m < terms->count; ++m) {
    const double y = x / terms->term[m].time;
    sum += terms->term[m].weight / (sqrt(1.0 + y * y) + y); /* S without cancellation */
  }
  const double work = 1.0 / (1.0 - sum);
  return (po_edge_law){work, work / (2.0 * M_PI * x)};
}

/* The length l, eps. Where the stress K/sqrt(2 pi l) of a crack between a rigid and an elastic
 * body, K^2 = 2 E* w, is the greatest tension s of the law, l = 1/(pi c s^2). OF_LENGTH times that
 * agrees best with the solver: of 3, 5 and 8, 8 is within 5 % at mu = 3 and 10, k = 0.1, over five
 * decades of the speed; with 3 the theory is up to 30 % above. */
static const double OF_LENGTH = 8.0;

static double length_of_edge(const po_scene *scene) {
  const double tension = po_maugis_matched_tension(scene);
  return OF_LENGTH / (M_PI * po_scene_coupling(scene) * tension * tension);
}

typedef struct {
  const po_scene *scene;
  const po_creep_terms *terms;
  double speed;  /* of the base */
  double length; /* of the edge */
} edge;

/* A state at a contact radius, without `edge_speed`. */
static po_rate_theory state_at(const edge *e, double a, double work) {
  const po_contact relaxed = po_jkr_profile_at(e->scene, a);
  const double c = po_scene_coupling(e->scene),
               pull = (sqrt(work) - 1.0) * sqrt(2.0 * M_PI * a * c);
  return (po_rate_theory){.force = -relaxed.load + 2.0 * a * pull / (M_PI * c * e->scene->radius),
                          .approach = relaxed.approach - pull,
                          .contact_radius = a,
                          .work = work};
}

/* Bounds of ln x beyond which Gamma is w/k and w to rounding. */
static const double LEAST_X = -60.0, GREATEST_X = 60.0;

/* An implicit step of the edge to the radius a, by da > 0, from the approach `before`. */
typedef struct {
  const edge *e;
  double a, da, before;
} edge_step;

/* D - D_before + V da/v at ln x, with which it rises. */
static double excess_at(double ln_x, const void *data) {
  const edge_step *s = data;
  const po_edge_law law = po_persson_brener_at(s->e->terms, po_exp(ln_x));
  return state_at(s->e, s->a, law.work).approach - s->before +
         s->e->speed * s->da / (law.speed * s->e->length);
}

/* Returned: the state after a step; with Gamma = w/k where the edge is unstable, and with w where
 * it has not to move. */
static po_rate_theory step(const edge *e, double a, double da, double before) {
  const edge_step s = {e, a, da, before};
  double ln_x = po_root(excess_at, &s, LEAST_X, GREATEST_X);
  if (isnan(ln_x))
    ln_x = excess_at(LEAST_X, &s) > 0.0 ? LEAST_X : GREATEST_X;
  const po_edge_law law = po_persson_brener_at(e->terms, po_exp(ln_x));
  po_rate_theory state = state_at(e, a, law.work);
  state.edge_speed = law.speed * e->length;
  return state;
}

static po_rate_theory limit_at(const edge *e, double a) {
  po_rate_theory state = state_at(e, a, e->speed > 0.0 ? 1.0 / e->terms->instant : 1.0);
  state.edge_speed = e->speed;
  return state;
}

/* The greatest tension of a number of equal steps from a contact radius to the axis: the vertex of
 * the parabola through the greatest one and its neighbours. A state that the edge jumps over, since
 * the approach was less before, is not visited. At a finite speed the tension begins at that of the
 * relaxed contact and is not smooth there on the scale of a step: no parabola has that state. */
static po_rate_theory greatest(const edge *e, double from, int steps) {
  const bool limit = e->speed == 0.0 || isinf(e->speed);
  po_rate_theory best = {.force = -INFINITY},
                 last = limit ? limit_at(e, from) : state_at(e, from, 1.0);
  double lowest = last.approach, forces[3] = {NAN, NAN, limit ? last.force : (double)NAN};
  if (limit)
    best = last;
  for (int k = 1; k < steps; ++k) {
    const double a = from * (double)(steps - k) / steps;
    const po_rate_theory now = limit ? limit_at(e, a) : step(e, a, from / steps, lowest);
    const bool is_visited = now.approach <= lowest;
    forces[0] = forces[1];
    forces[1] = forces[2];
    forces[2] = is_visited ? now.force : (double)NAN;
    const double bend = forces[0] - 2.0 * forces[1] + forces[2], slope = forces[2] - forces[0];
    if (forces[1] == best.force && bend < 0.0 && fabs(slope) < 2.0 * fabs(bend))
      best.force -= slope * slope / (8.0 * bend);
    if (is_visited && now.force > best.force)
      best = now;
    lowest = fmin(lowest, now.approach);
  }
  return best;
}

/* Implicit steps are of first order: the force is extrapolated from STEPS and half as many. */
enum { STEPS = 2000 };

/* The greatest tension of all states with Gamma = w/k, which none with less exceeds. An
 * extrapolation does, where the tension rises to nearly that in the first steps. */
static double bound(const edge *e, double from) {
  double force = -INFINITY, forces[3] = {NAN, NAN, NAN};
  for (int k = 0; k < STEPS; ++k) {
    const double a = from * (double)(STEPS - k) / STEPS;
    forces[0] = forces[1];
    forces[1] = forces[2];
    forces[2] = state_at(e, a, 1.0 / e->terms->instant).force;
    const double bend = forces[0] - 2.0 * forces[1] + forces[2], slope = forces[2] - forces[0];
    force = fmax(force, forces[2]);
    if (bend < 0.0 && fabs(slope) < 2.0 * fabs(bend))
      force = fmax(force, forces[1] - slope * slope / (8.0 * bend));
  }
  return force;
}

po_status po_persson_brener_pull_off(const po_scene *scene, const po_creep_terms *terms,
                                     double speed, po_preload preload, po_rate_theory *found) {
  const edge e = {scene, terms, speed, length_of_edge(scene)};
  po_jkr_preloaded loaded;
  *found = (po_rate_theory)PO_NO_RATE_THEORY;
  const po_status status = po_jkr_after_preload(scene, preload, &loaded);
  if (status)
    return status;
  const double from = loaded.reversal.contact_radius;
  const double coarse = greatest(&e, from, STEPS / 2).force;
  *found = greatest(&e, from, STEPS);
  found->preload_radius = from;
  if (speed > 0.0 && isfinite(speed))
    found->force = fmin(found->force + (found->force - coarse), bound(&e, from));
  return PO_OK;
}

po_status po_persson_brener_of(const po_scene *scene, const po_creep *creep, double speed,
                               po_preload preload, po_rate_theory *found) {
  po_creep_terms terms;
  po_creep_terms_fill(creep, isfinite(speed) && speed > 0.0 ? 1.0 / speed : 1.0, &terms);
  return po_persson_brener_pull_off(scene, &terms, speed, preload, found);
}

static double load_rate(double a, const void *data) {
  return po_jkr_profile_rate(data, PO_FIXED_LOAD, a);
}

po_status po_persson_brener_limit(const po_scene *scene, const po_creep *creep, double speed,
                                  po_preload preload, po_rate_theory *found) {
  const po_status status = po_persson_brener_of(scene, creep, speed, preload, found);
  if (status)
    return status;
  /* JKR theory with Gamma in place of w */
  po_scene stronger = *scene;
  stronger.tabor *= po_pow(found->work, 2.0 / 3.0);
  const double step = found->preload_radius / STEPS,
               a = po_root(load_rate, &stronger, found->contact_radius - step,
                           fmin(found->preload_radius, found->contact_radius + step));
  const edge e = {.scene = scene};
  const po_rate_theory before = *found;
  *found = state_at(&e, isnan(a) ? before.contact_radius : a, before.work);
  found->edge_speed = before.edge_speed;
  found->preload_radius = before.preload_radius;
  return PO_OK;
}
