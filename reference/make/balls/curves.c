/* Curves of equilibria as power series about a parameter x: the contact radius a of JKR theory, or
 * the angle theta = arccos(a/c) of Maugis-Dugdale. One function for a curve gives the values, the
 * derivatives, and the integrand of the work, which is needed in the complex plane. */
#include "balls.h"

void curve_init(curve *c) {
  arb_init(c->modulus), arb_init(c->work), arb_init(c->first), arb_init(c->second);
  arb_init(c->low), arb_init(c->high);
}

void curve_clear(curve *c) {
  arb_clear(c->modulus), arb_clear(c->work), arb_clear(c->first), arb_clear(c->second);
  arb_clear(c->low), arb_clear(c->high);
}

/* Whether the real part of the constant term is positive: roots and powers are analytic there. */
static bool is_right(const acb_poly_t x) {
  acb_t start;
  acb_init(start);
  acb_poly_get_coeff_acb(start, x, 0);
  const bool right = arb_is_positive(acb_realref(start));
  acb_clear(start);
  return right;
}

static void times_real(acb_poly_t result, const acb_poly_t x, const arb_t factor) {
  acb_t complex;
  acb_init(complex);
  acb_set_arb(complex, factor);
  acb_poly_scalar_mul(result, x, complex, BITS);
  acb_clear(complex);
}

/* C x^n: g = kappa C x^n, press = kappa C n/(n+1) x^(n+1), kappa = (sqrt(pi)/2) n Gamma(n/2)/
 * Gamma((n+1)/2); C is c->first, n is c->second. */
bool power(acb_poly_t g, acb_poly_t press, const acb_poly_t x, const curve *c, slong length) {
  arb_t factor, other, next;
  acb_t exponent;
  arb_init(factor), arb_init(other), arb_init(next), acb_init(exponent);
  arb_mul_2exp_si(other, c->second, -1);
  arb_gamma(factor, other, BITS);       /* Gamma(n/2) */
  arb_add_ui(next, c->second, 1, BITS); /* n + 1 */
  arb_mul_2exp_si(other, next, -1);
  arb_rgamma(other, other, BITS);
  arb_mul(factor, factor, other, BITS);
  arb_const_sqrt_pi(other, BITS);
  arb_mul(factor, factor, other, BITS);
  arb_mul(factor, factor, c->second, BITS);
  arb_mul_2exp_si(factor, factor, -1);
  arb_mul(factor, factor, c->first, BITS); /* kappa C */
  acb_set_arb(exponent, c->second);
  acb_poly_pow_acb_series(g, x, exponent, length, BITS);
  times_real(g, g, factor);
  acb_poly_mullow(press, g, x, length, BITS);
  arb_div(factor, c->second, next, BITS);
  times_real(press, press, factor);
  arb_clear(factor), arb_clear(other), arb_clear(next), acb_clear(exponent);
  return is_right(x);
}

/* R - sqrt(R^2 - r^2): g = x artanh(x/R), press = (R^2/2) [(1 + u^2) artanh u - u], u = x/R;
 * R is c->first. */
bool exact_sphere(acb_poly_t g, acb_poly_t press, const acb_poly_t x, const curve *c,
                  slong length) {
  acb_poly_t u, above, below;
  arb_t factor;
  acb_poly_init(u), acb_poly_init(above), acb_poly_init(below), arb_init(factor);
  arb_inv(factor, c->first, BITS);
  times_real(u, x, factor);
  acb_poly_add_si(above, u, 1, BITS);
  acb_poly_neg(below, u);
  acb_poly_add_si(below, below, 1, BITS);
  const bool analytic = is_right(above) && is_right(below);
  acb_poly_log_series(above, above, length, BITS);
  acb_poly_log_series(below, below, length, BITS);
  acb_poly_sub(above, above, below, BITS);
  acb_poly_scalar_mul_2exp_si(above, above, -1); /* artanh u */
  acb_poly_mullow(g, x, above, length, BITS);
  acb_poly_mullow(press, u, u, length, BITS);
  acb_poly_add_si(press, press, 1, BITS);
  acb_poly_mullow(press, press, above, length, BITS);
  acb_poly_sub(press, press, u, BITS);
  arb_mul(factor, c->first, c->first, BITS);
  arb_mul_2exp_si(factor, factor, -1);
  times_real(press, press, factor);
  acb_poly_clear(u), acb_poly_clear(above), acb_poly_clear(below), arb_clear(factor);
  return analytic;
}

