/* The scene: groups, gap shape, interaction law and its average, and Bradley's closed form. */
#include <math.h>
#include <string.h>

#include "po_bradley.h"
#include "po_law.h"
#include "po_profile.h"
#include "po_scene.h"
#include "run.h"

START_TEST(groups_of_the_paper) {
  po_scene scene = {.tabor = 2.385,
                    .amplitude = 1.3,
                    .wavelength = 17.0,
                    .radius = 83.0,
                    .outer_radius = INFINITY};
  ck_assert_double_eq_tol(po_scene_gamma(&scene), sqrt(83.0 * 2.385), 1e-14);
  ck_assert_double_eq_tol(po_scene_alpha(&scene), 1.3 * 83.0 / 289.0, 1e-15);
  scene.amplitude = 0.0;
  ck_assert_double_eq(po_scene_alpha(&scene), 0.0);
}
END_TEST

typedef struct {
  po_scene scene;
  const char *key;
} bad_scene;

static const bad_scene BAD[] = {
    {{-1.0, 0.0, 0.0, 100.0, INFINITY}, "tabor"},    {{NAN, 0.0, 0.0, 100.0, INFINITY}, "tabor"},
    {{1.0, INFINITY, 1.0, 100.0, 5.0}, "amplitude"}, {{1.0, 1.0, 0.0, 100.0, 5.0}, "wavelength"},
    {{1.0, 0.0, 0.0, -3.0, INFINITY}, "radius"},     {{1.0, 0.0, 0.0, 100.0, 0.0}, "outer_radius"},
    {{1.0, 0.0, 0.0, 100.0, NAN}, "outer_radius"},
};

START_TEST(bad_scenes_are_named) {
  ck_assert_int_eq(po_scene_check(&BAD[_i].scene), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), BAD[_i].key));
  ck_assert_ptr_nonnull(strstr(po_message(), "expected"));
}
END_TEST

START_TEST(profile_is_eq_2) {
  const po_scene scene = {1.0, 0.7, 13.0, 91.0, INFINITY};
  const double r = 2.385;
  ck_assert_double_eq_tol(po_profile(&scene, r),
                          r * r / 182.0 + 0.7 * (1.0 - cos(2.0 * M_PI * r / 13.0)), 1e-15);
  ck_assert_double_eq_tol(po_profile_mean(&scene, r), r * r / 182.0 + 0.7, 1e-15);
  /* no cancelling near the axis: f ~ r^2 (1/(2R) + 2 pi^2 A / lambda^2) */
  const double tiny = 1e-9, curvature = 1.0 / 182.0 + 2.0 * M_PI * M_PI * 0.7 / 169.0;
  ck_assert_double_eq_tol(po_profile(&scene, tiny) / (tiny * tiny * curvature), 1.0, 1e-14);
}
END_TEST

static const double GAPS[] = {-0.4, -0.05, 0.0, 0.3, 2.385, 40.0};

START_TEST(law_is_eq_16_and_derives_from_its_energy) {
  const double gap = GAPS[_i], h = 1.0 + gap, step = 1e-5 * h;
  const po_law law = po_law_at(gap);
  ck_assert_double_eq_tol(law.traction, -8.0 / 3.0 * (pow(h, -3.0) - pow(h, -9.0)),
                          1e-14 * (pow(h, -3.0) + pow(h, -9.0)));
  const double slope =
      (po_law_at(gap + step).traction - po_law_at(gap - step).traction) / (2 * step);
  ck_assert_double_eq_tol(law.slope, slope, 3e-9 * (pow(h, -4.0) + pow(h, -10.0)) * 24.0);
  const double force = -(po_law_energy(gap + step) - po_law_energy(gap - step)) / (2 * step);
  ck_assert_double_eq_tol(law.traction, force, 3e-9 * (pow(h, -3.0) + pow(h, -9.0)) * 20.0);
}
END_TEST

START_TEST(law_peaks_where_the_paper_says) { /* 16/(9 sqrt 3) at h = 3^(1/6), after Eq 9 */
  ck_assert_double_eq_tol(po_law_at(PO_LAW_PEAK_GAP).traction, -16.0 / (9.0 * sqrt(3.0)), 1e-15);
  ck_assert_double_eq_tol(po_law_at(PO_LAW_PEAK_GAP).slope, 0.0, 1e-14);
  ck_assert_double_eq_tol(PO_LAW_PEAK_GAP, pow(3.0, 1.0 / 6.0) - 1.0, 1e-15);
}
END_TEST

static const double AVERAGES[][2] = {
    {5.0, 0.0}, {5.0, 0.385}, {5.0, 4.0}, {60.0, 10.0}, {2.0, 1.5}};

START_TEST(averaged_law_is_the_mean_over_a_period) { /* the trapezoidal sum is spectral */
  enum { POINTS = 4096 };
  const double gap = AVERAGES[_i][0], amplitude = AVERAGES[_i][1];
  double traction = 0.0, slope = 0.0, energy = 0.0;
  for (int k = 0; k < POINTS; ++k) {
    const po_law law = po_law_at(gap - amplitude * cos(2.0 * M_PI * k / POINTS));
    traction += law.traction / POINTS;
    slope += law.slope / POINTS;
    energy += po_law_energy(gap - amplitude * cos(2.0 * M_PI * k / POINTS)) / POINTS;
  }
  const po_law law = po_law_averaged(gap, amplitude);
  ck_assert_double_eq_tol(law.traction / traction, 1.0, 1e-13);
  ck_assert_double_eq_tol(law.slope / slope, 1.0, 1e-12);
  ck_assert_double_eq_tol(po_law_energy_averaged(gap, amplitude) / energy, 1.0, 1e-13);
}
END_TEST

START_TEST(averaging_begins_where_a_wave_ends) {
  const po_scene scene = {3.0, 1.0, 20.0, 100.0, INFINITY};
  const double phase = po_averaging_phase(&scene, 83.0), end = po_averaging_radius(&scene, phase);
  ck_assert_double_eq_tol(phase, 90.0, 1e-12);
  ck_assert_double_eq_tol(fmod(end - phase, 20.0), 0.0, 1e-9);
  po_scene smooth = scene;
  smooth.amplitude = 0.0;
  ck_assert_double_eq(po_averaging_radius(&smooth, 83.0), 83.0);
}
END_TEST

START_TEST(bradley_is_eq_23) {
  ck_assert_double_eq_tol(po_bradley_load(0.0), -2.0, 1e-15); /* its minimum */
  const double x = 1.0 + 2.385;
  ck_assert_double_eq_tol(po_bradley_load(-2.385),
                          -2.0 * (4.0 * pow(x, 6.0) - 1.0) / (3.0 * pow(x, 8.0)), 1e-15);
  ck_assert(isnan(po_bradley_load(1.0)));
  ck_assert(isnan(po_bradley_load(NAN)));
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, groups_of_the_paper);
  tcase_add_loop_test(tests, bad_scenes_are_named, 0, sizeof BAD / sizeof *BAD);
  tcase_add_test(tests, profile_is_eq_2);
  tcase_add_loop_test(tests, law_is_eq_16_and_derives_from_its_energy, 0,
                      sizeof GAPS / sizeof *GAPS);
  tcase_add_test(tests, law_peaks_where_the_paper_says);
  tcase_add_loop_test(tests, averaged_law_is_the_mean_over_a_period, 0,
                      sizeof AVERAGES / sizeof *AVERAGES);
  tcase_add_test(tests, averaging_begins_where_a_wave_ends);
  tcase_add_test(tests, bradley_is_eq_23);
}

int main(void) {
  return run_case("scene", add);
}
