/* The minima of the load between two checkpoints of a series: followed from each to the other, and
 * compared with both traces. */
#include <math.h>
#include <stdlib.h>

#include "po_estimate.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_series_scenes.h"
#include "po_watch.h"

/* A followed and a traced minimum are the same if their loads differ by at most SAME_LOAD times the
 * relative tolerance, and their approaches by at most AGREEING_APPROACH relative to 1 + |approach|.
 */
static const double SAME_LOAD = 10.0, AGREEING_APPROACH = 1e-2;

/* A minimum that was followed from one checkpoint towards the other. */
typedef struct {
  const po_kept_point *from, *arrived; /* in both traces; arrived NULL: not in the second */
  double load_at_end; /* its load where it ended between the checkpoints; NAN: it did not end */
  double moved;       /* how far it moved up to there, see moved_to; INFINITY: it did not merge */
} followed;

/* The interval between two checkpoints. */
typedef struct {
  const po_series_scenes *l;
  const po_checkpoint *from, *to;
  po_follower *follower;
  size_t inside; /* number of scenes between the checkpoints */
  double *load;  /* rows x (inside + 2): the load of each followed minimum at each scene; NAN: it
                    does not exist there */
  followed *row; /* rows: the minima */
  size_t rows;
  po_series_work before;
} interval;

static bool may_follow(const interval *s) {
  if (!s->from->usable || !s->to->usable)
    return false;
  for (size_t k = s->from->index; k < s->to->index; ++k)
    if (!po_series_alike(&s->l->requests[k], &s->l->requests[k + 1]))
      return false;
  return true;
}

static double *load_of(const interval *s, size_t row, size_t index) {
  return &s->load[row * (s->inside + 2) + index - s->from->index];
}

/* Returned: the lowest load of all minima of a scene, whether they were followed to it or traced.
 */
static double deepest_at(const interval *s, size_t index) {
  double deepest = INFINITY;
  for (size_t row = 0; row < s->rows; ++row)
    deepest = fmin(deepest, *load_of(s, row, index)); /* fmin ignores NAN */
  return deepest;
}

static double load_tolerance(const interval *s, double load) {
  return SAME_LOAD * s->l->requests[s->from->index].mesh.tolerance * fabs(load);
}

/* Records the minimum at which the follower is as the pull-off of a scene if it is the deepest up
 * to now. Returned: its load; NAN if the contact reaches the end of the core of the surface. */
static double record_minimum(interval *s, size_t index) {
  const po_request *request = &s->l->requests[index];
  po_result *o = &s->l->results[index];
  const double before = deepest_at(s, index);
  const double domain = po_follow_domain(s->follower);
  po_branch_point p = po_follow_point(s->follower, false);
  if (po_series_is_cut_off(request, domain, &p))
    return NAN;
  const double load = p.load;
  if (index == s->from->index || index == s->to->index || !(load < before))
    return load;
  o->work.nodes = o->work.nodes > p.n ? o->work.nodes : p.n;
  p = po_follow_point(s->follower, true);
  o->followed = o->has_pull_off = true;
  const po_estimate e = po_estimate_of(request, domain, &p);
  o->pull_off.force = fabs(e.load);
  o->pull_off.approach = e.approach;
  o->pull_off.contact_radius = e.edge.radius;
  o->pull_off.force_error = e.load_error;
  o->pull_off.approach_error = e.approach_error;
  o->pull_off.contact_radius_error = e.edge.error;
  o->pull_off.contact_radius_other = e.edge.other;
  return load;
}

/* Returned: the minimum of a checkpoint at which the follower has arrived; NULL if the trace did
 * not find it. */
