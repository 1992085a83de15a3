/* The JKR theory of any profile against every row of its reference table, and by other routes. */
#include <gsl/gsl_errno.h>

#include "po_abel.h"
#include "po_elementary.h"
#include "po_guduru.h"
#include "po_initial_gap.h"
#include "po_quadrature.h"
#include "profiles.h"

/* The tolerances that the headers state. */
static const double JKR_ACCURACY = 1e-14, PULL_OFF_ACCURACY = 1e-13, QUADRATURE_ACCURACY = 1e-11,
                    INTEGRAL_ACCURACY = 1e-12;

ROWS_TEST(jkr_agrees_with_the_table, "jkr_profiles.csv", "JKR of any profile", 280, 3) {
  const po_scene s = scene_of(t, row);
  const double a = table_number(t, row, "contact_radius");
  const char *kind = table_word(t, row, "kind");
  const bool is_point = strcmp(kind, "point") == 0;
  po_contact got = po_jkr_profile_at(&s, a);
  if (!is_point) {
    const po_fixed fixed = strcmp(kind, "pull_off_load") == 0 ? PO_FIXED_LOAD : PO_FIXED_APPROACH;
    ck_assert_msg(po_jkr_profile_pull_off(&s, fixed, &got) == PO_OK, "%s", po_message());
  }
  const po_contact size = terms_at(&s, a);
  const double accuracy = is_point ? JKR_ACCURACY : PULL_OFF_ACCURACY;
  table_compare(t, row, "load", got.load, accuracy * size.load);
  table_compare(t, row, "approach", got.approach, accuracy * size.approach);
  table_compare(t, row, "contact_radius", got.contact_radius, PULL_OFF_ACCURACY * a);
}

/* An independent route to the transform: g(x) = x times the integral of f'(x sin t) over t from 0
 * to pi/2, and the press is the integral of (x sin t)^2 f'(x sin t), by adaptive quadrature. */
typedef struct {
  const po_scene *scene;
  double x;
  bool press;
} slope_integral;

static double of_slope(double t, void *data) {
  const slope_integral *q = data;
  const double part = po_sin(t), r = q->x * part;
  return po_initial_gap_slope(q->scene, r) * (q->press ? part * part : 1.0);
}

/* Accuracy of each piece, relative. */
static const double PIECE_ACCURACY = 1e-13;

/* The end of the piece of the quadrature that begins at r: a joint of the profile, or half a wave.
 */
static double piece_end(const po_scene *scene, double r, double x) {
  double end = fmin(x, po_profile_next_joint(&scene->profile, r));
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    end = fmin(end, r + 0.5 * po_scene_wave(scene, k).length);
  return end;
}

/* The angle whose sine is r/x. */
static double angle_of(double r, double x) {
  return po_atan2(r, sqrt((x - r) * (x + r)));
}

static po_status integrate(slope_integral *q, double *sum) {
  *sum = 0.0;
  for (double r = 0.0; r < q->x;) {
    const double to = piece_end(q->scene, r, q->x);
    double part;
    if (po_integrate(of_slope, q, angle_of(r, q->x), angle_of(to, q->x), 0.0, PIECE_ACCURACY,
                     &part))
      return po_fail(PO_NOT_CONVERGED, "the quadrature of the slope of the gap failed at radius %g",
                     q->x);
    *sum += part;
    r = to;
  }
  return PO_OK;
}

static po_status abel_by_quadrature(const po_scene *scene, double x, po_abel *abel) {
  slope_integral q = {scene, x, false};
  double g = 0.0, press = 0.0;
  po_status status = integrate(&q, &g);
  q.press = true;
  if (!status)
    status = integrate(&q, &press);
  *abel = (po_abel){x * g, NAN, x * x * press};
  return status;
}

static void compare_with_quadrature(const po_scene *s, double x) {
  po_abel other;
  const po_abel t = po_abel_at(s, x);
  ck_assert_msg(abel_by_quadrature(s, x, &other) == PO_OK, "%s", po_message());
  double swing = fabs(t.g);
  for (size_t k = 0; k < po_scene_waves(s); ++k)
    swing = fmax(swing, po_scene_wave(s, k).amplitude * sqrt(x / po_scene_wave(s, k).length));
  compare("g", s, x, t.g, other.g, QUADRATURE_ACCURACY * swing);
  compare("press", s, x, t.press, other.press, QUADRATURE_ACCURACY * swing * x);
  /* the rate by central differences of the closed form, of the order h^2 but beside a kink */
  const double h = 1e-4 * x;
  const double difference = (po_abel_at(s, x + h).g - po_abel_at(s, x - h).g) / (2.0 * h);
  if (!po_scene_is_wavy(s))
    compare("rate", s, x, t.rate, difference, 1e-5 * fabs(t.rate));
}

