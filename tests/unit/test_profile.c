/* Profiles and the initial gap with waves: each function agrees with the gap itself, and texts set
 * what they name. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_initial_gap.h"
#include "po_profile_table.h"
#include "po_scales.h"
#include "profile_table.h"
#include "run.h"

static const char *const PROFILES[] = {
    "sphere",     "power:0.05,1.5", "power:0.001;4",   "power:2.385,1",     "cone:0.3",
    "punch:5,20", "truncated:5,20", "exact_sphere:40", "hyperboloid:0.3,2", "table"};
static const double RADII[] = {0.02, 1.7, 4.9, 5.3, 21.7, 93.0};
enum {
  PROFILE_COUNT = sizeof PROFILES / sizeof *PROFILES,
  RADIUS_COUNT = sizeof RADII / sizeof *RADII,
};
static const double R = 93.0;

static double bumps(double r) {
  return r * r / 140.0 + 0.4 * (1.0 - cos(0.7 * r));
}

static po_profile profile_of(const char *text) {
  po_profile profile = po_profile_sphere();
  if (strcmp(text, "table") == 0)
    return table_of(bumps, 121, 30.0, 1.0);
  ck_assert(po_profile_set(&profile, text));
  ck_assert_int_eq(po_profile_check(&profile), PO_OK);
  return profile;
}

LOOP_TEST(functions_agree_with_the_gap, 0, (PROFILE_COUNT * RADIUS_COUNT)) {
  const po_profile p = profile_of(PROFILES[_i / RADIUS_COUNT]);
  const double r = RADII[_i % RADIUS_COUNT], step = 1e-5 * r;
  const double f = po_profile_gap(&p, R, r), size = po_profile_gap(&p, R, 1.01 * r) + 1e-300;
  const double rate =
      (po_profile_gap(&p, R, r + step) - po_profile_gap(&p, R, r - step)) / (2 * step);
  ck_assert_double_eq(po_profile_gap(&p, R, 0.0), 0.0);
  ck_assert_double_eq_tol(po_profile_slope(&p, R, r), rate, 1e-8 * size / r);
  ck_assert_double_eq_tol(po_profile_gap_exact(&p, R, r).high, f, 4e-15 * size);
  const double at = po_profile_radius_of_gap(&p, R, f);
  ck_assert_double_ge(at, r * (1.0 - 1e-9));
  ck_assert_double_eq_tol(po_profile_gap(&p, R, at), f, 1e-9 * (size + 1e-6));
  const double beyond = po_profile_gap_beyond(&p, R, r);
  ck_assert_double_le(beyond, f);
  for (double x = r; x < 200.0; x *= 1.003)
    ck_assert_double_ge(po_profile_gap(&p, R, x), beyond * (1.0 - 1e-14));
}

/* Far out the gap is a power of the radius; the punch and the truncated sphere tend to one. */
LOOP_TEST(gap_grows_as_stated, 0, PROFILE_COUNT) {
  const po_profile p = profile_of(PROFILES[_i]);
  const double r = 1e9;
  ck_assert_double_eq_tol(r * po_profile_slope(&p, R, r) / po_profile_gap(&p, R, r),
                          po_profile_shape(&p).growth, 2e-8);
}

/* Only the truncated sphere has a corner, b/R; the curvature of the punch jumps. */
TEST(jump_of_the_slope_is_that_of_the_corner) {
  for (size_t k = 0; k < PROFILE_COUNT; ++k) {
    const po_profile p = profile_of(PROFILES[k]);
    const double jump = strncmp(PROFILES[k], "truncated", 9) ? 0.0 : 5.0 / 20.0;
    ck_assert_double_eq_tol(po_profile_slope_jump(&p, R), jump, 1e-14);
  }
}

