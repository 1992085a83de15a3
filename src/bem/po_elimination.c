#include "po_elimination.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_skeleton.h"

enum { N = PO_TABLE_ORDER, K = PO_SKELETON_NODES };

/* Factors of a cell. In a panel, for the right-hand side r and the field w on it:
 *
 *   x = inverse r + along w,   z = moments r + relation w
 *
 * In other cells, for the relations of the halves:
 *
 *   w_1 = along w + ..., w_2 = along_right w + ...,   inverse = (I - to_left to_right)^-1,
 *   to_left = S Z_2,   to_right = S^T Z_1.
 */
typedef struct {
  _Alignas(64) double relation[K * K]; /* in a vector register without crossing a cache line */
  union {
    struct {
      double inverse[N * N], along[N * K], moments[K * N];
    } panel;
    struct {
      double inverse[K * K], along[K * K], along_right[K * K], to_left[K * K], to_right[K * K];
    } halves;
  };
  double border[K];      /* sum of border x = sum + border . w */
  double field[K], z[K]; /* of a solution */
  double sum;            /* of a solution: the sum of border x at zero field */
  bool is_quiet;         /* Z = 0 */
} factors;

struct po_elimination {
  const po_hierarchy *hierarchy;
  const po_skeleton *skeleton;
  size_t room;
  factors *cell;
  double *border; /* 12 a panel: the transpose of `inverse` times the border */
  double *factor; /* 12 a panel: the factors of the matrix */
  int sign;
  double tail_border[N]; /* border of the panel to infinity */
  double pivot;
};

po_status po_elimination_create(const po_hierarchy *hierarchy, po_elimination **elimination) {
  po_elimination *e = *elimination = po_allocate(1, sizeof *e);
  if (!e)
    return PO_NO_MEMORY;
  e->hierarchy = hierarchy;
  e->skeleton = po_skeleton_get();
  return e->skeleton ? PO_OK : PO_NO_MEMORY;
}

void po_elimination_destroy(po_elimination *e) {
  if (!e)
    return;
  free(e->cell);
  free(e->border);
  free(e->factor);
  free(e);
}

static bool is_panel(const po_cell *cell) {
  return cell->end - cell->panel == 1;
}

/* y = A x, and y = A^T x. */
static void set(size_t rows, size_t columns, const double *a, const double *x, double *y) {
  memset(y, 0, rows * sizeof *y);
  po_block_apply(rows, columns, a, x, y);
}
static void set_transposed(size_t rows, size_t columns, const double *a, const double *x,
                           double *y) {
  memset(y, 0, columns * sizeof *y);
  po_block_apply_transposed(rows, columns, a, x, y);
}

/* C = A B. */
static void set_product(size_t rows, size_t inner, size_t columns, const double *a, const double *b,
                        double *c) {
  memset(c, 0, rows * columns * sizeof *c);
  po_block_multiply(rows, inner, columns, 1.0, a, b, c);
}

static double dot(size_t n, const double *x, const double *y) {
  double sum = 0.0;
  for (size_t k = 0; k < n; ++k)
    sum += x[k] * y[k];
  return sum;
}

static void set_unit(size_t n, double *a) {
  memset(a, 0, n * n * sizeof *a);
  for (size_t k = 0; k < n; ++k)
    a[k + n * k] = 1.0;
}

/* Returned: the sign of the determinant; 0 for a singular matrix. */
static int factorize_panel(const po_elimination *e, size_t panel, const double *factor,
                           factors *f) {
  const double *own = po_hierarchy_own_block(e->hierarchy, panel);
  const double *weight = po_hierarchy_weight(e->hierarchy) + panel * N;
  const double *rule = po_panel_table_get()->rule.weight;
  double moment[K * N];
  f->is_quiet = true;
  for (int j = 0; j < N; ++j)
    f->is_quiet = f->is_quiet && factor[j] == 0.0;
  if (f->is_quiet)
    return 1;
  set_unit(N, f->panel.inverse);
  for (int j = 0; j < N; ++j) {
    const double charge = weight[j] / rule[j] * factor[j];
    for (int i = 0; i < N; ++i)
      f->panel.inverse[i + N * j] -= own[i + N * j] * factor[j];
    for (int i = 0; i < K; ++i)
      moment[i + K * j] = charge * e->skeleton->moment[i + K * j];
  }
  const int sign = po_block_invert(N, f->panel.inverse);
  set_product(N, N, K, f->panel.inverse, e->skeleton->value, f->panel.along);
  set_product(K, N, N, moment, f->panel.inverse, f->panel.moments);
  set_product(K, N, K, f->panel.moments, e->skeleton->value, f->relation);
  return sign;
}

