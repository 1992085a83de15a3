/* Creep, and the pull-off of viscoelastic bodies: exact limits, order of convergence, energies. */
#include <math.h>
#include <string.h>

#include "po_creep.h"
#include "po_elementary.h"
#include "po_march_internal.h"
#include "po_solve.h"
#include "request.h"
#include "run.h"

/* phi of the Gamma spectrum is 2 s^n K_n(2 s)/Gamma(n) with s = sqrt(t), elementary for n = 1/2,
 * 3/2 and 5/2. */
static double gamma_of(double exponent, double t) {
  const double s = sqrt(t), factor = po_exp(-2.0 * s);
  if (exponent == 0.5)
    return factor;
  return exponent == 1.5 ? (1.0 + 2.0 * s) * factor : (1.0 + 2.0 * s + 4.0 / 3.0 * t) * factor;
}

TEST(gamma_spectra_have_their_closed_form) {
  static const double EXPONENTS[] = {0.5, 1.5, 2.5}, K = 0.1;
  for (int k = 0; k < 3; ++k) {
    po_creep_terms terms;
    po_creep_terms_fill(&(po_creep){PO_CREEP_GAMMA, K, EXPONENTS[k]}, 1e-3, &terms);
    for (double t = 1e-3; t < 30.0; t *= 1.7)
      ck_assert_double_eq_tol(po_creep_compliance(&terms, t),
                              1.0 - (1.0 - K) * gamma_of(EXPONENTS[k], t), 3e-8);
  }
}

TEST(terms_have_all_the_weight) {
  for (double exponent = 0.05; exponent < 10.0; exponent *= 1.6)
    for (double duration = 1e-9; duration < 1e10; duration *= 1e3) {
      po_creep_terms terms;
      po_creep_terms_fill(&(po_creep){PO_CREEP_GAMMA, 0.3, exponent}, duration, &terms);
      double sum = terms.instant;
      ck_assert_uint_lt(terms.count, PO_MOST_CREEP_TERMS);
      for (size_t m = 0; m < terms.count; ++m)
        sum += terms.term[m].weight;
      ck_assert_double_eq_tol(sum, 1.0, 1e-13);
    }
}

TEST(texts_of_materials_are_read_and_refused) {
  static const char *const WRONG[] = {
      "",          "sls",        "sls:",           "sls:0",        "sls:1.01",      "sls:0.1,2",
      "gamma:0.1", "gamma:0.1,", "gamma:0.1,0.04", "gamma:0.1,11", "gamma:0.1,1,1", "sls:nan",
      "Sls:0.1",   "prony:",     "prony"};
  po_creep creep = {.ratio = 7.0}, again;
  for (size_t k = 0; k < sizeof WRONG / sizeof *WRONG; ++k) {
    ck_assert_msg(po_creep_read(WRONG[k], &creep) == PO_BAD_INPUT, "%s", WRONG[k]);
    ck_assert_double_eq(creep.ratio, 7.0);
  }
  static const char *const RIGHT[] = {"sls:0.1", "sls:1", "gamma:0.025,0.6"};
  for (size_t k = 0; k < sizeof RIGHT / sizeof *RIGHT; ++k) {
    char text[PO_CREEP_TEXT];
    ck_assert(po_creep_read(RIGHT[k], &creep) == PO_OK);
    po_creep_write(&creep, text);
    ck_assert(po_creep_read(text, &again) == PO_OK);
    ck_assert_str_eq(text, RIGHT[k]);
    ck_assert_double_eq(again.ratio, creep.ratio);
  }
}

static po_request rate_of(double tabor, double amplitude, double preload, po_creep creep,
                          double speed) {
  po_request request = request_of(tabor, amplitude, 20.0, INFINITY);
  request.mesh = po_mesh_default();
  request.preload.approach = preload;
  request.creep = creep;
  request.unload_speed = speed;
  return request;
}

static po_result solved(const po_request *request) {
  po_result result;
  ck_assert_msg(po_solve(request, &result) == PO_OK, "%s", result.reason);
  ck_assert(result.has_pull_off);
  return result;
}

static const po_creep ELASTIC = {PO_CREEP_NONE, 0.0, 0.0}, SOLID = {PO_CREEP_SLS, 0.1, 1.0};

