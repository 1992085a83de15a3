/* Tests of loading and unloading: closed forms, and the energy balance of whole loops. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "po_guduru.h"
#include "po_jkr_profile.h"
#include "po_solve.h"
#include "po_staircase.h"
#include "po_theory_forces.h"
#include "run.h"

/* The preload of the smooth sphere. */
static const po_preload PRESSED = {NAN, 1.5};

/* Energy of the JKR sphere at a contact radius in units of Gamma, integral of Eq 7 d(Eq 8). */
static double jkr_energy(double tabor, double a) {
  return tabor *
         (8.0 * pow(a, 5.0) / (15.0 * M_PI) -
          (4.0 / 21.0 * sqrt(2.0 / M_PI) + 8.0 / 7.0 * sqrt(2.0 / M_PI)) * pow(a, 3.5) + a * a);
}

/* The smooth sphere by JKR: it jumps in at first touch to the radius of approach 0, (2 pi)^(1/3),
 * and out where the approach is least, at (pi/8)^(1/3), at -1.60877204783 mu under 5/6 of pi w R;
 * under a load it comes together to the radius of no load, (9 pi/2)^(1/3), and parts at 3/2. */
LOOP_TEST(jkr_in_closed_form, 0, 2) {
  const double tabor = 2.385;
  po_scene scene = {tabor, 0.0, 0.0, 83.0, INFINITY};
  if (_i) /* the same sphere as a power */
    ck_assert(po_profile_set(&scene.profile, "power:0.0060240963855421684,2"));
  po_hysteresis h;
  ck_assert_int_eq(po_jkr_hysteresis(&scene, PRESSED, NAN, SIZE_MAX, &h), PO_OK);
  const po_loop *d = &h.of[PO_AT_APPROACH], *l = &h.of[PO_AT_LOAD];
  ck_assert_uint_eq(d->jump_count, 2);
  ck_assert_uint_eq(d->loading_jumps, 1);
  ck_assert_double_eq_tol(d->preload.load, 1.5, 1e-12);
  ck_assert_double_eq_tol(d->pull_off.load, -1.5, 1e-12);
  ck_assert_double_eq_tol(d->pull_off.approach, -0.77341693157 * tabor, 1e-10);
  ck_assert_double_eq_tol(d->jumps[0].before.approach, 0.0, 1e-15);
  ck_assert_double_eq_tol(d->jumps[0].energy_lost, -jkr_energy(tabor, cbrt(2.0 * M_PI)), 1e-6);
  ck_assert_double_eq_tol(d->jumps[1].before.approach, -1.60877204783 * tabor, 1e-10);
  ck_assert_double_eq_tol(d->jumps[1].before.load, -5.0 / 6.0, 1e-12);
  ck_assert_double_eq_tol(d->jumps[1].energy_lost, jkr_energy(tabor, cbrt(M_PI / 8.0)), 1e-10);
  ck_assert_double_eq_tol(d->work, d->energy_lost, 1e-6);
  ck_assert_uint_eq(l->jump_count, 2);
  ck_assert(isinf(l->jumps[0].before.approach) && isinf(l->jumps[1].after.approach));
  ck_assert_double_eq_tol(l->jumps[0].energy_lost, -jkr_energy(tabor, cbrt(4.5 * M_PI)), 1e-6);
  ck_assert_double_eq_tol(l->jumps[1].before.load, -1.5, 1e-12);
  ck_assert(isnan(l->jumps[1].energy_lost) && isnan(l->energy_lost));
  po_hysteresis_clear(&h);
}

/* The position of the base of a spring at a contact radius of the JKR sphere. */
static double base_of(const po_scene *scene, double stiffness, double a) {
  const po_contact at = po_jkr_profile_at(scene, a);
  return at.approach + at.load / stiffness;
}

/* The JKR sphere through a spring: it jumps in at first touch, where the base is at 0, and out
 * where the position of the base is least, which is found here by halving an interval about it. */
