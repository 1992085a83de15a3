#include "po_panel.h"

#include <math.h>

#include "po_elementary.h"
#include "po_kernel.h"

po_status po_panel_rule_fill(size_t order, po_panel_rule *rule) {
  rule->order = order;
  po_status status = po_gauss_rule(order, rule->node, rule->weight);
  if (!status)
    status = po_near_tables_fill(&rule->near);
  if (!status)
    po_barycentric_weights(order, rule->node, rule->barycentric);
  return status;
}

static double cube(double x) {
  return x * x * x;
}

/* That of the law of the paper, whose powers are computed by multiplication; and the least. */
static const double USUAL_DECAY = 6.0, LEAST_DECAY = 3.0;

double po_panel_decay(const po_scene *scene) {
  const double decay = po_scene_decay(scene);
  /* slower decays are refused but for rounding, as in a table of a cone: the traction times r ds
   * would not be finite at infinity */
  return isinf(decay) ? USUAL_DECAY : fmax(LEAST_DECAY, decay);
}

double po_panel_energy_decay(const po_scene *scene) {
  const bool falls = isfinite(po_scene_decay(scene));
  return falls && !po_scene_has_infinite_energy(scene)
             ? po_panel_decay(scene) - po_profile_shape(&scene->profile).growth
             : po_panel_decay(scene);
}

/* x^(decay - 3), and x^decay */
static double reduced_power(double decay, double x) {
  return decay == USUAL_DECAY ? cube(x) : po_pow(x, decay - 3.0);
}
static double power(double decay, double x) {
  return decay == USUAL_DECAY ? cube(x * x) : po_pow(x, decay);
}

/* The integral of x^exponent times the polynomial of degree order - 1 that is 1 at the node x of a
 * rule and 0 at the others, over the weight of the node. Gauss's rule takes it as x^exponent, which
 * is exact for whole exponents only. The integral of x^e times the Legendre polynomial P_k of the
 * unit interval is e (e - 1) ... (e - k + 1) / ((e + 1) ... (e + k + 1)). */
static double product_of_power(size_t order, double exponent, double x) {
  const double y = 2.0 * x - 1.0;
  double before = 0.0, now = 1.0, moment = 1.0 / (exponent + 1.0), sum = 0.0;
  for (size_t degree = 0; degree < order; ++degree) {
    const double k = (double)degree;
    sum += (2.0 * k + 1.0) * moment * now;
    const double next = ((2.0 * k + 1.0) * y * now - k * before) / (k + 1.0);
    before = now;
    now = next;
    moment *= (exponent - k) / (exponent + k + 2.0);
  }
  return sum;
}

void po_panel_nodes(const po_panel_rule *rule, po_panel_span panel, double *node, double *weight,
                    double *length) {
  const double begin = panel.begin, span = panel.end - panel.begin;
  for (size_t j = 0; j < rule->order; ++j) {
    const double x = rule->node[j], w = rule->weight[j];
    if (isinf(panel.end)) {
      node[j] = begin / x;
      length[j] = w * begin / (x * x);
      weight[j] = w * begin * begin / cube(x); /* Gauss is exact: degree order - 1 + 3 */
      if (panel.decay != round(panel.decay))
        weight[j] = w * begin * begin * product_of_power(rule->order, panel.decay - 3.0, x) /
                    po_pow(x, panel.decay);
    } else {
      node[j] = begin + span * x;
      length[j] = w * span;
      weight[j] = w * span * node[j];
    }
  }
}

/* Returned: the variable x of the panel, 0 to 1 on it, at radius r. */
static double variable_of(po_panel_span panel, double r) {
  if (isinf(panel.end))
    return r > 0.0 ? panel.begin / r : INFINITY;
  return (r - panel.begin) / (panel.end - panel.begin);
}

/* Returned: G(r, s) s ds/dx at a point of a near rule (on an infinite panel times x^decay). */
static double integrand(po_panel_span panel, double r, const po_near_point *point) {
  if (isinf(panel.end)) {
    const double x = point->x, s = panel.begin / x;
    /* r - s = s (x - x0) / x0 with x0 = begin / r */
    const double difference = s * point->offset * r / panel.begin;
    return po_kernel(r + s, difference) * panel.begin * panel.begin * reduced_power(panel.decay, x);
  }
  const double span = panel.end - panel.begin, s = panel.begin + span * point->x;
  return po_kernel(r + s, span * point->offset) * s * span;
}

uint64_t po_panel_influence(const po_panel_rule *rule, po_panel_span panel, double r, double *row,
                            size_t stride) {
  const size_t order = rule->order;
  const double x0 = variable_of(panel, r);
  double value[PO_PANEL_MAX_ORDER];
  if (r == 0.0 || po_near_is_far(x0, order)) { /* on the axis G s = 2 for all s */
    double node[PO_PANEL_MAX_ORDER], weight[PO_PANEL_MAX_ORDER], length[PO_PANEL_MAX_ORDER];
    po_panel_nodes(rule, panel, node, weight, length);
    po_kernel_row(r, node, NULL, order, value);
    for (size_t j = 0; j < order; ++j)
      row[j * stride] = value[j] * weight[j];
    return order;
  }
  /* The other singularity of the kernel is at s = -r: in x it is twice as far from x0 as the axis
   * is. */
  const double mirror = isinf(panel.end) ? 2.0 * x0 : 2.0 * r / (panel.end - panel.begin);
  po_near_rule near = po_near_rule_begin(&rule->near, x0, mirror);
  po_near_point point[PO_NEAR_PIECE_POINTS];
  double sum[PO_PANEL_MAX_ORDER] = {0.0};
  uint64_t evaluations = 0;
  for (size_t count; (count = po_near_rule_next(&near, point)) > 0; evaluations += count)
    for (size_t q = 0; q < count; ++q) {
      const double factor = point[q].weight * integrand(panel, r, &point[q]);
      po_lagrange(order, rule->node, rule->barycentric, point[q].x, value);
      for (size_t j = 0; j < order; ++j)
        sum[j] += factor * value[j];
    }
  for (size_t j = 0; j < order; ++j)
    row[j * stride] = isinf(panel.end) ? sum[j] / power(panel.decay, rule->node[j]) : sum[j];
  return evaluations;
}