/* Scenes: Tabor parameter, amplitude, preload. */
static const double SCENES[][3] = {
    {0.1, 0.0, 2.0}, {1.0, 0.0, 5.0}, {4.0, 0.0, 3.0}, {3.0, 1.0, 10.0}, {1.0, 0.5, 4.0}};
enum { SCENE_COUNT = sizeof SCENES / sizeof *SCENES };

static void same_as_elastic(const double scene[3], po_creep creep, double speed) {
  const po_request elastic = rate_of(scene[0], scene[1], scene[2], ELASTIC, NAN);
  const po_request creeping = rate_of(scene[0], scene[1], scene[2], creep, speed);
  po_result a = solved(&elastic), b = solved(&creeping);
  ck_assert_double_eq_tol(b.pull_off.force, a.pull_off.force, 1e-6 * a.pull_off.force);
  ck_assert_double_le(fabs(b.pull_off.force - a.pull_off.force),
                      b.pull_off.force_error + a.pull_off.force_error);
  ck_assert_double_eq_tol(b.pull_off.approach, a.pull_off.approach, 1e-4);
  ck_assert_double_eq_tol(b.rate.end.energy.dissipated, 0.0, 1e-6);
  po_result_clear(&a);
  po_result_clear(&b);
}

LOOP_TEST(at_speed_0_the_body_is_elastic, 0, SCENE_COUNT) {
  same_as_elastic(SCENES[_i], SOLID, 0.0);
}

LOOP_TEST(with_one_modulus_the_body_is_elastic, 0, SCENE_COUNT) {
  same_as_elastic(SCENES[_i], (po_creep){PO_CREEP_SLS, 1.0, 1.0}, 10.0);
}

/* With one modulus the profile at an approach or a load is that of the elastic body. Elastic
 * profiles at a tension are those of the approach of the bodies, so a load is compressive. */
LOOP_TEST(the_profile_is_that_of_the_elastic_body, 0, 4) {
  po_request request = rate_of(1.0, 0.5, 4.0, ELASTIC, NAN);
  request.want |= PO_WANT_PROFILE;
  if (_i == 0 || _i == 3)
    request.profile_approach = _i == 0 ? 3.0 : 4.0; /* 4: where unloading begins */
  else
    request.profile_load = 0.5;
  po_result a = solved(&request);
  request.creep = (po_creep){PO_CREEP_SLS, 1.0, 1.0};
  request.unload_speed = 1.0;
  if (_i == 2) /* through a spring the approach is not that of the base */
    request.stiffness = 0.4;
  po_result b = solved(&request);
  ck_assert_double_eq_tol(b.profile_approach, a.profile_approach, 1e-6);
  ck_assert_uint_eq(b.annuli.held_count, 1);
  ck_assert_double_eq_tol(b.annuli.held[0].outer, a.annuli.held[0].outer, 1e-4);
  ck_assert_double_eq_tol(b.profile[0].gap, a.profile[0].gap, 1e-4);
  ck_assert_double_eq_tol(b.profile[0].traction, a.profile[0].traction, 1e-3);
  po_result_clear(&a);
  po_result_clear(&b);
}

/* A march that cannot end is refused before it begins. */
TEST(an_edge_far_narrower_than_the_contact_is_refused) {
  po_result result;
  po_request request = rate_of(3000.0, 0.0, 5.0, SOLID, 1.0);
  request.scene.radius = 1e6;
  ck_assert_int_eq(po_solve(&request, &result), PO_TOO_MANY_POINTS);
  ck_assert_msg(strstr(result.reason, "more than 200000 steps") != NULL, "%s", result.reason);
  po_result_clear(&result);
}

/* Without an approach or a load the profile is that of the greatest tension. */
TEST(the_profile_is_at_the_pull_off) {
  po_request request = rate_of(1.0, 0.0, 5.0, SOLID, 1.0);
  request.want |= PO_WANT_PROFILE;
  po_result result = solved(&request);
  ck_assert_double_le(fabs(result.profile_approach - result.pull_off.approach),
                      result.pull_off.approach_error);
  ck_assert_double_eq_tol(result.annuli.held[0].outer, result.pull_off.contact_radius,
                          result.pull_off.contact_radius_error);
  po_result_clear(&result);
}

