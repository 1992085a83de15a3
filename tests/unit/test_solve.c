/* Quantities that are computed from a branch: pull-off against known values, curves, profiles,
 * preloads. */
#include <math.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_path.h"
#include "po_solve.h"
#include "request.h"
#include "run.h"

/* Values of an unrelated ring solver, each +- 3e-5. */
LOOP_TEST(smooth_sphere_against_another_code, 0, 3) {
  static const double KNOWN[][3] = {
      {1.0, 1.67067, -0.8734}, {2.0, 1.5836, -1.6581}, {3.0, 1.55104, -2.4263}};
  po_request request = request_of(KNOWN[_i][0], 0.0, 0.0, INFINITY);
  request.mesh.nodes = 501;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  /* second order: the cohesive zone, whose width is about eps sqrt(R)/mu, has some 20 elements at
   * mu = 3 */
  ck_assert_double_eq_tol(o.pull_off.force, KNOWN[_i][1],
                          3e-5 + 4e-5 * KNOWN[_i][0] * KNOWN[_i][0]);
  ck_assert_double_eq_tol(o.pull_off.approach, KNOWN[_i][2],
                          1e-4 + 8e-4 * KNOWN[_i][0] * KNOWN[_i][0]);
  po_result_clear(&o);
}

TEST(curve_contains_its_special_points_in_order) {
  po_request request = request_of(3.0, 1.0, 20.0, 100.0);
  request.want = PO_WANT_CURVE;
  request.approach_start = -6.5;
  request.approach_end = 1.0;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_ge(o.curve[0].approach, -6.5);
  ck_assert_double_eq_tol(o.ended.approach, 1.0, 1e-10);
  double least = 0.0;
  for (size_t k = 1; k < o.curve_count; ++k) {
    ck_assert_double_gt(o.curve[k].position, o.curve[k - 1].position);
    least = fmin(least, o.curve[k].load);
  }
  ck_assert_double_eq(least, -o.pull_off.force);
  ck_assert_uint_ge(o.fold_count, 4);
  ck_assert_int_eq(o.folds[0].kind, PO_JUMP_IN);
  ck_assert_int_eq(o.folds[0].unstable_modes, 1);
  po_result_clear(&o);
}

/* A curve does not get more points from one tolerance to the next without end: it is drawn with an
 * error of 1e-8, as at a tolerance of 1e-7. */
TEST(curve_of_a_small_tolerance_has_no_more_points) {
  static const double TOLERANCES[] = {1e-7, 1e-9};
  size_t points[2];
  for (int k = 0; k < 2; ++k) {
    po_request request = request_of(1.0, 0.0, 0.0, INFINITY);
    request.mesh = (po_mesh){.scheme = PO_PANEL, .tolerance = TOLERANCES[k]};
    request.want = PO_WANT_CURVE;
    po_result o;
    ck_assert_int_eq(po_solve(&request, &o), PO_OK);
    points[k] = o.curve_count;
    po_result_clear(&o);
  }
  ck_assert_uint_le(points[1], points[0] + points[0] / 4);
}

/* The load where a curve first reaches an approach, from the cubic between two of its points. */
static double load_where(const po_result *o, double approach) {
  for (size_t k = 0; k + 1 < o->curve_count; ++k) {
    if (!(o->curve[k].approach < approach && approach <= o->curve[k + 1].approach))
      continue;
    const po_path path = {o->curve, o->curve_count};
    return po_path_at(&path, po_path_where(&path, k, PO_DISPLACEMENT_CONTROL, approach)).load;
  }
  return (double)NAN;
}

/* A curve on panels is interpolated between its points with the computed slopes, accurate to a
 * tenth of the tolerance. It is compared with equilibria at given approaches, each from a separate
 * trace with other steps. On coarse triangles the steps are longer, so the interpolation is less
 * accurate; and equilibria are solved to 1e-8 there, which is also how closely a given approach is
 * met. */
