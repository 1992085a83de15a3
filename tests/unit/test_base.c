/* Statuses, messages and allocation. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_order.h"
#include "po_quote.h"
#include "po_status.h"
#include "run.h"

TEST(statuses_have_names_and_texts) {
  ck_assert_str_eq(po_status_name(PO_STEP_TOO_SMALL), "step_too_small");
  ck_assert_str_eq(po_status_name(PO_OK), "ok");
  ck_assert_str_eq(po_status_text(PO_BAD_INPUT), "bad input");
  ck_assert_int_lt(PO_BAD_INPUT, 0);
  ck_assert_int_gt(PO_NOT_CONVERGED, 0);
}

TEST(message_is_one_line) {
  ck_assert_int_eq(po_fail(PO_BAD_INPUT, "first\nsecond %d", 2385), PO_BAD_INPUT);
  ck_assert_str_eq(po_message(), "first second 2385");
  po_message_clear();
  ck_assert_str_eq(po_message(), "");
}

TEST(allocation_is_aligned_zeroed_and_checked) {
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

TEST(arrays_are_freed_together) {
  po_arena arrays = {0};
  for (int round = 0; round < 2; ++round) {
    double *x = po_arena_allocate(&arrays, 23, sizeof *x);
    char *text = po_arena_reserve(&arrays, 100, 1);
    ck_assert_uint_eq((uintptr_t)x % 64, 0);
    ck_assert_uint_eq((uintptr_t)text % 64, 0);
    memset(text, 1, 100);
    for (int i = 0; i < 23; ++i)
      ck_assert_double_eq(x[i], 0.0);
    ck_assert(!arrays.ran_out);
    ck_assert_ptr_null(po_arena_allocate(&arrays, SIZE_MAX / 4, 8));
    ck_assert_ptr_null(po_arena_reserve(&arrays, SIZE_MAX - 1, 1));
    ck_assert(arrays.ran_out);
    po_arena_free(&arrays);
    ck_assert(!arrays.ran_out);
  }
}

/* A text of unknown origin, and the text that is printed for it. */
static const struct {
  const char *text, *shown;
} QUOTES[] = {
    {"2.385", "2.385"},
    {"", "empty"},
    {"\033[31mred", "\\x1b[31mred"},
    {"a\nb\tc", "a\\x0ab\\x09c"},
    {"\177", "\\x7f"},
    {"gr\303\266\303\237er \347\220\203 \360\237\224\265", /* 2, 3 and 4 bytes */
     "gr\303\266\303\237er \347\220\203 \360\237\224\265"},
    {"\302\2331m", "\\xc2\\x9b1m"},     /* C1 control character: also begins an escape sequence */
    {"gr\366\337er", "gr\\xf6\\xdfer"}, /* Latin-1 */
    {"\300\257 \340\200\257", "\\xc0\\xaf \\xe0\\x80\\xaf"}, /* overlong encodings */
    {"\355\240\200", "\\xed\\xa0\\x80"},                     /* half a surrogate */
    {"\364\220\200\200", "\\xf4\\x90\\x80\\x80"},            /* above U+10FFFF */
    {"cut \347\220", "cut \\xe7\\x90"},
};

TABLE_TEST(quotes_are_safe_to_show, QUOTES) {
  char shown[PO_QUOTE_LENGTH];
  ck_assert_str_eq(po_quote(QUOTES[_i].text, shown), QUOTES[_i].shown);
  ck_assert_ptr_null(po_quote_find(shown, strlen(shown)));
  po_fail(PO_BAD_INPUT, "it is %s", shown);
  ck_assert_str_eq(po_message() + strlen("it is "), shown);
}

/* A quote of any size fits its buffer, and no character is cut in two. */
TEST(quotes_are_cut_between_characters) {
  static const char TEXT[] = "\303\266\347\220\203\033x\377";
  for (size_t size = 1; size <= 24; ++size) {
    char shown[32];
    memset(shown, 'z', sizeof shown);
    po_quote_text(TEXT, shown, size);
    ck_assert_uint_lt(strlen(shown), size);
    ck_assert_ptr_null(po_quote_find(shown, strlen(shown)));
    ck_assert_int_eq(shown[size], 'z');
  }
  char text[PO_QUOTE_BYTES + 8], shown[PO_QUOTE_LENGTH];
  memset(text, 'x', sizeof text);
  memcpy(text + PO_QUOTE_BYTES - 1, "\303\266", 3);
  ck_assert_uint_eq(strlen(po_quote(text, shown)), PO_QUOTE_BYTES - 1 + strlen(PO_QUOTE_CUT));
  ck_assert_str_eq(shown + PO_QUOTE_BYTES - 1, PO_QUOTE_CUT);
  ck_assert_str_eq(po_quote(text + 1, shown), text + 1); /* of 80 bytes */
}

TEST(an_array_grows_when_it_is_full) {
  int *array = NULL;
  size_t room = 0;
  for (int count = 0; count < 1000; ++count) {
    int *grown = po_grow(array, (size_t)count, &room, sizeof *array);
    ck_assert_ptr_nonnull(grown);
    ck_assert_uint_gt(room, (size_t)count);
    array = grown;
    array[count] = 3 * count;
  }
  for (int k = 0; k < 1000; ++k)
    ck_assert_int_eq(array[k], 3 * k);
  room = SIZE_MAX / 4;
  ck_assert_ptr_null(po_grow(array, room, &room, sizeof *array));
  ck_assert_uint_eq(room, SIZE_MAX / 4);
  ck_assert_int_eq(array[999], 2997);
  free(array);
}

/* Context: a counter of the comparisons. */
static int by_tens(const void *a, const void *b, void *context) {
  *(int *)context += 1;
  return *(const int *)a / 10 - *(const int *)b / 10;
}

LOOP_TEST(sorting_keeps_the_order_of_equal_items, 0, 61) {
  enum { MOST = 1000 };
  const int count = _i < 60 ? _i : MOST;
  int items[MOST], room[MOST], comparisons = 0;
  for (int k = 0; k < count; ++k) /* seven tens in turn, and within one ten ascending at first */
    items[k] = 10 * ((k * 5 + 3) % 7) + k / (count / 10 + 1);
  po_order_sort(items, (size_t)count, sizeof *items, by_tens, &comparisons, room);
  for (int k = 1; k < count; ++k)
    ck_assert_int_le(items[k - 1], items[k]);
  ck_assert_int_le(comparisons, 10 * MOST);
}
