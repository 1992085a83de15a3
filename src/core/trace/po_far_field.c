#include "po_far_field.h"

#include <math.h>

#include "po_elementary.h"
#include "po_far_energy.h"
#include "po_initial_gap.h"
#include "po_linear.h"
#include "po_margins.h"
#include "po_panel_table.h"
#include "po_rigid.h"
#include "po_scales.h"
#include "po_trace.h"

/* -- The panel to infinity -- */

/* The law averaged over the waves beyond a domain, and the polynomial in domain/r that stands for
 * it there. The deflection is interpolated as a part of the initial gap, which it is not known
 * better than. */
typedef struct {
  const po_scene *scene;
  double domain, decay, approach;
  double ratio[PO_TABLE_ORDER];  /* deflection over initial gap, at the nodes */
  double factor[PO_TABLE_ORDER]; /* traction there over (domain/r)^decay */
} far_panel;

/* Given: the initial gap and the deflection at r. */
static double traction_of(const far_panel *f, double r, double ratio) {
  const double gap = po_initial_gap_mean(f->scene, r) * (1.0 + ratio) - f->approach;
  return po_law_averaged(&f->scene->law, gap, po_initial_gap_amplitude(f->scene)).traction;
}

/* The traction at r less that of the polynomial. */
static double missed_at(const far_panel *f, double r) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double t = f->domain / r;
  double lagrange[PO_TABLE_ORDER];
  po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, t, lagrange);
  const double by_nodes = po_pow(t, f->decay) * po_linear_dot(PO_TABLE_ORDER, lagrange, f->factor);
  return traction_of(f, r, po_linear_dot(PO_TABLE_ORDER, lagrange, f->ratio)) - by_nodes;
}

/* Where the gap is so large that nothing acts. */
static bool is_apart(const po_scene *scene, double r) {
  return po_profile_gap(&scene->profile, scene->radius, r) >= PO_PROFILE_FARTHEST;
}

/* The pieces of the integral of the error: up to the next row of a table, or until the gap has
 * changed by PART_OF_LAW of the length of the law, or the radius by PART_OF_RADIUS. They end at the
 * last row, but not before FARTHEST times the domain: what is beyond has no weight in the
 * polynomial either. */
static const double PART_OF_LAW = 0.25, PART_OF_RADIUS = 0.2, FARTHEST = 100.0;

/* Gauss's rule with two points on (0, 1): the error is needed to some percent. */
static const double RULE[] = {0.21132486540518713, 0.78867513459481287};

static double piece_end(const po_scene *scene, double r) {
  const double slope = fabs(po_profile_slope(&scene->profile, scene->radius, r));
  const double gap = po_profile_gap(&scene->profile, scene->radius, r);
  const double length = PART_OF_LAW * po_law_size(&scene->law, gap) / slope;
  return fmin(po_profile_next_joint(&scene->profile, r),
              r + fmin(length, PART_OF_RADIUS * r)); /* a length of infinity is no limit */
}

/* -- The error of a solution -- */

/* Factor of the leading term of the error of the average. */
static const double LEADING = 2.0;

/* Part of the load of the last Legendre coefficients taken for the error of the polynomial. */
static const double OF_LAST = 0.1;

/* A radius, eps, and H of the mean surface there. */
typedef struct {
  double r, gap;
} po_far_place;

/* What is integrated over the far field. */
typedef enum { OF_TRACTION, OF_ENERGY } far_integrand;

/* Its value below the crests less that below the troughs of a wave. Given: H of the mean surface.
 */
static double difference(const po_scene *scene, far_integrand of, po_wave wave, double gap) {
  const po_law *law = &scene->law;
  const double crest = gap - wave.amplitude, trough = gap + wave.amplitude;
  return of == OF_ENERGY ? po_law_energy(law, crest) - po_law_energy(law, trough)
                         : po_law_at(law, crest).traction - po_law_at(law, trough).traction;
}

/* Half of that, times the radius: the part of the integrand that oscillates. Of an energy that is
 * relative to that of the initial gap, less its part. */
