/* The contact laws. */
#include "balls.h"

/* The state without load, both pull-offs and the work of a JKR contact. The profile is convex, so
 * that g' rises and the adhesion falls with a: each extremum is the only one. */
static void answer_jkr(curve *c) {
  arb_t radius, last, approach, load;
  arb_init(radius), arb_init(last), arb_init(approach), arb_init(load);
  c->at = jkr;
  the_root(last, c, LOAD_SLOPE, NULL);
  value_at(approach, load, last, c);
  answer("pull_off_radius", last);
  answer("pull_off_approach", approach);
  answer_negative("pull_off_force", load);
  the_root(last, c, APPROACH_SLOPE, NULL);
  value_at(approach, load, last, c);
  answer("grips_radius", last);
  answer("grips_approach", approach);
  answer_negative("grips_force", load);
  the_root(radius, c, LOAD, NULL);
  value_at(approach, load, radius, c);
  answer("zero_load_radius", radius);
  answer("zero_load_approach", approach);
  work_between(load, c, radius, last);
  answer("work_to_separate", load);
  arb_clear(radius), arb_clear(last), arb_clear(approach), arb_clear(load);
}

/* E* of one body with E and nu, or of two with E1, nu1, E2 and nu2. */
static void contact_modulus(arb_t modulus, const parameters *p, size_t bodies) {
  static const char *const names[][2][2] = {{{"E", "nu"}}, {{"E1", "nu1"}, {"E2", "nu2"}}};
  arb_t e, nu;
  arb_init(e), arb_init(nu);
  arb_zero(modulus);
  for (size_t k = 0; k < bodies; ++k) {
    take(e, p, names[bodies - 1][k][0]);
    take(nu, p, names[bodies - 1][k][1]);
    arb_mul(nu, nu, nu, BITS);
    arb_sub_ui(nu, nu, 1, BITS);
    arb_neg(nu, nu);
    arb_div(nu, nu, e, BITS);
    arb_add(modulus, modulus, nu, BITS);
  }
  arb_inv(modulus, modulus, BITS);
  arb_clear(e), arb_clear(nu);
}

/* Two spheres: C = 1/(2R), n = 2. */
void law_jkr(const parameters *p) {
  curve c = {.profile = power};
  arb_t one, radius;
  curve_init(&c), arb_init(one), arb_init(radius);
  contact_modulus(c.modulus, p, 2);
  take(c.work, p, "gamma1");
  take(one, p, "gamma2");
  arb_add(c.work, c.work, one, BITS);
  take(one, p, "gamma12");
  arb_sub(c.work, c.work, one, BITS);
  take(one, p, "R1");
  arb_inv(c.first, one, BITS);
  take(one, p, "R2");
  arb_inv(one, one, BITS);
  arb_add(c.first, c.first, one, BITS);
  arb_inv(c.high, c.first, BITS);
  arb_mul_2exp_si(c.first, c.first, -1);
  arb_set_ui(c.second, 2);
  arb_mul_2exp_si(c.low, c.high, -20);
  answer_jkr(&c);
  take(one, p, "D1");
  if (roots(radius, &c, APPROACH, one) < 1)
    fail("no contact at D1", "");
  value_at(one, c.low, radius, &c);
  answer("load_at_approach", c.low);
  curve_clear(&c), arb_clear(one), arb_clear(radius);
}

/* Profiles in units of w and E*. Range of the contact radius: up to `greatest`. */
static void unit_jkr(const parameters *p, curve *c, const char *first, const char *second,
                     const char *greatest) {
  arb_one(c->modulus);
  arb_one(c->work);
  if (first)
    take(c->first, p, first);
  if (second)
    take(c->second, p, second);
  arb_set_str(c->high, greatest, BITS);
  arb_mul_2exp_si(c->low, c->high, -20);
  answer_jkr(c);
  curve_clear(c);
}

/* A cone of the given half-angle between axis and flank: C = cot(angle), n = 1. */
void law_cone(const parameters *p) {
  curve c = {.profile = power};
  curve_init(&c);
  take(c.first, p, "half_angle_degrees");
  arb_div_ui(c.first, c.first, 180, BITS);
  arb_cot_pi(c.first, c.first, BITS);
  arb_one(c.second);
  unit_jkr(p, &c, NULL, NULL, "1000");
}

