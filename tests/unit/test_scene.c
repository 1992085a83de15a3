/* The scene: groups and gap shape, and Bradley's closed form. */
#include <math.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_scales.h"
#include "po_scene.h"
#include "po_wavy_rigid.h"
#include "run.h"

TEST(dimensionless_groups_are_those_of_the_paper) {
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

TABLE_TEST(bad_scenes_are_named, BAD) {
  ck_assert_int_eq(po_scene_check(&BAD[_i].scene), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), BAD[_i].key));
  ck_assert_ptr_nonnull(strstr(po_message(), "expected"));
}

TEST(profile_is_eq_2) {
  const po_scene scene = {1.0, 0.7, 13.0, 91.0, INFINITY};
  const double r = 2.385;
  ck_assert_double_eq_tol(po_initial_gap(&scene, r),
                          r * r / 182.0 + 0.7 * (1.0 - cos(2.0 * M_PI * r / 13.0)), 1e-15);
  ck_assert_double_eq_tol(po_initial_gap_mean(&scene, r), r * r / 182.0 + 0.7, 1e-15);
  /* no cancellation near the axis, where f ~ r^2 (1/(2R) + 2 pi^2 A / lambda^2) */
  const double tiny = 1e-9, curvature = 1.0 / 182.0 + 2.0 * M_PI * M_PI * 0.7 / 169.0;
  ck_assert_double_eq_tol(po_initial_gap(&scene, tiny) / (tiny * tiny * curvature), 1.0, 1e-14);
}

TEST(averaging_begins_where_a_wave_ends) {
  const po_scene scene = {3.0, 1.0, 20.0, 100.0, INFINITY};
  const double phase = po_averaging_phase(&scene, 83.0), end = po_averaging_radius(&scene, phase);
  ck_assert_double_eq_tol(phase, 90.0, 1e-12);
  ck_assert_double_eq_tol(fmod(end - phase, 20.0), 0.0, 1e-9);
  po_scene smooth = scene;
  smooth.amplitude = 0.0;
  ck_assert_double_eq(po_averaging_radius(&smooth, 83.0), 83.0);
}

TEST(bradley_is_eq_23) {
  ck_assert_double_eq_tol(po_bradley_load(0.0), -2.0, 1e-15); /* its minimum */
  const double x = 1.0 + 2.385;
  ck_assert_double_eq_tol(po_bradley_load(-2.385),
                          -2.0 * (4.0 * pow(x, 6.0) - 1.0) / (3.0 * pow(x, 8.0)), 1e-15);
  ck_assert(isnan(po_bradley_load(1.0)));
  ck_assert(isnan(po_bradley_load(NAN)));
}
