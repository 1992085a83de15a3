/* Eq 23 in C beside the table of exact rational values (reference/make/bradley.py). */
#include <check.h>
#include <float.h>
#include <math.h>

#include "po_bradley.h"
#include "po_csv.h"
#include "po_reference.h"
#include "run.h"

START_TEST(closed_form_is_the_table) {
  po_reference table;
  ck_assert_msg(po_reference_open(SOURCE_ROOT, "reference/bradley.csv", &table) == PO_OK, "%s",
                po_message());
  ck_assert_uint_eq(table.table.row_count, 170);
  for (size_t row = 0; row < table.table.row_count; ++row) {
    double approach = 0, load = 0;
    ck_assert_int_eq(po_csv_number(&table.table, row, 0, &approach), PO_OK);
    ck_assert_int_eq(po_csv_number(&table.table, row, 1, &load), PO_OK);
    const double x = 1 - approach;
    /* 4 ulp of the larger term, and what half an ulp of the approach makes of it. */
    const double larger = fmax(8 / (3 * x * x), 2 / (3 * pow(x, 8)));
    const double inherited = 8 * fabs(approach) / x;
    ck_assert_double_eq_tol(po_bradley_load(approach), load,
                            (4 + inherited) * DBL_EPSILON * larger);
  }
  po_reference_close(&table);
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, closed_form_is_the_table);
}

int main(void) {
  return run_case("bradley_table", add);
}
