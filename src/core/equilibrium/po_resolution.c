#include "po_resolution.h"

#include <math.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_profile.h"

po_resolution po_resolution_of(const po_equilibrium *e, po_allowance allowed) {
  return (po_resolution){e, allowed, po_initial_gap_detail(e->scene)};
}

/* Excess of a parent panel below which it replaces its two halves. */
static const double PARENT_MARGIN = 0.1;

/* Largest modulus of the last Legendre coefficients of the nodal values, and of all coefficients.
 */
static void decay(const double *value, double *last, double *largest) {
  const po_legendre *legendre = &po_panel_table_get()->legendre;
  *last = *largest = 0.0;
  for (int k = 0; k < PO_TABLE_ORDER; ++k) {
    double sum = 0.0;
    for (int j = 0; j < PO_TABLE_ORDER; ++j)
      sum += legendre->coefficient[k][j] * value[j];
    *largest = fmax(*largest, fabs(sum));
    if (k >= PO_TABLE_ORDER - PO_LAST_COEFFICIENTS)
      *last = fmax(*last, fabs(sum));
  }
}

static double value_at_end(int end, const double *value) {
  const po_legendre *legendre = &po_panel_table_get()->legendre;
  double sum = 0.0;
  for (int j = 0; j < PO_TABLE_ORDER; ++j)
    sum += legendre->at_end[end][j] * value[j];
  return sum;
}

/* The part of the error at the ends of a panel that is compared with the last coefficients. Where
 * these decay, the error is a few times the last ones. */
static const double SEEN_AT_END = 0.1;

/* Between the end and the nearest node the gap changes by less than this part of the scale of the
 * law if the panel is short enough for the coefficients to show the traction. */
static const double SMALL_CHANGE = 0.05;

/* The error of the polynomial through the nodal tractions at the ends of a panel, where the gap is
 * known from its own polynomial. The coefficients do not show a traction between the end and the
 * first node, as at the tip of a cone under a law of short range. */
static double error_at_ends(const po_law *law, const double *gap, const double *traction) {
  double error = 0.0;
  for (int end = 0; end < 2; ++end) {
    const double nearest = gap[end ? PO_TABLE_ORDER - 1 : 0];
    const double there = po_law_expected_gap(law, value_at_end(end, gap));
    if (fabs(there - nearest) < SMALL_CHANGE * po_law_size(law, nearest))
      continue;
    const double missed = fabs(po_law_at(law, there).traction - value_at_end(end, traction));
    error = missed > error ? missed : error;
  }
  return error;
}

/* Error of the gap on a panel relative to the change of the approach with which a contact edge
 * passes the panel. The error differs from panel to panel and with the place of the edge in the
 * panel, so that larger errors fold the branch. */
static const double RIPPLE = 5e-5;

/* The change of the approach with which a contact edge passes from begin to end: by JKR theory the
 * approach is the Abel transform of the profile, which rises about as the profile, less
 * sqrt(2 pi coupling a), a the radius of the edge. Near the pull-off the terms nearly cancel; that
 * is no reason to ask for more. */
static double change_along(const po_resolution *r, double begin, double end) {
  const po_scene *scene = r->e->scene;
  const double rise = fabs(po_initial_gap(scene, end) - po_initial_gap(scene, begin));
  return rise + (end - begin) * sqrt(M_PI * r->e->coupling / (begin + end));
}

/* Factor of the excess of a panel that has the kink of the profile inside. Its Legendre
 * coefficients fall slowly, so that the last of them are a small part of its error, which goes as
 * the square of its length. With a quarter of the value, a fold of a truncated sphere on a cut
 * surface has four times the error: 4.6e-6 of a load of 18 at a tolerance of 1e-9. */
static const double KINK_EXCESS = 120.0;

/* The integral of the traction over a panel by Gauss's rules on its halves, where the gap is that
 * of the profile plus the polynomial of the deflection, less that by the nodes; times r, as the
 * load. Of a panel with several waves the last coefficients may be small by chance: they left 4 %
 * of the load of a body with waves of 5 on a panel of 13. */
static double missed_by_nodes(const po_scene *scene, double begin, double length, const double *gap,
                              const double *traction) {
  const po_panel_table *table = po_panel_table_get();
  const po_panel_halves *halves = &table->halves;
  double deflection[PO_TABLE_ORDER], by_nodes = 0.0, by_halves = 0.0;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double r = begin + length * table->rule.node[j];
    deflection[j] = gap[j] - po_initial_gap(scene, r);
    by_nodes += table->rule.weight[j] * r * traction[j];
  }
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const double r = begin + length * halves->node[i];
    double there = po_initial_gap(scene, r);
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      there += halves->lagrange[i][j] * deflection[j];
    const double at = po_law_at(&scene->law, po_law_expected_gap(&scene->law, there)).traction;
    by_halves += halves->weight[i] * r * at;
  }
  return length * fabs(by_halves - by_nodes);
}