LOOP_TEST(spring_in_closed_form, 0, 4) {
  static const double STIFFNESS[] = {0.03, 0.3, 3.0, 300.0};
  const double stiffness = STIFFNESS[_i], tiny = 1e-4;
  po_scene scene = {2.385, 0.0, 0.0, 83.0, INFINITY};
  po_hysteresis h;
  ck_assert_int_eq(po_jkr_hysteresis(&scene, PRESSED, stiffness, SIZE_MAX, &h), PO_OK);
  ck_assert(h.has_spring);
  const po_loop *s = &h.of[PO_THROUGH_SPRING];
  ck_assert_uint_eq(s->jump_count, 2);
  ck_assert_double_eq_tol(s->jumps[0].before.approach, 0.0, 1e-12);
  ck_assert_double_eq_tol(base_of(&scene, stiffness, s->jumps[0].after.contact_radius), 0.0, 1e-2);
  double low = 1.0, high = s->preload.contact_radius;
  while (high - low > 1e-9) {
    const double a = 0.5 * (low + high);
    if (base_of(&scene, stiffness, a + tiny) > base_of(&scene, stiffness, a - tiny))
      high = a;
    else
      low = a;
  }
  const po_path_state *out = &s->jumps[1].before;
  const po_contact at = po_jkr_profile_at(&scene, low);
  ck_assert_double_eq_tol(out->approach + out->load / stiffness, base_of(&scene, stiffness, low),
                          1e-8 * (1.0 + 1.0 / stiffness));
  ck_assert_double_eq_tol(out->load, at.load, 1e-4);
  /* at the end of the jump the bodies are apart, and the base has not moved */
  ck_assert_double_eq_tol(s->jumps[1].after.load, 0.0, 1e-15);
  ck_assert_double_eq_tol(s->jumps[1].energy_lost,
                          out->energy + 0.5 * out->load * out->load / stiffness, 1e-9);
  ck_assert_double_eq_tol(s->work, s->energy_lost, 1e-6 * s->work);
  po_hysteresis_clear(&h);
}

/* The cone t r by JKR: at approach a it is g = (pi/2) t a. It jumps in at first touch to the radius
 * of approach 0, parts at given approach where g' = sqrt(pi c/(2a)), and pulls off at given load
 * under 54 c/(pi^2 t^3). */
TEST(cone_in_closed_form) {
  const double t = 0.3, coupling = 0.7, slope = M_PI_2 * t;
  po_scene scene = po_scene_default();
  scene.radius = 1.0;
  scene.tabor = po_scene_tabor_of_coupling(coupling, 1.0);
  ck_assert(po_profile_set(&scene.profile, "cone:0.3"));
  po_hysteresis h;
  ck_assert_int_eq(po_jkr_hysteresis(&scene, (po_preload){NAN, 40.0}, NAN, SIZE_MAX, &h), PO_OK);
  const po_loop *d = &h.of[PO_AT_APPROACH], *l = &h.of[PO_AT_LOAD];
  const double last = 0.5 * M_PI * coupling / (slope * slope);
  ck_assert_uint_eq(d->jump_count, 2);
  ck_assert_double_eq_tol(d->jumps[0].before.approach, 0.0, 1e-15);
  ck_assert_double_eq_tol(d->jumps[0].after.contact_radius, 4.0 * last, 1e-3 * last);
  ck_assert_double_eq_tol(d->jumps[1].before.contact_radius, last, 1e-10);
  ck_assert_double_eq_tol(d->jumps[1].before.approach, -slope * last, 1e-10);
  ck_assert_double_eq_tol(d->pull_off.load, -54.0 * coupling / (M_PI * M_PI * t * t * t), 1e-9);
  ck_assert_double_eq_tol(d->work, d->energy_lost, 1e-6 * d->work);
  ck_assert_double_eq_tol(l->jumps[1].before.load, d->pull_off.load, 1e-9);
  po_hysteresis_clear(&h);
}

