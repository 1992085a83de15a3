/* Gap and traction at one state of unloading: the first with a given approach, load or position of
 * the base. */
#include <math.h>
#include <string.h>

#include "po_march_internal.h"

/* Distance from what is wanted, relative to 1 + its modulus, at which a state has it; and the
 * shortest step, relative to the one that leads past it. */
static const double SAME = 1e-10;

enum { MOST_STEPS = 30 };

static double beyond(const po_march *m, const po_rate_point *p) {
  const po_march_wanted *w = &m->options.wanted;
  return (w->by == PO_WANTED_LOAD       ? p->load
          : w->by == PO_WANTED_APPROACH ? p->approach
                                        : p->moved) -
         w->value;
}

static bool has_wanted(const po_march *m, double distance) {
  return fabs(distance) <= SAME * (1.0 + fabs(m->options.wanted.value));
}

/* Keeps the state that was solved last. */
static void keep(po_march *m) {
  po_equilibrium *e = m->e;
  po_solution *to = m->options.wanted.solution;
  memcpy(e->initial_gap, m->bare, e->n * sizeof *m->bare);
  memcpy(to->state, m->solved, (e->n + 1) * sizeof *m->solved);
  po_equilibrium_evaluate(e, to->state);
  po_solution_take_state(to, e);
  m->has_wanted = true;
}

/* Solves steps from `held`, by the Illinois method on their length, until one ends at what is
 * wanted. Returned: m->next. */
static po_status approach_wanted(po_march *m, double length, double before, double after) {
  double low = 0.0, high = length;
  int side = 0; /* of the last length that was tried */
  for (int k = 0; k < MOST_STEPS; ++k) {
    const double h = fmax(low + (high - low) * before / (before - after), SAME * length);
    m->is_here = false;
    po_march_bring(m);
    const po_march_scene scene = po_march_scene_of(m, h);
    const po_status status = po_march_solve(m, &scene);
    if (status)
      return status;
    const double now = beyond(m, &m->next.point);
    if (has_wanted(m, now) || high - low <= SAME * length)
      break;
    const bool is_low = (now > 0.0) == (before > 0.0);
    *(is_low ? &low : &high) = h;
    *(is_low ? &before : &after) = now;
    if (side == (is_low ? -1 : 1))
      *(is_low ? &after : &before) *= 0.5;
    side = is_low ? -1 : 1;
  }
  keep(m);
  return PO_OK;
}

po_status po_march_look(po_march *m, bool jumped) {
  if (!m->options.wanted.solution || m->has_wanted || m->phase != PO_UNLOADING || jumped)
    return PO_OK;
  const double before = beyond(m, &m->held.point), after = beyond(m, &m->next.point);
  if (before * after > 0.0 && !has_wanted(m, before))
    return PO_OK;
  const double length = m->next.length;
  po_march_exchange(&m->next, &m->after);
  const po_status status = approach_wanted(m, length, before, after);
  po_march_exchange(&m->next, &m->after);
  m->is_here = false;
  return status == PO_NOT_CONVERGED ? PO_OK : status;
}

bool po_march_has_wanted(const po_march *m) {
  return m->has_wanted;
}