void law_power(const parameters *p) {
  curve c = {.profile = power};
  curve_init(&c);
  unit_jkr(p, &c, "C", "n", "1000");
}

void law_exact_sphere(const parameters *p) {
  curve c = {.profile = exact_sphere};
  curve_init(&c);
  unit_jkr(p, &c, "R", NULL, "19.9999");
}

void law_hyperboloid(const parameters *p) {
  curve c = {.profile = hyperboloid};
  curve_init(&c);
  unit_jkr(p, &c, "t", "b", "1000");
}

/* 2 pi w R. */
static void dmt_force(arb_t force, const arb_t work, const arb_t radius) {
  arb_const_pi(force, BITS);
  arb_mul_2exp_si(force, force, 1);
  arb_mul(force, force, work, BITS);
  arb_mul(force, force, radius, BITS);
}

/* P = (4/3) E* sqrt(R) D^(3/2) - 2 pi w R. Without load a^3 = (3 R/(4 E*)) 2 pi w R; the work from
 * there to D = 0 is (3/5) 2 pi w R D. */
void law_dmt(const parameters *p) {
  arb_t modulus, radius, work, force, x;
  arb_init(modulus), arb_init(radius), arb_init(work), arb_init(force), arb_init(x);
  contact_modulus(modulus, p, 2);
  take(radius, p, "R");
  take(work, p, "w");
  dmt_force(force, work, radius);
  answer("pull_off_force", force);
  arb_mul(x, force, radius, BITS);
  arb_div(x, x, modulus, BITS);
  arb_mul_ui(x, x, 3, BITS);
  arb_mul_2exp_si(x, x, -2);
  arb_root_ui(x, x, 3, BITS);
  answer("zero_load_radius", x);
  arb_mul(x, x, x, BITS);
  arb_div(x, x, radius, BITS);
  answer("zero_load_approach", x);
  arb_mul(x, x, force, BITS);
  arb_mul_ui(x, x, 3, BITS);
  arb_div_ui(x, x, 5, BITS);
  answer("work_to_separate", x);
  take(x, p, "D1");
  arb_mul(work, x, radius, BITS);
  arb_sqrt(work, work, BITS);
  arb_mul(x, x, work, BITS);
  arb_mul(x, x, modulus, BITS);
  arb_mul_2exp_si(x, x, 2);
  arb_div_ui(x, x, 3, BITS);
  arb_sub(x, x, force, BITS);
  answer("load_at_approach", x);
  arb_clear(modulus), arb_clear(radius), arb_clear(work), arb_clear(force), arb_clear(x);
}

/* A rigid punch of the radius a: the force is sqrt(8 pi w E* a^3), at the approach -force/(2 E* a);
 * the work up to there is force^2/(4 E* a) = 2 pi w a^2. */
void law_flat_punch(const parameters *p) {
  arb_t modulus, radius, work, stiffness, force;
  arb_init(modulus), arb_init(radius), arb_init(work), arb_init(stiffness), arb_init(force);
  contact_modulus(modulus, p, 1);
  take(radius, p, "a");
  take(work, p, "w");
  arb_mul(stiffness, modulus, radius, BITS);
  arb_mul_2exp_si(stiffness, stiffness, 1);
  dmt_force(force, work, radius);
  arb_mul(work, force, radius, BITS); /* 2 pi w a^2 */
  arb_mul(force, work, stiffness, BITS);
  arb_mul_2exp_si(force, force, 1);
  arb_sqrt(force, force, BITS);
  answer("pull_off_force", force);
  arb_div(force, force, stiffness, BITS);
  answer_negative("pull_off_approach", force);
  answer("work_to_separate", work);
  take(force, p, "D1");
  arb_mul(force, force, stiffness, BITS);
  answer("load_at_approach", force);
  arb_clear(modulus), arb_clear(radius), arb_clear(work), arb_clear(stiffness), arb_clear(force);
}

/* The state of lowest approach, and the work from the state in which the contact has just vanished
 * (end of the tension c = touching). Without contact the tension acts on r < c, with
 * P = -lambda (pi/2) c^2 and D = c^2/2 - e c - 2/(pi lambda), e = 8 lambda/(3 pi); D is lowest at
 * c = e. The integral of P dD is -lambda (pi/2) (c^4/4 - e c^3/3). */
