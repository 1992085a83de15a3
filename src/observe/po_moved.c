#include <math.h>

#include "po_clock.h"
#include "po_diagnose.h"
#include "po_observe_parts.h"

/* The largest change of the approach of a fold; NaN if the number of folds differs. */
static double change_of_folds(const po_result *a, const po_result *b) {
  double largest = 0.0;
  for (size_t k = 0; k < a->fold_count && a->fold_count == b->fold_count; ++k)
    largest = fmax(largest, fabs(a->folds[k].approach - b->folds[k].approach));
  return a->fold_count == b->fold_count ? largest : (double)NAN;
}

static po_status move(const po_request *request, const po_result *result, po_moved *moved) {
  po_result again;
  const po_status status = po_observe_kept(request, NULL, &again);
  ++moved->solves;
  if (status || !again.has_pull_off) {
    ++moved->failed;
  } else {
    const double change = fabs(again.pull_off.force / result->pull_off.force - 1.0);
    const double excess = fabs(again.pull_off.force - result->pull_off.force) /
                          (again.pull_off.force_error + result->pull_off.force_error);
    moved->change = fmax(moved->change, change); /* the first is NaN */
    moved->excess = fmax(moved->excess, excess);
    const double folds = change_of_folds(result, &again);
    if (!(folds <= moved->folds)) /* NaN stays */
      moved->folds = isnan(moved->folds) ? moved->folds : folds;
  }
  po_result_clear(&again);
  const bool ends = status == PO_NO_MEMORY || status == PO_INTERRUPTED || status == PO_OUT_OF_TIME;
  return ends ? status : PO_OK;
}

po_status po_diagnose_moved(const po_request *request, double deadline, po_result *result) {
  po_diagnostics *d = &result->diagnostics;
  po_request moving = *request;
  moving.want &= ~(unsigned)PO_WANT_DIAGNOSTICS; /* the other results may change the steps */
  const bool wavy = po_scene_is_wavy(&request->scene);
  const struct {
    double *value, by;
  } inputs[] = {{&moving.scene.tabor, d->force.tabor},
                {&moving.scene.radius, d->force.radius},
                {&moving.scene.amplitude, d->force.amplitude},
                {&moving.scene.wavelength, d->force.wavelength}};
  const double begin = po_clock_wall();
  double most = 0.0;
  po_status status = PO_OK;
  for (size_t k = 0; k < (wavy ? 4 : 2); ++k) {
    const double is = *inputs[k].value;
    for (int up = 0; !status && up < 2 && is > 0.0; ++up) {
      *inputs[k].value = nextafter(is, up ? INFINITY : 0.0);
      most = fmax(most, fabs(inputs[k].by * (*inputs[k].value / is - 1.0)));
      if (isfinite(deadline))
        moving.time_limit = deadline - po_clock_thread();
      status = moving.time_limit <= 0.0 ? PO_OUT_OF_TIME : move(&moving, result, &d->moved);
      if (status == PO_OUT_OF_TIME)
        status =
            po_diagnose_out_of_time(request, "the solves with changed inputs are not complete");
    }
    *inputs[k].value = is;
  }
  if (d->has_sensitivity)
    d->moved.predicted = most + fabs(d->force.residual) + d->force.rounding;
  d->seconds += po_clock_wall() - begin;
  return status;
}
