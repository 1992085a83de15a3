#include "po_quadrature.h"

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

void po_log_rule(double node[PO_LOG_RULE_POINTS], double weight[PO_LOG_RULE_POINTS]) {
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