/* A truncated sphere parts from its corner, at the radius of the flat, under either control. */
TEST(truncated_sphere_parts_from_its_corner) {
  po_scene scene = po_scene_default();
  scene.radius = 1.0;
  scene.tabor = po_scene_tabor_of_coupling(0.05, 1.0);
  ck_assert(po_profile_set(&scene.profile, "truncated:5,20"));
  po_hysteresis h;
  ck_assert_int_eq(po_jkr_hysteresis(&scene, (po_preload){NAN, 40.0}, NAN, SIZE_MAX, &h), PO_OK);
  const po_contact corner = po_jkr_profile_at(&scene, 5.0);
  const po_loop *d = &h.of[PO_AT_APPROACH], *l = &h.of[PO_AT_LOAD];
  ck_assert_uint_eq(d->jump_count, 2);
  ck_assert_double_eq_tol(d->jumps[1].before.contact_radius, 5.0, 1e-12);
  ck_assert_double_eq_tol(d->jumps[1].before.approach, corner.approach, 1e-12);
  ck_assert_double_eq_tol(d->pull_off.load, corner.load, 1e-10);
  ck_assert_double_eq_tol(l->jumps[1].before.load, corner.load, 1e-10);
  ck_assert_double_eq_tol(d->work, d->energy_lost, 1e-6 * d->work);
  po_hysteresis_clear(&h);
}

/* Two waves: the greatest step of both staircases is the lowest minimum of the curve; with a second
 * wave of no height the staircases are those of Eq 5. */
LOOP_TEST(staircases_of_two_waves, 0, 2) {
  po_scene scene = po_scene_default();
  scene.tabor = 5.0;
  po_staircases one, two;
  ck_assert(po_scene_set_waves(&scene, "4@20"));
  ck_assert_int_eq(po_jkr_staircases(&scene, NAN, &one), PO_OK);
  ck_assert(po_scene_set_waves(&scene, _i ? "4@20;1e-13@6" : "4@20;0.1@6"));
  ck_assert_int_eq(po_jkr_staircases(&scene, NAN, &two), PO_OK);
  po_contact least;
  ck_assert_int_eq(po_jkr_profile_pull_off(&scene, PO_FIXED_LOAD, &least), PO_OK);
  for (int c = 0; c < 2; ++c) {
    const po_step *greatest = po_staircase_greatest(&two.of[c]);
    ck_assert_ptr_nonnull(greatest);
    ck_assert_double_eq_tol(greatest->pull_off.load, least.load, 1e-9);
    ck_assert_uint_gt(one.of[c].count, 1);
    for (size_t k = 0; _i && k < one.of[c].count; ++k)
      ck_assert_double_eq_tol(two.of[c].step[k].pull_off.load, one.of[c].step[k].pull_off.load,
                              1e-9);
  }
  po_staircases_clear(&one);
  po_staircases_clear(&two);
}

/* The deepest minimum of this scene is beyond the curve that is first computed: it ends at twice
 * the contact radius of the minimum, and loading gets there only from a greater one. */
TEST(staircases_reach_the_lowest_minimum) {
  const po_scene scene = {3.27828, 1.86086, 44.143, 40.1129, INFINITY};
  po_staircases s;
  ck_assert_int_eq(po_jkr_staircases(&scene, NAN, &s), PO_OK);
  for (int c = 0; c < 2; ++c) {
    const po_step *greatest = po_staircase_greatest(&s.of[c]);
    ck_assert_ptr_nonnull(greatest);
    ck_assert_double_eq_tol(greatest->pull_off.load, po_guduru_pull_off(&scene).load, 1e-9);
  }
  po_staircases_clear(&s);
}

/* Every step and every cycle of the staircase through a spring is what one loop to just beyond it
 * gives, and differs from that at given approach. */
