#include "po_explain.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_identity.h"
#include "po_plan.h"
#include "po_recognise.h"

/* What a result and the other results of its point say. */
typedef enum {
  PASSES,
  SLACK,
  FAILED_SOLVES,
  NO_QUANTITY,
  NO_TRACE,
  NO_SCENE,
  WITHIN_ERRORS,
  TRACE_DIFFERS,
  SOLVER_FACTOR,
  SOLVER_CANNOT_SEE,
  SOLVER_PUBLISHED,
  SOLVER_ORACLE,
  SAME_AS_STORED,
  STORED_WAS_RIGHT,
  STORED_WAS_WORSE,
  STORED_WAS_OTHER,
  ORACLE_REFUTED,
  OTHER_AGREES_NOT,
  ORACLE_ALONE,
  PUBLISHED_REFUTED,
  PUBLISHED_ALONE,
  SITUATIONS
} situation;

/* The side that is probably wrong, and why. {check} is the reference of the check, {other} another
 * one and its ledger, {solver} the external solver; {number}, {factor} and {points} say for
 * themselves. */
static const struct {
  const char *side, *why;
} SENTENCES[SITUATIONS] = {
    [PASSES] = {"none", ""},
    [SLACK] = {"tolerance",
               "it is so wide that the check would not detect an error a thousand times larger: "
               "reduce it"},
    [FAILED_SOLVES] = {"solve",
                       "more solves failed than the check permits, or one has no reason; each is "
                       "listed below"},
    [NO_QUANTITY] = {"solve", "the solve did not deliver the quantity"},
    [NO_TRACE] = {"reference", "the trace of the scene failed"},
    [NO_SCENE] = {"reference",
                  "it does not contain this scene: add the scene to it, or exclude the scene from "
                  "the check by `when`"},
    [WITHIN_ERRORS] = {"tolerance",
                       "the difference is within the stated errors of both values together, "
                       "{number}: the tolerance is smaller than these"},
    [TRACE_DIFFERS] = {"program",
                       "the trace of the same scene finds another pull-off: the continuation left "
                       "its branch, or the trace missed a minimum; the greater pull-off force is "
                       "probably correct"},
    [SOLVER_FACTOR] = {"solver",
                       "the results of {solver} are the expected values times {factor} at all "
                       "{points}: a wrong unit, sign or factor"},
    [SOLVER_CANNOT_SEE] = {"none",
                           "{solver} follows stable equilibria and cannot see this value: the "
                           "check does not count"},
    [SOLVER_PUBLISHED] = {"solver",
                          "{check} is a published table: check {solver} first, and whether its "
                          "mesh is fine enough, then the publication and its digitisation"},
    [SOLVER_ORACLE] = {"solver",
                       "{check} was computed by an independent method: check {solver} first, and "
                       "whether its mesh is fine enough"},
    [SAME_AS_STORED] = {"reference",
                        "the result is the stored one to the last bit, and it was accepted when no "
                        "oracle contradicted it: the program did not change, but {check}, the "
                        "tolerance or the check did; see git log -- {check}"},
    [STORED_WAS_RIGHT] = {"program",
                          "{check} and the stored value {number} agree, the result differs from "
                          "both: the program changed"},
    [STORED_WAS_WORSE] = {"program",
                          "the result is not the stored one, {number}, either: the program "
                          "changed, and the error decreased"},
    [STORED_WAS_OTHER] = {"program", "the result is not the stored one either: the program "
                                     "changed"},
    [ORACLE_REFUTED] = {"reference", "{other} agrees with the result: check {check} first"},
    [OTHER_AGREES_NOT] = {"program", "{other} does not agree with the result either"},
    [ORACLE_ALONE] = {"program",
                      "{check} was computed by an independent method and no other reference covers "
                      "this number: check the program first, and whether its mesh is fine enough"},
    [PUBLISHED_REFUTED] = {"publication",
                           "{other} agrees with the result: the publication, or its digitisation, "
                           "is wrong"},
    [PUBLISHED_ALONE] = {"publication",
                         "only {check} covers this number: the publication, its digitisation, or "
                         "the program is wrong; an oracle would decide"},
};

/* What the words in braces stand for. */
typedef struct {
  char check[128], other[160], solver[64], number[32], factor[PO_FACTOR_LENGTH], points[32];
} word_list;

static const char *find_word(const word_list *words, const char *name, size_t length) {
  const struct {
    const char *name, *word;
  } list[] = {{"check", words->check},   {"other", words->other},   {"solver", words->solver},
              {"number", words->number}, {"factor", words->factor}, {"points", words->points}};
  for (size_t i = 0; i < sizeof list / sizeof *list; ++i)
    if (strlen(list[i].name) == length && strncmp(list[i].name, name, length) == 0)
      return list[i].word;
  return "";
}

static void compose_sentence(situation which, const word_list *words, po_blame *blame) {
  size_t length = 0;
  blame->side = SENTENCES[which].side;
  blame->why[0] = '\0';
  for (const char *c = SENTENCES[which].why; *c && length < sizeof blame->why;) {
    const size_t plain = strcspn(c, "{");
    const char *name = c + plain + (c[plain] == '{');
    const size_t named = strcspn(name, "}");
    length += (size_t)snprintf(blame->why + length, sizeof blame->why - length, "%.*s%s",
                               (int)plain, c, c[plain] ? find_word(words, name, named) : "");
    c = c[plain] ? name + named + 1 : name;
  }
}

/* Returned: the other result of the same number of the same point that says most: one that passes
 * before one that does not, an oracle before a published value; NULL if there is none. */
