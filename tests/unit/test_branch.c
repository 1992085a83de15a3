/* The branch: folds, extrema, stability, stations, ends. No special point is missed. */
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_special_point.h"
#include "run.h"
#include "trace.h"

enum { MOST = 64 };

typedef struct {
  po_branch_point point[MOST];
  int count, steps, sign_changes, wrong_modes;
  double last_approach, last_rate, rise_of_load, work; /* integral of load d approach */
  po_equilibrium *e;
} seen;

static bool look(const po_branch_point *p, void *data) {
  seen *s = data;
  if (p->kind != PO_POINT_STEP && s->count < MOST)
    s->point[s->count++] = *p;
  if (p->kind == PO_POINT_STEP) {
    ++s->steps;
    if (s->last_rate * p->approach_rate < 0.0)
      ++s->sign_changes;
    s->last_rate = p->approach_rate;
  }
  s->last_approach = p->approach;
  return p->load > 0.5 && p->unstable_modes == 0;
}

/* Traces a scene and returns its special points. */
static seen trace_on(const po_scene *scene, const po_mesh *mesh, double station) {
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  ck_assert_int_eq(po_surface_create(scene, mesh, po_surface_core(scene, NAN), true, &surface),
                   PO_OK);
  ck_assert_int_eq(po_equilibrium_create(scene, surface, &e), PO_OK);
  seen s = {.e = e};
  po_continuation_options options = po_continuation_options_default();
  options.visit = look;
  options.data = &s;
  options.station[0] = station;
  ck_assert_int_eq(trace_fixed(e, &options), PO_OK);
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
  return s;
}

/* Traces a smooth sphere on triangles. */
static seen trace(double tabor, size_t nodes, double outer, double station) {
  po_scene scene = po_scene_default();
  scene.tabor = tabor;
  scene.outer_radius = outer;
  const po_mesh mesh = {PO_TRIANGLE, PO_UNIFORM, nodes, 0.0};
  return trace_on(&scene, &mesh, station);
}

static int count_of(const seen *s, po_point_kind kind) {
  int count = 0;
  for (int k = 0; k < s->count; ++k)
    count += s->point[k].kind == kind;
  return count;
}

/* The curve of load against approach is S-shaped from mu = 0.697 on, not from mu = 1. At 0.70 the
 * two folds are 1.2e-4 apart in approach (reference/feng_landmarks.csv); an earlier version stepped
 * over them. */
TEST(smooth_sphere_folds_from_0_697_on) {
  const seen below = trace(0.69, 801, INFINITY, NAN), above = trace(0.70, 801, INFINITY, NAN);
  ck_assert_int_eq(count_of(&below, PO_POINT_APPROACH_MAX), 0);
  ck_assert_int_eq(count_of(&above, PO_POINT_APPROACH_MAX), 1);
  ck_assert_int_eq(count_of(&above, PO_POINT_APPROACH_MIN), 1);
  ck_assert_int_eq(count_of(&above, PO_POINT_LOAD_MIN), 1);
}

TEST(folds_alternate_and_account_for_every_turn) {
  /* The mesh is so coarse that it has spurious folds; these must not be missed either. */
  const seen s = trace(3.0, 301, INFINITY, NAN);
  int turns = 0;
  po_point_kind last = PO_POINT_APPROACH_MIN;
  for (int k = 0; k < s.count; ++k) {
    const po_point_kind kind = s.point[k].kind;
    if (kind != PO_POINT_APPROACH_MAX && kind != PO_POINT_APPROACH_MIN)
      continue;
    ck_assert_int_ne(kind, last);
    last = kind;
    ++turns;
    ck_assert_double_eq_tol(s.point[k].approach_rate, 0.0, 1e-5);
  }
  ck_assert_int_ge(turns, 2);
  ck_assert_int_eq(turns % 2, 0);
  ck_assert_int_le(s.sign_changes, turns);
  ck_assert_int_eq((turns - s.sign_changes) % 2, 0);
}

/* On 201 rings at mu = 2.6421 the approach turns twice within 6e-4. Steps whose predictions erred
 * by up to 0.2 of 1 + H passed over both folds. */