/* t (sqrt(r^2 + b^2) - b): g = t x arctan(x/b), press = (t/2) [(x^2 - b^2) arctan(x/b) + b x];
 * t is c->first, b is c->second. arctan is analytic in the right half-plane. */
bool hyperboloid(acb_poly_t g, acb_poly_t press, const acb_poly_t x, const curve *c, slong length) {
  acb_poly_t angle, part;
  arb_t factor;
  acb_t square;
  acb_poly_init(angle), acb_poly_init(part), arb_init(factor), acb_init(square);
  arb_inv(factor, c->second, BITS);
  times_real(angle, x, factor);
  acb_poly_atan_series(angle, angle, length, BITS);
  acb_poly_mullow(g, x, angle, length, BITS);
  times_real(g, g, c->first);
  acb_poly_mullow(press, x, x, length, BITS);
  arb_mul(acb_realref(square), c->second, c->second, BITS);
  acb_poly_set_acb(part, square);
  acb_poly_sub(press, press, part, BITS);
  acb_poly_mullow(press, press, angle, length, BITS);
  times_real(part, x, c->second);
  acb_poly_add(press, press, part, BITS);
  times_real(press, press, c->first);
  acb_poly_scalar_mul_2exp_si(press, press, -1);
  acb_poly_clear(angle), acb_poly_clear(part), arb_clear(factor), acb_clear(square);
  return is_right(x);
}

/* JKR theory: D = g - sqrt(2 pi w a/E*), P = 2 E* press - 2 E* a sqrt(2 pi w a/E*), a = x. */
bool jkr(acb_poly_t approach, acb_poly_t load, const acb_poly_t x, const curve *c, slong length) {
  acb_poly_t root;
  arb_t factor;
  acb_poly_init(root), arb_init(factor);
  const bool analytic = c->profile(approach, load, x, c, length) && is_right(x);
  arb_const_pi(factor, BITS);
  arb_mul_2exp_si(factor, factor, 1);
  arb_mul(factor, factor, c->work, BITS);
  arb_div(factor, factor, c->modulus, BITS);
  times_real(root, x, factor);
  acb_poly_sqrt_series(root, root, length, BITS);
  acb_poly_sub(approach, approach, root, BITS);
  acb_poly_mullow(root, root, x, length, BITS);
  acb_poly_sub(load, load, root, BITS);
  arb_mul_2exp_si(factor, c->modulus, 1);
  times_real(load, load, factor);
  acb_poly_clear(root), arb_clear(factor);
  return analytic;
}

/* The end C of the tension: alpha C^2 + beta C = 1, alpha = (lambda/2) [s k + (1 - 2 k^2) theta],
 * beta = (4 lambda^2/3) [theta s + k - 1], s and k sine and cosine of theta; lambda is c->first.
 * Therefore C = 2/(beta + sqrt(beta^2 + 4 alpha)). Units of Maugis (1992), end = a/cos(theta). */
