/* Interface of the parts of sheet_balls: parameters, curves of equilibria, their points, problems.
 */
#ifndef BALLS_H
#define BALLS_H

#include <acb_calc.h>
#include <acb_poly.h>
#include <stdbool.h>
#include <stddef.h>

enum {
  BITS = 200, /* of the arithmetic */
  GOAL = 130, /* bits of a root and of an integral */
  MOST = 16   /* parameters of a problem */
};

/* The numbers of the command line, by name. */
typedef struct {
  size_t count;
  const char *name[MOST];
  arb_t value[MOST];
} parameters;

_Noreturn void fail(const char *what, const char *which);
void take(arb_t value, const parameters *p, const char *name);
void answer(const char *name, const arb_t value);
void answer_negative(const char *name, const arb_t value);

typedef struct curve curve;

/* Approach and load as series about the constant term of x, to `length` coefficients. False: some
 * function has a branch point in the ball of x, so that the result is not analytic. */
typedef bool states(acb_poly_t approach, acb_poly_t load, const acb_poly_t x, const curve *c,
                    slong length);

/* g of a profile and its press a g - int_0^a g dx, likewise. */
typedef bool transform(acb_poly_t g, acb_poly_t press, const acb_poly_t x, const curve *c,
                       slong length);

struct curve {
  states *at;
  transform *profile;  /* of JKR theory */
  arb_t modulus, work; /* E*, w */
  arb_t first, second; /* numbers of the profile, or lambda */
  arb_t low, high;     /* range of the parameter x */
};

void curve_init(curve *c);
void curve_clear(curve *c);
states jkr, maugis;
void maugis_end(arb_t end, const arb_t theta, const curve *c);
void maugis_radius(arb_t radius, const arb_t theta, const curve *c);
transform power, exact_sphere, hyperboloid;

/* What is made to vanish at a point: load or approach less a target, or their derivatives by x. */
typedef enum { LOAD, APPROACH, LOAD_SLOPE, APPROACH_SLOPE } vanishing;

slong roots(arb_t root, const curve *c, vanishing what, arb_srcptr target);
void the_root(arb_t root, const curve *c, vanishing what, arb_srcptr target);
bool has_curvature(const curve *c, vanishing what, const arb_t x);
void value_at(arb_t approach, arb_t load, const arb_t x, const curve *c);
void integral(arb_t result, acb_calc_func_t function, void *data, const arb_t from, const arb_t to);
void work_between(arb_t work, curve *c, const arb_t from, const arb_t to);

typedef void problem(const parameters *p);
problem law_jkr, law_dmt, law_maugis, law_cone, law_power, law_flat_punch, law_exact_sphere,
    law_hyperboloid, rigid_sphere, rigid_truncated, rigid_wavy;

#endif
