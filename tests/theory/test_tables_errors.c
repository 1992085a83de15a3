/* The error estimates of panels are not smaller than the true errors, for every row of the tables
 * of the smooth sphere (reference/feng_*.csv). */
#include "../unit/run.h"
#include "po_solve.h"
#include "table.h"

static const double TOLERANCES[] = {1e-4, 1e-7};

static void solve(double tabor, double tolerance, po_result *result) {
  po_request request = po_request_default();
  request.scene.tabor = tabor;
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = tolerance;
  ck_assert_msg(po_solve(&request, result) == PO_OK, "tabor %g: %s", tabor, result->reason);
}

TABLE_TEST(pull_off_is_within_its_stated_errors, TOLERANCES) {
  table t = table_open("feng_pull_off.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    po_result o = {0};
    solve(table_number(&t, row, "tabor"), TOLERANCES[_i], &o);
    table_compare(&t, row, "force", o.pull_off.force,
                  o.pull_off.force_error + table_number(&t, row, "force_uncertainty"));
    table_compare(&t, row, "approach", o.pull_off.approach,
                  o.pull_off.approach_error + table_number(&t, row, "approach_uncertainty"));
    /* the estimate must not be too large either: it would bound any error */
    ck_assert_double_le(o.pull_off.force_error, 100.0 * TOLERANCES[_i] * o.pull_off.force);
    po_result_clear(&o);
  }
  table_close(&t, "pull-off in units of its stated error", 26, 2);
}

TABLE_TEST(folds_are_within_their_stated_errors, TOLERANCES) {
  table t = table_open("feng_landmarks.csv");
  po_result o = {0};
  double tabor = NAN;
  size_t folds = 0, fold = 0;
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    if (strncmp(table_word(&t, row, "kind"), "jump_", 5) != 0)
      continue;
    if (table_number(&t, row, "tabor") != tabor) {
      tabor = table_number(&t, row, "tabor");
      po_result_clear(&o);
      solve(tabor, TOLERANCES[_i], &o);
      fold = 0;
    }
    ck_assert_uint_lt(fold, o.fold_count);
    const po_special_point *ours = &o.folds[fold++];
    table_compare(&t, row, "approach", ours->approach,
                  ours->approach_error + table_number(&t, row, "approach_uncertainty"));
    table_compare(&t, row, "load", ours->load,
                  ours->load_error + table_number(&t, row, "load_uncertainty"));
    ++folds;
  }
  po_result_clear(&o);
  t.csv.row_count = folds;
  table_close(&t, "folds in units of their stated error", folds, 2);
  ck_assert_uint_gt(folds, 20);
}