static void without_contact(arb_t force, arb_t approach, arb_t work, const arb_t lambda,
                            const arb_t touching) {
  arb_t e, stress, x;
  arb_init(e), arb_init(stress), arb_init(x);
  arb_const_pi(stress, BITS);
  arb_mul(stress, stress, lambda, BITS);
  arb_mul_2exp_si(stress, stress, -1); /* lambda pi/2 */
  arb_mul(e, lambda, lambda, BITS);
  arb_mul_2exp_si(e, e, 2);
  arb_div_ui(e, e, 3, BITS);
  arb_div(e, e, stress, BITS);
  arb_mul(force, e, e, BITS);
  arb_mul_2exp_si(approach, force, -1);
  arb_inv(x, stress, BITS);
  arb_add(approach, approach, x, BITS);
  arb_neg(approach, approach);
  arb_mul(work, force, force, BITS);
  arb_div_ui(work, work, 12, BITS);
  arb_mul(force, force, stress, BITS);
  arb_mul_2exp_si(x, touching, -2);
  arb_div_ui(e, e, 3, BITS);
  arb_sub(x, x, e, BITS);
  arb_pow_ui(e, touching, 3, BITS);
  arb_addmul(work, x, e, BITS);
  arb_mul(work, work, stress, BITS);
  arb_clear(e), arb_clear(stress), arb_clear(x);
}

/* How far from theta = pi/2 roots of slopes are isolated. There a = 0, and the slopes vanish
 * because approach and load are even in a. */
static const char NEAR_END[] = "0.001";

/* Roots of a slope on the curve without its end a = 0; up to there the curvature has one sign. */
static slong folds_of_maugis(arb_t root, curve *c, vanishing what) {
  arb_t end, near;
  arb_init(end), arb_init(near);
  arb_set(end, c->high);
  arb_set_str(near, NEAR_END, BITS);
  arb_sub(c->high, end, near, BITS);
  const slong count = roots(root, c, what, NULL);
  arb_union(near, c->high, end, BITS);
  arb_set(c->high, end);
  if (count > 1 || !has_curvature(c, what, near))
    fail("Maugis-Dugdale: more than one fold", "");
  arb_clear(end), arb_clear(near);
  return count;
}

/* The state without load and that of the lowest load, which is the end of the contact, a = 0, if
 * the load falls up to there. Returned in `start` and `end`: their angles. */
static void maugis_at_load(arb_t start, arb_t end, curve *c) {
  arb_t approach, load, radius;
  arb_init(approach), arb_init(load), arb_init(radius);
  the_root(start, c, LOAD, NULL);
  value_at(approach, load, start, c);
  answer("zero_load_approach", approach);
  maugis_radius(radius, start, c);
  answer("zero_load_radius", radius);
  const slong folds = folds_of_maugis(end, c, LOAD_SLOPE);
  if (folds == 0)
    arb_set(end, c->high);
  value_at(approach, load, end, c);
  answer("pull_off_approach", approach);
  answer_negative("pull_off_force", load);
  maugis_radius(radius, end, c);
  if (folds > 0)
    answer("pull_off_radius", radius);
  arb_clear(approach), arb_clear(load), arb_clear(radius);
}

/* Maugis-Dugdale for a sphere, theta from 0.02 to pi/2. */
void law_maugis(const parameters *p) {
  curve c = {.at = maugis};
  arb_t start, end, approach, load, work;
  curve_init(&c);
  arb_init(start), arb_init(end), arb_init(approach), arb_init(load), arb_init(work);
  take(c.first, p, "lambda");
  arb_const_pi(c.high, BITS);
  arb_mul_2exp_si(c.high, c.high, -1);
  arb_set_str(c.low, "0.02", BITS);
  maugis_at_load(start, end, &c);
  if (folds_of_maugis(end, &c, APPROACH_SLOPE) == 1) {
    value_at(approach, load, end, &c);
    arb_neg(load, load);
    maugis_radius(work, end, &c);
    answer("grips_radius", work);
    work_between(work, &c, start, end);
  } else {
    work_between(start, &c, start, c.high);
    maugis_end(end, c.high, &c);
    without_contact(load, approach, work, c.first, end);
    arb_add(work, work, start, BITS);
  }
  answer("grips_force", load);
  answer("grips_approach", approach);
  answer("work_to_separate", work);
  curve_clear(&c);
  arb_clear(start), arb_clear(end), arb_clear(approach), arb_clear(load), arb_clear(work);
}
