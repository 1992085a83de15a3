#include "po_energy_error.h"

#include <math.h>

#include "po_elementary.h"
#include "po_far_field.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_quadrature.h"
#include "po_solution.h"

/* Factor of the estimate on panels. */
static const double OF_CHANGE = 3.0;

/* Error of the energy of a rigid scene, see po_rigid_energy. */
static const double RIGID = 1e-10;

/* A panel of a solution: its radii, eps, and the values at its nodes. */
typedef struct {
  double begin, size;
  double deflection[PO_TABLE_ORDER]; /* H - f */
  double traction[PO_TABLE_ORDER];
} panel;

static panel panel_of(const po_scene *scene, double domain, const po_solution *p, size_t k) {
  const po_panel place = p->panels->panel[k];
  panel here = {.begin = domain * po_panel_begin(place), .size = domain * po_panel_size(place)};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    here.deflection[j] = p->deflection[k * PO_TABLE_ORDER + j];
    here.traction[j] = po_law_at(&scene->law, p->state[k * PO_TABLE_ORDER + j]).traction;
  }
  return here;
}

/* Integrals over a panel, of r dr. */
typedef struct {
  double energy;  /* of phi(H) */
  double squares; /* of the square of the traction's difference from its polynomial */
} integrals;

/* The nodes of both halves of a panel on (0, 1), and the weights with which the values at the nodes
 * of the panel are interpolated to each. */
typedef struct {
  double place[2 * PO_TABLE_ORDER], weight[2 * PO_TABLE_ORDER],
      lagrange[2 * PO_TABLE_ORDER][PO_TABLE_ORDER];
} halves;

static void fill_halves(halves *h) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const size_t j = i % PO_TABLE_ORDER;
    h->place[i] = 0.5 * (rule->node[j] + (i < PO_TABLE_ORDER ? 0.0 : 1.0));
    h->weight[i] = 0.5 * rule->weight[j];
    po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, h->place[i], h->lagrange[i]);
  }
}

/* The integrals over a panel by Gauss's rule on its halves. */
static integrals by_halves(const po_scene *scene, const panel *p, const halves *h) {
  integrals sum = {0};
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const double r = p->begin + p->size * h->place[i], weight = p->size * h->weight[i] * r;
    const double gap =
        po_initial_gap(scene, r) + po_linear_dot(PO_TABLE_ORDER, p->deflection, h->lagrange[i]);
    const double off = po_law_at(&scene->law, gap).traction -
                       po_linear_dot(PO_TABLE_ORDER, p->traction, h->lagrange[i]);
    sum.energy += weight * po_law_energy(&scene->law, gap);
    sum.squares += weight * off * off;
  }
  return sum;
}

/* The integral of phi(H) r dr by the nodes of a panel. */
static double energy_by_nodes(const po_scene *scene, const panel *p) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  double sum = 0.0;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double r = p->begin + p->size * rule->node[j];
    sum += rule->weight[j] * r *
           po_law_energy(&scene->law, po_initial_gap(scene, r) + p->deflection[j]);
  }
  return p->size * sum;
}

/* The error of Gauss's rule for x ln x on (0, 1). */
static double error_of_rule(void) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  double sum = 0.25;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    sum += rule->weight[j] * rule->node[j] * po_log(rule->node[j]);
  return fabs(sum);
}

/* On a cut surface the traction p ends with a jump. So the deflection has a part -(2/pi) coupling p
 * x ln x at the distance x from the end, and the integrand phi + p u/2 of the energy has -p/2 of
 * it. Given: the last panel. */
static double of_end(const po_scene *scene, const panel *last) {
  const double p = last->traction[PO_TABLE_ORDER - 1], end = last->begin + last->size;
  return po_scene_coupling(scene) / M_PI * p * p * last->size * last->size * end * error_of_rule();
}

/* U is stationary for the solution, so that the energy of the interpolated solution, integrated on
 * panels that are halved, differs from the true one in the second order. The energy on the mesh
 * differs from it by the integral of phi, because the traction of the mesh is a polynomial on each
 * panel and is integrated exactly against the deflection; and by the energy of the tractions e that
 * these polynomials lack. They change sign about as often as a panel has nodes n, so that they
 * deflect the surface by about coupling e size / n. The moduli of the panels are added: their
 * errors may cancel by chance. */
static double of_panels(const po_scene *scene, double domain, const po_solution *p) {
  const double coupling = po_scene_coupling(scene);
  double change = 0.0, lacking = 0.0;
  halves h;
  fill_halves(&h);
  for (size_t k = 0; k < p->panels->count; ++k) {
    const panel here = panel_of(scene, domain, p, k);
    const integrals finer = by_halves(scene, &here, &h);
    change += fabs(finer.energy - energy_by_nodes(scene, &here));
    lacking += coupling * here.size / PO_TABLE_ORDER * finer.squares;
    if (k + 1 == p->panels->count && isfinite(scene->outer_radius))
      lacking += of_end(scene, &here);
  }
  return OF_CHANGE * 2.0 / scene->radius * (change + lacking);
}

double po_energy_error(const po_scene *scene, double domain, double precision,
                       const po_branch_point *p) {
  if (!p->gap)
    return RIGID * fmax(1.0, fabs(p->energy));
  if (!p->solution)
    return NAN;
  return of_panels(scene, domain, p->solution) + precision * (1.0 + fabs(p->load)) +
         po_far_field_error(scene, domain, p->solution).load * (1.0 + fabs(p->approach));
}
