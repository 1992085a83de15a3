#include "po_smoothing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_elementary.h"
#include "po_hermite.h"

/* Cubic B-splines that are not 0 in an interval; rows of a band. */
enum { ORDER = 4 };
typedef double band[ORDER]; /* the diagonal, and what is 1, 2 and 3 beside it */

/* First number of knots, and part of the parameters above which there are twice as many; also if
 * less than that is used because the knots are too far apart for the curve (removes_shape). */
enum { FIRST_KNOTS = 16 };
static const double MOST_USED = 0.25;

/* The roughness, relative to one with which both sums have the same trace, is sought between these
 * powers of 2, in steps, and then to a part of a step; or up to that which leaves little more than
 * a parabola. */
static const double ROUGHEST = -20.0, SMOOTHEST = 120.0, STEP = 2.0, ACCURACY = 0.02;
static const double PARABOLA = 3.05; /* parameters */

/* A parameter counts as so many in the score: with 1, noise is now and then taken for shape.
 * Source: Y.-J. Kim, C. Gu, J. R. Stat. Soc. B 66 (2004) 337. */
static const double COUNT = 1.4;

/* The least score is that of the least mean error of the gap. The force depends on the sharpest
 * parts of the gap, which that roughness wears off by more than the noise of the rest; a roughness
 * that is less by this power of 2 does not (tests/estimates/README.md). */
static const double SHARPER = 6.0;

/* What is known of a problem with certain knots. */
typedef struct {
  size_t points, knots, size; /* size: parameters */
  const double *x, *y;
  double deviation; /* NAN: not known */
  size_t *interval; /* points */
  double *knot;
  band *basis;                           /* points */
  band *gram, *rough, *factor, *inverse; /* size */
  double *right, *coefficient;           /* size */
  double unit;                           /* of the roughness */
  po_arena *kept;                        /* knot and factor, which the spline takes */
  po_arena work;                         /* the others */
} problem;

static double knot_at(size_t knots, const double *knot, size_t k) { /* k + 3 of the clamped ones */
  return knot[k < ORDER - 1 ? 0 : k - (ORDER - 1) < knots ? k - (ORDER - 1) : knots - 1];
}

/* Values and slopes of the B-splines of an interval at x. Source: C. de Boor, A Practical Guide to
 * Splines, chapter X. */
static void basis_at(size_t knots, const double *knot, size_t interval, double x, band value,
                     band slope) {
  const size_t k = interval + ORDER - 1;
  value[0] = 1.0;
  for (size_t degree = 1; degree < ORDER; ++degree) {
    band next = {0}, rate = {0};
    for (size_t r = 0; r < degree; ++r) {
      const double from = knot_at(knots, knot, k + r + 1 - degree),
                   to = knot_at(knots, knot, k + r + 1), part = value[r] / (to - from);
      next[r] += (to - x) * part;
      next[r + 1] += (x - from) * part;
      rate[r] -= (double)degree * part;
      rate[r + 1] += (double)degree * part;
    }
    memcpy(value, next, sizeof next);
    memcpy(slope, rate, sizeof rate);
  }
}

static void add_square(band *matrix, size_t first, const band of, double weight) {
  for (size_t i = 0; i < ORDER; ++i)
    for (size_t j = i; j < ORDER; ++j)
      matrix[first + i][j - i] += weight * of[i] * of[j];
}

static double trace_of(size_t size, band *matrix) {
  double sum = 0.0;
  for (size_t j = 0; j < size; ++j)
    sum += matrix[j][0];
  return sum;
}

/* The matrices of both sums, and the right side. */
static void assemble(problem *p) {
  size_t k = 0;
  for (size_t i = 0; i < p->points; ++i) {
    band slope;
    while (k + 2 < p->knots && p->x[i] >= p->knot[k + 1])
      ++k;
    p->interval[i] = k;
    basis_at(p->knots, p->knot, k, p->x[i], p->basis[i], slope);
    add_square(p->gram, k, p->basis[i], 1.0);
    for (size_t j = 0; j < ORDER; ++j)
      p->right[k + j] += p->basis[i][j] * p->y[i];
  }
  for (k = 0; k + 1 < p->knots; ++k) { /* the third derivative is constant between knots */
    band f0, d0, f1, d1, third;
    const double h = p->knot[k + 1] - p->knot[k];
    basis_at(p->knots, p->knot, k, p->knot[k], f0, d0);
    basis_at(p->knots, p->knot, k, p->knot[k + 1], f1, d1);
    for (size_t j = 0; j < ORDER; ++j)
      third[j] = 6.0 * (2.0 * (f0[j] - f1[j]) / h + d0[j] + d1[j]) / (h * h);
    add_square(p->rough, k, third, h);
  }
  p->unit = trace_of(p->size, p->gram) / trace_of(p->size, p->rough);
}

