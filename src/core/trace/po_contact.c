#include "po_contact.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_margins.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_refine.h"
#include "po_root.h"
#include "po_solution.h"

/* Largest error of the gap that is used, eps. */
static const double GREATEST_DOUBT = 1.0;

typedef struct {
  double gap, slope; /* H and dH/dr */
} value;

po_contact_gap po_contact_gap_on_panels(const po_scene *scene, const po_solution *solution) {
  return (po_contact_gap){.scene = scene,
                          .approach = solution->state[solution->n],
                          .end = solution->domain,
                          .solution = solution};
}

po_contact_gap po_contact_gap_of(const po_scene *scene, const po_branch_point *p) {
  if (p->solution)
    return po_contact_gap_on_panels(scene, p->solution);
  po_contact_gap g = {.scene = scene, .approach = p->approach};
  if (p->gap) {
    g.n = p->n;
    g.node = p->node;
    g.gap = p->gap;
    g.end = p->node[p->n - 1];
  } else { /* rigid: the contact is bounded by that of the sphere without waves */
    const double reach =
        fmax(0.0, p->approach + po_law_numbers_of(&scene->law)->peak_gap) + GREATEST_DOUBT;
    g.end = fmin(po_initial_gap_radius(scene, reach), scene->outer_radius);
  }
  return g;
}

/* Linear interpolation of the deflection, which is constant inside the first node. */
static value value_on_elements(const po_contact_gap *g, double r) {
  const size_t j = po_order_last_up_to(g->node, g->n, r);
  const double here = g->gap[j] - po_initial_gap(g->scene, g->node[j]);
  value v = {po_initial_gap(g->scene, r) + here, po_initial_gap_slope(g->scene, r)};
  if (r <= g->node[0] || j + 1 == g->n)
    return v;
  const double next = g->gap[j + 1] - po_initial_gap(g->scene, g->node[j + 1]);
  const double slope = (next - here) / (g->node[j + 1] - g->node[j]);
  v.gap += slope * (r - g->node[j]);
  v.slope += slope;
  return v;
}

static value value_at(const po_contact_gap *g, double r) {
  if (g->solution) {
    po_solution_field field = {g->solution, g->scene, 0};
    const po_solution_value v = po_solution_value_at(&field, r);
    return (value){v.gap, v.slope};
  }
  if (g->n)
    return value_on_elements(g, r);
  return (value){po_initial_gap(g->scene, r) - g->approach, po_initial_gap_slope(g->scene, r)};
}

/* A gap changed by the bound of its error: `side` is -1 for the smaller gap, 1 for the larger, 0
 * for the gap itself. */
typedef struct {
  const po_contact_gap *g;
  const po_contact_doubt *doubt; /* not used if side is 0 */
  int side;
  double level;
} sought;

static double doubt_at(const sought *s, double r, double gap) {
  const po_contact_doubt *d = s->doubt;
  if (!d->finer)
    return d->constant;
  return d->constant +
         po_refine_error(d->precision, value_at(d->finer, fmin(r, d->finer->end)).gap - gap, gap);
}

/* The gap less the level, and the slope. The slope is that of the gap itself, since the error
 * changes little between two samples. */
static value beyond(const sought *s, double r) {
  value v = value_at(s->g, r);
  if (s->side)
    v.gap += s->side * doubt_at(s, r, v.gap);
  v.gap -= s->level;
  return v;
}

static double gap_beyond(double r, const void *data) {
  return beyond(data, r).gap;
}
static double slope_at(double r, const void *data) {
  return beyond(data, r).slope;
}

/* The next smaller radius at which the gap is sampled: a panel as often as it has nodes, a smooth
 * sphere without panels as a wavelength. Between two samples the gap has at most one extremum,
 * which the slopes at the samples show. */