TEST(folds_near_each_other_are_found) {
  po_scene scene = po_scene_default();
  scene.tabor = 2.6421;
  const po_mesh mesh = {PO_RING, PO_UNIFORM, 201, 0.0};
  const seen s = trace_on(&scene, &mesh, NAN);
  ck_assert_int_eq(count_of(&s, PO_POINT_APPROACH_MAX), 2);
  ck_assert_int_eq(count_of(&s, PO_POINT_APPROACH_MIN), 2);
}

/* On the same mesh, another sequence of steps gives the same special points to 1e-10. */
TEST(special_points_do_not_depend_on_the_steps) {
  const seen a = trace(1.3, 201, 60.0, NAN), b = trace(1.3, 201, 60.0, -1.9);
  ck_assert_int_eq(a.count + 1, b.count); /* the station */
  for (int k = 0, j = 0; k < a.count; ++k, ++j) {
    if (b.point[j].kind == PO_POINT_STATION) {
      ck_assert_double_eq_tol(b.point[j].approach, -1.9, 1e-11);
      ++j;
    }
    ck_assert_int_eq(a.point[k].kind, b.point[j].kind);
    ck_assert_double_eq_tol(a.point[k].approach, b.point[j].approach, 1e-6);
    ck_assert_double_eq_tol(a.point[k].load, b.point[j].load, 1e-10);
    if (a.point[k].kind == PO_POINT_APPROACH_MAX || a.point[k].kind == PO_POINT_APPROACH_MIN)
      ck_assert_double_eq_tol(a.point[k].approach, b.point[j].approach, 1e-10);
  }
}

/* Number of negative eigenvalues of the Jacobian I - coupling G diag(slope). This is the number of
 * unstable modes, which the trace counts from the turns of the curve instead. */
static int unstable_modes_of(const po_equilibrium *e) {
  const size_t n = e->n;
  double *influence = malloc(n * n * sizeof *influence);
  po_surface_fill_matrix(e->surface, influence);
  gsl_matrix *m = gsl_matrix_alloc(n, n);
  gsl_vector_complex *values = gsl_vector_complex_alloc(n);
  gsl_eigen_nonsymm_workspace *space = gsl_eigen_nonsymm_alloc(n);
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j)
      gsl_matrix_set(m, i, j, (i == j) - e->coupling * influence[i + n * j] * e->slope[j]);
  gsl_eigen_nonsymm(m, values, space);
  int below = 0;
  for (size_t i = 0; i < n; ++i)
    below += GSL_REAL(gsl_vector_complex_get(values, i)) < 0.0;
  free(influence);
  gsl_matrix_free(m);
  gsl_vector_complex_free(values);
  gsl_eigen_nonsymm_free(space);
  return below;
}

static bool count_modes(const po_branch_point *p, void *data) {
  seen *s = data;
  if (p->kind == PO_POINT_STEP && ++s->steps % 4 == 0) {
    po_equilibrium_evaluate(s->e, p->gap);
    s->wrong_modes += unstable_modes_of(s->e) != p->unstable_modes;
  }
  return p->load > 0.5 && p->unstable_modes == 0;
}

LOOP_TEST(unstable_modes_agree_with_the_eigenvalues, 0, 3) {
  static const double SCENES[][3] = {{1.5, 0.0, 0.0}, {5.0, 0.0, 0.0}, {3.0, 1.0, 20.0}};
  const po_scene scene = {SCENES[_i][0], SCENES[_i][1], SCENES[_i][2], 100.0, 60.0};
  const po_mesh mesh = {PO_TRIANGLE, PO_UNIFORM, 81, 0.0};
  po_surface *surface = NULL;
  seen s = {.count = 0};
  ck_assert_int_eq(po_surface_create(&scene, &mesh, 60.0, true, &surface), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&scene, surface, &s.e), PO_OK);
  po_continuation_options options = po_continuation_options_default();
  options.visit = count_modes;
  options.data = &s;
  ck_assert_int_eq(trace_fixed(s.e, &options), PO_OK);
  ck_assert_int_eq(s.wrong_modes, 0);
  po_equilibrium_destroy(s.e);
  po_surface_destroy(surface);
}

static bool never(const po_branch_point *p, void *data) {
  (void)p;
  (void)data;
  return false;
}