/* As above, for a cell whose halves are factorised. */
static int factorize_halves(const po_elimination *e, size_t c, const factors *left,
                            const factors *right, factors *f) {
  const double *halves = po_hierarchy_halves(e->hierarchy, c);
  const po_skeleton *s = e->skeleton;
  double work[K * K], transposed[K * K];
  int sign = 1;
  f->is_quiet = left->is_quiet && right->is_quiet;
  if (f->is_quiet)
    return 1;
  memcpy(f->halves.along, s->from_parent[0], sizeof f->halves.along);
  memcpy(f->halves.along_right, s->from_parent[1], sizeof f->halves.along_right);
  if (!right->is_quiet) {
    set_product(K, K, K, halves, right->relation, f->halves.to_left);
    po_block_multiply(K, K, K, 1.0, f->halves.to_left, s->from_parent[1], f->halves.along);
  }
  if (!left->is_quiet) {
    for (int j = 0; j < K; ++j)
      for (int i = 0; i < K; ++i)
        transposed[j + K * i] = halves[i + K * j];
    set_product(K, K, K, transposed, left->relation, f->halves.to_right);
  }
  if (!left->is_quiet && !right->is_quiet) {
    set_unit(K, f->halves.inverse);
    po_block_multiply(K, K, K, -1.0, f->halves.to_left, f->halves.to_right, f->halves.inverse);
    sign = po_block_invert(K, f->halves.inverse);
    memcpy(work, f->halves.along, sizeof work);
    set_product(K, K, K, f->halves.inverse, work, f->halves.along);
  }
  memset(f->relation, 0, sizeof f->relation);
  if (!left->is_quiet) {
    po_block_multiply(K, K, K, 1.0, f->halves.to_right, f->halves.along, f->halves.along_right);
    set_product(K, K, K, left->relation, f->halves.along, work);
    po_block_multiply(K, K, K, 1.0, s->to_parent[0], work, f->relation);
  }
  if (!right->is_quiet) {
    set_product(K, K, K, right->relation, f->halves.along_right, work);
    po_block_multiply(K, K, K, 1.0, s->to_parent[1], work, f->relation);
  }
  return sign;
}

static po_status reserve(po_elimination *e, size_t cells) {
  if (cells <= e->room)
    return PO_OK;
  free(e->cell);
  free(e->border);
  free(e->factor);
  e->room = cells + cells / 2;
  e->cell = po_reserve(e->room, sizeof *e->cell);
  e->border = po_allocate(e->room * N, sizeof *e->border);
  e->factor = po_allocate(e->room * N, sizeof *e->factor);
  if (e->cell && e->border && e->factor)
    return PO_OK;
  e->room = 0;
  return PO_NO_MEMORY;
}

po_status po_elimination_factorize(po_elimination *e, const double *factor) {
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  const po_status status = reserve(e, count);
  if (status)
    return status;
  e->sign = 1;
  memcpy(e->factor, factor, (size_t)cell[0].end * N * sizeof *factor);
  for (size_t c = count; c-- > 0;) {
    factors *f = e->cell + c;
    e->sign *= is_panel(cell + c)
                   ? factorize_panel(e, cell[c].panel, factor + (size_t)cell[c].panel * N, f)
                   : factorize_halves(e, c, f + 1, e->cell + cell[c].right, f);
  }
  return e->sign == 0 ? PO_SINGULAR : PO_OK;
}

int po_elimination_sign(const po_elimination *e) {
  return e->sign;
}

/* The maps of the field of a cell to its halves. */
static const double *along_left(const po_elimination *e, size_t c) {
  return e->cell[c].is_quiet ? e->skeleton->from_parent[0] : e->cell[c].halves.along;
}
static const double *along_right(const po_elimination *e, size_t c) {
  return e->cell[c].is_quiet ? e->skeleton->from_parent[1] : e->cell[c].halves.along_right;
}

/* Adds to the border of a panel that of the panel to infinity, whose unknowns follow from those of
 * the others, x_i = right_i - d + sum_j G_ij factor_j x_j. */
static void add_tail_border(const po_elimination *e, size_t panel, double border[N]) {
  const double *to_tail = po_hierarchy_to_tail(e->hierarchy, panel);
  double from_tail[N];
  if (!to_tail)
    return;
  set_transposed(N, N, to_tail, e->tail_border, from_tail);
  for (size_t j = 0; j < N; ++j)
    border[j] += e->factor[panel * N + j] * from_tail[j];
}

