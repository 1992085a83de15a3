/* The JKR theory of any profile against every row of its reference table, and by other routes. */
#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <unistd.h>

#include "../unit/run.h"
#include "po_abel.h"
#include "po_abel_integral.h"
#include "po_elementary.h"
#include "po_guduru.h"
#include "po_initial_gap.h"
#include "po_integral.h"
#include "po_jkr_profile.h"
#include "po_maugis.h"
#include "po_rigid_profile.h"
#include "po_wavy_rigid.h"
#include "table.h"

/* The tolerances that the headers state. */
static const double JKR_ACCURACY = 1e-14, PULL_OFF_ACCURACY = 1e-13, QUADRATURE_ACCURACY = 1e-11,
                    INTEGRAL_ACCURACY = 1e-12, MAUGIS_ACCURACY = 1e-14, RIGID_ACCURACY = 1e-13,
                    RIGID_QUADRATURE = 1e-9;

/* The scene of a row: `radius` is - where the unit of the load is pi w eps. */
static po_scene scene_of(const table *t, size_t row) {
  po_scene s = po_scene_default();
  s.radius = strcmp(table_word(t, row, "radius"), "-") == 0 ? 1.0 : table_number(t, row, "radius");
  s.tabor = po_scene_tabor_of_coupling(table_number(t, row, "coupling"), s.radius);
  ck_assert(po_profile_set(&s.profile, table_word(t, row, "profile")));
  ck_assert(po_scene_set_waves(&s, table_word(t, row, "waves")));
  ck_assert_msg(po_scene_check(&s) == PO_OK, "%s", po_message());
  return s;
}

/* The adhesive part of load and approach, which is no smaller than the half of the elastic part
 * near pull-off. Rounding errors are relative to the largest term. */
static po_contact terms_at(const po_scene *s, double a) {
  const double c = po_scene_coupling(s);
  const po_contact at = po_jkr_profile_at(s, a);
  return (po_contact){.load = fabs(at.load) + sqrt(8.0 * a * a * a / (M_PI * c)) / s->radius,
                      .approach = fabs(at.approach) + sqrt(2.0 * M_PI * a * c)};
}

START_TEST(jkr_agrees_with_the_table) {
  table t = table_open("jkr_profiles.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    const po_scene s = scene_of(&t, row);
    const double a = table_number(&t, row, "contact_radius");
    const char *kind = table_word(&t, row, "kind");
    const bool is_point = strcmp(kind, "point") == 0;
    po_contact got = po_jkr_profile_at(&s, a);
    if (!is_point) {
      const po_given given = strcmp(kind, "pull_off_load") == 0 ? PO_GIVEN_LOAD : PO_GIVEN_APPROACH;
      ck_assert_msg(po_jkr_profile_pull_off(&s, given, &got) == PO_OK, "%s", po_message());
    }
    const po_contact size = terms_at(&s, a);
    const double accuracy = is_point ? JKR_ACCURACY : PULL_OFF_ACCURACY;
    table_compare(&t, row, "load", got.load, accuracy * size.load);
    table_compare(&t, row, "approach", got.approach, accuracy * size.approach);
    table_compare(&t, row, "contact_radius", got.contact_radius, PULL_OFF_ACCURACY * a);
  }
  table_close(&t, "JKR of any profile", 203, 3);
}
END_TEST

/* Every profile, with and without waves. */
static const char *const PROFILES[] = {"sphere",         "cone:0.3",   "power:0.05,1.5",
                                       "power:1e-9,7.3", "punch:5,20", "punch:1e-3,1e6",
                                       "truncated:5,20"};
static const char *const WAVES[] = {"-", "0.4@10;0.1@3", "1e-4@0.7"};
enum {
  PROFILE_COUNT = sizeof PROFILES / sizeof *PROFILES,
  WAVE_COUNT = sizeof WAVES / sizeof *WAVES
};