static bool end_of_tension(acb_poly_t end, const acb_poly_t theta, const acb_poly_t s,
                           const acb_poly_t k, const curve *c, slong length) {
  acb_poly_t alpha, beta;
  arb_t factor;
  acb_poly_init(alpha), acb_poly_init(beta), arb_init(factor);
  acb_poly_mullow(alpha, k, k, length, BITS);
  acb_poly_scalar_mul_2exp_si(alpha, alpha, 1);
  acb_poly_neg(alpha, alpha);
  acb_poly_add_si(alpha, alpha, 1, BITS);
  acb_poly_mullow(alpha, alpha, theta, length, BITS);
  acb_poly_mullow(beta, s, k, length, BITS);
  acb_poly_add(alpha, alpha, beta, BITS);
  arb_mul_2exp_si(factor, c->first, 1); /* 4 alpha has the factor 2 lambda */
  times_real(alpha, alpha, factor);
  acb_poly_mullow(beta, theta, s, length, BITS);
  acb_poly_add(beta, beta, k, BITS);
  acb_poly_add_si(beta, beta, -1, BITS);
  arb_mul(factor, c->first, c->first, BITS);
  arb_mul_2exp_si(factor, factor, 2);
  arb_div_ui(factor, factor, 3, BITS);
  times_real(beta, beta, factor);
  acb_poly_mullow(end, beta, beta, length, BITS);
  acb_poly_add(end, end, alpha, BITS);
  bool analytic = is_right(end);
  acb_poly_sqrt_series(end, end, length, BITS);
  acb_poly_add(end, end, beta, BITS);
  acb_poly_scalar_mul_2exp_si(end, end, -1);
  acb_poly_inv_series(end, end, length, BITS);
  acb_poly_clear(alpha), acb_poly_clear(beta), arb_clear(factor);
  return analytic;
}

/* Maugis-Dugdale for a sphere, theta = x: D = C^2 k^2 - (4/3) lambda C s,
 * P = C^3 k^3 - lambda C^2 (k s + theta). */
bool maugis(acb_poly_t approach, acb_poly_t load, const acb_poly_t x, const curve *c,
            slong length) {
  acb_poly_t s, k, end, part;
  arb_t factor;
  acb_poly_init(s), acb_poly_init(k), acb_poly_init(end), acb_poly_init(part), arb_init(factor);
  acb_poly_sin_cos_series(s, k, x, length, BITS);
  const bool analytic = end_of_tension(end, x, s, k, c, length);
  acb_poly_mullow(part, k, s, length, BITS);
  acb_poly_add(part, part, x, BITS);
  acb_poly_mullow(part, part, end, length, BITS);
  acb_poly_mullow(part, part, end, length, BITS);
  times_real(part, part, c->first);
  acb_poly_mullow(k, k, end, length, BITS); /* a */
  acb_poly_mullow(approach, k, k, length, BITS);
  acb_poly_mullow(load, approach, k, length, BITS);
  acb_poly_sub(load, load, part, BITS);
  acb_poly_mullow(part, end, s, length, BITS);
  arb_mul_2exp_si(factor, c->first, 2);
  arb_div_ui(factor, factor, 3, BITS);
  times_real(part, part, factor);
  acb_poly_sub(approach, approach, part, BITS);
  acb_poly_clear(s), acb_poly_clear(k), acb_poly_clear(end), acb_poly_clear(part);
  arb_clear(factor);
  return analytic;
}

/* The end of the tension at an angle. */
void maugis_end(arb_t end, const arb_t theta, const curve *c) {
  acb_poly_t series, place, s, k;
  acb_t value;
  acb_poly_init(series), acb_poly_init(place), acb_poly_init(s), acb_poly_init(k);
  acb_init(value);
  acb_set_arb(value, theta);
  acb_poly_set_acb(place, value);
  acb_poly_sin_cos_series(s, k, place, 1, BITS);
  end_of_tension(series, place, s, k, c, 1);
  acb_poly_get_coeff_acb(value, series, 0);
  arb_set(end, acb_realref(value));
  acb_poly_clear(series), acb_poly_clear(place), acb_poly_clear(s), acb_poly_clear(k);
  acb_clear(value);
}

/* The contact radius a = c cos(theta). */
void maugis_radius(arb_t radius, const arb_t theta, const curve *c) {
  arb_t cosine;
  arb_init(cosine);
  maugis_end(radius, theta, c);
  arb_cos(cosine, theta, BITS);
  arb_mul(radius, radius, cosine, BITS);
  arb_clear(cosine);
}
