#include "po_series.h"

#include <math.h>
#include <stdlib.h>

#include "po_checkpoint.h"
#include "po_clock.h"
#include "po_contact.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_series_scenes.h"

/* A minimum that was followed and one that was traced are the same when their loads differ by no
 * more than this many tolerances, and their approaches by this part. */
static const double SAME_LOAD = 10.0, SAME_APPROACH = 1e-2;

/* A minimum followed from one checkpoint towards the other. */
typedef struct {
  const po_checkpoint_minimum *from, *met; /* what the traces have of it; met NULL: nothing */
  double lost;                             /* its load where it ended on the way; NAN: it did not */
} followed;

/* The stretch between two checkpoints. */
typedef struct {
  const po_series_scenes *l;
  po_checkpoint *from, *to;
  po_follower *follower;
  size_t inside; /* scenes between */
  double *load;  /* a row of inside + 2 for each minimum followed: its load, NAN: not there */
  followed *row; /* one a row */
  size_t rows;
  po_series_work before;
} stretch;

static bool may_follow(const stretch *s) {
  if (!s->from->usable || !s->to->usable)
    return false;
  for (size_t k = s->from->index; k < s->to->index; ++k)
    if (!po_series_alike(&s->l->requests[k], &s->l->requests[k + 1]))
      return false;
  return true;
}

static double *load_of(const stretch *s, size_t row, size_t index) {
  return &s->load[row * (s->inside + 2) + index - s->from->index];
}

/* The deepest of what was followed to a scene, and traced there. */
static double deepest_at(const stretch *s, size_t index) {
  double deepest = INFINITY;
  for (size_t row = 0; row < s->rows; ++row)
    deepest = fmin(deepest, *load_of(s, row, index)); /* fmin passes over NAN */
  return deepest;
}

static double sameness(const stretch *s, double load) {
  return SAME_LOAD * s->l->requests[s->from->index].mesh.tolerance * fabs(load);
}

/* Takes the minimum that the follower is at for the pull-off of a scene, if it is the deepest so
 * far. Returned: its load; NAN when the contact reaches the end of the core of the surface. */