static double inwards(const po_contact_gap *g, double r) {
  double step = INFINITY, begin = 0.0;
  if (g->solution) {
    const po_panels *panels = g->solution->panels;
    size_t k = po_panels_find(panels, r / g->end, 0);
    if (k > 0 && g->end * po_panel_begin(panels->panel[k]) >= r)
      --k;
    begin = g->end * po_panel_begin(panels->panel[k]);
    step = g->end * po_panel_size(panels->panel[k]) / PO_TABLE_ORDER;
  } else if (g->n) {
    size_t j = po_order_last_up_to(g->node, g->n, r);
    if (j > 0 && g->node[j] >= r)
      --j;
    begin = g->node[j] < r ? g->node[j] : 0.0;
  } else {
    step = g->end / PO_POINTS_PER_WAVE;
  }
  return fmax(begin, r - fmin(step, po_initial_gap_detail(g->scene) / PO_POINTS_PER_WAVE));
}

/* A radius beyond which rigid surfaces are not in contact: the waves only increase the gap of the
 * profile. */
static double skip_rigid(const sought *s, double r) {
  const double reach = s->g->approach + s->level + (s->side ? s->doubt->constant : 0.0);
  return fmin(r, po_initial_gap_radius(s->g->scene, reach));
}

/* The inner end of the panel below a radius if the gap is above the level on the whole panel;
 * otherwise the radius itself. The bound: the waves only increase the gap of the sphere, and the
 * deflection exceeds the range of its nodal values by less than that range. */
static double skip(const sought *s, double r) {
  const po_contact_gap *g = s->g;
  if (!g->solution)
    return g->n ? r : skip_rigid(s, r);
  const po_panels *panels = g->solution->panels;
  size_t k = po_panels_find(panels, r / g->end, 0);
  const double begin = g->end * po_panel_begin(panels->panel[k]);
  double least = INFINITY, largest = -INFINITY;
  for (size_t j = k * PO_TABLE_ORDER; j < (k + 1) * PO_TABLE_ORDER; ++j) {
    least = fmin(least, g->solution->deflection[j]);
    largest = fmax(largest, g->solution->deflection[j]);
  }
  const double initial = po_initial_gap_beyond(g->scene, begin);
  const double level = s->level + (s->side ? GREATEST_DOUBT : 0.0);
  return initial + least - (largest - least) > level ? begin : r;
}

/* Rounding, eps: an extremum that passes the level by less is taken as not passing it. */
static const double GAP_ROUNDING = 1e-13;

/* The radius of the minimum or maximum of the gap between a and b; NaN if there is none. */
static double extremum_between(const sought *s, double a, value at_a, double b, value at_b,
                               bool minimum) {
  const double sign = minimum ? 1.0 : -1.0;
  return sign * at_a.slope < 0.0 && sign * at_b.slope > 0.0 ? po_root(slope_at, s, a, b)
                                                            : (double)NAN;
}

/* The outermost edge between a and b; -1 if there is none. If b is itself an edge, the sign of its
 * gap less the level is undetermined because of rounding. */
static double edge_between(const sought *s, double a, value at_a, double b, value at_b,
                           bool inside) {
  const bool a_inside = at_a.gap <= 0.0, b_inside = at_b.gap <= 0.0;
  if (a_inside != inside) { /* inside the extremum */
    const double extremum = extremum_between(s, a, at_a, b, at_b, inside);
    if (!isnan(extremum) && (gap_beyond(extremum, s) <= 0.0) == inside)
      return po_root(gap_beyond, s, a, extremum);
    return b_inside == inside ? po_root(gap_beyond, s, a, b) : b;
  }
  const double extremum = extremum_between(s, a, at_a, b, at_b, !inside);
  const double past = isnan(extremum) ? 0.0 : gap_beyond(extremum, s);
  if (inside ? !(past > GAP_ROUNDING) : !(past < -GAP_ROUNDING))
    return -1.0;
  return b_inside == inside ? po_root(gap_beyond, s, extremum, b) : b;
}

