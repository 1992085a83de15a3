/* Struve functions and the kernel against every row of their reference tables. */
#include <float.h>
#include <gsl/gsl_errno.h>
#include <stdbool.h>
#include <stdlib.h>

#include "../unit/run.h"
#include "po_kernel.h"
#include "po_struve.h"
#include "table.h"

/* The tolerances stated in po_struve.h and po_kernel.h; 4 ulp. */
static const double STRUVE_ACCURACY = 1e-14, KERNEL_ACCURACY = 4 * DBL_EPSILON;

START_TEST(struve_agrees_with_the_table) {
  static const char *const COLUMNS[] = {"h0", "h1", "h2"};
  table t = table_open("struve.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row)
    for (int n = 0; n < 3; ++n) {
      const double x = table_number(&t, row, "x"), h = table_number(&t, row, COLUMNS[n]);
      table_compare(&t, row, COLUMNS[n], po_struve(n, x), STRUVE_ACCURACY * fmax(1.0, fabs(h)));
    }
  table_close(&t, "Struve functions", 67, 3);
}
END_TEST

START_TEST(difference_agrees_with_the_table) {
  static const char *const COLUMNS[] = {"h0_minus_y0", "h1_minus_y1", "h2_minus_y2"};
  table t = table_open("struve.csv");
  for (size_t row = 0; row < t.csv.row_count; ++row)
    for (int n = 0; n < 3; ++n) {
      const double x = table_number(&t, row, "x"), d = table_number(&t, row, COLUMNS[n]);
      table_compare(&t, row, COLUMNS[n], po_struve_minus_bessel(n, x),
                    STRUVE_ACCURACY * fmax(1.0, fabs(d)));
    }
  table_close(&t, "Struve minus Bessel functions", 67, 3);
}
END_TEST

/* An exact decimal number, mantissa * 10^exponent, of up to 18 digits. */
typedef struct {
  long long mantissa;
  int exponent;
} decimal;

static decimal decimal_of(const char *text) {
  decimal d = {0, 0};
  bool fraction = false;
  for (; *text && *text != 'e'; ++text) {
    fraction = fraction || *text == '.';
    if (*text != '.') {
      d.mantissa = 10 * d.mantissa + (*text - '0');
      d.exponent -= fraction;
    }
  }
  if (*text == 'e')
    d.exponent += (int)strtol(text + 1, NULL, 10);
  return d;
}

/* a + sign b from the decimal numbers: r and s1 of a row may round to the same double. */
static double decimal_sum(decimal a, decimal b, int sign) {
  for (; a.exponent > b.exponent; --a.exponent)
    a.mantissa *= 10;
  for (; b.exponent > a.exponent; --b.exponent)
    b.mantissa *= 10;
  return (double)((long double)(a.mantissa + sign * b.mantissa) * powl(10.0L, a.exponent));
}

START_TEST(kernel_agrees_with_the_table) {
  table t = table_open("kernel.csv");
  size_t points = 0;
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    if (strcmp(table_word(&t, row, "kind"), "point") != 0)
      continue;
    const decimal r = decimal_of(table_word(&t, row, "r")),
                  s = decimal_of(table_word(&t, row, "s1"));
    const double value = table_number(&t, row, "value"), sum = decimal_sum(r, s, 1);
    table_compare(&t, row, "value", po_kernel(sum, decimal_sum(r, s, -1)), KERNEL_ACCURACY * value);
    ++points;
  }
  t.csv.row_count = points;
  table_close(&t, "kernel", 19, 1);
}
END_TEST

START_TEST(kernel_row_agrees_with_the_table) {
  table t = table_open("kernel.csv");
  size_t points = 0;
  for (size_t row = 0; row < t.csv.row_count; ++row) {
    if (strcmp(table_word(&t, row, "kind"), "point") != 0)
      continue;
    const double r = table_number(&t, row, "r"), s = table_number(&t, row, "s1");
    if (r == s) /* equal doubles: po_kernel_row does not accept them */
      continue;
    const double value = table_number(&t, row, "value"), three[] = {0.5 * s + 0.1, s, 7 * s + 3};
    double kernel[3];
    po_kernel_row(r, three, 3, kernel);
    /* a radius is rounded by half an ulp; this changes r - s, and G by its slope
     * 4/(pi (r + s) |r - s|) */
    const double inherited = DBL_EPSILON * fmax(r, s) * 4 / (M_PI * (r + s) * fabs(r - s));
    table_compare(&t, row, "value", kernel[1], KERNEL_ACCURACY * value + inherited);
    ++points;
  }
  t.csv.row_count = points;
  table_close(&t, "kernel of a row of radii", 18, 1);
}
END_TEST

static void add(TCase *tests) {
  gsl_set_error_handler_off();
  tcase_add_test(tests, struve_agrees_with_the_table);
  tcase_add_test(tests, difference_agrees_with_the_table);
  tcase_add_test(tests, kernel_agrees_with_the_table);
  tcase_add_test(tests, kernel_row_agrees_with_the_table);
}

int main(void) {
  return run_case("tables_math", add);
}