static double oscillation(const po_scene *scene, far_integrand of, po_wave wave, po_far_place at) {
  const bool relative = of == OF_ENERGY && po_scene_has_infinite_energy(scene);
  const double zero =
      relative ? difference(scene, of, wave, po_initial_gap_mean(scene, at.r)) : 0.0;
  return 0.5 * fabs(difference(scene, of, wave, at.gap) - zero) * at.r;
}

/* The error of the average over the waves, by parts: lambda/2 pi times the oscillating part of the
 * integrand at the end of the domain, with the sine of its phase, which is 0 for the main wave
 * (po_averaging_phase); and (lambda/2 pi)^2 times its slope. Given: the end, and two places beyond
 * it. */
static double error_of_average(const po_scene *scene, far_integrand of, double end,
                               po_far_place near, po_far_place far) {
  double error = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double here = oscillation(scene, of, wave, near);
    const double there = oscillation(scene, of, wave, far);
    const double decay = po_log(here / there) / po_log(far.r / near.r),
                 per_2pi = wave.length / (2.0 * M_PI);
    const double begin = here * po_pow(near.r / end, decay);
    if (here > 0.0 && there > 0.0)
      error +=
          begin * per_2pi * (fabs(po_sinpi(2.0 * (end / wave.length))) + per_2pi * decay / end);
  }
  return LEADING * 2.0 / scene->radius * error;
}

/* The error of the polynomial of the panel to infinity, from its last Legendre coefficients. */
static double error_of_polynomial(const po_scene *scene, const po_solution *p) {
  const po_panel_table *table = po_panel_table_get();
  const double decay = po_panel_decay(scene);
  double last = 0.0;
  for (int k = PO_TABLE_ORDER - 3; k < PO_TABLE_ORDER; ++k) {
    double sum = 0.0;
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const size_t at = p->n - PO_TABLE_ORDER + j;
      const double traction =
          po_law_averaged(&scene->law, p->state[at], po_initial_gap_amplitude(scene)).traction;
      sum += table->legendre.coefficient[k][j] * traction / po_pow(table->rule.node[j], decay);
    }
    last = fmax(last, fabs(sum));
  }
  return OF_LAST * 2.0 / scene->radius * p->domain * p->domain * last / (decay - 2.0);
}

/* The load that the polynomial lacks if the profile has joints beyond the domain, which its
 * coefficients do not show. */
static double missed_by_joints(const po_scene *scene, const po_solution *p) {
  const double *node = po_panel_table_get()->rule.node;
  const size_t first = p->n - PO_TABLE_ORDER;
  far_panel f = {.scene = scene,
                 .domain = p->domain,
                 .decay = po_panel_decay(scene),
                 .approach = po_solution_approach(p)};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    f.ratio[j] =
        (p->deflection[first + j] + f.approach) / po_initial_gap_mean(scene, p->domain / node[j]);
    f.factor[j] = traction_of(&f, p->domain / node[j], f.ratio[j]) / po_pow(node[j], f.decay);
  }
  double sum = 0.0;
  for (double r = p->domain, to;
       isfinite(po_profile_next_joint(&scene->profile, r)) && !is_apart(scene, r); r = to) {
    to = fmax(piece_end(scene, r), PO_SHORTEST_PIECE * r);
    for (int k = 0; k < 2; ++k) {
      const double at = r + (to - r) * RULE[k];
      sum += missed_at(&f, at) * at * 0.5 * (to - r);
    }
  }
  return PO_SAFETY * 2.0 / scene->radius * fabs(sum);
}

/* The error of the energy of the interaction on the panel to infinity: its difference from
 * po_far_energy, where that is not used. */
static double error_of_far_energy(const po_scene *scene, const po_solution *p) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double amplitude = po_initial_gap_amplitude(scene);
  const double *node = p->node + p->n - PO_TABLE_ORDER, *gap = p->state + p->n - PO_TABLE_ORDER;
  if (po_far_energy_is_apart(scene) || isinf(po_law_numbers_of(&scene->law)->exponent))
    return 0.0;
  double place[PO_TABLE_ORDER], weight[PO_TABLE_ORDER], length[PO_TABLE_ORDER], sum = 0.0;
  po_panel_nodes(rule, (po_panel_span){p->domain, INFINITY, po_panel_decay(scene)}, place, weight,
                 length);
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double initial = po_initial_gap_mean(scene, node[j]);
    const double zero = po_scene_has_infinite_energy(scene)
                            ? po_law_energy_averaged(&scene->law, initial, amplitude)
                            : 0.0;
    sum += weight[j] * (po_law_energy_averaged(&scene->law, gap[j], amplitude) - zero);
  }
  const double exact =
      po_far_energy(scene, p->domain, PO_TABLE_ORDER, node, gap, po_solution_approach(p));
  return 2.0 / scene->radius * fabs(sum - exact);
}

