#include "po_reduced.h"

#include <math.h>
#include <stdlib.h>

#include "po_load_unit.h"
#include "po_memory.h"
#include "po_reduced_internal.h"

/* How many traces in a row may fail. */
enum { FAILURES = 4 };

/* -- Traces -- */

/* The watcher of a request, whose approaches are in its own units. */
typedef struct {
  const po_request *request;
  double range;
} watcher;

static void watch_scaled(void *of, double approach, double load) {
  const watcher *w = of;
  w->request->watch(w->request->watcher, approach * w->range, load);
}

static po_range_trace no_trace(void) {
  return (po_range_trace){.at = -1, .kept = {.which = PO_KEEP_LOADING}, .result = po_result_none()};
}

static void clear_trace(po_range_trace *t) {
  po_kept_points_clear(&t->kept);
  po_result_clear(&t->result);
  *t = no_trace();
}

/* Traces with one of the ranges. */
static po_status trace_one(const po_ranges *ranges, int at, po_reduced_solver *solve,
                           po_range_trace *t) {
  const double range = ranges->range[at];
  po_request r = po_reduced_request(ranges->request, range);
  watcher w = {ranges->request, range};
  if (r.watch) {
    r.watch = watch_scaled;
    r.watcher = &w;
  }
  t->at = at;
  return solve(&r, &t->kept, &t->result);
}

/* The kept minimum of the load that is a pull-off of the trace; NULL: it is not on panels. Given:
 * the approach, which the finest mesh may have corrected. */
static const po_kept_point *minimum_of(const po_range_trace *t, double approach) {
  const po_kept_point *nearest = NULL;
  for (size_t k = 0; k < t->kept.count; ++k) {
    const po_kept_point *p = &t->kept.points[k];
    if (p->kind == PO_POINT_LOAD_MIN &&
        (!nearest || fabs(p->approach - approach) < fabs(nearest->approach - approach)))
      nearest = p;
  }
  return nearest;
}

static const po_kept_point *pull_off_of(const po_range_trace *t) {
  return minimum_of(t, t->result.pull_off.approach);
}

/* Whether a special point is a minimum of the load that loading leads to before a jump, which it
 * does not make; NULL: before the preload. */
static bool is_minimum_before(const po_kept_point *p, const po_kept_point *jump) {
  return p->kind == PO_POINT_LOAD_MIN && (jump ? p->position < jump->position : !p->met);
}

/* The deepest of these; NULL: none. */
static const po_kept_point *deepest_before(const po_range_trace *t, const po_kept_point *jump) {
  const po_kept_point *deepest = NULL;
  for (size_t k = 0; k < t->kept.count; ++k) {
    const po_kept_point *p = &t->kept.points[k];
    if (is_minimum_before(p, jump) && (!deepest || p->load < deepest->load))
      deepest = p;
  }
  return deepest;
}

/* The fold at which the stretch of a minimum of the load begins; NULL: none. */
static const po_kept_point *begin_of(const po_range_trace *t, const po_kept_point *minimum) {
  const po_kept_point *begin = NULL;
  for (size_t k = 0; k < t->kept.count; ++k) {
    const po_kept_point *p = &t->kept.points[k];
    if (p->kind == PO_POINT_APPROACH_MIN && p->position < minimum->position)
      begin = p;
  }
  return begin;
}

/* The jump of loading beyond which the pull-off is that of the trace; NULL: none. */
static const po_kept_point *jump_of(const po_range_trace *t) {
  const double approach = t->result.pull_off.pressed.approach;
  const double close = PO_SAME_APPROACH * (1.0 + fabs(approach));
  for (size_t k = 0; k < t->kept.count; ++k) {
    const po_kept_point *p = &t->kept.points[k];
    if (p->kind == PO_POINT_APPROACH_MAX && fabs(p->approach - approach) < close)
      return p;
  }
  return NULL;
}

/* -- The limit -- */

/* The limit of the force of a minimum. Returned: *bound, its error; INFINITY if the minimum is not
 * known at enough ranges. */
static double force_of(const po_ranges *ranges, const po_range_track *t, double *bound) {
  const int first = t->last - PO_RANGES_OF_LIMIT + 1;
  *bound = INFINITY;
  if (first < t->first)
    return fabs(t->at[t->last].point.load);
  const po_range_limit l = po_range_limit_of(PO_BY_EDGES, &ranges->range[first]);
  double load[PO_RANGES_OF_LIMIT], error[PO_RANGES_OF_LIMIT];
  for (int k = 0; k < PO_RANGES_OF_LIMIT; ++k) {
    load[k] = t->at[first + k].point.load;
    error[k] = t->at[first + k].point.load_error;
  }
  return fabs(po_range_limit_at(&l, load, error, bound));
}

