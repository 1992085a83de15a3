#include "po_reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_contact.h"
#include "po_law.h"
#include "po_memory.h"
#include "po_observe_parts.h"
#include "po_shape.h"

/* A contact that comes this close to the end of the meshed surface is cut off by it. */
const double PO_GREATEST_CONTACT = 0.9;

/* The trace of a wavy sphere ends when it is pressed, stably, by more than the pull-off force and
 * this many units of the load: as a test that pulls no harder than it pressed. */
static const double PRELOAD = 1.0;

/* A station is met to 1e-12. */
static const double SAME_APPROACH = 1e-9;

/* Waves whose minima rise more and more after the deepest: the envelope is past its own. */
enum { ENOUGH_RISES = 2 };

/* In parts of the tolerance: errors of the load and of the approach that halving the panels does
 * not show. On random scenes at 1e-4 such errors of 3e-6 and 1e-7 occur. */
static const double UNSEEN_LOAD = 3e-2, UNSEEN_APPROACH = 2e-3;

/* How far beyond pull-off the next wave's minimum is at least, in wavelengths (they are one apart,
 * a little less at first). Minima in between are ripples. */
static const double NEXT_WAVE = 0.8;

static double contact_radius_of(const po_reader *r, const po_branch_point *p) {
  return p->gap ? po_contact_radius(p->n, p->node, p->gap)
                : po_contact_radius_rigid(&r->request->scene, p->approach);
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
  po_outcome *o = r->outcome;
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

/* Keeps the branch whole, and what loading has come to. Displacement control follows the points at
 * which the approach is greater than ever before; a load is carried where it rises. */
static void follow_loading(po_reader *r, const po_branch_point *p, double contact_radius) {
  if (!(r->request->want & PO_WANT_HYSTERESIS) ||
      !grow(r, (void **)&r->path, r->path_count, &r->path_room, sizeof *r->path))
    return;
  r->path[r->path_count++] = (po_path_point){.approach = p->approach,
                                             .load = p->load,
                                             .energy = p->energy,
                                             .approach_rate = p->approach_rate,
                                             .load_rate = p->load_rate,
                                             .contact_radius = contact_radius,
                                             .position = p->position,
                                             .unstable_modes = p->unstable_modes};
  if (p->unstable_modes > 0)
    return;
  if (p->approach >= r->path_approach) {
    r->path_approach = p->approach;
    r->path_load = fmax(r->path_load, p->load);
  }
  if (p->approach_rate > 0.0 && (p->load_rate > 0.0 || p->kind == PO_POINT_LOAD_MAX))
    r->greatest_load = fmax(r->greatest_load, p->load);
}

/* Whether the branch is long enough to load to the preload, in displacement and in load control. */
static bool is_loaded(const po_reader *r) {
  const po_preload *preload = &r->request->preload;
  if (!(r->request->want & PO_WANT_HYSTERESIS))
    return true;
  if (isnan(preload->approach) && isnan(preload->load))
    return r->path_load >= r->outcome->pull_off.force &&
           r->greatest_load >= r->outcome->pull_off.force;
  const bool reached = r->path_approach >= preload->approach || r->path_load >= preload->load;
  return reached && r->greatest_load >= fmax(0.0, r->path_load);
}

static po_landmark_kind kind_of(po_point_kind kind) {
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

double po_reader_load_error(const po_request *request, double estimate, double load) {
  return estimate + UNSEEN_LOAD * request->mesh.tolerance * (1.0 + fabs(load));
}

double po_reader_approach_error(const po_request *request, double estimate, double approach) {
  return estimate + UNSEEN_APPROACH * request->mesh.tolerance * (1.0 + fabs(approach));
}

/* Of a landmark, as well as it is known. */
static double load_of(const po_branch_point *p) {
  return p->load + p->load_correction;
}

static double approach_of(const po_branch_point *p) {
  return p->approach + p->approach_correction;
}

static double load_error(const po_reader *r, const po_branch_point *p) {
  return r->outcome->rigid ? p->load_error
                           : po_reader_load_error(r->request, p->load_error, load_of(p));
}

static double approach_error(const po_reader *r, const po_branch_point *p) {
  return r->outcome->rigid
             ? p->approach_error
             : po_reader_approach_error(r->request, p->approach_error, approach_of(p));
}

static void add_landmark(po_reader *r, const po_branch_point *p, double contact_radius) {
  po_outcome *o = r->outcome;
  const po_landmark_kind kind = kind_of(p->kind);
  const bool fold = kind == PO_JUMP_IN || kind == PO_JUMP_OUT;
  po_landmark **list = fold ? &o->folds : &o->extrema;
  size_t *count = fold ? &o->fold_count : &o->extremum_count;
  r->unmet_folds += fold && p->unmet;
  if (!grow(r, (void **)list, *count, fold ? &r->fold_room : &r->extremum_room, sizeof **list))
    return;
  (*list)[(*count)++] = (po_landmark){.kind = kind,
                                      .approach = approach_of(p),
                                      .load = load_of(p),
                                      .energy = p->energy,
                                      .approach_error = approach_error(r, p),
                                      .load_error = load_error(r, p),
                                      .contact_radius = contact_radius,
                                      .position = p->position,
                                      .unstable_modes = p->unstable_modes};
}

/* The profile at the nodes up to the end of the core, P = mu p; a rigid one from the undeformed
 * gap, with P / mu when mu is 0. */
static void keep_profile(po_reader *r, const po_branch_point *p) {
  po_outcome *o = r->outcome;
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
  for (size_t j = 0; j < most; ++j) {
    const double radius = p->gap ? p->node[j] : s->node[j];
    if (radius > s->core_radius)
      break;
    const double gap = p->gap ? p->gap[j] : po_shape(scene, radius) - p->approach;
    profile[o->profile_count++] = (po_profile_point){
        .radius = radius, .gap = gap, .traction = tabor * po_law_at(gap).traction};
  }
}

/* Follows the minima from wave to wave. Where one more rise would have ended the trace, it tells by
 * how much the minimum of the next wave was short of that. */
static void note_wave(po_reader *r, double load, double contact_radius) {
  const double apart = contact_radius - r->wave_radius, rise = load - r->wave_minimum;
  const bool next = apart > NEXT_WAVE * r->request->scene.wavelength;
  if (next && r->rises == ENOUGH_RISES - 1 && rise < r->rise)
    r->margin = fmin(r->margin, (r->rise - rise) / PRELOAD);
  if (load <= r->pull_off_load) {
    r->rises = 0;
    r->rise = 0.0;
  } else if (next) {
    r->rises = rise > r->rise ? r->rises + 1 : 0;
    r->rise = rise;
  } else if (load >= r->wave_minimum) {
    return; /* a ripple beside the wave's own minimum */
  }
  r->wave_minimum = load;
  r->wave_radius = contact_radius;
}

static void note_minimum(po_reader *r, const po_branch_point *p, double contact_radius) {
  po_outcome *o = r->outcome;
  const double load = load_of(p);
  if (!o->has_pull_off || load < r->pull_off_load) {
    o->has_pull_off = true;
    r->pull_off_load = load;
    o->pull_off.force = fabs(load);
    o->pull_off.approach = approach_of(p);
    o->pull_off.contact_radius = contact_radius;
    o->pull_off.force_error = load_error(r, p);
    o->pull_off.approach_error = approach_error(r, p);
    if ((r->request->want & PO_WANT_PROFILE) && isnan(r->request->profile_approach))
      keep_profile(r, p);
  }
  note_wave(r, load, contact_radius);
}

/* Whether the trace may end, at a stable point. A smooth sphere under compression has its one
 * minimum behind it. On a wavy one the minima are what the outer edge of the contact makes as it
 * climbs over one wave after another; they follow the lower edge of the Kesari-Lew envelope, which
 * is convex, so that when those of several waves rose more and more the deepest is behind. But
 * pressed hard enough, grooves within the contact close, and a branch may come back by states that
 * are pulled off harder, up to Guduru's full contact; hence the preload, which is part of what is
 * called the pull-off. tests/unit/test_observe.c traces twice as far. */
static bool may_end(const po_reader *r, const po_branch_point *p) {
  const po_outcome *o = r->outcome;
  if (!isnan(r->request->approach_end) || !o->has_pull_off || p->unstable_modes > 0 ||
      !is_loaded(r))
    return false;
  if (!po_scene_is_wavy(&r->request->scene))
    return p->load > 0.0;
  return r->rises >= ENOUGH_RISES || p->load > PRELOAD + o->pull_off.force;
}

static bool is_kept(po_point_kind kind) {
  return kind == PO_POINT_LOAD_MIN || kind == PO_POINT_APPROACH_MAX ||
         kind == PO_POINT_APPROACH_MIN;
}

/* Of a scene a little different the trace might have ended at a point where this one just goes on.
 */
static void note_margin(po_reader *r, const po_branch_point *p) {
  const po_outcome *o = r->outcome;
  if (!o->has_pull_off || !po_scene_is_wavy(&r->request->scene))
    return;
  if (r->rises >= ENOUGH_RISES) /* it ends where it is stable */
    r->margin = 0.0;
  else if (p->unstable_modes == 0)
    r->margin = fmin(r->margin, (PRELOAD + o->pull_off.force - p->load) / PRELOAD);
}

po_reader po_reader_begin(const po_request *request, po_outcome *outcome, double deadline) {
  return (po_reader){.request = request,
                     .outcome = outcome,
                     .deadline = deadline,
                     .margin = 1.0,
                     .path_approach = -INFINITY,
                     .path_load = -INFINITY,
                     .greatest_load = -INFINITY};
}

void po_reader_end(po_reader *reader) {
  free(reader->path);
  reader->path = NULL;
}

/* Whether to go on: nobody stops it, and there is time. */
static bool may_go_on(po_reader *r, const po_branch_point *p) {
  if (r->request->stop && *r->request->stop)
    r->status = po_fail(PO_INTERRUPTED, "interrupted at approach %.6g", p->approach);
  else if (po_clock_thread() > r->deadline)
    r->status = po_fail(PO_OUT_OF_TIME,
                        "after %g s of processor time the trace is at approach %.6g, load %.6g",
                        r->request->time_limit, p->approach, p->load);
  return !r->status;
}

bool po_reader_visit_back(const po_branch_point *p, void *data) {
  po_reader *r = data;
  if (may_go_on(r, p))
    r->status = po_passage_note(r->back, p, approach_error(r, p), load_error(r, p), true);
  return r->status != PO_OK;
}

bool po_reader_visit(const po_branch_point *p, void *data) {
  po_reader *r = data;
  po_outcome *o = r->outcome;
  if (!may_go_on(r, p))
    return true;
  if (r->out)
    r->status = po_passage_note(r->out, p, approach_error(r, p), load_error(r, p), false);
  const double contact_radius = contact_radius_of(r, p);
  follow_loading(r, p, contact_radius);
  if (!r->begun && !(p->approach >= r->begin))
    return false;
  if (isnan(o->start))
    o->start = p->approach;
  r->begun = true;
  o->end = p->approach;
  if (r->surface && r->surface->n > r->most_nodes)
    r->most_nodes = r->surface->n;
  add_curve_point(r, p, contact_radius);
  if (p->kind == PO_POINT_STATION && !o->profile && (r->request->want & PO_WANT_PROFILE) &&
      fabs(p->approach - r->request->profile_approach) < SAME_APPROACH)
    keep_profile(r, p);
  note_margin(r, p);
  if (p->kind != PO_POINT_STEP && p->kind != PO_POINT_STATION)
    add_landmark(r, p, contact_radius);
  if (p->kind == PO_POINT_LOAD_MIN) {
    note_minimum(r, p, contact_radius);
  }
  if (r->keeper && is_kept(p->kind) && !r->keeper->landmark(r->keeper->data, p, r->margin))
    r->status = PO_NO_MEMORY;
  if (r->balance)
    po_balance_note(r->balance, p);
  if (r->kept && !r->status)
    r->status =
        po_kept_note(r->kept, p, p->kind == PO_POINT_LOAD_MIN && load_of(p) == r->pull_off_load);
  if (!r->status && p->gap && contact_radius > PO_GREATEST_CONTACT * r->surface->core_radius) {
    if (isinf(r->request->scene.outer_radius))
      r->status = po_fail(PO_OUT_OF_DOMAIN,
                          "the contact radius %.6g reached the end of the meshed surface, %.6g, at "
                          "approach %.6g",
                          contact_radius, r->surface->core_radius, p->approach);
    return true; /* a bounded surface is used up */
  }
  return r->status || may_end(r, p);
}
