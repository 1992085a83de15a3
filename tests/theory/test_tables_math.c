/* Elementary, special and Struve functions and the kernel against every row of their reference
 * tables. */
#include <float.h>
#include <gsl/gsl_errno.h>
#include <stdbool.h>
#include <stdlib.h>

#include "../unit/run.h"
#include "po_dd.h"
#include "po_elementary.h"
#include "po_kernel.h"
#include "po_special.h"
#include "table.h"

/* The tolerances stated in po_special.h and po_kernel.h; 4 ulp. */
static const double STRUVE_ACCURACY = 1e-14, KERNEL_ACCURACY = 4 * DBL_EPSILON;

ROWS_TEST(struve_agrees_with_the_table, "struve.csv", "Struve functions", 67, 2) {
  static const char *const COLUMNS[] = {"h0", "h1"};
  for (int n = 0; n < 2; ++n) {
    const double x = table_number(t, row, "x"), h = table_number(t, row, COLUMNS[n]);
    table_compare(t, row, COLUMNS[n], po_struve(n, x), STRUVE_ACCURACY * fmax(1.0, fabs(h)));
  }
}

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

ROWS_TEST(kernel_agrees_with_the_table, "kernel.csv", "kernel", 19, 1) {
  if (table_leaves_out(t, row, "point"))
    return;
  const decimal r = decimal_of(table_word(t, row, "r")), s = decimal_of(table_word(t, row, "s1"));
  const double value = table_number(t, row, "value"), sum = decimal_sum(r, s, 1);
  table_compare(t, row, "value", po_kernel(sum, decimal_sum(r, s, -1)), KERNEL_ACCURACY * value);
}

ROWS_TEST(kernel_row_agrees_with_the_table, "kernel.csv", "kernel of a row of radii", 18, 1) {
  if (table_leaves_out(t, row, "point"))
    return;
  const double r = table_number(t, row, "r"), s = table_number(t, row, "s1");
  if (r == s) { /* equal doubles: po_kernel_row does not accept them */
    t->left_out += 1;
    return;
  }
  const double value = table_number(t, row, "value"), three[] = {0.5 * s + 0.1, s, 7 * s + 3};
  double kernel[3];
  po_kernel_row(r, three, NULL, 3, kernel);
  /* a radius is rounded by half an ulp; this changes r - s, and G by its slope
   * 4/(pi (r + s) |r - s|) */
  const double inherited = DBL_EPSILON * fmax(r, s) * 4 / (M_PI * (r + s) * fabs(r - s));
  table_compare(t, row, "value", kernel[1], KERNEL_ACCURACY * value + inherited);
}

/* A function and its accuracy: in units in the last place (at most 0.95), or relative. */
static const struct {
  const char *name;
  double (*one)(double), (*pair)(double, double), (*triple)(double, double, double);
  double ulp, relative;
} FUNCTIONS[] = {
    {"exp", po_exp, .ulp = 0.95},
    {"expm1", po_expm1, .ulp = 0.95},
    {"log", po_log, .ulp = 0.95},
    {"log1p", po_log1p, .ulp = 0.95},
    {"log10", po_log10, .ulp = 0.95},
    {"pow", .pair = po_pow, .ulp = 0.95},
    {"sin", po_sin, .ulp = 0.95},
    {"cos", po_cos, .ulp = 0.95},
    {"sinpi", po_sinpi, .ulp = 0.95},
    {"cospi", po_cospi, .ulp = 0.95},
    {"atan2", .pair = po_atan2, .ulp = 0.95},
    {"sinh", po_sinh, .ulp = 0.95},
    {"cosh", po_cosh, .ulp = 0.95},
    {"asinh", po_asinh, .ulp = 0.95},
    {"cbrt", po_cbrt, .ulp = 0.95},
    {"hypot", .pair = po_hypot, .ulp = 0.95},
    {"gamma", po_gamma, .relative = 2e-16},
    {"beta", .pair = po_beta, .relative = 2e-16},
    {"beta_incomplete", .triple = po_beta_incomplete, .relative = 1e-14},
    {"bessel_i0_scaled", po_bessel_i0_scaled, .relative = 2e-15},
};

/* The same in twice the precision, to 1e-29 of the scale that po_dd.h states. */
static po_dd two_of(const char *name, double a, double b, double *scale) {
  const po_dd x = po_dd_of(a);
  po_dd value = po_dd_of((double)NAN);
  *scale = 1.0;
  if (strcmp(name, "exp") == 0)
    value = po_dd_exp(x);
  else if (strcmp(name, "log") == 0)
    value = po_dd_log(x);
  else if (strcmp(name, "pow") == 0)
    value = po_dd_pow(x, po_dd_of(b));
  else if (strcmp(name, "sinpi") == 0)
    value = po_dd_sinpi(x);
  if (name[0] == 'e' || name[0] == 'p')
    *scale = fabs(value.high) * (1.0 + fabs(b) + fabs(po_log(value.high)));
  if (name[0] == 'l')
    *scale = fmax(1.0, fabs(value.high));
  return value;
}