TEST(transform_agrees_with_quadrature) {
  static const double RADII[] = {1.1e-3, 0.3, 4.9, 5.1, 13.0, 170.0};
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (int w = 0; w < WAVE_COUNT; ++w)
      for (size_t k = 0; k < sizeof RADII / sizeof *RADII; ++k) {
        const po_scene s = scene_of_words(PROFILES[p], WAVES[w], 0.3);
        compare_with_quadrature(&s, RADII[k]);
      }
}

static double bumps(double r) {
  return r * r / 200.0 + 0.02 * (1.0 - cos(0.4 * r));
}

TEST(transform_of_a_table_agrees_with_quadrature) {
  static const double RADII[] = {0.07, 3.0, 24.9, 39.3, 40.3, 97.0, 3000.0};
  const po_scene tables[] = {scene_of_table(parabola, 21, 40.0, 1.0, 0.3),
                             scene_of_table(bumps, 33, 40.0, 1.0, 0.3)};
  for (int i = 0; i < 2; ++i)
    for (size_t k = 0; k < sizeof RADII / sizeof *RADII; ++k)
      compare_with_quadrature(&tables[i], RADII[k]);
}

/* A spline meets a parabola, and so does the power beyond its end. */
LOOP_TEST(table_of_a_sphere_gives_its_theory, 0, 2) {
  const po_scene s = scene_of_table(parabola, 21, 20.0, _i ? 2.5 : 1.0, 0.3);
  po_scene sphere = scene_of_words("sphere", "-", 0.3);
  if (_i) { /* the numbers in units of 2.5 eps: r^2/200 is then r^2/500 */
    sphere.radius = 250.0;
    sphere.tabor = po_scene_tabor_of_coupling(0.3, sphere.radius);
  }
  po_contact got, expected;
  for (po_fixed fixed = PO_FIXED_LOAD; fixed <= PO_FIXED_APPROACH; ++fixed) {
    ck_assert(po_jkr_profile_pull_off(&s, fixed, &got) == PO_OK);
    ck_assert(po_jkr_profile_pull_off(&sphere, fixed, &expected) == PO_OK);
    compare("load", &s, expected.contact_radius, got.load / sphere.radius, expected.load, 1e-12);
    compare("approach", &s, expected.contact_radius, got.approach, expected.approach, 1e-12);
    compare("contact radius", &s, expected.contact_radius, got.contact_radius,
            expected.contact_radius, 1e-11 * expected.contact_radius);
  }
}

/* The sphere with one wave and with none by the formulas of the paper. */
TEST(jkr_of_the_paper_is_a_case) {
  static const double TABOR[] = {1.1e-3, 0.3, 5.0, 300.0}, LENGTH[] = {3.0, 20.0, 170.0};
  for (int m = 0; m < 4; ++m)
    for (int l = 0; l < 3; ++l)
      for (double amplitude = 0.0; amplitude < 0.2; amplitude += 0.09) {
        const po_scene s = {.tabor = TABOR[m],
                            .radius = 100.0,
                            .amplitude = amplitude * LENGTH[l],
                            .wavelength = LENGTH[l],
                            .outer_radius = INFINITY};
        const po_contact eq_5 = po_guduru_pull_off(&s);
        po_contact got;
        ck_assert_msg(po_jkr_profile_pull_off(&s, PO_FIXED_LOAD, &got) == PO_OK, "%s",
                      po_message());
        compare("pull-off", &s, eq_5.contact_radius, got.load, eq_5.load, -1e-13 * eq_5.load);
        const double a = 1.7 * eq_5.contact_radius;
        const po_contact here = po_jkr_profile_at(&s, a), expected = po_guduru_at(&s, a),
                         size = terms_at(&s, a);
        compare("load", &s, a, here.load, expected.load, 1e-13 * size.load);
        compare("approach", &s, a, here.approach, expected.approach, 1e-13 * size.approach);
        compare("load rate", &s, a, po_jkr_profile_rate(&s, PO_FIXED_LOAD, a),
                po_guduru_rate(&s, PO_FIXED_LOAD, a), 1e-11 * size.load / a);
        compare("approach rate", &s, a, po_jkr_profile_rate(&s, PO_FIXED_APPROACH, a),
                po_guduru_rate(&s, PO_FIXED_APPROACH, a), 1e-11 * size.approach / a);
        const double load = 0.7 * eq_5.load;
        const double last = po_guduru_last_minimum(&s, load, 0.1);
        compare("last minimum", &s, a, po_jkr_profile_last_minimum(&s, load, 0.1), last,
                1e-11 * last);
      }
}

