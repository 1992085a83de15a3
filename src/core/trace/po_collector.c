#include "po_collector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_adjoint.h"
#include "po_contact.h"
#include "po_deadline.h"
#include "po_hermite.h"
#include "po_memory.h"
#include "po_solution.h"
#include "po_trace.h"

static bool is_special(const po_branch_point *p) {
  return p->kind != PO_POINT_STEP && p->kind != PO_POINT_STATION &&
         p->kind != PO_POINT_STATION_LOAD;
}

/* Stores the first failure of a part, which ends the trace. */
static void keep_status(po_collector *r, po_status status) {
  if (!r->status)
    r->status = status;
}

/* fmax ignores NAN. */
static void note_errors(po_estimate *greatest, const po_estimate *e) {
  greatest->traced_approach_error = fmax(greatest->traced_approach_error, e->traced_approach_error);
  greatest->traced_load_error = fmax(greatest->traced_load_error, e->traced_load_error);
  greatest->traced_energy_error = fmax(greatest->traced_energy_error, e->traced_energy_error);
}

/* The unstable modes at a given base of the spring, if there is one, of the equilibria just after a
 * point. After a fold the approach turns. */
static int modes_at_base(double stiffness, const po_branch_point *p) {
  if (isnan(stiffness))
    return 0;
  if (p->kind == PO_POINT_APPROACH_MAX || p->kind == PO_POINT_APPROACH_MIN)
    return p->unstable_modes + ((p->kind == PO_POINT_APPROACH_MAX) == (p->load_rate > 0.0));
  return po_modes_held(stiffness, p->unstable_modes, p->approach_rate, p->load_rate);
}

/* Adds a special point to the folds or the extrema of the result. Status: PO_NO_MEMORY. */
static po_status add_special_point(po_special_list *l, const po_branch_point *p, double stiffness,
                                   const po_estimate *e, po_result *o) {
  const bool fold = e->point.kind == PO_JUMP_IN || e->point.kind == PO_JUMP_OUT;
  po_special_point **list = fold ? &o->folds : &o->extrema;
  size_t *count = fold ? &o->fold_count : &o->extremum_count;
  l->unmet_folds += fold && p->unmet;
  note_errors(&l->greatest, e);
  po_special_point *grown =
      po_grow(*list, *count, fold ? &l->fold_room : &l->extremum_room, sizeof *grown);
  if (!grown)
    return PO_NO_MEMORY;
  *list = grown;
  grown[*count] = e->point;
  grown[*count].has_base = !isnan(stiffness);
  grown[(*count)++].base_modes = modes_at_base(stiffness, p);
  return PO_OK;
}

/* Shows the profile of the last point of the curve. */
static void show_profile(po_collector *r, const po_branch_point *p) {
  po_profile_point *profile = NULL;
  size_t count = 0;
  keep_status(r, po_contact_profile_fill(&r->request->scene, r->surface, p, &profile, &count));
  if (!r->status)
    r->request->show(r->request->watcher, r->points.count - r->points.before - 1, profile, count);
  free(profile);
}

static void note_minimum(po_collector *r, const po_branch_point *p, const po_estimate *e) {
  if (!po_stopping_note_minimum(&r->stopping, e->point.load))
    return;
  po_estimate_pull_off(e, r->result);
  keep_status(r, po_adjoint_note(&r->request->scene, r->surface, p, r->result));
  const po_contact_gap gap = po_contact_gap_of(&r->request->scene, p);
  const double edge = po_contact_radius(&gap);
  r->result->pull_off.full_disc = edge > 0.0 ? po_contact_disc(&gap) / edge : (double)NAN;
  if ((r->request->want & PO_WANT_PROFILE) && isnan(r->request->profile_approach) &&
      isnan(r->request->profile_load))
    keep_status(r, po_contact_profile_take(&r->request->scene, r->surface, p, r->result));
}

void po_kept_points_clear(po_kept_points *kept) {
  po_arena_free(&kept->arrays);
  free(kept->points);
  *kept = (po_kept_points){0};
}

static bool is_loading(po_point_kind kind) {
  return kind == PO_POINT_APPROACH_MAX || kind == PO_POINT_LOAD_MAX;
}

const double PO_NEARLY = 0.9;

