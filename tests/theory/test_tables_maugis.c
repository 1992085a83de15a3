/* The theory of Maugis and Dugdale and the rigid limit for any profile, against every row of their
 * reference tables and by other routes. */
#include <gsl/gsl_errno.h>

#include "po_maugis.h"
#include "po_rigid_profile.h"
#include "po_wavy_rigid.h"
#include "profiles.h"

/* The tolerances that the headers state. */
static const double MAUGIS_ACCURACY = 1e-14, RIGID_ACCURACY = 1e-13, RIGID_QUADRATURE = 1e-9;

ROWS_TEST(maugis_agrees_with_the_table, "maugis_profiles.csv", "Maugis-Dugdale", 54, 3) {
  const po_scene s = scene_of(t, row);
  const double tension = table_number(t, row, "tension"),
               a = table_number(t, row, "contact_radius");
  po_maugis got;
  ck_assert_msg(po_maugis_at(&s, tension, a, &got) == PO_OK, "%s", po_message());
  const po_contact size = terms_at(&s, a);
  table_compare(t, row, "load", got.contact.load, MAUGIS_ACCURACY * size.load);
  table_compare(t, row, "approach", got.contact.approach, MAUGIS_ACCURACY * size.approach);
  table_compare(t, row, "end_of_tension", got.end, MAUGIS_ACCURACY * got.end);
  /* the rates by central differences */
  po_maugis before, after;
  const double h = 1e-4 * a;
  double width_rate;
  ck_assert(po_maugis_at(&s, tension, a - h, &before) == PO_OK);
  ck_assert(po_maugis_at(&s, tension, a + h, &after) == PO_OK);
  compare("load rate", &s, a, po_maugis_rate(&s, tension, PO_FIXED_LOAD, &got, &width_rate),
          (after.contact.load - before.contact.load) / (2.0 * h), 1e-5 * size.load / a);
  compare("approach rate", &s, a, po_maugis_rate(&s, tension, PO_FIXED_APPROACH, &got, &width_rate),
          (after.contact.approach - before.contact.approach) / (2.0 * h), 1e-5 * size.approach / a);
  compare("rate of the width", &s, a, width_rate, (after.width - before.width) / (2.0 * h),
          1e-5 * got.end / a);
}

/* The sphere at given load, pi w R, over lambda = 2 q (R/(pi w K^2))^(1/3), K = (4/3) E*, from the
 * equations of Maugis (1992). */
TEST(maugis_pull_off_of_the_sphere) {
  static const double LAMBDAS[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0},
                      EXPECTED_FORCE[] = {1.950594892, 1.880473907, 1.718245275,
                                          1.600734911, 1.534603238, 1.506349968};
  const po_scene s = scene_of_words("sphere", "-", 0.3);
  const double stiffness = 4.0 / (3.0 * 0.3);
  for (int k = 0; k < 6; ++k) {
    const double tension = 0.5 * LAMBDAS[k] / cbrt(s.radius / (M_PI * stiffness * stiffness));
    po_maugis got;
    ck_assert_msg(po_maugis_pull_off(&s, tension, PO_FIXED_LOAD, true, &got) == PO_OK, "%s",
                  po_message());
    compare("pull-off", &s, tension, -got.contact.load, EXPECTED_FORCE[k], 1e-9);
    ck_assert(po_maugis_check(&s, tension, &got) == PO_OK);
  }
}

/* The pull-off tends to that of JKR as tension^-2, for every profile and under either control. */
TEST(maugis_tends_to_jkr) {
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (po_fixed fixed = PO_FIXED_LOAD; fixed <= PO_FIXED_APPROACH; ++fixed) {
      const po_scene s = scene_of_words(PROFILES[p], "-", 3.0);
      po_contact jkr;
      ck_assert(po_jkr_profile_pull_off(&s, fixed, &jkr) == PO_OK);
      double far[2];
      for (int k = 0; k < 2; ++k) {
        po_maugis got;
        const double tension = k ? 400.0 : 200.0;
        ck_assert_msg(po_maugis_pull_off(&s, tension, fixed, false, &got) == PO_OK, "%s",
                      po_message());
        far[k] = fixed == PO_FIXED_LOAD ? got.contact.load - jkr.load
                                        : got.contact.approach - jkr.approach;
      }
      ck_assert_msg(fabs(far[0] / far[1] - 4.0) < 0.15, "%s, fixed %d: %g and %g of %g",
                    PROFILES[p], fixed, far[0], far[1], jkr.load);
    }
}

