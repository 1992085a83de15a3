/* Tests of the side that is reported as probably wrong, and of the place on the branch. */
#include "made_results.h"

#include "po_explain.h"
#include "run.h"

static const double NONE = (double)NAN;

/* The value of one number in each reference (NAN: none), the result, the reference whose check is
 * explained, and the reported side with words of the reason. */
static const struct {
  double oracle, other, paper, pin, obtained;
  int asked;
  const char *side, *why;
} SIDES[] = {
    {1.5, NONE, NONE, 1.5001, 1.503, ORACLE, "program", "the result differs from both"},
    {1.5, NONE, NONE, 1.504, 1.503, ORACLE, "program", "and the error decreased"},
    {1.5, NONE, NONE, 1.5001, 1.503, PIN, "program",
     "its error against reference/sage.csv increased"},
    {1.5, 1.503, NONE, NONE, 1.503, ORACLE, "reference", "reference/seer.csv (oracle) agrees"},
    {1.5, NONE, 1.504, NONE, 1.503, ORACLE, "reference", "reference/paper.csv (published) agrees"},
    {1.5, 1.5001, NONE, NONE, 1.503, ORACLE, "program", "seer.csv (oracle) does not agree"},
    {1.5, NONE, NONE, NONE, 1.503, ORACLE, "program", "no other reference covers this number"},
    {1.5, NONE, 1.55, NONE, 1.5001, PUBLISHED, "publication", "sage.csv (oracle) agrees"},
    {1.5, NONE, 1.50, NONE, 1.55, PUBLISHED, "program", "does not agree with the result either"},
    {NONE, NONE, 1.55, NONE, 1.5001, PUBLISHED, "publication", "an oracle would decide"},
    {NONE, NONE, NONE, 1.5, 1.5001, PIN, "program", "no oracle decides"},
    {1.5, NONE, NONE, 1.5002, 1.5001, PIN, "pin", "the error decreased: bless it"},
    {1.5, NONE, NONE, 1.7, 1.5001, PIN, "pin", "the pin was altered"},
    {1.5, NONE, NONE, 1.5002, 1.5002, PIN, "none", ""},
};

TABLE_TEST(the_side_at_fault, SIDES) {
  const double expected[] = {SIDES[_i].oracle, SIDES[_i].other, SIDES[_i].paper, SIDES[_i].pin};
  size_t asked = 0;
  for (int which = 0; which < WORK; ++which) {
    if (isnan(expected[which]))
      continue;
    const size_t place = found(which, 0, "pull_off_force", "", SIDES[_i].obtained, expected[which],
                               which == PUBLISHED ? 1e-3 : 1e-10);
    if (which == SIDES[_i].asked)
      asked = place;
  }
  po_judge(&made_run.check_results);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[asked], &blame);
  ck_assert_str_eq(blame.side, SIDES[_i].side);
  ck_assert_msg(strstr(blame.why, SIDES[_i].why) != NULL, "%s", blame.why);
}

/* The pins of an external solver: the solver changed, not this program. */
static const struct {
  double oracle, pin;
  const char *side, *why;
} PINS_OF_SOLVER[] = {
    {NONE, 1.5001, "solver", "the solver, its compiler or its libraries changed, and no oracle"},
    {1.5, 1.5001, "solver", "the solver changed, and its error against reference/sage.csv"},
    {1.5026, 1.5020, "pin", "the solver changed and the error decreased: bless it"},
};

TABLE_TEST(the_solver_at_fault, PINS_OF_SOLVER) {
  const po_solver solver = {.name = (char *)"mine"};
  made_plan.solver = &solver;
  if (!isnan(PINS_OF_SOLVER[_i].oracle))
    found(ORACLE, 0, "pull_off_force", "", 1.503, PINS_OF_SOLVER[_i].oracle, 1e-10);
  const size_t pin = found(PIN, 0, "pull_off_force", "", 1.503, PINS_OF_SOLVER[_i].pin, 0);
  po_judge(&made_run.check_results);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[pin], &blame);
  ck_assert_str_eq(blame.side, PINS_OF_SOLVER[_i].side);
  ck_assert_msg(strstr(blame.why, PINS_OF_SOLVER[_i].why) != NULL, "%s", blame.why);
}

