/* Factors of po_elimination.c, which includes this file once for each precision. Given as macros:
 * REAL, the type of the factors; IN_REAL(name), the name in this precision; for matrices of 16
 * rows, MULTIPLY(inner, columns, a, b, start, c): C = start + A B. */

static const REAL IN_REAL(zero)[K * K];

typedef struct {
  REAL border[K];      /* border . x of the cell = sum + border . w, w its field */
  REAL field[K], z[K]; /* of a solution */
  double sum;          /* of a solution: border . x of the cell at zero field w */
} IN_REAL(state);

/* The matrices of all cells, and parts of the skeleton. */
typedef struct {
  size_t room; /* cells for which there is memory */
  REAL *matrix;
  IN_REAL(state) * cell;
  REAL value[K * K], moment[K * K], from_parent[2][K * K], to_parent[2][K * K];
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
  IN_REAL(copy)(K, N, s->moment, f->moment);
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

static REAL *IN_REAL(at)(const IN_REAL(factors) * f, size_t cell, enum part part) {
  return f->matrix + cell * CELL_SIZE + part;
}

/* The relation of a panel, and its parts of a solution. Given: own, the block of the panel; weight,
 * of its nodes; rule, those on the unit interval; factor, of its nodes. Returned: the sign of the
 * determinant of its own equations; *growth, of their inverse. */
static int IN_REAL(factorize_panel)(IN_REAL(factors) * f, size_t c, const double *own,
                                    const double *weight, const double *rule, const double *factor,
                                    double *growth) {
  double inverse[N * N];
  REAL change[K * N], moment[K * N];
  for (int j = 0; j < N; ++j) {
    const REAL charge = (REAL)(weight[j] / rule[j] * factor[j]);
    for (int i = 0; i < N; ++i)
      inverse[i + N * j] = (i == j ? 1.0 : 0.0) - own[i + N * j] * factor[j];
    for (int i = 0; i < K; ++i)
      moment[i + K * j] = charge * f->moment[i + K * j];
  }
  const int sign = invert(N, inverse, growth);
  IN_REAL(copy)(N, N, inverse, change);
  MULTIPLY(N, K, change, f->value, IN_REAL(zero), IN_REAL(at)(f, c, ALONG));
  MULTIPLY(N, N, moment, change, IN_REAL(zero), IN_REAL(at)(f, c, MOMENTS));
  MULTIPLY(N, K, IN_REAL(at)(f, c, MOMENTS), f->value, IN_REAL(zero), IN_REAL(at)(f, c, RELATION));
  for (int j = 0; j < N; ++j)
    inverse[j + N * j] -= 1.0;
  IN_REAL(copy)(N, N, inverse, IN_REAL(at)(f, c, CHANGE));
  return sign;
}

/* The inverse of I - A B. Returned: the sign of its determinant; *growth, of the inverse. */
static int IN_REAL(invert_less)(const REAL *a, const REAL *b, REAL *result, double *growth) {
  double inverse[K * K];
  REAL product[K * K];
  MULTIPLY(K, K, a, b, IN_REAL(zero), product);
  for (int k = 0; k < K * K; ++k)
    inverse[k] = (k % (K + 1) == 0 ? 1.0 : 0.0) - (double)product[k];
  const int sign = invert(K, inverse, growth);
  IN_REAL(copy)(K, K, inverse, result);
  return sign;
}

/* As above, for a cell whose halves are factorised. Given: across, the kernel between their
 * skeleton nodes; the halves that are not quiet, one at least. */
static int IN_REAL(factorize_halves)(IN_REAL(factors) * f, size_t c, size_t right,
                                     const double *across, bool has_left, bool has_right,
                                     double *growth) {
  const REAL *zero = IN_REAL(zero), *z_1 = IN_REAL(at)(f, c + 1, RELATION);
  const REAL *z_2 = IN_REAL(at)(f, right, RELATION), *start = f->from_parent[0];
  REAL *along = IN_REAL(at)(f, c, ALONG), *along_right = IN_REAL(at)(f, c, ALONG_RIGHT);
  REAL *back = IN_REAL(at)(f, c, BACK), *relation = IN_REAL(at)(f, c, RELATION);
  REAL to_left[K * K], to_right[K * K], inverse[K * K], work[K * K], forth[K * K];
  int sign = 1;
  IN_REAL(copy)(K, K, across, forth);
  for (int j = 0; j < K; ++j)
    for (int i = 0; i < K; ++i)
      back[j + K * i] = forth[i + K * j];
  if (has_right) {
    MULTIPLY(K, K, forth, z_2, zero, to_left);
    MULTIPLY(K, K, to_left, f->from_parent[1], start, work);
    start = work;
  }
  if (has_left)
    MULTIPLY(K, K, back, z_1, zero, to_right);
  if (has_left && has_right) {
    sign = IN_REAL(invert_less)(to_left, to_right, inverse, growth);
    MULTIPLY(K, K, inverse, start, zero, along);
    MULTIPLY(K, K, inverse, forth, zero, IN_REAL(at)(f, c, ACROSS));
  } else {
    memcpy(along, start, K * K * sizeof *along);
    memcpy(IN_REAL(at)(f, c, ACROSS), forth, sizeof forth);
  }
  start = zero;
  if (has_left) {
    MULTIPLY(K, K, to_right, along, f->from_parent[1], along_right);
    MULTIPLY(K, K, z_1, along, zero, work);
    MULTIPLY(K, K, f->to_parent[0], work, zero, relation);
    start = relation;
  } else {
    memcpy(along_right, f->from_parent[1], K * K * sizeof *along_right);
  }
  if (has_right) {
    MULTIPLY(K, K, z_2, along_right, zero, work);
    MULTIPLY(K, K, f->to_parent[1], work, start, relation);
  }
  return sign;
}
