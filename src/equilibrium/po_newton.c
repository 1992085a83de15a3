/* Quasi-Newton iterations with the factors of po_equilibrium: onto an equilibrium, and to the
 * tangent. Broyden's updates make up for factors that are a little old. */
#include <math.h>
#include <string.h>

#include "po_equilibrium.h"
#include "po_linear.h"

/* A change that rounding may have, with a wide margin: when rounding keeps a correction from its
 * precision, this much is accepted if it no longer falls; and Broyden's updates learn nothing from
 * a smaller one. */
static const double STAGNATED = 1e-10;
/* Share of 1 + H that one iteration may take from a gap. */
static const double GREATEST_CLOSING = 0.7;
/* A change of a gap, in parts of 1 + H, that no prediction is off by; and one that no iteration
 * recovers from once it began. */
static const double GREATEST_CHANGE = 1e3, DIVERGED = 10.0;
/* An iteration that on average contracts less costs more than a new factorisation. */
static const double SLOWEST = 0.45;
enum { MOST_ITERATIONS = 20, PATIENCE = 3 };

/* border . (state - base): the constraint of po_equilibrium_correct. */
static double distance_of(const po_equilibrium *e, const double *state, const void *data) {
  const double *base = data;
  double sum = e->border[e->n] * (state[e->n] - base[e->n]);
  for (size_t j = 0; j < e->n; ++j)
    sum += e->border[j] * (state[j] - base[j]);
  return sum;
}

/* change = -M residual, n + 1, by the factors: of the active nodes and the approach; the others
 * follow from their own equations. */
static void precondition(po_equilibrium *e, const double *residual, double *change) {
  const size_t n = e->n, m = e->active;
  double *right = e->right;
  for (size_t a = 0; a < m; ++a)
    right[a] = residual[e->index[a]];
  right[m] = residual[n];
  po_factors_solve(&e->factors, right);
  if (e->changed) {
    const double excess = po_linear_dot(m + 1, e->change, right) / e->pivot;
    for (size_t a = 0; a <= m; ++a)
      right[a] -= excess * e->response[a];
  }
  for (size_t a = 0; a < m; ++a)
    change[e->index[a]] = right[a];
  change[n] = right[m];
  for (size_t b = m; b < n; ++b)
    change[e->index[b]] = residual[e->index[b]] - change[n];
}

/* One quasi-Newton step. Returned: the largest change of a gap in parts of 1 + H, or NaN. */
static double newton_step(po_equilibrium *e, double *state, const po_constraint *constraint) {
  const size_t n = e->n;
  const po_law *law = &e->scene->law;
  double *residual = e->deflection, *change = e->scratch;
  po_equilibrium_residual(e, state, residual);
  residual[n] = constraint->target - constraint->value(e, state, constraint->data);
  precondition(e, residual, change);
  po_secant_step(&e->secant, change);
  double largest = 0.0, closing = 0.0;
  for (size_t j = 0; j < n; ++j) {
    const double relative = change[j] / po_law_size(law, state[j]);
    if (!(fabs(relative) <= largest))
      largest = fabs(relative);
    if (-relative > closing)
      closing = -relative;
  }
  if (!isfinite(largest))
    return NAN;
  if (largest < STAGNATED)
    po_secant_begin(&e->secant);
  double share = 1.0;
  if (closing > GREATEST_CLOSING) {
    share = GREATEST_CLOSING / closing;
    po_secant_begin(&e->secant);
  }
  for (size_t j = 0; j <= n; ++j)
    state[j] += share * change[j];
  return largest;
}

/* How an iteration converges: the sizes of its first change and of the last ones. */
typedef struct {
  double first, now, before, earlier;
  int count;
} progress;

static progress progress_begin(void) { /* comparisons with what has not happened yet are false */
  return (progress){NAN, NAN, NAN, NAN, 0};
}

static void note_change(progress *p, double change) {
  p->earlier = p->before;
  p->before = p->now;
  p->now = change;
  if (p->count++ == 0)
    p->first = change;
}

/* Whether it does not converge, or too slowly to be worth waiting for. */
static bool is_hopeless(const progress *p) {
  return !(p->now < GREATEST_CHANGE) || (p->count > 1 && p->now > DIVERGED) ||
         (p->count > PATIENCE && p->now > STAGNATED &&
          p->now > p->first * pow(SLOWEST, p->count - 1));
}

/* Whether what is left is below the precision: this change was, or the next will be; or it is small
 * and rounding keeps it from falling. */
static bool is_converged(const progress *p, double precision) {
  const double rate = fmax(p->now / p->before, p->before / p->earlier);
  return p->now < precision || (rate < SLOWEST && 2.0 * rate * p->now < precision) ||
         (p->now < STAGNATED && p->now > SLOWEST * p->earlier);
}

po_status po_equilibrium_correct(po_equilibrium *e, double *state, const double *base,
                                 double distance) {
  const po_constraint constraint = {distance_of, base, distance};
  return po_equilibrium_correct_to(e, state, &constraint);
}

po_status po_equilibrium_correct_to(po_equilibrium *e, double *state,
                                    const po_constraint *constraint) {
  progress p = progress_begin();
  po_secant_begin(&e->secant);
  for (int iteration = 0; iteration < MOST_ITERATIONS; ++iteration) {
    note_change(&p, newton_step(e, state, constraint));
    e->last_change = p.now;
    ++e->work.newton_iterations;
    if (is_converged(&p, e->precision)) {
      po_equilibrium_evaluate(e, state);
      ++e->work.points;
      return PO_OK;
    }
    if (is_hopeless(&p))
      return PO_NOT_CONVERGED;
  }
  return PO_NOT_CONVERGED;
}

po_status po_equilibrium_tangent(po_equilibrium *e, double precision, double *tangent) {
  const size_t n = e->n;
  double *residual = e->deflection, *change = e->scratch;
  memset(tangent, 0, (n + 1) * sizeof *tangent);
  po_secant_begin(&e->secant);
  progress p = progress_begin();
  for (int iteration = 0; iteration < MOST_ITERATIONS; ++iteration) {
    residual[n] = 1.0 - e->border[n] * tangent[n] - po_linear_dot(n, e->border, tangent);
    for (size_t j = 0; j < n; ++j)
      change[j] = e->slope[j] * tangent[j];
    po_equilibrium_deflect(e, change, residual);
    for (size_t i = 0; i < n; ++i)
      residual[i] -= tangent[n] + tangent[i];
    precondition(e, residual, change);
    po_secant_step(&e->secant, change);
    double largest = 0.0, size = 0.0;
    for (size_t j = 0; j <= n; ++j) {
      tangent[j] += change[j];
      largest = fmax(largest, fabs(change[j]));
      size = fmax(size, fabs(tangent[j]));
    }
    ++e->work.tangent_iterations;
    note_change(&p, largest / size);
    if (iteration > 0 && is_converged(&p, precision))
      return PO_OK;
    if (is_hopeless(&p))
      return PO_NOT_CONVERGED;
  }
  return PO_NOT_CONVERGED;
}