double po_elimination_border(po_elimination *e, const double *border) {
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  const size_t core = (size_t)cell[0].end * N, n = po_hierarchy_nodes(e->hierarchy);
  e->pivot = border[n];
  for (size_t j = core; j < n; ++j) {
    e->tail_border[j - core] = border[j];
    e->pivot -= border[j];
  }
  for (size_t c = count; c-- > 0;) {
    factors *f = e->cell + c;
    if (!is_panel(cell + c)) {
      set_transposed(K, K, along_left(e, c), f[1].border, f->border);
      po_block_apply_transposed(K, K, along_right(e, c), e->cell[cell[c].right].border, f->border);
      continue;
    }
    double *to = e->border + (size_t)cell[c].panel * N, own[N];
    memcpy(own, border + (size_t)cell[c].panel * N, sizeof own);
    if (!f->is_quiet)
      add_tail_border(e, cell[c].panel, own);
    set_transposed(N, K, f->is_quiet ? e->skeleton->value : f->panel.along, own, f->border);
    if (f->is_quiet)
      memcpy(to, own, sizeof own);
    else
      set_transposed(N, N, f->panel.inverse, own, to);
  }
  for (int k = 0; k < K; ++k)
    e->pivot -= e->cell[0].border[k];
  return e->pivot;
}

/* From the halves of a cell: its moments, the sum of its border, and the fields on its halves, at
 * zero field on the cell. */
static void join(po_elimination *e, size_t c, size_t right_half) {
  factors *f = e->cell + c, *left = f + 1, *right = e->cell + right_half;
  f->sum = left->sum + right->sum;
  if (f->is_quiet)
    return;
  const double *halves = po_hierarchy_halves(e->hierarchy, c);
  memset(left->field, 0, sizeof left->field);
  memset(right->field, 0, sizeof right->field);
  memset(f->z, 0, sizeof f->z);
  if (!left->is_quiet)
    po_block_apply_transposed(K, K, halves, left->z, right->field);
  if (!right->is_quiet) {
    po_block_apply(K, K, halves, right->z, left->field);
    po_block_apply(K, K, f->halves.to_left, right->field, left->field);
  }
  if (!left->is_quiet) {
    if (!right->is_quiet) {
      double field[K];
      memcpy(field, left->field, sizeof field);
      set(K, K, f->halves.inverse, field, left->field);
    }
    po_block_apply(K, K, f->halves.to_right, left->field, right->field);
    po_block_apply(K, K, left->relation, left->field, left->z);
    po_block_apply(K, K, e->skeleton->to_parent[0], left->z, f->z);
  }
  if (!right->is_quiet) {
    po_block_apply(K, K, right->relation, right->field, right->z);
    po_block_apply(K, K, e->skeleton->to_parent[1], right->z, f->z);
  }
  f->sum += dot(K, left->border, left->field) + dot(K, right->border, right->field);
}

/* Adds the field of a cell to that of one of its halves. */
static void add_field(const po_elimination *e, size_t parent, const double *along, factors *f) {
  if (e->cell[parent].is_quiet)
    memset(f->field, 0, sizeof f->field);
  po_block_apply(K, K, along, e->cell[parent].field, f->field);
}

/* Adds what the unknowns of a panel do to those of the panel to infinity. */
static void add_to_tail(const po_elimination *e, size_t panel, const double *x, double *tail) {
  double product[N];
  for (size_t j = 0; j < N; ++j)
    product[j] = e->factor[panel * N + j] * x[j];
  po_block_apply(N, N, po_hierarchy_to_tail(e->hierarchy, panel), product, tail);
}

/* From the field on a panel and its right-hand side in x: its unknowns. */
static void finish_panel(const po_elimination *e, const factors *f, double *x) {
  double right[N];
  if (!f->is_quiet) {
    memcpy(right, x, sizeof right);
    set(N, N, f->panel.inverse, right, x);
  }
  po_block_apply(N, K, f->is_quiet ? e->skeleton->value : f->panel.along, f->field, x);
}

void po_elimination_solve(po_elimination *e, double *x) {
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  const size_t core = (size_t)cell[0].end * N, n = po_hierarchy_nodes(e->hierarchy);
  for (size_t c = count; c-- > 0;) {
    const size_t first = (size_t)cell[c].panel * N;
    factors *f = e->cell + c;
    if (!is_panel(cell + c)) {
      join(e, c, cell[c].right);
      continue;
    }
    f->sum = dot(N, e->border + first, x + first);
    if (!f->is_quiet)
      set(K, N, f->panel.moments, x + first, f->z);
  }
  double last = x[n] - e->cell[0].sum - dot(n - core, e->tail_border, x + core);
  x[n] = last /= e->pivot;
  for (int k = 0; k < K; ++k)
    e->cell[0].field[k] = -last;
  for (size_t j = core; j < n; ++j)
    x[j] -= last;
  for (size_t c = 0; c < count; ++c) {
    double *at = x + (size_t)cell[c].panel * N;
    if (!is_panel(cell + c)) {
      add_field(e, c, along_left(e, c), e->cell + c + 1);
      add_field(e, c, along_right(e, c), e->cell + cell[c].right);
      continue;
    }
    finish_panel(e, e->cell + c, at);
    if (core < n && !e->cell[c].is_quiet)
      add_to_tail(e, cell[c].panel, at, x + core);
  }
}
