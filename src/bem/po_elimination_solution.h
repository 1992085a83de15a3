/* Solution with the factors of po_elimination.c, which includes this file once for each precision.
 * Given as macros: REAL, the type of the factors; IN_REAL(name), the name in this precision; for
 * matrices of 16 rows, APPLY(columns, a, x, start, y): y = start + A x, and
 * APPLY_TRANSPOSED(columns, a, x, y): y += A^T x. */

static const REAL IN_REAL(zero)[K];

typedef struct {
  REAL border[K];      /* sum of border x = sum + border . w */
  REAL field[K], z[K]; /* of a solution */
  double sum;          /* of a solution: the sum of border x at zero field */
} IN_REAL(state);

/* The matrices of all cells, and parts of the skeleton. */
typedef struct {
  size_t room; /* cells for which there is memory */
  REAL *matrix;
  IN_REAL(state) * cell;
  REAL value[K * K], from_parent[2][K * K], to_parent[2][K * K];
} IN_REAL(factors);

/* Copies a matrix of 12 or 16 rows to one of 16. */
static void IN_REAL(copy)(size_t rows, size_t columns, const double *from, REAL *to) {
  for (size_t j = 0; j < columns; ++j) {
    for (size_t i = 0; i < rows; ++i)
      to[i + K * j] = (REAL)from[i + rows * j];
    for (size_t i = rows; i < K; ++i)
      to[i + K * j] = (REAL)0;
  }
}

static void IN_REAL(set_skeleton)(const po_skeleton *s, IN_REAL(factors) * f) {
  IN_REAL(copy)(N, K, s->value, f->value);
  for (int half = 0; half < 2; ++half) {
    IN_REAL(copy)(K, K, s->from_parent[half], f->from_parent[half]);
    IN_REAL(copy)(K, K, s->to_parent[half], f->to_parent[half]);
  }
}

static void IN_REAL(free)(IN_REAL(factors) * f) {
  free(f->matrix);
  free(f->cell);
}

static po_status IN_REAL(reserve)(size_t cells, IN_REAL(factors) * f) {
  if (cells <= f->room)
    return PO_OK;
  IN_REAL(free)(f);
  f->room = cells + cells / 2;
  f->matrix = po_reserve(f->room * CELL_SIZE, sizeof *f->matrix);
  f->cell = po_reserve(f->room, sizeof *f->cell);
  if (f->matrix && f->cell)
    return PO_OK;
  f->room = 0;
  return PO_NO_MEMORY;
}

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
