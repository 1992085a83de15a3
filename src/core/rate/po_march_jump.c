/* A jump of the contact: the motion at frozen creep to the next stable equilibrium at the same
 * position of the base. Where the scene with the glassy modulus and the creep as it is has a fold,
 * no small step exists.
 *
 * The surface moves as if the instantaneous deflection u = k Q had a short retardation time of its
 * own, du/dt = k Q(p) - u, by implicit steps of any length x:
 *
 *   u = (1 - theta) u_before + theta k Q,   theta = x/(1 + x),
 *
 * (with a spring in the same way for the approach, which follows the spring with a delay), each of
 * which is an equilibrium with another gap and the coupling theta k. It is a motion along the
 * gradient of the energy, which falls in each step, so that it ends at a stable equilibrium. */
#include <math.h>

#include "po_law.h"
#include "po_march_internal.h"
#include "po_margins.h"

/* x of the first step, and the least one. */
static const double FIRST = 1.0, LEAST = 1e-8;

/* Greatest change of the gap in a step, relative to 1 + H. */
static const double GREATEST_CHANGE = 1.0;

/* Change of a step over x, at which a state misses the equilibrium by rounding. */
static const double STILL = 1e-10;

/* An edge moves by about a third of its width a step, and passes the whole contact. */
enum { MOST_STEPS = 1000000 };

/* The greatest change of the gap of a step, relative to 1 + H, in the core. */
static double change_of(const po_march *m) {
  const po_law *law = &m->e->scene->law;
  double largest = 0.0;
  const size_t core = po_surface_panels(m->e->surface)->count * PO_TABLE_ORDER;
  for (size_t j = 0; j < core; ++j) {
    const double before = m->bare[j] + po_march_field(&m->here, PO_OF_DEFLECTION)[j];
    const double size = fmin(po_law_size(law, before), po_law_size(law, m->solved[j]));
    largest = fmax(largest, fabs(m->solved[j] - before) / size);
  }
  return largest;
}

/* Makes the result of a step the state from which the next one starts: `held`, whose creep stays.
 */
static void move_on(po_march *m) {
  po_march_state *to = &m->next;
  for (size_t k = 0; k < m->fields; ++k)
    if (k != PO_OF_DEFLECTION)
      for (size_t j = 0; j < to->n; ++j)
        po_march_field(to, k)[j] = k < PO_OF_INSTANT ? 0.0 : po_march_field(&m->here, k)[j];
  for (size_t k = 0; k < PO_MOST_CREEP_TERMS; ++k)
    to->square[k] = m->here.square[k];
  to->length = 0.0;
  const po_march_state held = m->held;
  m->held = m->next;
  m->next = held;
  m->is_here = false;
}

/* Completes the state after the last step of the motion. Given: the energy and the state before. */
static void arrive(po_march *m, const po_march_scene *scene, double energy,
                   const po_rate_point *before, double length) {
  po_rate_point *p = &m->next.point;
  double *now = po_march_field(&m->next, PO_OF_INSTANT);
  for (size_t j = 0; j < m->e->n; ++j)
    now[j] = (po_march_field(&m->next, PO_OF_DEFLECTION)[j] + m->solved[m->e->n] - m->creep[j]) /
             scene->factor;
  if (m->speed == 0.0) /* the relaxed body: the creep is complete */
    for (size_t k = 0; k < m->options.terms->count; ++k) {
      const double c = m->options.terms->term[k].weight;
      double sum = 0.0;
      for (size_t j = 0; j < m->e->n; ++j) {
        po_march_field(&m->next, PO_OF_CREEP + k)[j] = c * now[j];
        sum += m->e->surface->weight[j] * m->traction[j] * now[j];
      }
      m->next.square[k] = c * c * 2.0 / m->e->radius * sum;
    }
  po_march_measure(m);
  const double worked = po_march_work(m, before, length);
  const po_rate_energy *e = &p->energy;
  p->energy.work += worked;
  p->energy.jumps += energy + worked - (e->stored + e->adhesive + e->spring);
}

po_status po_march_jump(po_march *m, double length) {
  const po_rate_point before = m->held.point;
  const po_rate_energy *e = &before.energy;
  double energy = e->stored + e->adhesive + e->spring;
  if (m->phase == PO_DWELLING) { /* the base stays: the creep leads beyond the fold */
    const double lost = po_march_creep(m, length);
    m->held.point.energy.dissipated += lost;
    energy -= lost;
  }
  const double instant = m->speed > 0.0 ? m->options.terms->instant : 1.0;
  double x = FIRST, left = length;
  for (int step = 0; step < MOST_STEPS && x > LEAST; ++step) {
    po_march_scene scene = {.length = left, .relaxing = true, .part = x / (1.0 + x)};
    scene.factor = scene.part * instant;
    m->e->factorized = false; /* the factors of a fold are so inaccurate that nothing moves */
    const po_status status = po_march_solve(m, &scene);
    if (status && status != PO_NOT_CONVERGED)
      return status;
    const double change = status ? INFINITY : change_of(m);
    if (!(change < GREATEST_CHANGE)) {
      x *= PO_STEP_CUT;
      continue;
    }
    move_on(m);
    left = 0.0;
    if (change < STILL * x) {
      po_march_bring(m);
      scene.length = 0.0;
      const po_status again = po_march_solve(m, &scene);
      if (again)
        return again;
      for (size_t k = PO_OF_RATE; k < m->fields; ++k)
        for (size_t j = 0; j < m->next.n; ++j)
          po_march_field(&m->next, k)[j] = po_march_field(&m->here, k)[j];
      for (size_t k = 0; k < PO_MOST_CREEP_TERMS; ++k)
        m->next.square[k] = m->here.square[k];
      m->next.length = 0.0;
      arrive(m, &scene, energy, &before, length);
      return PO_OK;
    }
    x *= fmin(PO_STEP_GROWTH, PO_AIM * GREATEST_CHANGE / change);
  }
  return po_fail(PO_STEP_TOO_SMALL,
                 "no stable equilibrium follows a jump of the contact at approach %.6g, load %.6g",
                 m->held.point.approach, m->held.point.load);
}
