/* Scenes of any profile that were solved wrongly, or not at all. */
#include <math.h>
#include <signal.h>

#include "po_input.h"
#include "po_solve.h"
#include "run.h"

static po_request request_of(const char *law, const char *profile, const char *coupling,
                             const char *waves, double tolerance) {
  po_request request = po_request_default();
  ck_assert(po_key_set(&request, PO_KEY_LAW, law));
  ck_assert(po_key_set(&request, PO_KEY_PROFILE, profile));
  ck_assert(po_key_set(&request, PO_KEY_COUPLING, coupling));
  if (waves)
    ck_assert(po_key_set(&request, PO_KEY_WAVES, waves));
  request.mesh.tolerance = tolerance;
  return request;
}

static volatile sig_atomic_t stop;

/* Ends the trace in the third groove. */
static void look(void *data, double approach, double load) {
  (void)data;
  (void)approach;
  stop = load < -60.0;
}

/* The arclength functional of a wavy cone differs by 3e-3 between two meshes, an amount by which
 * the contact edge moves by many of its widths beside a groove. So no step converged at approach
 * -2.077, however short, and three folds before were not found on a finer mesh. */
TEST(a_point_is_measured_on_the_mesh_of_the_next) {
  po_request request = request_of("morse:2.59436", "cone:0.0909885", "0.962968",
                                  "1.58546@6.92016;0.0757938@8.13471", 1e-6);
  request.watch = look;
  request.stop = &stop;
  po_result o;
  stop = 0;
  ck_assert_msg(po_solve(&request, &o) == PO_INTERRUPTED, "%s", o.reason);
  ck_assert_uint_ge(o.fold_count, 6);
  /* the deepest minimum before the preload was stated as the pull-off */
  ck_assert(!o.has_pull_off);
  ck_assert_msg(strstr(o.reason, "the deepest minimum of the load so far, -") != NULL, "%s",
                o.reason);
  for (size_t k = 0; k < o.fold_count; ++k)
    ck_assert_msg(isfinite(o.folds[k].approach_error), "fold at approach %g", o.folds[k].approach);
  po_result_clear(&o);
}

typedef struct {
  const char *law, *profile, *coupling;
} scene;

static const scene KINKS[] = {{"lennard-jones", "punch:4.3352,19.704", "0.14297"},
                              {"morse:1.5", "truncated:16.179,96.72", "0.17419"}};

/* Far from the edge of a flat part a panel may have it inside. The energy of such a point has a
 * larger error than that of any special point, from which the error of an energy lost was
 * estimated: it was 2.2 and 3.2 times what was stated. */
TABLE_TEST(energies_lost_are_within_their_errors, KINKS) {
  const scene *s = &KINKS[_i];
  double lost[2][2], error[2][2]; /* of the loop, and of the first cycle of the staircase */
  for (int tight = 0; tight < 2; ++tight)
    for (int stairs = 0; stairs < 2; ++stairs) {
      po_request request = request_of(s->law, s->profile, s->coupling, NULL, tight ? 1e-7 : 1e-4);
      request.want = stairs ? PO_WANT_PRELOAD : PO_WANT_HYSTERESIS;
      po_result o;
      ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
      ck_assert(stairs ? o.has_staircases : o.has_hysteresis);
      const po_loop *loop = &o.hysteresis.of[PO_AT_APPROACH];
      const po_cycle *cycle = stairs ? &o.staircase.of[0].step[0].cycle[0] : NULL;
      lost[stairs][tight] = cycle ? cycle->loss.energy : loop->energy_lost;
      error[stairs][tight] = cycle ? cycle->energy_error : loop->energy_lost_error;
      po_result_clear(&o);
    }
  for (int stairs = 0; stairs < 2; ++stairs) {
    const double off = fabs(lost[stairs][0] - lost[stairs][1]);
    ck_assert_double_le(off, error[stairs][0] + error[stairs][1]);
    ck_assert(stairs || error[stairs][0] < 10.0 * off);
  }
}

/* Where the slope of the profile jumps, at a tip and at a corner, the deflection has a part x^2 ln
 * x, which Gauss's rule does not integrate exactly: energies were off by 2.6 and 8 times the stated
 * error. Given: a profile, a law and the approach at which the trace ends. */