/* The error of that force over the tolerance times the force; INFINITY as above. */
static double excess_of(const po_ranges *ranges, const po_range_track *t) {
  double bound;
  const double force = force_of(ranges, t, &bound);
  return bound / (ranges->request->mesh.tolerance * force);
}

/* Follows a point to the ranges from `first` to `last`, and on until the excess is small enough if
 * that is asked for. */
static po_status follow_point(const po_range_follower *f, const po_kept_point *p, int first,
                              int last, double enough, po_range_track *t) {
  po_status status = po_range_course_begin(f->course, p, t);
  while (!status && t->first > first)
    status = po_range_course_next(f->course, false, t);
  if (!status && t->first < f->trace->at)
    status = po_range_course_again(f->course, p);
  while (!status && t->last < f->ranges->count - 1 &&
         (t->last < last || !(excess_of(f->ranges, t) <= enough)))
    status = po_range_course_next(f->course, true, t);
  return status;
}

/* Whether a minimum of the load that was followed to the range of another trace is one that this
 * has kept. The values of a trace are not corrected by those of a finer mesh. */
static bool is_kept_by(const po_request *request, const po_range_trace *t,
                       const po_range_track *track) {
  const po_special_point *p = &track->at[t->at].point;
  const po_kept_point *kept = minimum_of(t, p->approach);
  if (!kept)
    return false;
  const double tolerance = PO_SAME_LOAD * po_reduced_tolerance(request) + request->mesh.tolerance;
  return fabs(kept->load - p->load) <= tolerance * fabs(kept->load) + p->load_error &&
         fabs(kept->approach - p->approach) <= PO_SAME_APPROACH * (1.0 + fabs(p->approach));
}

/* -- The solve -- */

bool po_reduced_ends(po_status status) {
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED || status == PO_OUT_OF_TIME ||
         status == PO_BAD_INPUT;
}

/* Fails because the error stays above the tolerance. */
static po_status inaccurate(const po_request *request, const po_result *o, double excess) {
  const double unit = po_scene_load_unit(&request->scene);
  return po_fail(PO_NOT_CONVERGED,
                 "the pull-off force with ranges of the attraction %.3g to %.3g times as great "
                 "leads to %.6g with an error of %.2g, %.2g times the tolerance: expected a "
                 "larger tolerance",
                 o->range.least, o->range.greatest, o->pull_off.force * unit,
                 o->pull_off.force_error * unit, excess);
}

static po_status undecided(const po_ranges *ranges, po_result *o) {
  o->has_pull_off = o->pull_off_any.is_known = false;
  return po_fail(
      PO_NOT_CONVERGED,
      "with ranges of the attraction %.3g to %.3g times as great loading jumps so close "
      "to the preload that with the true one it may be reversed before: expected another "
      "preload, or the range exact",
      ranges->range[ranges->count - 1], ranges->range[0]);
}

/* Fails, with the pull-off, because the loops of the ranges reverse beyond another jump. */
static po_status without_loops(void) {
  return po_fail(PO_NOT_CONVERGED,
                 "with the true range of the attraction loading is reversed before a jump that "
                 "greater ones make, whose loops are others: expected the range exact");
}

/* A solve: the ranges, two traces, and tracks of special points. */
typedef struct {
  po_ranges ranges;
  po_range_trace before, now; /* at: -1 of a trace that has not been made */
  po_range_track pull_off, begin, jump, any, rival, work_track;
  po_work work;
  const po_kept_point *minimum; /* that is the pull-off */
  double greatest;              /* force of all minima with their errors */
  bool is_reversed_before;      /* a jump of loading that the trace makes */
  int next; /* index of the range of the next trace; -1: the solve is complete */
} search;

/* Follows a special point as far as the pull-off. Returned: its track; NULL: the trace has none, or
 * it ends before. */
static const po_range_track *follow_beside(const search *s, const po_range_follower *f,
                                           const po_kept_point *p, po_range_track *track,
                                           po_status *status) {
  if (!p || *status)
    return NULL;
  const int first = s->pull_off.last - PO_RANGES_OF_LIMIT + 1;
  const po_status followed = follow_point(f, p, first, s->pull_off.last, INFINITY, track);
  if (po_reduced_ends(followed))
    *status = followed;
  return followed ? NULL : track;
}

/* Makes the result of the last trace that of the solve, in units of the true range. */
static void take_result(search *s, po_result *result) {
  po_result_clear(result);
  *result = s->now.result;
  s->now.result = po_result_none();
  po_load_unit_lengthen(result, s->ranges.range[s->now.at]);
}

