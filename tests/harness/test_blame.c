/* Tests of the side that is reported as probably wrong, and of the place on the branch. */
#include "made_results.h"

#include "po_explain.h"
#include "po_record.h"
#include "run.h"

static const double NONE = (double)NAN;

/* The value of one number in each reference (NAN: none), the result, the reference whose check is
 * explained, and the reported side with words of the reason. */
static const struct {
  double oracle, other, paper, obtained;
  int asked;
  const char *side, *why;
} SIDES[] = {
    {1.5, 1.503, NONE, 1.503, ORACLE, "reference", "reference/seer.csv (oracle) agrees"},
    {1.5, NONE, 1.504, 1.503, ORACLE, "reference", "reference/paper.csv (published) agrees"},
    {1.5, 1.5001, NONE, 1.503, ORACLE, "program", "seer.csv (oracle) does not agree"},
    {1.5, NONE, NONE, 1.503, ORACLE, "program", "no other reference covers this number"},
    {1.5, NONE, 1.55, 1.5001, PUBLISHED, "publication", "sage.csv (oracle) agrees"},
    {1.5, NONE, 1.50, 1.55, PUBLISHED, "program", "does not agree with the result either"},
    {NONE, NONE, 1.55, 1.5001, PUBLISHED, "publication", "an oracle would decide"},
    {1.5, NONE, NONE, 1.5002, ORACLE, "none", ""},
};

TABLE_TEST(the_side_at_fault, SIDES) {
  const double expected[] = {SIDES[_i].oracle, SIDES[_i].other, SIDES[_i].paper};
  size_t asked = 0;
  for (int which = 0; which < CHECKS; ++which) {
    if (isnan(expected[which]))
      continue;
    const size_t place = found(which, 0, "pull_off_force", "", SIDES[_i].obtained, expected[which],
                               which == PUBLISHED ? 1e-3 : 1e-10);
    if (which == SIDES[_i].asked)
      asked = place;
  }
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[asked], &blame);
  ck_assert_str_eq(blame.side, SIDES[_i].side);
  ck_assert_msg(strstr(blame.why, SIDES[_i].why) != NULL, "%s", blame.why);
}

/* A difference of 3e-3 from an oracle that is right to 1e-10, with a stated error of the result. */
static const struct {
  double stated;
  const char *side;
} ERRORS[] = {{4e-3, "tolerance"}, {2e-3, "program"}};

TABLE_TEST(a_difference_within_the_stated_errors_is_no_fault, ERRORS) {
  made_results[0].result = (po_result){
      .has_pull_off = true, .pull_off.force = 1.503, .pull_off.force_error = ERRORS[_i].stated};
  const size_t oracle = found(ORACLE, 0, "pull_off_force", "", 1.503, 1.5, 1e-10);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[oracle], &blame);
  ck_assert_str_eq(blame.side, ERRORS[_i].side);
}

/* The stored force, whether the digest is the stored one, and what is reported of a force of 1.503
 * that an oracle, 1.5 with tolerance 1e-3, contradicts. */
static const struct {
  const char *force;
  bool same;
  const char *side, *why;
} STORED[] = {
    {"1.503", true, "reference", "see git log -- reference/sage.csv"},
    {"1.5001", false, "program", "the stored value 1.5001 agree, the result differs from both"},
    {"1.504", false, "program",
     "not the stored one, 1.504, either: the program changed, and the error decreased"},
    {"1.502", false, "program", "not the stored one either: the program changed"},
    {"-", false, "program", "not the stored one either: the program changed"},
};

TABLE_TEST(the_stored_result_tells_what_changed, STORED) {
  char digest[PO_RESULT_DIGEST_LENGTH] = "0123456789abcdef";
  char *cells[] = {(char *)"0", digest,      (char *)STORED[_i].force,
                   (char *)"9", (char *)"9", (char *)"9",
                   (char *)"9", (char *)"9"};
  made_points[0].request = po_request_default();
  made_results[0].result = (po_result){.has_pull_off = true, .pull_off.force = 1.503};
  if (STORED[_i].same)
    ck_assert_int_eq(po_record_digest(&made_run, 0, digest), PO_OK);
  made_plan.pins.table = (po_csv){.cells = cells, .row_count = 1, .column_count = 8};
  const size_t oracle = found(ORACLE, 0, "pull_off_force", "", 1.503, 1.5, 1e-10);
  po_blame blame;
  po_blame_find(&made_run, &made_run.check_results.items[oracle], &blame);
  ck_assert_str_eq(blame.side, STORED[_i].side);
  ck_assert_msg(strstr(blame.why, STORED[_i].why) != NULL, "%s", blame.why);
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
