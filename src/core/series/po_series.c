#include "po_series.h"

#include <math.h>
#include <stdlib.h>

#include "po_memory.h"
#include "po_series_scenes.h"

/* A scene of a series that is traced completely, with the minima of its load. */
typedef struct {
  size_t index;        /* index of its scene in the series */
  bool usable;         /* whether the minima can be followed: the scene was solved, on panels */
  double deepest;      /* load of the pull-off, pi w R */
  po_kept_points kept; /* all minima of the trace, in the order of their depth */
  size_t candidates; /* the number of minima, the deepest ones, that may be the pull-off of a scene
                        before the next checkpoint */
} checkpoint;

/* A minimum that was followed from one checkpoint towards the other. */
typedef struct {
  const po_kept_point *from, *arrived; /* in both traces; arrived NULL: not in the second */
  double load_at_end; /* its load where it ended between the checkpoints; NAN: it did not end */
  double moved;       /* how far it moved up to there, see moved_to; INFINITY: it did not merge */
} followed;

/* The interval between two checkpoints. */
typedef struct {
  const po_series_scenes *l;
  const checkpoint *from, *to;
  po_series_course course;
  size_t inside; /* number of scenes between the checkpoints */
  double *load;  /* rows x (inside + 2): the load of each followed minimum at each scene; NAN: it
                    does not exist there */
  followed *row; /* rows: the minima */
  size_t rows;
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
  return PO_SAME_LOAD * s->l->requests[s->from->index].mesh.tolerance * fabs(load);
}

/* Records a minimum as the pull-off of a scene if it is the deepest up to now. */
static void record_minimum(void *data, size_t index, const po_branch_point *p) {
  interval *s = data;
  po_result *o = &s->l->results[index];
  const double before = deepest_at(s, index);
  *load_of(s, s->rows - 1, index) = p->load;
  if (index == s->from->index || index == s->to->index || !(p->load < before))
    return;
  o->work.nodes = o->work.nodes > p->n ? o->work.nodes : p->n;
  const po_estimate e = po_series_estimate(&s->course, index);
  po_estimate_pull_off(&e, o);
  o->followed = true;
}

/* Returned: the minimum of a checkpoint at which the follower has arrived; NULL if the trace did
 * not find it. */
static const po_kept_point *find_arrived(const interval *s, const checkpoint *at) {
  const po_branch_point p = po_follow_point(s->course.follower, false);
  const po_kept_point *best = NULL;
  double nearest = PO_SAME_APPROACH * (1.0 + fabs(p.approach));
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
  const checkpoint *from = forward ? s->from : s->to, *to = forward ? s->to : s->from;
  followed *row = &s->row[s->rows++];
  *row = (followed){.from = m, .load_at_end = NAN};
  for (size_t k = s->from->index; k <= s->to->index; ++k)
    *load_of(s, s->rows - 1, k) = k == from->index ? m->load : (double)NAN;
  const po_status status = po_series_follow(&s->course, &m->point, from->index, to->index);
  if (status == PO_INTERRUPTED)
    return status;
  if (status) {
    const po_branch_point end = po_follow_point(s->course.follower, false);
    row->load_at_end = end.load;
    row->moved = status == PO_NOT_FOUND ? moved_to(s, m, &end) : INFINITY;
  } else
    row->arrived = find_arrived(s, to);
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
  const checkpoint *from = forward ? s->from : s->to;
  if (k >= from->candidates || has_arrived(s, &from->kept.points[k]))
    return PO_OK;
  return follow(s, &from->kept.points[k], forward);
}

/* Follows the candidates of both checkpoints, the deepest ones first. If these contradict the
 * traces, the others are left out: they would hardly mend it. */
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

/* Given: two checkpoints with scenes between them. Returned: *settled, whether the followed minima
 * agree with both traces; then the results of the scenes between have their pull-off. Status:
 * PO_NO_MEMORY, PO_INTERRUPTED. */
static po_status follow_minima(const po_series_scenes *scenes, const checkpoint *from,
                               const checkpoint *to, bool *settled) {
  interval s = {.l = scenes, .from = from, .to = to, .inside = to->index - from->index - 1};
  s.course =
      (po_series_course){.scenes = scenes, .of = PO_OF_LOAD, .record = record_minimum, .data = &s};
  *settled = false;
  if (!may_follow(&s))
    return PO_OK;
  const size_t most = from->candidates + to->candidates;
  s.load = po_allocate(most * (s.inside + 2), sizeof *s.load);
  s.row = po_allocate(most, sizeof *s.row);
  po_status status = s.load && s.row ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = po_series_course_begin(&s.course, from->index,
                                    fmin(from->kept.tolerance, to->kept.tolerance));
  if (!status)
    status = follow_all(&s);
  *settled = !status && agrees(&s);
  po_follow_destroy(s.course.follower);
  free(s.load);
  free(s.row);
  return status;
}

