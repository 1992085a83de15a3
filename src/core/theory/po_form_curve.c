/* The curve of a closed form over the contact radius. */
#include <math.h>
#include <stdlib.h>

#include "po_abel.h"
#include "po_forms.h"
#include "po_guduru.h"
#include "po_margins.h"
#include "po_maugis.h"
#include "po_memory.h"
#include "po_root.h"
#include "po_theory_forces.h"

/* POINTS: of the curve, without those of waves; PER_WAVE: points in the shortest wave; MOST: points
 * of a curve. */
enum { POINTS = 200, PER_WAVE = 32, MOST = 1 << 17 };

/* Two contact radii that differ by less, relatively, are one point. */
static const double SAME = 1e-12;

typedef enum { JKR, DMT, MAUGIS } curve_kind;

typedef struct {
  const po_scene *scene;
  curve_kind kind;
  double tension; /* of Maugis-Dugdale */
  double first;   /* a contact radius that is small beside the first step */
  po_status status;
} curve;

static curve_kind kind_of(const po_form *form) {
  return form->takes & PO_TAKES_TENSION                             ? MAUGIS
         : form->takes & (PO_TAKES_AMPLITUDE | PO_TAKES_WAVELENGTH) ? JKR
                                                                    : DMT;
}

/* The state at a contact radius and its derivatives by it. */
static po_contact state_at(curve *c, double a, double *approach_rate, double *load_rate) {
  const po_scene *scene = c->scene;
  *approach_rate = *load_rate = INFINITY; /* of DMT: everywhere stable */
  if (c->kind == DMT)
    return po_dmt_at(scene, a);
  if (c->kind == JKR && po_scene_is_of_paper(scene)) {
    *approach_rate = po_guduru_rate(scene, PO_FIXED_APPROACH, a);
    *load_rate = po_guduru_rate(scene, PO_FIXED_LOAD, a);
    return po_guduru_at(scene, a);
  }
  if (c->kind == JKR) {
    *approach_rate = po_jkr_profile_rate(scene, PO_FIXED_APPROACH, a);
    *load_rate = po_jkr_profile_rate(scene, PO_FIXED_LOAD, a);
    return po_jkr_profile_at(scene, a);
  }
  po_maugis state = {{NAN, NAN, NAN}, NAN, NAN};
  double width_rate;
  const po_status status = po_maugis_at(scene, c->tension, a, &state);
  c->status = c->status ? c->status : status;
  *approach_rate = *load_rate = NAN;
  if (!status && a > 0.0) {
    *approach_rate = po_maugis_rate(scene, c->tension, PO_FIXED_APPROACH, &state, &width_rate);
    *load_rate = po_maugis_rate(scene, c->tension, PO_FIXED_LOAD, &state, &width_rate);
  }
  return state.contact;
}

static double approach_rate(double a, const void *data) {
  curve c = *(const curve *)data;
  double approach, load;
  state_at(&c, a, &approach, &load);
  return approach;
}

static double load_rate(double a, const void *data) {
  curve c = *(const curve *)data;
  double approach, load;
  state_at(&c, a, &approach, &load);
  return load;
}

/* At contact radius 0 the stability is that of the states beyond it. */
static po_form_point point_at(curve *c, double a) {
  double by_approach, by_load;
  const po_contact state = state_at(c, a, &by_approach, &by_load);
  if (a == 0.0)
    state_at(c, c->first, &by_approach, &by_load);
  return (po_form_point){state.approach, state.load, a, by_approach > 0.0, by_load > 0.0};
}

/* Appends the points at which the stability changes between the last point and `a`, in order, then
 * that at `a`. A point at which it changes has that of the states beyond it. */