/* The jumps of unloading lose what the elastic loop loses in its own. */
TEST(jumps_lose_what_the_elastic_loop_loses) {
  po_request elastic = rate_of(3.0, 1.0, 10.0, ELASTIC, NAN);
  elastic.want |= PO_WANT_HYSTERESIS;
  const po_request creeping = rate_of(3.0, 1.0, 10.0, SOLID, 0.0);
  po_result a = solved(&elastic), b = solved(&creeping);
  const po_loop *loop = &a.hysteresis.of[PO_AT_APPROACH];
  double lost = 0.0;
  size_t count = 0;
  for (size_t k = 0; k < loop->jump_count; ++k)
    if (!loop->jumps[k].loading) {
      lost += loop->jumps[k].energy_lost;
      ++count;
    }
  ck_assert_uint_eq(b.rate.jumps, count);
  ck_assert_double_eq_tol(b.rate.end.energy.jumps, lost, 1e-3);
  po_result_clear(&a);
  po_result_clear(&b);
}

/* Far slower and far faster than all its times, the body is near its limits. */
TEST(speeds_tend_to_the_limits) {
  const double slow = 1e-6, fast = 1e7;
  const double speeds[] = {0.0, slow, fast, INFINITY};
  double force[4];
  for (int k = 0; k < 4; ++k) {
    const po_request request = rate_of(1.0, 0.0, 5.0, SOLID, speeds[k]);
    po_result result = solved(&request);
    force[k] = result.pull_off.force;
    po_result_clear(&result);
  }
  ck_assert_double_eq_tol(force[1], force[0], 1e-5);
  ck_assert_double_eq_tol(force[2], force[3], 1e-5);
  ck_assert_double_gt(force[3], 4.0 * force[0]);
}

/* With a hundredth of the tolerance the steps are a third as long: a tenth of the error, of the
 * second order. The extrapolated values agree within the stated errors. */
TEST(steps_are_of_second_order) {
  const double tolerances[] = {1e-5, 1e-7};
  double force[2], work[2], part[2], imbalance[2], error[2];
  for (int k = 0; k < 2; ++k) {
    po_request request = rate_of(1.0, 0.0, 5.0, (po_creep){PO_CREEP_GAMMA, 0.1, 0.6}, 1.0);
    request.mesh.tolerance = tolerances[k];
    po_result result = solved(&request);
    force[k] = result.pull_off.force;
    error[k] = result.pull_off.force_error;
    part[k] = result.rate.time_part;
    imbalance[k] = result.rate.imbalance;
    work[k] =
        result.rate.end.energy.work + result.rate.end.energy.adhesive; /* until infinitely apart */
    po_result_clear(&result);
  }
  ck_assert_double_gt(part[0], 7.0 * part[1]);
  ck_assert_double_lt(part[0], 14.0 * part[1]);
  ck_assert_double_gt(imbalance[0], 7.0 * imbalance[1]);
  ck_assert_double_lt(imbalance[0], 14.0 * imbalance[1]);
  ck_assert_double_le(fabs(force[0] - force[1]), 0.1 * error[0]);
  ck_assert_double_lt(fabs(work[0] - work[1]), 0.1);
}

/* Where an edge moved by more than its width in a step, the history kept ripples behind it, and the
 * mesh four times as many nodes. */
TEST(an_edge_leaves_no_trail) {
  po_request request = rate_of(20.0, 0.0, 1.0, SOLID, 10.0);
  request.mesh.tolerance = 1e-2;
  po_result result = solved(&request);
  ck_assert_uint_lt(result.work.nodes, 600);
  ck_assert_double_eq_tol(result.pull_off.force, 6.2124, 3e-3);
  po_result_clear(&result);
}

/* The balance of energy of every step, and the dissipation, which never falls. Through a spring,
 * with a jump; and of a wavy sphere. */