TEST(staircase_through_a_spring) {
  const double stiffness = 0.3, beyond = 1e-3;
  po_scene scene = {3.0, 1.0, 20.0, 100.0, INFINITY};
  po_staircases s;
  ck_assert_int_eq(po_jkr_staircases(&scene, stiffness, &s), PO_OK);
  ck_assert(s.has_spring);
  ck_assert_double_eq(s.of[2].control, stiffness);
  ck_assert_uint_ge(s.of[2].count, 2);
  for (size_t k = 0; k < 2; ++k) {
    const po_step *step = &s.of[2].step[k], *held = &s.of[0].step[k];
    const po_cycle *cycle = &step->cycle[0];
    po_hysteresis h;
    const po_preload preload = {cycle->preload.approach + beyond, NAN};
    ck_assert_int_eq(po_jkr_hysteresis(&scene, preload, stiffness, SIZE_MAX, &h), PO_OK);
    ck_assert_double_eq_tol(h.of[PO_THROUGH_SPRING].pull_off.load, step->pull_off.load, 1e-12);
    ck_assert_uint_eq(h.of[PO_THROUGH_SPRING].jump_count, cycle->loss.jumps);
    ck_assert_double_eq_tol(h.of[PO_THROUGH_SPRING].energy_lost, cycle->loss.energy, 1e-9);
    ck_assert_double_gt(cycle->loss.energy, 1.5 * held->cycle[0].loss.energy);
    po_hysteresis_clear(&h);
  }
  po_staircases_clear(&s);
}

/* JKR: with the load as a function of the approach the slope dW/d(approach) decides at a base, the
 * sign of both rates under either control. */
TEST(modes_at_a_base) {
  ck_assert_int_eq(po_modes_held(PO_DISPLACEMENT_CONTROL, 0, 1.0, -5.0), 0);
  ck_assert_int_eq(po_modes_held(2.0, 0, 1.0, -1.9), 0);
  ck_assert_int_eq(po_modes_held(2.0, 0, 1.0, -2.1), 1);
  ck_assert_int_eq(po_modes_held(2.0, 1, -1.0, 2.1), 2);
  ck_assert_int_eq(po_modes_held(2.0, 1, -1.0, -2.1), 1);
  ck_assert_int_eq(po_modes_held(PO_LOAD_CONTROL, 0, 1.0, -1e-9), 1);
  ck_assert_int_eq(po_modes_held(PO_LOAD_CONTROL, 0, 1.0, 1e-9), 0);
}

/* Bradley's spheres never jump at fixed approach; under a load they come together where Eq 23
 * vanishes, x = 4^(-1/6), and part at 2. */
TEST(bradley_in_closed_form) {
  po_request request = po_request_default();
  request.scene.tabor = 0.0;
  request.want = PO_WANT_HYSTERESIS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_loop *d = &o.hysteresis.of[PO_AT_APPROACH], *l = &o.hysteresis.of[PO_AT_LOAD];
  ck_assert_uint_eq(d->jump_count, 0);
  ck_assert_double_eq_tol(d->pull_off.load, -2.0, 1e-9);
  ck_assert_double_eq_tol(d->energy_lost, 0.0, 1e-15);
  ck_assert_double_eq_tol(d->work, 0.0, 1e-9); /* back the way it came */
  ck_assert_uint_eq(l->jump_count, 2);
  const double x = pow(4.0, -1.0 / 6.0);
  ck_assert_double_eq_tol(l->jumps[0].after.approach, 1.0 - x, 1e-5);
  const double lost = 8.0 / (3.0 * x) - 2.0 / (21.0 * pow(x, 7.0));
  ck_assert_double_eq_tol(l->jumps[0].energy_lost, lost, 1e-5);
  ck_assert_double_le(fabs(l->jumps[0].energy_lost - lost), l->jumps[0].energy_lost_error);
  ck_assert_double_eq_tol(l->jumps[1].before.load, -2.0, 1e-9);
  po_result_clear(&o);
}

