/* The closed forms: limits, energy, inverses, and a comparison of each form with an independent
 * computation. */
#include <gsl/gsl_errno.h>
#include <math.h>

#include "po_estimates.h"
#include "po_guduru.h"
#include "po_law.h"
#include "po_special.h"
#include "po_wavy_rigid.h"
#include "run.h"

/* tabor, amplitude, wavelength, radius */
static const po_scene SCENES[] = {{5.0, 10.0, 20.0, 100.0, INFINITY},
                                  {2.385, 0.7, 13.1, 77.0, INFINITY},
                                  {3.3, 1e-3, 5.7, 210.0, INFINITY},
                                  {0.41, 2.9, 31.0, 53.0, INFINITY},
                                  {7.7, 0.03, 400.0, 91.0, INFINITY}};
enum { SCENE_COUNT = sizeof SCENES / sizeof *SCENES };

LOOP_TEST(jkr_agrees_with_known_values, 0, SCENE_COUNT) {
  const po_scene *s = &SCENES[_i];
  const po_contact load = po_jkr_pull_off(s), last = po_jkr_last(s);
  ck_assert_double_eq_tol(load.load, -1.5, 1e-14);
  ck_assert_double_eq_tol(load.approach / s->tabor, -0.77341693157, 1e-11);
  ck_assert_double_eq_tol(last.load, -5.0 / 6.0, 1e-14);
  ck_assert_double_eq_tol(last.approach / s->tabor, -1.60877204783, 1e-11);
}

/* In the form of the paper, with H2, alpha and beta. */
LOOP_TEST(guduru_is_eq_5, 0, SCENE_COUNT) {
  const po_scene *s = &SCENES[_i];
  const double alpha = po_scene_alpha(s);
  const double beta = pow(s->wavelength, 3.0) / (2.0 * M_PI * pow(s->radius * s->tabor, 1.5));
  for (double a = 0.013; a < 9.0; a *= 1.7) {
    const double x = 2.0 * M_PI * a, h1 = po_struve(1, x);
    const double h2 = 2.0 * h1 / x + 2.0 / (3.0 * M_PI) * x - po_struve(0, x);
    const double waves =
        4.0 * M_PI * M_PI * a * a * a / 3.0 + M_PI_2 * a * h1 - M_PI * M_PI * a * a * h2;
    const double hertz = 2.0 * a * a * a / 3.0, stick = 4.0 * sqrt(beta * a * a * a);
    const double load = 4.0 * beta * (hertz + alpha * waves) - stick;
    const double approach = (a * a + alpha * M_PI * M_PI * a * po_struve(0, x) - sqrt(a / beta)) *
                            s->wavelength * s->wavelength / s->radius;
    const po_contact got = po_guduru_at(s, a * s->wavelength);
    const double size = 4.0 * beta * (hertz + alpha * 14.0 * a * a * a) + stick;
    ck_assert_double_eq_tol(got.load, load, 2e-14 * size);
    ck_assert_double_eq_tol(got.approach, approach, 1e-13 * (fabs(approach) + s->amplitude * a));
  }
}

LOOP_TEST(guduru_load_rate_agrees_with_finite_differences, 0, SCENE_COUNT) {
  const po_scene *s = &SCENES[_i];
  for (double a = 0.1 * s->wavelength; a < 6.0 * s->wavelength; a *= 1.6) {
    const double h = 1e-4 * fmin(a, s->wavelength);
    const double slope = (po_guduru_at(s, a + h).load - po_guduru_at(s, a - h).load) / (2.0 * h);
    const double size = fabs(po_guduru_at(s, a).load) / a + fabs(slope);
    ck_assert_double_eq_tol(po_guduru_rate(s, PO_FIXED_LOAD, a), slope, 1e-5 * (size + 1e-3));
  }
}

LOOP_TEST(guduru_tends_to_jkr_for_small_amplitudes, 0, SCENE_COUNT) {
  po_scene s = SCENES[_i];
  s.amplitude = 1e-11;
  const po_contact wavy = po_guduru_pull_off(&s), smooth = po_jkr_pull_off(&s);
  ck_assert_double_eq_tol(wavy.load, smooth.load, 1e-8);
  const double a = 0.7 * s.wavelength;
  ck_assert_double_eq_tol(po_guduru_at(&s, a).approach, po_jkr_at(&s, a).approach, 1e-9);
}

