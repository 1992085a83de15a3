/* Statuses, messages and allocation. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_status.h"
#include "run.h"

START_TEST(statuses_have_names_and_texts) {
  ck_assert_str_eq(po_status_name(PO_STEP_TOO_SMALL), "step_too_small");
  ck_assert_str_eq(po_status_name(PO_OK), "ok");
  ck_assert_str_eq(po_status_text(PO_BAD_INPUT), "bad input");
  ck_assert_int_lt(PO_BAD_INPUT, 0);
  ck_assert_int_gt(PO_NOT_CONVERGED, 0);
}
END_TEST

START_TEST(message_is_one_line) {
  ck_assert_int_eq(po_fail(PO_BAD_INPUT, "first\nsecond %d", 2385), PO_BAD_INPUT);
  ck_assert_str_eq(po_message(), "first second 2385");
  po_message_clear();
  ck_assert_str_eq(po_message(), "");
}
END_TEST

START_TEST(allocation_is_aligned_zeroed_and_checked) {
  double *x = po_allocate(23, sizeof *x);
  ck_assert_ptr_nonnull(x);
  ck_assert_uint_eq((uintptr_t)x % 64, 0);
  for (int i = 0; i < 23; ++i)
    ck_assert_double_eq(x[i], 0.0);
  free(x);
  ck_assert_ptr_null(po_allocate(SIZE_MAX / 4, 8)); /* the product would wrap around */
  ck_assert_ptr_nonnull(strstr(po_message(), "more than can be addressed"));
  ck_assert_ptr_null(po_resize(NULL, SIZE_MAX / 4, 8));
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, statuses_have_names_and_texts);
  tcase_add_test(tests, message_is_one_line);
  tcase_add_test(tests, allocation_is_aligned_zeroed_and_checked);
}

int main(void) {
  return run_case("base", add);
}
