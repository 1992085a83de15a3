#include "po_balance.h"

#include <math.h>

#include "po_hermite.h"

/* Gauss's rule with three points on (0, 1). It is exact for the integrand, a cubic times the
 * derivative of a cubic. */
static const double NODE[] = {0.11270166537925831, 0.5, 0.88729833462074169};
static const double WEIGHT[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/* The integral of the load over the approach along the cubics with the values and rates at two
 * points. The parameter of the rates does not change the area to this order. */
static double work_between(const po_branch_point *a, const po_branch_point *b) {
  const double h = b->position - a->position;
  double sum = 0.0;
  for (int q = 0; q < 3; ++q)
    sum += WEIGHT[q] * h *
           po_hermite_value(a->load, a->load_rate, b->load, b->load_rate, NODE[q] * h, h) *
           po_hermite_rate(a->approach, a->approach_rate, b->approach, b->approach_rate,
                           NODE[q] * h, h);
  return sum;
}

void po_balance_note(po_balance *balance, const po_branch_point *p) {
  if (balance->begun && p->position > balance->last.position) {
    balance->gained += p->energy - balance->last.energy;
    balance->done += work_between(&balance->last, p);
    const double off = fabs(balance->gained - balance->done);
    if (!(off <= balance->worst)) {
      balance->worst = off;
      balance->at = p->approach;
    }
    balance->lowest = fmin(balance->lowest, balance->gained);
    balance->highest = fmax(balance->highest, balance->gained);
  }
  balance->begun = true;
  balance->last = *p;
}

double po_balance_defect(const po_balance *balance) {
  const double range = balance->highest - balance->lowest;
  return range > 0.0 ? balance->worst / range : (double)NAN;
}