ROWS_TEST(functions_of_twice_the_precision_agree_with_the_table, "elementary.csv",
          "functions in twice the precision", 112, 1) {
  double scale;
  const char *name = table_word(t, row, "function");
  const po_dd got = two_of(name, table_number(t, row, "a"), table_number(t, row, "b"), &scale);
  if (isnan(got.high)) {
    t->left_out += 1; /* the count of the others tells that none of these is NaN */
    return;
  }
  const double value = table_number(t, row, "value"), rest = table_number(t, row, "rest");
  table_judge(t, row, name, fabs((got.high - value) + (got.low - rest)), 1e-29 * scale);
}

/* Products, quotients, sums and roots of numbers with both parts, beside the exact relation. */
TEST(arithmetic_in_twice_the_precision) {
  const double unit = 0x1p-102;
  for (int k = 1; k <= 1000; ++k) {
    const po_dd a = po_dd_log(po_dd_of(1.0 + 0.37 * k)), b = po_dd_exp(po_dd_of(-0.013 * k));
    const po_dd quotient = po_dd_divide(a, b), root = po_dd_sqrt(a);
    const po_dd back = po_dd_subtract(po_dd_multiply(quotient, b), a);
    const po_dd square = po_dd_subtract(po_dd_multiply(root, root), a);
    const po_dd sum = po_dd_subtract(po_dd_subtract(po_dd_add(a, b), a), b);
    ck_assert_double_le(fabs(back.high), 4 * unit * a.high);
    ck_assert_double_le(fabs(square.high), 4 * unit * a.high);
    ck_assert_double_le(fabs(sum.high), 4 * unit * (a.high + b.high));
    ck_assert_double_le(fabs(quotient.low), 0x1p-53 * quotient.high);
  }
}

/* What is outside the domain, at its ends, infinite or NaN; and the sign of zero. */
TEST(ends_of_the_domains) {
  const double inf = (double)INFINITY;
  ck_assert(isnan(po_log(-1)) && isnan(po_log1p(-2)) && isnan(po_pow(-1, 0.5)));
  ck_assert(isnan(po_sin(inf)) && isnan(po_cos(inf)) && isnan(po_sinpi(inf)));
  ck_assert(isnan(po_gamma(0)) && isnan(po_gamma(-1.5)) && isnan(po_beta(0, 1)));
  double (*const all[])(double) = {po_exp,   po_expm1, po_log,  po_log1p, po_log10, po_sin, po_cos,
                                   po_sinpi, po_cospi, po_sinh, po_cosh,  po_asinh, po_cbrt};
  for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
    ck_assert(isnan(all[k]((double)NAN)));
  ck_assert(po_log(0) == -inf && po_log(inf) == inf && po_log(1) == 0 && po_log1p(-1) == -inf);
  ck_assert(po_exp(-inf) == 0 && po_exp(inf) == inf && po_exp(800) == inf && po_exp(-800) == 0);
  ck_assert(po_exp(0) == 1 && po_expm1(-inf) == -1 && po_expm1(inf) == inf);
  ck_assert(po_pow(0, 2) == 0 && po_pow(0, -1) == inf && po_pow(2, 0) == 1 && po_pow(4, 0.5) == 2);
  ck_assert(po_pow(inf, 1) == inf && po_pow(inf, -1) == 0 && po_pow(2, 2000) == inf);
  ck_assert(po_sinpi(1) == 0 && po_cospi(0.5) == 0 && po_cospi(1) == -1 && po_sinpi(0.5) == 1);
  ck_assert(po_sinh(inf) == inf && po_sinh(-inf) == -inf && po_cosh(-inf) == inf);
  ck_assert(po_cbrt(-8) == -2 && po_hypot(inf, 1) == inf && po_asinh(-inf) == -inf);
  ck_assert(signbit(po_sin(-0.0)) && signbit(po_expm1(-0.0)) && signbit(po_sinh(-0.0)));
  ck_assert(po_atan2(0, -1) == M_PI && po_atan2(0, 1) == 0 && po_atan2(1, 0) == M_PI_2);
  ck_assert(po_beta_incomplete(2, 3, 0) == 0);
  ck_assert_double_eq_tol(po_beta_incomplete(2, 3, 1), po_beta(2, 3), 1e-15);
}

/* The value of a row is the sum of two doubles. */
ROWS_TEST(functions_agree_with_the_table, "elementary.csv", "elementary and special functions", 437,
          1) {
  const char *name = table_word(t, row, "function");
  for (size_t f = 0; f < sizeof FUNCTIONS / sizeof *FUNCTIONS; ++f) {
    if (strcmp(name, FUNCTIONS[f].name) != 0)
      continue;
    const double a = table_number(t, row, "a"), b = table_number(t, row, "b");
    const double got = FUNCTIONS[f].one    ? FUNCTIONS[f].one(a)
                       : FUNCTIONS[f].pair ? FUNCTIONS[f].pair(a, b)
                                           : FUNCTIONS[f].triple(a, b, table_number(t, row, "c"));
    const double value = table_number(t, row, "value"), rest = table_number(t, row, "rest");
    const double unit = nextafter(fabs(value), INFINITY) - fabs(value);
    const double allowed =
        FUNCTIONS[f].ulp > 0 ? FUNCTIONS[f].ulp * unit : FUNCTIONS[f].relative * fabs(value);
    table_judge(t, row, name, fabs((got - value) - rest), allowed);
  }
}

static void silence_gsl(void) {
  gsl_set_error_handler_off();
}
FIXTURE(silence_gsl, NULL)
