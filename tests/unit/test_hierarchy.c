/* The hierarchical influence matrix against the dense one: products, largest coefficients, and the
 * factors of the bordered Jacobian. */
#include <dlfcn.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_elimination.h"
#include "po_linear.h"
#include "po_random.h"
#include "run.h"

/* Takes the place of GSL's function. Fails in the call after this number of further calls. */
static int calls_before_failure = -1;

gsl_integration_glfixed_table *gsl_integration_glfixed_table_alloc(size_t n) {
  gsl_integration_glfixed_table *(*alloc)(size_t) = NULL;
  void *const of_gsl = dlsym(RTLD_NEXT, "gsl_integration_glfixed_table_alloc");
  memcpy(&alloc, &of_gsl, sizeof alloc);
  return calls_before_failure-- == 0 ? NULL : alloc(n);
}

/* Makes the matrix of one panel and its factors. */
static po_status make_once(void) {
  static po_panels panels;
  po_hierarchy *h = NULL;
  po_elimination *e = NULL;
  const po_panel_table *table = po_panel_table_get();
  po_panels_uniform(&panels, 1);
  po_status status = table ? po_hierarchy_create(table, false, 6.0, &h) : PO_NO_MEMORY;
  if (!status)
    status = po_hierarchy_mesh(h, &panels);
  if (!status)
    status = po_elimination_create(h, &e);
  po_elimination_destroy(e);
  po_hierarchy_destroy(h);
  return status;
}

/* If memory ran out in the last of the three rules that the tables of panels need, the first mesh
 * ended the program, and all tables but one stayed empty. */
LOOP_TEST(tables_are_computed_later_if_memory_ran_out, 0, 3) {
  calls_before_failure = _i;
  ck_assert_int_eq(make_once(), PO_NO_MEMORY);
  ck_assert_int_eq(make_once(), PO_OK);
}

enum { MESHES = 5 };

/* Random trees: the domain halved `level` times, then random panels split. */
static const struct {
  uint32_t level;
  int splits;
  bool unbounded;
} MESH[MESHES] = {{0, 0, true}, {1, 3, false}, {3, 25, true}, {5, 30, false}, {5, 60, true}};

typedef struct {
  po_hierarchy *h;
  po_panels *panels;
  size_t n;
  double *matrix, *x, *y, *z; /* n square; n + 1 each */
} fixture;

static double next_random(uint64_t *seed) {
  return po_random_uniform(1, (*seed)++, "hierarchy");
}

static void refine(po_panels *panels, int splits, uint64_t *seed) {
  for (int k = 0; k < splits; ++k) {
    const size_t at = (size_t)(next_random(seed) * (double)panels->count);
    for (size_t j = 0; j < panels->count; ++j)
      panels->marked[j] = j == at;
    ck_assert(po_panels_split(panels));
  }
}

static fixture set_up(int mesh, uint64_t *seed) {
  static po_panels panels;
  fixture f = {.panels = &panels};
  po_panels_uniform(f.panels, MESH[mesh].level);
  refine(f.panels, MESH[mesh].splits, seed);
  ck_assert_int_eq(po_hierarchy_create(po_panel_table_get(), MESH[mesh].unbounded, 6.0, &f.h),
                   PO_OK);
  ck_assert_int_eq(po_hierarchy_mesh(f.h, f.panels), PO_OK);
  const size_t n = f.n = po_hierarchy_nodes(f.h);
  ck_assert_uint_eq(n, PO_TABLE_ORDER * (f.panels->count + (MESH[mesh].unbounded ? 1 : 0)));
  f.matrix = malloc(n * n * sizeof *f.matrix);
  f.x = malloc((n + 1) * sizeof *f.x);
  f.y = malloc((n + 1) * sizeof *f.y);
  f.z = malloc((n + 1) * sizeof *f.z);
  po_hierarchy_fill_matrix(f.h, 1.0, f.matrix);
  for (size_t j = 0; j <= n; ++j)
    f.x[j] = 2.0 * next_random(seed) - 1.0;
  return f;
}

static void tear_down(fixture *f) {
  po_hierarchy_destroy(f->h);
  free(f->matrix);
  free(f->x);
  free(f->y);
  free(f->z);
}

/* The largest difference of y and z, relative to the largest of y. */
static double difference(const fixture *f, size_t n) {
  double worst = 0.0, largest = 0.0;
  for (size_t i = 0; i < n; ++i) {
    worst = fmax(worst, fabs(f->y[i] - f->z[i]));
    largest = fmax(largest, fabs(f->y[i]));
  }
  return worst / largest;
}

