/* Folds followed in a parameter of the scene, against the folds of full traces. */
#include <math.h>

#include "po_continuation.h"
#include "po_follow.h"
#include "po_solve.h"
#include "po_trace.h"
#include "run.h"

enum { MOST = 16 };

/* The tolerance of the panels and of Newton's method. */
static const double TOLERANCE = 1e-8;

/* A series of scenes: the parameter that varies is the amplitude if `amplitude` is set, otherwise
 * mu. */
typedef struct {
  po_scene scene;
  bool amplitude;
  double from, to[3];
  size_t folds;
} series;

static const series SERIES[] = {
    {{0.0, 0.0, 0.0, 87.0, INFINITY}, false, 2.385, {2.2, 2.61, 3.07}, 2},
    /* as mu decreases, the contact edge of the third fold reaches the axis, faster and faster */
    {{0.0, 0.0, 0.0, 100.0, INFINITY}, false, 5.0, {4.7, 4.385, 5.41}, 4},
    {{3.0, 0.0, 20.0, 100.0, 100.0}, true, 1.0, {0.97, 1.04, 1.1}, 6},
    {{0.0, 0.3, 17.0, 100.0, INFINITY}, false, 1.7, {1.66, 1.81, 1.93}, 2},
};

static void scene_at(void *data, double at, po_scene *scene) {
  const series *l = data;
  *scene = l->scene;
  *(l->amplitude ? &scene->amplitude : &scene->tabor) = at;
}

static double domain_of(void *data, const po_scene *scene) {
  (void)data;
  return po_trace_domain(scene, po_surface_core(scene, NAN));
}

typedef struct {
  size_t count, most;
  po_solution point[MOST];
  po_point_kind kind[MOST];
  po_arena arrays; /* of the points */
} folds;

static bool keep(const po_branch_point *p, void *data) {
  folds *f = data;
  if (p->kind == PO_POINT_APPROACH_MAX || p->kind == PO_POINT_APPROACH_MIN) {
    ck_assert_uint_lt(f->count, MOST);
    ck_assert_int_eq(po_solution_allocate(&f->point[f->count], p->solution->n, &f->arrays), PO_OK);
    po_solution_copy(p->solution, &f->point[f->count]);
    f->kind[f->count++] = p->kind;
  }
  return f->count == f->most;
}

/* The folds of a trace, on its own panels. */
static void trace(const series *l, folds *f) {
  po_scene scene;
  scene_at((void *)l, l->from, &scene);
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  ck_assert_int_eq(po_surface_create_panels(&scene, domain_of(NULL, &scene), 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&scene, panels, &e), PO_OK);
  e->precision = po_trace_precision(TOLERANCE);
  *f = (folds){.most = l->folds};
  po_continuation_options options = po_continuation_options_default();
  options.visit = keep;
  options.data = f;
  const po_allowance allowed = po_trace_allowance(TOLERANCE);
  ck_assert_int_eq(po_continuation_create(e, allowed, &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  po_continuation_destroy(continuation);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
  ck_assert_uint_eq(f->count, l->folds);
}

/* Creates a follower at the beginning of the series. */
static po_follower *follower_of(const series *l) {
  const po_follow_options options = {.scene_at = scene_at,
                                     .domain_of = domain_of,
                                     .data = (void *)l,
                                     .allowed = po_trace_allowance(TOLERANCE),
                                     .precision = po_trace_precision(TOLERANCE),
                                     .sharpness = TOLERANCE};
  po_follower *follower = NULL;
  ck_assert_int_eq(po_follow_create(&options, l->from, &follower), PO_OK);
  return follower;
}

/* The folds of a full trace of the scene at a value of the parameter. */
static void solve(const series *l, double at, po_result *o) {
  po_request request = po_request_default();
  scene_at((void *)l, at, &request.scene);
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = TOLERANCE;
  ck_assert_int_eq(po_solve(&request, o), PO_OK);
  ck_assert_uint_eq(o->fold_count, l->folds);
}

TABLE_TEST(followed_folds_agree_with_full_traces, SERIES) {
  const series *l = &SERIES[_i];
  folds f = {.arrays = {0}};
  trace(l, &f);
  po_result traced[3];
  for (int k = 0; k < 3; ++k)
    solve(l, l->to[k], &traced[k]);
  po_follower *follower = follower_of(l);
  for (size_t j = 0; j < f.count; ++j) {
    ck_assert_int_eq(po_follow_begin(follower, &f.point[j], PO_OF_APPROACH, l->from), PO_OK);
    for (int k = 0; k < 3; ++k) {
      ck_assert_int_eq(po_follow_to(follower, l->to[k]), PO_OK);
      const po_branch_point p = po_follow_point(follower, true);
      const po_special_point *expected = &traced[k].folds[j];
      ck_assert_int_eq(p.kind, f.kind[j]);
      ck_assert_int_eq(p.kind == PO_POINT_APPROACH_MAX ? PO_JUMP_IN : PO_JUMP_OUT, expected->kind);
      ck_assert_double_eq_tol(p.approach, expected->approach, 1e-6);
      ck_assert_double_eq_tol(p.load, expected->load, 1e-6);
      ck_assert_double_lt(p.approach_error, 1e-6);
      ck_assert_double_lt(p.load_error, 1e-6);
    }
  }
  const po_work work = po_follow_work(follower);
  ck_assert_uint_lt(work.factorizations, 40 * 3 * l->folds); /* error estimates included */
  po_follow_destroy(follower);
  po_arena_free(&f.arrays);
  for (int k = 0; k < 3; ++k)
    po_result_clear(&traced[k]);
}

/* The two folds of a smooth sphere merge at mu = 0.697. Below this value there are none. */
TEST(folds_that_merge_are_not_found_beyond) {
  static const series MERGING = {{0.0, 0.0, 0.0, 100.0, INFINITY}, false, 0.9, {0.75, 0.6, 0.0}, 2};
  folds f = {.arrays = {0}};
  trace(&MERGING, &f);
  po_follower *follower = follower_of(&MERGING);
  for (size_t j = 0; j < f.count; ++j) {
    ck_assert_int_eq(po_follow_begin(follower, &f.point[j], PO_OF_APPROACH, MERGING.from), PO_OK);
    ck_assert_int_eq(po_follow_to(follower, MERGING.to[0]), PO_OK);
    ck_assert_int_eq(po_follow_to(follower, MERGING.to[1]), PO_NOT_FOUND);
  }
  po_arena_free(&f.arrays);
  po_follow_destroy(follower);
}