TEST(texts_set_what_they_name) {
  po_profile p = po_profile_sphere(), before = p;
  static const char *const BAD[] = {"",           "wedge",    "cone:",      "cone:0.3,2",
                                    "table",      "sphere:1", "power:0.05", "power:1,2,3",
                                    "punch 5,20", "Cone:1",   "power:x,2",  "power:1,nan"};
  for (size_t k = 0; k < sizeof BAD / sizeof *BAD; ++k) {
    ck_assert_msg(!po_profile_set(&p, BAD[k]), "%s is accepted", BAD[k]);
    ck_assert_int_eq(memcmp(&p, &before, sizeof p), 0);
  }
  ck_assert(po_profile_is_sphere(&p) && po_profile_default_radius(&p) == 100.0);
  ck_assert(po_profile_set(&p, "punch"));
  ck_assert_int_eq(po_profile_check(&p), PO_BAD_INPUT);
  ck_assert_str_eq(po_message(), "punch_b is not given: the profile punch needs it");
  p.parameter[PO_PUNCH_B] = 5.0;
  p.parameter[PO_PUNCH_R] = 20.0;
  const po_profile whole = profile_of("punch:5,20");
  ck_assert_int_eq(memcmp(&p, &whole, sizeof p), 0);
  ck_assert_double_eq(po_profile_default_radius(&p), 1.0);
  ck_assert(po_profile_has(&p, PO_PUNCH_R) && !po_profile_has(&p, PO_POWER_C));
  ck_assert_str_eq(po_profile_file(&p), "-");
}

static const char *const OUT_OF_RANGE[] = {"power:1,0.99",   "power:1,41",   "power:0,2",
                                           "cone:-1",        "punch:0,1",    "punch:1,0",
                                           "truncated:-1,2", "truncated:1,0"};

TABLE_TEST(parameters_out_of_range_are_named, OUT_OF_RANGE) {
  po_profile p = po_profile_sphere();
  ck_assert(po_profile_set(&p, OUT_OF_RANGE[_i]));
  ck_assert_int_eq(po_profile_check(&p), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), po_profile_name(&p)));
  ck_assert_ptr_nonnull(strstr(po_message(), "expected"));
}

/* f(r)/epsilon of a profile in metres is that of the profile in epsilon at r/epsilon. */
TEST(other_units_of_length) {
  static const char *const METRES[] = {"power:3e7,1.5", "power:5e6,2", "cone:0.3",
                                       "punch:1.5e-9,6e-9", "truncated:1.5e-9,6e-9"};
  const double epsilon = 3e-10;
  for (size_t k = 0; k < sizeof METRES / sizeof *METRES; ++k) {
    const po_profile metres = profile_of(METRES[k]);
    po_profile p = metres;
    po_profile_rescale(&p, epsilon);
    for (int i = 0; i < RADIUS_COUNT; ++i) {
      const double f = po_profile_gap(&metres, NAN, epsilon * RADII[i]) / epsilon;
      ck_assert_double_eq_tol(po_profile_gap(&p, NAN, RADII[i]), f, 1e-13 * (1.0 + f));
    }
  }
  const po_profile one = table_of(bumps, 121, 30.0, 1.0), other = table_of(bumps, 121, 30.0, 0.37);
  for (int i = 0; i < RADIUS_COUNT; ++i)
    ck_assert_double_eq_tol(po_profile_gap(&other, NAN, RADII[i]),
                            po_profile_gap(&one, NAN, RADII[i]),
                            1e-12 * (1.0 + po_profile_gap(&one, NAN, RADII[i])));
  ck_assert_double_eq_tol(po_profile_shape(&other).end, 30.0, 1e-13);
}

static double parabola(double r) {
  return r * r / 200.0;
}

TEST(table_of_a_parabola_is_the_parabola) {
  const po_profile p = table_of(parabola, 23, 40.0, 1.0);
  ck_assert_uint_eq(p.table->rows, 23);
  ck_assert_double_lt(p.table->uncertainty, 1e-13);
  ck_assert_double_eq_tol(po_profile_shape(&p).growth, 2.0, 1e-12);
  ck_assert(po_profile_shape(&p).is_convex && isinf(po_profile_shape(&p).detail));
  ck_assert_uint_eq(strlen(po_profile_digest(&p)), 64);
  for (double r = 0.01; r < 1e4; r *= 1.37)
    ck_assert_double_eq_tol(po_profile_gap(&p, NAN, r), parabola(r), 1e-11 * parabola(r) + 1e-15);
}

static double ball(double r) {
  return 40.0 - sqrt(1600.0 - r * r);
}

