/* The work of adhesion of a moving edge, and the pull-off force that follows from it. */
#include <math.h>
#include <stdlib.h>

#include "po_jkr.h"
#include "po_persson_brener.h"
#include "po_scene.h"
#include "run.h"

static po_creep_terms terms_of(po_creep creep) {
  po_creep_terms terms;
  po_creep_terms_fill(&creep, 1.0, &terms);
  return terms;
}

/* The integral of the theory, 2/pi over the frequencies y up to that of the edge, 1/x, of
 * sqrt(1 - (x y)^2) times the loss compliance c tau/(1 + (y tau)^2), by the midpoint rule after y =
 * sin(s)/x, which makes the integrand smooth. */
static double loss(double x, double tau) {
  enum { COUNT = 200000 };
  double sum = 0.0;
  for (int i = 0; i < COUNT; ++i) {
    const double s = M_PI_2 * (i + 0.5) / COUNT, y = sin(s) / x;
    sum += cos(s) * cos(s) / x * tau / (1.0 + y * y * tau * tau);
  }
  return 2.0 / M_PI * sum * M_PI_2 / COUNT;
}

TEST(each_time_is_the_integral_over_the_frequencies) {
  const po_creep_terms terms = {0.1, 2, {{0.3, 0.4}, {2.385, 0.5}}};
  for (double x = 0.01; x < 100.0; x *= 7.3) {
    const double sum = 0.4 * loss(x, 0.3) + 0.5 * loss(x, 2.385);
    const po_edge_law law = po_persson_brener_at(&terms, x);
    ck_assert_double_eq_tol(law.work, 1.0 / (1.0 - sum), 1e-7 * law.work);
    ck_assert_double_eq_tol(law.speed, law.work / (2.0 * M_PI * x), 1e-14 * law.speed);
  }
}

TEST(it_goes_from_rest_to_the_glassy_limit) {
  const po_creep_terms terms = terms_of((po_creep){PO_CREEP_GAMMA, 0.1, 0.6});
  ck_assert_double_eq_tol(po_persson_brener_at(&terms, 1e12).work, 1.0, 1e-11);
  ck_assert_double_eq_tol(po_persson_brener_at(&terms, 1e-20).work, 10.0, 1e-2);
  double before = 11.0;
  for (double x = 1e-8; x < 1e8; x *= 1.7) {
    const double work = po_persson_brener_at(&terms, x).work;
    ck_assert_double_lt(work, before);
    before = work;
  }
}

/* One time in closed form: S = sqrt(1 + x^2) - x gives x = (1 - S^2)/(2 S). */
TEST(one_time_is_inverted_in_closed_form) {
  const po_creep_terms terms = terms_of((po_creep){PO_CREEP_SLS, 0.2, 1.0});
  for (double work = 1.1; work < 5.0; work += 0.37) {
    const double s = (1.0 - 1.0 / work) / 0.8;
    ck_assert_double_eq_tol(po_persson_brener_at(&terms, (1.0 - s * s) / (2.0 * s)).work, work,
                            1e-12);
  }
}

static const po_preload HARD = {200.0, NAN};

static double force_of(double tabor, po_creep creep, double speed, po_preload preload) {
  po_scene scene = po_scene_default();
  scene.tabor = tabor;
  const po_creep_terms terms = terms_of(creep);
  po_rate_theory found;
  ck_assert_int_eq(po_persson_brener_pull_off(&scene, &terms, speed, preload, &found), PO_OK);
  return found.force;
}

TEST(both_limits_are_those_of_jkr) {
  const po_creep solid = {PO_CREEP_SLS, 0.2, 1.0};
  ck_assert_double_eq_tol(force_of(5.0, solid, 0.0, HARD), 1.5, 1e-6);
  ck_assert_double_eq_tol(force_of(5.0, solid, 1e-7, HARD), 1.5, 1e-4);
  ck_assert_double_eq_tol(force_of(5.0, solid, INFINITY, HARD), 7.5, 1e-5);
  ck_assert_double_eq_tol(force_of(5.0, solid, 1e6, HARD), 7.5, 1e-3);
  /* k = 1 is elastic at any speed */
  ck_assert_double_eq_tol(force_of(5.0, (po_creep){PO_CREEP_SLS, 1.0, 1.0}, 3.0, HARD), 1.5, 1e-6);
}

/* At once, from a contact that is too narrow, the tension is greatest before the edge moves: 3 ways
 * of the load of JKR at the contact radius a of the preload, with w/k. */
TEST(at_once_a_narrow_contact_holds_less) {
  po_scene scene = po_scene_default();
  scene.tabor = 5.0;
  const double k = 0.1, a = 50.0, c = pow(5.0, 1.5) / sqrt(scene.radius);
  const po_contact relaxed = po_jkr_at(&scene, a);
  const double hertz = 4.0 * a * a * a / (3.0 * M_PI * c * scene.radius * scene.radius);
  const double force = 2.0 * a * sqrt(2.0 * M_PI * a * c / k) / (M_PI * c * scene.radius) - hertz;
  const double found = force_of(5.0, (po_creep){PO_CREEP_SLS, k, 1.0}, INFINITY,
                                (po_preload){relaxed.approach, NAN});
  ck_assert_double_lt(force, 14.9);
  ck_assert_double_eq_tol(found, force, 1e-6 * force);
}

TEST(the_force_rises_with_the_speed) {
  double before = 1.5;
  for (double speed = 1e-4; speed < 1e5; speed *= 10.0) {
    const double force = force_of(5.0, (po_creep){PO_CREEP_GAMMA, 0.1, 0.6}, speed, HARD);
    ck_assert_double_gt(force, before);
    before = force;
  }
}

/* The ordinary differential equation dD/da = V/v by steps in time that resolve it, with the closed
 * form of one time: another method. */
TEST(the_path_is_that_of_the_differential_equation) {
  const double tabor = 3.0, k = 0.3, speed = 2.0, radius = 100.0;
  const double c = pow(tabor, 1.5) / sqrt(radius), s = 16.0 / (9.0 * sqrt(3.0));
  const double length = 8.0 / (M_PI * c * s * s);
  po_scene scene = po_scene_default();
  scene.tabor = tabor;
  double a = 60.0, approach = po_jkr_at(&scene, a).approach, greatest = 0.0;
  const double force =
      force_of(tabor, (po_creep){PO_CREEP_SLS, k, 1.0}, speed, (po_preload){approach, NAN});
  const double step = 2e-5;
  for (int i = 0; i < 4000000 && a > 1.0; ++i) {
    const double pull = a * a / radius - approach, work = pull * pull / (2.0 * M_PI * a * c);
    const double x = (1.0 - 1.0 / work) / (1.0 - k), y = (1.0 - x * x) / (2.0 * x);
    if (work > 1.0 + 1e-14)
      a -= step * (x < 1.0 ? fmin(work / (2.0 * M_PI * y) * length, 1e3) : 1e3);
    approach -= step * speed;
    greatest = fmax(greatest, 2.0 * a * pull / (M_PI * c * radius) -
                                  4.0 * a * a * a / (3.0 * M_PI * c * radius * radius));
  }
  ck_assert_double_eq_tol(force, greatest, 2e-4 * force);
}
