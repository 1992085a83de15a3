/* The folds of the first scene of a series, followed along it. */
#include <math.h>
#include <stdio.h>

#include "po_estimate.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_series.h"
#include "po_series_scenes.h"
#include "po_watch.h"

/* Records the special point at which the follower is. Returned: false if the contact reaches the
 * end of the core of the surface. */
static bool record_fold(po_follower *follower, const po_request *request, po_special_point *fold) {
  po_branch_point p = po_follow_point(follower, false);
  if (po_series_is_cut_off(request, &p))
    return false;
  p = po_follow_point(follower, true);
  const po_estimate e = po_estimate_of(request, &p);
  const po_special_point first = *fold;
  *fold = e.point;
  fold->kind = first.kind;
  fold->unstable_modes = first.unstable_modes;
  fold->energy = fold->energy_error = fold->position = NAN;
  return true;
}

/* Marks all scenes from `first` on: whether the fold exists there is unknown. */
static void fail_from(const po_series_scenes *l, size_t first, po_status status) {
  for (size_t k = first; k < l->count; ++k) {
    po_result *o = &l->results[k];
    o->status = status;
    snprintf(o->reason, sizeof o->reason, "%s", po_message());
  }
}

/* Follows one fold until it ends. Status: PO_INTERRUPTED, PO_NO_MEMORY. */
static po_status follow(const po_series_scenes *l, po_follower *follower, const po_solution *point,
                        size_t place, po_work *before) {
  po_status status = po_follow_begin(follower, point, PO_OF_APPROACH, 0.0);
  for (size_t k = 1; k < l->count && !status; ++k) {
    const po_request *request = &l->requests[k];
    po_result *o = &l->results[k];
    if (request->stop && *request->stop)
      return po_fail(PO_INTERRUPTED, "interrupted in a series of scenes");
    if (request->watch)
      request->watch(request->watcher, (double)NAN, (double)NAN);
    const double start = po_clock_wall();
    status = po_follow_to(follower, (double)k, po_observe_deadline(request));
    if (!status && !record_fold(follower, request, &o->folds[place]))
      status = PO_NOT_FOUND;
    po_series_add_work(follower, po_clock_wall() - start, before, &o->work);
    if (status == PO_OUT_OF_TIME)
      fail_from(l, k, status);
  }
  po_message_clear();
  return status == PO_NO_MEMORY ? status : PO_OK;
}

/* Allocates the folds of the first scene in all other results, initially as ended. */
static po_status allocate_folds(const po_series_scenes *l) {
  const po_result *first = &l->results[0];
  for (size_t k = 1; k < l->count; ++k) {
    po_result *o = &l->results[k];
    o->followed = true;
    o->folds = po_allocate(first->fold_count, sizeof *o->folds);
    if (!o->folds)
      return PO_NO_MEMORY;
    o->fold_count = first->fold_count;
    for (size_t j = 0; j < first->fold_count; ++j) {
      o->folds[j] = (po_special_point){.kind = first->folds[j].kind,
                                       .unstable_modes = first->folds[j].unstable_modes,
                                       .contact_radius = NAN,
                                       .contact_radius_error = NAN,
                                       .contact_radius_other = NAN};
      o->folds[j].approach = o->folds[j].load = o->folds[j].energy = o->folds[j].position = NAN;
      o->folds[j].approach_error = o->folds[j].load_error = o->folds[j].energy_error = NAN;
    }
  }
  return PO_OK;
}

static po_status follow_all(const po_series_scenes *l, const po_kept_points *f) {
  po_follower *follower = NULL;
  po_work before = {0};
  po_status status = allocate_folds(l);
  if (!status)
    status = po_series_follower(l, 0, f->tolerance, &follower);
  for (size_t j = 0; j < f->count && !status; ++j)
    status = follow(l, follower, &f->points[j].point, j, &before);
  po_follow_destroy(follower);
  return status;
}

static po_status solve(const po_series_scenes *l) {
  const po_request *requests = l->requests;
  for (size_t k = 0; k + 1 < l->count; ++k)
    if (!po_series_alike(&requests[k], &requests[k + 1]))
      return po_fail(PO_BAD_INPUT,
                     "folds are not followed from scene %zu to the next: expected both "
                     "wavy or both smooth, both bounded or both unbounded",
                     k + 1);
  po_kept_points f = {.minima = false};
  po_status status = po_series_trace(&requests[0], &f, &l->results[0]);
  if (status != PO_NO_MEMORY && status != PO_INTERRUPTED)
    status = PO_OK;
  /* the numbers differ for a rigid scene, and for one whose curve begins after the first fold */
  if (!status && !l->results[0].status && f.count == l->results[0].fold_count)
    status = follow_all(l, &f);
  po_kept_points_clear(&f);
  return status;
}

po_status po_series_folds(const po_request *requests, size_t count, po_result *results) {
  return po_series_solve((po_series_scenes){requests, results, count, 0}, solve);
}
