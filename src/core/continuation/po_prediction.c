#include "po_prediction.h"

#include <math.h>

#include "po_law.h"
#include "po_profile.h"
#include "po_special_point.h"

const double PO_SHORT_STEP = 1e-4;

/* Two predictions are compared at every so many nodes: at three a panel. */
enum { STRIDE = 4 };

/* Predicts the shifts of the contact edges. Returned: whether the coordinates can move by them. */
static bool move(po_prediction *p, double distance) {
  const po_moving_edges *edges = &p->edges;
  p->w = (po_hermite){1.0, distance, 0.0, 0.0};
  const double whole = p->paired ? po_solution_progress(p->a, p->b) : 0.0;
  p->cubic = p->paired && fabs(whole) > 0.0 && po_edge_may_relate(edges, p->back);
  if (p->cubic)
    p->w = po_hermite_at(distance, whole);
  for (size_t f = 0; f < edges->count; ++f) {
    p->shift[f] = p->w.d0 * edges->rate[f];
    if (p->cubic)
      p->shift[f] += p->w.f1 * p->back[f] + p->w.d1 * p->rate_back[f] / p->rate_b;
  }
  return po_edge_may_move(edges, p->shift);
}

/* Adds the kink of the profile, which does not move, to the contact edges that do: the gap has
 * features of the width of a contact edge there. */
static void hold_kink(po_prediction *p) {
  po_moving_edges *edges = &p->edges;
  if (!isfinite(p->kink) || edges->count == 0 || edges->count == PO_MOST_MOVING_EDGES)
    return;
  size_t k = edges->count++;
  for (; k > 0 && edges->at[k - 1] > p->kink; --k) {
    edges->at[k] = edges->at[k - 1];
    edges->rate[k] = edges->rate[k - 1];
    p->back[k] = p->back[k - 1];
    p->rate_back[k] = p->rate_back[k - 1];
  }
  edges->at[k] = p->kink;
  edges->rate[k] = p->back[k] = p->rate_back[k] = 0.0;
}

/* Begins a prediction: pairs the contact edges of a with those of b, if they are as many. */
static po_prediction begin(const po_equilibrium *e, const po_solution *a, const po_solution *b) {
  const po_scene *scene = e->scene;
  po_prediction p = {.a = a, .b = b, .of_a = {a, scene, 0}, .of_b = {b, scene, 0}};
  p.slope_jump = po_profile_slope_jump(&scene->profile, scene->radius);
  p.kink = p.slope_jump != 0.0 ? po_profile_shape(&scene->profile).kink : INFINITY;
  p.edges = a->edges;
  p.paired = b && b->edges.all == a->edges.all;
  if (p.paired)
    p.rate_b = po_solution_cosine(a, b);
  for (size_t f = 0; p.paired && f < a->edges.count; ++f) {
    p.back[f] = b->edges.at[f] - a->edges.at[f];
    p.rate_back[f] = b->edges.rate[f];
  }
  hold_kink(&p);
  return p;
}

/* Predicts at a distance, with all moving contact edges or none. */
static bool predict(po_prediction *p, double distance) {
  if (move(p, distance))
    return true;
  p->edges.count = 0;
  return move(p, distance);
}

bool po_prediction_make(const po_equilibrium *e, const po_solution *a, const po_solution *b,
                        double distance, po_prediction *p) {
  *p = begin(e, a, b);
  return predict(p, distance);
}

/* The largest difference of the gaps of two predictions, relative to 1 + H, at some nodes of a. */
static double difference(po_prediction *p, po_prediction *q) {
  double largest = 0.0;
  for (size_t j = 0; j < p->a->core; j += STRIDE) {
    const double r = p->a->node[j];
    const double of_p = po_prediction_gap(p, r), of_q = po_prediction_gap(q, r);
    largest = fmax(largest, fabs(of_p - of_q) / po_law_size(&p->of_a.scene->law, of_p));
  }
  return largest;
}

/* The error of a prediction is proportional to this function of the distance. */
static double error_power(const po_prediction *p, double distance) {
  if (!p->cubic)
    return distance * distance;
  const double product = distance * (distance - po_solution_progress(p->a, p->b));
  return product * product;
}

