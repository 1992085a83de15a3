#include "po_stopping.h"

#include <math.h>

po_stopping po_stopping_begin(const po_request *request) {
  return (po_stopping){.request = request,
                       .preload = po_request_preload(request),
                       .greatest_approach = -INFINITY,
                       .greatest_load = -INFINITY,
                       .carried = -INFINITY,
                       .enough = NAN,
                       .disc = 0.0,
                       .margin = 1.0};
}

bool po_stopping_note_minimum(po_stopping *s, double load) {
  const bool deepest = !s->has_minimum || load < s->deepest;
  s->has_minimum = true;
  if (deepest) {
    s->deepest = load;
    s->enough = po_request_bound(s->request, load);
  }
  return deepest && !s->met;
}

static void note_loading(po_stopping *s, const po_branch_point *p, const po_contact_gap *gap,
                         double contact_radius) {
  /* loading reaches a fold, although the points after it are unstable */
  if (p->unstable_modes > (p->kind == PO_POINT_APPROACH_MAX ? 1 : 0))
    return;
  if (p->approach >= s->greatest_approach) {
    s->greatest_approach = p->approach;
    s->greatest_load = fmax(s->greatest_load, p->load);
    if (contact_radius > s->enough || contact_radius >= s->request->scene.outer_radius)
      s->disc = fmax(s->disc, po_contact_disc(gap));
  }
  if (p->approach_rate > 0.0 && (p->load_rate > 0.0 || p->kind == PO_POINT_LOAD_MAX))
    s->carried = fmax(s->carried, p->load);
}

/* Updates the margin. The trace of a slightly different scene might have ended at a point where
 * this one continues. */
static void note_margin(po_stopping *s) {
  if (!isnan(s->preload.approach))
    s->margin = fmin(s->margin, s->preload.approach - s->greatest_approach);
  if (!isnan(s->preload.load))
    s->margin = fmin(s->margin, s->preload.load - s->greatest_load);
}

void po_stopping_note_point(po_stopping *s, const po_branch_point *p, const po_contact_gap *gap,
                            double contact_radius) {
  note_loading(s, p, gap, contact_radius);
  s->effort += (double)p->n * (double)p->n;
  if (s->met)
    return;
  note_margin(s);
  s->before = s->effort;
  s->met = po_path_reaches(s->greatest_approach, s->preload.approach) ||
           s->greatest_load >= s->preload.load;
}

/* Load, pi w R, at which a search ends. A search continues at least to the default preload, because
 * its bound is that of the JKR theory: at small Tabor parameters the first minimum may be deeper
 * than any of the JKR theory. */
static const double HARDEST = 100.0;
/* The effort of a limited search is at most a multiple of the effort before it, plus a constant.
 * The effort is the sum over the points of the square of the number of nodes, about the work of the
 * matrices; 400 points of 250 nodes take some tenths of a second. */
static const double EFFORT = 2.0, EFFORT_AT_LEAST = 400.0 * 250.0 * 250.0;

bool po_stopping_is_searching(const po_stopping *s) {
  return po_request_search(s->request) != PO_SEARCH_NONE && s->has_minimum &&
         (s->met || (isinf(s->preload.approach) && s->greatest_load >= PO_USUAL_PRELOAD));
}

/* A cut surface has no contact beyond its end. */
bool po_stopping_is_complete(const po_stopping *s, double load) {
  const po_scene *scene = &s->request->scene;
  if (po_scene_is_simple(scene))
    return s->has_minimum && s->greatest_load > 0.0;
  if (!s->request->theories || !(s->disc > 0.0) || s->greatest_load < PO_USUAL_PRELOAD)
    return false;
  return s->disc > po_request_bound(s->request, load) || s->disc >= scene->outer_radius;
}

static bool ends_compressed(const po_stopping *s) {
  const po_request *r = s->request;
  return po_scene_is_simple(&r->scene) && isnan(r->preload.approach) && isnan(r->preload.load) &&
         !(r->want & (PO_WANT_HYSTERESIS | PO_WANT_PRELOAD));
}

/* Whether loading at given load has reached the greatest load of loading at given approach. */
static bool is_carried(const po_stopping *s) {
  const bool both = s->request->want & (PO_WANT_HYSTERESIS | PO_WANT_PRELOAD);
  return !both || s->carried >= fmax(0.0, s->greatest_load);
}

/* The cause for which a search ends; PO_END_NONE if it continues. */
static po_end_cause search_ends(const po_stopping *s) {
  const po_scene *scene = &s->request->scene;
  if (s->greatest_load >= PO_USUAL_PRELOAD &&
      (s->disc > s->enough || s->disc >= scene->outer_radius))
    return PO_END_COMPLETE;
  if (po_request_search(s->request) == PO_SEARCH_SOME &&
      s->effort > EFFORT * s->before + EFFORT_AT_LEAST)
    return PO_END_SEARCHED;
  const double hardest = s->request->hardest > 0.0 ? s->request->hardest : HARDEST;
  return s->greatest_load > hardest ? PO_END_SEARCHED : PO_END_NONE;
}

po_end_cause po_stopping_cause(const po_stopping *s, const po_branch_point *p) {
  const po_request *r = s->request;
  if (p->unstable_modes > 0 || !isnan(r->approach_end))
    return PO_END_NONE;
  if (ends_compressed(s))
    return s->has_minimum && p->load > 0.0 ? PO_END_COMPRESSED : PO_END_NONE;
  if (!is_carried(s) || p->approach < s->greatest_approach)
    return PO_END_NONE;
  if (po_request_search(r) == PO_SEARCH_NONE)
    return s->met ? PO_END_PRELOAD : PO_END_NONE;
  const bool loaded = s->met || isinf(s->preload.approach);
  return loaded && s->has_minimum ? search_ends(s) : PO_END_NONE;
}
