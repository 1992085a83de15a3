#include "po_elimination.h"

#include <stdlib.h>
#include <string.h>

#include "po_linear.h"
#include "po_memory.h"
#include "po_skeleton.h"

enum { N = PO_TABLE_ORDER, K = PO_SKELETON_NODES };

/* The matrices of a cell, by their places among its values. All have 16 rows; those of a panel with
 * 12 end with rows of zeros. In a panel, for the right-hand side r and the field w on it:
 *
 *   x = r + CHANGE r + ALONG w,   z = MOMENTS r + RELATION w
 *
 * In other cells, for the relations of the halves:
 *
 *   w_1 = ALONG w + ACROSS (z_2 + Z_2 S^T z_1),   w_2 = ALONG_RIGHT w + ...,
 *   ACROSS = (I - S Z_2 S^T Z_1)^-1 S,   BACK = S^T,   RELATION = Z.
 */
enum part {
  RELATION = 0,
  ALONG = K * K,
  CHANGE = 2 * K * K,
  MOMENTS = 3 * K * K,
  ALONG_RIGHT = CHANGE,
  ACROSS = MOMENTS,
  BACK = 4 * K * K,
  CELL_SIZE = 5 * K * K
};

static const double ZERO[K * K];

typedef struct {
  double border[K];      /* border . x of the cell = sum + border . w, w its field */
  double field[K], z[K]; /* of a solution */
  double sum;            /* of a solution: border . x of the cell at zero field w */
  bool is_quiet;         /* Z = 0 */
} cell_state;

struct po_elimination {
  const po_hierarchy *hierarchy;
  const po_skeleton *skeleton;
  double value[K * K]; /* that of the skeleton, with rows of zeros */
  size_t room;         /* cells for which there is memory */
  po_arena cells;      /* the arrays of the cells, which follow */
  double *matrix;      /* of all cells */
  cell_state *state;
  double *border; /* 12 a panel: the transpose of I + CHANGE times the border */
  double *factor; /* 12 a panel: the factors of the matrix */
  int sign;
  double tail_border[N]; /* border of the panel to infinity */
  double pivot;
};

/* Copies a matrix of 12 rows to one of 16. */
static void widen(size_t columns, const double *from, double *to) {
  for (size_t j = 0; j < columns; ++j) {
    memcpy(to + K * j, from + N * j, N * sizeof *to);
    memset(to + K * j + N, 0, (K - N) * sizeof *to);
  }
}

po_status po_elimination_create(const po_hierarchy *hierarchy, po_elimination **elimination) {
  po_elimination *e = *elimination = po_allocate(1, sizeof *e);
  if (!e)
    return PO_NO_MEMORY;
  e->hierarchy = hierarchy;
  e->skeleton = hierarchy->table->skeleton;
  widen(K, e->skeleton->value, e->value);
  return PO_OK;
}

void po_elimination_destroy(po_elimination *e) {
  if (!e)
    return;
  po_arena_free(&e->cells);
  free(e);
}

static po_status reserve(po_elimination *e, size_t cells) {
  if (cells <= e->room)
    return PO_OK;
  po_arena_free(&e->cells);
  const size_t room = cells + cells / 2;
  e->matrix = po_arena_reserve(&e->cells, room * CELL_SIZE, sizeof *e->matrix);
  e->state = po_arena_reserve(&e->cells, room, sizeof *e->state);
  e->border = po_arena_allocate(&e->cells, room * N, sizeof *e->border);
  e->factor = po_arena_allocate(&e->cells, room * N, sizeof *e->factor);
  e->room = e->cells.ran_out ? 0 : room;
  return e->cells.ran_out ? PO_NO_MEMORY : PO_OK;
}

static double *at(const po_elimination *e, size_t cell, enum part part) {
  return e->matrix + cell * CELL_SIZE + part;
}

/* The relation of a panel, and its parts of a solution. Returned: the sign of the determinant of
 * its own equations; 0 if they are singular. */