/* Completes a solve whose pull-off has been followed. Given: whether it is that of the trace. */
static po_status conclude(search *s, const po_range_follower *f, bool is_traced,
                          po_result *result) {
  const po_request *request = s->ranges.request;
  const po_result *o = &s->now.result;
  const bool is_any =
      is_traced && o->pull_off_any.is_known && o->pull_off_any.force != o->pull_off.force;
  const po_kept_point *other = is_any ? minimum_of(&s->now, o->pull_off_any.approach) : NULL;
  const po_kept_point *last = is_traced ? jump_of(&s->now) : NULL;
  po_status status = PO_OK;
  const po_range_points points = {
      .pull_off = &s->pull_off,
      .begin = follow_beside(s, f, begin_of(&s->now, s->minimum), &s->begin, &status),
      .jump = follow_beside(s, f, last, &s->jump, &status),
      .any = follow_beside(s, f, other, &s->any, &status)};
  if (status)
    return status;
  po_message_clear();
  take_result(s, result);
  result->pull_off_any.is_known &= is_traced && (!is_any || points.any);
  if (!is_traced) { /* the trace went on beyond the reversal */
    result->pull_off.full_disc = NAN;
    result->pull_off_any.searched = (po_preload){NAN, NAN};
  }
  status = po_range_limit_take(&s->ranges, &points, s->pull_off.last, result);
  result->pull_off.force_error =
      fmax(result->pull_off.force_error, s->greatest - result->pull_off.force);
  const double by_others =
      result->pull_off.force_error / (request->mesh.tolerance * result->pull_off.force);
  const double excess = fmax(excess_of(&s->ranges, &s->pull_off), by_others);
  return status ? status : excess > PO_MOST_EXCESS ? inaccurate(request, result, excess) : PO_OK;
}

/* Whether a minimum of the last trace may have a force above the given one at the true range. One
 * that ends before the greater range may. */
static po_status find_whether_exceeds(search *s, const po_range_follower *f, const po_kept_point *p,
                                      double force, bool *exceeds) {
  *exceeds = false;
  if (!(fabs(p->load) > PO_NEARLY * force))
    return PO_OK;
  const po_status status = follow_point(f, p, s->before.at, s->now.at, INFINITY, &s->rival);
  if (po_reduced_ends(status))
    return status;
  const double now = fabs(s->rival.at[s->now.at].point.load);
  *exceeds = status ||
             now + PO_CHANGES_ON * fabs(now - fabs(s->rival.at[s->before.at].point.load)) > force;
  return PO_OK;
}

/* Follows a minimum that may be the pull-off at the true range, and makes it the pull-off if it is.
 * Status: PO_NOT_CONVERGED if it is not known whether it is. */
static po_status follow_rival(search *s, const po_range_follower *f, const po_kept_point *p,
                              bool *is_traced) {
  const int first = s->rival.first, last = first + PO_RANGES_OF_LIMIT - 1;
  const po_status status = follow_point(f, p, first, last, PO_RANGE_ENOUGH, &s->rival);
  double bound, other;
  const double force = force_of(&s->ranges, &s->rival, &bound);
  if (status || isinf(bound))
    return po_reduced_ends(status) ? status : PO_NOT_CONVERGED;
  s->greatest = fmax(s->greatest, force + bound);
  if (force > force_of(&s->ranges, &s->pull_off, &other)) {
    s->pull_off = s->rival;
    s->minimum = p;
    *is_traced = false;
  }
  return PO_OK;
}

/* Follows the other minima that may be the pull-off. Given: as conclude; the jump before which
 * loading is reversed, NULL: none. Returned: *is_traced. */
static po_status follow_rivals(search *s, const po_range_follower *f, const po_kept_point *jump,
                               bool *is_traced) {
  const po_kept_point *first = s->minimum;
  double bound;
  po_status status = PO_OK;
  s->greatest = force_of(&s->ranges, &s->pull_off, &bound) + bound;
  for (size_t k = 0; k < s->now.kept.count && !status; ++k) {
    const po_kept_point *p = &s->now.kept.points[k];
    bool exceeds = false;
    if (p != first && is_minimum_before(p, jump))
      status = find_whether_exceeds(s, f, p, fabs(first->load), &exceeds);
    if (!status && exceeds)
      status = follow_rival(s, f, p, is_traced);
  }
  return status;
}

/* The greatest pull-off of all preloads is not known if a minimum beyond the preload may exceed it.
 */
static po_status judge_any(search *s, const po_range_follower *f) {
  po_result *o = &s->now.result;
  if (!o->pull_off_any.is_known)
    return PO_OK;
  const po_kept_point *any = minimum_of(&s->now, o->pull_off_any.approach);
  po_status status = PO_OK;
  for (size_t k = 0; k < s->now.kept.count && !status; ++k) {
    const po_kept_point *p = &s->now.kept.points[k];
    bool exceeds = false;
    if (p != any && p->kind == PO_POINT_LOAD_MIN && (p->met || any->met))
      status = find_whether_exceeds(s, f, p, o->pull_off_any.force, &exceeds);
    o->pull_off_any.is_known &= !exceeds;
  }
  return status;
}

