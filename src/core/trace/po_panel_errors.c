#include "po_panel_errors.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_linear.h"
#include "po_margins.h"
#include "po_quadrature.h"
#include "po_solution.h"

/* Distance of a kink from the end of a panel, relative to its length, within which it is there. */
static const double AT_END = 1e-9;

/* A panel of a solution: its radii, eps, and the values at its nodes. */
typedef struct {
  double begin, size;
  double deflection[PO_TABLE_ORDER];                         /* H - f */
  double traction[PO_TABLE_ORDER], response[PO_TABLE_ORDER]; /* p and dp/dH */
  double tangent[PO_TABLE_ORDER];                            /* dH/ds */
} panel;

static panel panel_of(const po_scene *scene, const po_solution *p, size_t k) {
  const po_panel place = p->panels->panel[k];
  panel here = {.begin = p->domain * po_panel_begin(place),
                .size = p->domain * po_panel_size(place)};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const size_t at = k * PO_TABLE_ORDER + j;
    here.deflection[j] = p->deflection[at];
    const po_law_value law = po_law_at(&scene->law, p->state[at]);
    here.traction[j] = law.traction;
    here.response[j] = law.slope;
    here.tangent[j] = p->tangent[at];
  }
  return here;
}

/* Integrals over a panel, of r dr. */
typedef struct {
  double energy;  /* of phi(H) */
  double load;    /* of the traction */
  double rate;    /* of its derivative along the branch */
  double squares; /* of the square of the traction's difference from its polynomial */
} integrals;

/* Adds the integrals over a panel at the nodes of a rule: at x, 0 to 1 on the panel, with its
 * weight and the Lagrange polynomials of the panel there. */
static void add_point(const po_scene *scene, const panel *p, double x, double weight,
                      const double lagrange[PO_TABLE_ORDER], integrals *sum) {
  const double r = p->begin + p->size * x;
  const double gap =
      po_initial_gap(scene, r) + po_linear_dot(PO_TABLE_ORDER, p->deflection, lagrange);
  const po_law_value law = po_law_at(&scene->law, gap);
  const double off = law.traction - po_linear_dot(PO_TABLE_ORDER, p->traction, lagrange);
  weight = p->size * weight * r;
  sum->energy += weight * po_law_energy(&scene->law, gap);
  sum->load += weight * law.traction;
  sum->rate += weight * law.slope * po_linear_dot(PO_TABLE_ORDER, p->tangent, lagrange);
  sum->squares += weight * off * off;
}

/* The integrals over a panel by Gauss's rule on its halves. */
static integrals by_halves(const po_scene *scene, const panel *p) {
  const po_panel_halves *h = &po_panel_table_get()->halves;
  integrals sum = {0};
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i)
    add_point(scene, p, h->node[i], h->weight[i], h->lagrange[i], &sum);
  return sum;
}

/* Length of a piece at least, relative to the panel. */
static const double SHORTEST_PIECE = 1.0 / 16.0;

/* The same by Gauss's rule on the pieces between the joints of the profile, and the middle, each at
 * most as long as a wave. Of a panel with many rows or waves the error is then that of the shortest
 * piece. */
static integrals by_pieces(const po_scene *scene, const panel *p) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double detail = po_initial_gap_detail(scene);
  integrals sum = {0};
  for (double from = 0.0, to; from < 1.0; from = to) {
    const double begin = p->begin + p->size * from;
    const double end = fmin(po_profile_next_joint(&scene->profile, begin), begin + detail);
    to = fmax((end - p->begin) / p->size, from + SHORTEST_PIECE);
    to = fmin(to, from < 0.5 ? 0.5 : 1.0);
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const double x = from + (to - from) * rule->node[j];
      double lagrange[PO_TABLE_ORDER];
      po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, x, lagrange);
      add_point(scene, p, x, (to - from) * rule->weight[j], lagrange, &sum);
    }
  }
  return sum;
}

/* The integrals of phi(H) and of the traction by the nodes of a panel. */
static integrals by_nodes(const po_scene *scene, const panel *p) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  integrals sum = {0};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double r = p->begin + p->size * rule->node[j], weight = p->size * rule->weight[j] * r;
    const double gap = po_initial_gap(scene, r) + p->deflection[j];
    sum.energy += weight * po_law_energy(&scene->law, gap);
    sum.load += weight * p->traction[j];
    sum.rate += weight * p->response[j] * p->tangent[j];
  }
  return sum;
}

/* The error of Gauss's rule for x^power ln x on (0, 1). */
static double error_of_rule(int power) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  double sum = 1.0 / ((power + 1) * (power + 1));
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    double term = rule->weight[j] * po_log(rule->node[j]);
    for (int k = 0; k < power; ++k)
      term *= rule->node[j];
    sum += term;
  }
  return fabs(sum);
}

/* The value of the polynomial through the nodal tractions of a panel at its beginning or end. */
static double traction_at(const panel *p, int end) {
  return po_linear_dot(PO_TABLE_ORDER, p->traction, po_panel_table_get()->legendre.at_end[end]);
}

/* Between two panels the polynomials of the traction jump by J, and at the end of a cut surface the
 * traction does. So the deflection has a part -(2/pi) coupling J x ln x at the distance x from
 * there, and the integrand phi + p u/2 of the energy has -p/2 of it. Given: a panel, and the next
 * one; of the last panel one without tractions. */
static double of_border(const po_scene *scene, const panel *p, const panel *next) {
  const double a = traction_at(p, 1), b = traction_at(next, 0), end = p->begin + p->size;
  const double parts = fabs(a) * p->size * p->size + fabs(b) * next->size * next->size;
  return po_scene_coupling(scene) / M_PI * fabs(a - b) * parts * end * error_of_rule(1);
}

