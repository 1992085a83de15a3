#include "po_series.h"

#include <stdlib.h>

#include "po_series_scenes.h"

/* A checkpoint of a series of scenes: a scene that is traced completely, with the minima of its
 * load. */

/* Minima whose load is at least this fraction of the deepest one may become the deepest before the
 * next checkpoint. Example: at A = 5.024, lambda = 20, R = 100 (eps) a minimum of load -0.69 at mu
 * = 5 is the deepest for mu = 2.9 to 3.8 and does not exist at mu = 1.4. */
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
                                  po_checkpoint *a) {
  *a = (po_checkpoint){.index = index, .kept = {.minima = true}};
  const po_status status = po_series_trace(request, &a->kept, result);
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

static po_status trace(const po_series_scenes *l, size_t index, po_checkpoint *checkpoint) {
  po_result *o = &l->results[index];
  const po_work spent = o->work; /* on minima that did not agree */
  po_result_clear(o);
  const po_status status = checkpoint_trace(&l->requests[index], index, o, checkpoint);
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
    po_checkpoint unused;
    status = trace(l, k, &unused);
    po_kept_points_clear(&unused.kept);
  }
  return status;
}

/* Computes the scenes between two checkpoints: follows the minima, or traces the middle scene and
 * continues with both halves. */
static po_status solve_between(const po_series_scenes *l, po_checkpoint *from, po_checkpoint *to) {
  if (to->index - from->index < 2)
    return PO_OK;
  bool settled;
  po_status status = po_series_follow_minima(l, from, to, &settled);
  if (settled)
    return trace_inaccurate(l, from->index + 1, to->index);
  po_checkpoint middle = {0};
  if (!status)
    status = trace(l, from->index + (to->index - from->index) / 2, &middle);
  if (!status)
    status = solve_between(l, from, &middle);
  if (!status)
    status = solve_between(l, &middle, to);
  po_kept_points_clear(&middle.kept);
  return status;
}

/* po_series_observe for requests in the units of their solves. */
static po_status observe(const po_request *requests, size_t count, size_t checkpoint_every,
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
      status = solve_between(&l, &from, &to);
    po_kept_points_clear(&from.kept);
    from = to;
    to = (po_checkpoint){0};
  }
  po_kept_points_clear(&from.kept);
  return status;
}

po_status po_series_observe(const po_request *requests, size_t count, size_t checkpoint_every,
                            po_result *results) {
  po_request *solved = po_series_requests(requests, count);
  if (!solved)
    return PO_NO_MEMORY;
  const po_status status = observe(solved, count, checkpoint_every, results);
  po_series_finish(solved, count, results);
  return status;
}
