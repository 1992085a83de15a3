#include "po_checkpoint.h"

#include <math.h>
#include <stdlib.h>

#include "po_memory.h"
#include "po_observe_parts.h"

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

po_status po_checkpoint_trace(const po_request *request, size_t index, po_result *result,
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

void po_checkpoint_clear(po_checkpoint *a) {
  free_points(a);
  free(a->minima);
  *a = (po_checkpoint){0};
}
