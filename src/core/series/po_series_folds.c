/* The folds of the first scene of a series, followed along it. */
#include <math.h>
#include <stdio.h>

#include "po_memory.h"
#include "po_series.h"
#include "po_series_scenes.h"

/* A fold that is followed, by its place in the results. */
typedef struct {
  po_series_course course;
  size_t place;
} followed;

static void record_fold(void *data, size_t index, const po_branch_point *p) {
  const followed *f = data;
  (void)p;
  po_special_point *fold = &f->course.scenes->results[index].folds[f->place];
  const po_special_point first = *fold;
  *fold = po_series_estimate(&f->course, index).point;
  fold->kind = first.kind;
  fold->unstable_modes = first.unstable_modes;
  fold->energy = fold->energy_error = fold->position = NAN;
}

/* Fails all scenes to which a fold was not followed: whether it exists there is unknown. */
static void fail_others(const po_series_scenes *l, size_t place, po_status status) {
  for (size_t k = 1; k < l->count; ++k) {
    po_result *o = &l->results[k];
    if (!isnan(o->folds[place].approach))
      continue;
    o->status = status;
    snprintf(o->reason, sizeof o->reason, "%s",
             *po_message() ? po_message() : po_status_text(status));
  }
}

/* Follows one fold until it ends. Status: PO_INTERRUPTED, PO_NO_MEMORY. */
static po_status follow(followed *f, const po_solution *point) {
  const po_series_scenes *l = f->course.scenes;
  const po_status status = po_series_follow(&f->course, point, 0, l->count - 1);
  if (status == PO_INTERRUPTED)
    return status;
  if (status && status != PO_NOT_FOUND)
    fail_others(l, f->place, status);
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

static po_status follow_all(const po_series_scenes *l, const po_kept_points *folds) {
  followed f = {.course = {.scenes = l, .of = PO_OF_APPROACH, .record = record_fold}};
  f.course.data = &f;
  po_status status = allocate_folds(l);
  if (!status)
    status = po_series_course_begin(&f.course, 0, folds->tolerance);
  for (; f.place < folds->count && !status; ++f.place)
    status = follow(&f, &folds->points[f.place].point);
  po_follow_destroy(f.course.follower);
  return status;
}

static po_status solve(const po_series_scenes *l) {
  const po_request *requests = l->requests;
  for (size_t k = 0; k + 1 < l->count; ++k)
    if (!po_series_alike(&requests[k], &requests[k + 1]))
      return po_fail(
          PO_BAD_INPUT,
          "folds are not followed from scene %zu to the next: expected both "
          "wavy or both smooth, both bounded or both unbounded, and no viscoelastic body",
          k + 1);
  po_kept_points f = {.which = PO_KEEP_FOLDS};
  po_status status = po_solve_kept(&requests[0], &f, &l->results[0]);
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
