#include "po_reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_contact.h"
#include "po_law.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_profile.h"

/* Of the panels; there are none without a surface. */
static double root_of(const po_reader *r) {
  return r->surface ? r->surface->core_radius : (double)NAN;
}

/* Room for one more in an array that doubles. */
static bool grow(po_reader *r, void **array, size_t count, size_t *room, size_t size) {
  if (count < *room)
    return true;
  const size_t larger = *room ? 2 * *room : 64;
  void *moved = po_resize(*array, larger, size);
  if (!moved) {
    r->status = PO_NO_MEMORY;
    return false;
  }
  *array = moved;
  *room = larger;
  return true;
}

static void add_curve_point(po_reader *r, const po_branch_point *p, double contact_radius) {
  po_result *o = r->result;
  if (!(r->request->want & PO_WANT_CURVE) ||
      !grow(r, (void **)&o->curve, o->curve_count, &r->curve_room, sizeof *o->curve))
    return;
  o->curve[o->curve_count++] = (po_curve_point){.position = p->position,
                                                .approach = p->approach,
                                                .load = p->load,
                                                .energy = p->energy,
                                                .contact_radius = contact_radius,
                                                .approach_rate = p->approach_rate,
                                                .load_rate = p->load_rate,
                                                .unstable_modes = p->unstable_modes};
}

/* Keeps the branch whole. */
static void keep_path(po_reader *r, const po_branch_point *p, double contact_radius) {
  if (!grow(r, (void **)&r->path, r->path_count, &r->path_room, sizeof *r->path))
    return;
  r->path[r->path_count++] = (po_path_point){.approach = p->approach,
                                             .load = p->load,
                                             .energy = p->energy,
                                             .approach_rate = p->approach_rate,
                                             .load_rate = p->load_rate,
                                             .contact_radius = contact_radius,
                                             .position = p->position,
                                             .unstable_modes = p->unstable_modes,
                                             .minimum = p->kind == PO_POINT_LOAD_MIN};
}

static po_special_kind kind_of(po_point_kind kind) {
  switch (kind) {
  case PO_POINT_APPROACH_MAX:
    return PO_JUMP_IN;
  case PO_POINT_APPROACH_MIN:
    return PO_JUMP_OUT;
  case PO_POINT_LOAD_MAX:
    return PO_MAXIMUM;
  default:
    return PO_MINIMUM;
  }
}

static po_estimate estimate_of(const po_reader *r, const po_branch_point *p) {
  return po_estimate_of(r->request, root_of(r), p);
}

static void add_special_point(po_reader *r, const po_branch_point *p, const po_estimate *e) {
  po_result *o = r->result;
  const po_special_kind kind = kind_of(p->kind);
  const bool fold = kind == PO_JUMP_IN || kind == PO_JUMP_OUT;
  po_special_point **list = fold ? &o->folds : &o->extrema;
  size_t *count = fold ? &o->fold_count : &o->extremum_count;
  r->unmet_folds += fold && p->unmet;
  if (!grow(r, (void **)list, *count, fold ? &r->fold_room : &r->extremum_room, sizeof **list))
    return;
  (*list)[(*count)++] = (po_special_point){.kind = kind,
                                           .approach = e->approach,
                                           .load = e->load,
                                           .energy = p->energy,
                                           .approach_error = e->approach_error,
                                           .load_error = e->load_error,
                                           .contact_radius = e->edge.radius,
                                           .contact_radius_error = e->edge.error,
                                           .contact_radius_other = e->edge.other,
                                           .position = p->position,
                                           .unstable_modes = p->unstable_modes};
}

/* The profile at the nodes up to the end of the core, P = mu p; a rigid one from the undeformed
 * gap, with P / mu when mu is 0. */
static void keep_profile(po_reader *r, const po_branch_point *p) {
  po_result *o = r->result;
  const po_surface *s = r->surface; /* of a rigid scene: nodes to take the profile at */
  const po_scene *scene = &r->request->scene;
  const size_t most = p->gap ? p->n : s->resolved;
  po_profile_point *profile = po_resize(o->profile, most, sizeof *profile);
  if (!profile) {
    r->status = PO_NO_MEMORY;
    return;
  }
  const double tabor = scene->tabor > 0.0 ? scene->tabor : 1.0;
  o->profile = profile;
  o->profile_count = 0;
  o->profile_approach = p->approach;
  const po_contact_gap field = po_contact_gap_of(scene, root_of(r), p);
  r->status = po_contact_annuli_fill(&field, &o->annuli);
  for (size_t j = 0; j < most; ++j) {
    const double radius = p->gap ? p->node[j] : s->node[j];
    if (radius > s->core_radius)
      break;
    const double gap = p->gap ? p->gap[j] : po_profile(scene, radius) - p->approach;
    profile[o->profile_count++] = (po_profile_point){
        .radius = radius, .gap = gap, .traction = tabor * po_law_at(gap).traction};
  }
}