LOOP_TEST(interpolated_curve_agrees_with_separate_equilibria, 0, 3) {
  static const double APPROACH[] = {-3.85, -2.385, 0.71, 4.1};
  static const double ERROR[] = {1e-7, 1e-7, 2e-5};
  static const double MET[] = {1e-9, 1e-9, 1e-7};
  po_request request = request_of(3.0, 1.0, 20.0, 100.0);
  request.mesh = _i < 2 ? (po_mesh){PO_PANEL, PO_UNIFORM, 0, 1e-6}
                        : (po_mesh){PO_TRIANGLE, PO_UNIFORM, 141, 0};
  if (_i == 1)
    request.scene.amplitude = 0.0;
  request.approach_end = 5.0;
  request.want = PO_WANT_CURVE;
  po_result curve, station;
  ck_assert_int_eq(po_solve(&request, &curve), PO_OK);
  request.want = PO_WANT_CURVE | PO_WANT_PROFILE;
  for (size_t i = 0; i < sizeof APPROACH / sizeof *APPROACH; ++i) {
    request.profile_approach = APPROACH[i];
    ck_assert_int_eq(po_solve(&request, &station), PO_OK);
    size_t at = 0;
    while (at + 1 < station.curve_count && fabs(station.curve[at].approach - APPROACH[i]) > MET[_i])
      ++at;
    const po_curve_point *found = &station.curve[at];
    ck_assert_double_eq_tol(found->approach, APPROACH[i], MET[_i]);
    ck_assert_double_eq_tol(load_where(&curve, found->approach), found->load, ERROR[_i]);
    po_result_clear(&station);
  }
  po_result_clear(&curve);
}

/* The derivative of the approach vanishes at a fold, that of the load at an extremum. */
TEST(curve_turns_at_its_special_points) {
  po_request request = request_of(3.0, 1.0, 20.0, 100.0);
  request.want = PO_WANT_CURVE;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  size_t folds = 0, extrema = 0;
  for (size_t k = 0; k < o.curve_count; ++k) {
    const po_curve_point *p = &o.curve[k];
    if (folds < o.fold_count && p->position == o.folds[folds].position) {
      ck_assert_double_le(fabs(p->approach_rate), 1e-6 * fabs(p->load_rate));
      ++folds;
    } else if (extrema < o.extremum_count && p->position == o.extrema[extrema].position) {
      ck_assert_double_le(fabs(p->load_rate), 1e-6 * fabs(p->approach_rate));
      ++extrema;
    }
  }
  ck_assert_uint_ge(folds, 4);
  ck_assert_uint_eq(folds, o.fold_count);
  ck_assert_uint_eq(extrema, o.extremum_count);
  po_result_clear(&o);
}

/* W/(pi w R) = 2/(R mu) integral of P r dr, by the trapezoidal rule. */
static double load_of_profile(const po_scene *scene, const po_profile_point *profile,
                              size_t count) {
  double load = 0.0;
  for (size_t k = 1; k < count; ++k) {
    const po_profile_point *a = &profile[k - 1], *b = &profile[k];
    load += 0.5 * (b->radius - a->radius) * (a->traction * a->radius + b->traction * b->radius);
  }
  return load * 2.0 / (scene->radius * scene->tabor);
}

typedef struct {
  const po_scene *scene;
  double load[1000]; /* of the profile of each point of the curve */
  size_t count;
} loads;

static void note_load(void *data, size_t number, const po_profile_point *profile, size_t count) {
  loads *l = data;
  ck_assert_uint_lt(number, sizeof l->load / sizeof *l->load);
  l->load[number] = load_of_profile(l->scene, profile, count);
  l->count = number + 1;
}