/* A ring far narrower than the rounding of its radius: the width was the difference of two radii,
 * and a sphere of Tabor parameter 1e8 pulled off at 0.957 of the force of JKR, one of 1e9 at 1e-27.
 */
TEST(maugis_of_very_soft_bodies_is_jkr) {
  for (int p = 0; p < PROFILE_COUNT; ++p)
    for (double coupling = 1e8; coupling < 1e18; coupling *= 1e3)
      for (po_fixed fixed = PO_FIXED_LOAD; fixed <= PO_FIXED_APPROACH; ++fixed) {
        const po_scene s = scene_of_words(PROFILES[p], "-", coupling);
        po_contact jkr;
        po_maugis got;
        ck_assert(po_jkr_profile_pull_off(&s, fixed, &jkr) == PO_OK);
        ck_assert_msg(po_maugis_pull_off(&s, 1.026, fixed, false, &got) == PO_OK, "%s",
                      po_message());
        const bool load = fixed == PO_FIXED_LOAD;
        compare("pull-off", &s, coupling, load ? got.contact.load : got.contact.approach,
                load ? jkr.load : jkr.approach, 1e-6 * fabs(load ? jkr.load : jkr.approach));
      }
}

TEST(maugis_with_deep_waves_is_refused) {
  po_maugis state;
  const po_scene shallow = scene_of_words("sphere", "0.05@30", 0.7),
                 deep = scene_of_words("sphere", "3@10", 1e-3);
  ck_assert(po_maugis_at(&shallow, 1.0, 9.0, &state) == PO_OK);
  ck_assert_msg(po_maugis_check(&shallow, 1.0, &state) == PO_OK, "%s", po_message());
  ck_assert(po_maugis_at(&deep, 1.0, 7.0, &state) == PO_OK);
  ck_assert(po_maugis_check(&deep, 1.0, &state) == PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "full disc"));
}

ROWS_TEST(rigid_agrees_with_the_table, "rigid_profiles.csv", "rigid bodies", 50, 2) {
  po_scene s = po_scene_default();
  s.radius = strcmp(table_word(t, row, "radius"), "-") == 0 ? 1.0 : 100.0;
  s.tabor = 0.0;
  ck_assert(po_profile_set(&s.profile, table_word(t, row, "profile")));
  ck_assert(po_law_set(&s.law, table_word(t, row, "law")));
  po_rigid_pull_off got;
  ck_assert_msg(po_rigid_profile_pull_off(&s, &got) == PO_OK, "%s", po_message());
  const double force = table_number(t, row, "force");
  table_compare(t, row, "force", got.force, RIGID_ACCURACY * force);
  table_compare(t, row, "approach", got.approach, RIGID_ACCURACY);
  double load, rate, other, other_rate;
  ck_assert(po_rigid_profile_load(&s, 0.2, &load, &rate) == PO_OK);
  ck_assert_msg(po_rigid_profile_quadrature(&s, 0.2, &other, &other_rate) == PO_OK, "%s",
                po_message());
  compare("load", &s, 0.2, load, other, RIGID_QUADRATURE * force);
  compare("rate", &s, 0.2, rate, other_rate, 10.0 * RIGID_QUADRATURE * force);
}

/* Waves by quadrature: the sphere with one wave under Lennard-Jones against Eq 22; and 2 pi w R of
 * a paraboloid under every law, by a table and by a power. */
TEST(rigid_waves_and_tables) {
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

static void silence_gsl(void) {
  gsl_set_error_handler_off();
}
FIXTURE(silence_gsl, NULL)
