/* The pull-off along a series of scenes, followed from checkpoint to checkpoint, against a full
 * trace of each scene. */
#include <math.h>

#include "po_follow.h"
#include "po_random.h"
#include "po_series.h"
#include "po_solve.h"
#include "po_solve_internal.h"
#include "run.h"

enum { MOST = 24, SEED = 2385 };

/* A series of scenes: the parameter that varies, its range, and the other parameters. Lengths are
 * in units of epsilon; outer_radius 0: unbounded. */
typedef struct {
  char key; /* t: tabor, a: amplitude, w: wavelength, r: amplitude and wavelength in proportion */
  double from, to;
  size_t count;
  double tabor, amplitude, wavelength, outer_radius;
} series_words;

static const series_words SERIES[] = {
    /* the contact pulls off at the first crest, later at the second; a minimum appears, another
       ends */
    {'t', 0.11, 1.13, 16, 0, 1.0, 20.0, 100.0},
    /* at the second crest, later at the third */
    {'t', 1.31, 4.2, 13, 0, 1.0, 20.0, 100.0},
    /* two folds appear near 0.697; they do not change the minimum */
    {'t', 0.61, 0.83, 12, 0, 0.0, 0.0, 0.0},
    {'t', 0.4, 3.1, 12, 0, 0.0, 0.0, 90.0},
    {'a', 0.023, 2.7, 14, 0.87, 0, 23.85, 0.0},
    {'w', 9.1, 31.0, 16, 0.71, 0.6, 0, 0.0},
    {'r', 0.31, 1.43, 12, 1.17, 0.4, 17.3, 80.0},
    {'a', 0.3, 19.0, 14, 0.43, 0, 20.0, 100.0},
};

static void make_series(const series_words *w, po_request *request) {
  for (size_t k = 0; k < w->count; ++k) {
    const double value = w->from * pow(w->to / w->from, (double)k / (double)(w->count - 1));
    request[k] = po_request_default();
    request[k].mesh.scheme = PO_PANEL;
    request[k].mesh.tolerance = 1e-5;
    po_scene *s = &request[k].scene;
    s->tabor = w->key == 't' ? value : w->tabor;
    s->amplitude = w->key == 'a' ? value : w->amplitude * (w->key == 'r' ? value : 1.0);
    s->wavelength = w->key == 'w' ? value : w->wavelength * (w->key == 'r' ? value : 1.0);
    s->outer_radius = w->outer_radius > 0.0 ? w->outer_radius : INFINITY;
  }
}

/* The ends of each series are checkpoints. Of the other scenes that were followed, a random
 * selection is compared. */
TABLE_TEST(followed_pull_off_agrees_with_full_traces, SERIES) {
  static po_request request[MOST];
  static po_result result[MOST];
  const series_words *w = &SERIES[_i];
  make_series(w, request);
  ck_assert_int_eq(po_series_pull_offs(request, w->count, 7, result), PO_OK);
  ck_assert(!result[0].followed && !result[w->count - 1].followed);
  size_t checked = 0;
  for (size_t k = 0; k < w->count; ++k) {
    ck_assert_int_eq(result[k].status, PO_OK);
    ck_assert(result[k].has_pull_off);
    const double chance = po_random_uniform(SEED, (uint64_t)(_i * MOST) + k, "check");
    if (!result[k].followed || chance > 0.6)
      continue;
    po_result traced;
    ck_assert_int_eq(po_solve(&request[k], &traced), PO_OK);
    ck_assert_double_le(fabs(result[k].pull_off.force - traced.pull_off.force),
                        result[k].pull_off.force_error + traced.pull_off.force_error);
    ck_assert_double_le(fabs(result[k].pull_off.approach - traced.pull_off.approach),
                        result[k].pull_off.approach_error + traced.pull_off.approach_error);
    /* the radius is interpolated linearly between the nodes; this only decides which wave it is at
     */
    ck_assert_double_eq_tol(result[k].pull_off.contact_radius, traced.pull_off.contact_radius,
                            0.05);
    ck_assert_double_le(result[k].pull_off.force_error, 1e-5 * result[k].pull_off.force);
    po_result_clear(&traced);
    ++checked;
  }
  ck_assert_uint_ge(checked, 3);
  for (size_t k = 0; k < w->count; ++k)
    po_result_clear(&result[k]);
}

/* The minimum that is deepest in the middle does not exist at one end of the series, and is far
 * from the deepest at the other: 0.69 of its depth. */