TEST(trace_ends_at_its_end_or_at_the_limit_of_points) {
  po_scene scene = po_scene_default();
  const po_mesh mesh = {PO_RING, PO_GRADED, 101, 0.0};
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  seen s = {.count = 0};
  ck_assert_int_eq(po_surface_create(&scene, &mesh, po_surface_core(&scene, 2.385), true, &surface),
                   PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&scene, surface, &e), PO_OK);
  po_continuation_options options = po_continuation_options_default();
  options.visit = look;
  options.data = &s;
  options.end = 1.385;
  ck_assert_int_eq(trace_fixed(e, &options), PO_OK);
  ck_assert_double_eq_tol(s.last_approach, 1.385, 1e-11);
  options.visit = never;
  options.end = NAN;
  options.most_points = 17;
  ck_assert_int_eq(trace_fixed(e, &options), PO_TOO_MANY_POINTS);
  ck_assert_ptr_nonnull(strstr(po_message(), "17 points"));
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
}

/* A curve with one fold: the approach is a parabola of the parameter, the load the parameter. */
static po_status solve_parabola(void *data, double at, bool roughly, po_sample *sample) {
  (void)data;
  (void)roughly;
  *sample = (po_sample){
      .at = at, .value = {0.3 - pow(at - 0.45, 2.0), at}, .rate = {-2.0 * (at - 0.45), 1.0}};
  return PO_OK;
}

static void keep_nothing(void *data, size_t place) {
  (void)data;
  (void)place;
}

/* An approach just below a fold is passed twice in the step that contains the fold, and neither end
 * of the step shows it. `solve --tabor 1 --approach-end -1.6295` went past both and ended at the
 * third passage. */
TEST(an_approach_that_a_fold_hides_is_met_before_and_after_it) {
  const double station[PO_STATIONS] = {0.29, NAN};
  const po_interval interval = {.solve = solve_parabola,
                                .keep = keep_nothing,
                                .station = station,
                                .station_load = NAN,
                                .end = 0.2996};
  po_sample from, to;
  po_events found;
  solve_parabola(NULL, 0.0, false, &from);
  solve_parabola(NULL, 1.0, false, &to);
  ck_assert_int_eq(po_events_find(&interval, &from, &to, &found), PO_OK);
  static const double EXPECTED[] = {0.35, 0.43, 0.45, 0.47, 0.55};
  static const po_event_kind KINDS[] = {PO_AT_STATION, PO_AT_END, PO_OF_APPROACH, PO_AT_END,
                                        PO_AT_STATION};
  ck_assert_uint_eq(found.count, 5);
  for (size_t k = 0; k < found.count; ++k) {
    ck_assert_double_eq_tol(found.list[k].root, EXPECTED[k], 1e-8);
    ck_assert_int_eq(found.list[k].of, KINDS[k]);
  }
}
/* The same with the load as the parabola, and the approach as the parameter. */
static po_status solve_crest(void *data, double at, bool roughly, po_sample *sample) {
  po_sample s;
  const po_status status = solve_parabola(data, at, roughly, &s);
  *sample =
      (po_sample){.at = at, .value = {s.value[1], s.value[0]}, .rate = {s.rate[1], s.rate[0]}};
  return status;
}

TEST(a_load_that_a_maximum_hides_is_met_before_and_after_it) {
  const double station[PO_STATIONS] = {0.46, NAN};
  const po_interval interval = {.solve = solve_crest,
                                .keep = keep_nothing,
                                .station = station,
                                .station_load = 0.2984,
                                .end = NAN};
  po_sample from, to;
  po_events found;
  solve_crest(NULL, 0.0, false, &from);
  solve_crest(NULL, 1.0, false, &to);
  ck_assert_int_eq(po_events_find(&interval, &from, &to, &found), PO_OK);
  static const double EXPECTED[] = {0.41, 0.45, 0.46, 0.49};
  static const po_event_kind KINDS[] = {PO_AT_STATION_LOAD, PO_OF_LOAD, PO_AT_STATION,
                                        PO_AT_STATION_LOAD};
  ck_assert_uint_eq(found.count, 4);
  for (size_t k = 0; k < found.count; ++k) {
    ck_assert_double_eq_tol(found.list[k].root, EXPECTED[k], 1e-8);
    ck_assert_int_eq(found.list[k].of, KINDS[k]);
  }
}
