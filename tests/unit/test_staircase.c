/* The pull-off after every preload: the steps of synthetic curves and of solved scenes, against
 * loops. */
#include <math.h>
#include <stdlib.h>

#include "po_loop.h"
#include "po_solve.h"
#include "po_staircase.h"
#include "request.h"
#include "run.h"

/* A point of a synthetic curve, with its number of unstable modes. */
typedef struct {
  double approach, load;
  int modes;
} synthetic;

enum { MOST = 16 };

static po_path path_of(const synthetic *list, size_t count, po_curve_point point[MOST]) {
  const double small =
      1e-3; /* slopes relative to the secants, so that the curve is near the secants */
  for (size_t k = 0; k < count; ++k) {
    const double before = k > 0 ? list[k].load - list[k - 1].load : 0.0;
    const double after = k + 1 < count ? list[k + 1].load - list[k].load : before;
    const bool minimum = before < 0.0 && after > 0.0;
    point[k] = (po_curve_point){.approach = list[k].approach,
                                .load = list[k].load,
                                .energy = -(double)(k * k),
                                .position = (double)k,
                                .load_rate = minimum ? 0.0 : small * after,
                                .unstable_modes = list[k].modes,
                                .minimum = minimum};
  }
  return (po_path){point, count};
}

/* The staircase of one test along a curve. */
static po_staircase staircase_of(const po_path *path, int test) {
  po_staircases all = {.has_spring = false};
  ck_assert_int_eq(po_staircases_read(path, (double)NAN, &all), PO_OK);
  const po_staircase asked = all.of[test];
  all.of[test] = (po_staircase){.count = 0};
  po_staircases_clear(&all);
  return asked;
}

static void clear(po_staircase staircase) {
  po_staircases all = {.of = {staircase}};
  po_staircases_clear(&all);
}

/* The load falls to a minimum of -1 at approach 1, rises, falls to -2 at 3 and rises again. There
 * is no jump. For preloads between the steps the greatest tension is that at the reversal. */
TEST(minima_on_the_loading_path_are_steps) {
  static const synthetic CURVE[] = {{0, 0, 0}, {1, -1, 0}, {2, -0.5, 0}, {3, -2, 0}, {4, 1, 0}};
  po_curve_point point[MOST];
  const po_path path = path_of(CURVE, 5, point);
  po_staircase s = staircase_of(&path, PO_AT_APPROACH);
  ck_assert_uint_eq(s.count, 2);
  ck_assert(!s.step[0].jumped && !s.step[1].jumped);
  ck_assert_double_eq(s.step[0].preload.approach, 1.0);
  ck_assert_double_eq(s.step[0].pull_off.load, -1.0);
  ck_assert(!s.step[0].open && s.step[1].open);
  ck_assert_double_eq_tol(s.step[0].until.load, -1.0, 1e-12);
  ck_assert_double_gt(s.step[0].until.approach, 2.0);
  ck_assert_double_lt(s.step[0].until.approach, 3.0);
  ck_assert_double_eq(s.step[1].preload.approach, 3.0);
  ck_assert_double_eq(s.step[1].pull_off.load, -2.0);
  ck_assert_double_eq(s.reached.approach, 4.0);
  ck_assert_uint_eq(s.step[1].cycle_count, 1);
  ck_assert_uint_eq(s.step[1].cycle[0].loss.jumps, 0);
  ck_assert_double_eq(s.step[1].cycle[0].loss.energy, 0.0);
  ck_assert_ptr_eq(po_staircase_greatest(&s), &s.step[1]);
  clear(s);
}

/* The jump at the fold at approach 2 leads to a stable stretch that reaches back to 0.5 and has a
 * minimum of -3. The jump at 5 leads to a stretch with less tension in unloading. So the pull-off
 * force decreases with the preload. */
TEST(a_harder_preload_may_give_a_smaller_force) {
  static const synthetic CURVE[] = {{-2, 0, 0}, {2, -1, 1},    {0.5, -2, 0}, {1, -3, 0},
                                    {5, 2, 1},  {-1, -0.5, 0}, {1.5, 0, 0},  {9, 9, 0}};
  po_curve_point point[MOST];
  const po_path path = path_of(CURVE, 8, point);
  po_staircase s = staircase_of(&path, PO_AT_APPROACH);
  ck_assert_uint_eq(s.count, 2);
  ck_assert(s.step[0].jumped && s.step[1].jumped);
  ck_assert_double_eq(s.step[0].preload.approach, 2.0);
  ck_assert_double_eq(s.step[0].pull_off.load, -3.0);
  ck_assert_double_eq(s.step[1].preload.approach, 5.0);
  ck_assert_double_eq(s.step[1].pull_off.load, -0.5);
  ck_assert_ptr_eq(po_staircase_greatest(&s), &s.step[0]);
  for (size_t k = 0; k < 2; ++k) { /* loops with preloads just beyond the jumps */
    po_hysteresis loops;
    const po_preload preload = {s.step[k].preload.approach + 1e-3, NAN};
    ck_assert_int_eq(po_hysteresis_follow(&path, preload, INFINITY, false, &loops), PO_OK);
    const po_loop *loop = &loops.of[PO_AT_APPROACH];
    ck_assert_double_eq(loop->pull_off.load, s.step[k].pull_off.load);
    ck_assert_uint_eq(loop->jump_count, s.step[k].cycle[0].loss.jumps);
    ck_assert_double_eq_tol(loop->energy_lost, s.step[k].cycle[0].loss.energy, 1e-12);
    po_hysteresis_clear(&loops);
  }
  clear(s);
}