static po_scene scene_of_words(const char *profile, const char *waves, double coupling) {
  po_scene s = po_scene_default();
  ck_assert(po_profile_set(&s.profile, profile));
  if (!po_profile_is_sphere(&s.profile))
    s.radius = 1.0;
  s.tabor = po_scene_tabor_of_coupling(coupling, s.radius);
  ck_assert(po_scene_set_waves(&s, waves));
  return s;
}

static void compare(const char *what, const po_scene *s, double a, double got, double expected,
                    double tolerance) {
  ck_assert_msg(fabs(got - expected) <= tolerance,
                "%s of %s at %g: %.17g, expected %.17g: off by %.2e, expected %.2e", what,
                po_profile_name(&s->profile), a, got, expected, fabs(got - expected), tolerance);
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

/* The end of the piece of the quadrature that begins at r: a joint of the profile, half a wave.
 */
static double piece_end(const po_scene *scene, double r, double x) {
  double end = fmin(x, po_profile_next_joint(&scene->profile, r));
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    end = fmin(end, r + 0.5 * po_scene_wave(scene, k).length);
  return end;
}

/* The angle whose sine is r/x */
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

START_TEST(transform_agrees_with_quadrature) {
  static const double RADII[] = {1.1e-3, 0.3, 4.9, 5.1, 13.0, 170.0};
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (int w = 0; w < WAVE_COUNT; ++w)
      for (size_t k = 0; k < sizeof RADII / sizeof *RADII; ++k) {
        const po_scene s = scene_of_words(PROFILES[p], WAVES[w], 0.3);
        compare_with_quadrature(&s, RADII[k]);
      }
}
END_TEST

/* Writes the rows of a profile to a table, and reads it. Given: the unit of the table, eps. */
static po_scene scene_of_table(double (*gap)(double r), int rows, double end, double unit,
                               double coupling) {
  char path[] = "/tmp/po_profile_XXXXXX";
  const int file = mkstemp(path);
  ck_assert_int_ge(file, 0);
  FILE *f = fdopen(file, "w");
  ck_assert_ptr_nonnull(f);
  fprintf(f, "r,gap\n");
  for (int k = 0; k < rows; ++k) {
    const double r = end * k / (rows - 1);
    fprintf(f, "%.17g,%.17g\n", r, gap(r));
  }
  ck_assert_int_eq(fclose(f), 0);
  po_scene s = scene_of_words("sphere", "-", coupling);
  s.radius = 1.0;
  s.tabor = po_scene_tabor_of_coupling(coupling, 1.0);
  po_profile_set_parameter(&s.profile, PO_TABLE_SCALE, unit);
  const po_status status = po_profile_set_file(&s.profile, path);
  ck_assert_msg(status == PO_OK, "%s", po_message());
  ck_assert_int_eq(unlink(path), 0);
  return s;
}

static double parabola(double r) {
  return r * r / 200.0;
}

static double bumps(double r) {
  return r * r / 200.0 + 0.02 * (1.0 - cos(0.4 * r));
}

START_TEST(transform_of_a_table_agrees_with_quadrature) {
  static const double RADII[] = {0.07, 3.0, 24.9, 39.3, 40.3, 97.0, 3000.0};
  const po_scene tables[] = {scene_of_table(parabola, 21, 40.0, 1.0, 0.3),
                             scene_of_table(bumps, 33, 40.0, 1.0, 0.3)};
  for (int i = 0; i < 2; ++i)
    for (size_t k = 0; k < sizeof RADII / sizeof *RADII; ++k)
      compare_with_quadrature(&tables[i], RADII[k]);
}
END_TEST

/* A spline meets a parabola, and so does the power beyond its end. */
START_TEST(table_of_a_sphere_gives_its_theory) {
  const po_scene s = scene_of_table(parabola, 21, 20.0, _i ? 2.5 : 1.0, 0.3);
  po_scene sphere = scene_of_words("sphere", "-", 0.3);
  if (_i) { /* the numbers in units of 2.5 eps: r^2/200 is then r^2/500 */
    sphere.radius = 250.0;
    sphere.tabor = po_scene_tabor_of_coupling(0.3, sphere.radius);
  }
  po_contact got, expected;
  for (po_given given = PO_GIVEN_LOAD; given <= PO_GIVEN_APPROACH; ++given) {
    ck_assert(po_jkr_profile_pull_off(&s, given, &got) == PO_OK);
    ck_assert(po_jkr_profile_pull_off(&sphere, given, &expected) == PO_OK);
    compare("load", &s, expected.contact_radius, got.load / sphere.radius, expected.load, 1e-12);
    compare("approach", &s, expected.contact_radius, got.approach, expected.approach, 1e-12);
    compare("contact radius", &s, expected.contact_radius, got.contact_radius,
            expected.contact_radius, 1e-11 * expected.contact_radius);
  }
}
END_TEST

/* The sphere with one wave and with none by the formulas of the paper. */
START_TEST(jkr_of_the_paper_is_a_case) {
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
        ck_assert_msg(po_jkr_profile_pull_off(&s, PO_GIVEN_LOAD, &got) == PO_OK, "%s",
                      po_message());
        compare("pull-off", &s, eq_5.contact_radius, got.load, eq_5.load, -1e-13 * eq_5.load);
        const double a = 1.7 * eq_5.contact_radius;
        const po_contact here = po_jkr_profile_at(&s, a), expected = po_guduru_at(&s, a),
                         size = terms_at(&s, a);
        compare("load", &s, a, here.load, expected.load, 1e-13 * size.load);
        compare("approach", &s, a, here.approach, expected.approach, 1e-13 * size.approach);
        compare("load rate", &s, a, po_jkr_profile_rate(&s, PO_GIVEN_LOAD, a),
                po_guduru_load_rate(&s, a), 1e-11 * size.load / a);
        compare("approach rate", &s, a, po_jkr_profile_rate(&s, PO_GIVEN_APPROACH, a),
                po_guduru_approach_rate(&s, a), 1e-11 * size.approach / a);
        const double load = 0.7 * eq_5.load;
        const double last = po_guduru_last_minimum(&s, load, 0.1);
        compare("last minimum", &s, a, po_jkr_profile_last_minimum(&s, load, 0.1), last,
                1e-11 * last);
      }
}
END_TEST