LOOP_TEST(products_agree_with_the_dense_matrix, 0, MESHES) {
  uint64_t seed = 17000 + 1000 * (uint64_t)_i;
  fixture f = set_up(_i, &seed);
  po_linear_apply(f.n, f.n, f.matrix, f.n, f.x, f.y);
  po_hierarchy_apply(f.h, f.x, f.z);
  ck_assert_double_lt(difference(&f, f.n), 1e-12);
  po_linear_apply_transposed(f.n, f.n, f.matrix, f.n, f.x, f.y);
  po_hierarchy_apply_transposed(f.h, f.x, f.z);
  ck_assert_double_lt(difference(&f, f.n), 1e-12);
  tear_down(&f);
}

LOOP_TEST(largest_coefficients_are_those_of_the_dense_matrix, 0, MESHES) {
  uint64_t seed = 29000 + 1000 * (uint64_t)_i;
  fixture f = set_up(_i, &seed);
  po_hierarchy_reach(f.h, f.z);
  for (size_t j = 0; j < f.n; ++j) {
    double largest = 0.0;
    for (size_t i = 0; i < f.n; ++i)
      largest = fmax(largest, fabs(f.matrix[i + f.n * j]));
    ck_assert_double_eq_tol(f.z[j], largest, 1e-14 * largest);
  }
  tear_down(&f);
}

/* A mesh that returns computes nothing, one that changes a little computes little, and the products
 * are those of a matrix that is made anew. */
TEST(blocks_are_kept_from_mesh_to_mesh) {
  uint64_t seed = 31;
  fixture f = set_up(4, &seed);
  const uint64_t first = f.h->evaluations;
  static po_panels finer;
  po_panels_copy(f.panels, &finer);
  refine(&finer, 1, &seed);
  ck_assert_int_eq(po_hierarchy_mesh(f.h, &finer), PO_OK);
  const uint64_t second = f.h->evaluations - first;
  ck_assert_uint_gt(second, 0);
  ck_assert_uint_lt(second, first / 5);
  ck_assert_int_eq(po_hierarchy_mesh(f.h, f.panels), PO_OK);
  ck_assert_uint_eq(f.h->evaluations, first + second);
  po_hierarchy_apply(f.h, f.x, f.y);
  po_hierarchy *other;
  ck_assert_int_eq(po_hierarchy_create(po_panel_table_get(), true, 6.0, &other), PO_OK);
  ck_assert_int_eq(po_hierarchy_mesh(other, f.panels), PO_OK);
  po_hierarchy_apply(other, f.x, f.z);
  ck_assert_mem_eq(f.y, f.z, f.n * sizeof *f.y);
  po_hierarchy_destroy(other);
  tear_down(&f);
}

/* The blocks of a mesh are proportional to the number of its panels, but for those at both ends. */
TEST(work_is_proportional_to_the_number_of_panels) {
  double per_panel[2];
  for (int k = 0; k < 2; ++k) {
    static po_panels panels;
    po_panels_uniform(&panels, k ? 10 : 7);
    po_hierarchy *h;
    ck_assert_int_eq(po_hierarchy_create(po_panel_table_get(), false, 6.0, &h), PO_OK);
    ck_assert_int_eq(po_hierarchy_mesh(h, &panels), PO_OK);
    per_panel[k] = (double)h->evaluations / (double)panels.count;
    po_hierarchy_destroy(h);
  }
  ck_assert_double_lt(per_panel[1], 1.1 * per_panel[0]);
}

/* Factors such as those of a contact: stiff inside, of the other sign at the edge, small outside,
 * and zero farther out and to infinity. */
static void fill_factors(const fixture *f, double stiffness, double *factor) {
  memset(factor, 0, f->n * sizeof *factor);
  for (size_t k = 0; k < f->panels->count; ++k)
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
      const double r = po_panel_begin(f->panels->panel[k]) +
                       po_panel_size(f->panels->panel[k]) * po_panel_table_get()->rule.node[j];
      factor[k * PO_TABLE_ORDER + j] = r < 0.4    ? -stiffness * (1.0 + 0.5 * sin(20.0 * r))
                                       : r < 0.44 ? 3.0
                                       : r < 0.6  ? 0.05
                                                  : 0.0;
    }
}

/* The bordered Jacobian, dense, of order n + 1. */
static double *jacobian(const fixture *f, const double *factor, const double *border) {
  const size_t n = f->n, order = n + 1;
  double *m = calloc(order * order, sizeof *m);
  for (size_t j = 0; j < n; ++j) {
    for (size_t i = 0; i < n; ++i)
      m[i + order * j] = (i == j) - f->matrix[i + n * j] * factor[j];
    m[n + order * j] = border[j];
    m[j + order * n] = 1.0;
  }
  m[n + order * n] = border[n];
  return m;
}

