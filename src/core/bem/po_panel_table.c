#include "po_panel_table.h"

#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

#include "po_elementary.h"
#include "po_kernel.h"
#include "po_lock.h"
#include "po_quadrature.h"
#include "po_skeleton.h"

/* An offset of panels that are not near. */
enum { FAR = 99 };

/* The position of a target relative to a source: the difference of their levels, and the offset of
 * the target in units of the shorter of the two panels. */
typedef struct {
  int level, offset;
} position;

/* The panel itself; neighbours of equal length; of one half and one quarter; of twice and four
 * times the length. */
static const position LOG_POSITIONS[PO_LOG_POSITIONS] = {{0, 0},  {0, -1},  {0, 1}, {1, -1},
                                                         {1, 2},  {2, -1},  {2, 4}, {-1, -2},
                                                         {-1, 1}, {-2, -4}, {-2, 1}};
static const position AXIS_POSITIONS[PO_AXIS_POSITIONS] = {{0, 0}, {0, 1}, {1, 2}, {2, 4}};

static position position_of(po_panel target, po_panel source) {
  const int level = (int)target.level - (int)source.level;
  if (abs(level) > PO_MOST_LEVEL_STEP)
    return (position){level, FAR};
  const int64_t to = (int64_t)target.index << (level < 0 ? -level : 0);
  const int64_t from = (int64_t)source.index << (level > 0 ? level : 0);
  return (position){level, to - from > FAR ? FAR : to - from < -FAR ? -FAR : (int)(to - from)};
}

static int find(const position *positions, int count, position s) {
  for (int k = 0; k < count; ++k)
    if (positions[k].level == s.level && positions[k].offset == s.offset)
      return k;
  return -1;
}

/* Returned: the position of node i of the target in the variable x of the source. */
static double node_in_source(const po_panel_rule *rule, position s, size_t i) {
  const double size = ldexp(1.0, -s.level), unit = fmin(size, 1.0);
  return unit * s.offset + size * rule->node[i];
}

static void fill_logarithm(const po_panel_rule *rule, position s, po_panel_block block) {
  static const double NO_MIRROR = 1e300;
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
    po_near_rule near = po_near_rule_begin(&rule->near, node_in_source(rule, s, i), NO_MIRROR);
    po_near_point point[PO_NEAR_PIECE_POINTS];
    double value[PO_TABLE_ORDER];
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      block[i][j] = 0.0;
    for (size_t count; (count = po_near_rule_next(&near, point)) > 0;)
      for (size_t q = 0; q < count; ++q) {
        const double factor = point[q].weight * po_log(fabs(point[q].offset));
        po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, point[q].x, value);
        for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
          block[i][j] += factor * value[j];
      }
  }
}

static po_panel_table table;
static atomic_bool is_filled;

static void fill_derivative(const po_panel_rule *rule, po_panel_block block) {
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      block[i][j] =
          i == j ? 0.0
                 : rule->barycentric[j] / rule->barycentric[i] / (rule->node[i] - rule->node[j]);
}

static void fill_legendre(const po_panel_rule *rule, po_legendre *legendre) {
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double x = 2.0 * rule->node[j] - 1.0;
    double before = 0.0, now = 1.0;
    legendre->at_end[0][j] = legendre->at_end[1][j] = 0.0;
    for (int k = 0; k < PO_TABLE_ORDER; ++k) {
      legendre->coefficient[k][j] = (2 * k + 1) * rule->weight[j] * now;
      legendre->at_end[0][j] += k % 2 ? -legendre->coefficient[k][j] : legendre->coefficient[k][j];
      legendre->at_end[1][j] += legendre->coefficient[k][j];
      const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
      before = now;
      now = next;
    }
  }
}

static void fill_halves(const po_panel_rule *rule, po_panel_halves *halves) {
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const size_t j = i % PO_TABLE_ORDER;
    halves->node[i] = 0.5 * ((i < PO_TABLE_ORDER ? 0.0 : 1.0) + rule->node[j]);
    halves->weight[i] = 0.5 * rule->weight[j];
    po_lagrange(PO_TABLE_ORDER, rule->node, rule->barycentric, halves->node[i],
                halves->lagrange[i]);
  }
}

