/* Struve functions against mpmath, published values, and identities; the root finder. */
#include <math.h>

#include "po_root.h"
#include "po_special.h"
#include "run.h"

/* mpmath.struveh(n, x) with 40 digits, printed with 20: x, H0, H1 */
static const double TABLE[][3] = {
    {1e-8, 6.3661977236758134932e-9, 2.1220659078919378849e-17},
    {3.7e-5, 0.000023554931574017541679, 2.9051082276389230218e-10},
    {0.0123, 0.0078302915715038226917, 0.000032104411313538384078},
    {0.385, 0.24108583534271332619, 0.03114481403035959067},
    {1.0, 0.56865662704828795099, 0.19845733620194439894},
    {2.385, 0.75340601643884562235, 0.81738321548568339445},
    {4.75, -0.13181478751963875074, 0.89150658662128646772},
    {7.0, 0.063382961188815946737, 0.34630573167866372618},
    {8.999, 0.31998780240537613603, 0.7483056683803820128},
    {9.0, 0.31987599811408866644, 0.74854243745107710333},
    {9.5, 0.2375406397318753185, 0.84664854642567359993},
    {11.3, -0.15318008125515009712, 0.74444160231150364268},
    {13.0, -0.029513265588763400047, 0.43024348474243655567},
    {17.25, -0.094052300572746519454, 0.7756200130536824997},
    {23.85, -0.11651380130529005456, 0.71343944366294706992},
    {33.3, 0.14199810651609067436, 0.5756916221837908002},
    {50.75, -0.020915909429363451736, 0.52964707016131835775},
    {77.125, 0.081608856018589643902, 0.58359953283349929466},
    {123.456, -0.0053955144239347531696, 0.70764944373150778413},
    {385.2, 0.038591269440834437895, 0.61969438905289995549},
    {1000.5, 0.016654275950501048131, 0.61714185091178329338},
    {2385.0, 0.0043766146738735515504, 0.65243330407386872428},
    {7654.321, 0.0053514977892019334887, 0.62917593308079320596},
    {1e4, 0.0037114675355867443059, 0.6437161214863153709},
};
enum { TABLE_COUNT = sizeof TABLE / sizeof *TABLE };

LOOP_TEST(struve_agrees_with_mpmath, 0, TABLE_COUNT) {
  const double x = TABLE[_i][0];
  for (int n = 0; n < 2; ++n) {
    const double expected = TABLE[_i][n + 1];
    ck_assert_double_eq_tol(po_struve(n, x), expected, 2e-15 * fmax(1.0, fabs(expected)));
    if (x <= 2.5) /* before the first zero the relative accuracy is the same */
      ck_assert_double_eq_tol(po_struve(n, x), expected, 1e-15 * fabs(expected));
  }
}

/* Abramowitz and Stegun, table 12.1; MacLeod, TOMS 757. */
TEST(struve_agrees_with_published_tables) {
  ck_assert_double_eq_tol(po_struve(1, 2.0), 0.6467637282835622, 1e-15);
  ck_assert_double_eq_tol(po_struve(1, 9.0), 0.7485424374510771033, 1e-15);
}

TEST(struve_series_and_integral_agree) {
  const double below = 9.0, above = nextafter(9.0, 10.0);
  for (int n = 0; n < 2; ++n)
    ck_assert_double_eq_tol(po_struve(n, below), po_struve(n, above), 5e-15);
}

LOOP_TEST(derivative_of_order_zero_is_known, 0, TABLE_COUNT) { /* H0' = 2/pi - H1 */
  const double x = TABLE[_i][0];
  if (x < 1e-2 || x > 1e3)
    return;
  const double h = 1e-3 * fmin(1.0, x);
  const double slope = (8.0 * (po_struve(0, x + h) - po_struve(0, x - h)) -
                        (po_struve(0, x + 2.0 * h) - po_struve(0, x - 2.0 * h))) /
                       (12.0 * h);
  ck_assert_double_eq_tol(slope, M_2_PI - po_struve(1, x), 1e-14 / h + h * h * h * h);
}

TEST(outside_the_domain_the_result_is_nan) {
  ck_assert(isnan(po_struve(0, -1e-300)));
  ck_assert(isnan(po_struve(1, NAN)));
  ck_assert(isnan(po_struve(2, 1.0)));
  for (int n = 0; n < 2; ++n)
    ck_assert_double_eq(po_struve(n, 0.0), 0.0);
}

static double steep(double x, const void *data) {
  return pow(x, 9.0) - *(const double *)data;
}

TEST(root_is_found) {
  const double value = 2.385e-40;
  ck_assert_double_eq_tol(po_root(steep, &value, 1e-9, 1e3) / pow(value, 1.0 / 9.0), 1.0, 1e-15);
  ck_assert_double_eq_tol(po_root(steep, &value, 1e3, -2.0) / pow(value, 1.0 / 9.0), 1.0, 1e-15);
  ck_assert(isnan(po_root(steep, &value, 1.0, 2.0)));
}