/* Finds the next edge inwards of `from`, where the gap passes the level. Given: whether the gap is
 * below the level just inside `from`. Returned: its radius; -1 when there is none. */
static double next_edge(const sought *s, double from, bool inside) {
  double b = from;
  value at_b = beyond(s, b);
  while (b > 0.0) {
    const double skipped = inside ? b : skip(s, b);
    const double a = skipped < b ? skipped : inwards(s->g, b);
    const value at_a = beyond(s, a);
    const double edge = edge_between(s, a, at_a, b, at_b, inside);
    if (edge >= 0.0)
      return edge;
    b = a;
    at_b = at_a;
  }
  return -1.0;
}

/* The outermost edge inside a radius at which the gap is above the level; 0 if there is none. */
static double outermost(const sought *s, double from) {
  return fmax(0.0, next_edge(s, from, false));
}

static double radius_of(const sought *s) {
  return beyond(s, s->g->end).gap <= 0.0 ? s->g->end : outermost(s, s->g->end);
}

/* Upper bound of the radius of the edge. If the gap minus its error has contact annuli farther out
 * that the gap itself does not have, the edge of the outermost one is recorded. */
static double farthest(const sought *as_it_is, double radius, double *other) {
  sought closer = *as_it_is;
  closer.side = -1;
  double edge = radius_of(&closer);
  while (edge > radius) {
    const double inner = next_edge(&closer, edge, true);
    if (inner <= radius)
      break;
    if (isnan(*other))
      *other = 0.5 * (inner + edge);
    edge = fmin(inner, outermost(&closer, inner));
  }
  return edge;
}

/* Lower bound of the radius of the edge. If the outermost annulus vanishes with the gap plus its
 * error, the edge of the next annulus is recorded. */
static double nearest(const sought *as_it_is, double radius, double *other) {
  sought farther = *as_it_is;
  farther.side = 1;
  const double edge = radius_of(&farther);
  const double inner = next_edge(as_it_is, radius, true);
  if (edge >= inner)
    return edge;
  if (isnan(*other))
    *other = outermost(as_it_is, inner);
  return 0.5 * (inner + radius);
}

/* Shortest wavelength of a rigid scene, relative to the radius, below which waves are not resolved:
 * the outermost crest in contact is within one wavelength of the contact edge of the smooth sphere.
 */
static const double SHORTEST_WAVE = 1e-8;

static bool is_smeared(const po_contact_gap *g) {
  const po_scene *scene = g->scene;
  return !g->solution && g->n == 0 && po_scene_is_wavy(scene) &&
         po_initial_gap_detail(scene) < SHORTEST_WAVE * g->end;
}

static double radius_of_sphere(const po_contact_gap *g, double doubt) {
  const double reach = g->approach + po_law_numbers_of(&g->scene->law)->peak_gap + doubt;
  return fmin(g->end, po_initial_gap_radius(g->scene, reach));
}

static po_contact_edge estimate_smeared(const po_contact_gap *g, double doubt) {
  const double radius = radius_of_sphere(g, 0.0);
  const double change =
      fmax(radius_of_sphere(g, doubt) - radius, radius - radius_of_sphere(g, -doubt));
  return (po_contact_edge){radius, change + po_initial_gap_detail(g->scene), NAN};
}

double po_contact_radius(const po_contact_gap *gap) {
  if (is_smeared(gap))
    return radius_of_sphere(gap, 0.0);
  return radius_of(&(sought){.g = gap, .level = po_law_numbers_of(&gap->scene->law)->peak_gap});
}

double po_contact_disc(const po_contact_gap *gap) {
  if (is_smeared(gap))
    return radius_of_sphere(gap, 0.0);
  const sought s = {.g = gap, .level = po_law_numbers_of(&gap->scene->law)->peak_gap};
  double edge = radius_of(&s);
  while (edge > 0.0) {
    const double inner = next_edge(&s, edge, true);
    if (inner < 0.0)
      break;
    edge = outermost(&s, inner);
  }
  return edge;
}

