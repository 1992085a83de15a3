#include "po_far_field.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_resolution.h"

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
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double decay = po_panel_decay(scene);
  po_legendre legendre;
  po_legendre_fill(rule, &legendre);
  double last = 0.0;
  for (int k = PO_TABLE_ORDER - 3; k < PO_TABLE_ORDER; ++k) {
    double sum = 0.0;
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const double gap = p->state[p->n - PO_TABLE_ORDER + j];
      const double traction =
          po_law_averaged(&scene->law, gap, po_initial_gap_amplitude(scene)).traction;
      sum += legendre.coefficient[k][j] * traction / po_pow(rule->node[j], decay);
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