LOOP_TEST(energy_is_balanced_and_dissipation_is_positive, 0, 3) {
  po_request request = _i == 0 ? rate_of(1.0, 0.0, 5.0, SOLID, 1.0)
                       : _i == 1
                           ? rate_of(1.0, 0.0, 3.0, SOLID, 2.0)
                           : rate_of(3.0, 1.0, 10.0, (po_creep){PO_CREEP_GAMMA, 0.1, 1.4}, 30.0);
  if (_i == 1)
    request.stiffness = 0.5;
  request.want |= PO_WANT_HISTORY;
  po_result result = solved(&request);
  const po_rate_point *p = result.rate.history;
  const po_rate_energy *first = &p->energy;
  ck_assert_uint_eq(result.rate.history_count, result.rate.steps);
  for (size_t k = 1; k < result.rate.history_count; ++k) {
    const po_rate_energy *e = &p[k].energy;
    const double change =
        e->stored + e->adhesive + e->spring - first->stored - first->adhesive - first->spring;
    ck_assert_double_eq_tol(e->work, change + e->dissipated + e->jumps, 5e-4);
    ck_assert_double_ge(e->dissipated, p[k - 1].energy.dissipated - 1e-9);
    ck_assert_double_ge(e->jumps, p[k - 1].energy.jumps - 1e-9);
    ck_assert_double_gt(p[k].moved, p[k - 1].moved);
    ck_assert_double_eq_tol(p[k].base, p[0].base - p[k].moved, 1e-9);
  }
  ck_assert_double_gt(result.rate.end.energy.dissipated, 0.1);
  ck_assert_uint_eq(result.rate.jumps, _i > 0);
  po_result_clear(&result);
}

/* One factorisation served thousands of steps, and each accepted a hundred times the noise of the
 * one before: near a fold the states were no equilibria, the balance missed 3e-3 and the force
 * 2e-4. */
TEST(factors_of_many_steps_leave_equilibria) {
  po_request request =
      rate_of(0.947335, 1.43778, 5.8996, (po_creep){PO_CREEP_GAMMA, 0.269658, 0.142752}, 86.646);
  request.scene.wavelength = 39.2869;
  request.stiffness = 0.693443;
  request.mesh.tolerance = 1e-8;
  po_result result = solved(&request);
  ck_assert_double_lt(result.rate.imbalance, 1e-5);
  ck_assert_double_eq_tol(result.pull_off.force, 3.83586, 1.1e-5); /* with a tolerance of 1e-7 */
  po_result_clear(&result);
}

/* A scene whose contact jumps after steps of the first march that are shorter than the rounding of
 * the position: those of the next march were as long for ever. */
TEST(steps_like_those_of_another_march_move_on) {
  po_request request = rate_of(0.201756, 1.11017, 5.72405,
                               (po_creep){PO_CREEP_GAMMA, 0.101973, 0.172993}, 0.000104124);
  request.scene.wavelength = 25.6359;
  request.stiffness = 0.0745382;
  po_result result = solved(&request);
  ck_assert_uint_lt(result.rate.steps, 3000);
  po_result_clear(&result);
}

/* All marches have the same domain, so that their difference lacks the error of the energy by the
 * far field: two domains differed by 1.7 of the stated error, through a spring, too. */
LOOP_TEST(energies_have_the_error_of_the_far_field, 0, 2) {
  double work[2], error[2];
  for (int k = 0; k < 2; ++k) {
    po_request request = _i ? rate_of(0.135086, 0.486519, 3.63494,
                                      (po_creep){PO_CREEP_GAMMA, 0.407375, 0.940815}, 0.0248542)
                            : rate_of(0.124864, 0.336492, 2.54508,
                                      (po_creep){PO_CREEP_GAMMA, 0.0617081, 0.128743}, 0.110686);
    request.scene.wavelength = _i ? 11.8156 : 11.3492;
    if (_i)
      request.stiffness = 0.0920707;
    request.mesh.tolerance = k ? 1e-7 : 1e-6;
    po_result result = solved(&request);
    const po_rate_energy *end = &result.rate.end.energy, *e = &result.rate.end_error;
    work[k] = end->work - end->adhesive - end->spring;
    error[k] = e->work + e->adhesive + e->spring + 2.0 * end->stored;
    po_result_clear(&result);
  }
  ck_assert_double_eq_tol(work[0], work[1], error[0] + error[1]);
  ck_assert_double_lt(error[0], 2e-2);
}

/* After a motion at frozen creep that was no jump, `held` is at the position of the next state. The
 * parabola through them divided by 0: the pull-off force was infinite, and the status ok. */
