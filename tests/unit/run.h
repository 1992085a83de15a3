/* The tests of a file as a program: TEST, LOOP_TEST, TABLE_TEST and LONG_TEST begin a test like the
 * head of a function, and main runs all of them; the exit status says whether all passed. The
 * environment variable RUN_TESTS names those that are run, separated by blanks (default: all; a
 * name that no test has is an error). With RUN_FEW, those with more than four rounds are run for
 * the first, the middle and the last _i, and the long ones, whose lines others run, are not: for
 * builds in which tests are slow, and in which only the lines count that are run. */
#ifndef RUN_H
#define RUN_H

#include <check.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct {
  const TTest **test;
  const char *name;
  int begin, end;
} all_tests[100];
static size_t test_count;
static SFun before_each, after_each;

static void add_test(const TTest **test, const char *name, int begin, int end) {
  if (test_count == sizeof all_tests / sizeof *all_tests)
    abort();
  all_tests[test_count].test = test;
  all_tests[test_count].name = name;
  all_tests[test_count].begin = begin;
  all_tests[test_count++].end = end;
}

/* A test that is run for each _i from BEGIN to END - 1, for each row of a table, and once. */
#define LOOP_TEST(NAME, BEGIN, END)                                                                \
  static const TTest *NAME;                                                                        \
  __attribute__((constructor)) static void add_##NAME(void) {                                      \
    add_test(&NAME, #NAME, BEGIN, END);                                                            \
  }                                                                                                \
  START_TEST(NAME)
#define TABLE_TEST(NAME, TABLE) LOOP_TEST(NAME, 0, (int)(sizeof TABLE / sizeof *TABLE))
#define TEST(NAME) LOOP_TEST(NAME, 0, 1)
#define LONG_TEST(NAME) LOOP_TEST(NAME, 0, getenv("RUN_FEW") ? 0 : 1)

/* Functions that are called before and after each test; NULL: none. */
#define FIXTURE(BEFORE, AFTER)                                                                     \
  __attribute__((constructor)) static void set_fixture(void) {                                     \
    before_each = BEFORE;                                                                          \
    after_each = AFTER;                                                                            \
  }

static bool is_asked(const char *test) {
  char list[1000], name[200];
  snprintf(list, sizeof list, " %s ", getenv("RUN_TESTS") ? getenv("RUN_TESTS") : test);
  snprintf(name, sizeof name, " %s ", test);
  return strstr(list, name);
}

/* The number of words in RUN_TESTS; 0 without it. */
static size_t asked_count(void) {
  size_t count = 0;
  const char *list = getenv("RUN_TESTS");
  for (const char *c = list; c && *c; ++c)
    count += *c != ' ' && (c == list || c[-1] == ' ');
  return count;
}

int main(void) {
  Suite *suite = suite_create(__BASE_FILE__);
  TCase *tests = tcase_create(__BASE_FILE__);
  tcase_set_timeout(tests, 200.0);
  tcase_add_checked_fixture(tests, before_each, after_each);
  size_t found = 0;
  for (size_t k = 0; k < test_count; ++k) {
    const int begin = all_tests[k].begin, end = all_tests[k].end;
    if (!is_asked(all_tests[k].name))
      continue;
    ++found;
    if (getenv("RUN_FEW") && end - begin > 4) {
      const int few[] = {begin, (begin + end) / 2, end - 1};
      for (int i = 0; i < 3; ++i)
        tcase_add_loop_test(tests, *all_tests[k].test, few[i], few[i] + 1);
    } else
      tcase_add_loop_test(tests, *all_tests[k].test, begin, end);
  }
  suite_add_tcase(suite, tests);
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_NORMAL);
  const bool all_found = found >= asked_count();
  if (!all_found)
    fprintf(stderr, "RUN_TESTS is %s: expected names of tests of this program\n",
            getenv("RUN_TESTS"));
  const bool passed =
      all_found && srunner_ntests_run(runner) > 0 && srunner_ntests_failed(runner) == 0;
  srunner_free(runner);
  return passed ? 0 : 1;
}

#endif