static const po_kept_point *find_arrived(const interval *s, const po_checkpoint *at) {
  const po_branch_point p = po_follow_point(s->follower, false);
  const po_kept_point *best = NULL;
  double nearest = AGREEING_APPROACH * (1.0 + fabs(p.approach));
  for (size_t k = 0; k < at->kept.count; ++k) {
    const double apart = fabs(at->kept.points[k].approach - p.approach);
    if (fabs(at->kept.points[k].load - p.load) < load_tolerance(s, p.load) && apart < nearest) {
      nearest = apart;
      best = &at->kept.points[k];
    }
  }
  return best;
}

/* Returned: how far a minimum has moved from the checkpoint, in the approach or the load, whichever
 * the preload has. */
static double moved_to(const interval *s, const po_kept_point *m, const po_branch_point *end) {
  const po_preload preload = po_request_preload(&s->l->requests[s->from->index]);
  const double approach = isnan(preload.approach) ? 0.0 : fabs(end->approach - m->approach);
  const double load = isnan(preload.load) ? 0.0 : fabs(end->load - m->load);
  return fmax(approach, load);
}

/* Follows a minimum of one checkpoint towards the other. Status: PO_NO_MEMORY, PO_INTERRUPTED; a
 * minimum that ends between the checkpoints is not a failure. */
static po_status follow(interval *s, const po_kept_point *m, bool forward) {
  const po_checkpoint *from = forward ? s->from : s->to;
  const size_t row = s->rows++, steps = s->inside + 1;
  s->row[row] = (followed){.from = m, .load_at_end = NAN};
  for (size_t k = 0; k <= steps; ++k)
    *load_of(s, row, s->from->index + k) = NAN;
  *load_of(s, row, from->index) = m->load;
  double begin = po_clock_wall();
  po_status status = po_follow_begin(s->follower, &m->point, PO_OF_LOAD, (double)from->index);
  bool merged = false;
  for (size_t k = 1; k <= steps && !status; ++k) {
    const size_t index = forward ? from->index + k : from->index - k;
    const volatile sig_atomic_t *stop = s->l->requests[index].stop;
    if (stop && *stop)
      return po_fail(PO_INTERRUPTED, "interrupted in a series of scenes");
    if (s->l->requests[index].watch)
      s->l->requests[index].watch(s->l->requests[index].watcher, (double)NAN, (double)NAN);
    status = po_follow_to(s->follower, (double)index, po_observe_deadline(&s->l->requests[index]));
    merged = status == PO_NOT_FOUND;
    if (!status)
      *load_of(s, row, index) = record_minimum(s, index);
    const double now = po_clock_wall();
    po_series_add_work(s->follower, now - begin, &s->before, &s->l->results[index].work);
    begin = now;
    if (!status && isnan(*load_of(s, row, index)))
      status = PO_NOT_FOUND;
  }
  if (status) {
    const po_branch_point end = po_follow_point(s->follower, false);
    s->row[row].load_at_end = end.load;
    s->row[row].moved = merged ? moved_to(s, m, &end) : INFINITY;
  } else
    s->row[row].arrived = find_arrived(s, forward ? s->to : s->from);
  po_message_clear();
  return status == PO_NO_MEMORY ? status : PO_OK;
}

/* Returned: the load that the deepest minimum which exists at both of two neighbouring scenes has
 * at the shallower of them; INFINITY if there is none. */
static double spanning_load(const interval *s, size_t index) {
  double load = INFINITY;
  for (size_t row = 0; row < s->rows; ++row) {
    const double here = *load_of(s, row, index), there = *load_of(s, row, index + 1);
    if (!isnan(here) && !isnan(there))
      load = fmin(load, fmax(here, there));
  }
  return load;
}

/* Returned: whether a minimum is the pull-off of a scene between the checkpoints. */
static bool is_pull_off(const interval *s, size_t row) {
  bool is = false;
  for (size_t k = s->from->index + 1; k < s->to->index; ++k)
    is = is || *load_of(s, row, k) == deepest_at(s, k);
  return is;
}