/* Amplitude 0, with or without a wavelength, gives the JKR values exactly. */
LOOP_TEST(amplitude_zero_is_jkr, 0, SCENE_COUNT) {
  po_scene s = SCENES[_i];
  s.amplitude = 0.0;
  for (int k = 0; k < 2; ++k, s.wavelength = 0.0) {
    const po_contact jkr = po_jkr_pull_off(&s), guduru = po_guduru_pull_off(&s);
    ck_assert_double_eq(guduru.load, jkr.load);
    ck_assert_double_eq(guduru.contact_radius, jkr.contact_radius);
    ck_assert(isinf(po_johnson_parameter(&s)));
    ck_assert_double_eq(po_kesari_lew_work(&s), 1.0);
    ck_assert_double_eq(po_persson_tosatti_of(&s).work, 1.0);
    ck_assert_double_eq(po_persson_tosatti_of(&s).work_with_area, 1.0);
    ck_assert_double_eq(po_compactness_of(&s).critical_radius, 0.0);
    ck_assert_double_eq_tol(po_crest_of(&s).composite_radius, s.radius, 1e-15 * s.radius);
    for (double a = 0.37; a < 100.0; a *= 2.385) {
      const po_contact exact = po_jkr_at(&s, a), wavy = po_guduru_at(&s, a);
      const double size = 1e-14 * (1.0 + fabs(exact.load));
      ck_assert_double_eq_tol(wavy.load, exact.load, size);
      for (int side = -1; side <= 1; side += 2) {
        const po_contact edge = po_kesari_lew_edge(&s, a, side);
        ck_assert_double_eq_tol(edge.load, exact.load, size);
        ck_assert_double_eq_tol(edge.approach, exact.approach, 1e-14 * (a * a + a));
      }
    }
  }
}

LOOP_TEST(pull_off_is_the_global_minimum, 0, SCENE_COUNT) { /* no load on a dense grid is lower */
  const po_scene *s = &SCENES[_i];
  const po_contact best = po_guduru_pull_off(s);
  double least = INFINITY;
  const double end = 4.0 * best.contact_radius + 3.0 * s->wavelength;
  for (int i = 1; i <= 200000; ++i)
    least = fmin(least, po_guduru_at(s, end * i / 200000.0).load);
  ck_assert_double_ge(least, best.load - 1e-12 * fabs(best.load));
  ck_assert_double_eq_tol(least, best.load, 1e-3 * fabs(best.load));
}

TEST(guduru_pull_off_at_a_known_scene) {
  ck_assert_double_eq_tol(-po_guduru_pull_off(&SCENES[0]).load, 19.9243, 1e-4);
}

/* With many short waves the load is between the two envelopes and touches both. */
TEST(envelope_encloses_eq_5) {
  const po_scene s = {3.1, 0.02, 0.9, 770.0, INFINITY};
  const double middle = 60.0;
  double low = INFINITY, high = INFINITY;
  for (double a = middle; a < middle + 4.0 * s.wavelength; a += 0.003) {
    const double load = po_guduru_at(&s, a).load;
    low = fmin(low, load - po_kesari_lew_edge(&s, a, -1).load);
    high = fmin(high, po_kesari_lew_edge(&s, a, 1).load - load);
  }
  ck_assert_double_eq_tol(low, 0.0, 2e-4);
  ck_assert_double_eq_tol(high, 0.0, 2e-4);
  const double force = -po_guduru_pull_off(&s).load;
  ck_assert_double_eq_tol(force / (1.5 * po_kesari_lew_work(&s)), 1.0, 1e-3);
}