static int factorize_panel(po_elimination *e, size_t c, size_t panel) {
  const double *own = e->hierarchy->own[panel];
  const double *weight = e->hierarchy->weight + panel * N;
  const double *rule = e->hierarchy->table->rule.weight, *factor = e->factor + panel * N;
  double inverse[N * N], change[K * N], moment[K * N];
  e->state[c].is_quiet = true;
  for (int j = 0; j < N; ++j)
    e->state[c].is_quiet = e->state[c].is_quiet && factor[j] == 0.0;
  if (e->state[c].is_quiet)
    return 1;
  for (int j = 0; j < N; ++j) {
    const double charge = weight[j] / rule[j] * factor[j];
    for (int i = 0; i < N; ++i)
      inverse[i + N * j] = (i == j ? 1.0 : 0.0) - own[i + N * j] * factor[j];
    for (int i = 0; i < K; ++i)
      moment[i + K * j] = charge * e->skeleton->moment[i + K * j];
  }
  const int sign = po_block_invert(N, inverse);
  widen(N, inverse, change);
  po_block_multiply(N, K, change, e->value, ZERO, at(e, c, ALONG));
  po_block_multiply(N, N, moment, change, ZERO, at(e, c, MOMENTS));
  po_block_multiply(N, K, at(e, c, MOMENTS), e->value, ZERO, at(e, c, RELATION));
  for (int j = 0; j < N; ++j)
    inverse[j + N * j] -= 1.0;
  widen(N, inverse, at(e, c, CHANGE));
  return sign;
}

/* The inverse of I - A B. Returned: the sign of its determinant. */
static int invert_less(const double *a, const double *b, double *result) {
  po_block_multiply(K, K, a, b, ZERO, result);
  for (int k = 0; k < K * K; ++k)
    result[k] = (k % (K + 1) == 0 ? 1.0 : 0.0) - result[k];
  return po_block_invert(K, result);
}

/* As above, for a cell whose halves are factorised. */
static int factorize_halves(po_elimination *e, size_t c, size_t right) {
  const bool has_left = !e->state[c + 1].is_quiet, has_right = !e->state[right].is_quiet;
  const double *forth = e->hierarchy->halves[c];
  const po_skeleton *s = e->skeleton;
  const double *z_1 = at(e, c + 1, RELATION), *z_2 = at(e, right, RELATION);
  const double *start = s->from_parent[0];
  double *along = at(e, c, ALONG), *along_right = at(e, c, ALONG_RIGHT), *back = at(e, c, BACK);
  double *relation = at(e, c, RELATION);
  double to_left[K * K], to_right[K * K], inverse[K * K], work[K * K];
  int sign = 1;
  e->state[c].is_quiet = !has_left && !has_right;
  if (e->state[c].is_quiet)
    return 1;
  for (int j = 0; j < K; ++j)
    for (int i = 0; i < K; ++i)
      back[j + K * i] = forth[i + K * j];
  if (has_right) {
    po_block_multiply(K, K, forth, z_2, ZERO, to_left);
    po_block_multiply(K, K, to_left, s->from_parent[1], start, work);
    start = work;
  }
  if (has_left)
    po_block_multiply(K, K, back, z_1, ZERO, to_right);
  if (has_left && has_right) {
    sign = invert_less(to_left, to_right, inverse);
    po_block_multiply(K, K, inverse, start, ZERO, along);
    po_block_multiply(K, K, inverse, forth, ZERO, at(e, c, ACROSS));
  } else {
    memcpy(along, start, K * K * sizeof *along);
    memcpy(at(e, c, ACROSS), forth, K * K * sizeof *forth);
  }
  start = ZERO;
  if (has_left) {
    po_block_multiply(K, K, to_right, along, s->from_parent[1], along_right);
    po_block_multiply(K, K, z_1, along, ZERO, work);
    po_block_multiply(K, K, s->to_parent[0], work, ZERO, relation);
    start = relation;
  } else {
    memcpy(along_right, s->from_parent[1], K * K * sizeof *along_right);
  }
  if (has_right) {
    po_block_multiply(K, K, z_2, along_right, ZERO, work);
    po_block_multiply(K, K, s->to_parent[1], work, start, relation);
  }
  return sign;
}

