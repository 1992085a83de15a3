/* Source: Y. Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., SIAM 2003, Sec. 6.5. The
 * vectors of the basis are orthogonalised twice. */
#include "po_krylov.h"

#include <math.h>
#include <string.h>

#include "po_deadline.h"
#include "po_elementary.h"
#include "po_linear.h"

enum { MOST = PO_KRYLOV_DEPTH };

/* The least-squares problem of GMRES: the Hessenberg matrix, made triangular by rotations. */
typedef struct {
  size_t count;
  double triangle[MOST][MOST]; /* columns */
  double cosine[MOST], sine[MOST];
  double right[MOST + 1]; /* the modulus of the last is the residual */
  double last;            /* the diagonal element before its rotation */
  int sign;               /* of the determinant without the last column */
} least_squares;

static double *basis_vector(const po_equilibrium *e, size_t k) {
  return e->krylov + k * (e->n + 1);
}

/* v /= unit, by components; v is then relative to the law's length. */
static void divide(size_t size, const double *unit, double *v) {
  for (size_t j = 0; j < size; ++j)
    v[j] /= unit[j];
}

static void divide_by_length(size_t size, double length, double *v) {
  for (size_t j = 0; j < size; ++j)
    v[j] /= length;
}

static double length_of(size_t size, const double *v) {
  return sqrt(po_linear_dot(size, v, v));
}

/* The product of preconditioned Jacobian and vector `count` of the basis, less its components along
 * the vectors so far. Given: work, n + 1. Returned: the next vector, not yet of length 1; its
 * components in `column`. */
static void extend_basis(po_equilibrium *e, size_t count, double *work, double *column) {
  const size_t size = e->n + 1;
  const double *from = basis_vector(e, count), *scale = e->secant.scale;
  double *to = basis_vector(e, count + 1);
  for (size_t j = 0; j < size; ++j)
    work[j] = from[j] * scale[j];
  po_equilibrium_multiply(e, work, e->deflection);
  po_equilibrium_precondition(e, e->deflection, to);
  divide(size, scale, to);
  memset(column, 0, (count + 1) * sizeof *column);
  for (int again = 0; again < 2; ++again)
    for (size_t i = 0; i <= count; ++i) {
      const double along = po_linear_dot(size, basis_vector(e, i), to);
      column[i] += along;
      po_linear_add(size, -along, basis_vector(e, i), to);
    }
}

/* Adds a column of the Hessenberg matrix, in triangle[count], with the element `below` under its
 * diagonal. */
static void add_column(least_squares *s, double below) {
  const size_t m = s->count++;
  double *column = s->triangle[m];
  for (size_t i = 0; i < m; ++i) {
    const double upper = column[i], lower = column[i + 1];
    column[i] = s->cosine[i] * upper + s->sine[i] * lower;
    column[i + 1] = s->cosine[i] * lower - s->sine[i] * upper;
  }
  s->last = column[m]; /* the diagonal elements before are lengths, which are positive */
  column[m] = po_hypot(s->last, below);
  s->cosine[m] = s->last / column[m];
  s->sine[m] = below / column[m];
  s->right[m + 1] = -s->sine[m] * s->right[m];
  s->right[m] *= s->cosine[m];
}

/* Sets x to the solution. */
static void combine(const po_equilibrium *e, least_squares *s, double *x) {
  const size_t size = e->n + 1;
  memset(x, 0, size * sizeof *x);
  for (size_t k = s->count; k-- > 0;) {
    const double y = s->right[k] / s->triangle[k][k];
    for (size_t i = 0; i < k; ++i)
      s->right[i] -= y * s->triangle[k][i];
    po_linear_add(size, y, basis_vector(e, k), x);
  }
  for (size_t j = 0; j < size; ++j)
    x[j] *= e->secant.scale[j];
}

po_status po_krylov_solve(po_equilibrium *e, const double *right, double precision, double *x) {
  const size_t size = e->n + 1;
  least_squares s = {.last = 1.0};
  po_secant_drop(&e->secant);
  po_equilibrium_precondition(e, right, basis_vector(e, 0));
  divide(size, e->secant.scale, basis_vector(e, 0));
  const double whole = s.right[0] = length_of(size, basis_vector(e, 0));
  double length = whole;
  while (fabs(s.right[s.count]) > precision * whole) {
    const po_status stopped = po_deadline_check();
    if (stopped)
      return stopped;
    if (s.count == MOST)
      return PO_NOT_CONVERGED;
    divide_by_length(size, length, basis_vector(e, s.count));
    extend_basis(e, s.count, x, s.triangle[s.count]);
    length = length_of(size, basis_vector(e, s.count + 1));
    add_column(&s, length);
  }
  if (!isfinite(whole) || !isfinite(s.right[s.count]))
    return PO_NOT_CONVERGED;
  combine(e, &s, x);
  if (s.last < 0.0)
    e->secant.sign = -1;
  return PO_OK;
}