/* A table that could not be filled for lack of memory is filled by a later call. */
static void fill_table(void) {
  if (is_filled || po_panel_rule_fill(PO_TABLE_ORDER, &table.rule))
    return;
  table.skeleton = po_skeleton_make(&table.rule);
  if (!table.skeleton)
    return;
  for (int k = 0; k < PO_LOG_POSITIONS; ++k)
    fill_logarithm(&table.rule, LOG_POSITIONS[k], table.logarithm[k]);
  for (int k = 0; k < PO_AXIS_POSITIONS; ++k)
    for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
      po_panel_influence(&table.rule, (po_panel_span){.begin = 0.0, .end = 1.0},
                         node_in_source(&table.rule, AXIS_POSITIONS[k], i), table.axis[k][i], 1);
  fill_derivative(&table.rule, table.derivative);
  fill_legendre(&table.rule, &table.legendre);
  fill_halves(&table.rule, &table.halves);
  is_filled = true;
}

const po_panel_table *po_panel_table_get(void) {
  if (is_filled)
    return &table;
  po_lock_take(PO_LOCK_PANELS);
  fill_table();
  const bool filled = is_filled;
  po_lock_release(PO_LOCK_PANELS);
  return filled ? &table : NULL;
}

/* Computes a block near the singularity: G = a ln|r - s| + b, times s and the length of the source.
 * The weights of the table integrate the logarithm, the Gauss rule the rest. */
static void near_block(const po_panel_table *t, po_panel target, po_panel source, int k,
                       po_panel_block block) {
  const double begin = po_panel_begin(source), size = po_panel_size(source);
  const double from = po_panel_begin(target), reach = po_panel_size(target),
               log_size = po_log(size);
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
    const double r = from + reach * t->rule.node[i];
    const double x0 = node_in_source(&t->rule, position_of(target, source), i);
    double s[PO_TABLE_ORDER], sum[PO_TABLE_ORDER], geometric[PO_TABLE_ORDER];
    double distance[PO_TABLE_ORDER], apart[PO_TABLE_ORDER];
    double smooth[PO_TABLE_ORDER], whole[PO_TABLE_ORDER];
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const double x = t->rule.node[j];
      s[j] = begin + size * x;
      sum[j] = r + s[j];
      geometric[j] = 2.0 * sqrt(r * s[j]);
      distance[j] = size * fabs(x0 - x);
      apart[j] = distance[j] > 0.0 ? distance[j] : sum[j]; /* at the node itself: not used */
    }
    po_kernels(PO_TABLE_ORDER, sum, geometric, smooth);
    po_kernels(PO_TABLE_ORDER, sum, apart, whole);
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      /* 1/agm(sum, geometric) = po_kernel/2, with `geometric` in place of the difference */
      const double a = -2.0 / M_PI * smooth[j];
      const double b = distance[j] > 0.0 ? whole[j] - a * po_log(distance[j])
                                         : 2.0 * po_log(8.0 * r) / (M_PI * r);
      const double log_weight = t->logarithm[k][i][j] + log_size * t->rule.weight[j];
      block[i][j] = s[j] * size * (a * log_weight + b * t->rule.weight[j]);
    }
  }
}

static void far_block(const po_panel_table *t, po_panel target, po_panel source,
                      po_panel_block block) {
  const double begin = po_panel_begin(source), size = po_panel_size(source);
  const double from = po_panel_begin(target), reach = po_panel_size(target);
  double s[PO_TABLE_ORDER], weight[PO_TABLE_ORDER];
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    s[j] = begin + size * t->rule.node[j];
    weight[j] = size * s[j] * t->rule.weight[j];
  }
  const double between = from - begin; /* exact: both are multiples of the deepest panel's size */
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
    const double x = reach * t->rule.node[i];
    double apart[PO_TABLE_ORDER];
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      apart[j] = between + (x - size * t->rule.node[j]);
    po_kernel_row(from + x, s, apart, PO_TABLE_ORDER, block[i]);
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      block[i][j] *= weight[j];
  }
}

void po_panel_table_block(const po_panel_table *t, po_panel target, po_panel source,
                          po_panel_block block) {
  const position s = position_of(target, source);
  if (source.index == 0) {
    const int k = find(AXIS_POSITIONS, PO_AXIS_POSITIONS, s);
    const double size = po_panel_end(source);
    if (k >= 0) { /* the kernel scales as 1/length and s ds as its square */
      for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
        for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
          block[i][j] = size * t->axis[k][i][j];
      return;
    }
  } else {
    const int k = find(LOG_POSITIONS, PO_LOG_POSITIONS, s);
    if (k >= 0) {
      near_block(t, target, source, k, block);
      return;
    }
  }
  far_block(t, target, source, block);
}
