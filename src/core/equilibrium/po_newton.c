/* Quasi-Newton iterations for Eq 15 and for the tangent of the branch. Both use the factors of
 * po_equilibrium, which may be those of an earlier state, and Broyden's updates. See doc/method.md,
 * "Newton's method". */
#include <float.h>
#include <math.h>
#include <string.h>

#include "po_deadline.h"
#include "po_elementary.h"
#include "po_equilibrium.h"
#include "po_krylov.h"
#include "po_linear.h"
#include "po_margins.h"

/* A change, relative to 1 + H, that may be due to rounding: PO_FINEST_PRECISION, or this many times
 * the measured noise. A smaller change that no longer decreases is accepted as converged, and
 * Broyden's method makes no update from it. The noise is the precision that an iteration can reach.
 * Noise of stiff scenes is five to ten times the measured one; updates made of it amplify it, so
 * that with 5 the law (4, 10) at mu = 10,000 took three times as many points. */
static const double STAGNATED_OF_NOISE = 20.0;
/* Changes of a gap, relative to 1 + H, at which an iteration is given up: larger than the error of
 * any prediction; and, after the first iteration, larger than any from which the iteration
 * converges. */
static const double GREATEST_CHANGE = 1e3, DIVERGED = 10.0;
/* Mean contraction of an iteration above which a new factorisation is cheaper. */
static const double SLOWEST = 0.45;
/* Greatest error of the condition at which an iteration may have converged. The changes of the gaps
 * alone do not show it: a prediction that closes the gaps far beyond any equilibrium, where the law
 * is as stiff as 1e30, leaves them no change, but an approach that changes by as much. A step is
 * about as long as 1, and in the 39,475 converged iterations of 100 random scenes (Tabor parameters
 * from 0.1 to 100, all laws, waves, cuts, tolerances from 1e-8 to 1e-4) the error was at most
 * 1.5e-6. */
static const double GREATEST_LEFT = 0.1;
/* The same of Eq 15: the error that is left, over the greatest that the last change can have
 * removed. It is about 1 if the factors are those of a state near by. Factors of a state whose gaps
 * are closed too far, where the law is 1e9 times as stiff or more, leave an error and hardly a
 * change, time after time: such an iteration seems to converge, but not to an equilibrium. */
static const double GREATEST_UNEXPLAINED = 10.0;
/* Iterations before the contraction is judged. */
enum { MOST_ITERATIONS = 20, PATIENCE = 3 };

/* As fmax if a is a number; a call of fmax costs ten times as much. */
static inline double greater(double a, double b) {
  return b > a ? b : a;
}

/* border . (state - base): the condition of po_equilibrium_correct. */
static double distance_of(const po_equilibrium *e, const double *state, const void *data) {
  const double *base = data;
  double sum = e->border[e->n] * (state[e->n] - base[e->n]);
  for (size_t j = 0; j < e->n; ++j)
    sum += e->border[j] * (state[j] - base[j]);
  return sum;
}

static double stagnated(const po_equilibrium *e) {
  return fmax(PO_FINEST_PRECISION, STAGNATED_OF_NOISE * e->noise);
}

/* Rounding of the sum in Eq 15, relative to the result. */
static const double SUM_ROUNDING = 16.0 * DBL_EPSILON;

/* A sign for each node, without order. */
static double sign_of(size_t j) {
  return (j * 2654435761U >> 16 & 1) ? 1.0 : -1.0;
}

void po_equilibrium_measure_noise(po_equilibrium *e, const double *state) {
  const size_t n = e->n;
  const po_law *law = &e->scene->law;
  double *rounding = e->deflection, *change = e->scratch, part = 0.0;
  for (size_t j = 0; j < n; ++j) {
    const double size = SUM_ROUNDING * (fabs(e->initial_gap[j]) + fabs(state[n]) + fabs(state[j]));
    part = greater(part, size / po_law_size(law, state[j]));
    rounding[j] = size * sign_of(j);
  }
  rounding[n] = 0.0;
  po_equilibrium_precondition(e, rounding, change);
  double noise = 0.0;
  for (size_t j = 0; j < n; ++j)
    noise = greater(noise, fabs(change[j]) / po_law_size(law, state[j]));
  e->noise = noise;
  e->gain = noise / part;
}

