/* A reverse trace from the end of the branch must find the folds of the forward trace. The
 * comparison of the two reports it if not. */
#include <math.h>

#include "po_branch_point.h"
#include "po_diagnose.h"
#include "po_solve.h"
#include "run.h"

typedef struct {
  po_scene scene;
  double preload; /* approach */
  size_t folds, extrema;
} expected;

/* The folds of the first scene are in reference/feng_landmarks.csv, those of the second in
 * reference/wavy_landmarks.csv. */
static const expected SCENES[] = {
    {{5.0, 0.0, 0.0, 100.0, INFINITY}, NAN, 4, 3},
    {{3.0, 1.0, 20.0, 100.0, 100.0}, NAN, 6, 5},
    {{0.385, 0.0, 0.0, 71.0, 60.0}, NAN, 0, 1}, /* no fold at all */
    /* on the reverse trace a groove closes; its two edges approach each other ever faster, and a
     * trace whose steps followed them ended there */
    {{1.97598, 6.31644, 9.55822, 201.659, INFINITY}, NAN, 8, 5},
    /* a contact annulus forms between two extrema 0.07 eps apart; a forward trace missed both */
    {{1.78343, 3.51838, 4.03854, 60.7776, INFINITY}, 5.2, 2, 9},
};

TABLE_TEST(reverse_trace_finds_the_same_folds, SCENES) {
  const expected *known = &SCENES[_i];
  po_request request = po_request_default();
  request.scene = known->scene;
  request.preload.approach = known->preload;
  request.mesh.scheme = PO_PANEL;
  /* a tenth of the default: the tolerance is on the force, and the error of a fold may exceed it */
  request.mesh.tolerance = 1e-7;
  po_result plain, o;
  ck_assert_int_eq(po_solve(&request, &plain), PO_OK);
  request.want = PO_WANT_DIAGNOSTICS;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_reverse_trace *way = &o.diagnostics.reverse_trace;
  ck_assert(way->made && way->same);
  ck_assert_int_eq(way->status, PO_OK);
  ck_assert_uint_eq(o.fold_count, known->folds);
  ck_assert_uint_eq(way->folds, known->folds);
  ck_assert_uint_eq(way->extrema, known->extrema);
  ck_assert_uint_gt(way->points, known->folds + known->extrema + 10);
  ck_assert_double_le(way->excess, 1.0);
  ck_assert_double_lt(way->fold_approach, 1e-7);
  ck_assert_double_lt(way->fold_load, 1e-5);
  ck_assert_double_lt(way->extremum_approach, 1e-5);
  ck_assert_double_lt(way->extremum_load, 1e-7);
  if (known->folds > 0) /* other steps and meshes, so not identical */
    ck_assert_double_gt(way->fold_approach, 0.0);
  /* the reverse trace does not change the results and counters of the scene */
  ck_assert_double_eq(o.pull_off.force, plain.pull_off.force);
  ck_assert_uint_eq(o.work.factorizations, plain.work.factorizations);
  ck_assert_uint_eq(o.work.points, plain.work.points);
  po_result_clear(&plain);
  po_result_clear(&o);
}

/* Just before a contact annulus forms, the load has two extrema 0.053 eps apart. At this tolerance
 * an earlier version missed them and ended elsewhere. */
TEST(extrema_just_before_an_annulus_forms_are_found) {
  po_request request = po_request_default();
  request.scene = (po_scene){1.56744, 3.76602, 13.2004, 502.623, 278.158};
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = 1e-4;
  request.preload.approach = 4.6;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_ge(o.extremum_count, 7);
  ck_assert_double_eq_tol(o.extrema[5].approach, 4.452258, 1e-5);
  ck_assert_double_eq_tol(o.extrema[6].approach, 4.505330, 1e-5);
  po_result_clear(&o);
}

/* Points of a synthetic forward trace: fold, minimum, fold, between two others. */
typedef struct {
  bool special;
  po_special_point at;
} passed;
static const passed OUT[] = {
    {false, {.unstable_modes = 0}},
    {true, {.kind = PO_JUMP_IN, .approach = -2.385, .load = -0.31, .unstable_modes = 1}},
    {true, {.kind = PO_MINIMUM, .approach = -2.5, .load = -1.4, .unstable_modes = 1}},
    {true, {.kind = PO_JUMP_OUT, .approach = -2.61, .load = -0.9, .unstable_modes = 0}},
    {false, {.unstable_modes = 0}},
};
enum { COUNT = sizeof OUT / sizeof *OUT };

static void note(po_passage *passage, passed p, double approach_error, bool back) {
  p.at.approach_error = approach_error;
  p.at.load_error = 3e-6;
  ck_assert_int_eq(po_passage_note(passage, p.special ? &p.at : NULL, p.at.unstable_modes, back),
                   PO_OK);
}

/* Compares the points with those of a synthetic reverse trace that ended with `status`. One point
 * is missing (COUNT: none); the point met last but one has another kind, approach and number of
 * unstable modes. */
static po_reverse_trace judge(size_t missing, po_special_kind last, double off, int modes,
                              po_status status) {
  po_kept kept = {.folds = 0};
  for (size_t k = 0; k < COUNT; ++k)
    note(&kept.out, OUT[k], 2e-7, false);
  for (size_t k = COUNT; k-- > 0;) {
    passed p = OUT[k];
    p.at.unstable_modes = k > 0 ? OUT[k - 1].at.unstable_modes : modes;
    if (k == 1) {
      p.at.kind = last;
      p.at.approach += off;
      p.at.unstable_modes = modes;
    }
    if (k != missing)
      note(&kept.back, p, 1e-7, true);
  }
  const po_reverse_trace way = po_reverse_trace_compare(&kept, status);
  po_kept_clear(&kept);
  return way;
}

TEST(differences_are_relative_to_the_errors) {
  const po_reverse_trace way = judge(COUNT, PO_JUMP_IN, 4.5e-7, 0, PO_OK);
  ck_assert(way.same);
  ck_assert_uint_eq(way.folds, 2);
  ck_assert_uint_eq(way.extrema, 1);
  ck_assert_double_eq_tol(way.fold_approach, 4.5e-7, 1e-15);
  ck_assert_double_eq(way.fold_load, 0.0);
  ck_assert_double_eq_tol(way.excess, 1.5, 1e-8);
}

TEST(different_special_points_are_reported) {
  const po_reverse_trace missing = judge(1, PO_JUMP_IN, 0.0, 0, PO_OK);
  ck_assert(!missing.same && isnan(missing.excess));
  ck_assert_uint_eq(missing.folds, 1);
  ck_assert(!judge(2, PO_JUMP_IN, 0.0, 0, PO_OK).same);
  ck_assert(!judge(COUNT, PO_JUMP_OUT, 0.0, 0, PO_OK).same);
  ck_assert(!judge(COUNT, PO_JUMP_IN, 0.0, 1, PO_OK).same);
  ck_assert(!judge(COUNT, PO_JUMP_IN, 0.0, 0, PO_STEP_TOO_SMALL).same);
}