static po_status append_up_to(curve *c, double a, po_form_point **points, size_t *count,
                              size_t *room) {
  po_form_point next[3] = {point_at(c, a)};
  size_t added = 1;
  if (*count) {
    po_form_point *last_point = &(*points)[*count - 1];
    const po_form_point last = *last_point, here = next[0];
    const double from = fmax(last.contact_radius, c->first);
    const double changes[] = {
        here.stable_at_approach != last.stable_at_approach ? po_root(approach_rate, c, from, a)
                                                           : NAN,
        here.stable_at_load != last.stable_at_load ? po_root(load_rate, c, from, a) : NAN};
    /* it changes at the last point, as at a corner */
    if (changes[0] <= last.contact_radius * (1.0 + SAME))
      last_point->stable_at_approach = here.stable_at_approach;
    if (changes[1] <= last.contact_radius * (1.0 + SAME))
      last_point->stable_at_load = here.stable_at_load;
    const double first = fmin(changes[0], changes[1]), second = fmax(changes[0], changes[1]);
    added = 0;
    for (int k = 0; k < 2; ++k) {
      const double r = k ? second : first;
      if (!(r > last.contact_radius * (1.0 + SAME) && r < a * (1.0 - SAME)) || (k && r == first))
        continue;
      next[added] = point_at(c, r);
      next[added].stable_at_approach =
          r >= changes[0] ? here.stable_at_approach : last.stable_at_approach;
      next[added].stable_at_load = r >= changes[1] ? here.stable_at_load : last.stable_at_load;
      ++added;
    }
    next[added++] = here;
  }
  for (size_t k = 0; k < added && !c->status; ++k) {
    if (*count == MOST)
      return po_fail(PO_TOO_MANY_POINTS, "the curve has more than %d points: expected fewer waves",
                     MOST);
    po_form_point *moved = po_grow(*points, *count, room, sizeof *moved);
    if (!moved)
      return PO_NO_MEMORY;
    *points = moved;
    moved[(*count)++] = next[k];
  }
  return c->status;
}

/* The contact radius at which the curve ends. */
static po_status end_of(const curve *c, const po_form_input *in, double *end) {
  po_contact least = {NAN, NAN, NAN};
  po_jkr_preloaded state;
  po_maugis ring;
  po_status status = PO_OK;
  if (c->kind == DMT) {
    *end = po_dmt_radius(c->scene, PO_FIXED_LOAD, 1.0);
    return PO_OK;
  }
  if (in->has_preload) {
    status = po_jkr_after_preload(c->scene, in->preload, &state);
    *end = status ? NAN : state.reversal.contact_radius;
    return status;
  }
  status = c->kind == MAUGIS ? po_maugis_pull_off(c->scene, c->tension, PO_FIXED_LOAD, false, &ring)
                             : po_jkr_profile_pull_off(c->scene, PO_FIXED_LOAD, &least);
  if (!status && c->kind == MAUGIS && !(ring.contact.contact_radius > 0.0))
    status = po_jkr_profile_pull_off(c->scene, PO_FIXED_LOAD, &least);
  else if (c->kind == MAUGIS)
    least = ring.contact;
  *end = 2.0 * least.contact_radius;
  return status;
}

po_status po_form_curve(const po_form *form, const po_form_input *input, po_form_point **points,
                        size_t *count) {
  curve c = {&input->scene, kind_of(form),
             input->tension > 0.0 ? input->tension : po_maugis_matched_tension(&input->scene), 0.0,
             PO_OK};
  double end;
  size_t room = 0;
  *points = NULL;
  *count = 0;
  po_status status = end_of(&c, input, &end);
  const bool wavy = po_scene_is_wavy(&input->scene) && c.kind != DMT;
  double step = end / POINTS, a = 0.0;
  for (size_t k = 0; wavy && k < po_scene_waves(&input->scene); ++k)
    step = fmin(step, po_scene_wave(&input->scene, k).length / PER_WAVE);
  c.first = PO_NEAR_AXIS * step;
  const double steps = status ? 0.0 : ceil(end / step);
  if (!(steps < MOST))
    status = po_fail(PO_TOO_MANY_POINTS, "the curve has %g points: expected fewer waves", steps);
  for (size_t k = 0; (double)k <= steps && !status; ++k) {
    a = k < (size_t)steps ? (double)k * step : end;
    status = append_up_to(&c, a, points, count, &room);
  }
  if (!status)
    return PO_OK;
  free(*points);
  *points = NULL;
  *count = 0;
  return status;
}