/* Whether the profile has a joint inside a panel. */
static bool has_joint(const po_scene *scene, const panel *p) {
  return po_profile_next_joint(&scene->profile, p->begin + p->size * AT_END) <
         p->begin + p->size * (1.0 - AT_END);
}

/* The integrals over a panel by a finer rule. Half a panel that has a kink or several waves inside
 * would have as large an error as the whole, and their difference may vanish by chance. */
static integrals finer_integrals(const po_scene *scene, const panel *p) {
  const bool is_wavy = p->size > 2.0 * po_initial_gap_detail(scene);
  return is_wavy || has_joint(scene, p) ? by_pieces(scene, p) : by_halves(scene, p);
}

/* Where the slope of the profile jumps, that of the traction jumps by the response dp/dH times as
 * much, s. So the deflection has a part -(1/pi) coupling s x^2 ln |x| at the distance x from a
 * kink, and -(1/2) coupling s r^2 ln r at a tip. The integrand of the energy has p/2 of it. Given:
 * a panel, and whether it has the kink at its beginning or at its end. */
static double of_corner(const po_scene *scene, const panel *p, bool at_end, double jump) {
  const size_t nearest = at_end ? PO_TABLE_ORDER - 1 : 0;
  const double at = at_end ? p->begin + p->size : p->begin;
  const double gap = po_initial_gap(scene, at) + p->deflection[nearest];
  const double s = po_law_at(&scene->law, gap).slope * jump;
  const double part =
      0.5 * fabs(p->traction[nearest] * s) * po_scene_coupling(scene) * p->size * p->size * p->size;
  return at > 0.0 ? part / M_PI * at * error_of_rule(2) : part / 2.0 * p->size * error_of_rule(3);
}

/* That of both ends of a panel. */
static double of_corners(const po_scene *scene, const panel *p) {
  const po_profile *profile = &scene->profile;
  const double kink = po_profile_shape(profile).kink, end = p->begin + p->size;
  double sum = 0.0;
  if (p->begin == 0.0)
    sum += of_corner(scene, p, false, po_initial_gap_slope(scene, 0.0));
  for (int at_end = 0; at_end < 2; ++at_end)
    if (fabs(kink - (at_end ? end : p->begin)) < AT_END * p->size)
      sum += of_corner(scene, p, at_end, po_profile_slope_jump(profile, scene->radius));
  return sum;
}

/* U is stationary for the solution, so that the energy of the interpolated solution, integrated on
 * panels that are halved, differs from the true one in the second order. The energy on the mesh
 * differs from it by the integral of phi, because the traction of the mesh is a polynomial on each
 * panel and is integrated exactly against the deflection; and by the energy of the tractions e that
 * these polynomials lack. They change sign about as often as a panel has nodes n, so that they
 * deflect the surface by about coupling e size / n. The moduli of the panels are added: their
 * errors may cancel by chance. */
po_point_error po_panel_errors(const po_scene *scene, const po_solution *p) {
  const double coupling = po_scene_coupling(scene);
  double change = 0.0, lacking = 0.0, load = 0.0;
  panel here = panel_of(scene, p, 0);
  for (size_t k = 0; k < p->panels->count; ++k) {
    const bool is_last = k + 1 == p->panels->count;
    const panel next = is_last ? (panel){0} : panel_of(scene, p, k + 1);
    const integrals finer = finer_integrals(scene, &here);
    const integrals nodes = by_nodes(scene, &here);
    change += fabs(finer.energy - nodes.energy);
    load += fabs(finer.load - nodes.load);
    lacking += coupling * here.size / PO_TABLE_ORDER * finer.squares;
    lacking += of_corners(scene, &here);
    if (!is_last || isfinite(scene->outer_radius))
      lacking += of_border(scene, &here, &next);
    here = next;
  }
  const double factor = PO_SAFETY * 2.0 / scene->radius;
  return (po_point_error){factor * (change + lacking), factor * load};
}

/* By how much the surface gives way to what a panel misses between its nodes. Where the surfaces
 * are pressed together the gap is nearly fixed, so that the deflection follows the joint and the
 * traction changes by far less than at a deflection that does not. */
static double giving_way(const po_scene *scene, const panel *p) {
  double response = 0.0;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    response = fmax(response, fabs(p->response[j]));
  return 1.0 + response * po_scene_coupling(scene) * p->size / (PO_TABLE_ORDER * PO_TABLE_ORDER);
}

po_joint_errors po_joint_errors_of(const po_scene *scene, const po_branch_point *point) {
  const po_solution *const p = point->best;
  po_joint_errors sum = {0};
  if (!p)
    return sum;
  double rate = 0.0;
  for (size_t k = 0; k < p->panels->count; ++k) {
    const panel here = panel_of(scene, p, k);
    if (!has_joint(scene, &here))
      continue;
    const integrals finer = by_pieces(scene, &here), nodes = by_nodes(scene, &here);
    const double given = giving_way(scene, &here);
    const double missed = fabs(finer.load - nodes.load) / given;
    sum.load += PO_SAFETY * 2.0 / scene->radius * missed;
    sum.energy += PO_SAFETY * 2.0 / scene->radius * fabs(finer.energy - nodes.energy);
    sum.gap += po_scene_coupling(scene) * missed / (here.begin + here.size);
    rate += 2.0 / scene->radius * fabs(finer.rate - nodes.rate) / given;
  }
  sum.approach = sum.gap;
  if (point->kind == PO_POINT_LOAD_MIN || point->kind == PO_POINT_LOAD_MAX)
    sum.approach += PO_SAFETY * fabs(rate / point->turn * p->tangent[p->n]);
  return sum;
}
