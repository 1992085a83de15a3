/* Solves with changed inputs: by a unit in the last place, for the diagnostics; and by their
 * uncertainty, for that of the pull-off force to first order. */
#include <math.h>
#include <stdio.h>

#include "po_deadline.h"
#include "po_diagnose.h"
#include "po_load_unit.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_profile_table.h"
#include "po_solve_internal.h"

/* Solves a request with a changed input, as long as the deadline of the solve permits. Given: what
 * is missing if it does not. Returned: again, to be cleared. Status: PO_OK also if the solve fails;
 * PO_NO_MEMORY, PO_INTERRUPTED, PO_OUT_OF_TIME. */
static po_status solve_again(const po_request *request, const po_request *moved,
                             const char *missing, po_result *again) {
  const po_status status = po_solve_kept(moved, NULL, again);
  if (status == PO_OUT_OF_TIME)
    return po_diagnose_out_of_time(request, missing);
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

/* The largest change of the approach of a fold; NaN if the number of folds differs. */
static double change_of_folds(const po_result *a, const po_result *b) {
  double largest = 0.0;
  for (size_t k = 0; k < a->fold_count && a->fold_count == b->fold_count; ++k)
    largest = fmax(largest, fabs(a->folds[k].approach - b->folds[k].approach));
  return a->fold_count == b->fold_count ? largest : (double)NAN;
}

/* Solves with a parameter moved. */
static po_status move(const po_request *request, const po_request *moving, const po_result *result,
                      po_moved *moved) {
  po_result again;
  const po_status status =
      solve_again(request, moving, "the solves with changed inputs are not complete", &again);
  ++moved->solves;
  if (again.status || !again.has_pull_off) {
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
  return status;
}

static po_status diagnose_moved(const po_request *request, po_result *result) {
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
      status = move(request, &moving, result, &d->moved);
    }
    *inputs[k].value = is;
  }
  if (d->has_sensitivity)
    d->moved.predicted = most + fabs(d->force.residual) + d->force.rounding;
  d->seconds += po_clock_wall() - begin;
  return status;
}

/* -- Uncertain inputs -- */

/* The force is linear if its changes to both sides, and that of the adjoint, differ from their mean
 * by at most this part of it. With the change a s + b s^2/2 by an input s of deviation 1, at s = 2,
 * the part is b/a, and the true standard deviation, sqrt(a^2 + b^2/2), exceeds a by 1 % at most; a
 * jump on one side is seen from a on. */
static const double LINEAR = 0.2;

/* A source that is not linear and changes the force by at most this part of the uncertainty by the
 * others has the greater of its changes: it changes that of all by 0.5 % at most. */
static const double SMALL = 0.1;

/* Of a force without an error, relative to it. */
static const double ROUNDING = 1e-12;

/* The standard uncertainty. Given: the changes, and the standard uncertainty by the adjoint, NAN:
 * not known. Changes as small as the error of the force, or as rounding if it has no error, are not
 * compared. */
static double force_of(const po_uncertain *u, double adjoint, const po_result *o) {
  const double error = fmax(o->pull_off.force_error, ROUNDING * o->pull_off.force);
  const double mean = 0.5 * fabs(u->above - u->below) / PO_VARIATION_REACH;
  const double bend = 0.5 * fabs(u->above + u->below) / PO_VARIATION_REACH;
  const double off = isnan(adjoint) ? 0.0 : fabs(adjoint - mean);
  if (fmax(bend, off) <= fmax(LINEAR * mean, error))
    return isnan(adjoint) ? mean : adjoint;
  return (double)NAN; /* also if a change is */
}

/* Solves with an input moved. Returned: the change of the force, unchanged if the solve failed. */
static po_status solve(const po_request *request, const po_request *moved, double unit,
                       const po_result *o, double *change) {
  po_request r = *moved;
  po_result again;
  r.want = 0;
  r.search = PO_SEARCH_NONE;
  r.stop = request->stop;
  r.watch = NULL;
  r.show = NULL;
  r.time_limit = NAN;
  const po_status status =
      solve_again(request, &r, "the solves with uncertain inputs are not complete", &again);
  if (!again.status && again.has_pull_off)
    *change = again.pull_off.force * unit - o->pull_off.force;
  po_result_clear(&again);
  return status;
}

/* The next source of the result. */
static po_uncertain *begin(po_result *o, const char *source, double value, double deviation) {
  po_uncertain *u = &o->uncertain[o->uncertain_count++];
  *u = (po_uncertain){.value = value, .deviation = deviation, .below = NAN, .above = NAN};
  snprintf(u->source, sizeof u->source, "%s", source);
  return u;
}

static po_status vary_input(const po_request *request, const po_variation *v, po_result *o) {
  const double solved = po_scene_load_unit(&request->scene);
  po_uncertain *u = begin(o, v->source, v->value, v->deviation);
  po_status status = PO_OK;
  for (int k = 0; k < 2 && !status; ++k) {
    const po_request moved = po_load_unit_request(v->moved[k]);
    const double unit = v->unit[k] * po_scene_load_unit(&moved.scene) / solved;
    status = solve(request, &moved, unit, o, k ? &u->above : &u->below);
  }
  u->force = force_of(u, (double)NAN, o);
  return status;
}