/* Follows the minimum to as many ranges as its error needs, and completes the solve. Given: the
 * jump before which loading is reversed, NULL: none. */
static po_status follow_minimum(search *s, const po_range_follower *f, const po_kept_point *jump,
                                po_result *result) {
  const int last = s->before.at + PO_RANGES_OF_LIMIT - 1;
  bool is_traced = !jump;
  po_status status = follow_point(f, s->minimum, s->before.at, last, PO_RANGE_ENOUGH, &s->pull_off);
  if (po_reduced_ends(status) || isinf(excess_of(&s->ranges, &s->pull_off)))
    return status ? status : PO_NOT_CONVERGED;
  if (!is_traced && !is_kept_by(s->ranges.request, &s->before, &s->pull_off))
    return PO_NOT_CONVERGED;
  status = follow_rivals(s, f, jump, &is_traced);
  if (!status && is_traced)
    status = judge_any(s, f);
  if (status)
    return status;
  s->next = -1;
  return conclude(s, f, is_traced, result);
}

/* Follows the pull-off of the last trace to the range of the one before, where it has to be a
 * minimum, although a jump that only the greater range makes may lead to a deeper one; then the
 * jumps of loading to smaller ones, then what is the pull-off at the true range. Returned: s->next:
 * -1 if the solve is complete. */
static po_status follow_all(search *s, const po_range_follower *f, po_result *result) {
  s->minimum = pull_off_of(&s->now);
  po_status status = follow_point(f, s->minimum, s->before.at, s->now.at, INFINITY, &s->pull_off);
  if (status)
    return status;
  if (!is_kept_by(s->ranges.request, &s->before, &s->pull_off))
    return PO_NOT_CONVERGED;
  bool known;
  const po_kept_point *before;
  status = po_range_find_reversal(f, &known, &before);
  if (status)
    return status;
  if (before)
    s->minimum = deepest_before(&s->now, before);
  s->is_reversed_before = before;
  if (known && s->minimum)
    return follow_minimum(s, f, before, result);
  s->next = -1;
  take_result(s, result);
  return undecided(&s->ranges, result);
}

/* The same, of which only failures that end the solve are returned. */
static po_status follow_trace(search *s, po_result *result) {
  po_range_follower f = {.ranges = &s->ranges, .trace = &s->now, .track = &s->work_track};
  po_status status = po_range_course_create(&s->ranges, &s->now, &f.course);
  if (!status)
    status = follow_all(s, &f, result);
  po_range_course_destroy(f.course, &s->work);
  return s->next < 0 || po_reduced_ends(status) ? status : PO_OK;
}

/* Makes the trace with the next range, and follows its points. */
static po_status go_on(search *s, po_reduced_solver *solve, int *failures, po_result *result) {
  const int at = s->next;
  po_status status = trace_one(&s->ranges, at, solve, &s->now);
  po_work_add(&s->now.result.work, &s->work);
  const bool fails = status || !s->now.result.has_pull_off || !pull_off_of(&s->now);
  *failures = fails ? *failures + 1 : 0;
  s->next = at + (fails ? 1 : PO_RANGE_STRIDE);
  if (fails) {
    take_result(s, result);
    clear_trace(&s->before);
    clear_trace(&s->now);
    return status;
  }
  if (s->before.at >= 0)
    status = follow_trace(s, result);
  clear_trace(&s->before);
  s->before = s->now;
  s->now = no_trace();
  if (s->next != s->before.at + PO_RANGE_STRIDE)
    clear_trace(&s->before);
  return status;
}

po_status po_reduced_solve(const po_request *request, po_reduced_solver *solve, po_result *result) {
  search *s = po_allocate(1, sizeof *s);
  *result = po_result_none();
  if (!s)
    return PO_NO_MEMORY;
  s->ranges = po_ranges_of(request);
  s->before = s->now = no_trace();
  po_status status = PO_OK;
  int failures = 0;
  while (s->next >= 0 && s->next < s->ranges.count && failures < FAILURES &&
         !po_reduced_ends(status))
    status = go_on(s, solve, &failures, result);
  if (!status && s->next >= 0)
    status = po_fail(PO_NOT_CONVERGED,
                     "no range of the attraction %.3g to %.3g times as great "
                     "leads to the pull-off: expected the range exact",
                     s->ranges.range[s->ranges.count - 1], s->ranges.range[0]);
  result->work = s->work;
  if (!status && request->want & PO_WANT_PRELOAD)
    status = po_reduced_staircases(&s->ranges, solve, result);
  if (!status && request->want & PO_WANT_HYSTERESIS)
    status = s->is_reversed_before ? without_loops() : po_reduced_loops(&s->ranges, solve, result);
  clear_trace(&s->before);
  clear_trace(&s->now);
  free(s);
  return status;
}
