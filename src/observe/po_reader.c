#include "po_reader.h"

#include <math.h>

#include "po_contact.h"
#include "po_contact_profile.h"
#include "po_energy_error.h"
#include "po_observe_parts.h"
#include "po_pull_off_sensitivity.h"
#include "po_watch.h"

/* The radius of the domain of the panels, eps; without a surface there are none. */
static double root_of(const po_reader *r) {
  return r->surface ? r->surface->core_radius : (double)NAN;
}

static po_estimate estimate_of(const po_reader *r, const po_branch_point *p) {
  return po_estimate_of(r->request, root_of(r), p);
}

/* Stores the first failure of a part, which ends the trace. */
static void keep_status(po_reader *r, po_status status) {
  if (!r->status)
    r->status = status;
}

static void take_profile(po_reader *r, const po_branch_point *p) {
  keep_status(r, po_contact_profile_take(&r->request->scene, r->surface, p, r->result));
}

static void note_minimum(po_reader *r, const po_branch_point *p, const po_estimate *e) {
  if (!po_stopping_note_minimum(&r->stopping, e->load))
    return;
  po_special_list_pull_off(e, r->result);
  if (p->solution)
    r->result->pull_off.has_sensitivity = po_pull_off_sensitivity(
        &r->request->scene, r->surface, p->solution, &r->result->pull_off.sensitivity);
  if ((r->request->want & PO_WANT_PROFILE) && isnan(r->request->profile_approach))
    take_profile(r, p);
}

static bool is_kept(po_point_kind kind) {
  return kind == PO_POINT_LOAD_MIN || kind == PO_POINT_APPROACH_MAX ||
         kind == PO_POINT_APPROACH_MIN;
}

po_reader po_reader_begin(const po_request *request, po_result *result, double deadline) {
  return (po_reader){.request = request,
                     .result = result,
                     .deadline = deadline,
                     .special = po_special_list_begin(),
                     .stopping = po_stopping_begin(request)};
}

void po_reader_end(po_reader *reader) {
  po_trace_points_free(&reader->points);
}

/* Whether the preload is met and a search of limited effort is in progress, which may end at any
 * point. */
static bool only_searches(const po_reader *r) {
  return r->stopping.met && po_request_search(r->request) == PO_SEARCH_SOME;
}

po_status po_reader_stop(po_reader *r, po_status why, double approach, double load) {
  if (why == PO_INTERRUPTED && isnan(approach))
    return po_fail(why, "interrupted before the first point");
  if (why == PO_INTERRUPTED)
    return po_fail(why, "interrupted at approach %.6g", approach);
  if (only_searches(r)) {
    r->result->ended.cause = PO_END_SEARCHED;
    return PO_OK;
  }
  if (isnan(approach))
    return po_fail(why, "after %g s of processor time the trace has no point yet",
                   r->request->time_limit);
  return po_fail(why, "after %g s of processor time the trace is at approach %.6g, load %.6g",
                 r->request->time_limit, approach, load * po_scene_load_unit(&r->request->scene));
}

/* Whether the trace continues: it is not interrupted, and the time limit is not reached. */
static bool may_go_on(po_reader *r, const po_branch_point *p) {
  if (r->request->watch)
    r->request->watch(r->request->watcher, p->approach,
                      p->load * po_scene_load_unit(&r->request->scene));
  const po_status stopped = po_watch_look();
  if (stopped)
    r->status = po_reader_stop(r, stopped, p->approach, p->load);
  return !r->status;
}

bool po_reader_visit_back(const po_branch_point *p, void *data) {
  po_reader *r = data;
  if (may_go_on(r, p)) {
    const po_estimate e = estimate_of(r, p);
    r->status = po_passage_note(r->back, p, e.approach_error, e.load_error, true);
  }
  return r->status != PO_OK;
}

/* Reads a special point. */
static void read_special_point(po_reader *r, const po_branch_point *p) {
  const po_estimate e = estimate_of(r, p);
  keep_status(r, po_special_list_add(&r->special, p, &e, r->result));
  if (p->kind == PO_POINT_LOAD_MIN)
    note_minimum(r, p, &e);
  if (r->keeper && is_kept(p->kind) && !r->keeper->special(r->keeper->data, p, r->stopping.margin))
    r->status = PO_NO_MEMORY;
}