/* Where the base of a spring turns between two points, what the panels miss of the load there, over
 * the stiffness, is an error of its position. */
TEST(the_turn_of_a_base_has_the_error_of_the_load_beside_it) {
  const double stiffness = 0.5, error = 0.02;
  const po_curve_point ends[] = {{.approach_rate = 1.0, .load_error = 0.5 * error},
                                 {.position = 1.0,
                                  .approach = 1.0,
                                  .load = -stiffness,
                                  .approach_rate = 1.0,
                                  .load_rate = -2.0 * stiffness,
                                  .load_error = error}};
  po_path path = {.point = ends, .count = 2};
  po_curve_point *point;
  ck_assert_int_eq(po_path_add_extrema(&path, stiffness, &point), PO_OK);
  ck_assert_uint_eq(path.count, 3);
  ck_assert_double_eq_tol(path.point[1].held_miss, error / stiffness, 1e-15);
  free(point);
}

/* A point next to a minimum may lie below it by the discretisation error. A test measures the
 * minimum. An earlier version gave one of 1,000 random scenes a pull-off that no preload produces.
 */
TEST(a_step_begins_at_the_minimum_itself) {
  static const synthetic CURVE[] = {
      {0, 0, 0}, {1, -1.00001, 0}, {1.1, -1, 0}, {1.2, -1.00001, 0}, {4, 1, 0}};
  po_curve_point point[MOST];
  const po_path path = path_of(CURVE, 5, point);
  po_staircase s;
  for (size_t k = 0; k < 5; ++k) {
    point[k].minimum = k == 2;
    point[k].load_rate = k < 2 ? -1e-3 : k > 2 ? 1e-3 : 0.0;
  }
  s = staircase_of(&path, PO_AT_APPROACH);
  ck_assert_uint_eq(s.count, 1);
  ck_assert_double_eq(s.step[0].preload.position, 2.0);
  ck_assert_double_eq(s.step[0].pull_off.position, 2.0);
  clear(s);
}

TEST(a_curve_without_minima_has_no_steps) {
  static const synthetic CURVE[] = {{0, -0.1, 0}, {1, -1, 0}, {2, -2, 0}};
  po_curve_point point[MOST];
  const po_path path = path_of(CURVE, 3, point), none = {point, 0};
  po_staircase s = staircase_of(&path, PO_AT_APPROACH);
  ck_assert_uint_eq(s.count, 0);
  ck_assert_ptr_null(po_staircase_greatest(&s));
  s = staircase_of(&path, PO_AT_LOAD);
  ck_assert_uint_eq(s.count, 0);
  s = staircase_of(&none, PO_AT_LOAD);
  ck_assert_uint_eq(s.count, 0);
}

/* A bound of the load that is never reached, so that a search goes on to the hardest preload, and a
 * bound that is always reached. */
static double never_met(const po_scene *scene, double load) {
  (void)scene;
  (void)load;
  return 1e9;
}
static double always_met(const po_scene *scene, double load) {
  (void)scene;
  (void)load;
  return 0.0;
}
static const po_theories NEVER = {.bound = never_met}, ALWAYS = {.bound = always_met};

/* Every step of solved scenes is compared with loops of separate solves, whose preloads are just
 * inside the step and just below it. */
static const po_scene SCENES[] = {{3.0, 10.15, 50.0, 50.0, INFINITY},
                                  {2.911, 7.784, 35.18, 56.7, INFINITY},
                                  {2.385, 0.37, 13.7, 61.3, 61.3},
                                  {1.3, 0.7, 23.85, 100.0, INFINITY}};

/* The pull-off in the loop of a separate solve, at given approach. */
static po_path_state pulled(po_request request, double preload) {
  po_result o;
  request.want = PO_WANT_HYSTERESIS;
  request.preload = (po_preload){preload, NAN};
  ck_assert_msg(!po_solve(&request, &o), "preload %.12g: %s", preload, o.reason);
  const po_path_state pull_off = o.hysteresis.of[PO_AT_APPROACH].pull_off;
  po_result_clear(&o);
  return pull_off;
}

TABLE_TEST(steps_agree_with_separate_loops, SCENES) {
  const double near = 1e-3;
  po_request request = po_request_default();
  request.scene = SCENES[_i];
  request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = 1e-5};
  request.want = PO_WANT_PRELOAD;
  request.theories = &ALWAYS;
  request.preload.load = 4.0;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(o.has_staircases);
  const po_staircase *s = &o.staircase.of[0];
  ck_assert_uint_ge(s->count, 1);
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    const double error = 2.0 * step->pull_off_error.load + 1e-5;
    const double at = step->preload.approach;
    po_path_state above = pulled(request, at + near);
    ck_assert_double_eq_tol(above.load, step->pull_off.load, error);
    if (!step->open) {
      above = pulled(request, step->until.approach - near);
      ck_assert_double_eq_tol(above.load, step->pull_off.load, error);
    }
    if (k > 0 && step->jumped && s->step[k - 1].until.approach == at)
      ck_assert_double_eq_tol(pulled(request, at - near).load, s->step[k - 1].pull_off.load, error);
  }
  po_result_clear(&o);
}

