#include "po_elimination.h"

#include <math.h>
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

/* Growth of rounding errors above which the factors are in double precision: in single precision
 * they would be off by 3e-5, the error of the skeletons being 1e-5, and cost iterations. With 1000
 * some scenes take 5 % less time, but the approach of the pull-off under the Morse law with a = 3
 * at mu = 10,000 is off by 2e-3. */
static const double GROWTH_OF_DOUBLE = 250.0;

static double largest(size_t n, const double *a) {
  double largest = 0.0;
  for (size_t k = 0; k < n * n; ++k)
    largest = fabs(a[k]) > largest ? fabs(a[k]) : largest; /* fmax costs ten times as much */
  return largest;
}

/* Replaces a matrix of order 12 or 16 by its inverse, as po_block_invert. Given and returned:
 * growth, the greatest of all inverses so far. */
static int invert(size_t n, double *a, double *growth) {
  const double before = largest(n, a);
  const int sign = po_block_invert(n, a);
  *growth = fmax(*growth, before * largest(n, a));
  return sign;
}

/* Factors in single and in double precision. A solution reads every matrix once, so that in single
 * precision it takes half the time. */
#define REAL float
#define IN_REAL(name) name##_single
#define APPLY po_block_apply_from_single
#define APPLY_TRANSPOSED po_block_apply_transposed_single
#define MULTIPLY po_block_multiply_single
#include "po_elimination_factors.h"
#include "po_elimination_solution.h"
#undef REAL
#undef IN_REAL
#undef APPLY
#undef APPLY_TRANSPOSED
#undef MULTIPLY
#define REAL double
#define IN_REAL(name) name##_double
#define APPLY po_block_apply_from
#define APPLY_TRANSPOSED(columns, a, x, y) po_block_apply_transposed(K, columns, a, x, y)
#define MULTIPLY po_block_multiply
#include "po_elimination_factors.h"
#include "po_elimination_solution.h"

struct po_elimination {
  const po_hierarchy *hierarchy;
  const po_skeleton *skeleton;
  bool in_double;
  double growth; /* of rounding errors in the last factorisation, by the inverses: the product of
                    the largest elements of a matrix and of its inverse */
  factors_single single;
  factors_double full;
  size_t room;
  bool *is_quiet; /* of each cell: Z = 0 */
  double *border; /* 12 a panel: the transpose of I + CHANGE times the border */
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
  if (!e->skeleton)
    return PO_NO_MEMORY;
  set_skeleton_single(e->skeleton, &e->single);
  set_skeleton_double(e->skeleton, &e->full);
  return PO_OK;
}

static void free_cells(po_elimination *e) {
  free(e->is_quiet);
  free(e->border);
  free(e->factor);
}

void po_elimination_destroy(po_elimination *e) {
  if (!e)
    return;
  free_single(&e->single);
  free_double(&e->full);
  free_cells(e);
  free(e);
}

static bool is_panel(const po_cell *cell) {
  return cell->end - cell->panel == 1;
}

/* Returned: the sign of the determinant; 0 for a singular matrix. */
static int factorize_panel(po_elimination *e, size_t c, size_t panel) {
  const double *own = po_hierarchy_own_block(e->hierarchy, panel);
  const double *weight = po_hierarchy_weight(e->hierarchy) + panel * N;
  const double *rule = po_panel_table_get()->rule.weight, *factor = e->factor + panel * N;
  e->is_quiet[c] = true;
  for (int j = 0; j < N; ++j)
    e->is_quiet[c] = e->is_quiet[c] && factor[j] == 0.0;
  if (e->is_quiet[c])
    return 1;
  return e->in_double
             ? factorize_panel_double(&e->full, c, own, weight, rule, factor, &e->growth)
             : factorize_panel_single(&e->single, c, own, weight, rule, factor, &e->growth);
}

/* As above, for a cell whose halves are factorised. */
static int factorize_halves(po_elimination *e, size_t c, size_t right) {
  const bool has_left = !e->is_quiet[c + 1], has_right = !e->is_quiet[right];
  const double *across = po_hierarchy_halves(e->hierarchy, c);
  e->is_quiet[c] = !has_left && !has_right;
  if (e->is_quiet[c])
    return 1;
  return e->in_double
             ? factorize_halves_double(&e->full, c, right, across, has_left, has_right, &e->growth)
             : factorize_halves_single(&e->single, c, right, across, has_left, has_right,
                                       &e->growth);
}

static po_status reserve(po_elimination *e, size_t cells) {
  if (cells <= e->room)
    return PO_OK;
  free_cells(e);
  e->room = cells + cells / 2;
  e->is_quiet = po_reserve(e->room, sizeof *e->is_quiet);
  e->border = po_allocate(e->room * N, sizeof *e->border);
  e->factor = po_allocate(e->room * N, sizeof *e->factor);
  if (e->is_quiet && e->border && e->factor)
    return PO_OK;
  e->room = 0;
  return PO_NO_MEMORY;
}

/* Factorises in one of the precisions; in single precision only as long as rounding allows. */
static po_status factorize(po_elimination *e, bool in_double) {
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  const po_status status =
      in_double ? reserve_double(count, &e->full) : reserve_single(count, &e->single);
  if (status)
    return status;
  e->in_double = in_double;
  e->sign = 1;
  e->growth = 0.0;
  for (size_t c = count; c-- > 0 && (in_double || e->growth < GROWTH_OF_DOUBLE);)
    e->sign *= is_panel(cell + c) ? factorize_panel(e, c, cell[c].panel)
                                  : factorize_halves(e, c, cell[c].right);
  return PO_OK;
}