TEST(a_maximum_beside_a_motion_is_a_recorded_state) {
  for (int late = 0; late < 2; ++late) {
    po_march_record records[] = {{{.moved = 1.0, .load = -1.0}, false, 1e-3},
                                 {{.moved = 1.1, .load = -2.0}, false, 1e-3},
                                 {{.moved = 1.2, .load = -3.0}, false, 1e-3}};
    po_march march = {.phase = PO_UNLOADING, .records = records, .count = 3};
    march.options.stiffness = NAN;
    march.before.point = records[late ? 2 : 1].point; /* late: the motion led to the last record */
    march.held.point = records[2].point;
    march.next.point = (po_rate_point){.moved = 1.3, .load = -2.5};
    if (!late)
      march.held.point = march.next.point;
    ck_assert(po_march_watch_peak(&march, false) == PO_OK);
    const po_march_peak peak = po_march_greatest_tension(&march);
    ck_assert(peak.found);
    ck_assert_double_eq(peak.at.load, -3.0);
    ck_assert_double_eq(peak.at.moved, 1.2);
  }
}

/* Values of the independent solver of reference/make/unloading.py, with its digits: a body of one
 * time, mu = 1, k = 0.1, moved from approach 5 to 0 at speed 1. Between two states of the history
 * the work is a parabola, whose chord is off by less than 1e-4. */
TEST(work_until_approach_0_is_that_of_the_independent_solver) {
  po_request request = rate_of(1.0, 0.0, 5.0, SOLID, 1.0);
  request.want |= PO_WANT_HISTORY;
  po_result result = solved(&request);
  const po_rate_point *p = result.rate.history;
  while (p->approach > 0.0)
    ++p;
  const double part = p[-1].approach / (p[-1].approach - p->approach);
  const po_rate_energy *a = &p[-1].energy, *b = &p->energy;
  ck_assert_double_eq_tol(a->work + part * (b->work - a->work), 3.6514, 2e-4);
  ck_assert_double_eq_tol(a->dissipated + part * (b->dissipated - a->dissipated), 6.5210, 2e-4);
  po_result_clear(&result);
}

static po_request loaded_at(po_request request, double load_speed, double dwell) {
  request.load_speed = load_speed;
  request.dwell = dwell;
  return request;
}

static void same_force(const po_request *first, const po_request *second, double within) {
  po_result a = solved(first), b = solved(second);
  ck_assert_double_le(fabs(a.pull_off.force - b.pull_off.force), within * b.pull_off.force);
  po_result_clear(&a);
  po_result_clear(&b);
}

TEST(slow_loading_is_the_default) {
  const po_request plain = rate_of(1.0, 0.0, 5.0, SOLID, 1.0);
  const po_request slow = loaded_at(plain, 0.0, INFINITY), held = loaded_at(plain, 0.0, 3.0);
  same_force(&slow, &plain, 0.0);
  same_force(&held, &plain, 0.0);
}

/* Loaded and unloaded at once, without a dwell, the body is elastic, with the glassy modulus. */
LOOP_TEST(at_once_the_loop_is_that_of_the_glassy_body, 0, 3) {
  static const double LOADED[][3] = {{0.1, 0.0, 2.0}, {1.0, 0.0, 5.0}, {3.0, 1.0, 4.0}};
  const double *s = LOADED[_i];
  const po_request glassy = rate_of(s[0] * pow(SOLID.ratio, 2.0 / 3.0), s[1], s[2], ELASTIC, NAN);
  const po_request fast = loaded_at(rate_of(s[0], s[1], s[2], SOLID, INFINITY), INFINITY, 0.0);
  po_result a = solved(&glassy), b = solved(&fast);
  ck_assert_double_eq_tol(b.pull_off.force, a.pull_off.force, 1e-6 * a.pull_off.force);
  ck_assert_double_eq_tol(b.rate.loading.start.energy.dissipated, 0.0,
                          b.rate.loading.error.dissipated);
  ck_assert_double_eq_tol(b.rate.end.energy.dissipated, 0.0, b.rate.end_error.dissipated);
  po_result_clear(&a);
  po_result_clear(&b);
}

/* After a long dwell the contact is relaxed: at the approach, also through a spring, or the load
 * of the preload. The same after slow loading. */
