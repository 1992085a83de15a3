#include "po_resolution.h"

#include <math.h>
#include <string.h>

#include "po_law.h"
#include "po_shape.h"

enum { ORDER = PO_TABLE_ORDER, LAST_COEFFICIENTS = 3, MOST_DEPTH = 6 };

/* A parent takes the place of two panels when its own error is below this part of the allowed. */
static const double JOIN_MARGIN = 0.1;

void po_legendre_fill(const po_panel_rule *rule, po_legendre *legendre) {
  for (size_t j = 0; j < ORDER; ++j) {
    const double x = 2.0 * rule->node[j] - 1.0;
    double before = 0.0, now = 1.0;
    for (int k = 0; k < ORDER; ++k) {
      legendre->coefficient[k][j] = (2 * k + 1) * rule->weight[j] * now;
      const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
      before = now;
      now = next;
    }
  }
}

/* Size of the last Legendre coefficients of nodal values, and of the largest of all. */
static void decay(const po_legendre *legendre, const double *value, double *last, double *largest) {
  *last = *largest = 0.0;
  for (int k = 0; k < ORDER; ++k) {
    double sum = 0.0;
    for (int j = 0; j < ORDER; ++j)
      sum += legendre->coefficient[k][j] * value[j];
    *largest = fmax(*largest, fabs(sum));
    if (k >= ORDER - LAST_COEFFICIENTS)
      *last = fmax(*last, fabs(sum));
  }
}

/* The error of a panel in parts of the allowed. A traction of high degree deflects the surface by
 * its size times the panel's length over the degree; the load, integrated by Gauss's rule, suffers
 * only from twice the degree: the square of the decay. */
static double excess(const po_resolution *r, double begin, double end, const double *traction) {
  double last, largest;
  decay(r->legendre, traction, &last, &largest);
  const double length = end - begin;
  const double gap = r->e->coupling * length * last / ORDER;
  const double load =
      2.0 / r->e->radius * 0.5 * (begin + end) * length * last * last / (largest + 1e-300);
  return fmax(gap, load) / r->allowed;
}

double po_resolution_excess(const po_resolution *r) {
  const po_leaves *leaves = po_adaptive_leaves(r->adaptive);
  const double root = po_adaptive_root(r->adaptive);
  double worst = 0.0, traction[ORDER];
  for (size_t k = 0; k < leaves->count; ++k) {
    for (size_t j = 0; j < ORDER; ++j)
      traction[j] = po_law_at(r->state[0][k * ORDER + j]).traction;
    worst = fmax(worst, excess(r, root * po_leaf_begin(leaves->leaf[k]),
                               root * po_leaf_end(leaves->leaf[k]), traction));
  }
  return worst;
}

/* Error of a panel that need not be in force: its gaps by the polynomials of those that are, for
 * the deflection; the shape is known. */
static double excess_of_leaf(const po_resolution *r, po_leaf leaf) {
  const po_leaves *in_force = po_adaptive_leaves(r->adaptive);
  const double root = po_adaptive_root(r->adaptive);
  const double begin = po_leaf_begin(leaf), size = po_leaf_end(leaf) - begin;
  double traction[2][ORDER];
  for (size_t i = 0; i < ORDER; ++i) {
    const double x = begin + size * r->rule->node[i];
    const size_t k = po_leaves_find(in_force, x);
    const double from = po_leaf_begin(in_force->leaf[k]), to = po_leaf_end(in_force->leaf[k]);
    double value[ORDER];
    po_lagrange(ORDER, r->rule->node, r->rule->barycentric, (x - from) / (to - from), value);
    for (int s = 0; s < 2 && r->state[s]; ++s) {
      const double *gap = r->state[s] + k * ORDER, *shape = r->e->shape + k * ORDER;
      double deflected = po_shape(r->e->scene, root * x);
      for (size_t j = 0; j < ORDER; ++j)
        deflected += value[j] * (gap[j] - shape[j]);
      traction[s][i] = po_law_at(fmax(deflected, -0.9)).traction;
    }
  }
  double worst = excess(r, root * begin, root * (begin + size), traction[0]);
  if (r->state[1])
    worst = fmax(worst, excess(r, root * begin, root * (begin + size), traction[1]));
  return worst;
}

/* Splits leaves of a tree until each resolves. */
static bool split_all(const po_resolution *r, po_leaves *leaves) {
  bool known[PO_MOST_LEAVES] = {false}; /* leaf k was found to do */
  for (int pass = 0; pass < MOST_DEPTH; ++pass) {
    bool split[PO_MOST_LEAVES], any = false;
    for (size_t k = 0; k < leaves->count; ++k) {
      split[k] = !known[k] && excess_of_leaf(r, leaves->leaf[k]) > 1.0;
      any = any || split[k];
    }
    if (!any)
      return true;
    const po_leaves before = *leaves;
    if (!po_leaves_split(leaves, split))
      return false;
    bool now_known[PO_MOST_LEAVES] = {false};
    size_t old = 0;
    for (size_t k = 0; k < leaves->count; ++k) { /* what was not split still does */
      while (po_leaf_end(before.leaf[old]) <= po_leaf_begin(leaves->leaf[k]))
        ++old;
      now_known[k] = po_leaf_equal(before.leaf[old], leaves->leaf[k]);
    }
    memcpy(known, now_known, sizeof known);
  }
  return true;
}

static void join_what_can_be(const po_resolution *r, po_leaves *leaves) {
  bool join[PO_MOST_LEAVES] = {false};
  for (size_t k = 0; k + 1 < leaves->count; ++k) {
    const po_leaf a = leaves->leaf[k], b = leaves->leaf[k + 1];
    if (a.level < 2 || a.level != b.level || a.index % 2 || b.index != a.index + 1)
      continue;
    const po_leaf parent = {a.level - 1, a.index / 2};
    join[k] = join[k + 1] = excess_of_leaf(r, parent) < JOIN_MARGIN;
  }
  po_leaves_join(leaves, join);
}

bool po_resolution_leaves(const po_resolution *r, po_leaves *leaves) {
  const po_leaves *in_force = po_adaptive_leaves(r->adaptive);
  *leaves = *in_force;
  join_what_can_be(r, leaves);
  if (!split_all(r, leaves))
    *leaves = *in_force;
  if (leaves->count != in_force->count)
    return true;
  for (size_t k = 0; k < leaves->count; ++k)
    if (!po_leaf_equal(leaves->leaf[k], in_force->leaf[k]))
      return true;
  return false;
}