po_far_field po_far_field_of(const po_scene *scene, const po_solution *p) {
  if (isfinite(scene->outer_radius))
    return (po_far_field){0.0, 0.0, 0.0};
  /* the nodes of the panel to infinity follow those of the domain, the nearest last */
  const po_far_place near = {p->node[p->n - 1], p->state[p->n - 1]};
  const po_far_place far = {p->node[p->n - 2], p->state[p->n - 2]};
  const double load = error_of_average(scene, OF_TRACTION, p->domain, near, far) +
                      fmax(error_of_polynomial(scene, p), missed_by_joints(scene, p));
  /* as much as a ring of that load at the end of the domain deflects the axis */
  const double approach = po_scene_coupling(scene) * scene->radius * load / p->domain;
  const double energy =
      error_of_average(scene, OF_ENERGY, p->domain, near, far) + error_of_far_energy(scene, p);
  return (po_far_field){load, approach, energy};
}

double po_far_field_rigid_energy(const po_scene *scene, double approach) {
  if (isfinite(scene->outer_radius) || !po_scene_is_wavy(scene))
    return 0.0;
  const double end = po_rigid_end(scene, approach, po_scene_has_infinite_energy(scene));
  const po_far_place near = {end, po_initial_gap_mean(scene, end) - approach};
  const po_far_place far = {PO_NEXT_RADIUS * end,
                            po_initial_gap_mean(scene, PO_NEXT_RADIUS * end) - approach};
  return error_of_average(scene, OF_ENERGY, end, near, far);
}

/* -- How far the panels reach -- */

/* The load of the difference between the traction of rigid bodies beyond a domain and the
 * polynomial through its values at the nodes, by moduli, pi w R. Given: domain, eps; most: a sum
 * above it is not continued. The bodies are nearer by the gap of the greatest usual contact: the
 * deflection is smooth there. */
static double error_of_initial_gap(const po_scene *scene, double domain, double most) {
  far_panel f = {.scene = scene,
                 .domain = domain,
                 .decay = po_panel_decay(scene),
                 .approach = po_scene_scales(scene).contact_gap};
  const double *node = po_panel_table_get()->rule.node;
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    f.factor[j] = traction_of(&f, domain / node[j], 0.0) / po_pow(node[j], f.decay);
  const double rows = po_profile_shape(&scene->profile).end;
  const double end = fmax(FARTHEST * domain, isfinite(rows) ? rows : 0.0);
  double sum = 0.0;
  for (double r = domain, to; r < end && !(sum > most) && !is_apart(scene, r); r = to) {
    to = piece_end(scene, r);
    for (int k = 0; k < 2; ++k) {
      const double at = r + (to - r) * RULE[k];
      sum += 2.0 / scene->radius * fabs(missed_at(&f, at)) * at * 0.5 * (to - r);
    }
  }
  return sum;
}

/* Factor between the cores that are tried, up to MOST times the first, or the last row. */
static const double LARGER = 1.25, MOST = 16.0;

double po_far_field_core(const po_scene *scene, double core, double tolerance) {
  if (isfinite(scene->outer_radius) || isinf(po_law_numbers_of(&scene->law)->exponent))
    return core;
  const double allowed = PO_PART_OF_TOLERANCE * tolerance * po_scene_scales(scene).load;
  const double rows = po_profile_shape(&scene->profile).end;
  const double most = fmax(MOST * core, isfinite(rows) ? LARGER * rows : 0.0);
  for (double c = core; c < most; c *= LARGER)
    if (!(error_of_initial_gap(scene, po_trace_domain(scene, c), allowed) > allowed))
      return c;
  return core;
}