po_status po_elimination_factorize(po_elimination *e, const double *factor) {
  const size_t count = e->hierarchy->cells;
  const po_cell *cell = e->hierarchy->cell;
  const po_status status = reserve(e, count);
  if (status)
    return status;
  memcpy(e->factor, factor, (size_t)cell[0].end * N * sizeof *factor);
  e->sign = 1;
  for (size_t c = count; c-- > 0;)
    e->sign *= po_cell_is_panel(cell + c) ? factorize_panel(e, c, cell[c].panel)
                                          : factorize_halves(e, c, cell[c].right);
  return e->sign == 0 ? PO_SINGULAR : PO_OK;
}

int po_elimination_sign(const po_elimination *e) {
  return e->sign;
}

/* Adds to the border of a panel that of the panel to infinity, whose unknowns follow from those of
 * the others, x_i = right_i - d + sum_j G_ij factor_j x_j. */
static void add_tail_border(const po_elimination *e, size_t panel, double *border) {
  double from_tail[N] = {0};
  if (!e->hierarchy->unbounded)
    return;
  po_block_apply_transposed(N, N, e->hierarchy->to_tail[panel], e->tail_border, from_tail);
  for (size_t j = 0; j < N; ++j)
    border[j] += e->factor[panel * N + j] * from_tail[j];
}

/* The border of a panel as a function of the field on it, and of its right-hand side. */
static void set_panel_border(po_elimination *e, size_t c, size_t panel) {
  const bool is_quiet = e->state[c].is_quiet;
  double *to = e->border + panel * N, border[K], *of_field = e->state[c].border;
  if (!is_quiet)
    add_tail_border(e, panel, to);
  widen(1, to, border);
  memset(of_field, 0, K * sizeof *of_field);
  po_block_apply_transposed(K, K, is_quiet ? e->value : at(e, c, ALONG), border, of_field);
  if (!is_quiet)
    po_block_apply_transposed(K, N, at(e, c, CHANGE), border, to);
}

static void set_border(po_elimination *e, size_t c, size_t right) {
  const bool is_quiet = e->state[c].is_quiet;
  const double *left = is_quiet ? e->skeleton->from_parent[0] : at(e, c, ALONG);
  double *border = e->state[c].border;
  memset(border, 0, K * sizeof *border);
  po_block_apply_transposed(K, K, left, e->state[c + 1].border, border);
  po_block_apply_transposed(K, K, is_quiet ? e->skeleton->from_parent[1] : at(e, c, ALONG_RIGHT),
                            e->state[right].border, border);
}

double po_elimination_border(po_elimination *e, const double *border) {
  const size_t count = e->hierarchy->cells;
  const po_cell *cell = e->hierarchy->cell;
  const size_t core = (size_t)cell[0].end * N, n = po_hierarchy_nodes(e->hierarchy);
  e->pivot = border[n];
  for (size_t j = core; j < n; ++j) {
    e->tail_border[j - core] = border[j];
    e->pivot -= border[j];
  }
  memcpy(e->border, border, core * sizeof *border);
  for (size_t c = count; c-- > 0;)
    if (po_cell_is_panel(cell + c))
      set_panel_border(e, c, cell[c].panel);
    else
      set_border(e, c, cell[c].right);
  for (int k = 0; k < K; ++k)
    e->pivot -= e->state[0].border[k];
  return e->pivot;
}

/* y = start + A x with a matrix of a cell. */
static void apply(const po_elimination *e, size_t cell, enum part part, const double *x,
                  const double *start, double *y) {
  po_block_apply_from(K, at(e, cell, part), x, start, y);
}

/* The moments of a panel, and the sum of its border, at zero field. Given: x, its right-hand side.
 */
static void begin_panel(po_elimination *e, size_t c, size_t panel, const double *x) {
  double right[K];
  e->state[c].sum = po_linear_dot(N, e->border + panel * N, x);
  if (e->state[c].is_quiet)
    return;
  widen(1, x, right);
  po_block_apply_from(N, at(e, c, MOMENTS), right, ZERO, e->state[c].z);
}

static double dot(const double *x, const double *y) {
  double sum = 0.0;
  for (int k = 0; k < K; ++k)
    sum += x[k] * y[k];
  return sum;
}

/* From the halves of a cell: its moments, the sum of its border, and the fields on its halves, at
 * zero field on the cell. */