/* C r^n: a_c^(2n-1) = xi^2 pi c/(2 (n kappa C)^2) with xi = 3 at given load and 1 at given
 * approach, the load -(2n-1)/(n+1) sqrt(8 a^3/(pi c))/2, over eighteen decades of the factor and of
 * the coupling. */
TEST(pull_off_of_powers_over_many_decades) {
  for (double n = 1.0; n < 12.0; n *= 1.7)
    for (double factor = 1e-12; factor < 1e7; factor *= 1e3)
      for (double coupling = 1e-9; coupling < 1e10; coupling *= 1e3) {
        po_scene s = po_scene_default();
        ck_assert(po_profile_set(&s.profile, "power"));
        s.profile.parameter[PO_POWER_C] = factor;
        s.profile.parameter[PO_POWER_N] = n;
        s.radius = 1.0;
        s.tabor = po_scene_tabor_of_coupling(coupling, 1.0);
        const double kappa = 0.5 * sqrt(M_PI) * n * tgamma(0.5 * n) / tgamma(0.5 * n + 0.5);
        const double slope = n * kappa * factor;
        po_contact got;
        ck_assert_msg(po_jkr_profile_pull_off(&s, PO_FIXED_LOAD, &got) == PO_OK, "%s",
                      po_message());
        const double a = exp(log(4.5 * M_PI * coupling / (slope * slope)) / (2.0 * n - 1.0));
        compare("contact radius", &s, a, got.contact_radius, a, 1e-12 * a);
        const double load =
            -(2.0 * n - 1.0) / (n + 1.0) * sqrt(2.0 * M_PI / coupling * a * a * a) / M_PI;
        compare("load", &s, a, got.load, load, -1e-11 * load);
        ck_assert(po_jkr_profile_pull_off(&s, PO_FIXED_APPROACH, &got) == PO_OK);
        const double last = exp(log(0.5 * M_PI * coupling / (slope * slope)) / (2.0 * n - 1.0));
        compare("last contact radius", &s, last, got.contact_radius, last, 1e-12 * last);
      }
}

/* dU = W dDelta: the energy by quadrature against that integrated along the curve, by Simpson's
 * rule between near radii. */
TEST(energy_is_the_work_of_the_load) {
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (int w = 0; w < 2; ++w) {
      const po_scene s = scene_of_words(PROFILES[p], WAVES[w], 0.3);
      for (double a = 0.9; a < 20.0; a *= 1.9) {
        const double h = 2e-4 * a;
        double before, after;
        ck_assert(po_jkr_profile_energy(&s, a - h, &before) == PO_OK);
        ck_assert(po_jkr_profile_energy(&s, a + h, &after) == PO_OK);
        double work = 0.0;
        for (int i = -1; i <= 1; ++i) {
          const double x = a + i * h;
          work += (i ? 1.0 : 4.0) * h / 3.0 * po_jkr_profile_at(&s, x).load *
                  po_jkr_profile_rate(&s, PO_FIXED_APPROACH, x);
        }
        const po_contact size = terms_at(&s, a);
        compare("energy", &s, a, after - before, work,
                1e-9 * fabs(work) + INTEGRAL_ACCURACY * size.load * size.approach);
      }
    }
}

/* The gap outside the contact, by the deflection of the half-space: f - D + u, u = (2/pi) times the
 * integral of (D - g)/sqrt(r^2 - x^2) over the contact. For a sphere it is closed. */
TEST(gap_outside_is_that_of_the_sphere) {
  const po_scene s = scene_of_words("sphere", "-", 0.3);
  const double a = 9.0, R = s.radius, D = po_jkr_profile_at(&s, a).approach;
  for (double r = 1.0001 * a; r < 5.0 * a; r *= 1.2) {
    const double angle = asin(a / r);
    const double u =
        M_2_PI * (D * angle - (0.5 * r * r * angle - 0.5 * a * sqrt(r * r - a * a)) / R);
    compare("gap", &s, r, po_abel_gap(&s, a, D, r), 0.5 * r * r / R - D + u,
            1e-13 * (1.0 + fabs(D)));
  }
}