static po_status pose(size_t knots, problem *p) {
  p->knots = knots;
  p->size = knots + ORDER - 2;
  po_arena *const kept = p->kept, *const work = &p->work;
  p->knot = po_arena_allocate(kept, knots, sizeof *p->knot);
  p->factor = po_arena_allocate(kept, p->size, sizeof *p->factor);
  p->interval = po_arena_allocate(work, p->points, sizeof *p->interval);
  p->basis = po_arena_allocate(work, p->points, sizeof *p->basis);
  p->gram = po_arena_allocate(work, p->size, sizeof *p->gram);
  p->rough = po_arena_allocate(work, p->size, sizeof *p->rough);
  p->inverse = po_arena_allocate(work, p->size, sizeof *p->inverse);
  p->right = po_arena_allocate(work, p->size, sizeof *p->right);
  p->coefficient = po_arena_allocate(work, p->size, sizeof *p->coefficient);
  if (kept->ran_out || work->ran_out)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < knots; ++k)
    p->knot[k] = p->x[k * (p->points - 1) / (knots - 1)];
  assemble(p);
  return PO_OK;
}

/* The factors L D L^T of the matrix with a roughness: D, and L below its diagonal. */
static void factorize(problem *p, double roughness) {
  for (size_t j = 0; j < p->size; ++j)
    for (size_t m = 0; m < ORDER; ++m)
      p->factor[j][m] = p->gram[j][m] + roughness * p->rough[j][m];
  for (size_t j = 0; j < p->size; ++j) {
    double *const row = p->factor[j];
    for (size_t m = 1; m < ORDER && j + m < p->size; ++m) {
      const double part = row[m] / row[0];
      for (size_t n = m; n < ORDER && j + n < p->size; ++n)
        p->factor[j + m][n - m] -= part * row[n];
    }
    for (size_t m = 1; m < ORDER; ++m)
      row[m] /= row[0];
  }
}

static void solve(size_t size, const double *factor, double *x) {
  const band *const f = (const band *)factor;
  for (size_t j = 0; j < size; ++j)
    for (size_t m = 1; m < ORDER && j + m < size; ++m)
      x[j + m] -= f[j][m] * x[j];
  for (size_t j = size; j-- > 0;) {
    x[j] /= f[j][0];
    for (size_t m = 1; m < ORDER && j + m < size; ++m)
      x[j] -= f[j][m] * x[j + m];
  }
}

/* The band of the inverse. Source: K. Takahashi, J. Fagan, M. S. Chin, 8th PICA Conf. (1973) 63; M.
 * F. Hutchinson, F. R. de Hoog, Numer. Math. 47 (1985) 99. */
static void invert(size_t size, const double *factor, band *inverse) {
  const band *const f = (const band *)factor;
  for (size_t i = size; i-- > 0;) {
    memset(inverse[i], 0, sizeof inverse[i]);
    for (size_t m = ORDER; m-- > 0;) {
      if (i + m >= size)
        continue;
      double sum = m == 0 ? 1.0 / f[i][0] : 0.0;
      for (size_t n = 1; n < ORDER && i + n < size; ++n)
        sum -= f[i][n] * (n <= m ? inverse[i + n][m - n] : inverse[i + m][n - m]);
      inverse[i][m] = sum;
    }
  }
}

/* Trace of the product of two symmetric bands. */
static double trace_of_product(size_t size, band *a, band *b) {
  double sum = 0.0;
  for (size_t j = 0; j < size; ++j)
    for (size_t m = 0; m < ORDER; ++m)
      sum += (m ? 2.0 : 1.0) * a[j][m] * b[j][m];
  return sum;
}