static void note_minimum(po_reader *r, const po_branch_point *p, const po_estimate *e) {
  po_result *o = r->result;
  if (!po_stopping_note_minimum(&r->stopping, e->load))
    return;
  o->has_pull_off = true;
  o->pull_off.force = fabs(e->load);
  o->pull_off.approach = e->approach;
  o->pull_off.contact_radius = e->edge.radius;
  o->pull_off.force_error = e->load_error;
  o->pull_off.approach_error = e->approach_error;
  o->pull_off.contact_radius_error = e->edge.error;
  o->pull_off.contact_radius_other = e->edge.other;
  if ((r->request->want & PO_WANT_PROFILE) && isnan(r->request->profile_approach))
    keep_profile(r, p);
}

static bool is_kept(po_point_kind kind) {
  return kind == PO_POINT_LOAD_MIN || kind == PO_POINT_APPROACH_MAX ||
         kind == PO_POINT_APPROACH_MIN;
}

po_reader po_reader_begin(const po_request *request, po_result *result, double deadline) {
  return (po_reader){.request = request,
                     .result = result,
                     .deadline = deadline,
                     .stopping = po_stopping_begin(request)};
}

void po_reader_end(po_reader *reader) {
  free(reader->path);
  reader->path = NULL;
}

/* Whether the preload is met and a search of some effort goes on: it may end anywhere. */
static bool only_searches(const po_reader *r) {
  return r->stopping.met && po_request_search(r->request) == PO_SEARCH_SOME;
}

/* Whether to go on: nobody stops it, and there is time. */
static bool may_go_on(po_reader *r, const po_branch_point *p) {
  if (r->request->stop && *r->request->stop)
    r->status = po_fail(PO_INTERRUPTED, "interrupted at approach %.6g", p->approach);
  else if (po_clock_thread() > r->deadline && only_searches(r))
    r->result->ended.cause = PO_END_SEARCHED;
  else if (po_clock_thread() > r->deadline)
    r->status = po_fail(PO_OUT_OF_TIME,
                        "after %g s of processor time the trace is at approach %.6g, load %.6g",
                        r->request->time_limit, p->approach, p->load);
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
  add_special_point(r, p, &e);
  if (p->kind == PO_POINT_LOAD_MIN)
    note_minimum(r, p, &e);
  if (r->keeper && is_kept(p->kind) && !r->keeper->special(r->keeper->data, p, r->stopping.margin))
    r->status = PO_NO_MEMORY;
}

/* What is diagnosed later. */
static void keep_for_diagnosis(po_reader *r, const po_branch_point *p) {
  po_balance_note(r->balance, p);
  const bool deepest = p->kind == PO_POINT_LOAD_MIN && r->result->has_pull_off &&
                       fabs(p->load + p->load_correction) == r->result->pull_off.force;
  if (!r->status)
    r->status = po_kept_note(r->kept, p, deepest);
}

/* The contact has come to the end of the meshed surface: a search of some effort ends there, any
 * other trace is repeated on a larger one. */
static void note_cut_off(po_reader *r, const po_branch_point *p, double contact_radius) {
  if (only_searches(r))
    r->result->ended.cause = PO_END_SEARCHED;
  else
    r->status = po_fail(PO_OUT_OF_DOMAIN,
                        "the contact radius %.6g reached the end of the meshed surface, %.6g, at "
                        "approach %.6g, load %.6g%s",
                        contact_radius, r->surface->core_radius, p->approach, p->load,
                        r->stopping.met ? "" : ", before the preload is met");
}

/* Whether the trace goes on no farther than a point, and why. */
static bool ends_at(po_reader *r, const po_branch_point *p, double contact_radius) {
  const po_scene *scene = &r->request->scene;
  if (!r->status && p->gap && po_observe_is_cut_off(scene, contact_radius, r->surface->core_radius))
    note_cut_off(r, p, contact_radius);
  else if (!r->status)
    r->result->ended.cause = po_stopping_cause(&r->stopping, p);
  return r->status || r->result->ended.cause != PO_END_NONE;
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
  keep_path(r, p, contact_radius);
  if (!r->begun && !(p->approach >= r->begin))
    return false;
  if (isnan(o->start))
    o->start = p->approach;
  r->begun = true;
  o->ended.approach = p->approach;
  o->ended.load = p->load;
  if (r->surface && r->surface->n > r->most_nodes)
    r->most_nodes = r->surface->n;
  add_curve_point(r, p, contact_radius);
  if (p->kind == PO_POINT_STATION && !o->profile && (r->request->want & PO_WANT_PROFILE) &&
      po_path_is_at(p->approach, r->request->profile_approach))
    keep_profile(r, p);
  po_stopping_note_point(&r->stopping, p, &gap, contact_radius);
  if (p->kind != PO_POINT_STEP && p->kind != PO_POINT_STATION)
    read_special_point(r, p);
  if (r->balance)
    keep_for_diagnosis(r, p);
  return ends_at(r, p, contact_radius);
}