LOOP_TEST(energies_of_profiles_with_a_corner_are_within_their_errors, 0, 2) {
  static const scene SCENES[] = {{"mie:5.27,10.69", "cone:0.0540348", "0.00235669"},
                                 {"lennard-jones", "truncated:7.31919,16.5028", "0.169458"}};
  static const double APPROACHES[] = {-0.4432476, 0.09950589};
  const scene *s = &SCENES[_i];
  double energy[2], error[2];
  for (int tight = 0; tight < 2; ++tight) {
    po_request request = request_of(s->law, s->profile, s->coupling, NULL, tight ? 1e-8 : 1e-4);
    request.want = PO_WANT_CURVE;
    request.approach_end = APPROACHES[_i];
    po_result o;
    ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
    const po_curve_point *last = &o.curve[o.curve_count - 1];
    ck_assert_double_eq_tol(last->approach, APPROACHES[_i], 1e-9);
    energy[tight] = last->energy;
    error[tight] = last->energy_error;
    po_result_clear(&o);
  }
  const double off = fabs(energy[0] - energy[1]);
  ck_assert_double_ge(error[0], 1.5 * off); /* measured: 2.6 and 3.1 */
  ck_assert_double_le(error[0], 6.0 * off);
}

/* Solves a request. Returned: the pull-off force, 0 if there is none. */
static double solved(po_request *request, double *error) {
  po_result o;
  const po_status status = po_solve(request, &o);
  ck_assert_msg(!status, "%s", o.reason);
  const double force = o.has_pull_off ? o.pull_off.force : 0.0;
  *error = o.has_pull_off ? o.pull_off.force_error : NAN;
  po_result_clear(&o);
  return force;
}

/* A trace from so far out that the first step is on another mesh, whose first node is farther from
 * the tip of the cone. The least gap of the nodes therefore grew by more than the bodies
 * approached, and the trace failed at its second point: "the branch returned to its beginning". The
 * force does not depend on where the trace begins. */
TEST(a_tip_between_the_nodes_is_no_return) {
  po_request request =
      request_of("lennard-jones", "cone:0.717956", "0.18996", "1.04875@70.7415", 1e-6);
  double near_error, far_error;
  request.preload.load = 1.0;
  const double near = solved(&request, &near_error);
  request.approach_start = -29683.25;
  const double far = solved(&request, &far_error);
  ck_assert_double_eq_tol(near, far, near_error + far_error);
}

/* A long step predicts a gap at which a traction as (1 + H)^-35 is 1e36. Newton's method then
 * changed the approach by 1e30 and no gap, and the prediction passed
 * for an equilibrium, which no mesh resolved: "the traction needs 8192 panels, more than 4096". */
TEST(a_prediction_beyond_contact_is_no_equilibrium) {
  po_request request = request_of("mie:14.3,35", "sphere", "0.2619", NULL, 1e-6);
  ck_assert(po_key_set(&request, PO_KEY_RADIUS, "320"));
  ck_assert(po_key_set(&request, PO_KEY_TABOR, "2.8"));
  request.scene.outer_radius = 16.0;
  double error, other;
  const double force = solved(&request, &error);
  ck_assert_double_eq_tol(force, 0.54831, 1e-3 * force); /* 801 nodes of triangles */
  request.mesh.tolerance = 1e-8;
  ck_assert_double_eq_tol(force, solved(&request, &other), error + other);
}

/* A trace that begins far out, as through a soft spring, doubles its steps until one ends beyond
 * contact, where a traction as (1 + H)^-33 is 1e33. The factors then left Eq 15 an error of 1e35
 * and changed neither gaps nor approach, and the condition of the step was met: "the traction needs
 * 8192 panels". The force does not depend on where the trace begins. */
LOOP_TEST(an_iteration_that_leaves_the_equation_has_not_converged, 0, 2) {
  static const scene SCENES[] = {{"mie:15,33", "power:0.02,2", "0.7"},
                                 {"mie:9,33", "power:5e-3,2", "0.1"}};
  const scene *s = &SCENES[_i];
  po_request request = request_of(s->law, s->profile, s->coupling, NULL, 1e-6);
  request.scene.outer_radius = 50.0;
  double near_error, far_error;
  const double near = solved(&request, &near_error);
  for (double start = -3e3; start > -2e5; start *= 7.0) {
    request.approach_start = start;
    ck_assert_double_eq_tol(near, solved(&request, &far_error), near_error + far_error);
  }
}

static const struct {
  const char *law, *profile, *outer;
} STEEP[] = {{"mie:20,40", "power:1e-8,9", "30"}, {"mie:4,12", "power:1e-32,40", "9"}};

/* The traction falls as r^-180 and as r^-160 far out. The weights of the panel to infinity
 * overflowed, so that there was "no equilibrium at the start". What is beyond a cut at which the
 * gap is 2e5 and 1.5e6 eps changes nothing. */
LOOP_TEST(steep_profiles_are_solved_on_the_half_space, 0, 2) {
  po_request request = request_of(STEEP[_i].law, STEEP[_i].profile, "0.05", NULL, 1e-6);
  double error, cut_error;
  const double force = solved(&request, &error);
  ck_assert(po_key_set(&request, PO_KEY_OUTER_RADIUS, STEEP[_i].outer));
  ck_assert_double_eq_tol(force, solved(&request, &cut_error), error + cut_error);
}