static const struct {
  po_scene scene;
  po_preload preload;
  size_t jumps;
} LOOPS[] = {{{2.385, 0.0, 0.0, 83.0, INFINITY}, {NAN, NAN}, 2},
             {{4.0, 0.4, 10.0, 100.0, 100.0}, {4.0, NAN}, 6},
             {{1.3, 0.7, 23.85, 100.0, INFINITY}, {NAN, 1.1}, 4}};

static void check_balance(const po_loop *loop, double accuracy) {
  double lost = 0.0;
  for (size_t k = 0; k < loop->jump_count; ++k) {
    const po_jump *jump = &loop->jumps[k];
    ck_assert_double_gt(jump->energy_lost, 0.0);
    ck_assert_double_eq_tol(jump->before.approach, jump->after.approach, 1e-9);
    ck_assert(jump->loading == (k < loop->loading_jumps));
    ck_assert((jump->after.contact_radius > jump->before.contact_radius) == jump->loading);
    lost += jump->energy_lost;
  }
  ck_assert_double_eq_tol(lost, loop->energy_lost, 1e-12);
  ck_assert_double_eq_tol(loop->work / loop->energy_lost, 1.0, accuracy);
}

/* The loop is pulled off at the deepest minimum of the curve, and states it as it was located. */
static void is_located(const po_loop *loop, const po_result *o) {
  ck_assert_double_eq(-loop->pull_off.load, o->pull_off.force);
  ck_assert_double_eq(loop->pull_off.approach, o->pull_off.approach);
  ck_assert_double_eq(loop->pull_off_error.load, o->pull_off.force_error);
  ck_assert_double_eq(loop->pull_off_error.approach, o->pull_off.approach_error);
}

/* The integral of the load over the closed loop equals the sum of the energies lost in the jumps,
 * which are computed from the gaps. The error of the integral is that of the cubic interpolation: a
 * curve that is off by at most 0.06 of the tolerance of 1e-6 everywhere encloses an area that is
 * off by at most that times its length, of which the way in approach and back is the most. The same
 * holds for the loops of the theory on their points. */
TABLE_TEST(loop_loses_what_its_jumps_do, LOOPS) {
  po_request request = po_request_default();
  request.scene = LOOPS[_i].scene;
  request.mesh.scheme = PO_PANEL;
  request.preload = LOOPS[_i].preload;
  request.want = PO_WANT_HYSTERESIS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(o.hysteresis.of[PO_AT_APPROACH].jump_count, LOOPS[_i].jumps);
  const po_loop *loop = &o.hysteresis.of[PO_AT_APPROACH];
  const double way = 2.0 * (loop->preload.approach - o.start);
  check_balance(loop, 0.06 * 1e-6 * way / loop->energy_lost);
  po_hysteresis h;
  ck_assert_int_eq(
      po_jkr_hysteresis(&request.scene, po_request_preload(&request), NAN, SIZE_MAX, &h), PO_OK);
  check_balance(&h.of[PO_AT_APPROACH], 1e-8);
  is_located(loop, &o);
  is_located(&o.hysteresis.of[PO_AT_LOAD], &o);
  po_hysteresis_clear(&h);
  po_result_clear(&o);
}

static void holds(double loose, double loose_error, double tight, double tight_error) {
  ck_assert_double_gt(loose_error, 0.0);
  ck_assert_double_le(fabs(loose - tight), loose_error + tight_error);
  ck_assert_double_lt(loose_error, 2e-4); /* says something: energies are of order one */
}

static void loops_hold(const po_loop *loose, const po_loop *tight) {
  ck_assert_uint_eq(loose->jump_count, tight->jump_count);
  for (size_t k = 0; k < loose->jump_count; ++k)
    if (isfinite(loose->jumps[k].energy_lost))
      holds(loose->jumps[k].energy_lost, loose->jumps[k].energy_lost_error,
            tight->jumps[k].energy_lost, tight->jumps[k].energy_lost_error);
  if (!isfinite(loose->energy_lost))
    return;
  holds(loose->energy_lost, loose->energy_lost_error, tight->energy_lost, tight->energy_lost_error);
  holds(loose->work, loose->work_error, tight->work, tight->work_error);
}

