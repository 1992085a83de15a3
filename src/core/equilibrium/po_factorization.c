/* The factors of the bordered Jacobian of Eq 15, and the linear systems that they solve: of the
 * active nodes of rings and triangles here, of panels in po_elimination.c. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_deadline.h"
#include "po_equilibrium.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_order.h"

/* Sum of the measures of the nodes that are not factorised. It costs about one iteration and saves
 * most of the matrix. */
static const double NEGLECT = 5e-3;

/* Gain of rounding above which less is neglected, in inverse proportion, and above which the
 * factors of rings and triangles are in double precision. */
static const double GAIN_OF_NEGLECT = 10.0, GAIN_OF_DOUBLE = 30.0;

/* Factors are coarse if more was neglected than this multiple of what their gain allows. */
static const double COARSE = 3.0;

/* Starts a new matrix of order n. Returned: false if memory runs out. */
static bool begin_matrix(po_factors *f, size_t n) {
  f->n = n;
  f->is_double = f->in_double;
  if (f->is_double) {
    f->wide = po_reserve_matrix(f->wide, &f->wide_room, n, sizeof *f->wide);
    return f->wide;
  }
  f->matrix = po_reserve_matrix(f->matrix, &f->room, n, sizeof *f->matrix);
  return f->matrix;
}

static void put_column(po_factors *f, size_t column, const double *values) {
  if (f->is_double) {
    memcpy(f->wide + f->n * column, values, f->n * sizeof *values);
    return;
  }
  float *to = f->matrix + f->n * column;
  for (size_t i = 0; i < f->n; ++i)
    to[i] = (float)values[i];
}

static po_status compute_factors(po_factors *f) {
  return f->is_double ? po_linear_factorize(f->n, f->wide, f->n, f->pivots)
                      : po_linear_factorize_single(f->n, f->matrix, f->n, f->pivots);
}

/* The sign of the determinant. */
static int sign_of_factors(const po_factors *f) {
  int sign = 1;
  for (size_t i = 0; i < f->n; ++i) { /* pivot indices start from 1 */
    const size_t diagonal = i + f->n * i;
    const bool negative = f->is_double ? f->wide[diagonal] < 0.0 : f->matrix[diagonal] < 0.0F;
    if ((f->pivots[i] != (int)i + 1) != negative)
      sign = -sign;
  }
  return sign;
}

/* Solves the linear system. Accuracy: about six digits, less those that the condition number of the
 * matrix costs. */
static void solve_with(po_factors *f, double *x) {
  if (f->is_double) {
    po_linear_solve(f->n, f->wide, f->n, f->pivots, x);
    return;
  }
  double scale = 0.0; /* scaling prevents overflow and underflow in single precision */
  for (size_t i = 0; i < f->n; ++i)
    scale = fmax(scale, fabs(x[i]));
  if (scale == 0.0)
    return;
  for (size_t i = 0; i < f->n; ++i)
    f->right[i] = (float)(x[i] / scale);
  po_linear_solve_single(f->n, f->matrix, f->n, f->pivots, f->right);
  for (size_t i = 0; i < f->n; ++i)
    x[i] = scale * (double)f->right[i];
}

static int by_measure(const void *left, const void *right, void *data) {
  const double *measure = data;
  const double a = measure[*(const size_t *)left], b = measure[*(const size_t *)right];
  return (a < b) - (a > b);
}

/* Sorts the first `count` entries of the index by their measure, descending; equal measures by
 * index. Returned: how many there are
 * without the last whose measures add up to `neglect`. */
static size_t sort_active(po_equilibrium *e, size_t count) {
  for (size_t k = 0; k < count; ++k)
    e->index[k] = k;
  po_order_sort(e->index, count, sizeof *e->index, by_measure, e->measure, e->scratch);
  double left_out = 0.0;
  for (; count > 0; --count) {
    left_out += e->measure[e->index[count - 1]];
    if (!(left_out <= e->neglect))
      break;
  }
  return count;
}

/* The measure of a node: the largest change of a gap by a change of its own. */
static double measure_of(const po_equilibrium *e, size_t j) {
  return e->coupling * fabs(e->slope[j]) * e->surface->reach[j];
}

static void choose_active(po_equilibrium *e) {
  for (size_t j = 0; j < e->n; ++j)
    e->measure[j] = measure_of(e, j);
  e->active = sort_active(e, e->n);
}

/* The border as the last row of the matrix of the active nodes, active + 1 values. The gaps of the
 * other nodes are eliminated by their own linearised equations,
 *
 *   dH_i = -d(approach) + coupling * sum_j G_ij p'(H_j) dH_j,   j active,
 *
 * which distributes their part of the border to the active nodes and the approach. */
static void fill_row(po_equilibrium *e, double *row) {
  const size_t m = e->active;
  row[m] = e->border[e->n];
  memset(e->scratch, 0, e->n * sizeof *e->scratch);
  for (size_t b = m; b < e->n; ++b) {
    e->scratch[e->index[b]] = e->border[e->index[b]];
    row[m] -= e->border[e->index[b]];
  }
  po_surface_apply_transposed(e->surface, e->scratch, e->right);
  for (size_t b = 0; b < m; ++b) {
    const size_t j = e->index[b];
    row[b] = e->border[j] + e->coupling * e->slope[j] * e->right[j];
  }
}

