/* The closed forms against every row of their reference tables. */
#include <gsl/gsl_errno.h>

#include "../unit/run.h"
#include "po_estimates.h"
#include "po_guduru.h"
#include "po_maugis.h"
#include "po_wavy_rigid.h"
#include "table.h"

/* The tolerances that the headers state. */
static const double GUDURU_ACCURACY = 1e-14, PULL_OFF_ACCURACY = 1e-13, RIGID_ACCURACY = 1e-10,
                    ESTIMATE_ACCURACY = 1e-14;

static po_scene scene_of(const table *t, size_t row) {
  return (po_scene){.tabor = table_number(t, row, "tabor"),
                    .amplitude = table_number(t, row, "amplitude"),
                    .wavelength = table_number(t, row, "wavelength"),
                    .radius = table_number(t, row, "radius"),
                    .outer_radius = INFINITY};
}

/* The larger term of load and approach in Eq 5 at a contact radius. Rounding errors are relative to
 * it. The phase 2 pi a/lambda has a rounding error in proportion to its size. */
static po_contact terms_at(const po_scene *s, double a) {
  const double e = sqrt(s->radius / pow(s->tabor, 3.0)), R = s->radius, A = s->amplitude;
  const double x = A > 0.0 ? 2.0 * M_PI * a / s->wavelength : 0.0, turns = 1.0 + 0.1 * x;
  const double swing = A > 0.0 ? A * turns * sqrt(2.0 * x / M_PI) : 0.0;
  return (po_contact){
      .load = fmax(4.0 * e * a * a * a / (3.0 * M_PI * R * R),
                   fmax(sqrt(8.0 * e * a * a * a / M_PI) / R, e * a * swing / R)),
      .approach = fmax(a * a / R, fmax(sqrt(2.0 * M_PI * a / e), M_PI_2 * swing)),
  };
}

ROWS_TEST(guduru_agrees_with_the_table, "guduru.csv", "Eq 5", 108, 2) {
  const po_scene s = scene_of(t, row);
  const double a = table_number(t, row, "contact_radius");
  const po_contact got = po_guduru_at(&s, a), size = terms_at(&s, a);
  table_compare(t, row, "load", got.load, GUDURU_ACCURACY * size.load);
  table_compare(t, row, "approach", got.approach, GUDURU_ACCURACY * size.approach);
}

ROWS_TEST(guduru_pull_off_agrees_with_the_table, "guduru_pull_off.csv", "pull-off of Eq 5", 74, 3) {
  const po_scene s = scene_of(t, row);
  const po_contact got = po_guduru_pull_off(&s);
  const double a = table_number(t, row, "contact_radius");
  table_compare(t, row, "force", -got.load, PULL_OFF_ACCURACY * table_number(t, row, "force"));
  table_compare(t, row, "contact_radius", got.contact_radius, PULL_OFF_ACCURACY * a);
  table_compare(t, row, "approach", got.approach, PULL_OFF_ACCURACY * terms_at(&s, a).approach);
}

/* The states of jkr_grooves_path.csv whose contact is a disc are those of Eq 5, since the pressure
 * does not depend on the gap outside. With lambda = R = epsilon, alpha is the amplitude and beta =
 * 1/(2 pi mu^1.5). The table has 12 digits; its errors are below 1e-9. */
TEST(guduru_agrees_with_discs_between_grooves) {
  table t = table_open("jkr_grooves_path.csv");
  size_t discs = 0;
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    const char *edges = table_word(&t, row, "edges");
    double a;
    int end = 0;
    if (sscanf(edges, "0;%lf%n", &a, &end) != 1 || edges[end])
      continue;
    discs += 1;
    const po_scene s = {.tabor = pow(2.0 * M_PI * table_number(&t, row, "beta"), -2.0 / 3.0),
                        .amplitude = table_number(&t, row, "alpha"),
                        .wavelength = 1.0,
                        .radius = 1.0,
                        .outer_radius = INFINITY};
    const po_contact got = po_guduru_at(&s, a), size = terms_at(&s, a);
    table_compare(&t, row, "load", got.load, 1e-9 * size.load);
    table_compare(&t, row, "approach", got.approach, 1e-9 * size.approach);
  }
  ck_assert_uint_ge(discs, 50);
  ck_assert_uint_eq(t.compared, 2 * discs);
  printf("%s: %zu discs, at most %.3f of the tolerance\n", t.csv.path, discs, t.worst);
  po_csv_clear(&t.csv);
}