/* The largest error of Eq 15 over a bound of what the change of the state contributes to it. Given:
 * the slopes of the state before. */
static double unexplained(const po_equilibrium *e, const double *residual, const double *change) {
  double deflection = 0.0, largest = 0.0;
  for (size_t j = 0; j < e->n; ++j)
    deflection += e->coupling * fabs(e->slope[j] * change[j]) * e->surface->reach[j];
  for (size_t j = 0; j < e->n; ++j) {
    const double explained = fabs(change[j]) + fabs(change[e->n]) + deflection;
    largest = greater(largest, fabs(residual[j]) / (explained + DBL_MIN));
  }
  return largest;
}

/* The norm of the residual of a Newton iteration that GMRES leaves, relative to that before. */
static const double KRYLOV_OF_NEWTON = 1e-5;

/* The change that a residual asks for. Status: those of po_krylov_solve. */
static po_status solve_change(po_equilibrium *e, const double *residual, double *change) {
  if (e->by_krylov)
    return po_krylov_solve(e, residual, KRYLOV_OF_NEWTON, change);
  po_equilibrium_precondition(e, residual, change);
  po_secant_step(&e->secant, change);
  return PO_OK;
}

/* One quasi-Newton iteration for Eq 15 and the condition. Returned: the largest change of a gap
 * relative to 1 + H; NaN if it is not finite; left, the error of the condition before, or of Eq 15
 * as far as it is allowed. */
static double newton_step(po_equilibrium *e, double *state, const po_constraint *constraint,
                          double *left) {
  const size_t n = e->n;
  const po_law *law = &e->scene->law;
  double *residual = e->deflection, *change = e->scratch;
  po_equilibrium_residual(e, state, residual);
  residual[n] = constraint->target - constraint->value(e, state, constraint->data);
  *left = fabs(residual[n]);
  if (solve_change(e, residual, change))
    return NAN;
  if (!e->by_krylov) /* GMRES has the Jacobian of the state itself, and overwrites the residual */
    *left = fmax(*left, GREATEST_LEFT / GREATEST_UNEXPLAINED * unexplained(e, residual, change));
  double largest = 0.0;
  for (size_t j = 0; j < n; ++j) {
    const double relative = change[j] / po_law_size(law, state[j]);
    if (!(fabs(relative) <= largest))
      largest = fabs(relative);
  }
  if (!isfinite(largest))
    return NAN;
  if (largest < stagnated(e))
    po_secant_begin(&e->secant);
  for (size_t j = 0; j <= n; ++j)
    state[j] += change[j];
  return largest;
}

/* Convergence of an iteration: the sizes of its first change and of its last three. */
typedef struct {
  double first, now, before, earlier;
  int count;
} progress;

static progress progress_begin(void) { /* comparisons with NaN are false */
  return (progress){NAN, NAN, NAN, NAN, 0};
}

static void note_change(progress *p, double change) {
  p->earlier = p->before;
  p->before = p->now;
  p->now = change;
  if (p->count++ == 0)
    p->first = change;
}

/* Whether the iteration diverges, or converges so slowly that it is given up. */
static bool is_hopeless(const progress *p, double stagnated) {
  return !(p->now < GREATEST_CHANGE) || (p->count > 1 && p->now > DIVERGED) ||
         (p->count > PATIENCE && p->now > stagnated &&
          p->now > p->first * po_pow(SLOWEST, p->count - 1));
}

/* The contraction that is expected of the next iteration. Factors of an earlier state leave changes
 * whose ratio grows towards that of the slowest part: that of the first two was up to 60 times too
 * small, its square root at most twice (560 corrections at mu = 20 with waves; the case
 * extreme_stiff checks the residuals that are left). */
static double expected_rate(const progress *p) {
  const double last = p->now / p->before;
  return p->count > 2 ? fmax(last, p->before / p->earlier) : sqrt(last);
}

/* Whether the change, or the change expected next, is below the precision. */
static bool is_converged(const progress *p, double precision) {
  const double rate = expected_rate(p);
  return p->now < precision || (rate < SLOWEST && 2.0 * rate * p->now < precision);
}