/* The stated uncertainty of a table bounds its true error. That of a smooth gap falls as the fourth
 * power of the distance of the rows. */
LOOP_TEST(uncertainty_of_a_table_bounds_its_error, 0, 2) {
  double (*const gaps[])(double r) = {ball, bumps};
  double error[2] = {0.0, 0.0};
  for (int refine = 0; refine < 2; ++refine) {
    const po_profile p = table_of(gaps[_i], refine ? 121 : 61, 30.0, 1.0);
    for (double r = 0.0; r <= 30.0; r += 0.0137)
      error[refine] = fmax(error[refine], fabs(po_profile_gap(&p, NAN, r) - gaps[_i](r)));
    ck_assert_double_le(error[refine], p.table->uncertainty);
    ck_assert_int_eq(po_profile_shape(&p).is_convex, _i == 0);
    ck_assert_int_eq(isinf(po_profile_shape(&p).detail) != 0, _i == 0);
  }
  ck_assert(_i == 1 || (error[0] / error[1] > 12.0 && error[0] / error[1] < 20.0));
}

/* Reads 21 rows of a parabola and one more, at a small relative distance from the seventh and with
 * its gap. Returned: the greatest error of the table. */
static po_status read_near_rows(double distance, po_profile *profile, double *error) {
  char path[] = "/tmp/po_profile_XXXXXX";
  FILE *f = new_table(path);
  for (int k = 0; k < 21; ++k) {
    fprintf(f, "%.17g,%.17g\n", 2.0 * k, parabola(2.0 * k));
    if (k == 6)
      fprintf(f, "%.17g,%.17g\n", 12.0 * (1.0 + distance), parabola(12.0));
  }
  ck_assert_int_eq(fclose(f), 0);
  *profile = po_profile_sphere();
  profile->parameter[PO_TABLE_SCALE] = 1.0;
  const po_status status = po_profile_set_file(profile, path);
  ck_assert_int_eq(unlink(path), 0);
  *error = 0.0;
  for (double r = 0.0; r <= 40.0 && !status; r += 0.0137)
    *error = fmax(*error, fabs(po_profile_gap(profile, NAN, r) - parabola(r)));
  return status;
}

/* Two rows at nearly the same radius with the same gap make the slope there 0. At a distance of
 * 1e-15 that is refused. Of rows that were rounded to six digits it is in the stated uncertainty,
 * which was 1e-15: only rows left out were compared, and these two differ by nothing. */
TEST(rows_that_are_too_near_are_noticed) {
  po_profile profile;
  double error;
  ck_assert_int_eq(read_near_rows(1e-15, &profile, &error), PO_CANNOT_READ);
  ck_assert_ptr_nonnull(strstr(po_message(), ":9: the distance of r from that of the row before"));
  ck_assert_int_eq(read_near_rows(1e-6, &profile, &error), PO_OK);
  ck_assert_double_gt(error, 0.01);
  ck_assert_double_le(error, 1.02 * profile.table->uncertainty);
}

static double ball_of_50(double r) {
  return 50.0 - sqrt(2500.0 - r * r);
}

/* The theories evaluated all rows at each radius and went from row to row: the JKR theory of 10,000
 * rows took more than 20 s. The thin spline has few knots, and the slopes of the ball. */
TEST(thin_splines_have_the_slopes_of_all_rows) {
  const po_profile profile = table_of(ball_of_50, 10001, 40.0, 1.0);
  const po_profile_table *thin = profile.table->thin;
  ck_assert_ptr_nonnull(thin);
  ck_assert_uint_lt(thin->rows, 200);
  po_profile few = profile;
  few.table = thin;
  for (double r = 0.003; r < 40.0; r += 0.0137) {
    const double slope = r / sqrt(2500.0 - r * r), allowed = 1.1e-7 * fmax(slope, 1.0 / r);
    ck_assert_double_eq_tol(po_profile_slope(&few, 0.0, r), slope, allowed);
  }
  ck_assert_ptr_null(table_of(ball_of_50, 256, 40.0, 1.0).table->thin);
}