/* The excess of a panel. A traction of high degree deflects the surface on the panel by its
 * amplitude times the length of the panel over the degree; this changes the solution as far as the
 * traction there depends on the gap. Where the surfaces are pressed together the gap is nearly
 * fixed, and the traction takes up the deflection: the gap changes by the deflection over 1 +
 * stiffness. The load and the deflection elsewhere are integrals by Gauss's
 * rule, which is exact to twice the degree; their error goes as the square of the decay of the
 * coefficients. */
static double excess_of(const po_resolution *r, double begin, double end, const double *gap) {
  const po_law *law = &r->e->scene->law;
  double traction[PO_TABLE_ORDER], response = 0.0, last, largest;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const po_law_value p = po_law_at(law, po_law_expected_gap(law, gap[j]));
    traction[j] = p.traction;
    response = fmax(response, fabs(p.slope));
  }
  decay(traction, &last, &largest);
  last = fmax(last, SEEN_AT_END * error_at_ends(law, gap, traction));
  const double length = end - begin, ring = 2.0 / r->e->radius * 0.5 * (begin + end) * length;
  const double felt = fmin(1.0, response * fmax(r->e->coupling * length, ring));
  const double stiffness = response * r->e->coupling * length / (PO_TABLE_ORDER * PO_TABLE_ORDER);
  const double local = felt * r->e->coupling * length * last / PO_TABLE_ORDER / (1.0 + stiffness);
  const double allowed = fmin(r->allowed.gap, RIPPLE * change_along(r, begin, end));
  double load = ring * last * last / (largest + 1e-300);
  if (length > r->detail && ring * largest > r->allowed.load && load < r->allowed.load)
    load =
        fmax(load, 2.0 / r->e->radius * missed_by_nodes(r->e->scene, begin, length, gap, traction));
  const double excess = fmax(local / allowed, load / r->allowed.load);
  return po_profile_has_kink_between(&r->e->scene->profile, begin, end) ? KINK_EXCESS * excess
                                                                        : excess;
}

double po_resolution_excess_of(const po_resolution *r, const po_panels *panels, const double *gap,
                               size_t panel) {
  const double domain = r->e->surface->core_radius;
  return excess_of(r, domain * po_panel_begin(panels->panel[panel]),
                   domain * po_panel_end(panels->panel[panel]), gap + panel * PO_TABLE_ORDER);
}

double po_resolution_excess(const po_resolution *r, const po_panels *panels, const double *gap) {
  double worst = 0.0;
  for (size_t k = 0; k < panels->count; ++k)
    worst = fmax(worst, po_resolution_excess_of(r, panels, gap, k));
  return worst;
}

typedef struct {
  const po_resolution *r;
  const po_gap_field *field;
} resolved_field;

static double excess_of_panel(const resolved_field *f, po_panel panel) {
  const po_resolution *r = f->r;
  const double *node = po_panel_table_get()->rule.node;
  const double domain = r->e->surface->core_radius;
  const double begin = domain * po_panel_begin(panel), end = domain * po_panel_end(panel);
  double gap[PO_TABLE_ORDER];
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
    gap[i] = f->field->gap_at(f->field->data, begin + (end - begin) * node[i]);
  return excess_of(r, begin, end, gap);
}

static bool is_too_coarse(void *data, po_panel panel) {
  return excess_of_panel(data, panel) > 1.0;
}

static void join_what_can_be(const resolved_field *f, po_panels *panels) {
  bool *const join = panels->marked;
  memset(join, 0, panels->count * sizeof *join);
  for (size_t k = 0; k + 1 < panels->count; ++k) {
    const po_panel a = panels->panel[k], b = panels->panel[k + 1];
    if (a.level < 2 || a.level != b.level || a.index % 2 || b.index != a.index + 1)
      continue;
    const po_panel parent = {a.level - 1, a.index / 2};
    join[k] = join[k + 1] = excess_of_panel(f, parent) < PARENT_MARGIN;
  }
  po_panels_join(panels);
}

po_status po_resolution_fail(const po_scene *scene, const po_panels *panels) {
  for (size_t k = 0; k < panels->count; ++k)
    if (panels->panel[k].level == PO_DEEPEST_LEVEL)
      return po_fail(PO_OUT_OF_NODES,
                     "the traction needs panels shorter than 2^-%d of the domain: if the load is "
                     "compressive there, expected a smaller preload, otherwise a smaller coupling "
                     "or Tabor parameter, in SI units a greater distance",
                     PO_DEEPEST_LEVEL);
  return po_fail(PO_OUT_OF_NODES, "the traction needs more than %d panels%s", PO_MOST_PANELS,
                 po_scene_is_wavy(scene) ? ": expected longer waves or a smaller outer radius"
                                         : "");
}

po_status po_resolution_panels(const po_resolution *r, const po_gap_field *field,
                               po_panels *panels) {
  resolved_field f = {r, field};
  join_what_can_be(&f, panels);
  return po_panels_refine(panels, PO_MOST_HALVINGS, is_too_coarse, &f)
             ? PO_OK
             : po_resolution_fail(r->e->scene, panels);
}
