/* The state of greatest tension of unloading, between the steps. */
#include <math.h>

#include "po_march_internal.h"

/* The vertex of the parabola through three points with different x. */
static bool vertex(const double x[3], const double y[3], double *at, double *value) {
  const double d1 = (y[1] - y[0]) / (x[1] - x[0]), d2 = (y[2] - y[1]) / (x[2] - x[1]);
  const double bend = (d2 - d1) / (x[2] - x[0]);
  if (!(bend > 0.0))
    return false;
  /* the slope in the middle of the first interval is d1 */
  *at = 0.5 * (x[0] + x[1]) - 0.5 * d1 / bend;
  *value = y[0] + (*at - x[0]) * (d1 + bend * (*at - x[1]));
  return *at > x[0] && *at < x[2];
}

/* Solves the state at a position between `before` and the last accepted one; `held` is the state
 * from which. Returned: m->next. */
static po_status side_step(po_march *m, double moved) {
  po_march_bring(m);
  const po_march_scene scene = po_march_scene_of(m, moved - m->here.point.moved);
  return po_march_solve(m, &scene);
}

enum { SIDE_STEPS = 2 };

/* Called when the tension has passed a maximum: before, held (the middle), next. Finds the maximum
 * by steps that end there. Given: the state after the middle one. */
static po_status find_peak(po_march *m, const po_rate_point *before, const po_rate_point *middle,
                           const po_rate_point *after) {
  double x[3] = {before->moved, middle->moved, after->moved};
  double y[3] = {before->load, middle->load, after->load};
  po_rate_point best = *middle;
  double at = middle->moved, value = middle->load, first = middle->moved;
  vertex(x, y, &first, &value);
  for (int k = 0; k < SIDE_STEPS && vertex(x, y, &at, &value); ++k) {
    /* from the nearest state that is not beyond */
    const bool from_middle = at > middle->moved;
    if (fabs(at - best.moved) <= 1e-9 * (x[2] - x[0]))
      break;
    if (!from_middle)
      po_march_exchange(&m->before, &m->held);
    m->is_here = false;
    const po_status status = side_step(m, at);
    if (!from_middle)
      po_march_exchange(&m->before, &m->held);
    m->is_here = false;
    if (status)
      return status == PO_NOT_CONVERGED ? PO_OK : status;
    const po_rate_point found = m->next.point;
    /* the three nearest about the least load */
    const int inner = found.moved > best.moved ? 1 : 0; /* best is below, found above, or reverse */
    const double low_x = inner ? best.moved : found.moved, low_y = inner ? best.load : found.load;
    const double high_x = inner ? found.moved : best.moved, high_y = inner ? found.load : best.load;
    if (low_y < high_y) {
      x[2] = high_x, y[2] = high_y;
      x[1] = low_x, y[1] = low_y;
    } else {
      x[0] = low_x, y[0] = low_y;
      x[1] = high_x, y[1] = high_y;
    }
    if (found.load < best.load)
      best = found;
  }
  vertex(x, y, &at, &value);
  if (m->peak.found && !(value < m->peak.at.load))
    return PO_OK;
  const double spread = fabs(at - first) + fabs(at - best.moved);
  const double rate =
      fabs(after->contact_radius - before->contact_radius) / (after->moved - before->moved);
  m->peak = (po_march_peak){.at = best,
                            .found = true,
                            .jumps = m->jumps,
                            .spread = spread,
                            .radius_spread = spread * rate};
  m->peak.at.base -= at - best.moved;
  m->peak.at.approach = m->peak.at.base;
  if (!isnan(m->options.stiffness))
    m->peak.at.approach -= value / m->options.stiffness;
  m->peak.at.moved = at;
  m->peak.at.time = isnan(best.time) ? best.time : at / m->speed;
  m->peak.at.load = value;
  return PO_OK;
}

/* Takes a state as that of the greatest tension if it is. */
static void note_peak(po_march *m, const po_rate_point *point) {
  if (point->load < 0.0 && !(m->peak.found && m->peak.at.load <= point->load))
    m->peak = (po_march_peak){.at = *point, .found = true, .jumps = m->jumps};
}

/* Whether the last two states of the record are `before` and `held`. After a jump, and after a
 * motion at frozen creep that turned out to be none, `held` is a state of the motion, at the same
 * position of the base as the one that follows: no parabola leads through them, and no step from
 * there to the maximum. Just before a motion the steps are so short that the state is the maximum.
 */
static bool are_recorded(const po_march *m) {
  const po_march_record *last = m->records + m->count - 1;
  return m->held.point.moved == last[0].point.moved &&
         m->before.point.moved == last[-1].point.moved;
}

po_status po_march_watch_peak(po_march *m, bool jumped) {
  const po_march_record *last = m->records + m->count - 1;
  if (m->phase != PO_UNLOADING)
    return PO_OK;
  if (jumped) {
    note_peak(m, &last->point);
    return PO_OK;
  }
  if (m->count - m->first[m->phase] < 2)
    return PO_OK;
  const po_rate_point before = last[-1].point, middle = last->point, after = m->next.point;
  if (!(middle.load < 0.0) || !(middle.load <= before.load) || !(middle.load < after.load) ||
      (m->peak.found && middle.load > m->peak.at.load))
    return PO_OK;
  if (!are_recorded(m)) {
    note_peak(m, &middle);
    return PO_OK;
  }
  po_march_exchange(&m->next, &m->after);
  const po_status status = find_peak(m, &before, &middle, &after);
  po_march_exchange(&m->next, &m->after);
  return status;
}

po_march_peak po_march_greatest_tension(const po_march *m) {
  return m->peak;
}