TEST(joints_of_a_table_are_its_rows) {
  const po_profile p = table_of(parabola, 23, 40.0, 0.3);
  double r = 0.0;
  int joints = 0;
  for (; (r = po_profile_next_joint(&p, r)) < INFINITY; ++joints)
    ck_assert_double_eq_tol(r, 40.0 * (joints + 1) / 22.0, 1e-12);
  ck_assert_int_eq(joints, 22);
}

/* The usual load of a cone without units, for a coupling. */
static double load_of_cone(double coupling, const char *waves) {
  po_scene scene = po_scene_default();
  scene.profile = profile_of("cone:0.05");
  scene.outer_radius = INFINITY;
  scene.radius = 1.0;
  scene.tabor = po_scene_tabor_of_coupling(coupling, scene.radius);
  ck_assert(po_scene_set_waves(&scene, waves));
  const po_scales s = po_scene_scales(&scene);
  return s.load * s.load_factor;
}

/* The pull-off force of JKR of a cone goes as w^2/E, that of rigid cones is fixed. A wave that
 * multiplies the work of adhesion by four multiplies that of JKR by 16. */
TEST(usual_load_is_that_of_the_limit_which_applies) {
  ck_assert_double_eq_tol(load_of_cone(0.6, "-") / load_of_cone(0.3, "-"), 2.0, 0.1);
  ck_assert_double_eq_tol(load_of_cone(2e-6, "-") / load_of_cone(1e-6, "-"), 1.0, 1e-12);
  const double length = 0.5 * M_PI / 0.3; /* amplitude 1: 1 + 1 = sqrt(4) in Eq 24 */
  char wave[64];
  snprintf(wave, sizeof wave, "1@%.17g", length);
  ck_assert_double_eq_tol(load_of_cone(0.3, wave) / load_of_cone(0.3, "-"), 16.0, 0.5);
  po_scene sphere = po_scene_default();
  ck_assert_double_eq(po_scene_scales(&sphere).load_factor, 1.0);
  ck_assert(po_scene_set_waves(&sphere, wave)); /* coupling 0.1: (1 + sqrt(3))^2 */
  ck_assert_double_eq_tol(po_scene_scales(&sphere).load_factor, 4.0 + 2.0 * sqrt(3.0), 1e-12);
}

TEST(waves_add_to_the_profile) {
  po_scene scene = po_scene_default();
  scene.profile = profile_of("cone:0.3");
  ck_assert(po_scene_set_waves(&scene, "0.4@12;0.03@1.7;0.2@5"));
  ck_assert_uint_eq(po_scene_waves(&scene), 3);
  static const double A[] = {0.4, 0.03, 0.2}, L[] = {12.0, 1.7, 5.0};
  for (int i = 0; i < RADIUS_COUNT; ++i) {
    const double r = RADII[i], step = 1e-5;
    double f = 0.3 * r;
    for (int k = 0; k < 3; ++k)
      f += A[k] * (1.0 - cos(2.0 * M_PI * r / L[k]));
    ck_assert_double_eq_tol(po_initial_gap(&scene, r), f, 1e-12);
    ck_assert_double_eq_tol(po_initial_gap_exact(&scene, r).high, f, 1e-12);
    const double rate =
        (po_initial_gap(&scene, r + step) - po_initial_gap(&scene, r - step)) / (2 * step);
    ck_assert_double_eq_tol(po_initial_gap_slope(&scene, r), rate, 1e-8);
    ck_assert_double_eq_tol(po_initial_gap_mean(&scene, r), 0.3 * r + 0.63, 1e-12);
    ck_assert_double_le(po_initial_gap_beyond(&scene, r), f);
  }
  static const char *const BAD[] = {
      "1",    "1@",      "@2",  "1@2;",  "-1@2",
      "1@-2", "1@2,3@4", "0@2", "1@inf", "1@2;1@2;1@2;1@2;1@2;1@2;1@2;1@2;1@2"};
  for (size_t k = 0; k < sizeof BAD / sizeof *BAD; ++k)
    ck_assert_msg(!po_scene_set_waves(&scene, BAD[k]), "%s is accepted", BAD[k]);
  ck_assert_uint_eq(po_scene_waves(&scene), 3);
  ck_assert(po_scene_set_waves(&scene, "-"));
  ck_assert_uint_eq(po_scene_waves(&scene), 0);
}