static double less_than(double x, po_abel t, const void *data) {
  (void)x;
  return t.g - *(const double *)data;
}

/* With the order of both integrals changed it is the integral of the transform, for rings that span
 * from half a row to all rows, and go beyond them, with waves and without. */
TEST(opening_of_a_table_is_the_integral_of_its_transform) {
  for (int w = 0; w < 2; ++w) {
    po_scene s = scene_of_table(bumps, 33, 40.0, 1.0, 0.3);
    if (w)
      ck_assert(po_scene_set_waves(&s, "0.4@9"));
    for (double a = 0.31; a < 60.0; a *= 1.37)
      for (double c = a + 0.4; c < 90.0; c += 0.37 * c) {
        const double approach = po_abel_at(&s, a).g;
        const double by_transform = po_abel_integral(&s, a, c, true, less_than, &approach);
        compare("opening", &s, c, po_abel_opening(&s, a, approach, c), by_transform,
                3e-13 * (fabs(by_transform) + fabs(approach) + po_initial_gap(&s, c)));
      }
  }
}

TEST(overlap_outside_is_found) {
  double gap, radius;
  po_contact c;
  const po_scene smooth = scene_of_words("sphere", "-", 0.3);
  ck_assert(po_jkr_profile_check(&smooth, 9.0, &gap, &radius) == PO_OK);
  ck_assert_double_eq(gap, 0.0);
  /* deep waves on a stiff sphere: a contact of one crest passes through the next ring */
  const po_scene deep = scene_of_words("sphere", "3@10", 1e-3);
  ck_assert(po_jkr_profile_check(&deep, 7.0, &gap, &radius) == PO_OK);
  c = po_jkr_profile_at(&deep, 7.0);
  ck_assert_double_lt(gap, 0.0);
  ck_assert_double_gt(radius, 7.0);
  compare("gap", &deep, radius, gap, po_abel_gap(&deep, 7.0, c.approach, radius), 1e-12);
}

/* The minima that the searches find are those of a dense scan: the lowest, and for the load at each
 * of them the last one that is not above it. */
TEST(minima_are_those_of_a_scan) {
  const po_scene s = scene_of_words("sphere", "0.4@10;0.1@3", 0.05);
  po_contact found[64], least;
  size_t count = 0, deepest = 0;
  double before = po_jkr_profile_rate(&s, PO_FIXED_LOAD, 1e-3);
  for (double a = 1e-3; a < 200.0; a += 1e-3) {
    const double rate = po_jkr_profile_rate(&s, PO_FIXED_LOAD, a);
    if (before < 0.0 && rate >= 0.0 && po_jkr_profile_at(&s, a).load < 0.0) {
      ck_assert_uint_lt(count, 64);
      found[count] = po_jkr_profile_at(&s, a);
      deepest = found[count].load < found[deepest].load ? count : deepest;
      ++count;
    }
    before = rate;
  }
  ck_assert_uint_gt(count, 3);
  for (size_t k = 0; k < count; ++k) {
    size_t last = k;
    for (size_t j = k; j < count; ++j)
      last = found[j].load <= found[k].load ? j : last;
    compare("contact radius", &s, found[k].load,
            po_jkr_profile_last_minimum(&s, found[k].load, 0.0), found[last].contact_radius, 2e-3);
  }
  ck_assert(po_jkr_profile_pull_off(&s, PO_FIXED_LOAD, &least) == PO_OK);
  compare("contact radius", &s, least.load, least.contact_radius, found[deepest].contact_radius,
          2e-3);
  ck_assert_double_le(least.load, found[deepest].load);
}

TEST(unusable_profiles_are_refused) {
  po_contact c;
  po_scene s = scene_of_words("cone:0.3", "-", 0.05);
  s.tabor = 0.0;
  ck_assert(po_jkr_profile_pull_off(&s, PO_FIXED_LOAD, &c) == PO_BAD_INPUT);
  ck_assert(isnan(po_jkr_profile_last_minimum(&s, -1.0, 0.1)));
}

/* The search for the last minimum began at the radius 0 and did not end. */
TEST(a_sphere_beyond_the_range_of_numbers_is_refused) {
  po_scene scene = po_scene_default();
  scene.tabor = 7.3e-102;
  scene.radius = 2.5e-300;
  po_contact least;
  ck_assert_int_eq(po_jkr_profile_pull_off(&scene, PO_FIXED_LOAD, &least), PO_BAD_INPUT);
}

static void silence_gsl(void) {
  gsl_set_error_handler_off();
}
FIXTURE(silence_gsl, NULL)