/* C r^n: a_c^(2n-1) = xi^2 pi c/(2 (n kappa C)^2) with xi = 3 at given load and 1 at given
 * approach, the load -(2n-1)/(n+1) sqrt(8 a^3/(pi c))/2, over eighteen decades of the factor and of
 * the coupling. */
START_TEST(pull_off_of_powers_over_many_decades) {
  for (double n = 1.0; n < 12.0; n *= 1.7)
    for (double factor = 1e-12; factor < 1e7; factor *= 1e3)
      for (double coupling = 1e-9; coupling < 1e10; coupling *= 1e3) {
        po_scene s = po_scene_default();
        ck_assert(po_profile_set(&s.profile, "power"));
        po_profile_set_parameter(&s.profile, PO_POWER_C, factor);
        po_profile_set_parameter(&s.profile, PO_POWER_N, n);
        s.radius = 1.0;
        s.tabor = po_scene_tabor_of_coupling(coupling, 1.0);
        const double kappa = 0.5 * sqrt(M_PI) * n * tgamma(0.5 * n) / tgamma(0.5 * n + 0.5);
        const double slope = n * kappa * factor;
        po_contact got;
        ck_assert_msg(po_jkr_profile_pull_off(&s, PO_GIVEN_LOAD, &got) == PO_OK, "%s",
                      po_message());
        const double a = exp(log(4.5 * M_PI * coupling / (slope * slope)) / (2.0 * n - 1.0));
        compare("contact radius", &s, a, got.contact_radius, a, 1e-12 * a);
        const double load =
            -(2.0 * n - 1.0) / (n + 1.0) * sqrt(2.0 * M_PI / coupling * a * a * a) / M_PI;
        compare("load", &s, a, got.load, load, -1e-11 * load);
        ck_assert(po_jkr_profile_pull_off(&s, PO_GIVEN_APPROACH, &got) == PO_OK);
        const double last = exp(log(0.5 * M_PI * coupling / (slope * slope)) / (2.0 * n - 1.0));
        compare("last contact radius", &s, last, got.contact_radius, last, 1e-12 * last);
      }
}
END_TEST

