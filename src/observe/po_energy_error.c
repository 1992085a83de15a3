#include "po_energy_error.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_profile.h"
#include "po_quadrature.h"
#include "po_resolution.h"
#include "po_solution.h"

/* Factor of the estimate on panels. */
static const double OF_CHANGE = 3.0;

/* Error of the energy of a rigid scene, see po_rigid_energy. */
static const double RIGID = 1e-10;

/* Distance of a kink from the end of a panel, relative to its length, within which it is there. */
static const double AT_END = 1e-9;

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

/* The nodes of two parts of a panel on (0, 1), and the weights with which the values at the nodes
 * of the panel are interpolated to each. */
typedef struct {
  double place[2 * PO_TABLE_ORDER], weight[2 * PO_TABLE_ORDER],
      lagrange[2 * PO_TABLE_ORDER][PO_TABLE_ORDER];
} parts;

/* Given: where the parts meet. */
static void fill_parts(double middle, parts *h) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const size_t j = i % PO_TABLE_ORDER;
    const double begin = i < PO_TABLE_ORDER ? 0.0 : middle;
    const double length = i < PO_TABLE_ORDER ? middle : 1.0 - middle;
    h->place[i] = begin + length * rule->node[j];
    h->weight[i] = length * rule->weight[j];
    po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, h->place[i], h->lagrange[i]);
  }
}

/* The integrals over a panel by Gauss's rule on its parts. */
static integrals by_parts(const po_scene *scene, const panel *p, const parts *h) {
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

/* On a cut surface the traction p ends with a jump. So the deflection has a part -(2/pi) coupling p
 * x ln x at the distance x from the end, and the integrand phi + p u/2 of the energy has -p/2 of
 * it. Given: the last panel. */
static double of_end(const po_scene *scene, const panel *last) {
  const double p = last->traction[PO_TABLE_ORDER - 1], end = last->begin + last->size;
  return po_scene_coupling(scene) / M_PI * p * p * last->size * last->size * end * error_of_rule(1);
}

/* The integrals over a panel by Gauss's rule on its halves, or on both sides of a kink of the
 * profile: half a panel that has the kink inside would have as large an error as the whole, and
 * their difference may vanish by chance. */
static integrals finer_integrals(const po_scene *scene, const panel *p, const parts *halves) {
  const po_profile *profile = &scene->profile;
  if (!po_profile_has_kink_between(profile, p->begin, p->begin + p->size))
    return by_parts(scene, p, halves);
  parts sides;
  fill_parts((po_profile_kink(profile) - p->begin) / p->size, &sides);
  return by_parts(scene, p, &sides);
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
  const double kink = po_profile_kink(profile), end = p->begin + p->size;
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
static double of_panels(const po_scene *scene, double domain, const po_solution *p) {
  const double coupling = po_scene_coupling(scene);
  double change = 0.0, lacking = 0.0;
  parts halves;
  fill_parts(0.5, &halves);
  for (size_t k = 0; k < p->panels->count; ++k) {
    const panel here = panel_of(scene, domain, p, k);
    const integrals finer = finer_integrals(scene, &here, &halves);
    change += fabs(finer.energy - energy_by_nodes(scene, &here));
    lacking += coupling * here.size / PO_TABLE_ORDER * finer.squares;
    lacking += of_corners(scene, &here);
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

/* The error of the far field of an unbounded surface: of the average over the waves beyond the
 * domain, and of the polynomial of the panel to infinity. A finer mesh does not show it. See
 * doc/method.md, "Errors". */

/* Factor of the leading term of the error of the average. In six scenes the term was from 0.93 to
 * 1.02 of the error. */
static const double LEADING = 2.0;

/* Part of the load of the last Legendre coefficients that is taken for the error of the polynomial.
 * With m = 2.2 the error was 0.01 of that load, with larger m less. */
static const double OF_LAST = 0.1;

/* The difference of the tractions below the crests and the troughs of a wave, times the radius: the
 * oscillating part of the integrand of Eq 17. Given: H of the mean surface. */
static double oscillation(const po_scene *scene, po_wave wave, double r, double gap) {
  const double crest = po_law_at(&scene->law, gap - wave.amplitude).traction;
  const double trough = po_law_at(&scene->law, gap + wave.amplitude).traction;
  return 0.5 * fabs(crest - trough) * r;
}

/* The error of the average over the waves, by parts: lambda/2 pi times the oscillating part of the
 * integrand at the end of the domain, with the sine of its phase, which is 0 for the main wave
 * (po_averaging_phase); and (lambda/2 pi)^2 times its slope. */
static double error_of_average(const po_scene *scene, double domain, const po_solution *p) {
  /* the nodes of the panel to infinity follow those of the domain, the nearest last */
  const double near = p->node[p->n - 1], far = p->node[p->n - 2];
  double error = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double here = oscillation(scene, wave, near, p->state[p->n - 1]);
    const double there = oscillation(scene, wave, far, p->state[p->n - 2]);
    const double decay = po_log(here / there) / po_log(far / near),
                 per_2pi = wave.length / (2.0 * M_PI);
    const double begin = here * po_pow(near / domain, decay);
    if (here > 0.0 && there > 0.0)
      error += begin * per_2pi *
               (fabs(po_sinpi(2.0 * (domain / wave.length))) + per_2pi * decay / domain);
  }
  return LEADING * 2.0 / scene->radius * error;
}

/* The error of the polynomial of the panel to infinity, from its last Legendre coefficients. */
static double error_of_polynomial(const po_scene *scene, double domain, const po_solution *p) {
  const po_panel_table *table = po_panel_table_get();
  const double decay = po_panel_decay(scene);
  double last = 0.0;
  for (int k = PO_TABLE_ORDER - 3; k < PO_TABLE_ORDER; ++k) {
    double sum = 0.0;
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const double gap = p->state[p->n - PO_TABLE_ORDER + j];
      const double traction =
          po_law_averaged(&scene->law, gap, po_initial_gap_amplitude(scene)).traction;
      sum += table->legendre.coefficient[k][j] * traction / po_pow(table->rule.node[j], decay);
    }
    last = fmax(last, fabs(sum));
  }
  return OF_LAST * 2.0 / scene->radius * domain * domain * last / (decay - 2.0);
}

po_far_field po_far_field_error(const po_scene *scene, double domain, const po_solution *p) {
  if (isfinite(scene->outer_radius))
    return (po_far_field){0.0, 0.0};
  const double load = error_of_average(scene, domain, p) + error_of_polynomial(scene, domain, p);
  /* as much as a ring of that load at the end of the domain deflects the axis */
  return (po_far_field){load, po_scene_coupling(scene) * scene->radius * load / domain};
}
