/* The theories beside a result: deviations and assumptions, for results made up here. */
#include <math.h>

#include "po_companion_jkr.h"
#include "run.h"

/* A result with the force 1.6 +- 0.01 and a contact of two wavelengths and a half. */
static po_result result_of(double full_disc) {
  po_result result = po_result_none();
  result.has_pull_off = true;
  result.pull_off.force = 1.6;
  result.pull_off.force_error = 0.01;
  result.pull_off.contact_radius = 20.0;
  result.pull_off.full_disc = full_disc;
  return result;
}

static po_request request_of_tabor(double tabor, double amplitude) {
  po_request request = po_request_default();
  request.scene.tabor = tabor;
  request.scene.amplitude = amplitude;
  request.scene.wavelength = 8.0;
  return request;
}

START_TEST(deviation_and_its_error) {
  const po_request request = request_of_tabor(2.0, 0.0);
  po_result result = result_of(1.0);
  ck_assert_int_eq(PO_COMPANION_JKR.theories(&request, &result), PO_OK);
  ck_assert_uint_eq(result.theory_count, PO_THEORY_COUNT);
  const po_theory_row *rigid = &result.theories[PO_THEORY_RIGID],
                      *jkr = &result.theories[PO_THEORY_JKR];
  ck_assert_double_eq_tol(rigid->deviation, 2.0 / 1.6 - 1.0, 1e-9);
  ck_assert_double_eq_tol(jkr->deviation, 1.5 / 1.6 - 1.0, 1e-9);
  ck_assert_double_eq_tol(jkr->deviation_error, 1.5 / 1.59 - 1.5 / 1.6, 1e-9);
  ck_assert_int_eq(rigid->holds, PO_HOLDS_NO);
  ck_assert_double_eq_tol(rigid->number, 2.0, 1e-12);
  ck_assert(isnan(result.theories[PO_THEORY_GUDURU].force));
  ck_assert_str_eq(result.theories[PO_THEORY_GUDURU].reason, "the surface has no waves");
  po_result_clear(&result);
}
END_TEST

/* JKR assumes a soft crest and a disc without grooves. The first assumption that does not hold
 * decides, also after one that is unknown. */
START_TEST(assumption_that_decides) {
  static const struct {
    double tabor, full_disc;
    po_holds holds;
    po_assumption decided_by;
  } CASES[] = {{40.0, 1.0, PO_HOLDS_YES, PO_ASSUMES_CREST_TABOR},
               {40.0, 0.8, PO_HOLDS_NO, PO_ASSUMES_FULL_DISC},
               {4.0, 0.8, PO_HOLDS_NO, PO_ASSUMES_CREST_TABOR},
               {40.0, NAN, PO_HOLDS_UNKNOWN, PO_ASSUMES_FULL_DISC},
               {4.0, NAN, PO_HOLDS_NO, PO_ASSUMES_CREST_TABOR}};
  const po_request request = request_of_tabor(CASES[_i].tabor, 0.02);
  po_result result = result_of(CASES[_i].full_disc);
  ck_assert_int_eq(PO_COMPANION_JKR.theories(&request, &result), PO_OK);
  const po_theory_row *jkr = &result.theories[PO_THEORY_JKR];
  ck_assert_int_eq(jkr->holds, CASES[_i].holds);
  ck_assert_int_eq(jkr->decided_by, CASES[_i].decided_by);
  if (jkr->decided_by == PO_ASSUMES_CREST_TABOR)
    ck_assert_double_eq_tol(
        jkr->number, CASES[_i].tabor / cbrt(1.0 + 100.0 * 0.02 * pow(2.0 * M_PI / 8.0, 2)), 1e-12);
  po_result_clear(&result);
}
END_TEST

/* Kesari-Lew assumes many waves in the contact, too: here too few, while the disc is unknown. */
START_TEST(one_that_fails_counts_beside_one_that_is_unknown) {
  const po_request request = request_of_tabor(40.0, 0.02);
  po_result result = result_of(NAN);
  result.pull_off.contact_radius = 12.0;
  ck_assert_int_eq(PO_COMPANION_JKR.theories(&request, &result), PO_OK);
  const po_theory_row *row = &result.theories[PO_THEORY_KESARI_LEW];
  ck_assert_int_eq(row->holds, PO_HOLDS_NO);
  ck_assert_int_eq(row->decided_by, PO_ASSUMES_WAVES);
  ck_assert_double_eq(row->number, 1.5);
  po_result_clear(&result);
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, deviation_and_its_error);
  tcase_add_loop_test(tests, assumption_that_decides, 0, 5);
  tcase_add_test(tests, one_that_fails_counts_beside_one_that_is_unknown);
}

int main(void) {
  return run_case("beside", add);
}