static const po_check_result *find_other(const po_check_results *check_results,
                                         const po_check_result *item) {
  const po_check_result *best = NULL;
  int most = -1;
  for (size_t i = 0; i < check_results->count; ++i) {
    const po_check_result *other = &check_results->items[i];
    if (other == item || other->point != item->point || !isfinite(other->error) ||
        strcmp(other->subject, item->subject) != 0)
      continue;
    const int weight = 2 * po_verdict_passes(other->verdict) + (other->ledger == PO_LEDGER_ORACLE);
    if (weight > most) {
      best = other;
      most = weight;
    }
  }
  return best;
}

/* Whether a result differs from its reference by no more than both may be off, of which
 * item->uncertainty is that of the reference. */
static bool is_within_errors(const po_case_run *run, const po_check_result *item,
                             word_list *words) {
  const double errors =
      item->uncertainty +
      po_compare_stated_error(item->check->quantity, &run->points[item->point].result);
  snprintf(words->number, sizeof words->number, "%.2g", errors);
  return fabs(item->error) <= errors;
}

/* Handles what does not depend on other references. Returned: SITUATIONS if they decide. */
static situation judge_alone(const po_case_run *run, const po_check_result *item,
                             word_list *words) {
  const bool traced = item->check->type == PO_REFERENCE_TRACED;
  if (item->whole && !po_verdict_passes(item->verdict))
    return FAILED_SOLVES;
  switch (item->verdict) {
  case PO_WITHIN:
    return PASSES;
  case PO_SLACK:
    return SLACK;
  case PO_NO_RESULT:
    return NO_QUANTITY;
  case PO_MISSING_REFERENCE:
    return traced ? NO_TRACE : NO_SCENE;
  default:
    return !run->plan->solver && is_within_errors(run, item, words) ? WITHIN_ERRORS
           : traced                                                 ? TRACE_DIFFERS
                                                                    : SITUATIONS;
  }
}

/* A wrong factor is recognised with this relative tolerance, which leaves room for the error of a
 * coarse mesh. */
static const double CLOSE = 0.05;

enum { MOST_PAIRS = 100 };

/* The results of an external solver. A factor between the obtained and the expected numbers of a
 * quantity, the same at all points, is named. */
static situation judge_solver(const po_case_run *run, const po_check_result *item,
                              word_list *words) {
  po_pair pairs[MOST_PAIRS];
  size_t count = 0;
  strcpy(words->factor, "1");
  for (size_t i = 0; i < run->check_results.count && count < MOST_PAIRS; ++i) {
    const po_check_result *other = &run->check_results.items[i];
    if (other->check == item->check && strcmp(other->quantity, item->quantity) == 0 &&
        isfinite(other->obtained) && isfinite(other->expected) && other->expected != 0)
      pairs[count++] = (po_pair){other->obtained, other->expected,
                                 &run->plan->kase->points[other->point].request.scene};
  }
  snprintf(words->points, sizeof words->points, "%zu %s", count,
           po_one_or_more(count, "point", "points"));
  if (count > 0 && po_recognise_factor(pairs, count, CLOSE, words->factor) &&
      strcmp(words->factor, "1") != 0)
    return SOLVER_FACTOR;
  return item->verdict == PO_NOT_REACHABLE     ? SOLVER_CANNOT_SEE
         : item->ledger == PO_LEDGER_PUBLISHED ? SOLVER_PUBLISHED
                                               : SOLVER_ORACLE;
}

/* An oracle contradicts a result of this program. The stored force is known if the number is the
 * pull-off force. */
static situation judge_oracle(const po_check_result *item, const po_check_result *other,
                              const po_point_identity *stored, word_list *words) {
  const bool is_force = item->check->quantity == PO_PULL_OFF_FORCE && isfinite(stored->pin.force);
  const double error = fabs(stored->pin.force - item->expected);
  if (stored->known && is_force)
    snprintf(words->number, sizeof words->number, "%.10g", stored->pin.force);
  if (stored->known && stored->same)
    return SAME_AS_STORED;
  if (stored->known && is_force && error <= item->allowance)
    return STORED_WAS_RIGHT;
  if (stored->known)
    return is_force && fabs(item->error) < error ? STORED_WAS_WORSE : STORED_WAS_OTHER;
  if (!other)
    return ORACLE_ALONE;
  return po_verdict_passes(other->verdict) ? ORACLE_REFUTED : OTHER_AGREES_NOT;
}

static situation judge_program(const po_case_run *run, const po_check_result *item,
                               word_list *words) {
  const po_check_result *other = find_other(&run->check_results, item);
  po_point_identity stored;
  if (po_identity_point(run, item->point, &stored))
    stored = (po_point_identity){0};
  if (other)
    snprintf(words->other, sizeof words->other, "%s (%s)", other->check->reference,
             PO_LEDGERS[other->ledger]);
  if (item->ledger == PO_LEDGER_ORACLE)
    return judge_oracle(item, other, &stored, words);
  return !other                              ? PUBLISHED_ALONE
         : po_verdict_passes(other->verdict) ? PUBLISHED_REFUTED
                                             : OTHER_AGREES_NOT;
}

void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  word_list words = {0};
  snprintf(words.check, sizeof words.check, "%s", item->check->reference);
  if (run->plan->solver)
    snprintf(words.solver, sizeof words.solver, "%s", run->plan->solver->name);
  situation found = judge_alone(run, item, &words);
  if (found == SITUATIONS)
    found = run->plan->solver ? judge_solver(run, item, &words) : judge_program(run, item, &words);
  compose_sentence(found, &words, blame);
}