double po_prediction_reach(const po_equilibrium *e, const po_solution *a, const po_solution *b,
                           double distance, double error, po_prediction *p) {
  po_prediction moving = begin(e, a, b);
  double near = distance;
  for (; !move(&moving, near); near *= 0.5) {
    if (fabs(near) < PO_SHORT_STEP && po_prediction_make(e, a, b, near, p))
      return near;
    if (fabs(near) < PO_LOCATED)
      return 0.0;
  }
  for (double far = distance; fabs(far) > 1.5 * fabs(near); far *= 0.5) {
    if (!po_prediction_make(e, a, b, far, p))
      continue;
    po_prediction still = *p;
    move(&still, near);
    const double growth = error_power(p, far) / error_power(p, near);
    if (growth * difference(&moving, &still) < error)
      return far;
  }
  *p = moving;
  move(p, near);
  return near;
}

/* The part of the initial gap that has the kink of the profile. */
static double kink_gap(const po_prediction *p, double r) {
  return r > p->kink ? p->slope_jump * (r - p->kink) : 0.0;
}

/* A solution at a radius without that part. */
static po_solution_value smooth_value(const po_prediction *p, po_solution_field *of, double r) {
  po_solution_value v = po_solution_value_at(of, r);
  if (r > p->kink) {
    v.gap -= kink_gap(p, r);
    v.slope -= p->slope_jump;
  }
  return v;
}

/* The place that moves to a radius. */
static po_edge_place origin_of(po_prediction *p, double r) {
  const po_edge_place origin = po_edge_origin(&p->edges, p->shift, r, p->edge);
  p->edge = origin.outer;
  return origin;
}

double po_prediction_gap(void *prediction, double r) {
  po_prediction *p = prediction;
  const po_moving_edges *edges = &p->edges;
  const po_edge_place origin = origin_of(p, r);
  const po_solution_value a = smooth_value(p, &p->of_a, origin.r);
  const double velocity = po_edge_displacement(&origin, edges->rate);
  double gap = a.gap + kink_gap(p, r) + p->w.d0 * (a.tangent + a.slope * velocity);
  if (p->cubic) {
    const double at = origin.r + po_edge_displacement(&origin, p->back);
    const po_solution_value b = smooth_value(p, &p->of_b, at);
    const double velocity_b = po_edge_displacement(&origin, p->rate_back);
    gap += p->w.f1 * (b.gap - a.gap) + p->w.d1 * (b.tangent + b.slope * velocity_b) / p->rate_b;
  }
  return po_law_expected_gap(&p->of_a.scene->law, gap);
}

/* The predicted gap at a node that does not move, or the predicted approach. */
static double component(const po_prediction *p, size_t of_a, size_t of_b) {
  double value = p->a->state[of_a] + p->w.d0 * p->a->tangent[of_a];
  if (p->cubic)
    value += p->w.f1 * (p->b->state[of_b] - p->a->state[of_a]) +
             p->w.d1 * p->b->tangent[of_b] / p->rate_b;
  return value;
}

void po_prediction_state(po_prediction *p, const po_surface *surface, size_t moving,
                         double *state) {
  const size_t n = surface->n;
  for (size_t j = 0; j < moving; ++j)
    state[j] = po_prediction_gap(p, surface->node[j]);
  for (size_t back = 0; back <= n - moving; ++back) { /* from the approach inwards */
    const double value = component(p, p->a->n - back, p->cubic ? p->b->n - back : 0);
    state[n - back] = back > 0 ? po_law_expected_gap(&p->of_a.scene->law, value) : value;
  }
}

/* Size of the panel of a->wanted at the origin of a radius, both relative to the domain. */
static double wanted_size(po_prediction *p, double x) {
  const double origin = origin_of(p, x * p->a->domain).r / p->a->domain;
  const po_panels *wanted = p->a->wanted;
  p->panel_wanted = po_panels_find(wanted, origin, p->panel_wanted);
  return po_panel_size(wanted->panel[p->panel_wanted]);
}

bool po_prediction_too_large(po_prediction *p, po_panel panel, double times) {
  enum { SAMPLES = 5 };
  const double begin = po_panel_begin(panel), size = po_panel_size(panel);
  for (int k = 0; k < SAMPLES; ++k)
    if (size > 1.001 * times * wanted_size(p, begin + size * (k + 0.5) / SAMPLES))
      return true;
  return false;
}

double po_prediction_error(const po_gap_field *predicted, const po_law *law, const double *guess,
                           const po_solution *solved) {
  double largest = 0.0;
  for (size_t j = 0; j < solved->core; ++j) {
    const double expected = guess ? guess[j] : predicted->gap_at(predicted->data, solved->node[j]);
    largest = fmax(largest, fabs(solved->state[j] - expected) / po_law_size(law, solved->state[j]));
  }
  return largest;
}
