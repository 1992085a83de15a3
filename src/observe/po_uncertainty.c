/* The uncertainty of the pull-off force by that of the inputs, to first order. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_diagnose.h"
#include "po_load_unit.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_profile_table.h"
#include "po_watch.h"

/* The force is linear if its changes to both sides, and that of the adjoint, differ from their mean
 * by at most this part of it. With the change a s + b s^2/2 by an input s of deviation 1, at s = 2,
 * the part is b/a, and the true standard deviation, sqrt(a^2 + b^2/2), exceeds a by 1 % at most; a
 * jump on one side is seen from a on. */
static const double LINEAR = 0.2;

/* A source that is not linear and changes the force by at most this part of the uncertainty by the
 * others has the greater of its changes: it changes that of all by 0.5 % at most. */
static const double SMALL = 0.1;

/* The standard uncertainty. Given: the changes, and the standard uncertainty by the adjoint, NAN:
 * not known. Changes as small as the error of the force are not compared. */
static double force_of(const po_uncertain *u, double adjoint, double error) {
  const double mean = 0.5 * fabs(u->above - u->below) / PO_VARIATION_REACH;
  const double bend = 0.5 * fabs(u->above + u->below) / PO_VARIATION_REACH;
  const double off = isnan(adjoint) ? 0.0 : fabs(adjoint - mean);
  if (fmax(bend, off) <= fmax(LINEAR * mean, error))
    return isnan(adjoint) ? mean : adjoint;
  return (double)NAN; /* also if a change is */
}

/* What all solves have in common. */
typedef struct {
  const po_request *request;
  double deadline;
  po_result *result;
} work;

/* Solves with an input moved. Returned: the change of the force, unchanged if the solve failed. */
static po_status solve(const work *w, const po_request *moved, double unit, double *change) {
  po_request r = *moved;
  po_result again;
  r.want = 0;
  r.search = PO_SEARCH_NONE;
  r.stop = w->request->stop;
  r.watch = NULL;
  r.show = NULL;
  r.time_limit = isfinite(w->deadline) ? w->deadline - po_clock_thread() : (double)NAN;
  po_status status = PO_OUT_OF_TIME;
  if (!(r.time_limit <= 0.0)) {
    status = po_observe_kept(&r, NULL, &again);
    if (!status && again.has_pull_off)
      *change = again.pull_off.force * unit - w->result->pull_off.force;
    po_result_clear(&again);
  }
  if (status == PO_OUT_OF_TIME)
    return po_diagnose_out_of_time(w->request, "the solves with uncertain inputs are not complete");
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED ? status : PO_OK;
}

/* The next source of the result. */
static po_uncertain *begin(po_result *o, const char *source, double value, double deviation) {
  po_uncertain *u = &o->uncertain[o->uncertain_count++];
  *u = (po_uncertain){.value = value, .deviation = deviation, .below = NAN, .above = NAN};
  snprintf(u->source, sizeof u->source, "%s", source);
  return u;
}

static po_status vary_input(const work *w, const po_variation *v) {
  po_result *o = w->result;
  const double solved = po_scene_load_unit(&w->request->scene);
  po_uncertain *u = begin(o, v->source, v->value, v->deviation);
  double change[2] = {NAN, NAN};
  po_status status = PO_OK;
  for (int k = 0; k < 2 && !status; ++k) {
    const po_request moved = po_load_unit_request(v->moved[k]);
    status = solve(w, &moved, v->unit[k] * po_scene_load_unit(&moved.scene) / solved, &change[k]);
  }
  u->below = change[0];
  u->above = change[1];
  u->force = force_of(u, (double)NAN, o->pull_off.force_error);
  return status;
}

/* The profile is changed as it most probably is where the force is off by its deviation. */
static po_status vary_profile(const work *w) {
  po_result *o = w->result;
  const po_profile_table *table = w->request->scene.profile.table;
  po_uncertain *u = begin(o, "noise", (double)NAN, table->smoothing.deviation / table->scale);
  double change[2] = {NAN, NAN};
  po_status status = PO_OK;
  for (int k = 0; k < 2 && !status; ++k) {
    po_profile_table *displaced;
    po_request moved = *w->request;
    status = po_profile_table_displace(table, o->noise.change,
                                       k ? -PO_VARIATION_REACH : PO_VARIATION_REACH, &displaced);
    moved.scene.profile.table = displaced;
    if (!status)
      status = solve(w, &moved, 1.0, &change[k]); /* the load falls, the force grows */
    po_profile_table_free(displaced);
  }
  u->below = change[0];
  u->above = change[1];
  u->force = force_of(u, o->noise.deviation, o->pull_off.force_error);
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

po_status po_uncertainty_solve(const po_request *request, double deadline, po_result *o) {
  const work w = {request, deadline, o};
  const size_t count = request->variations + (o->noise.change != NULL);
  if (count == 0)
    return PO_OK;
  o->uncertain = po_allocate(count, sizeof *o->uncertain);
  po_status status = o->uncertain ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; k < request->variations && !status; ++k)
    status = vary_input(&w, &request->variation[k]);
  if (o->noise.change && !status)
    status = vary_profile(&w);
  add_squares(o);
  if (!status)
    po_message_clear();
  return status;
}
