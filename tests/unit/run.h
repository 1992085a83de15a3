/* Runs the tests of one Check case as a program: the exit status says whether all passed. The
 * environment variable RUN_TESTS names those that are run, separated by blanks (default: all). */
#ifndef RUN_H
#define RUN_H

#include <check.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline bool is_asked(const char *test) {
  char list[1000], name[200];
  snprintf(list, sizeof list, " %s ", getenv("RUN_TESTS") ? getenv("RUN_TESTS") : test);
  snprintf(name, sizeof name, " %s ", test);
  return strstr(list, name);
}

#undef tcase_add_loop_test
#define tcase_add_loop_test(tests, test, begin, end)                                               \
  do {                                                                                             \
    if (is_asked(#test))                                                                           \
      tcase_add_loop_test_raise_signal(tests, test, 0, begin, end);                                \
  } while (0)
#undef tcase_add_test
#define tcase_add_test(tests, test) tcase_add_loop_test(tests, test, 0, 1)

static inline int run_case(const char *name, void (*add)(TCase *tests)) {
  Suite *suite = suite_create(name);
  TCase *tests = tcase_create(name);
  tcase_set_timeout(tests, 120.0);
  add(tests);
  suite_add_tcase(suite, tests);
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_NORMAL);
  const bool passed = srunner_ntests_run(runner) > 0 && srunner_ntests_failed(runner) == 0;
  srunner_free(runner);
  return passed ? 0 : 1;
}

#endif
