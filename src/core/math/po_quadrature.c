#include "po_quadrature.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>

#include "po_elementary.h"

void po_gsl_return_errors(void) {
  gsl_set_error_handler_off();
}

po_status po_gauss_rule(size_t n, double *node, double *weight) {
  gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(n);
  if (!table)
    return po_fail(PO_NO_MEMORY, "out of memory while a Gauss rule of %zu points was computed", n);
  for (size_t i = 0; i < n; ++i)
    gsl_integration_glfixed_point(0.0, 1.0, i, &node[i], &weight[i], table);
  gsl_integration_glfixed_table_free(table);
  return PO_OK;
}

static void fill_log_rule(double *node, double *weight) {
  /* x = 1/(1 + exp(-pi sinh t)) with the trapezoidal rule in t. The ends are chosen so that x log x
   * is below 1e-19 at the left end and 1 - x is below 1e-17 at the right end. */
  const double left = -3.32, right = 3.20;
  const double step = (right - left) / (PO_LOG_RULE_POINTS - 1);
  for (size_t i = 0; i < PO_LOG_RULE_POINTS; ++i) {
    const double t = left + step * (double)i;
    const double e = po_exp(-M_PI * po_sinh(t));
    node[i] = 1.0 / (1.0 + e);
    weight[i] = step * M_PI * po_cosh(t) * node[i] * (e / (1.0 + e));
  }
}

void po_barycentric_weights(size_t n, const double *node, double *barycentric) {
  for (size_t j = 0; j < n; ++j) {
    double product = 1.0;
    for (size_t k = 0; k < n; ++k)
      if (k != j)
        product *= 4.0 * (node[j] - node[k]); /* (0, 1) has the capacity 1/4: no underflow */
    barycentric[j] = 1.0 / product;
  }
}

void po_lagrange(size_t n, const double *node, const double *barycentric, double x, double *value) {
  double sum = 0.0;
  for (size_t j = 0; j < n; ++j) {
    const double difference = x - node[j];
    if (difference == 0.0) {
      for (size_t k = 0; k < n; ++k)
        value[k] = k == j ? 1.0 : 0.0;
      return;
    }
    value[j] = barycentric[j] / difference;
    sum += value[j];
  }
  for (size_t j = 0; j < n; ++j)
    value[j] /= sum;
}

po_status po_near_tables_fill(po_near_tables *tables) {
  fill_log_rule(tables->log_node, tables->log_weight);
  return po_gauss_rule(PO_NEAR_GAUSS_POINTS, tables->gauss_node, tables->gauss_weight);
}

/* The integral of the logarithm over a piece shorter than this is below the rounding of the
 * result. */
static const double LEAST_PIECE = 1e-20;

/* The points of a piece on one side of x0, with the nodes and weights of a rule over (0, 1). */
static void fill_piece(const po_near_rule *r, double length, size_t count, const double *node,
                       const double *weight, po_near_point *point) {
  for (size_t q = 0; q < count; ++q) {
    const double offset = r->sign * (r->near + length * node[q]);
    point[q] = (po_near_point){.x = r->x0 + offset, .offset = offset, .weight = length * weight[q]};
  }
}

po_near_rule po_near_rule_begin(const po_near_tables *tables, double x0, double mirror) {
  return (po_near_rule){.tables = tables,
                        .x0 = x0,
                        .mirror = fmax(mirror, LEAST_PIECE),
                        .sign = -1.0,
                        .near = x0 > 1.0 ? x0 - 1.0 : 0.0,
                        .to = x0};
}

size_t po_near_rule_next(po_near_rule *r, po_near_point point[PO_NEAR_PIECE_POINTS]) {
  const po_near_tables *t = r->tables;
  if (!(r->near < r->to) && r->sign < 0.0) {
    r->sign = 1.0;
    r->near = r->x0 < 0.0 ? -r->x0 : 0.0;
    r->to = 1.0 - r->x0;
  }
  if (!(r->near < r->to))
    return 0;
  if (r->near == 0.0) {
    const double length = r->mirror < r->to ? r->mirror : r->to;
    fill_piece(r, length, PO_LOG_RULE_POINTS, t->log_node, t->log_weight, point);
    r->near = length;
    return PO_LOG_RULE_POINTS;
  }
  double length = r->near; /* the length of each piece equals its distance from the singularity */
  if (r->near + 1.5 * length > r->to)
    length = r->to - r->near;
  fill_piece(r, length, PO_NEAR_GAUSS_POINTS, t->gauss_node, t->gauss_weight, point);
  r->near = length == r->to - r->near ? r->to : r->near + length;
  return PO_NEAR_GAUSS_POINTS;
}