static void join(po_elimination *e, size_t c, size_t right_half) {
  cell_state *own = e->state + c, *left = own + 1, *right = e->state + right_half;
  const bool has_left = !left->is_quiet, has_right = !right->is_quiet;
  const double *moments = ZERO;
  own->sum = left->sum + right->sum;
  if (own->is_quiet)
    return;
  if (has_left && has_right) {
    double with[K]; /* z_2 + Z_2 S^T z_1 */
    apply(e, c, BACK, left->z, ZERO, right->field);
    apply(e, right_half, RELATION, right->field, right->z, with);
    apply(e, c, ACROSS, with, ZERO, left->field);
  } else if (has_right) {
    apply(e, c, ACROSS, right->z, ZERO, left->field);
  } else {
    memset(left->field, 0, sizeof left->field);
  }
  if (has_left) {
    apply(e, c + 1, RELATION, left->field, left->z, left->z);
    apply(e, c, BACK, left->z, ZERO, right->field);
    po_block_apply_from(K, e->skeleton->to_parent[0], left->z, ZERO, own->z);
    moments = own->z;
  } else {
    memset(right->field, 0, sizeof right->field);
  }
  if (has_right) {
    apply(e, right_half, RELATION, right->field, right->z, right->z);
    po_block_apply_from(K, e->skeleton->to_parent[1], right->z, moments, own->z);
  }
  own->sum += dot(left->border, left->field) + dot(right->border, right->field);
}

/* Adds the field of a cell to those of its halves, or carries it to them if the cell is quiet. */
static void split(po_elimination *e, size_t c, size_t right_half) {
  const double *field = e->state[c].field;
  cell_state *left = e->state + c + 1, *right = e->state + right_half;
  if (!e->state[c].is_quiet) {
    apply(e, c, ALONG, field, left->field, left->field);
    apply(e, c, ALONG_RIGHT, field, right->field, right->field);
    return;
  }
  po_block_apply_from(K, e->skeleton->from_parent[0], field, ZERO, left->field);
  po_block_apply_from(K, e->skeleton->from_parent[1], field, ZERO, right->field);
}

/* From the field on a panel and its right-hand side in x: its unknowns. */
static void finish_panel(const po_elimination *e, size_t c, double *x) {
  const bool is_quiet = e->state[c].is_quiet;
  double right[K], change[K];
  const double *start = ZERO;
  if (!is_quiet) {
    widen(1, x, right);
    po_block_apply_from(N, at(e, c, CHANGE), right, start, change);
    start = change;
  }
  po_block_apply_from(K, is_quiet ? e->value : at(e, c, ALONG), e->state[c].field, start, change);
  for (int j = 0; j < N; ++j)
    x[j] += change[j];
}

/* Adds the deflection of the panel to infinity by the tractions of a panel. */
static void add_to_tail(const po_elimination *e, size_t panel, const double *x, double *tail) {
  double product[N];
  for (size_t j = 0; j < N; ++j)
    product[j] = e->factor[panel * N + j] * x[j];
  po_block_apply(e->hierarchy->to_tail[panel], product, tail);
}

void po_elimination_solve(po_elimination *e, double *x) {
  const size_t count = e->hierarchy->cells;
  const po_cell *cell = e->hierarchy->cell;
  const size_t core = (size_t)cell[0].end * N, n = po_hierarchy_nodes(e->hierarchy);
  for (size_t c = count; c-- > 0;) /* from the panels up */
    if (po_cell_is_panel(cell + c))
      begin_panel(e, c, cell[c].panel, x + (size_t)cell[c].panel * N);
    else
      join(e, c, cell[c].right);
  const double sum = e->state[0].sum;
  const double last = (x[n] - sum - po_linear_dot(n - core, e->tail_border, x + core)) / e->pivot;
  x[n] = last;
  for (size_t j = core; j < n; ++j)
    x[j] -= last;
  for (int k = 0; k < K; ++k)
    e->state[0].field[k] = -last;
  for (size_t c = 0; c < count; ++c) { /* from the domain down */
    double *panel = x + (size_t)cell[c].panel * N;
    if (!po_cell_is_panel(cell + c)) {
      split(e, c, cell[c].right);
      continue;
    }
    finish_panel(e, c, panel);
    if (core < n && !e->state[c].is_quiet)
      add_to_tail(e, cell[c].panel, panel, x + core);
  }
}