/* dU = W dDelta: the energy by quadrature against that integrated along the curve, by Simpson's
 * rule between near radii. */
START_TEST(energy_is_the_work_of_the_load) {
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
                  po_jkr_profile_rate(&s, PO_GIVEN_APPROACH, x);
        }
        const po_contact size = terms_at(&s, a);
        compare("energy", &s, a, after - before, work,
                1e-9 * fabs(work) + INTEGRAL_ACCURACY * size.load * size.approach);
      }
    }
}
END_TEST

/* The gap outside the contact, by the deflection of the half-space: f - D + u, u = (2/pi) times the
 * integral of (D - g)/sqrt(r^2 - x^2) over the contact. For a sphere it is closed. */
START_TEST(gap_outside_is_that_of_the_sphere) {
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
END_TEST

START_TEST(overlap_outside_is_found) {
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
END_TEST

/* The minima that the searches find are those of a dense scan: the lowest, and for the load at each
 * of them the last one that is not above it. */
START_TEST(minima_are_those_of_a_scan) {
  const po_scene s = scene_of_words("sphere", "0.4@10;0.1@3", 0.05);
  po_contact found[64], least;
  size_t count = 0, deepest = 0;
  double before = po_jkr_profile_rate(&s, PO_GIVEN_LOAD, 1e-3);
  for (double a = 1e-3; a < 200.0; a += 1e-3) {
    const double rate = po_jkr_profile_rate(&s, PO_GIVEN_LOAD, a);
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
  ck_assert(po_jkr_profile_pull_off(&s, PO_GIVEN_LOAD, &least) == PO_OK);
  compare("contact radius", &s, least.load, least.contact_radius, found[deepest].contact_radius,
          2e-3);
  ck_assert_double_le(least.load, found[deepest].load);
}
END_TEST

START_TEST(unusable_profiles_are_refused) {
  po_contact c;
  po_scene s = scene_of_words("cone:0.3", "-", 0.05);
  s.tabor = 0.0;
  ck_assert(po_jkr_profile_pull_off(&s, PO_GIVEN_LOAD, &c) == PO_BAD_INPUT);
  ck_assert(isnan(po_jkr_profile_last_minimum(&s, -1.0, 0.1)));
}
END_TEST

/* The search for the last minimum began at the radius 0 and did not end. */
START_TEST(a_sphere_beyond_the_range_of_numbers_is_refused) {
  po_scene scene = po_scene_default();
  scene.tabor = 7.3e-102;
  scene.radius = 2.5e-300;
  po_contact least;
  ck_assert_int_eq(po_jkr_profile_pull_off(&scene, PO_GIVEN_LOAD, &least), PO_BAD_INPUT);
}
END_TEST

START_TEST(maugis_agrees_with_the_table) {
  table t = table_open("maugis_profiles.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    const po_scene s = scene_of(&t, row);
    const double tension = table_number(&t, row, "tension"),
                 a = table_number(&t, row, "contact_radius");
    po_maugis got;
    ck_assert_msg(po_maugis_at(&s, tension, a, &got) == PO_OK, "%s", po_message());
    const po_contact size = terms_at(&s, a);
    table_compare(&t, row, "load", got.contact.load, MAUGIS_ACCURACY * size.load);
    table_compare(&t, row, "approach", got.contact.approach, MAUGIS_ACCURACY * size.approach);
    table_compare(&t, row, "end_of_tension", got.end, MAUGIS_ACCURACY * got.end);
    /* the rates by central differences */
    po_maugis before, after;
    const double h = 1e-4 * a;
    ck_assert(po_maugis_at(&s, tension, a - h, &before) == PO_OK);
    ck_assert(po_maugis_at(&s, tension, a + h, &after) == PO_OK);
    compare("load rate", &s, a, po_maugis_rate(&s, tension, PO_GIVEN_LOAD, &got),
            (after.contact.load - before.contact.load) / (2.0 * h), 1e-5 * size.load / a);
    compare("approach rate", &s, a, po_maugis_rate(&s, tension, PO_GIVEN_APPROACH, &got),
            (after.contact.approach - before.contact.approach) / (2.0 * h),
            1e-5 * size.approach / a);
  }
  table_close(&t, "Maugis-Dugdale", 42, 3);
}
END_TEST

/* The sphere at given load, pi w R, over lambda = 2 q (R/(pi w K^2))^(1/3), K = (4/3) E*, from the
 * equations of Maugis (1992). */
START_TEST(maugis_pull_off_of_the_sphere) {
  static const double LAMBDAS[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0},
                      EXPECTED_FORCE[] = {1.950594892, 1.880473907, 1.718245275,
                                          1.600734911, 1.534603238, 1.506349968};
  const po_scene s = scene_of_words("sphere", "-", 0.3);
  const double stiffness = 4.0 / (3.0 * 0.3);
  for (int k = 0; k < 6; ++k) {
    const double tension = 0.5 * LAMBDAS[k] / cbrt(s.radius / (M_PI * stiffness * stiffness));
    po_maugis got;
    ck_assert_msg(po_maugis_pull_off(&s, tension, PO_GIVEN_LOAD, true, &got) == PO_OK, "%s",
                  po_message());
    compare("pull-off", &s, tension, -got.contact.load, EXPECTED_FORCE[k], 1e-9);
    ck_assert(po_maugis_check(&s, tension, &got) == PO_OK);
  }
}
END_TEST

/* The pull-off tends to that of JKR as tension^-2, for every profile and under either control. */
START_TEST(maugis_tends_to_jkr) {
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (po_given given = PO_GIVEN_LOAD; given <= PO_GIVEN_APPROACH; ++given) {
      const po_scene s = scene_of_words(PROFILES[p], "-", 3.0);
      po_contact jkr;
      ck_assert(po_jkr_profile_pull_off(&s, given, &jkr) == PO_OK);
      double far[2];
      for (int k = 0; k < 2; ++k) {
        po_maugis got;
        const double tension = k ? 400.0 : 200.0;
        ck_assert_msg(po_maugis_pull_off(&s, tension, given, false, &got) == PO_OK, "%s",
                      po_message());
        far[k] = given == PO_GIVEN_LOAD ? got.contact.load - jkr.load
                                        : got.contact.approach - jkr.approach;
      }
      ck_assert_msg(fabs(far[0] / far[1] - 4.0) < 0.15, "%s, given %d: %g and %g of %g",
                    PROFILES[p], given, far[0], far[1], jkr.load);
    }
}
END_TEST

START_TEST(maugis_with_deep_waves_is_refused) {
  po_maugis state;
  const po_scene shallow = scene_of_words("sphere", "0.05@30", 0.7),
                 deep = scene_of_words("sphere", "3@10", 1e-3);
  ck_assert(po_maugis_at(&shallow, 1.0, 9.0, &state) == PO_OK);
  ck_assert_msg(po_maugis_check(&shallow, 1.0, &state) == PO_OK, "%s", po_message());
  ck_assert(po_maugis_at(&deep, 1.0, 7.0, &state) == PO_OK);
  ck_assert(po_maugis_check(&deep, 1.0, &state) == PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "full disc"));
}
END_TEST

START_TEST(rigid_agrees_with_the_table) {
  table t = table_open("rigid_profiles.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    po_scene s = po_scene_default();
    s.radius = strcmp(table_word(&t, row, "radius"), "-") == 0 ? 1.0 : 100.0;
    s.tabor = 0.0;
    ck_assert(po_profile_set(&s.profile, table_word(&t, row, "profile")));
    ck_assert(po_law_set(&s.law, table_word(&t, row, "law")));
    po_rigid_pull_off got;
    ck_assert_msg(po_rigid_profile_pull_off(&s, &got) == PO_OK, "%s", po_message());
    const double force = table_number(&t, row, "force");
    table_compare(&t, row, "force", got.force, RIGID_ACCURACY * force);
    table_compare(&t, row, "approach", got.approach, RIGID_ACCURACY);
    double load, rate, other, other_rate;
    ck_assert(po_rigid_profile_load(&s, 0.2, &load, &rate) == PO_OK);
    ck_assert_msg(po_rigid_profile_quadrature(&s, 0.2, &other, &other_rate) == PO_OK, "%s",
                  po_message());
    compare("load", &s, 0.2, load, other, RIGID_QUADRATURE * force);
    compare("rate", &s, 0.2, rate, other_rate, 10.0 * RIGID_QUADRATURE * force);
  }
  table_close(&t, "rigid bodies", 35, 2);
}
END_TEST

/* Waves by quadrature: the sphere with one wave under Lennard-Jones against Eq 22; and 2 pi w R of
 * a paraboloid under every law, by a table and by a power. */
START_TEST(rigid_waves_and_tables) {
  po_scene s = scene_of_words("sphere", "0.7@12", 0.3);
  po_rigid_pull_off got;
  ck_assert_msg(po_rigid_profile_pull_off(&s, &got) == PO_OK, "%s", po_message());
  const po_rigid_pull_off eq_22 = po_wavy_rigid_pull_off(0.7, po_scene_alpha(&s));
  compare("force", &s, 0.0, got.force, eq_22.force, 1e-8);
  compare("approach", &s, 0.0, got.approach, eq_22.approach, 1e-6);
  static const char *const LAWS[] = {"lennard-jones", "mie:4,10", "mie:2.5,7.3", "morse:1.7"};
  po_scene by_table = scene_of_table(parabola, 21, 20.0, 1.0, 0.3);
  for (int l = 0; l < 4; ++l) {
    ck_assert(po_law_set(&by_table.law, LAWS[l]));
    ck_assert_msg(po_rigid_profile_pull_off(&by_table, &got) == PO_OK, "%s", po_message());
    compare("force", &by_table, l, got.force, 200.0, 200.0 * RIGID_QUADRATURE);
    s = scene_of_words("power:0.005,2", "-", 0.3);
    ck_assert(po_law_set(&s.law, LAWS[l]));
    ck_assert(po_rigid_profile_pull_off(&s, &got) == PO_OK);
    compare("force", &s, l, got.force, 200.0, 200.0 * RIGID_ACCURACY);
  }
}
END_TEST

static void add(TCase *tests) {
  gsl_set_error_handler_off();
  tcase_add_test(tests, jkr_agrees_with_the_table);
  tcase_add_test(tests, transform_agrees_with_quadrature);
  tcase_add_test(tests, transform_of_a_table_agrees_with_quadrature);
  tcase_add_loop_test(tests, table_of_a_sphere_gives_its_theory, 0, 2);
  tcase_add_test(tests, jkr_of_the_paper_is_a_case);
  tcase_add_test(tests, pull_off_of_powers_over_many_decades);
  tcase_add_test(tests, energy_is_the_work_of_the_load);
  tcase_add_test(tests, gap_outside_is_that_of_the_sphere);
  tcase_add_test(tests, overlap_outside_is_found);
  tcase_add_test(tests, minima_are_those_of_a_scan);
  tcase_add_test(tests, maugis_agrees_with_the_table);
  tcase_add_test(tests, maugis_pull_off_of_the_sphere);
  tcase_add_test(tests, maugis_tends_to_jkr);
  tcase_add_test(tests, maugis_with_deep_waves_is_refused);
  tcase_add_test(tests, rigid_agrees_with_the_table);
  tcase_add_test(tests, rigid_waves_and_tables);
  tcase_add_test(tests, unusable_profiles_are_refused);
  tcase_add_test(tests, a_sphere_beyond_the_range_of_numbers_is_refused);
}

int main(void) {
  return run_case("tables_profiles", add);
}
