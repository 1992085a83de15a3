/* Staircases at the true range from those with greater ones, of a made-up solver whose numbers
 * change with the range as those of contact edges and of crests do. */
#include <math.h>

#include "po_memory.h"
#include "po_reduced_internal.h"
#include "run.h"

enum { STEPS = 3, STRIDE = 2 };
static double noise = 1e-8; /* error of the force of the second step */
static const double RADIUS = 1e6, POWER = 4.0 / 7.0;
static unsigned solves;    /* so far */
static unsigned few_jumps; /* at the first so many ranges a jump is not made */
static unsigned no_jump;   /* at the first so many ranges a step begins at a minimum of the load */

static double of_edges(double value, double s) {
  return value * (1.0 + 1e-6 * s * s * (1.0 + 0.1 * log(s)) + 1e-9 * s * s * s);
}

static double of_crests(double value, double s) {
  return value * (1.0 + 0.01 * pow(s, POWER) + 1e-4 * pow(s, 2.0 * POWER));
}

static po_path_state state_of(double approach, double load, double (*of)(double, double),
                              double s) {
  return (po_path_state){.approach = of(approach, s) / s, .load = of(load, s)};
}

/* A crest whose gap becomes less than the height of the waves between the ranges and the true one:
 * the power changes from 0.53 to 0.86. */
static double of_low_crest(double value, double s) {
  return value * 2.0 / (pow(s, -0.52) + pow(s, -1.2));
}

static bool has_low_crest;

static double of_beginning(double value, double s) {
  return has_low_crest ? of_low_crest(value, s) : of_crests(value, s);
}

/* Lengths in the unit of the range. The first step is made at every second range only. */
static po_step step_of(int k, double s) {
  po_step step = {.jumped = solves >= no_jump, .open = k == STEPS - 1, .cycle_count = 1};
  step.preload = state_of(30.0 * k - 50.0, 0.5 * k - 0.9, of_beginning, s);
  step.preload.position = k;
  step.until = step.open ? state_of(900.0, 10.0, of_edges, s)
                         : state_of(30.0 * k - 20.0, 0.5 * k - 0.4, of_crests, s);
  step.until.position = k + 1.0;
  step.pull_off = state_of(-100.0, -1.0 - k, of_edges, s);
  step.pull_off_error = (po_path_error){1e-7, k == 1 ? noise : 1e-8};
  step.cycle = po_allocate(1, sizeof *step.cycle);
  if (!step.cycle)
    abort();
  *step.cycle = (po_cycle){
      .preload = step.preload,
      .loss = {.energy = of_crests(200.0 * (k + 1.0), s) / s, .jumps = solves >= few_jumps ? 4 : 3},
      .energy_error = 0.1 / s};
  return step;
}

static po_status solve(const po_request *request, po_kept_points *kept, po_result *o) {
  (void)kept;
  const double s = RADIUS / request->scene.radius;
  ck_assert_uint_eq(request->want, PO_WANT_PRELOAD);
  ck_assert_double_eq_tol(request->hardest, 20.0, 1e-12);
  *o = po_result_none();
  o->has_staircases = true;
  for (int test = 0; test < 2; ++test) {
    po_staircase *stairs = &o->staircase.of[test];
    stairs->control = test == PO_AT_LOAD ? PO_LOAD_CONTROL : PO_DISPLACEMENT_CONTROL;
    const int first = solves % 2 == 0;
    stairs->step = po_allocate(STEPS, sizeof *stairs->step);
    for (int k = first; k < STEPS; ++k)
      stairs->step[stairs->count++] = step_of(k, s);
    stairs->reached = stairs->step[stairs->count - 1].until;
  }
  ++solves;
  return PO_OK;
}

static po_status staircases(po_request *request, po_result *o) {
  *request = po_request_default();
  request->scene.tabor = 1e3;
  request->scene.radius = RADIUS;
  request->preload.load = 2.0;
  request->mesh.tolerance = 1e-4;
  po_ranges ranges = {.request = request, .count = 16};
  for (int k = 0; k < ranges.count; ++k)
    ranges.range[k] = 200.0 * pow(M_SQRT1_2, k);
  *o = po_result_none();
  o->has_pull_off = true;
  o->pull_off.force = of_edges(3.0, 1.0);
  o->pull_off.force_error = 1e-6;
  return po_reduced_staircases(&ranges, solve, o);
}

static void expect_number(double value, double error, double expected, double part) {
  ck_assert_double_eq_tol(value, expected, error);
  ck_assert_double_le(error, part * fabs(expected));
}