/* The pin passes and the oracle fails; `checked` is the header of the pins about that oracle. */
static const struct {
  const char *checked, *side, *why;
} FROZEN[] = {
    {"reference/sage.csv sha256 0123", "tolerance", "the table has not changed"},
    {"reference/sage.csv sha256 4567", "reference", "the reference was altered"},
    {"reference/seer.csv sha256 0123", "program", "was not among the oracles"},
};

TABLE_TEST(wrong_and_frozen, FROZEN) {
  po_csv_header header = {.key = (char *)"checked 1", .value = (char *)FROZEN[_i].checked};
  made_references[PIN].table = (po_csv){.headers = &header, .header_count = 1};
  made_references[WORK].table = made_references[PIN].table;
  strcpy(made_references[ORACLE].table.digest, "0123");
  const size_t oracle = found(ORACLE, 0, "pull_off_force", "", 1.503, 1.5, 1e-10);
  found(PIN, 0, "pull_off_force", "", 1.503, 1.503, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(oracle), PO_WRONG_AND_FROZEN);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[oracle], &blame);
  ck_assert_str_eq(blame.side, FROZEN[_i].side);
  ck_assert_msg(strstr(blame.why, FROZEN[_i].why) != NULL, "%s", blame.why);
}

/* A curve has no pin; the pins of the special points of the same point are used instead. */
TEST(the_pins_of_a_point_are_used_for_its_curve) {
  const size_t curve = found(ORACLE, 0, "curve", "", 0.01, 0, 1e-10);
  found(PIN, 0, "fold_load", "jump_in-1/load", -0.7, -0.6999, 0);
  po_judge(&made_run.check_results);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[curve], &blame);
  ck_assert_str_eq(blame.side, "program");
  ck_assert_ptr_nonnull(strstr(blame.why, "not the blessed value either"));
}

static po_special_point FOLDS[] = {
    {.kind = PO_JUMP_IN, .approach = -1.6, .load = -0.7, .position = 4.1},
    {.kind = PO_JUMP_OUT, .approach = -1.7, .load = -1.0, .position = 4.6}};
static po_special_point EXTREMA[] = {
    {.kind = PO_MINIMUM, .approach = -0.9, .load = -1.67, .position = 5.9}};
static po_curve_point CURVE[] = {{.position = 0, .approach = -6, .load = -0.1},
                                 {.position = 4.3, .approach = -1.65, .load = -0.85},
                                 {.position = 5, .approach = -1.5, .load = -1.3},
                                 {.position = 7, .approach = 0.2, .load = -0.4}};

static const struct {
  double approach, load;
  const char *words;
} PLACES[] = {
    {-1.6, -0.7, "at jump_in-1"},
    {-0.9, -1.67, "at minimum-1"},
    {-5, -0.15, "before jump_in-1"},
    {-1.65, -0.8, "between jump_in-1 and jump_out-2"},
    {-1.5, -1.2, "between jump_out-2 and minimum-1"},
    {0.1, -0.5, "after minimum-1"},
};

TABLE_TEST(a_place_between_special_points, PLACES) {
  const po_result result = {.folds = FOLDS,
                            .fold_count = 2,
                            .extrema = EXTREMA,
                            .extremum_count = 1,
                            .curve = CURVE,
                            .curve_count = 4};
  char words[PO_PLACE_LENGTH];
  po_place_describe(&result, PLACES[_i].approach, PLACES[_i].load, words);
  ck_assert_str_eq(words, PLACES[_i].words);
}

TEST(a_point_is_meant_by_number_or_words) {
  const po_point point = {.id = "3", .label = (char *)"scheme=ring tabor=2.385"};
  ck_assert(po_explain_means(&point, "3"));
  ck_assert(po_explain_means(&point, "tabor=2.385"));
  ck_assert(po_explain_means(&point, "tabor=2.385 scheme=ring"));
  ck_assert(!po_explain_means(&point, "tabor=2.38"));
  ck_assert(!po_explain_means(&point, "tabor=2.385 scheme=triangle"));
  ck_assert(!po_explain_means(&point, "33"));
  ck_assert(!po_explain_means(&point, ""));
}

FIXTURE(make_run, clear_run)