/* At the pull-off, at a given approach or load, and at every point of the curve. */
TEST(profile_is_an_equilibrium) {
  po_request request = request_of(1.3, 0.7, 23.85, 100.0);
  request.want = PO_WANT_PROFILE;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq(o.profile_approach, o.pull_off.approach);
  const double load = load_of_profile(&request.scene, o.profile, o.profile_count);
  ck_assert_double_eq_tol(-load, o.pull_off.force, 1e-3);
  po_result_clear(&o);
  request.profile_approach = -1.385;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.profile_approach, -1.385, 1e-10);
  po_result_clear(&o);
  request.profile_approach = NAN;
  request.profile_load = 0.385;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(load_of_profile(&request.scene, o.profile, o.profile_count), 0.385, 2e-3);
  po_result_clear(&o);
  static loads shown;
  shown.scene = &request.scene;
  request.want = PO_WANT_CURVE;
  request.show = note_load;
  request.watcher = &shown;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(shown.count, o.curve_count);
  for (size_t k = 0; k < o.curve_count; ++k)
    ck_assert_double_eq_tol(shown.load[k], o.curve[k].load, 2e-3);
  po_result_clear(&o);
  request.scene.tabor = 0.0; /* rigid: without a surface, if nothing is shown */
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(shown.count, o.curve_count);
  po_result_clear(&o);
}

TEST(rigid_scene_is_solved_without_a_surface) {
  po_request request = request_of(0.0, 1.0, 20.0, INFINITY); /* alpha = 0.25 */
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(o.rigid);
  ck_assert_double_eq(o.start, -10.0);
  ck_assert_uint_eq(o.work.kernel_evaluations, 0);
  ck_assert_uint_eq(o.work.nodes, 0);
  ck_assert_double_eq_tol(o.pull_off.force, 0.7410559, 1e-7);
  po_result_clear(&o);
  request.scene.wavelength = 1000.0; /* alpha = 1e-4 */
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.pull_off.force, 1.992148, 1e-6);
  po_result_clear(&o);
}

TEST(small_tabor_goes_to_the_rigid_limit) { /* a scene with mu = 1e-4 is solved as elastic */
  po_request request = request_of(1e-4, 1.0, 20.0, INFINITY);
  request.mesh.nodes = 801;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(!o.rigid);
  ck_assert_double_eq_tol(o.pull_off.force, 0.7410559, 3e-4);
  po_result_clear(&o);
}

/* At R = 100 the tail beyond r = R contributes 1.0e-3 to the load. */
/* With lengths in units of the range 1/a, a Morse law of steepness a at mu is that of steepness 1
 * at mu a. For a soft one the tension is greatest at a gap of ln 2/a, here 14 eps, and the pull-off
 * is in approach far outside that of the law of the paper; its feedback is small at every gap, so
 * that a trace could begin behind its minimum. */
TEST(trace_begins_outside_a_law_of_long_range) {
  double force[2], bound = 0.0;
  for (int k = 0; k < 2; ++k) {
    po_request request = request_of(k ? 0.2 : 4.0, 0.0, 0.0, 100.0);
    request.scene.outer_radius = INFINITY;
    request.mesh = po_mesh_default();
    ck_assert(po_law_set(&request.scene.law, k ? "morse:1" : "morse:0.05"));
    po_result o;
    ck_assert_int_eq(po_solve(&request, &o), PO_OK);
    ck_assert_int_eq(o.status, PO_OK);
    force[k] = o.pull_off.force;
    bound += o.pull_off.force_error;
    po_result_clear(&o);
  }
  ck_assert_double_le(fabs(force[0] - force[1]), bound);
}

TEST(unbounded_and_bounded_surfaces_differ_by_the_tail) {
  po_request request = request_of(1.0, 0.0, 0.0, 100.0);
  po_result cut, whole;
  ck_assert_int_eq(po_solve(&request, &cut), PO_OK);
  request.scene.outer_radius = INFINITY;
  ck_assert_int_eq(po_solve(&request, &whole), PO_OK);
  ck_assert_double_eq_tol(whole.pull_off.force - cut.pull_off.force, 1.0e-3, 2e-4);
  po_result_clear(&cut);
  po_result_clear(&whole);
}