LOOP_TEST(a_long_dwell_ends_at_the_relaxed_contact, 0, 3) {
  po_request relaxed = rate_of(1.0, 0.0, 3.0, (po_creep){PO_CREEP_GAMMA, 0.1, 0.6}, 2.0);
  if (_i == 1)
    relaxed.stiffness = 0.5;
  if (_i == 2)
    relaxed.preload = (po_preload){NAN, 2.0};
  const double speeds[] = {3.0, 30.0, INFINITY};
  for (int k = 0; k < 2; ++k) {
    const po_request loaded = loaded_at(relaxed, speeds[_i], k ? INFINITY : 200.0);
    po_result a = solved(&relaxed), b = solved(&loaded);
    ck_assert_double_eq_tol(b.rate.begin.approach, a.rate.begin.approach, 1e-5);
    ck_assert_double_eq_tol(b.rate.begin.load, a.rate.begin.load, 1e-5);
    /* a jump from the spring is not extrapolated */
    const double within = _i == 1 ? a.pull_off.force_error + b.pull_off.force_error : 2e-6;
    ck_assert_double_lt(within, 2e-4);
    ck_assert_double_le(fabs(b.pull_off.force - a.pull_off.force), within);
    ck_assert_double_lt(b.rate.loading.start.energy.dissipated, -0.1);
    po_result_clear(&a);
    po_result_clear(&b);
  }
  const po_request slow = loaded_at(relaxed, 1e-6, 0.0);
  same_force(&slow, &relaxed, _i == 1 ? 5e-5 : 2e-6);
}

/* The states of loading and dwell come before unloading; the balance holds from the first one. */
LOOP_TEST(energy_is_balanced_from_the_begin_of_loading, 0, 2) {
  po_request request = _i == 0 ? rate_of(1.0, 0.0, 3.0, SOLID, 2.0)
                               : rate_of(3.0, 1.0, 8.0, (po_creep){PO_CREEP_GAMMA, 0.1, 1.4}, 30.0);
  if (_i == 0)
    request.stiffness = 0.3;
  request = loaded_at(request, 5.0, 0.5);
  request.want |= PO_WANT_HISTORY;
  po_result result = solved(&request);
  const po_rate_point *p = result.rate.history;
  ck_assert_uint_eq(result.rate.history_count, result.rate.steps);
  ck_assert_double_lt(p->time, -0.5);
  ck_assert_double_eq_tol(p->energy.work, result.rate.loading.start.energy.work,
                          result.rate.loading.error.work);
  for (size_t k = 1; k < result.rate.history_count; ++k) {
    const po_rate_energy *e = &p[k].energy, *first = &p->energy;
    const double change =
        e->stored + e->adhesive + e->spring - first->stored - first->adhesive - first->spring;
    ck_assert_double_eq_tol(e->work - first->work,
                            change + e->dissipated + e->jumps - first->dissipated - first->jumps,
                            1e-3);
    ck_assert_double_ge(e->dissipated, p[k - 1].energy.dissipated - 1e-9);
    ck_assert_double_ge(e->jumps, p[k - 1].energy.jumps - 1e-9);
    ck_assert_double_ge(p[k].time, p[k - 1].time);
    if (p[k].time <= -0.5)
      ck_assert_double_ge(p[k].base, p[k - 1].base);
    else if (p[k].time <= 0.0)
      ck_assert_double_eq_tol(p[k].approach, request.preload.approach, 1e-8);
  }
  ck_assert_uint_ge(result.rate.loading.jumps, 1);
  po_result_clear(&result);
}

/* Values of the independent solver of reference/make/unloading.py, to its digits: loaded at speed 1
 * from approach -10 to 5. */
TEST(work_of_loading_is_that_of_the_independent_solver) {
  const po_request request = loaded_at(rate_of(1.0, 0.0, 5.0, SOLID, 1.0), 1.0, 0.0);
  po_result result = solved(&request);
  const po_rate_loading *l = &result.rate.loading;
  ck_assert_double_eq_tol(-l->start.energy.work, 7.0847373, 1e-4);
  ck_assert_double_eq_tol(-l->start.energy.dissipated, 7.2749419, 2e-5);
  ck_assert_double_eq_tol(l->start.time, -15.0, 1e-9);
  po_result_clear(&result);
}
