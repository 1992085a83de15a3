/* Solution with the factors of po_elimination.c, which includes this file once for each precision.
 * Given as macros, beside those of po_elimination_factors.h: for matrices of 16 rows,
 * APPLY(columns, a, x, start, y): y = start + A x, and
 * APPLY_TRANSPOSED(columns, a, x, y): y += A^T x. */

/* y = start + A x with a matrix of a cell. */
static void IN_REAL(apply)(const IN_REAL(factors) * f, size_t cell, enum part part, const REAL *x,
                           const REAL *start, REAL *y) {
  APPLY(K, f->matrix + cell * CELL_SIZE + part, x, start, y);
}

static double IN_REAL(dot)(const REAL *x, const REAL *y) {
  double sum = 0.0;
  for (int k = 0; k < K; ++k)
    sum += (double)x[k] * (double)y[k];
  return sum;
}

/* The border of a panel as a function of the field on it. Given: to, the border; returned there:
 * the transpose of I + CHANGE times it. */
static void IN_REAL(set_panel_border)(IN_REAL(factors) * f, size_t c, bool is_quiet, double *to) {
  const REAL *matrix = f->matrix + c * CELL_SIZE;
  REAL border[K], change[N] = {(REAL)0};
  IN_REAL(copy)(N, 1, to, border);
  memset(f->cell[c].border, 0, sizeof f->cell[c].border);
  APPLY_TRANSPOSED(K, is_quiet ? f->value : matrix + ALONG, border, f->cell[c].border);
  if (is_quiet)
    return;
  APPLY_TRANSPOSED(N, matrix + CHANGE, border, change);
  for (int j = 0; j < N; ++j)
    to[j] += (double)change[j];
}

static void IN_REAL(set_border)(IN_REAL(factors) * f, size_t c, size_t right, bool is_quiet) {
  const REAL *matrix = f->matrix + c * CELL_SIZE;
  REAL *border = f->cell[c].border;
  memset(border, 0, sizeof f->cell[c].border);
  APPLY_TRANSPOSED(K, is_quiet ? f->from_parent[0] : matrix + ALONG, f->cell[c + 1].border, border);
  APPLY_TRANSPOSED(K, is_quiet ? f->from_parent[1] : matrix + ALONG_RIGHT, f->cell[right].border,
                   border);
}

/* The moments of a panel, and the sum of its border, at zero field. Given: x, its right-hand side.
 */
static void IN_REAL(begin_panel)(IN_REAL(factors) * f, size_t c, bool is_quiet, const double *x) {
  REAL right[K];
  if (is_quiet)
    return;
  IN_REAL(copy)(N, 1, x, right);
  APPLY(N, f->matrix + c * CELL_SIZE + MOMENTS, right, IN_REAL(zero), f->cell[c].z);
}

/* From the halves of a cell: its moments, the sum of its border, and the fields on its halves, at
 * zero field on the cell. */
static void IN_REAL(join)(IN_REAL(factors) * f, size_t c, size_t right_half, bool has_left,
                          bool has_right) {
  IN_REAL(state) *own = f->cell + c, *left = own + 1, *right = f->cell + right_half;
  own->sum = left->sum + right->sum;
  if (!has_left && !has_right)
    return;
  const REAL *zero = IN_REAL(zero), *moments = zero;
  if (has_left && has_right) {
    REAL with[K]; /* z_2 + Z_2 S^T z_1 */
    IN_REAL(apply)(f, c, BACK, left->z, zero, right->field);
    IN_REAL(apply)(f, right_half, RELATION, right->field, right->z, with);
    IN_REAL(apply)(f, c, ACROSS, with, zero, left->field);
  } else if (has_right) {
    IN_REAL(apply)(f, c, ACROSS, right->z, zero, left->field);
  } else {
    memset(left->field, 0, sizeof left->field);
  }
  if (has_left) {
    IN_REAL(apply)(f, c + 1, RELATION, left->field, left->z, left->z);
    IN_REAL(apply)(f, c, BACK, left->z, zero, right->field);
    APPLY(K, f->to_parent[0], left->z, zero, own->z);
    moments = own->z;
  } else {
    memset(right->field, 0, sizeof right->field);
  }
  if (has_right) {
    IN_REAL(apply)(f, right_half, RELATION, right->field, right->z, right->z);
    APPLY(K, f->to_parent[1], right->z, moments, own->z);
  }
  own->sum += IN_REAL(dot)(left->border, left->field) + IN_REAL(dot)(right->border, right->field);
}

/* Adds the field of a cell to those of its halves, or carries it to them if the cell is quiet. */
static void IN_REAL(split)(IN_REAL(factors) * f, size_t c, size_t right_half, bool is_quiet) {
  const REAL *field = f->cell[c].field;
  IN_REAL(state) *left = f->cell + c + 1, *right = f->cell + right_half;
  if (!is_quiet) {
    IN_REAL(apply)(f, c, ALONG, field, left->field, left->field);
    IN_REAL(apply)(f, c, ALONG_RIGHT, field, right->field, right->field);
    return;
  }
  APPLY(K, f->from_parent[0], field, IN_REAL(zero), left->field);
  APPLY(K, f->from_parent[1], field, IN_REAL(zero), right->field);
}

/* From the field on a panel and its right-hand side in x: its unknowns. */
static void IN_REAL(finish_panel)(const IN_REAL(factors) * f, size_t c, bool is_quiet, double *x) {
  const REAL *matrix = f->matrix + c * CELL_SIZE;
  REAL right[K], change[K];
  const REAL *start = IN_REAL(zero);
  if (!is_quiet) {
    IN_REAL(copy)(N, 1, x, right);
    APPLY(N, matrix + CHANGE, right, start, change);
    start = change;
  }
  APPLY(K, is_quiet ? f->value : matrix + ALONG, f->cell[c].field, start, change);
  for (int j = 0; j < N; ++j)
    x[j] += (double)change[j];
}