static double value_at(const problem *p, size_t point) {
  const double *const c = p->coefficient + p->interval[point], *const b = p->basis[point];
  return c[0] * b[0] + c[1] * b[1] + c[2] * b[2] + c[3] * b[3];
}

typedef struct {
  double power;      /* of the roughness */
  double score;      /* the less the better */
  double squares;    /* sum of those of the removed part */
  double parameters; /* effective number */
} fit;

static fit fit_with(problem *p, double power) {
  fit f = {.power = power};
  factorize(p, p->unit * po_pow(2.0, power));
  memcpy(p->coefficient, p->right, p->size * sizeof *p->right);
  solve(p->size, p->factor[0], p->coefficient);
  invert(p->size, p->factor[0], p->inverse);
  f.parameters = trace_of_product(p->size, p->inverse, p->gram);
  for (size_t i = 0; i < p->points; ++i) {
    const double removed = p->y[i] - value_at(p, i);
    f.squares += removed * removed;
  }
  const double counted = COUNT * f.parameters, left = (double)p->points - counted;
  f.score = isnan(p->deviation) ? f.squares / (left * left)
                                : f.squares + 2.0 * p->deviation * p->deviation * counted;
  return f;
}

static fit best_of(fit a, fit b) {
  return b.score < a.score ? b : a;
}

/* The best roughness: the least score of all steps, then halved steps on both sides of it. */
static fit fit_best(problem *p) {
  fit best = fit_with(p, ROUGHEST), next = best;
  for (double power = ROUGHEST + STEP; power <= SMOOTHEST && next.parameters > PARABOLA;
       power += STEP) {
    next = fit_with(p, power);
    best = best_of(best, next);
  }
  for (double step = 0.5 * STEP; step > ACCURACY; step *= 0.5) {
    const fit below = fit_with(p, best.power - step), above = fit_with(p, best.power + step);
    best = best_of(best_of(best, below), above);
  }
  return fit_with(p, best.power - SHARPER);
}

/* The B-splines at a knot. Returned: the interval whose they are. */
static size_t basis_at_knot(size_t knots, const double *knot, size_t k, band value, band slope) {
  const size_t interval = k + 1 < knots ? k : k - 1;
  basis_at(knots, knot, interval, knot[k], value, slope);
  return interval;
}

/* Values and slopes at the knots of a spline with given coefficients. */
static void evaluate(size_t knots, const double *knot, const double *coefficient, double *value,
                     double *slope) {
  for (size_t k = 0; k < knots; ++k) {
    band f, d;
    const double *const c = coefficient + basis_at_knot(knots, knot, k, f, d);
    value[k] = slope[k] = 0.0;
    for (size_t j = 0; j < ORDER; ++j) {
      value[k] += c[j] * f[j];
      slope[k] += c[j] * d[j];
    }
  }
}

static void take_spline(const problem *p, po_smoothing *s) {
  evaluate(p->knots, p->knot, p->coefficient, s->value, s->slope);
  for (size_t i = 0; i < p->points; ++i) {
    s->removed[i] = p->y[i] - value_at(p, i);
    s->greatest = fmax(s->greatest, fabs(s->removed[i]));
  }
}

static po_status take(const problem *p, const fit *best, po_smoothing *s) {
  s->points = p->points;
  s->knots = p->knots;
  s->parameters = best->parameters;
  s->rms = sqrt(best->squares / (double)p->points);
  s->residual = sqrt(best->squares / ((double)p->points - best->parameters));
  s->deviation = isnan(p->deviation) ? s->residual : p->deviation;
  s->value = po_arena_allocate(&s->arrays, p->knots, sizeof *s->value);
  s->slope = po_arena_allocate(&s->arrays, p->knots, sizeof *s->slope);
  s->removed = po_arena_allocate(&s->arrays, p->points, sizeof *s->removed);
  s->knot = p->knot;
  s->factor = p->factor[0];
  if (s->arrays.ran_out)
    return PO_NO_MEMORY;
  take_spline(p, s);
  return PO_OK;
}

/* The fourth divided difference of five successive points, in units of its standard deviation by
 * independent noise of deviation 1. */