/* Returned: whether the traces of the scenes between would reach a minimum, as those of both
 * checkpoints did. A trace ends where the sphere is pressed enough; if an earlier minimum becomes
 * deeper, or the load maximum before the minimum higher, the trace may end before it. The margins
 * of both traces must therefore exceed their difference. Of a minimum that merges with a maximum
 * between the checkpoints there is one margin. It must exceed the movement of the minimum, because
 * the load maximum and the folds before it move about as far. */
static bool is_within(const followed *f) {
  if (!isnan(f->load_at_end))
    return f->from->margin > f->moved;
  return f->arrived &&
         fmin(f->from->margin, f->arrived->margin) > fabs(f->from->margin - f->arrived->margin);
}

/* Returned: whether the minima followed so far contradict a trace. */
static bool contradicts(const interval *s) {
  const size_t first = s->from->index, last = s->to->index;
  if (deepest_at(s, first) < s->from->deepest - load_tolerance(s, s->from->deepest) ||
      deepest_at(s, last) < s->to->deepest - load_tolerance(s, s->to->deepest))
    return true;
  /* a minimum that ends between the checkpoints must not be the deepest */
  for (size_t row = 0; row < s->rows; ++row)
    for (size_t k = first; k < last; ++k)
      if (isnan(*load_of(s, row, k)) != isnan(*load_of(s, row, k + 1)) &&
          !(s->row[row].load_at_end > spanning_load(s, k)))
        return true;
  for (size_t row = 0; row < s->rows; ++row)
    if (is_pull_off(s, row) && !is_within(&s->row[row]))
      return true;
  return false;
}

/* Returned: whether the followed minima agree with both traces and give every scene between them a
 * pull-off (po_series.h). */
static bool agrees(const interval *s) {
  for (size_t k = s->from->index + 1; k < s->to->index; ++k)
    if (!isfinite(deepest_at(s, k)))
      return false;
  return !contradicts(s);
}

static bool has_arrived(const interval *s, const po_kept_point *m) {
  bool has = false;
  for (size_t row = 0; row < s->rows; ++row)
    has = has || s->row[row].arrived == m;
  return has;
}

/* Follows a candidate of one checkpoint to the other, unless it was met from there. */
static po_status follow_candidate(interval *s, size_t k, bool forward) {
  const po_checkpoint *from = forward ? s->from : s->to;
  if (k >= from->candidates || has_arrived(s, &from->kept.points[k]))
    return PO_OK;
  return follow(s, &from->kept.points[k], forward);
}

/* Follows the candidates of both checkpoints, the deepest ones first. If these contradict the
 * traces, the others are left out: they would hardly mend it. Following in vain took a third of the
 * time of the map of Figure 15; now it takes a tenth, and 401 of the 2460 scenes are traced instead
 * of 392. */
static po_status follow_all(interval *s) {
  const size_t most =
      s->from->candidates > s->to->candidates ? s->from->candidates : s->to->candidates;
  po_status status = PO_OK;
  for (size_t k = 0; k < most && !status && !(k == 1 && contradicts(s)); ++k) {
    status = follow_candidate(s, k, true);
    if (!status)
      status = follow_candidate(s, k, false);
  }
  return status;
}

po_status po_series_follow_minima(const po_series_scenes *scenes, const po_checkpoint *from,
                                  const po_checkpoint *to, bool *settled) {
  interval s = {.l = scenes, .from = from, .to = to, .inside = to->index - from->index - 1};
  *settled = false;
  if (!may_follow(&s))
    return PO_OK;
  const size_t most = from->candidates + to->candidates;
  s.load = po_allocate(most * (s.inside + 2), sizeof *s.load);
  s.row = po_allocate(most, sizeof *s.row);
  po_status status = s.load && s.row ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = po_series_follower(scenes, from->index, fmin(from->kept.tolerance, to->kept.tolerance),
                                &s.follower);
  if (!status)
    status = follow_all(&s);
  *settled = !status && agrees(&s);
  po_follow_destroy(s.follower);
  free(s.load);
  free(s.row);
  return status;
}