/* The errors of energies that a solve at 1e-4 states hold against one at 1e-8: of folds, of the
 * last point of the curve, of the preload, and of what loops lose. */
TABLE_TEST(stated_errors_of_energies_hold, LOOPS) {
  po_request request = po_request_default();
  po_result o[2];
  request.scene = LOOPS[_i].scene;
  request.mesh.scheme = PO_PANEL;
  request.preload = LOOPS[_i].preload;
  request.approach_end = 9.0;
  request.want = PO_WANT_HYSTERESIS | PO_WANT_CURVE;
  for (int k = 0; k < 2; ++k) {
    request.mesh.tolerance = k ? 1e-8 : 1e-4;
    ck_assert_int_eq(po_solve(&request, &o[k]), PO_OK);
  }
  ck_assert_uint_eq(o[0].fold_count, o[1].fold_count);
  for (size_t k = 0; k < o[0].fold_count; ++k)
    holds(o[0].folds[k].energy, o[0].folds[k].energy_error, o[1].folds[k].energy,
          o[1].folds[k].energy_error);
  const po_curve_point *last[2];
  for (int k = 0; k < 2; ++k)
    last[k] = &o[k].curve[o[k].curve_count - 1];
  ck_assert_double_eq_tol(last[0]->approach, last[1]->approach, 1e-9);
  holds(last[0]->energy, last[0]->energy_error, last[1]->energy, last[1]->energy_error);
  const po_loop *loop = &o[0].hysteresis.of[PO_AT_APPROACH];
  ck_assert_double_gt(loop->energy_error, 0.0);
  if (isfinite(request.preload.approach)) /* the same approach in both */
    holds(loop->preload.energy, loop->energy_error,
          o[1].hysteresis.of[PO_AT_APPROACH].preload.energy,
          o[1].hysteresis.of[PO_AT_APPROACH].energy_error);
  loops_hold(loop, &o[1].hysteresis.of[PO_AT_APPROACH]);
  loops_hold(&o[0].hysteresis.of[PO_AT_LOAD], &o[1].hysteresis.of[PO_AT_LOAD]);
  po_result_clear(&o[0]);
  po_result_clear(&o[1]);
}

/* With a preload that reaches only the first crest, the pull-off force of a test is smaller than
 * with the default preload. The reported pull-off must be that of the test. */
TEST(a_small_preload_measures_less) {
  po_request request = po_request_default();
  request.scene = (po_scene){4.0, 3.0, 10.0, 100.0, 100.0};
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = 1e-4;
  request.preload.approach = -2.0;
  request.want = PO_WANT_HYSTERESIS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(o.hysteresis.of[PO_AT_APPROACH].loading_jumps, 1);
  ck_assert_double_lt(o.pull_off.force, 0.45);
  ck_assert_double_eq_tol(-o.hysteresis.of[PO_AT_APPROACH].pull_off.load, o.pull_off.force, 1e-4);
  po_result_clear(&o);
  request.preload.approach = NAN;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.pull_off.force, 1.226617, 1e-4);
  po_result_clear(&o);
}

TEST(a_preload_beyond_the_trace_is_refused) {
  po_request request = po_request_default();
  request.mesh.scheme = PO_PANEL;
  request.approach_end = 0.5;
  request.preload.load = 0.7;
  request.want = PO_WANT_HYSTERESIS;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_NOT_FOUND);
  ck_assert(!o.has_hysteresis);
  po_result_clear(&o);
  request.preload.load = -0.1;
  ck_assert_int_eq(po_solve(&request, &o), PO_BAD_INPUT);
}