/* The load of the deepest kept minimum; 0: there is none. */
static double deepest_kept(const po_kept_points *kept) {
  double deepest = 0.0;
  for (size_t k = 0; k < kept->count; ++k)
    if (kept->points[k].kind == PO_POINT_LOAD_MIN)
      deepest = fmin(deepest, kept->points[k].load);
  return deepest;
}

/* Whether a special point is one of PO_KEEP_LOADING. Minima of the load are tensile. */
static bool is_of_loading(const po_kept_points *kept, const po_branch_point *p, bool minimum) {
  if (p->kind == PO_POINT_APPROACH_MIN)
    return p->unstable_modes == 0;
  if (minimum)
    return p->load < PO_NEARLY * deepest_kept(kept);
  if (!is_loading(p->kind))
    return false;
  for (size_t k = kept->count; k-- > 0;) {
    const po_kept_point *last = &kept->points[k];
    if (is_loading(last->kind))
      return p->approach >= last->approach;
  }
  return true;
}

/* Keeps a special point on panels if it is one of those that are wanted. Status: PO_NO_MEMORY. */
static po_status keep_point(po_kept_points *kept, const po_branch_point *p,
                            const po_stopping *stopping) {
  const bool fold = p->kind == PO_POINT_APPROACH_MAX || p->kind == PO_POINT_APPROACH_MIN;
  const bool minimum = p->kind == PO_POINT_LOAD_MIN && p->load < 0.0;
  const bool wanted = kept->which == PO_KEEP_LOADING  ? is_of_loading(kept, p, minimum)
                      : kept->which == PO_KEEP_MINIMA ? minimum
                                                      : fold;
  if (!p->solution || !wanted)
    return PO_OK;
  po_kept_point *points = po_grow(kept->points, kept->count, &kept->room, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  kept->points = points;
  po_kept_point *new = &points[kept->count++];
  *new = (po_kept_point){.kind = p->kind,
                         .position = p->position,
                         .approach = p->approach,
                         .load = p->load,
                         .unstable_modes = p->unstable_modes,
                         .margin = stopping->margin,
                         .met = stopping->met};
  const po_status status = po_solution_allocate(&new->point, p->solution->n, &kept->arrays);
  if (!status)
    po_solution_copy(p->solution, &new->point);
  return status;
}

/* Appends a point to the path. Given: contact radius, eps. Status: PO_NO_MEMORY. */
static po_status add_to_path(po_trace_points *points, const po_branch_point *p, double stiffness,
                             double contact_radius, po_point_error error) {
  po_curve_point *path = po_grow(points->path, points->count, &points->room, sizeof *path);
  if (!path)
    return PO_NO_MEMORY;
  points->path = path;
  path[points->count++] = (po_curve_point){.position = p->position,
                                           .approach = p->approach,
                                           .load = p->load,
                                           .energy = p->energy,
                                           .energy_error = error.energy,
                                           .load_error = error.load,
                                           .contact_radius = contact_radius,
                                           .approach_rate = p->approach_rate,
                                           .load_rate = p->load_rate,
                                           .unstable_modes = p->unstable_modes,
                                           .has_base = !isnan(stiffness),
                                           .base_modes = modes_at_base(stiffness, p),
                                           .minimum = p->kind == PO_POINT_LOAD_MIN};
  return PO_OK;
}

/* Makes the path the curve of the result. */
static void give_curve(po_trace_points *points, po_result *o) {
  o->curve_count = points->count - points->before;
  if (o->curve_count == 0)
    return;
  memmove(points->path, points->path + points->before, o->curve_count * sizeof *points->path);
  o->curve = points->path;
  points->path = NULL;
}

/* The largest difference relative to the range of the energy; NAN for fewer than two points. */
static double balance_defect(const po_balance *balance) {
  const double range = balance->highest - balance->lowest;
  return range > 0.0 ? balance->worst / range : (double)NAN;
}

void po_collector_end(po_collector *collector) {
  collector->result->diagnostics.energy_defect = balance_defect(&collector->balance);
  collector->result->diagnostics.energy_defect_at = collector->balance.at;
  if (collector->request->want & PO_WANT_CURVE)
    give_curve(&collector->points, collector->result);
  free(collector->points.path);
  po_kept_clear(&collector->kept);
}

/* Whether the preload is met and a search of limited effort is in progress, which may end at any
 * point. */
static bool only_searches(const po_collector *r) {
  return r->stopping.met && po_request_search(r->request) == PO_SEARCH_SOME;
}

po_status po_collector_stop(po_collector *r, po_status why, double approach, double load) {
  const double length = po_scene_length_unit(&r->request->scene);
  if (why == PO_INTERRUPTED && isnan(approach))
    return po_fail(why, "interrupted before the first point");
  if (why == PO_INTERRUPTED)
    return po_fail(why, "interrupted at approach %.6g", approach * length);
  if (only_searches(r)) {
    r->result->ended.cause = PO_END_SEARCHED;
    return PO_OK;
  }
  if (isnan(approach))
    return po_fail(why, "after %g s of processor time the trace has no point yet",
                   r->request->time_limit);
  return po_fail(why, "after %g s of processor time the trace is at approach %.6g, load %.6g",
                 r->request->time_limit, approach * length,
                 load * po_scene_load_unit(&r->request->scene));
}

/* Whether the trace continues: it is not interrupted, and the time limit is not reached. */
static bool may_go_on(po_collector *r, const po_branch_point *p) {
  if (r->request->watch)
    r->request->watch(r->request->watcher, p->approach,
                      p->load * po_scene_load_unit(&r->request->scene));
  const po_status stopped = po_deadline_check();
  if (stopped)
    r->status = po_collector_stop(r, stopped, p->approach, p->load);
  return !r->status;
}

/* Adds a point to the special points of the forward or the reverse trace. */
static po_status pass(po_collector *r, const po_branch_point *p, bool back) {
  po_passage *passage = back ? &r->kept.back : &r->kept.out;
  if (!is_special(p))
    return po_passage_note(passage, NULL, p->unstable_modes, back);
  const po_estimate e = po_estimate_of(r->request, p);
  return po_passage_note(passage, &e.point, p->unstable_modes, back);
}

bool po_collector_visit_back(const po_branch_point *p, void *data) {
  po_collector *r = data;
  if (may_go_on(r, p))
    r->status = pass(r, p, true);
  return r->status != PO_OK;
}

/* Reads a special point. */
static void read_special_point(po_collector *r, const po_branch_point *p) {
  const po_estimate e = po_estimate_of(r->request, p);
  keep_status(r, add_special_point(&r->special, p, r->request->stiffness, &e, r->result));
  if (p->kind == PO_POINT_LOAD_MIN)
    note_minimum(r, p, &e);
  if (r->for_series)
    keep_status(r, keep_point(r->for_series, p, &r->stopping));
}

/* Gauss's rule with three points on (0, 1). It is exact for the integrand, a cubic times the
 * derivative of a cubic. */
static const double NODE[] = {0.11270166537925831, 0.5, 0.88729833462074169};
static const double WEIGHT[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/* The integral of the load over the approach along the cubics with the values and rates at two
 * points. The parameter of the rates does not change the area to this order. */
static double work_between(const po_branch_point *a, const po_branch_point *b) {
  const double h = b->position - a->position;
  double sum = 0.0;
  for (int q = 0; q < 3; ++q)
    sum += WEIGHT[q] * h *
           po_hermite_value(a->load, a->load_rate, b->load, b->load_rate, NODE[q] * h, h) *
           po_hermite_rate(a->approach, a->approach_rate, b->approach, b->approach_rate,
                           NODE[q] * h, h);
  return sum;
}

/* Adds the next point along the branch. */
static void balance_note(po_balance *balance, const po_branch_point *p) {
  if (balance->begun && p->position > balance->last.position) {
    balance->gained += p->energy - balance->last.energy;
    balance->done += work_between(&balance->last, p);
    const double off = fabs(balance->gained - balance->done);
    if (!(off <= balance->worst)) {
      balance->worst = off;
      balance->at = p->approach;
    }
    balance->lowest = fmin(balance->lowest, balance->gained);
    balance->highest = fmax(balance->highest, balance->gained);
  }
  balance->begun = true;
  balance->last = *p;
}

/* Passes a point to the diagnostics. */
static void keep_for_diagnosis(po_collector *r, const po_branch_point *p) {
  balance_note(&r->balance, p);
  const bool deepest = p->kind == PO_POINT_LOAD_MIN && r->result->has_pull_off &&
                       fabs(p->load + p->load_correction) == r->result->pull_off.force;
  if (!r->status)
    r->status = po_kept_note(&r->kept, p, deepest);
}

/* The contact has reached the end of the meshed surface: a search of limited effort ends here, any
 * other trace is repeated on a larger surface. */
static void note_cut_off(po_collector *r, const po_branch_point *p, double contact_radius) {
  const double length = po_scene_length_unit(&r->request->scene);
  if (only_searches(r))
    r->result->ended.cause = PO_END_SEARCHED;
  else
    r->status =
        po_fail(PO_OUT_OF_DOMAIN,
                "the contact radius %.6g reached the end of the meshed surface, %.6g, at "
                "approach %.6g, load %.6g%s",
                contact_radius * length, r->surface->core_radius * length, p->approach * length,
                p->load * po_scene_load_unit(&r->request->scene),
                r->stopping.met ? "" : ", before the preload is met: expected a smaller preload");
}

static void note_too_long(po_collector *r, const po_branch_point *p) {
  r->status = po_fail(PO_TOO_MANY_POINTS,
                      "more than %zu points before the preload is met, the last at approach %.6g, "
                      "load %.6g",
                      r->most_points, p->approach * po_scene_length_unit(&r->request->scene),
                      p->load * po_scene_load_unit(&r->request->scene));
}

/* Whether a point is one at which the profile is asked for. */
static bool is_of_profile(const po_request *request, const po_branch_point *p) {
  return p->kind == PO_POINT_STATION_LOAD ||
         (p->kind == PO_POINT_STATION && po_path_is_at(p->approach, request->profile_approach));
}

/* Whether the trace ends at a point; stores the cause. */
static bool ends_at(po_collector *r, const po_branch_point *p, double contact_radius) {
  const po_scene *scene = &r->request->scene;
  if (!r->status && contact_radius > po_profile_shape(&scene->profile).end)
    r->status = po_fail(PO_BAD_INPUT,
                        "the table of the profile ends at r = %g, before the contact does: its "
                        "radius is %.6g at approach %.6g; expected rows for larger radii, or a "
                        "smaller preload",
                        po_profile_shape(&scene->profile).end, contact_radius, p->approach);
  if (!r->status && r->most_points && !r->stopping.met && r->points.count > r->most_points)
    note_too_long(r, p);
  if (!r->status && p->gap && po_trace_is_cut_off(scene, contact_radius, r->surface->core_radius))
    note_cut_off(r, p, contact_radius);
  else if (!r->status)
    r->result->ended.cause = po_stopping_cause(&r->stopping, p);
  return r->status || r->result->ended.cause != PO_END_NONE;
}

/* The errors of a point, if something with such errors is wanted. */
static po_point_error error_of(const po_collector *r, const po_branch_point *p) {
  const bool wanted = r->request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS | PO_WANT_PRELOAD);
  return wanted ? po_point_error_of(r->request, p) : (po_point_error){NAN, NAN};
}

bool po_collector_visit(const po_branch_point *p, void *data) {
  po_collector *r = data;
  po_result *o = r->result;
  if (!may_go_on(r, p) || o->ended.cause != PO_END_NONE)
    return true;
  if (r->diagnoses)
    r->status = pass(r, p, false);
  const po_contact_gap gap = po_contact_gap_of(&r->request->scene, p);
  const double contact_radius = po_contact_radius(&gap);
  keep_status(r, add_to_path(&r->points, p, r->request->stiffness, contact_radius, error_of(r, p)));
  if (!r->begun && !(p->approach >= r->begin)) {
    r->points.before = r->points.count;
    return false;
  }
  if (isnan(o->start))
    o->start = p->approach;
  r->begun = true;
  o->ended.approach = p->approach;
  o->ended.load = p->load;
  if (r->surface && r->surface->n > r->most_nodes)
    r->most_nodes = r->surface->n;
  if (r->request->show && r->request->want & PO_WANT_CURVE && !r->status)
    show_profile(r, p);
  if ((r->request->want & PO_WANT_PROFILE) && !o->profile && is_of_profile(r->request, p))
    keep_status(r, po_contact_profile_take(&r->request->scene, r->surface, p, r->result));
  po_stopping_note_point(&r->stopping, p, &gap, contact_radius);
  if (is_special(p))
    read_special_point(r, p);
  if (r->diagnoses)
    keep_for_diagnosis(r, p);
  return ends_at(r, p, contact_radius);
}
