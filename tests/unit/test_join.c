/* The interpolation error between the points of a curve, on a circle, where the exact curve is
 * known. */
#include <check.h>
#include <math.h>

#include "po_branch_point.h"
#include "run.h"

static const double RADIUS = 2.385;

/* A branch that is a circle. Its energy is the integral of load d approach from angle 0 on. */
static po_branch_point at(double angle) {
  return (po_branch_point){.position = RADIUS * angle,
                           .approach = RADIUS * cos(angle),
                           .load = RADIUS * sin(angle),
                           .approach_rate = -sin(angle),
                           .load_rate = cos(angle),
                           .energy = RADIUS * RADIUS * (0.25 * sin(2.0 * angle) - 0.5 * angle)};
}

static const double TURNS[] = {0.037, 0.1, 0.29, 0.6};

TABLE_TEST(interpolation_error_on_a_circle_is_known, TURNS) {
  const double turn = TURNS[_i], begin = 0.71 + 1.3 * _i;
  const po_branch_point from = at(begin), to = at(begin + turn);
  ck_assert_double_eq_tol(po_join_sagitta(&from, &to) / (RADIUS * (1.0 - cos(0.5 * turn))), 1.0,
                          turn * turn / 12.0);
  const double exact = RADIUS * pow(turn, 4.0) / 384.0; /* half way between the points */
  ck_assert_double_eq_tol(po_join_miss(&from, &to) / exact, 1.0, 0.1);
}

/* If the energy is not the integral of the load, the estimated interpolation error is large. */
TEST(wrong_energy_increases_the_interpolation_error) {
  const po_branch_point from = at(0.4);
  po_branch_point to = at(0.5);
  const double before = po_join_miss(&from, &to);
  to.energy += 1e-4;
  ck_assert_double_gt(po_join_miss(&from, &to), 100.0 * before);
}