TEST(minimum_that_is_deepest_only_between_checkpoints_is_found) {
  static const series_words WORDS = {'t', 2.5, 5.0, 4, 0, 5.02378, 20.0, 100.0};
  static po_request request[MOST];
  static po_result result[MOST];
  po_result traced;
  make_series(&WORDS, request);
  ck_assert_int_eq(po_series_pull_offs(request, WORDS.count, MOST, result), PO_OK);
  ck_assert_int_eq(po_solve(&request[1], &traced), PO_OK);
  ck_assert_double_eq_tol(result[1].pull_off.force, traced.pull_off.force, 2e-5);
  ck_assert_double_eq_tol(result[1].pull_off.approach, traced.pull_off.approach, 1e-4);
  ck_assert_double_gt(traced.pull_off.contact_radius, 30.0);
  po_result_clear(&traced);
  for (size_t k = 0; k < WORDS.count; ++k)
    po_result_clear(&result[k]);
}

/* The deepest minimum at one end of the series moves beyond the preload, where a trace ends before
 * it. It still exists at the other end, shallower than the pull-off. An earlier version gave a
 * pull-off of 5.1996 instead of 2.4515. */
TEST(minima_beyond_the_preload_are_not_the_pull_off) {
  enum { COUNT = 8 };
  po_request request[COUNT];
  po_result result[COUNT];
  for (size_t k = 0; k < COUNT; ++k) {
    request[k] = po_request_default();
    request[k].mesh.scheme = PO_PANEL;
    request[k].mesh.tolerance = 1e-4;
    request[k].scene =
        (po_scene){3.0, 5.0 * pow(1.7, (double)k / (COUNT - 1)), 50.0, 200.0, INFINITY};
  }
  ck_assert_int_eq(po_series_pull_offs(request, COUNT, COUNT, result), PO_OK);
  size_t followed = 0;
  for (size_t k = 0; k < COUNT; ++k) {
    po_result traced;
    ck_assert_int_eq(po_solve(&request[k], &traced), PO_OK);
    ck_assert_double_le(fabs(result[k].pull_off.force - traced.pull_off.force),
                        result[k].pull_off.force_error + traced.pull_off.force_error);
    followed += result[k].followed;
    po_result_clear(&traced);
    po_result_clear(&result[k]);
  }
  ck_assert_uint_ge(followed, 2);
}

/* Two checkpoints whose minima rise from wave to wave, and fall again before the trace ends. A
 * trace of a scene between them would not end at the rise. */
TEST(one_rise_of_the_minima_does_not_end_the_series) {
  enum { COUNT = 11 };
  po_request request[COUNT];
  po_result result[COUNT], traced;
  for (size_t k = 0; k < COUNT; ++k) {
    request[k] = po_request_default();
    request[k].mesh.scheme = PO_PANEL;
    request[k].mesh.tolerance = 1e-4;
    request[k].scene =
        (po_scene){1.42 * pow(1.94, (double)k / (COUNT - 1)), 1.464, 5.0, 100.0, 100.0};
  }
  ck_assert_int_eq(po_series_pull_offs(request, COUNT, COUNT - 1, result), PO_OK);
  for (size_t k = 0; k < COUNT; ++k)
    ck_assert_int_eq(result[k].followed, k > 0 && k + 1 < COUNT);
  ck_assert_int_eq(po_solve(&request[6], &traced), PO_OK);
  ck_assert_double_le(fabs(result[6].pull_off.force - traced.pull_off.force),
                      result[6].pull_off.force_error + traced.pull_off.force_error);
  po_result_clear(&traced);
  for (size_t k = 0; k < COUNT; ++k)
    po_result_clear(&result[k]);
}

/* Series in which no minimum ends: a followed scene needs less than a tenth of the factorisations
 * of a traced one. */
LOOP_TEST(following_takes_few_factorizations, 2, 4) {
  static po_request request[MOST];
  static po_result result[MOST];
  const series_words *w = &SERIES[_i];
  make_series(w, request);
  ck_assert_int_eq(po_series_pull_offs(request, w->count, MOST, result), PO_OK);
  double traced = 0.0, followed = 0.0;
  size_t many = 0;
  for (size_t k = 0; k < w->count; ++k) {
    *(result[k].followed ? &followed : &traced) += (double)result[k].work.factorizations;
    many += result[k].followed;
  }
  const double each = traced / (double)(w->count - many);
  ck_assert_uint_ge(many, w->count - 3);
  ck_assert_double_lt(10.0 * followed / (double)many, each);
  for (size_t k = 0; k < w->count; ++k)
    po_result_clear(&result[k]);
}