/* A scene whose pull-off depends strongly on the preload. The expected values are from separate
 * traces. */
TEST(steps_of_a_scene_are_accurate) {
  po_request request = po_request_default();
  request.scene = SCENES[0];
  request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = 1e-6};
  request.want = PO_WANT_PRELOAD;
  request.theories = &ALWAYS;
  request.preload.load = 5.0;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_staircase *s = &o.staircase.of[0];
  static const double STEPS[][3] = {
      {-1.1110996, -0.1978146, 0.19781}, {20.5358, 1.5231, 4.10804}, {26.5580, 3.0095, 14.40819}};
  ck_assert_uint_eq(s->count, 3);
  for (size_t k = 0; k < 3; ++k) {
    ck_assert_double_eq_tol(s->step[k].preload.approach, STEPS[k][0], 1e-4);
    ck_assert_double_eq_tol(s->step[k].preload.load, STEPS[k][1], 1e-4);
    ck_assert_double_eq_tol(-s->step[k].pull_off.load, STEPS[k][2], 1e-5);
    ck_assert_double_lt(s->step[k].pull_off_error.load, 1e-6);
  }
  ck_assert_double_eq(o.pull_off_any.force, -s->step[2].pull_off.load);
  ck_assert_double_eq(o.pull_off_any.pressed.approach, s->step[2].preload.approach);
  /* the preload of this request, the load 5, is beyond all steps */
  ck_assert_double_eq(o.pull_off.pressed.approach, s->step[2].preload.approach);
  po_result_clear(&o);
}

/* The default preload is the load pi w R. A search beyond it does not change the pull-off after it.
 */
LOOP_TEST(a_search_does_not_change_the_pull_off, 0, 3) {
  static const po_search SEARCH[] = {PO_SEARCH_NONE, PO_SEARCH_SOME, PO_SEARCH_ALL};
  po_request request = po_request_default();
  request.scene = SCENES[0];
  request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = 1e-6};
  request.theories = &NEVER;
  request.search = SEARCH[_i];
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.pull_off.force, 0.197814606, 1e-7);
  ck_assert_double_eq_tol(o.pull_off.pressed.approach, -1.1110996, 1e-6);
  ck_assert(o.pull_off_any.is_known && !o.pull_off_any.complete);
  ck_assert_int_eq(o.ended.cause, _i ? PO_END_SEARCHED : PO_END_PRELOAD);
  if (_i == 0)
    ck_assert_double_lt(o.ended.load, 2.0); /* about a step beyond the preload */
  if (_i == 2) {
    ck_assert_double_gt(o.ended.load, 100.0);
    ck_assert_double_eq_tol(o.pull_off_any.force, 14.40819, 1e-5);
    ck_assert_double_eq_tol(o.pull_off.until.approach, 20.5358, 1e-4);
  }
  po_result_clear(&o);
}

/* With an unlimited preload the pull-off is the greatest of all, and the trace ends when the bound
 * is reached. */
TEST(an_unlimited_preload_gives_the_greatest_pull_off) {
  po_request request = po_request_default();
  request.scene = SCENES[1];
  request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = 1e-4};
  request.preload.approach = INFINITY;
  request.theories = &NEVER;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.pull_off.force, 8.49669, 1e-4);
  ck_assert_double_eq_tol(o.pull_off_any.force, o.pull_off.force, 1e-9);
  ck_assert(!o.pull_off_any.complete);
  po_result_clear(&o);
  request.theories = &ALWAYS;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_int_eq(o.ended.cause, PO_END_COMPLETE);
  ck_assert(o.pull_off_any.complete);
  ck_assert_double_lt(o.ended.load, 3.0); /* the bound is reached early */
  po_result_clear(&o);
}

/* A small bounded surface. When all of it is in contact, no harder preload changes the pull-off,
 * whatever the bound says. An earlier version pressed this one further until the nodes were
 * exhausted, and failed. */
LOOP_TEST(a_bounded_surface_in_full_contact_is_complete, 0, 2) {
  static const po_search SEARCH[] = {PO_SEARCH_SOME, PO_SEARCH_ALL};
  po_request request = po_request_default();
  request.scene = (po_scene){4.84366, 0.152139, 21.7469, 33.9995, 9.58721};
  request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = 1e-4};
  request.theories = &NEVER;
  request.search = SEARCH[_i];
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_int_eq(o.ended.cause, PO_END_COMPLETE);
  ck_assert(o.pull_off_any.complete);
  ck_assert_double_eq_tol(o.pull_off.force, 0.709603, 1e-5);
  po_result_clear(&o);
}