/* Minima whose load is at least this fraction of the deepest one may become the deepest before the
 * next checkpoint. */
static const double CANDIDATE_DEPTH = 0.3;

static int by_depth(const void *left, const void *right) {
  const double a = ((const po_kept_point *)left)->load;
  const double b = ((const po_kept_point *)right)->load;
  return (a > b) - (a < b);
}

/* Traces a scene. Returned: its result; the checkpoint, with the minima in the order of their
 * depth, the pull-off first, to be cleared with po_kept_points_clear. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED. A trace that fails gives a checkpoint that is not usable. */
static po_status checkpoint_trace(const po_request *request, size_t index, po_result *result,
                                  checkpoint *a) {
  *a = (checkpoint){.index = index, .kept = {.which = PO_KEEP_MINIMA}};
  const po_status status = po_solve_kept(request, &a->kept, result);
  if (status == PO_NO_MEMORY || status == PO_INTERRUPTED)
    return status;
  a->usable = !status && a->kept.count > 0;
  if (!a->usable) {
    po_kept_points_clear(&a->kept);
    return PO_OK;
  }
  const po_kept_point *minima = a->kept.points;
  qsort(a->kept.points, a->kept.count, sizeof *a->kept.points, by_depth);
  a->deepest = minima[0].load;
  while (a->candidates < a->kept.count &&
         minima[a->candidates].load <= CANDIDATE_DEPTH * a->deepest)
    ++a->candidates;
  return PO_OK;
}

static po_status trace(const po_series_scenes *l, size_t index, checkpoint *made) {
  po_result *o = &l->results[index];
  const po_work spent = o->work; /* on minima that did not agree */
  po_result_clear(o);
  const po_status status = checkpoint_trace(&l->requests[index], index, o, made);
  o->work.points += spent.points;
  o->work.newton_iterations += spent.newton_iterations;
  o->work.factorizations += spent.factorizations;
  o->work.meshes += spent.meshes;
  o->work.kernel_evaluations += spent.kernel_evaluations;
  o->work.seconds += spent.seconds;
  return status;
}

/* Traces those of the scenes first <= k < end whose error estimate exceeds the tolerance or is
 * missing. */
static po_status trace_inaccurate(const po_series_scenes *l, size_t first, size_t end) {
  po_status status = PO_OK;
  for (size_t k = first; k < end && !status; ++k) {
    const po_result *o = &l->results[k];
    if (o->pull_off.force_error <= l->requests[k].mesh.tolerance * o->pull_off.force)
      continue;
    checkpoint unused;
    status = trace(l, k, &unused);
    po_kept_points_clear(&unused.kept);
  }
  return status;
}

/* Computes the scenes between two checkpoints: follows the minima, or traces the middle scene and
 * continues with both halves. */
static po_status solve_between(const po_series_scenes *l, checkpoint *from, checkpoint *to) {
  if (to->index - from->index < 2)
    return PO_OK;
  bool settled;
  po_status status = follow_minima(l, from, to, &settled);
  if (settled)
    return trace_inaccurate(l, from->index + 1, to->index);
  checkpoint middle = {0};
  if (!status)
    status = trace(l, from->index + (to->index - from->index) / 2, &middle);
  if (!status)
    status = solve_between(l, from, &middle);
  if (!status)
    status = solve_between(l, &middle, to);
  po_kept_points_clear(&middle.kept);
  return status;
}

static po_status solve(const po_series_scenes *l) {
  const size_t count = l->count, most = l->checkpoint_every;
  if (count == 0)
    return PO_OK;
  checkpoint from, to = {0};
  po_status status = trace(l, 0, &from);
  for (size_t index = 0; index + 1 < count && !status;) {
    index = count - 1 - index > most ? index + most : count - 1;
    status = trace(l, index, &to);
    if (!status)
      status = solve_between(l, &from, &to);
    po_kept_points_clear(&from.kept);
    from = to;
    to = (checkpoint){0};
  }
  po_kept_points_clear(&from.kept);
  return status;
}

po_status po_series_pull_offs(const po_request *requests, size_t count, size_t checkpoint_every,
                              po_result *results) {
  return po_series_solve((po_series_scenes){requests, results, count, checkpoint_every}, solve);
}