po_contact_edge po_contact_estimate(const po_contact_gap *gap, const po_contact_doubt *doubt) {
  if (is_smeared(gap))
    return estimate_smeared(gap, doubt->constant);
  const sought s = {
      .g = gap, .doubt = doubt, .level = po_law_numbers_of(&gap->scene->law)->peak_gap};
  po_contact_edge e = {.radius = radius_of(&s), .other = NAN};
  e.error = fmax(0.0, farthest(&s, e.radius, &e.other) - e.radius);
  e.error = fmax(e.error, e.radius - nearest(&s, e.radius, &e.other));
  return e;
}

/* Largest number of annuli that are listed. There can be as many as waves in the contact. */
enum { MOST_ANNULI = 10000 };

static po_status too_many(void) {
  return po_fail(PO_OUT_OF_NODES, "the contact has more than %d annuli", MOST_ANNULI);
}

/* Annuli below a level, from the axis outwards. Status: PO_NO_MEMORY, PO_OUT_OF_NODES. */
static po_status fill(const po_contact_gap *gap, double level, po_contact_annulus **list,
                      size_t *count) {
  const sought s = {.g = gap, .level = level};
  size_t room = 0;
  bool inside = beyond(&s, gap->end).gap <= 0.0;
  double outer = gap->end, edge = gap->end;
  *count = 0;
  for (;;) {
    edge = next_edge(&s, edge, inside);
    if (edge < 0.0 && !inside)
      break;
    if (!inside) {
      outer = edge;
    } else {
      if (*count == MOST_ANNULI)
        return too_many();
      po_contact_annulus *more = po_grow(*list, *count, &room, sizeof *more);
      if (!more)
        return PO_NO_MEMORY;
      *list = more;
      more[(*count)++] = (po_contact_annulus){fmax(edge, 0.0), outer};
      if (edge < 0.0)
        break;
    }
    inside = !inside;
  }
  for (size_t k = 0; 2 * k + 1 < *count; ++k) {
    const po_contact_annulus first = (*list)[k];
    (*list)[k] = (*list)[*count - 1 - k];
    (*list)[*count - 1 - k] = first;
  }
  return PO_OK;
}

po_status po_contact_annuli_fill(const po_contact_gap *gap, po_contact_annuli *a) {
  if (is_smeared(gap))
    return too_many();
  const po_status status = fill(gap, 0.0, &a->compressed, &a->compressed_count);
  return status
             ? status
             : fill(gap, po_law_numbers_of(&gap->scene->law)->peak_gap, &a->held, &a->held_count);
}

po_status po_contact_profile_fill(const po_scene *scene, const po_surface *s,
                                  const po_branch_point *p, po_profile_point **profile,
                                  size_t *count) {
  const size_t most = p->gap ? p->n : s->resolved;
  po_profile_point *points = po_resize(*profile, most, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  const double tabor = scene->tabor > 0.0 ? scene->tabor : 1.0;
  *profile = points;
  *count = 0;
  for (size_t j = 0; j < most; ++j) {
    const double radius = p->gap ? p->node[j] : s->node[j];
    if (radius > s->core_radius)
      break;
    const double gap = p->gap ? p->gap[j] : po_initial_gap(scene, radius) - p->approach;
    points[(*count)++] = (po_profile_point){
        .radius = radius, .gap = gap, .traction = tabor * po_law_at(&scene->law, gap).traction};
  }
  return PO_OK;
}

po_status po_contact_profile_take(const po_scene *scene, const po_surface *s,
                                  const po_branch_point *p, po_result *o) {
  const po_status status = po_contact_profile_fill(scene, s, p, &o->profile, &o->profile_count);
  if (status)
    return status;
  o->profile_approach = p->approach;
  const po_contact_gap field = po_contact_gap_of(scene, p);
  return po_contact_annuli_fill(&field, &o->annuli);
}
