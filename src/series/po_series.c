#include "po_series.h"

#include <stdlib.h>

#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_series_minima.h"
#include "po_series_scenes.h"

/* A checkpoint of a series of scenes: a scene that is traced completely, with the minima of its
 * load. */

/* Minima whose load is at least this fraction of the deepest one may become the deepest before the
 * next checkpoint. Example: at A = 5.024, lambda = 20, R = 100 (eps) a minimum of load -0.69 at mu
 * = 5 is the deepest for mu = 2.9 to 3.8 and does not exist at mu = 1.4. */
static const double CANDIDATE_DEPTH = 0.3;

static void free_points(po_checkpoint *a) {
  for (size_t k = 0; k < a->count; ++k)
    po_solution_free(&a->minima[k].point);
  a->count = 0;
}

static void begin(void *data, double tolerance) {
  po_checkpoint *a = data;
  free_points(a);
  a->tolerance = tolerance;
}

static bool keep(void *data, const po_branch_point *point, double margin) {
  po_checkpoint *a = data;
  if (!point->solution || point->kind != PO_POINT_LOAD_MIN || !(point->load < 0.0))
    return true;
  po_checkpoint_minimum *minima = po_grow(a->minima, a->count, &a->room, sizeof *minima);
  if (!minima)
    return false;
  a->minima = minima;
  po_checkpoint_minimum *m = &minima[a->count++];
  *m = (po_checkpoint_minimum){.approach = point->approach, .load = point->load, .margin = margin};
  if (po_solution_allocate(&m->point, point->solution->n))
    return false;
  po_solution_copy(point->solution, &m->point);
  return true;
}

static int by_depth(const void *left, const void *right) {
  const double a = ((const po_checkpoint_minimum *)left)->load;
  const double b = ((const po_checkpoint_minimum *)right)->load;
  return (a > b) - (a < b);
}

/* Traces a scene. Returned: its result; the checkpoint, with the minima in the order of their
 * depth, the pull-off first, to be cleared with checkpoint_clear. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED. A trace that fails gives a checkpoint that is not usable. */
static po_status checkpoint_trace(const po_request *request, size_t index, po_result *result,
                                  po_checkpoint *a) {
  *a = (po_checkpoint){.index = index};
  const po_keeper keeper = {begin, keep, a, true};
  const po_status status = po_observe_kept(request, &keeper, result);
  if (status == PO_NO_MEMORY || status == PO_INTERRUPTED)
    return status;
  a->usable = !status && a->count > 0;
  if (!a->usable) {
    free_points(a);
    return PO_OK;
  }
  qsort(a->minima, a->count, sizeof *a->minima, by_depth);
  a->deepest = a->minima[0].load;
  while (a->candidates < a->count && a->minima[a->candidates].load <= CANDIDATE_DEPTH * a->deepest)
    ++a->candidates;
  return PO_OK;
}

static void checkpoint_clear(po_checkpoint *a) {
  free_points(a);
  free(a->minima);
  *a = (po_checkpoint){0};
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
    checkpoint_clear(&unused);
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
  checkpoint_clear(&middle);
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
    checkpoint_clear(&from);
    from = to;
    to = (po_checkpoint){0};
  }
  checkpoint_clear(&from);
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