static double fourth_difference(const double *x, const double *y) {
  double sum = 0.0, squares = 0.0;
  const double unit = 0.25 * (x[4] - x[0]);
  for (int j = 0; j < 5; ++j) {
    double weight = 1.0;
    for (int k = 0; k < 5; ++k)
      weight *= k == j ? 1.0 : unit / (x[j] - x[k]);
    sum += weight * y[j];
    squares += weight * weight;
  }
  return sum / sqrt(squares);
}

/* Whether more is removed than noise: the variance of the removed part is this many times that of
 * the fourth differences, to which a curve that the points resolve contributes little. */
static const double MORE_THAN_NOISE = 2.0;

static bool removes_shape(const problem *p, const fit *best) {
  const size_t differences = p->points - 4;
  double squares = 0.0;
  for (size_t i = 0; i < differences; ++i) {
    const double difference = fourth_difference(p->x + i, p->y + i);
    squares += difference * difference;
  }
  return best->squares / ((double)p->points - best->parameters) >
         MORE_THAN_NOISE * squares / (double)differences;
}

po_status po_smoothing_make(size_t points, const double *x, const double *y, double deviation,
                            po_smoothing *s) {
  *s = (po_smoothing){0};
  const size_t most = points / 2;
  for (size_t knots = FIRST_KNOTS;; knots *= 2) {
    problem p = {.points = points, .x = x, .y = y, .deviation = deviation, .kept = &s->arrays};
    knots = knots < most ? knots : most;
    po_arena_free(&s->arrays);
    po_status status = pose(knots, &p);
    bool more = false;
    if (!status) {
      const fit best = fit_best(&p);
      more = knots < most && (best.parameters > MOST_USED * (double)p.size ||
                              (isnan(deviation) && removes_shape(&p, &best)));
      status = more ? PO_OK : take(&p, &best, s);
    }
    po_arena_free(&p.work);
    if (!more)
      return status;
  }
}

void po_smoothing_free(po_smoothing *s) {
  po_arena_free(&s->arrays);
  *s = (po_smoothing){0};
}

po_status po_smoothing_deviation(const po_smoothing *s, double *by_value, double *by_slope,
                                 double *deviation) {
  const size_t size = s->knots + ORDER - 2;
  double *room = po_allocate(2 * size, sizeof *room);
  if (!room)
    return PO_NO_MEMORY;
  double *const weight = room, *const covariance = room + size;
  for (size_t k = 0; k < s->knots; ++k) {
    band f, d;
    double *const w = weight + basis_at_knot(s->knots, s->knot, k, f, d);
    for (size_t j = 0; j < ORDER; ++j)
      w[j] += by_value[k] * f[j] + by_slope[k] * d[j];
  }
  memcpy(covariance, weight, size * sizeof *weight);
  solve(size, s->factor, covariance);
  double variance = 0.0;
  for (size_t j = 0; j < size; ++j)
    variance += weight[j] * covariance[j];
  for (size_t j = 0; j < size; ++j)
    covariance[j] *= variance > 0.0 ? s->deviation / sqrt(variance) : 0.0;
  evaluate(s->knots, s->knot, covariance, by_value, by_slope);
  *deviation = s->deviation * sqrt(variance);
  free(room);
  return PO_OK;
}

po_status po_smoothing_uncertainty(const po_smoothing *s, double *greatest) {
  const size_t size = s->knots + ORDER - 2;
  band *inverse = po_allocate(size, sizeof *inverse);
  if (!inverse)
    return PO_NO_MEMORY;
  invert(size, s->factor, inverse);
  *greatest = 0.0;
  for (size_t k = 0; k < s->knots; ++k) {
    band f, d;
    const size_t first = basis_at_knot(s->knots, s->knot, k, f, d);
    double variance = 0.0;
    for (size_t i = 0; i < ORDER; ++i)
      for (size_t j = i; j < ORDER; ++j)
        variance += (i == j ? 1.0 : 2.0) * f[i] * f[j] * inverse[first + i][j - i];
    *greatest = fmax(*greatest, s->deviation * sqrt(variance));
  }
  free(inverse);
  return PO_OK;
}