po_status po_elimination_factorize(po_elimination *e, const double *factor, bool in_double) {
  const bool was_large = !(e->growth < GROWTH_OF_DOUBLE);
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  po_status status = reserve(e, count);
  if (status)
    return status;
  memcpy(e->factor, factor, (size_t)cell[0].end * N * sizeof *factor);
  status = factorize(e, in_double || was_large);
  if (!status && !e->in_double && !(e->growth < GROWTH_OF_DOUBLE))
    status = factorize(e, true);
  if (status)
    return status;
  return e->sign == 0 ? PO_SINGULAR : PO_OK;
}

int po_elimination_sign(const po_elimination *e) {
  return e->sign;
}

bool po_elimination_is_double(const po_elimination *e) {
  return e->in_double;
}

/* Adds to the border of a panel that of the panel to infinity, whose unknowns follow from those of
 * the others, x_i = right_i - d + sum_j G_ij factor_j x_j. */
static void add_tail_border(const po_elimination *e, size_t panel, double *border) {
  const double *to_tail = po_hierarchy_to_tail(e->hierarchy, panel);
  double from_tail[N] = {0};
  if (!to_tail)
    return;
  po_block_apply_transposed(N, N, to_tail, e->tail_border, from_tail);
  for (size_t j = 0; j < N; ++j)
    border[j] += e->factor[panel * N + j] * from_tail[j];
}

static void set_panel_border(po_elimination *e, size_t c, size_t panel) {
  double *border = e->border + panel * N;
  if (!e->is_quiet[c])
    add_tail_border(e, panel, border);
  if (e->in_double)
    set_panel_border_double(&e->full, c, e->is_quiet[c], border);
  else
    set_panel_border_single(&e->single, c, e->is_quiet[c], border);
}

static void set_border(po_elimination *e, size_t c, size_t right) {
  if (e->in_double)
    set_border_double(&e->full, c, right, e->is_quiet[c]);
  else
    set_border_single(&e->single, c, right, e->is_quiet[c]);
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
  memcpy(e->border, border, core * sizeof *border);
  for (size_t c = count; c-- > 0;)
    if (is_panel(cell + c))
      set_panel_border(e, c, cell[c].panel);
    else
      set_border(e, c, cell[c].right);
  for (int k = 0; k < K; ++k)
    e->pivot -= e->in_double ? e->full.cell[0].border[k] : (double)e->single.cell[0].border[k];
  return e->pivot;
}

/* Adds the deflection of the panel to infinity by the tractions of a panel. */
static void add_to_tail(const po_elimination *e, size_t panel, const double *x, double *tail) {
  double product[N];
  for (size_t j = 0; j < N; ++j)
    product[j] = e->factor[panel * N + j] * x[j];
  po_block_apply(N, N, po_hierarchy_to_tail(e->hierarchy, panel), product, tail);
}

/* The cells from the panels up: moments, sums of the border and fields at zero field on the domain.
 * Returned: the sum of the border. */
static double go_up(po_elimination *e, const po_cell *cell, size_t count, const double *x) {
  for (size_t c = count; c-- > 0;) {
    const size_t first = (size_t)cell[c].panel * N, right = cell[c].right;
    if (is_panel(cell + c)) {
      const double sum = po_linear_dot(N, e->border + first, x + first);
      if (e->in_double)
        begin_panel_double(&e->full, c, e->is_quiet[c], x + first);
      else
        begin_panel_single(&e->single, c, e->is_quiet[c], x + first);
      *(e->in_double ? &e->full.cell[c].sum : &e->single.cell[c].sum) = sum;
    } else if (e->in_double) {
      join_double(&e->full, c, right, !e->is_quiet[c + 1], !e->is_quiet[right]);
    } else {
      join_single(&e->single, c, right, !e->is_quiet[c + 1], !e->is_quiet[right]);
    }
  }
  return e->in_double ? e->full.cell[0].sum : e->single.cell[0].sum;
}

/* The cells from the domain down: fields, and the unknowns of the panels. */
static void go_down(po_elimination *e, const po_cell *cell, size_t count, double field, double *x,
                    double *tail) {
  for (int k = 0; k < K; ++k)
    if (e->in_double)
      e->full.cell[0].field[k] = field;
    else
      e->single.cell[0].field[k] = (float)field;
  for (size_t c = 0; c < count; ++c) {
    double *at = x + (size_t)cell[c].panel * N;
    if (!is_panel(cell + c)) {
      if (e->in_double)
        split_double(&e->full, c, cell[c].right, e->is_quiet[c]);
      else
        split_single(&e->single, c, cell[c].right, e->is_quiet[c]);
      continue;
    }
    if (e->in_double)
      finish_panel_double(&e->full, c, e->is_quiet[c], at);
    else
      finish_panel_single(&e->single, c, e->is_quiet[c], at);
    if (tail && !e->is_quiet[c])
      add_to_tail(e, cell[c].panel, at, tail);
  }
}

void po_elimination_solve(po_elimination *e, double *x) {
  size_t count;
  const po_cell *cell = po_hierarchy_cells(e->hierarchy, &count);
  const size_t core = (size_t)cell[0].end * N, n = po_hierarchy_nodes(e->hierarchy);
  const double sum = go_up(e, cell, count, x);
  const double last = (x[n] - sum - po_linear_dot(n - core, e->tail_border, x + core)) / e->pivot;
  x[n] = last;
  for (size_t j = core; j < n; ++j)
    x[j] -= last;
  go_down(e, cell, count, -last, x, core < n ? x + core : NULL);
}