/* Eq 22 by a fine midpoint sum in theta. Beyond 400 waves the gap is replaced by its mean. */
static double eq_22(double amplitude, double alpha, double approach) {
  const double step = 4e-4 * M_PI, end = 800.0 * M_PI, c = amplitude / (8.0 * M_PI * M_PI * alpha);
  const double x0 = 1.0 / (1.0 - approach);
  double sum = -step * step / 24.0 * (pow(x0, 3.0) - pow(x0, 9.0));
  for (double theta = 0.5 * step; theta < end; theta += step) {
    const double y = 1.0 - approach + c * theta * theta + amplitude * (1.0 - cos(theta));
    const double v3 = 1.0 / (y * y * y);
    sum += (v3 - v3 * v3 * v3) * theta * step;
  }
  sum += pow(c * end * end + amplitude + 1.0 - approach, -2.0) / (4.0 * c);
  return -32.0 / 3.0 * c * sum;
}

/* amplitude, alpha, approach */
static const double RIGID[][3] = {{1.0, 0.25, 0.2}, {0.7, 2.385, 0.31}, {5.0, 0.03, -0.4},
                                  {40.0, 1.1, 0.1}, {1.0, 0.25, -1.3},  {0.31, 0.0997, 0.12}};
enum { RIGID_COUNT = sizeof RIGID / sizeof *RIGID };

LOOP_TEST(rigid_wavy_sphere_is_eq_22, 0, RIGID_COUNT) {
  const double A = RIGID[_i][0], alpha = RIGID[_i][1], approach = RIGID[_i][2];
  ck_assert_double_eq_tol(po_wavy_rigid_load(A, alpha, approach), eq_22(A, alpha, approach), 2e-9);
  const double h = 1e-4, slope = (po_wavy_rigid_load(A, alpha, approach + h) -
                                  po_wavy_rigid_load(A, alpha, approach - h)) /
                                 (2.0 * h);
  ck_assert_double_eq_tol(po_wavy_rigid_rate(A, alpha, approach), slope,
                          1e-5 * fmax(1.0, fabs(slope)));
}

TEST(rigid_wavy_sphere_tends_to_bradley) {
  for (double approach = -3.1; approach < 0.5; approach += 0.7) {
    const double exact = po_bradley_load(approach);
    ck_assert_double_eq_tol(po_wavy_rigid_load(2.385, 1e-12, approach), exact,
                            1e-9 * fmax(1.0, fabs(exact)));
    ck_assert_double_eq_tol(po_wavy_rigid_load(1e-12, 2.385, approach), exact,
                            1e-9 * fmax(1.0, fabs(exact)));
  }
}

TEST(rigid_pull_off_is_within_its_limits) {
  ck_assert_double_eq_tol(po_wavy_rigid_pull_off(1.0, 0.25).force, 0.7410559, 1e-7);
  ck_assert_double_eq_tol(po_wavy_rigid_pull_off(1.0, 1e-4).force, 1.992148, 1e-6);
  for (double A = 1e-3; A < 2e4; A *= 100.0)
    for (double alpha = 1e-4; alpha < 2e3; alpha *= 100.0) {
      const po_rigid_pull_off p = po_wavy_rigid_pull_off(A, alpha);
      ck_assert_double_gt(p.force, 0.0);
      ck_assert_double_lt(p.force,
                          2.001); /* 2.00008 at A = 1e-3, alpha = 0.01, confirmed by quadrature */
      /* if one crest carries the load: Bradley's force for the crest (Eqs 18 and 19) */
      if (A >= 1e3 && alpha <= 0.1)
        ck_assert_double_eq_tol(p.force * 0.5 * (1.0 + 4.0 * M_PI * M_PI * alpha), 1.0, 1e-2);
    }
}

LOOP_TEST(estimates_agree_with_their_formulas, 0, SCENE_COUNT) {
  const po_scene *s = &SCENES[_i];
  const double johnson = po_johnson_parameter(s), alpha = po_scene_alpha(s);
  const double beta = pow(s->wavelength, 3.0) / (2.0 * M_PI * pow(s->radius * s->tabor, 1.5));
  ck_assert_double_eq_tol(M_PI * alpha * sqrt(beta) * sqrt(M_PI) * johnson, 1.0, 1e-14);
  const double bound = po_compactness_of(s).bound;
  ck_assert_double_eq_tol(bound, 8.57604, 1e-6);
  ck_assert_double_eq_tol(po_persson_tosatti_of(s).work,
                          1.0 - 1.0 / (2.0 * M_PI * johnson * johnson),
                          1e-14 / (johnson * johnson));
  ck_assert_double_eq_tol(po_crest_of(s).composite_radius / s->radius, po_crest_of(s).force / 2.0,
                          1e-15);
  ck_assert_double_eq(po_rumpf_rabinowicz_ratio(0.0, s->radius), 1.0);
  const double h = po_lennard_jones_greatest().distance;
  const po_law law = po_law_lennard_jones();
  ck_assert_double_eq_tol(-po_law_at(&law, h - 1.0).traction, po_lennard_jones_greatest().tension,
                          1e-15);
}