int po_near_is_far(double x0, size_t n) {
  /* The relative error of a Gauss rule with n points is rho^(-2n), where rho is the parameter of
   * the Bernstein ellipse through the singularity. Requiring rho^n = 10^10.5, i.e. an error of
   * 1e-21 for the kernel alone, leaves half of the digits for the polynomial that multiplies the
   * kernel. */
  const double rho = po_pow(10.0, 10.5 / (double)n);
  const double reach = 0.25 * (rho + 1.0 / rho) - 0.5; /* distance beyond the ends of (0, 1) */
  return x0 <= -reach || x0 >= 1.0 + reach;
}

/* The nodes of the rule on (-1, 1) and their weights; every other node, from the second on, belongs
 * to Gauss's rule of 10 points. It is exact for polynomials of degree 31
 * (tests/unit/test_quadrature.c). */
enum { PAIRS = 10 };
static const double NODE[PAIRS] = {0.9956571630258081, 0.9739065285171717, 0.9301574913557082,
                                   0.8650633666889845, 0.7808177265864169, 0.6794095682990244,
                                   0.5627571346686047, 0.4333953941292472, 0.2943928627014602,
                                   0.14887433898163122};
static const double KRONROD[PAIRS + 1] = {
    0.011694638867371874, 0.032558162307964725, 0.054755896574351995, 0.07503967481091996,
    0.0931254545836976,   0.10938715880229764,  0.12349197626206584,  0.13470921731147334,
    0.14277593857706009,  0.1477391049013385,   0.1494455540029169};
static const double GAUSS[PAIRS / 2] = {0.06667134430868814, 0.1494513491505806,
                                        0.21908636251598204, 0.26926671930999635,
                                        0.29552422471475287};

typedef struct {
  double from, to, integral, error;
  double rounding; /* of the integral: what the error can at least be told from */
} piece;

/* The estimate of QUADPACK: the difference of the two rules, which is the error of Gauss's, is
 * reduced by the power 3/2 if it is small against the variation of the function. */
static double reduced(double difference, double variation) {
  if (variation == 0.0 || difference == 0.0)
    return difference;
  const double part = 200.0 * difference / variation;
  return part < 1.0 ? variation * part * sqrt(part) : variation;
}

static piece rule(po_integrand f, void *data, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from), at_middle = f(middle, data);
  double low[PAIRS], high[PAIRS];
  double kronrod = KRONROD[PAIRS] * at_middle, gauss = 0.0, size = fabs(kronrod);
  for (int k = 0; k < PAIRS; ++k) {
    low[k] = f(middle - half * NODE[k], data);
    high[k] = f(middle + half * NODE[k], data);
    kronrod += KRONROD[k] * (low[k] + high[k]);
    size += KRONROD[k] * (fabs(low[k]) + fabs(high[k]));
    if (k % 2 == 1)
      gauss += GAUSS[k / 2] * (low[k] + high[k]);
  }
  const double mean = 0.5 * kronrod;
  double variation = KRONROD[PAIRS] * fabs(at_middle - mean);
  for (int k = 0; k < PAIRS; ++k)
    variation += KRONROD[k] * (fabs(low[k] - mean) + fabs(high[k] - mean));
  const double length = fabs(half), rounding = 50.0 * DBL_EPSILON * size * length;
  return (piece){from, to, kronrod * half,
                 fmax(rounding, reduced(fabs(kronrod - gauss) * length, variation * length)),
                 rounding};
}

po_status po_integrate(po_integrand f, void *data, double from, double to, double absolute,
                       double relative, double *integral) {
  enum { PIECES = 200 };
  piece pieces[PIECES];
  pieces[0] = rule(f, data, from, to);
  for (size_t count = 1;; ++count) {
    double sum = 0.0, error = 0.0, rounding = 0.0;
    size_t worst = 0;
    for (size_t k = 0; k < count; ++k) {
      sum += pieces[k].integral;
      error += pieces[k].error;
      rounding += pieces[k].rounding;
      if (pieces[k].error - pieces[k].rounding > pieces[worst].error - pieces[worst].rounding)
        worst = k;
    }
    *integral = sum;
    if (error <= fmax(absolute, relative * fabs(sum)) || error <= 2.0 * rounding)
      return PO_OK;
    const piece p = pieces[worst];
    const double middle = 0.5 * (p.from + p.to);
    if (count == PIECES || !isfinite(sum) || middle == p.from || middle == p.to)
      return PO_NOT_CONVERGED;
    pieces[worst] = rule(f, data, p.from, middle);
    pieces[count] = rule(f, data, middle, p.to);
  }
}
