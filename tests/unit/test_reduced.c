/* A pull-off by greater ranges of the attraction: against the true range where both can be solved,
 * and against the limits of JKR theory where only the greater ones can. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_solve.h"
#include "run.h"

static po_request request_of(double tabor, double radius, double amplitude, double wavelength) {
  po_request request = po_request_default();
  request.scene.tabor = tabor;
  request.scene.radius = radius;
  request.scene.amplitude = amplitude;
  request.scene.wavelength = wavelength;
  request.preload.load = 2.0;
  request.mesh.tolerance = 1e-4;
  return request;
}

/* Tabor parameter, radius, amplitude, wavelength. */
static const double BOTH[][4] = {{200.0, 1e3, 0.0, 0.0},
                                 {100.0, 1e4, 30.0, 900.0},
                                 {200.0, 3e4, 60.0, 2500.0},
                                 {300.0, 1e5, 50.0, 6000.0}};

TABLE_TEST(agrees_with_the_true_range_within_the_stated_errors, BOTH) {
  po_request request = request_of(BOTH[_i][0], BOTH[_i][1], BOTH[_i][2], BOTH[_i][3]);
  request.range = PO_RANGE_EXACT;
  po_result exact, reduced;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  ck_assert(!exact.range.is_reduced && reduced.range.is_reduced);
  ck_assert_double_gt(reduced.range.least, 1.0);
  ck_assert_double_le(reduced.pull_off.force_error, 1e-4 * reduced.pull_off.force);
  ck_assert_double_eq_tol(reduced.pull_off.force, exact.pull_off.force,
                          reduced.pull_off.force_error + exact.pull_off.force_error);
  ck_assert_double_eq_tol(reduced.pull_off.approach, exact.pull_off.approach,
                          reduced.pull_off.approach_error + exact.pull_off.approach_error);
  ck_assert_double_eq_tol(reduced.pull_off.contact_radius, exact.pull_off.contact_radius,
                          reduced.pull_off.contact_radius_error +
                              exact.pull_off.contact_radius_error);
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

/* Every special point that is stated is one of the true range. */
TEST(special_points_are_those_of_the_true_range) {
  po_request request = request_of(BOTH[1][0], BOTH[1][1], BOTH[1][2], BOTH[1][3]);
  request.range = PO_RANGE_EXACT;
  po_result exact, reduced;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  ck_assert_uint_ge(reduced.extremum_count, 1);
  for (size_t k = 0; k < reduced.extremum_count; ++k) {
    const po_special_point *p = &reduced.extrema[k];
    double least = INFINITY;
    for (size_t i = 0; i < exact.extremum_count; ++i)
      if (exact.extrema[i].kind == p->kind)
        least = fmin(least, fabs(exact.extrema[i].load - p->load));
    ck_assert_double_le(least, p->load_error + exact.pull_off.force_error);
  }
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

/* A sphere of centimetres with a range of atoms: JKR theory, whose pull-off is 3/2 at the approach
 * -(3/4)(pi^2)^(1/3) mu and the contact radius (9 pi/8)^(1/3) sqrt(R mu). */
LOOP_TEST(smooth_spheres_tend_to_the_jkr_theory, 0, 3) {
  static const double TABOR[] = {2e4, 1e6, 1e9};
  const po_request request = request_of(TABOR[_i], 1e9, 0.0, 0.0);
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(o.range.is_reduced);
  ck_assert_double_eq_tol(o.pull_off.force, 1.5,
                          o.pull_off.force_error + 1.0 / (TABOR[_i] * TABOR[_i]));
  ck_assert_double_eq_tol(o.pull_off.contact_radius, cbrt(9.0 * M_PI / 8.0) * sqrt(1e9 * TABOR[_i]),
                          o.pull_off.contact_radius_error + 1e-6 * o.pull_off.contact_radius);
  po_result_clear(&o);
}

/* A wavy sphere of R/epsilon = 4e9: ten times as great and ten times as small a range differ by
 * less than the stated errors. */
TEST(the_range_does_not_matter_where_it_is_small) {
  double force[2], error[2];
  for (int k = 0; k < 2; ++k) {
    const double s = k ? 100.0 : 1.0;
    const po_request request = request_of(1e5 / s, 4e9 / s, 1e6 / s, 5e7 / s);
    po_result o;
    ck_assert_int_eq(po_solve(&request, &o), PO_OK);
    ck_assert(o.range.is_reduced);
    force[k] = o.pull_off.force;
    error[k] = o.pull_off.force_error;
    ck_assert_double_le(error[k], 1e-4 * force[k]);
    po_result_clear(&o);
  }
  ck_assert_double_eq_tol(force[0], force[1], error[0] + error[1]);
}

/* A loop and its jumps at the true range and from greater ones. */
static void expect_same_loops(const po_loop *exact, const po_loop *reduced) {
  ck_assert_uint_eq(reduced->jump_count, exact->jump_count);
  for (size_t k = 0; k < exact->jump_count; ++k) {
    const po_jump *a = &exact->jumps[k], *b = &reduced->jumps[k];
    ck_assert(a->loading == b->loading);
    if (isnan(a->energy_lost))
      ck_assert_double_nan(b->energy_lost);
    else
      ck_assert_double_eq_tol(b->energy_lost, a->energy_lost,
                              b->energy_lost_error + a->energy_lost_error);
  }
  if (isnan(exact->energy_lost))
    return;
  ck_assert_double_le(reduced->energy_lost_error, 1e-3 * reduced->energy_lost);
  ck_assert_double_eq_tol(reduced->energy_lost, exact->energy_lost,
                          reduced->energy_lost_error + exact->energy_lost_error);
  ck_assert_double_eq_tol(reduced->work, exact->work, reduced->work_error + exact->work_error);
  ck_assert_double_eq_tol(reduced->pull_off.load, exact->pull_off.load,
                          reduced->pull_off_error.load + exact->pull_off_error.load);
}

static void expect_ends_within(const po_loop *exact, const po_loop *reduced,
                               const po_range_loops *stated) {
  for (size_t k = 0; k < exact->jump_count; ++k) {
    ck_assert_double_eq_tol(reduced->jumps[k].before.load, exact->jumps[k].before.load,
                            stated->load);
    ck_assert_double_eq_tol(reduced->jumps[k].after.approach, exact->jumps[k].after.approach,
                            stated->approach);
  }
}

/* With the true range the surfaces jump at another approach than with any that is solved. */
LONG_TEST(loops_are_those_of_the_true_range) {
  po_request request = request_of(300.0, 1e5, 50.0, 6000.0);
  request.want = PO_WANT_HYSTERESIS;
  request.range = PO_RANGE_EXACT;
  po_result exact, reduced;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  ck_assert(reduced.range.loops.are_known && reduced.range.loops.least > 1.0);
  ck_assert(exact.hysteresis.has_load && reduced.hysteresis.has_load);
  const po_loop *a = exact.hysteresis.of, *b = reduced.hysteresis.of;
  ck_assert_uint_eq(a[PO_AT_APPROACH].loading_jumps, 2);
  expect_same_loops(&a[PO_AT_APPROACH], &b[PO_AT_APPROACH]);
  expect_same_loops(&a[PO_AT_LOAD], &b[PO_AT_LOAD]);
  expect_ends_within(&a[PO_AT_APPROACH], &b[PO_AT_APPROACH], &reduced.range.loops);
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

/* Through a soft spring: the loop begins farther out and has other jumps. */
TEST(loops_through_a_spring_are_those_of_the_true_range) {
  po_request request = request_of(200.0, 1e3, 0.0, 0.0);
  request.want = PO_WANT_HYSTERESIS;
  request.stiffness = 0.02;
  request.range = PO_RANGE_EXACT;
  po_result exact, reduced;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  ck_assert(reduced.hysteresis.has_spring);
  expect_same_loops(&exact.hysteresis.of[PO_THROUGH_SPRING],
                    &reduced.hysteresis.of[PO_THROUGH_SPRING]);
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

/* A number and its error; the stated errors hold and are a small part of it. */
static void expect_number(double exact, double error, double reduced, double stated, double part) {
  ck_assert_double_eq_tol(reduced, exact, error + stated);
  ck_assert_double_le(stated, part * fabs(exact));
}

static void expect_same_step(const po_step *a, const po_step *b) {
  ck_assert(a->jumped == b->jumped && a->open == b->open);
  expect_number(a->pull_off.load, a->pull_off_error.load, b->pull_off.load, b->pull_off_error.load,
                1e-4);
  expect_number(a->preload.approach, a->preload_error.approach, b->preload.approach,
                b->preload_error.approach, 0.02);
  expect_number(a->preload.load, a->preload_error.load, b->preload.load, b->preload_error.load,
                0.3);
  ck_assert_uint_eq(b->cycle_count, a->cycle_count);
  for (size_t c = 0; c < a->cycle_count; ++c) {
    const po_cycle *one = &a->cycle[c], *other = &b->cycle[c];
    ck_assert_uint_eq(other->loss.jumps, one->loss.jumps);
    expect_number(one->loss.energy, one->energy_error, other->loss.energy, other->energy_error,
                  1e-2);
  }
}

/* The pull-off after every preload: a step that begins where the sphere jumps into contact, and one
 * where a crest does. */
TEST(staircases_are_those_of_the_true_range) {
  po_request request = request_of(300.0, 1e5, 50.0, 6000.0);
  request.mesh.tolerance = 1e-4;
  request.preload.load = 0.05;
  request.hardest = 0.5; /* as with greater ranges */
  request.want = PO_WANT_PRELOAD;
  request.range = PO_RANGE_EXACT;
  po_result exact, reduced;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  ck_assert(reduced.has_staircases && reduced.range.stairs.are_known);
  ck_assert_uint_eq(reduced.range.stairs.left_out, 0);
  const po_staircase *a = exact.staircase.of, *b = reduced.staircase.of;
  ck_assert_uint_eq(a[PO_AT_APPROACH].count, 2);
  ck_assert_uint_eq(b[PO_AT_APPROACH].count, 2);
  for (size_t k = 0; k < 2; ++k)
    expect_same_step(&a[PO_AT_APPROACH].step[k], &b[PO_AT_APPROACH].step[k]);
  const po_step *first = b[PO_AT_APPROACH].step;
  ck_assert_double_eq(first->until.approach, first[1].preload.approach);
  ck_assert_double_eq(-first[1].pull_off.load, reduced.pull_off.force);
  ck_assert_double_eq(reduced.pull_off.pressed.approach, first[1].preload.approach);
  ck_assert_double_eq(reduced.pull_off_any.force, reduced.pull_off.force);
  ck_assert_uint_eq(b[PO_AT_LOAD].count, a[PO_AT_LOAD].count);
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

static void expect_refusal(const po_request *request) {
  po_result o;
  ck_assert_int_eq(po_solve(request, &o), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "range is reduced: expected auto or exact"));
  po_result_clear(&o);
}

TEST(refused_where_it_does_not_apply) {
  const po_request asked = request_of(200.0, 1e3, 0.0, 0.0);
  po_request request = asked;
  request.range = PO_RANGE_REDUCED;
  request.scene.tabor = 3.0; /* wide contact edges */
  expect_refusal(&request);
  request.scene.tabor = asked.scene.tabor;
  request.want = PO_WANT_CURVE;
  expect_refusal(&request);
  request.want = 0;
  request.stiffness = 1.0; /* without loops, which alone depend on it */
  expect_refusal(&request);
  request.stiffness = NAN;
  ck_assert(po_law_set(&request.scene.law, "mie:4,10"));
  expect_refusal(&request);
  request.scene.law = asked.scene.law;
  ck_assert(po_profile_set(&request.scene.profile, "cone:0.1"));
  expect_refusal(&request);
}

/* The contact edges of this scene change the force by so much that no range gives ten digits. */
TEST(an_error_above_the_tolerance_fails_with_the_error) {
  po_request request = request_of(60.0, 1e4, 20.0, 900.0);
  request.range = PO_RANGE_REDUCED;
  request.mesh.tolerance = 1e-10;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_NOT_CONVERGED);
  ck_assert_ptr_nonnull(strstr(o.reason, "times the tolerance: expected a larger tolerance"));
  ck_assert(o.has_pull_off && o.range.is_reduced);
  ck_assert_double_gt(o.pull_off.force_error, 1e-9 * o.pull_off.force);
  po_result_clear(&o);
}

/* A sphere whose second crest touches at a load that grows as the range decreases, to 1.8. With
 * ranges 118 to 670 times as great it touches at a load of 1.2 to 1.6. */
static po_request with_a_crest(double preload) {
  po_request request = request_of(9473.945733, 41666666.67, 26309.0, 2183333.33);
  request.preload.load = preload;
  return request;
}

/* With the true range loading is reversed before the crest touches; with greater ones after it,
 * where the pull-off force is eighty times as great. */
LONG_TEST(a_jump_that_the_true_range_does_not_make_is_not_made) {
  po_request request = with_a_crest(1.6976527);
  po_result exact, reduced;
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  request.range = PO_RANGE_EXACT;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  ck_assert(reduced.range.is_reduced);
  ck_assert_double_eq_tol(reduced.pull_off.force, exact.pull_off.force,
                          reduced.pull_off.force_error + exact.pull_off.force_error);
  ck_assert_double_lt(reduced.pull_off.force, 0.2);
  const double force = reduced.pull_off.force;
  po_result_clear(&exact);
  po_result_clear(&reduced);
  request.range = PO_RANGE_REDUCED; /* whose loops make the jump */
  request.want = PO_WANT_HYSTERESIS;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_NOT_CONVERGED);
  ck_assert_ptr_nonnull(strstr(reduced.reason, "loading is reversed before a jump"));
  ck_assert(reduced.has_pull_off && !reduced.has_hysteresis);
  ck_assert_double_eq(reduced.pull_off.force, force);
  po_result_clear(&reduced);
}

/* Beyond that load it does touch. */
TEST(a_jump_that_the_true_range_makes_is_made) {
  const po_request request = with_a_crest(1.9);
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(o.range.is_reduced);
  ck_assert_double_gt(o.pull_off.force, 12.0);
  po_result_clear(&o);
}

/* So close to the preload that the ranges of the limits do not decide, the jump is followed to the
 * true range. */
TEST(a_jump_close_to_the_preload_is_decided_at_the_true_range) {
  po_request request = request_of(130.190695, 11363.1582, 1401.62461, 4853.24379);
  request.preload.load = 1.78873781;
  po_result exact, reduced;
  request.range = PO_RANGE_REDUCED;
  ck_assert_int_eq(po_solve(&request, &reduced), PO_OK);
  request.range = PO_RANGE_EXACT;
  ck_assert_int_eq(po_solve(&request, &exact), PO_OK);
  ck_assert_double_eq_tol(reduced.pull_off.force, exact.pull_off.force,
                          reduced.pull_off.force_error + exact.pull_off.force_error);
  po_result_clear(&exact);
  po_result_clear(&reduced);
}

/* A solve after a preload by a load, whose error is within the tolerance of request_of. */
static po_result solved_after(po_request request, double load) {
  po_result o;
  request.preload.load = load;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_le(o.pull_off.force_error, request.mesh.tolerance * o.pull_off.force);
  return o;
}

/* Messages had approaches in units of the greater range: -32.009. */
TEST(messages_have_lengths_of_the_true_range) {
  po_request request = request_of(1e3, 1e6, 30.0, 2e4);
  request.preload = (po_preload){-1800.0, NAN};
  request.range = PO_RANGE_REDUCED;
  po_result result;
  ck_assert_int_eq(po_solve(&request, &result), PO_NOT_FOUND);
  ck_assert_msg(strstr(result.reason, "approach -1800"), "%s", result.reason);
  po_result_clear(&result);
}

/* Folds of the unstable equilibria between two jumps of loading, dozens with each range, are passed
 * by two traces only: the scene was not solved in 20 s when each range was traced. */
TEST(takes_few_points) {
  const po_request request = request_of(8492.83, 28247.0, 12688.5, 20582.5);
  po_result o = solved_after(request, 3.02284);
  ck_assert(o.range.is_reduced);
  ck_assert_uint_lt(o.work.points, 3000);
  po_result_clear(&o);
}

/* The greatest range makes a jump before the preload that smaller ones do not, so that two traces
 * have other pull-offs. They agree all the same: the pull-off of the second is a minimum of the
 * first. With a third trace the scene takes 9,000 points. */
LONG_TEST(two_traces_agree_on_a_minimum_before_a_jump) {
  po_request request = request_of(112.040442, 572863.323, 55.8582041, 3015.27947);
  request.range = PO_RANGE_REDUCED;
  po_result o = solved_after(request, 0.159941631);
  ck_assert_uint_lt(o.work.points, 6000);
  po_result_clear(&o);
}

/* Two minima of the load are almost as deep. With the traced ranges, 14.5 and 29 times as great,
 * the first is deeper, by 0.5 % and 2.4 %; with the true one the second, by 0.7 %. The force with
 * the true range, of 1,700 points, is 1.08221437 +- 2e-7. */
TEST(the_deepest_minimum_is_that_of_the_true_range) {
  po_request request = request_of(218.09345, 46116.2796, 193.583833, 1403.53987);
  request.range = PO_RANGE_REDUCED;
  po_result o = solved_after(request, 1.35226441);
  ck_assert_double_eq_tol(o.pull_off.force, 1.08221437, o.pull_off.force_error + 2e-7);
  ck_assert_double_eq_tol(o.pull_off.approach, 34.317583, o.pull_off.approach_error + 7e-6);
  po_result_clear(&o);
}

/* The contact edges of this scene are not so narrow that greater ranges are chosen, but its trace
 * takes 3,100 points; it has the force 5.483464565 +- 2.5e-8. */
LONG_TEST(a_long_trace_gives_way_to_greater_ranges) {
  po_request request = request_of(49.4742, 50710.4, 27.2957, 862.874);
  request.preload.load = 2.5;
  po_result taken;
  ck_assert_int_eq(po_solve(&request, &taken), PO_OK);
  ck_assert(taken.range.is_reduced);
  ck_assert_double_eq_tol(taken.pull_off.force, 5.483464565, taken.pull_off.force_error + 2.5e-8);
  po_result_clear(&taken);
}
