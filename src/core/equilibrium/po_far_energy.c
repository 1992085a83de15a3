#include "po_far_energy.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_panel.h"
#include "po_panel_table.h"
#include "po_profile.h"

/* Gauss's rule on the panel to infinity is exact for a power of x = begin/r and the polynomials of
 * the panel up to the degree 2 PO_TABLE_ORDER - 1. */
static const double HIGHEST_WHOLE_DECAY = PO_TABLE_ORDER + 3;

bool po_far_energy_is_apart(const po_scene *scene) {
  const double decay = po_panel_energy_decay(scene), of_traction = po_panel_decay(scene);
  const bool whole = decay == round(decay) && of_traction == round(of_traction);
  return isfinite(po_law_numbers_of(&scene->law)->exponent) &&
         !(whole && decay <= HIGHEST_WHOLE_DECAY);
}

/* The panel to infinity. Its deflection u is interpolated as u over the initial gap f, a polynomial
 * in x: u = H + approach - f is not known better than f is rounded, and f is large far out. */
typedef struct {
  const po_scene *scene;
  double begin, approach, amplitude;
  bool relative;
  size_t nodes;
  double x[PO_PANEL_MAX_ORDER], barycentric[PO_PANEL_MAX_ORDER], ratio[PO_PANEL_MAX_ORDER];
} far_panel;

static far_panel far_panel_of(const po_scene *scene, double begin, size_t nodes, const double *node,
                              const double *gap, double approach) {
  far_panel p = {.scene = scene,
                 .begin = begin,
                 .approach = approach,
                 .amplitude = po_initial_gap_amplitude(scene),
                 .relative = po_scene_has_infinite_energy(scene),
                 .nodes = nodes};
  for (size_t j = 0; j < nodes; ++j) {
    const double initial = po_initial_gap_mean(scene, node[j]);
    p.x[j] = begin / node[j];
    p.ratio[j] = (gap[j] + approach - initial) / initial;
  }
  po_barycentric_weights(nodes, p.x, p.barycentric);
  return p;
}

/* phi at a radius r, where x = begin/r. */
static double interaction(const far_panel *p, double x, double r) {
  double weight[PO_PANEL_MAX_ORDER], ratio = 0.0;
  po_lagrange(p->nodes, p->x, p->barycentric, x, weight);
  for (size_t j = 0; j < p->nodes; ++j)
    ratio += weight[j] * p->ratio[j];
  const po_law *law = &p->scene->law;
  const double initial = po_initial_gap_mean(p->scene, r);
  const double zero = p->relative ? po_law_energy_averaged(law, initial, p->amplitude) : 0.0;
  return po_law_energy_averaged(law, initial - p->approach + ratio * initial, p->amplitude) - zero;
}

/* Where phi has its leading power to any precision, beyond which r^2 would overflow. */
static const double FARTHEST = 1e-30;

/* Each part of the range of t below begins at a quarter of its end, and the last is the rest, 4^-13
 * of the whole. Gauss's rule is accurate to 1e-10 of such a part; with an eighth it was 1e-9 where
 * the approach exceeds the initial gap. If t changes more slowly than x, the first parts are those
 * in which x falls to a quarter. */
enum { PARTS = 14, PARTS_OF_X = 18 };
static const double SHRINKAGE = 0.25;

/* phi falls as x^e with e > 2, x = begin/r. With t = x^(e - 2) the integral is that of phi r^2/((e
 * - 2) t) over t from 0 to 1, whose integrand is finite. It is not smooth at 0, and the parts
 * become smaller there. */
static double to_infinity(const far_panel *p, double begin) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double power = po_panel_energy_decay(p->scene) - 2.0;
  const int of_x = power < 1.0 ? PARTS_OF_X : 0, parts = of_x + PARTS;
  const double slow = po_pow(SHRINKAGE, power);
  double sum = 0.0, end = 1.0;
  for (int part = 0; part < parts; ++part) {
    const double from = part + 1 == parts ? 0.0 : end * (part < of_x ? slow : SHRINKAGE);
    for (size_t j = 0; j < rule->order; ++j) {
      const double t = from + (end - from) * rule->node[j];
      const double x = fmax(FARTHEST, po_pow(t, 1.0 / power)), r = begin / x;
      sum += (end - from) * rule->weight[j] * interaction(p, p->begin / begin * x, r) * r * r /
             (power * po_pow(x, power));
    }
    end = from;
  }
  return sum;
}

double po_far_energy(const po_scene *scene, double begin, size_t nodes, const double *node,
                     const double *gap, double approach) {
  const far_panel p = far_panel_of(scene, begin, nodes, node, gap, approach);
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  double sum = 0.0, from = begin, to;
  while (isfinite(to = po_profile_next_joint(&scene->profile, from))) {
    to = fmax(to, PO_SHORTEST_PIECE * from);
    for (size_t j = 0; j < rule->order; ++j) {
      const double r = from + (to - from) * rule->node[j];
      sum += (to - from) * rule->weight[j] * interaction(&p, begin / r, r) * r;
    }
    from = to;
  }
  return sum + to_infinity(&p, from);
}
