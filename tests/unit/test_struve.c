/* Struve functions against mpmath, published values, and identities; the root finder. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>

#include "po_root.h"
#include "po_struve.h"
#include "run.h"

/* mpmath.struveh(n, x) with 40 digits, printed with 20: x, H0, H1, H2 */
static const double TABLE[][4] = {
    {1e-8, 6.3661977236758134932e-9, 2.1220659078919378849e-17, 4.2441318157838758667e-26},
    {3.7e-5, 0.000023554931574017541679, 2.9051082276389230218e-10, 2.1497800885088610016e-15},
    {0.0123, 0.0078302915715038226917, 0.000032104411313538384078, 7.8977079420791744519e-8},
    {0.385, 0.24108583534271332619, 0.03114481403035959067, 0.0024049438272799954265},
    {1.0, 0.56865662704828795099, 0.19845733620194439894, 0.040464636144794627909},
    {2.385, 0.75340601643884562235, 0.81738321548568339445, 0.43814336128158566578},
    {4.75, -0.13181478751963875074, 0.89150658662128646772, 1.5151672881351666707},
    {7.0, 0.063382961188815946737, 0.34630573167866372618, 1.5210076691008730136},
    {8.999, 0.31998780240537613603, 0.7483056683803820128, 1.7559679353719154026},
    {9.0, 0.31987599811408866644, 0.74854243745107710333, 1.7563260828666724969},
    {9.5, 0.2375406397318753185, 0.84664854642567359993, 1.9566637720129758328},
    {11.3, -0.15318008125515009712, 0.74444160231150364268, 2.6828741328033945922},
    {13.0, -0.029513265588763400047, 0.43024348474243655567, 2.8543902511932727927},
    {17.25, -0.094052300572746519454, 0.7756200130536824997, 3.8445429497215488073},
    {23.85, -0.11651380130529005456, 0.71343944366294706992, 5.2374681986433227906},
    {33.3, 0.14199810651609067436, 0.5756916221837908002, 6.9590574401684935135},
    {50.75, -0.020915909429363451736, 0.52964707016131835775, 10.811273182923265804},
    {77.125, 0.081608856018589643902, 0.58359953283349929466, 16.299958320065299986},
    {123.456, -0.0053955144239347531696, 0.70764944373150778413, 26.215036381252657152},
    {385.2, 0.038591269440834437895, 0.61969438905289995549, 81.706605022748990259},
    {1000.5, 0.016654275950501048131, 0.61714185091178329338, 212.29727347550626624},
    {2385.0, 0.0043766146738735515504, 0.65243330407386872428, 506.10888953143511714},
    {7654.321, 0.0053514977892019334887, 0.62917593308079320596, 1624.2921771159255602},
    {1e4, 0.0037114675355867443059, 0.6437161214863153709, 2122.0623251676265208},
};
enum { TABLE_COUNT = sizeof TABLE / sizeof *TABLE };

START_TEST(struve_agrees_with_mpmath) {
  const double x = TABLE[_i][0];
  for (int n = 0; n < 3; ++n) {
    const double expected = TABLE[_i][n + 1];
    ck_assert_double_eq_tol(po_struve(n, x), expected, 2e-15 * fmax(1.0, fabs(expected)));
    if (x <= 5.0) /* the series keeps its relative accuracy */
      ck_assert_double_eq_tol(po_struve(n, x), expected, 4e-16 * fabs(expected));
  }
}
END_TEST

/* Abramowitz and Stegun, table 12.1; MacLeod, TOMS 757. */
START_TEST(struve_agrees_with_published_tables) {
  ck_assert_double_eq_tol(po_struve(1, 2.0), 0.6467637282835622, 1e-15);
  ck_assert_double_eq_tol(po_struve(2, 3.0), 0.74238666967748318564, 1e-15);
  ck_assert_double_eq_tol(po_struve(1, 9.0), 0.7485424374510771033, 1e-15);
}
END_TEST

START_TEST(struve_minus_bessel_is_the_difference) {
  const double x = TABLE[_i][0];
  for (int n = 0; n < 3; ++n) {
    const double y = gsl_sf_bessel_Yn(n, x), h = TABLE[_i][n + 1];
    ck_assert_double_eq_tol(po_struve_minus_bessel(n, x), h - y,
                            3e-15 * fmax(1.0, fabs(h) + fabs(y)));
  }
}
END_TEST

START_TEST(struve_series_and_integral_agree) {
  const double below = 9.0, above = nextafter(9.0, 10.0);
  for (int n = 0; n < 3; ++n) {
    ck_assert_double_eq_tol(po_struve(n, below), po_struve(n, above), 5e-15);
    ck_assert_double_eq_tol(po_struve_minus_bessel(n, below), po_struve_minus_bessel(n, above),
                            5e-15);
  }
}
END_TEST

START_TEST(derivative_of_order_zero_is_known) { /* H0' = 2/pi - H1 */
  const double x = TABLE[_i][0];
  if (x < 1e-2 || x > 1e3)
    return;
  const double h = 1e-3 * fmin(1.0, x);
  const double slope = (8.0 * (po_struve(0, x + h) - po_struve(0, x - h)) -
                        (po_struve(0, x + 2.0 * h) - po_struve(0, x - 2.0 * h))) /
                       (12.0 * h);
  ck_assert_double_eq_tol(slope, M_2_PI - po_struve(1, x), 1e-14 / h + h * h * h * h);
}
END_TEST

START_TEST(outside_the_domain_the_result_is_nan) {
  ck_assert(isnan(po_struve(0, -1e-300)));
  ck_assert(isnan(po_struve(1, NAN)));
  ck_assert(isnan(po_struve(3, 1.0)));
  ck_assert(isnan(po_struve_minus_bessel(-1, 1.0)));
  ck_assert(isinf(po_struve_minus_bessel(0, 0.0)));
  for (int n = 0; n < 3; ++n)
    ck_assert_double_eq(po_struve(n, 0.0), 0.0);
}
END_TEST

static double steep(double x, const void *data) {
  return pow(x, 9.0) - *(const double *)data;
}

START_TEST(root_is_found) {
  const double value = 2.385e-40;
  ck_assert_double_eq_tol(po_root(steep, &value, 1e-9, 1e3) / pow(value, 1.0 / 9.0), 1.0, 1e-15);
  ck_assert_double_eq_tol(po_root(steep, &value, 1e3, -2.0) / pow(value, 1.0 / 9.0), 1.0, 1e-15);
  ck_assert(isnan(po_root(steep, &value, 1.0, 2.0)));
}
END_TEST

static void add(TCase *tests) {
  gsl_set_error_handler_off();
  tcase_add_loop_test(tests, struve_agrees_with_mpmath, 0, TABLE_COUNT);
  tcase_add_test(tests, struve_agrees_with_published_tables);
  tcase_add_loop_test(tests, struve_minus_bessel_is_the_difference, 0, TABLE_COUNT);
  tcase_add_test(tests, struve_series_and_integral_agree);
  tcase_add_loop_test(tests, derivative_of_order_zero_is_known, 0, TABLE_COUNT);
  tcase_add_test(tests, outside_the_domain_the_result_is_nan);
  tcase_add_test(tests, root_is_found);
}

int main(void) {
  return run_case("struve", add);
}