static double take(stretch *s, size_t index) {
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

/* The minimum of a checkpoint that the follower has arrived at; NULL: none of the trace. */
static const po_checkpoint_minimum *find_arrived(const stretch *s, const po_checkpoint *at) {
  const po_branch_point p = po_follow_point(s->follower, false);
  const po_checkpoint_minimum *best = NULL;
  double nearest = SAME_APPROACH * (1.0 + fabs(p.approach));
  for (size_t k = 0; k < at->count; ++k) {
    const double apart = fabs(at->minima[k].approach - p.approach);
    if (fabs(at->minima[k].load - p.load) < sameness(s, p.load) && apart < nearest) {
      nearest = apart;
      best = &at->minima[k];
    }
  }
  return best;
}

/* Follows a minimum of one checkpoint towards the other. Status: as of po_run; a minimum that is
 * lost on the way is no failure. */
static po_status follow(stretch *s, const po_checkpoint_minimum *m, bool forward) {
  const po_checkpoint *from = forward ? s->from : s->to;
  const size_t row = s->rows++, steps = s->inside + 1;
  s->row[row] = (followed){.from = m, .lost = NAN};
  for (size_t k = 0; k <= steps; ++k)
    *load_of(s, row, s->from->index + k) = NAN;
  *load_of(s, row, from->index) = m->load;
  double begin = po_clock_wall();
  po_status status = po_follow_begin(s->follower, &m->point, PO_OF_LOAD, (double)from->index);
  for (size_t k = 1; k <= steps && !status; ++k) {
    const size_t index = forward ? from->index + k : from->index - k;
    const volatile sig_atomic_t *stop = s->l->requests[index].stop;
    if (stop && *stop)
      return po_fail(PO_INTERRUPTED, "interrupted on a line");
    status = po_follow_to(s->follower, (double)index, po_observe_deadline(&s->l->requests[index]));
    if (!status)
      *load_of(s, row, index) = take(s, index);
    const double now = po_clock_wall();
    po_series_add_work(s->follower, now - begin, &s->before, &s->l->results[index].work);
    begin = now;
    if (!status && isnan(*load_of(s, row, index)))
      status = PO_NOT_FOUND;
  }
  if (status)
    s->row[row].lost = po_follow_point(s->follower, false).load;
  else
    s->row[row].met = find_arrived(s, forward ? s->to : s->from);
  po_message_clear();
  return status == PO_NO_MEMORY ? status : PO_OK;
}

/* The load, at both of two neighbouring scenes at least so deep, of the deepest minimum that was
 * followed from one to the other; INFINITY: none. */
static double spanning_load(const stretch *s, size_t index) {
  double load = INFINITY;
  for (size_t row = 0; row < s->rows; ++row) {
    const double here = *load_of(s, row, index), there = *load_of(s, row, index + 1);
    if (!isnan(here) && !isnan(there))
      load = fmin(load, fmax(here, there));
  }
  return load;
}

/* Whether a minimum is the pull-off of a scene between. */
static bool is_pull_off(const stretch *s, size_t row) {
  bool is = false;
  for (size_t k = s->from->index + 1; k < s->to->index; ++k)
    is = is || *load_of(s, row, k) == deepest_at(s, k);
  return is;
}

/* Whether traces of the scenes between would come as far as a minimum, as those of both checkpoints
 * did: they end where the sphere is pressed enough, and as a minimum before grows deeper, or the
 * load between, that may be short of it. Both must have come to it with room to spare, by which
 * they differ by less than either has. */
static bool is_within(const followed *f) {
  return f->met && fmin(f->from->margin, f->met->margin) > fabs(f->from->margin - f->met->margin);
}

/* Whether what was followed agrees with both traces, and gives every scene between its pull-off. */
static bool agrees(const stretch *s) {
  const size_t first = s->from->index, last = s->to->index;
  if (deepest_at(s, first) < s->from->deepest - sameness(s, s->from->deepest) ||
      deepest_at(s, last) < s->to->deepest - sameness(s, s->to->deepest))
    return false;
  for (size_t row = 0; row < s->rows; ++row)
    for (size_t k = first; k < last; ++k) /* a minimum that ends on the way is not the deepest */
      if (isnan(*load_of(s, row, k)) != isnan(*load_of(s, row, k + 1)) &&
          !(s->row[row].lost > spanning_load(s, k)))
        return false;
  for (size_t row = 0; row < s->rows; ++row)
    if (is_pull_off(s, row) && !is_within(&s->row[row]))
      return false;
  for (size_t k = first + 1; k < last; ++k)
    if (!isfinite(deepest_at(s, k)))
      return false;
  return true;
}

static bool has_arrived(const stretch *s, const po_checkpoint_minimum *m) {
  bool has = false;
  for (size_t row = 0; row < s->rows; ++row)
    has = has || s->row[row].met == m;
  return has;
}

/* Follows the minima between two checkpoints. Returned: whether that settles the scenes between. */
static po_status follow_between(stretch *s, bool *settled) {
  const size_t most = s->from->deep + s->to->deep;
  const double tolerance = fmin(s->from->tolerance, s->to->tolerance);
  s->load = po_allocate(most * (s->inside + 2), sizeof *s->load);
  s->row = po_allocate(most, sizeof *s->row);
  po_status status = s->load && s->row ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = po_series_follower(s->l, s->from->index, s->to->index, tolerance, &s->follower);
  for (size_t k = 0; k < s->from->deep && !status; ++k)
    status = follow(s, &s->from->minima[k], true);
  for (size_t k = 0; k < s->to->deep && !status; ++k)
    if (!has_arrived(s, &s->to->minima[k]))
      status = follow(s, &s->to->minima[k], false);
  *settled = !status && agrees(s);
  po_follow_destroy(s->follower);
  free(s->load);
  free(s->row);
  return status;
}

static po_status trace(const po_series_scenes *l, size_t index, po_checkpoint *checkpoint) {
  po_result *o = &l->results[index];
  const po_work spent = o->work; /* on following what did not agree */
  po_result_clear(o);
  const po_status status = po_checkpoint_trace(&l->requests[index], index, o, checkpoint);
  o->work.points += spent.points;
  o->work.newton_iterations += spent.newton_iterations;
  o->work.factorizations += spent.factorizations;
  o->work.meshes += spent.meshes;
  o->work.kernel_evaluations += spent.kernel_evaluations;
  o->work.seconds += spent.seconds;
  return status;
}

/* Traces the scenes whose error estimate misses the tolerance, or that have none. */
static po_status trace_what_errs(const stretch *s) {
  po_status status = PO_OK;
  for (size_t k = s->from->index + 1; k < s->to->index && !status; ++k) {
    const po_result *o = &s->l->results[k];
    if (o->pull_off.force_error <= s->l->requests[k].mesh.tolerance * o->pull_off.force)
      continue;
    po_checkpoint unused;
    status = trace(s->l, k, &unused);
    po_checkpoint_clear(&unused);
  }
  return status;
}

static po_status fill(const po_series_scenes *l, po_checkpoint *from, po_checkpoint *to) {
  if (to->index - from->index < 2)
    return PO_OK;
  stretch s = {.l = l, .from = from, .to = to, .inside = to->index - from->index - 1};
  bool settled = false;
  po_status status = may_follow(&s) ? follow_between(&s, &settled) : PO_OK;
  if (settled)
    return trace_what_errs(&s);
  po_checkpoint middle = {0};
  if (!status)
    status = trace(l, from->index + (to->index - from->index) / 2, &middle);
  if (!status)
    status = fill(l, from, &middle);
  if (!status)
    status = fill(l, &middle, to);
  po_checkpoint_clear(&middle);
  return status;
}

po_status po_series_observe(const po_request *requests, size_t count, size_t checkpoint_every,
                            po_result *results) {
  const po_series_scenes l = {requests, results, count};
  for (size_t k = 0; k < count; ++k)
    results[k] = po_result_none();
  if (count == 0)
    return PO_OK;
  po_checkpoint from, to = {0};
  po_status status = trace(&l, 0, &from);
  for (size_t index = 0; index + 1 < count && !status;) {
    index = count - 1 - index > checkpoint_every ? index + checkpoint_every : count - 1;
    status = trace(&l, index, &to);
    if (!status)
      status = fill(&l, &from, &to);
    po_checkpoint_clear(&from);
    from = to;
    to = (po_checkpoint){0};
  }
  po_checkpoint_clear(&from);
  return status;
}