/* Assembles the bordered Jacobian of Eq 15 for the active nodes, column by column. */
static po_status assemble(po_equilibrium *e) {
  const size_t m = e->active;
  fill_row(e, e->row);
  e->changed = false;
  if (!begin_matrix(&e->factors, m + 1))
    return PO_NO_MEMORY;
  for (size_t b = 0; b < m; ++b) {
    const size_t j = e->index[b];
    const double *influence = e->surface->influence + e->n * j;
    const double factor = e->coupling * e->slope[j];
    for (size_t a = 0; a < m; ++a)
      e->column[a] = -factor * influence[e->index[a]];
    e->column[b] += 1.0;
    e->column[m] = e->row[b];
    put_column(&e->factors, b, e->column);
  }
  for (size_t a = 0; a < m; ++a)
    e->column[a] = 1.0;
  e->column[m] = e->row[m];
  put_column(&e->factors, m, e->column);
  return PO_OK;
}

/* Replaces the border of the factors. Returned: the determinant over that before. */
static double change_row(po_equilibrium *e) {
  const size_t m = e->active;
  fill_row(e, e->change);
  memset(e->response, 0, m * sizeof *e->response);
  e->response[m] = 1.0;
  solve_with(&e->factors, e->response);
  e->pivot = 1.0;
  for (size_t k = 0; k <= m; ++k) {
    e->change[k] -= e->row[k];
    e->pivot += e->change[k] * e->response[k];
  }
  e->changed = true;
  return e->pivot;
}

void po_equilibrium_change_border(po_equilibrium *e, const double *border) {
  memcpy(e->border, border, (e->n + 1) * sizeof *border);
  e->weak_count = 0;
  const double ratio =
      e->elimination ? po_elimination_border(e->elimination, border) / e->pivot : change_row(e);
  e->factorized = ratio > PO_LEAST_DETERMINANT;
}

static po_status factorize_dense(po_equilibrium *e) {
  choose_active(e);
  po_status status = assemble(e);
  if (!status)
    status = compute_factors(&e->factors);
  e->orientation = status ? 0 : sign_of_factors(&e->factors);
  return status;
}

/* Panels whose measures add up to `neglect` are left out of the factors. */
static po_status factorize_panels(po_equilibrium *e) {
  const size_t panels = e->n / PO_TABLE_ORDER;
  for (size_t k = 0; k < panels; ++k) {
    e->measure[k] = 0.0;
    for (size_t j = k * PO_TABLE_ORDER; j < (k + 1) * PO_TABLE_ORDER; ++j)
      e->measure[k] += measure_of(e, j);
  }
  const size_t active = sort_active(e, panels);
  e->active = active * PO_TABLE_ORDER;
  memset(e->scratch, 0, e->n * sizeof *e->scratch);
  const double factor = e->coupling * e->surface->core_radius;
  for (size_t k = 0; k < active; ++k)
    for (size_t j = e->index[k] * PO_TABLE_ORDER, i = 0; i < PO_TABLE_ORDER; ++i)
      e->scratch[j + i] = factor * e->slope[j + i];
  const po_status status = po_elimination_factorize(e->elimination, e->scratch);
  if (status)
    return status;
  e->pivot = po_elimination_border(e->elimination, e->border);
  e->orientation =
      e->pivot < 0.0 ? -po_elimination_sign(e->elimination) : po_elimination_sign(e->elimination);
  return e->pivot != 0.0 ? PO_OK : PO_SINGULAR;
}

static double neglect_of(const po_equilibrium *e) {
  return NEGLECT * fmin(1.0, GAIN_OF_NEGLECT / e->gain);
}

bool po_equilibrium_is_coarse(const po_equilibrium *e) {
  const bool is_double = e->elimination || e->factors.is_double;
  return (e->gain > GAIN_OF_DOUBLE && !is_double) || e->neglect > COARSE * neglect_of(e);
}

po_status po_equilibrium_factorize(po_equilibrium *e, const double *state, const double *border) {
  const po_status stopped = po_deadline_check();
  if (stopped)
    return stopped;
  po_equilibrium_evaluate(e, state);
  if (border != e->border)
    memcpy(e->border, border, (e->n + 1) * sizeof *border);
  po_secant_clear(&e->secant, e->n + 1);
  for (size_t j = 0; j < e->n; ++j)
    e->secant.scale[j] = po_law_size(&e->scene->law, state[j]);
  e->weak_count = 0;
  e->neglect = neglect_of(e);
  e->factors.in_double = e->gain > GAIN_OF_DOUBLE;
  const po_status status = e->elimination ? factorize_panels(e) : factorize_dense(e);
  e->factorized = !status;
  const size_t order = e->active + 1;
  ++e->work.factorizations;
  if (order > e->work.factorized_nodes)
    e->work.factorized_nodes = order;
  return status;
}

void po_equilibrium_precondition(po_equilibrium *e, const double *residual, double *change) {
  const size_t n = e->n, m = e->active;
  double *right = e->right;
  if (e->elimination) {
    memcpy(change, residual, (n + 1) * sizeof *change);
    po_elimination_solve(e->elimination, change);
    for (size_t k = 0; k < e->weak_count * (n + 1); k += n + 1)
      po_linear_add(n + 1, po_linear_dot(n + 1, e->weak_functional + k, change), e->weak + k,
                    change);
    return;
  }
  for (size_t a = 0; a < m; ++a)
    right[a] = residual[e->index[a]];
  right[m] = residual[n];
  solve_with(&e->factors, right);
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

void po_equilibrium_multiply(po_equilibrium *e, const double *change, double *product) {
  const size_t n = e->n;
  for (size_t j = 0; j < n; ++j)
    e->right[j] = e->slope[j] * change[j];
  po_equilibrium_deflect(e, e->right, product);
  for (size_t i = 0; i < n; ++i)
    product[i] = change[i] + change[n] - product[i];
  product[n] = po_linear_dot(n + 1, e->border, change);
}