/* Passes a point to the diagnostics. */
static void keep_for_diagnosis(po_reader *r, const po_branch_point *p) {
  po_balance_note(r->balance, p);
  const bool deepest = p->kind == PO_POINT_LOAD_MIN && r->result->has_pull_off &&
                       fabs(p->load + p->load_correction) == r->result->pull_off.force;
  if (!r->status)
    r->status = po_kept_note(r->kept, p, deepest);
}

/* The contact has reached the end of the meshed surface: a search of limited effort ends here, any
 * other trace is repeated on a larger surface. */
static void note_cut_off(po_reader *r, const po_branch_point *p, double contact_radius) {
  if (only_searches(r))
    r->result->ended.cause = PO_END_SEARCHED;
  else
    r->status = po_fail(PO_OUT_OF_DOMAIN,
                        "the contact radius %.6g reached the end of the meshed surface, %.6g, at "
                        "approach %.6g, load %.6g%s",
                        contact_radius, r->surface->core_radius, p->approach,
                        p->load * po_scene_load_unit(&r->request->scene),
                        r->stopping.met ? "" : ", before the preload is met");
}

/* Whether the trace ends at a point; stores the cause. */
static bool ends_at(po_reader *r, const po_branch_point *p, double contact_radius) {
  const po_scene *scene = &r->request->scene;
  if (!r->status && contact_radius > po_profile_end(&scene->profile))
    r->status = po_fail(PO_BAD_INPUT,
                        "the table of the profile ends at r = %g, before the contact does: its "
                        "radius is %.6g at approach %.6g; expected rows for larger radii, or a "
                        "smaller preload",
                        po_profile_end(&scene->profile), contact_radius, p->approach);
  if (!r->status && p->gap && po_observe_is_cut_off(scene, contact_radius, r->surface->core_radius))
    note_cut_off(r, p, contact_radius);
  else if (!r->status)
    r->result->ended.cause = po_stopping_cause(&r->stopping, p);
  return r->status || r->result->ended.cause != PO_END_NONE;
}

/* The error of the energy of a point, if something with such errors is wanted. */
static double energy_error_of(const po_reader *r, const po_branch_point *p) {
  if (!(r->request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS | PO_WANT_PRELOAD)))
    return NAN;
  const double precision = po_observe_precision(r->request->mesh.tolerance);
  return po_energy_error(&r->request->scene, root_of(r), precision, p);
}

bool po_reader_visit(const po_branch_point *p, void *data) {
  po_reader *r = data;
  po_result *o = r->result;
  if (!may_go_on(r, p) || o->ended.cause != PO_END_NONE)
    return true;
  if (r->out) {
    const po_estimate e = estimate_of(r, p);
    r->status = po_passage_note(r->out, p, e.approach_error, e.load_error, false);
  }
  const po_contact_gap gap = po_contact_gap_of(&r->request->scene, root_of(r), p);
  const double contact_radius = po_contact_radius(&gap);
  const double energy_error = energy_error_of(r, p);
  keep_status(r, po_trace_points_add_to_path(&r->points, p, contact_radius, energy_error));
  if (!r->begun && !(p->approach >= r->begin))
    return false;
  if (isnan(o->start))
    o->start = p->approach;
  r->begun = true;
  o->ended.approach = p->approach;
  o->ended.load = p->load;
  if (r->surface && r->surface->n > r->most_nodes)
    r->most_nodes = r->surface->n;
  if (r->request->want & PO_WANT_CURVE)
    keep_status(r, po_trace_points_add_to_curve(&r->points, p, contact_radius, energy_error, o));
  if (p->kind == PO_POINT_STATION && !o->profile && (r->request->want & PO_WANT_PROFILE) &&
      po_path_is_at(p->approach, r->request->profile_approach))
    take_profile(r, p);
  po_stopping_note_point(&r->stopping, p, &gap, contact_radius);
  if (p->kind != PO_POINT_STEP && p->kind != PO_POINT_STATION)
    read_special_point(r, p);
  if (r->balance)
    keep_for_diagnosis(r, p);
  return ends_at(r, p, contact_radius);
}