/* Scenes that cannot be followed are traced: rigid ones, a smooth one next to a wavy one, a bounded
 * surface next to an unbounded one. The trace of a series does not solve folds again on a finer
 * mesh, so the iterations beside a minimum begin with other factors than those of a trace alone:
 * the forces agree to the precision of Newton's method. */
TEST(scenes_that_cannot_be_followed_are_traced) {
  static const po_scene SCENES[] = {
      {0.0, 0.9, 21.0, 100.0, 90.0}, {0.0, 0.8, 21.0, 100.0, 90.0},
      {0.7, 0.8, 21.0, 100.0, 90.0}, {0.7, 0.0, 21.0, 100.0, 90.0},
      {0.8, 0.0, 21.0, 100.0, 90.0}, {0.8, 0.0, 21.0, 100.0, INFINITY},
  };
  enum { COUNT = sizeof SCENES / sizeof *SCENES };
  po_request request[COUNT];
  po_result result[COUNT];
  for (size_t k = 0; k < COUNT; ++k) {
    request[k] = po_request_default();
    request[k].mesh.scheme = PO_PANEL;
    request[k].mesh.tolerance = 1e-4;
    request[k].scene = SCENES[k];
  }
  ck_assert_int_eq(po_series_pull_offs(request, COUNT, COUNT, result), PO_OK);
  for (size_t k = 0; k < COUNT; ++k) {
    po_result alone;
    ck_assert_int_eq(po_solve(&request[k], &alone), PO_OK);
    ck_assert(!result[k].followed);
    ck_assert_double_eq_tol(result[k].pull_off.force, alone.pull_off.force, 1e-12);
    po_result_clear(&alone);
    po_result_clear(&result[k]);
  }
}

/* A wavy sphere, with the logarithm of the amplitude as the parameter, counted from a large number,
 * so that steps are rounded. */
typedef struct {
  double domain, target, nearest; /* least distance of a step from the target that is not 0 */
} wave_series;

static const double COUNTED_FROM = 1000.0;

static void wave_at(void *data, double at, po_scene *scene) {
  wave_series *s = data;
  *scene = po_scene_default();
  scene->tabor = 3.0;
  scene->wavelength = 20.0;
  scene->amplitude = exp(at - COUNTED_FROM);
  if (at != s->target)
    s->nearest = fmin(s->nearest, fabs(at - s->target));
}

static double same_domain(void *data, const po_scene *scene) {
  (void)scene;
  return ((wave_series *)data)->domain;
}

/* Half of the rest, twice, is the rest but for rounding: what remains is no step. */
TEST(rounding_leaves_no_step) {
  po_request request = po_request_default();
  request.mesh.tolerance = 1e-5;
  request.preload.load = 1.0;
  request.scene.tabor = 3.0;
  request.scene.wavelength = 20.0;
  request.scene.amplitude = 0.3;
  po_kept_points kept = {.which = PO_KEEP_MINIMA};
  po_result result;
  ck_assert_int_eq(po_solve_kept(&request, &kept, &result), PO_OK);
  ck_assert_uint_ge(kept.count, 1);
  const double begin = COUNTED_FROM + log(0.3);
  int halved = 0;
  for (int k = 0; k < 24; ++k) {
    const po_solution *deepest = &kept.points[kept.count - 1].point;
    wave_series s = {deepest->domain, begin + 0.5 + 0.0371 * k, INFINITY};
    const po_follow_options options = {.scene_at = wave_at,
                                       .domain_of = same_domain,
                                       .data = &s,
                                       .allowed = po_trace_allowance(1e-5),
                                       .precision = po_trace_precision(1e-5),
                                       .sharpness = 1e-5};
    po_follower *f = NULL;
    ck_assert_int_eq(po_follow_create(&options, begin, &f), PO_OK);
    ck_assert_int_eq(po_follow_begin(f, deepest, PO_OF_LOAD, begin), PO_OK);
    s.nearest = INFINITY;
    ck_assert_int_eq(po_follow_to(f, s.target), PO_OK);
    ck_assert_double_gt(s.nearest, 1e-6);
    halved += s.nearest < 0.6 * (s.target - begin);
    po_follow_destroy(f);
  }
  ck_assert_int_ge(halved, 12);
  po_kept_points_clear(&kept);
  po_result_clear(&result);
}