ROWS_TEST(envelope_agrees_with_the_table, "kesari_lew.csv", "envelope of Eq 5", 73, 6) {
  const po_scene s = scene_of(t, row);
  const double johnson = po_johnson_parameter(&s), work = po_kesari_lew_work(&s);
  table_compare(t, row, "johnson", johnson, ESTIMATE_ACCURACY * table_number(t, row, "johnson"));
  table_compare(t, row, "effective_work", work, ESTIMATE_ACCURACY * work);
  table_compare(t, row, "force", 1.5 * work, ESTIMATE_ACCURACY * work);
  /* the upper envelope is deepest where (a/Gamma)^3 = (9 pi/8) factor^2; it is tensile only if
   * the factor is positive */
  const double factor = fmax(0.0, 1.0 - 1.0 / (sqrt(M_PI) * johnson));
  const double a = cbrt(9.0 * M_PI / 8.0 * factor * factor) * po_scene_gamma(&s);
  table_compare(t, row, "upper_force", -po_kesari_lew_edge(&s, a, 1).load, ESTIMATE_ACCURACY);
  const double force = -po_guduru_pull_off(&s).load;
  table_compare(t, row, "guduru_force", force, PULL_OFF_ACCURACY * force);
  const double difference = table_number(t, row, "force_difference");
  table_compare(t, row, "force_difference", fabs(1.5 * work - force), 5e-3 * difference);
}

/* Of a smooth sphere the number of Maugis decides alone: any Tabor parameter with the tension that
 * belongs to it. */
ROWS_TEST(transition_agrees_with_the_table, "transition.csv", "transition from Bradley to JKR", 15,
          6) {
  const double lambda = table_number(t, row, "maugis_parameter");
  table_compare(t, row, "alpha", po_transition_alpha(lambda), ESTIMATE_ACCURACY);
  table_compare(t, row, "carpick", po_carpick_force(lambda), ESTIMATE_ACCURACY);
  table_compare(t, row, "pietrement", po_pietrement_force(lambda), ESTIMATE_ACCURACY);
  table_compare(t, row, "schwarz", po_schwarz_force(lambda), ESTIMATE_ACCURACY);
  po_scene s = po_scene_default();
  s.tabor = 2.385;
  const double tension = lambda / po_maugis_parameter(s.tabor, 1.0);
  po_maugis state;
  for (int predict = 0; predict < 2; ++predict) {
    ck_assert_int_eq(po_maugis_pull_off(&s, tension, PO_FIXED_LOAD, predict, &state), PO_OK);
    table_compare(t, row, "maugis", -state.contact.load, PULL_OFF_ACCURACY);
  }
}

ROWS_TEST(edges_agree_with_the_table, "kesari_lew_edges.csv", "edges of the envelope", 50, 4) {
  const po_scene s = scene_of(t, row);
  const double a = table_number(t, row, "contact_radius");
  const int side = strcmp(table_word(t, row, "edge"), "lower") == 0 ? -1 : 1;
  const po_contact edge = po_kesari_lew_edge(&s, a, side), eq_5 = po_guduru_at(&s, a);
  const po_contact size = terms_at(&s, a);
  table_compare(t, row, "edge_load", edge.load, GUDURU_ACCURACY * size.load);
  table_compare(t, row, "edge_approach", edge.approach, GUDURU_ACCURACY * size.approach);
  table_compare(t, row, "load", eq_5.load, GUDURU_ACCURACY * size.load);
  table_compare(t, row, "approach", eq_5.approach, GUDURU_ACCURACY * size.approach);
  ck_assert_double_le(fabs(edge.load - eq_5.load), table_number(t, row, "load_difference_bound"));
  ck_assert_double_le(fabs(edge.approach - eq_5.approach),
                      table_number(t, row, "approach_difference_bound"));
}

ROWS_TEST(rigid_load_agrees_with_the_table, "rigid_integral.csv", "Eq 22", 80, 1) {
  const double load =
      po_wavy_rigid_load(table_number(t, row, "amplitude"), table_number(t, row, "alpha"),
                         table_number(t, row, "approach"));
  table_compare(t, row, "load", load, RIGID_ACCURACY * fabs(table_number(t, row, "load")));
}

ROWS_TEST(bradley_agrees_with_the_table, "bradley.csv", "Eq 23", 170, 1) {
  const double approach = table_number(t, row, "approach"), x = 1.0 - approach;
  /* 4 ulp of the larger term, and the effect of rounding the approach by half an ulp */
  const double larger = fmax(8.0 / (3.0 * x * x), 2.0 / (3.0 * pow(x, 8.0)));
  const double ulp = 4.0 + 8.0 * fabs(approach) / x;
  table_compare(t, row, "load", po_bradley_load(approach), ulp * 2.220446049250313e-16 * larger);
}

static void silence_gsl(void) {
  gsl_set_error_handler_off();
}
FIXTURE(silence_gsl, NULL)