/* The sign and the logarithm of the modulus of a determinant. */
static double determinant(size_t n, const double *matrix, int *sign) {
  double *m = malloc(n * n * sizeof *m), sum = 0.0;
  int *pivots = malloc(n * sizeof *pivots);
  memcpy(m, matrix, n * n * sizeof *m);
  ck_assert_int_eq(po_linear_factorize(n, m, n, pivots), PO_OK);
  *sign = 1;
  for (size_t i = 0; i < n; ++i) {
    sum += log(fabs(m[i + n * i]));
    if ((pivots[i] != (int)i + 1) != (m[i + n * i] < 0.0))
      *sign = -*sign;
  }
  free(m);
  free(pivots);
  return sum;
}

static const double STIFFNESS[] = {1.0, 30.0, 3000.0};

/* The solution satisfies the system but for the error of the skeletons, with a second border as
 * with the first; the sign of the determinant is that of LU, and the determinant changes with the
 * border as that of LU does. */
LOOP_TEST(factors_solve_the_bordered_system, 0, 3 * MESHES) {
  uint64_t seed = 41000 + 1000 * (uint64_t)_i;
  fixture f = set_up(_i % MESHES, &seed);
  const size_t n = f.n;
  double *factor = malloc(n * sizeof *factor), *border = malloc((n + 1) * sizeof *border);
  fill_factors(&f, STIFFNESS[_i / MESHES], factor);
  po_elimination *e;
  ck_assert_int_eq(po_elimination_create(f.h, &e), PO_OK);
  ck_assert_int_eq(po_elimination_factorize(e, factor), PO_OK);
  double before = 0.0, size = 0.0;
  for (int k = 0; k < 2; ++k) {
    for (size_t j = 0; j <= n; ++j)
      border[j] = (k ? cos(3.0 * (double)j / (double)n) : 1.0) / (double)n;
    const double pivot = po_elimination_border(e, border);
    double *m = jacobian(&f, factor, border);
    memcpy(f.y, f.x, (n + 1) * sizeof *f.y);
    po_elimination_solve(e, f.y);
    po_linear_apply(n + 1, n + 1, m, n + 1, f.y, f.z);
    memcpy(f.y, f.x, (n + 1) * sizeof *f.y);
    ck_assert_double_lt(difference(&f, n + 1), 2e-2);
    int sign;
    const double logarithm = determinant(n + 1, m, &sign);
    ck_assert_int_eq(po_elimination_sign(e) * (pivot < 0.0 ? -1 : 1), sign);
    if (k)
      ck_assert_double_eq_tol(fabs(pivot) / before, exp(logarithm - size),
                              2e-3 * fabs(pivot) / before);
    before = fabs(pivot);
    size = logarithm;
    free(m);
  }
  po_elimination_destroy(e);
  free(factor);
  free(border);
  tear_down(&f);
}

/* With small factors nothing hides the error of the skeletons: it is that of the header. */
TEST(skeletons_are_as_accurate_as_stated) {
  uint64_t seed = 53;
  fixture f = set_up(3, &seed);
  const size_t n = f.n;
  static const double SMALL = 1e-3;
  double *factor = malloc(n * sizeof *factor), *border = calloc(n + 1, sizeof *border);
  for (size_t j = 0; j < n; ++j)
    factor[j] = SMALL;
  border[n] = 1.0;
  po_elimination *e;
  ck_assert_int_eq(po_elimination_create(f.h, &e), PO_OK);
  ck_assert_int_eq(po_elimination_factorize(e, factor), PO_OK);
  po_elimination_border(e, border);
  double *m = jacobian(&f, factor, border);
  for (size_t j = 0; j < n; ++j)
    f.x[j] = 1.0 + cos(9.0 * (double)j / (double)n);
  f.x[n] = 0.0;
  memcpy(f.y, f.x, (n + 1) * sizeof *f.y);
  po_elimination_solve(e, f.y);
  po_linear_apply(n + 1, n + 1, m, n + 1, f.y, f.z);
  double worst = 0.0;
  for (size_t i = 0; i <= n; ++i)
    worst = fmax(worst, fabs(f.z[i] - f.x[i]) / SMALL);
  ck_assert_double_lt(worst, 1e-4);
  ck_assert_double_gt(worst, 1e-9); /* it is not exact: the test sees the skeletons */
  free(m);
  po_elimination_destroy(e);
  free(factor);
  free(border);
  tear_down(&f);
}