/* Whether the change is small and no longer decreases because of rounding. */
static bool has_stagnated(const progress *p, double stagnated) {
  return p->now < stagnated && p->now > SLOWEST * p->earlier;
}

po_status po_equilibrium_correct(po_equilibrium *e, double *state, const double *base,
                                 double distance) {
  const po_constraint constraint = {distance_of, base, distance, INFINITY};
  return po_equilibrium_correct_to(e, state, &constraint);
}

po_status po_equilibrium_correct_to(po_equilibrium *e, double *state,
                                    const po_constraint *constraint) {
  progress p = progress_begin();
  po_secant_begin(&e->secant);
  e->last_change = INFINITY;
  for (int iteration = 0; iteration < MOST_ITERATIONS; ++iteration) {
    const po_status stopped = po_deadline_check();
    if (stopped)
      return stopped;
    double left;
    note_change(&p, newton_step(e, state, constraint, &left));
    e->last_change = p.now;
    ++e->work.newton_iterations;
    const double precision = fmax(e->precision, e->noise);
    const bool converged = is_converged(&p, precision);
    if (converged || has_stagnated(&p, stagnated(e))) {
      if (!(left < GREATEST_LEFT))
        return PO_NOT_CONVERGED;
      e->reached = converged ? precision : greater(p.now, p.earlier);
      po_equilibrium_evaluate(e, state);
      ++e->work.points;
      return PO_OK;
    }
    if (is_hopeless(&p, stagnated(e)) || p.now > constraint->farthest)
      return PO_NOT_CONVERGED;
  }
  return PO_NOT_CONVERGED;
}

/* Solves the bordered linearised Eq 15 for the right-hand side e->source. */
static po_status solve_linear(po_equilibrium *e, const double *unit, double precision,
                              double *solution) {
  const size_t n = e->n;
  double *residual = e->deflection, *change = e->scratch;
  memset(solution, 0, (n + 1) * sizeof *solution);
  po_secant_begin(&e->secant);
  progress p = progress_begin();
  const double least = unit ? precision : fmax(precision, e->noise);
  for (int iteration = 0; iteration < MOST_ITERATIONS; ++iteration) {
    const po_status stopped = po_deadline_check();
    if (stopped)
      return stopped;
    residual[n] = e->source[n] - e->border[n] * solution[n] - po_linear_dot(n, e->border, solution);
    for (size_t j = 0; j < n; ++j)
      change[j] = e->slope[j] * solution[j];
    po_equilibrium_deflect(e, change, residual);
    for (size_t i = 0; i < n; ++i)
      residual[i] += e->source[i] - (solution[n] + solution[i]);
    po_equilibrium_precondition(e, residual, change);
    po_secant_step(&e->secant, change);
    double largest = 0.0, size = 0.0;
    for (size_t j = 0; j <= n; ++j) {
      solution[j] += change[j];
      const double one = unit && j < n ? unit[j] : 1.0;
      largest = greater(largest, fabs(change[j]) / one);
      size = greater(size, fabs(solution[j]) / one);
    }
    ++e->tangent_iterations;
    note_change(&p, largest / size);
    if (iteration > 0 && (is_converged(&p, least) || has_stagnated(&p, stagnated(e))))
      return PO_OK;
    if (is_hopeless(&p, stagnated(e)))
      return PO_NOT_CONVERGED;
  }
  return PO_NOT_CONVERGED;
}

/* Updates that were made of changes near rounding may prevent convergence: without them, the
 * factors alone decide. */
po_status po_equilibrium_solve(po_equilibrium *e, const double *unit, double precision,
                               double *solution) {
  if (e->by_krylov)
    return po_krylov_solve(e, e->source, PO_PART_OF_TOLERANCE * precision, solution);
  const po_status status = solve_linear(e, unit, precision, solution);
  if (!status || e->secant.count == 0)
    return status;
  po_secant_drop(&e->secant);
  return solve_linear(e, unit, precision, solution);
}

po_status po_equilibrium_tangent(po_equilibrium *e, double precision, double *tangent) {
  memset(e->source, 0, e->n * sizeof *e->source);
  e->source[e->n] = 1.0;
  return po_equilibrium_solve(e, NULL, precision, tangent);
}