/* The limit of a step: its numbers at the range 1. */
static void expect_step(const po_step *step, int k) {
  const po_step truth = step_of(k, 1.0);
  expect_number(step->pull_off.load, step->pull_off_error.load, truth.pull_off.load, 1e-4);
  const double most = has_low_crest ? 5.0 : 1e-4;
  expect_number(step->preload.approach, step->preload_error.approach, truth.preload.approach, most);
  expect_number(step->preload.load, step->preload_error.load, truth.preload.load, most);
  expect_number(step->cycle->loss.energy, step->cycle->energy_error, truth.cycle->loss.energy,
                0.01);
  ck_assert_double_gt(step->cycle->energy_error, 0.1);
  free(truth.cycle);
}

/* The step that some ranges do not have is left out. */
TEST(steps_of_all_ranges_are_stated) {
  solves = few_jumps = no_jump = 0;
  po_request request;
  po_result o;
  ck_assert_int_eq(staircases(&request, &o), PO_OK);
  ck_assert_uint_eq(solves, PO_RANGES_OF_LIMIT);
  const po_staircase *s = &o.staircase.of[PO_AT_APPROACH];
  ck_assert(o.has_staircases && o.range.stairs.are_known);
  ck_assert_uint_eq(s->count, STEPS - 1);
  ck_assert_uint_eq(o.range.stairs.left_out, 1); /* of the last range */
  for (int k = 1; k < STEPS; ++k)
    expect_step(&s->step[k - 1], k);
  ck_assert_double_eq(s->step[0].until.approach, s->step[1].preload.approach);
  ck_assert_double_eq(o.pull_off.pressed.approach, s->step[1].preload.approach);
  ck_assert(isnan(o.pull_off.until.approach) && o.pull_off_any.is_known);
  ck_assert_double_eq(o.pull_off_any.searched.load, s->reached.load);
  po_result_clear(&o);
}

/* What the power leaves is not known from ranges where it is another. */
TEST(errors_of_a_changing_power_are_stated) {
  solves = few_jumps = no_jump = 0;
  has_low_crest = true;
  po_request request;
  po_result o;
  ck_assert_int_eq(staircases(&request, &o), PO_OK);
  for (int k = 1; k < STEPS; ++k)
    expect_step(&o.staircase.of[PO_AT_APPROACH].step[k - 1], k);
  has_low_crest = false;
  po_result_clear(&o);
}

/* Smaller ranges are solved until the last step begins with the same jumps at six of them. */
LOOP_TEST(ranges_with_other_jumps_are_followed_by_others, 0, 2) {
  solves = 0;
  few_jumps = _i == 0 ? 2 : 0;
  no_jump = _i == 1 ? 1 : 0;
  po_request request;
  po_result o;
  ck_assert_int_eq(staircases(&request, &o), PO_OK);
  ck_assert_uint_eq(solves, (unsigned)(_i == 0 ? PO_RANGES_OF_LIMIT + 2 : PO_RANGES_OF_LIMIT + 1));
  expect_step(&o.staircase.of[PO_AT_APPROACH].step[1], 2);
  po_result_clear(&o);
}

/* Without such ranges the forces are known, and the errors of what depends on the jumps are not;
 * nor is the beginning at a minimum at all ranges, past which a crest may jump at the true one. */
LOOP_TEST(errors_are_unknown_where_jumps_differ, 0, 3) {
  solves = 0;
  few_jumps = _i == 0 ? 5 : 0;
  no_jump = _i == 0 ? 0 : _i == 1 ? 5 : 100;
  po_request request;
  po_result o;
  ck_assert_int_eq(staircases(&request, &o), PO_OK);
  const po_step *step = &o.staircase.of[PO_AT_APPROACH].step[1];
  expect_number(step->pull_off.load, step->pull_off_error.load, of_edges(-3.0, 1.0), 1e-4);
  ck_assert(isnan(step->cycle->energy_error) == (_i < 2));
  ck_assert(isnan(step->preload_error.approach) == (_i > 0));
  po_result_clear(&o);
}

/* A step whose force is not known to ten tolerances is left out, and what is before it, too. */
TEST(steps_of_large_errors_are_left_out) {
  solves = few_jumps = no_jump = 0;
  po_request request;
  for (int k = 0; k < 2; ++k) {
    po_result o;
    noise = k == 0 ? 1e-4 : 1e-2;
    ck_assert_int_eq(staircases(&request, &o), PO_OK);
    ck_assert_uint_eq(o.staircase.of[PO_AT_APPROACH].count, k == 0 ? 2 : 1);
    po_result_clear(&o);
  }
}