/* The JKR sphere has one minimum, of load -3/2. */
TEST(last_minimum_of_a_smooth_sphere) {
  const po_scene scene = {2.385, 0.0, 0.0, 83.0, INFINITY};
  const double last = po_guduru_last_minimum(&scene, -1.4, 0.0);
  ck_assert_double_eq_tol(po_guduru_at(&scene, last).load, -1.5, 1e-13);
  ck_assert_double_eq(po_guduru_last_minimum(&scene, -1.6, 0.0), 0.0);
}

TEST(outside_the_domain_the_result_is_nan) {
  const po_scene rigid = {0.0, 1.0, 20.0, 100.0, INFINITY};
  ck_assert(isnan(po_guduru_pull_off(&rigid).load));
  ck_assert(isnan(po_jkr_at(&rigid, 1.0).load));
  ck_assert(isnan(po_guduru_at(&SCENES[0], -1.0).load));
  ck_assert(isnan(po_wavy_rigid_load(1.0, 1.0, 1.0)));
  ck_assert(isnan(po_wavy_rigid_pull_off(-1.0, 1.0).force));
  ck_assert(isnan(po_rumpf_rabinowicz_ratio(NAN, 1.0)));
}

/* Spheres with few waves in the contact, with 2e4 and with 5e9; the search looked at every one. */
static const po_scene OF_MANY_WAVES[] = {{2.385, 0.7, 13.1, 77.0, INFINITY},
                                         {3.0, 1e-3, 2e-3, 100.0, INFINITY},
                                         {1e-6, 1e5, 0.01, 1e5, INFINITY}};
enum { MANY_COUNT = sizeof OF_MANY_WAVES / sizeof *OF_MANY_WAVES };

LOOP_TEST(no_minimum_is_beyond_the_last, 0, MANY_COUNT) {
  const po_scene *s = &OF_MANY_WAVES[_i];
  const double wave = s->wavelength, load = 0.9 * po_guduru_pull_off(s).load;
  const double last = po_guduru_last_minimum(s, load, 0.0);
  ck_assert_double_gt(last, 0.0);
  if (last > 1e8 * wave) { /* only the envelope is resolved */
    double inside = 0.0, outside = 0.0;
    for (int k = 1; k < 1000; ++k) {
      inside = fmin(inside, po_guduru_at(s, last * (1.0 - 1.37e-7 * k)).load);
      outside = fmin(outside, po_guduru_at(s, last * (1.0 + 1.37e-7 * k)).load);
    }
    ck_assert_double_ge(outside, load * (1.0 + 1e-9));
    ck_assert_double_le(inside, load * (1.0 - 1e-3));
    return;
  }
  ck_assert_double_le(po_guduru_at(s, last).load, load);
  ck_assert_double_lt(po_guduru_rate(s, PO_FIXED_LOAD, last - 1e-4 * wave), 0.0);
  ck_assert_double_gt(po_guduru_rate(s, PO_FIXED_LOAD, last + 1e-4 * wave), 0.0);
  for (double a = last + 0.5 * wave; a < last + 40.0 * wave; a += wave / 64.0)
    ck_assert(po_guduru_rate(s, PO_FIXED_LOAD, a) > 0.0 ||
              po_guduru_rate(s, PO_FIXED_LOAD, a + wave / 64.0) < 0.0 ||
              po_guduru_at(s, a + wave / 128.0).load > load);
}

static void silence_gsl(void) {
  gsl_set_error_handler_off();
}
FIXTURE(silence_gsl, NULL)
