/* Scenes of any profile for the tests beside reference tables. */
#ifndef PROFILES_H
#define PROFILES_H

#include <stdlib.h>
#include <unistd.h>

#include "../unit/run.h"
#include "po_jkr_profile.h"
#include "table.h"

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

/* Every profile, with and without waves. */
static const char *const PROFILES[] = {
    "sphere",         "cone:0.3",          "power:0.05,1.5",   "power:1e-9,7.3",
    "punch:5,20",     "punch:1e-3,1e6",    "truncated:5,20",   "exact_sphere:30",
    "exact_sphere:3", "hyperboloid:0.3,2", "hyperboloid:2,300"};
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
  s.profile.parameter[PO_TABLE_SCALE] = unit;
  const po_status status = po_profile_set_file(&s.profile, path);
  ck_assert_msg(status == PO_OK, "%s", po_message());
  ck_assert_int_eq(unlink(path), 0);
  return s;
}

static double parabola(double r) {
  return r * r / 200.0;
}

#endif