/* The profile is changed as it most probably is where the force is off by its deviation. */
static po_status vary_profile(const po_request *request, po_result *o) {
  const po_profile_table *table = request->scene.profile.table;
  po_uncertain *u = begin(o, "noise", (double)NAN, table->smoothing.deviation / table->scale);
  po_status status = PO_OK;
  for (int k = 0; k < 2 && !status; ++k) { /* where the load falls, the force grows */
    po_profile_table *displaced;
    po_request moved = *request;
    status = po_profile_table_displace(table, o->noise.change,
                                       k ? -PO_VARIATION_REACH : PO_VARIATION_REACH, &displaced);
    moved.scene.profile.table = displaced;
    if (!status)
      status = solve(request, &moved, 1.0, o, k ? &u->above : &u->below);
    po_profile_table_free(displaced);
  }
  u->force = force_of(u, o->noise.deviation, o);
  return status;
}

static void add_squares(po_result *o) {
  double linear = 0.0, squares = 0.0;
  for (size_t k = 0; k < o->uncertain_count; ++k)
    if (!isnan(o->uncertain[k].force))
      linear += o->uncertain[k].force * o->uncertain[k].force;
  for (size_t k = 0; k < o->uncertain_count; ++k) {
    po_uncertain *u = &o->uncertain[k];
    const double most =
        0.5 * (fabs(u->above + u->below) + fabs(u->above - u->below)) / PO_VARIATION_REACH;
    if (isnan(u->force) && most <= SMALL * sqrt(linear))
      u->force = most;
    squares += u->force * u->force;
  }
  o->uncertainty = sqrt(squares);
}

static po_status find_uncertainty(const po_request *request, po_result *o) {
  const size_t count = request->variations + (o->noise.change != NULL);
  if (count == 0)
    return PO_OK;
  o->uncertain = po_allocate(count, sizeof *o->uncertain);
  po_status status = o->uncertain ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; k < request->variations && !status; ++k)
    status = vary_input(request, &request->variation[k], o);
  if (o->noise.change && !status)
    status = vary_profile(request, o);
  add_squares(o);
  if (!status)
    po_message_clear();
  return status;
}

/* -- The interpolation of a table without noise -- */

/* Part of the force up to which a change of first order is taken. The second order is about as
 * large a part of the change as the change is of the force. */
static const double FIRST_ORDER = 0.05;

/* The change of the force by another spline through the rows. */
static po_status change_of_reading(const po_request *request, po_reading reading, po_result *o,
                                   double *change) {
  po_profile_table *again;
  po_request moved = *request;
  po_status status = po_profile_table_read_again(request->scene.profile.table, reading, &again);
  if (status)
    return status;
  moved.scene.profile.table = again;
  double load = 0.0;
  for (size_t i = 0; i < o->interpolation.weight_count; ++i) {
    const double r = o->interpolation.weights[2 * i];
    load += o->interpolation.weights[2 * i + 1] * (po_profile_gap(&moved.scene.profile, 1.0, r) -
                                                   po_profile_gap(&request->scene.profile, 1.0, r));
  }
  *change = -load; /* where the load falls, the force grows */
  if (!(fabs(load) <= FIRST_ORDER * o->pull_off.force)) {
    *change = NAN;
    o->interpolation.solved = true;
    status = solve(request, &moved, 1.0, o, change);
  }
  po_profile_table_free(again);
  return status;
}

/* The changes by the other readings of the rows. An error that all of these splines share is not
 * seen. */
static po_status read_again(const po_request *request, po_result *o) {
  if (!o->interpolation.weights)
    return PO_OK;
  const po_profile_table *table = request->scene.profile.table;
  double *const changes[PO_READINGS] = {[PO_WITHOUT_ODD] = &o->interpolation.without_odd,
                                        [PO_WITHOUT_EVEN] = &o->interpolation.without_even,
                                        [PO_ROUND_APEX] = &o->interpolation.round_apex};
  po_status status = PO_OK;
  double most = 0.0;
  for (int k = 0; k < PO_READINGS && !status; ++k) {
    status = change_of_reading(request, (po_reading)k, o, changes[k]);
    if (!(fabs(*changes[k]) <= most)) /* NaN stays */
      most = isnan(most) ? most : fabs(*changes[k]);
  }
  o->interpolation.force = most;
  o->interpolation.interval =
      (int)po_order_last_up_to(table->r, table->rows, o->pull_off.contact_radius) + 1;
  o->interpolation.is_known = !status;
  if (!status)
    po_message_clear();
  return status;
}

po_status po_solve_changed(const po_request *request, po_result *result) {
  const bool diagnoses = request->want & PO_WANT_DIAGNOSTICS;
  po_status status = diagnoses ? diagnose_moved(request, result) : PO_OK;
  if (!status && result->has_pull_off)
    status = find_uncertainty(request, result);
  return status || !result->has_pull_off ? status : read_again(request, result);
}
