#include "po_reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_contact.h"
#include "po_law.h"
#include "po_memory.h"
#include "po_shape.h"

/* A contact that comes this close to the end of the meshed surface is cut off by it. */
static const double GREATEST_CONTACT = 0.9;

/* Loads in units of this and the pull-off force that no wave's minimum falls from. */
static const double GREATEST_PUSH = 10.0;

/* A station is met to 1e-12. */
static const double SAME_APPROACH = 1e-9;

/* The load drops by a similar amount as the contact's edge passes one wave after another: from here
 * it would have to drop by this many times the greatest drop so far, ... */
static const double DROPS = 3.0;
/* ... the edge having left the wave of the pull-off by this part of a wavelength. */
static const double PAST_THE_WAVE = 0.3;

/* Waves whose minima rise more and more after the deepest: the envelope is past its own. */
enum { ENOUGH_RISES = 2 };

/* In parts of the tolerance: an error that halving the panels does not show. On random scenes at
 * 1e-4 such errors of 1e-6 occur. */
static const double UNSEEN = 2e-2;

/* In wavelengths: contact beyond that at the last minimum without a new one; how far beyond
 * pull-off the next wave's minimum is at least (they are a wavelength apart, a little less at
 * first); and the end of the first trough. Minima in between are ripples. */
static const double QUIET_WAVES = 1.5, NEXT_WAVE = 0.8, FIRST_TROUGH = 0.5;

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
                                                .unstable_modes = p->unstable_modes};
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

/* An estimated error, and what an estimate cannot resolve. */
static double error_of(const po_reader *r, double estimate, double value) {
  return r->outcome->rigid ? estimate
                           : estimate + UNSEEN * r->request->mesh.tolerance * (1.0 + fabs(value));
}

static void add_landmark(po_reader *r, const po_branch_point *p, double contact_radius) {
  po_outcome *o = r->outcome;
  const po_landmark_kind kind = kind_of(p->kind);
  const bool fold = kind == PO_JUMP_IN || kind == PO_JUMP_OUT;
  po_landmark **list = fold ? &o->folds : &o->extrema;
  size_t *count = fold ? &o->fold_count : &o->extremum_count;
  if (!grow(r, (void **)list, *count, fold ? &r->fold_room : &r->extremum_room, sizeof **list))
    return;
  (*list)[(*count)++] = (po_landmark){.kind = kind,
                                      .approach = p->approach,
                                      .load = p->load,
                                      .energy = p->energy,
                                      .approach_error = error_of(r, p->approach_error, p->approach),
                                      .load_error = error_of(r, p->load_error, p->load),
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

/* Follows the minima from wave to wave. */
static void note_wave(po_reader *r, double load, double contact_radius) {
  const double apart = contact_radius - r->wave_radius;
  if (load <= r->pull_off_load) {
    r->rises = 0;
    r->rise = 0.0;
  } else if (apart > NEXT_WAVE * r->request->scene.wavelength) {
    const double rise = load - r->wave_minimum;
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
  r->greatest_drop = fmax(r->greatest_drop, r->last_maximum - p->load);
  if (!o->has_pull_off || p->load < r->pull_off_load) {
    o->has_pull_off = true;
    r->pull_off_load = p->load;
    o->pull_off.force = fabs(p->load);
    o->pull_off.approach = p->approach;
    o->pull_off.contact_radius = contact_radius;
    o->pull_off.force_error = error_of(r, p->load_error, p->load);
    o->pull_off.approach_error = error_of(r, p->approach_error, p->approach);
    if ((r->request->want & PO_WANT_PROFILE) && isnan(r->request->profile_approach))
      keep_profile(r, p);
  }
  note_wave(r, p->load, contact_radius);
  const double wavelength = r->request->scene.wavelength;
  r->risen = r->risen || (p->load > 0.0 && contact_radius > FIRST_TROUGH * wavelength &&
                          contact_radius > o->pull_off.contact_radius + NEXT_WAVE * wavelength);
  r->last_contact_radius = contact_radius;
}

/* No deeper minimum lies ahead. The minima of the load are what the outer edge of the contact makes
 * as it climbs over one wave after another; their sequence follows the lower edge of the Kesari-Lew
 * envelope, which is convex: it falls to a single minimum and rises ever after; and the drops to
 * them change little from one to the next. So at a stable point: when the minima of several waves
 * since rose more and more; or, under compression, when there are no waves; when a deeper minimum
 * takes a drop far greater than any so far; when the next wave's minimum was compressive itself; or
 * when the surfaces are pushed many times as hard as they were pulled, or as hard and the contact
 * grew over more than a wave without a minimum. tests/unit/test_observe.c traces twice as far and
 * finds none. */
static bool pull_off_is_certain(const po_reader *r, const po_branch_point *p,
                                double contact_radius) {
  const po_outcome *o = r->outcome;
  if (!isnan(r->request->approach_end) || !o->has_pull_off || p->unstable_modes > 0)
    return false;
  if (r->rises >= ENOUGH_RISES)
    return true;
  if (p->load <= 0.0)
    return false;
  const po_scene *scene = &r->request->scene;
  const bool past = contact_radius > o->pull_off.contact_radius + PAST_THE_WAVE * scene->wavelength;
  return !po_scene_is_wavy(scene) || r->risen ||
         (past && p->load > DROPS * r->greatest_drop - o->pull_off.force) ||
         p->load > GREATEST_PUSH * (1.0 + o->pull_off.force) ||
         (p->load > o->pull_off.force &&
          contact_radius > r->last_contact_radius + QUIET_WAVES * scene->wavelength);
}

bool po_reader_visit(const po_branch_point *p, void *data) {
  po_reader *r = data;
  po_outcome *o = r->outcome;
  if (r->request->stop && *r->request->stop) {
    r->status = po_fail(PO_INTERRUPTED, "interrupted at approach %.6g", p->approach);
    return true;
  }
  if (po_clock_thread() > r->deadline) {
    r->status = po_fail(PO_OUT_OF_TIME,
                        "after %g s of processor time the trace is at approach %.6g, load %.6g",
                        r->request->time_limit, p->approach, p->load);
    return true;
  }
  if (!r->begun && !(p->approach >= r->begin))
    return false;
  if (isnan(o->start))
    o->start = p->approach;
  r->begun = true;
  o->end = p->approach;
  if (r->surface && r->surface->n > r->most_nodes)
    r->most_nodes = r->surface->n;
  const double contact_radius = contact_radius_of(r, p);
  add_curve_point(r, p, contact_radius);
  if (p->kind == PO_POINT_STATION && !o->profile && (r->request->want & PO_WANT_PROFILE) &&
      fabs(p->approach - r->request->profile_approach) < SAME_APPROACH)
    keep_profile(r, p);
  if (p->kind != PO_POINT_STEP && p->kind != PO_POINT_STATION)
    add_landmark(r, p, contact_radius);
  if (p->kind == PO_POINT_LOAD_MIN)
    note_minimum(r, p, contact_radius);
  if (p->kind == PO_POINT_LOAD_MAX)
    r->last_maximum = p->load;
  if (!r->status && p->gap && contact_radius > GREATEST_CONTACT * r->surface->core_radius) {
    if (isinf(r->request->scene.outer_radius))
      r->status = po_fail(PO_OUT_OF_DOMAIN,
                          "the contact radius %.6g reached the end of the meshed surface, %.6g, at "
                          "approach %.6g",
                          contact_radius, r->surface->core_radius, p->approach);
    return true; /* a bounded surface is used up */
  }
  return r->status || pull_off_is_certain(r, p, contact_radius);
}