/* A cleared result is the same as one before any solve. It may be cleared again. */
TEST(cleared_result_is_empty) {
  po_request request = request_of(0.0, 0.0, 0.0, INFINITY);
  request.want = PO_WANT_CURVE | PO_WANT_PROFILE;
  request.mesh.nodes = 41;
  static const po_result empty;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(o.has_pull_off && o.curve_count > 0 && o.profile_count > 0);
  for (int times = 0; times < 2; ++times) {
    po_result_clear(&o);
    ck_assert_int_eq(o.status, PO_OK);
    ck_assert(!o.has_pull_off && !o.has_hysteresis && o.reason[0] == '\0');
    ck_assert_uint_eq(o.curve_count + o.profile_count + o.fold_count + o.extremum_count, 0);
    ck_assert_ptr_null(o.curve);
    ck_assert_ptr_null(o.profile);
    ck_assert_uint_eq(o.work.points, empty.work.points);
  }
}

TEST(bad_requests_are_refused) {
  po_request request = request_of(1.0, 0.0, 0.0, INFINITY);
  po_result o;
  request.mesh.nodes = 3;
  ck_assert_int_eq(po_solve(&request, &o), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(o.reason, "nodes is 3"));
  request.mesh.nodes = 100;
  request.approach_start = 1.0;
  request.approach_end = -1.0;
  ck_assert_int_eq(po_solve(&request, &o), PO_BAD_INPUT);
  request.scene.tabor = NAN;
  ck_assert_int_eq(po_solve(&request, &o), PO_BAD_INPUT);
}

/* The trace meets the preload exactly, whether or not a profile is wanted at another approach. An
 * earlier version did not, and the load was wrong by 4e-8. */
TEST(a_profile_does_not_move_the_preload) {
  po_request request = po_request_default();
  request.scene.tabor = 3.0;
  request.want = PO_WANT_HYSTERESIS;
  request.preload.approach = 1.2385;
  po_result alone, beside;
  ck_assert_int_eq(po_solve(&request, &alone), PO_OK);
  request.want |= PO_WANT_PROFILE;
  request.profile_approach = 0.385;
  ck_assert_int_eq(po_solve(&request, &beside), PO_OK);
  ck_assert_double_eq_tol(beside.profile_approach, 0.385, 1e-10);
  ck_assert_double_eq_tol(alone.hysteresis.of[PO_AT_APPROACH].preload.load,
                          beside.hysteresis.of[PO_AT_APPROACH].preload.load, 1e-10);
  po_result_clear(&alone);
  po_result_clear(&beside);
}

/* The corner of a truncated sphere does not move with the contact edge: 147 points; moved, it
 * limits the steps, and the trace takes 551. The mesh ends a panel at the corner, but not on a cut
 * surface. The case `general` compares such scenes with the independent solver. */
/* The part of the contact radius without a groove at pull-off, beside the annuli of the profile. */
TEST(disc_without_a_groove) {
  po_request request = request_of(4.0, 3.0, 10.0, 100.0);
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = 1e-4;
  request.want = PO_WANT_PROFILE;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const size_t last = o.annuli.held_count - 1;
  ck_assert_uint_gt(last, 0);
  ck_assert_double_eq_tol(o.pull_off.full_disc, o.annuli.held[0].outer / o.annuli.held[last].outer,
                          1e-9);
  po_result_clear(&o);
}

LOOP_TEST(corner_of_a_profile_does_not_limit_the_steps, 0, 2) {
  po_request request = po_request_default();
  request.scene.radius = 1.0;
  request.scene.outer_radius = _i ? 30.0 : INFINITY;
  request.scene.tabor = pow(0.7, 2.0 / 3.0); /* coupling 0.7 */
  ck_assert(po_law_set(&request.scene.law, "morse:2.72"));
  ck_assert(po_profile_set(&request.scene.profile, "truncated:9.453,12.97"));
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(o.fold_count, 4);
  ck_assert_uint_lt(o.work.points, 250);
  po_result_clear(&o);
}
