#include "po_explain.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_plan.h"
#include "po_recognise.h"
#include "po_text.h"

static void __attribute__((format(printf, 3, 4)))
say(po_blame *blame, const char *side, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(blame->why, sizeof blame->why, format, arguments);
  va_end(arguments);
  blame->side = side;
}

static bool is_verdict_of_pin_moved(po_verdict verdict) {
  return verdict == PO_MOVED || verdict == PO_REGRESSED || verdict == PO_IMPROVED;
}

/* The other results of the same point. Members are NULL if there is no such result. */
typedef struct {
  const po_check_result *pin;     /* of the same quantity */
  const po_check_result *for_it;  /* of another oracle, else of a published value, that passes */
  const po_check_result *against; /* of another oracle, else of a published value, that fails */
  size_t pins_held, pins_moved;   /* numbers of pins of all quantities except work */
} other_results;

static other_results collect(const po_check_results *check_results, const po_check_result *item) {
  other_results others = {0};
  for (size_t i = 0; i < check_results->count; ++i) {
    const po_check_result *other = &check_results->items[i];
    if (other == item || other->point != item->point || other->check->quantity == PO_WORK)
      continue;
    const bool same = strcmp(other->subject, item->subject) == 0;
    if (other->ledger == PO_LEDGER_PIN) {
      others.pins_held += po_verdict_is_plain(other->verdict);
      others.pins_moved += is_verdict_of_pin_moved(other->verdict);
      if (same)
        others.pin = other;
    } else if (same && isfinite(other->error)) {
      const po_check_result **place =
          po_verdict_passes(other->verdict) ? &others.for_it : &others.against;
      if (!*place || other->ledger == PO_LEDGER_ORACLE)
        *place = other;
    }
  }
  return others;
}

/* The result equals the blessed value. At the blessing all oracles passed; now this oracle fails.
 */
static void blame_frozen(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  const po_plan *plan = run->plan;
  const po_reference *oracle = item->reference;
  const po_reference *pins = NULL;
  for (unsigned c = 0; c < plan->kase->file->checks_count; ++c)
    if (plan->references[c].type == PO_REFERENCE_PINS)
      pins = &plan->references[c];
  const char *then = NULL;
  for (size_t i = 0; pins && i < pins->table.header_count; ++i) {
    const po_csv_header *header = &pins->table.headers[i];
    const size_t length = strlen(oracle->name);
    if (strncmp(header->key, "checked ", 8) == 0 &&
        strncmp(header->value, oracle->name, length) == 0 &&
        strncmp(header->value + length, " sha256 ", 8) == 0)
      then = header->value + length + 8;
  }
  if (oracle->type == PO_REFERENCE_BRADLEY || !then)
    say(blame, "program",
        "the result is the blessed value, so the program did not change; %s was not among the "
        "oracles that were checked then: either the result was wrong before, or the reference is",
        oracle->name);
  else if (strcmp(then, oracle->table.digest) != 0)
    say(blame, "reference",
        "the result is the blessed value, and %s passed then; the table has changed (sha256 "
        "%.12s..., then %.12s...): the reference was altered, see git log -- %s",
        oracle->name, oracle->table.digest, then, oracle->name);
  else
    say(blame, "tolerance",
        "the result is the blessed value, and %s passed then; the table has not changed: the "
        "tolerance, or the check, is newer than the blessing",
        oracle->name);
}

static void blame_oracle(const po_case_run *run, const po_check_result *item,
                         const other_results *others, po_blame *blame) {
  const char *name = item->check->reference;
  const po_check_result *pin = others->pin;
  if (item->verdict == PO_WRONG_AND_FROZEN ||
      (!pin && others->pins_held > 0 && others->pins_moved == 0))
    blame_frozen(run, item, blame);
  else if (pin && is_verdict_of_pin_moved(pin->verdict) &&
           fabs(pin->expected - item->expected) <= item->allowance)
    say(blame, "program",
        "%s and the blessed value %.10g agree, the result differs from both: the program changed",
        name, pin->expected);
  else if (others->pins_moved > 0)
    say(blame, "program", "the result is not the blessed value either: the program changed%s",
        pin && fabs(item->error) < fabs(pin->expected - item->expected)
            ? ", and the error decreased"
            : "");
  else if (others->for_it)
    say(blame, "reference", "%s (%s) agrees with the result: check %s first",
        others->for_it->check->reference, PO_LEDGERS[others->for_it->ledger], name);
  else if (others->against)
    say(blame, "program", "%s (%s) does not agree with the result either",
        others->against->check->reference, PO_LEDGERS[others->against->ledger]);
  else
    say(blame, "program",
        "%s was computed by an independent method and no other reference covers this number: check "
        "the program first, and whether its mesh is fine enough",
        name);
}

static void blame_published(const po_check_result *item, const other_results *others,
                            po_blame *blame) {
  if (others->for_it)
    say(blame, "publication",
        "%s (%s) agrees with the result: the publication, or its digitisation, is wrong",
        others->for_it->check->reference, PO_LEDGERS[others->for_it->ledger]);
  else if (others->against)
    say(blame, "program", "%s (%s) does not agree with the result either",
        others->against->check->reference, PO_LEDGERS[others->against->ledger]);
  else
    say(blame, "publication",
        "only %s covers this number: the publication, its digitisation, or the program is wrong; "
        "an oracle would decide",
        item->check->reference);
}

/* Given: `changed`, what computed the result: "program" or "solver". */
static void blame_pin(const po_check_result *item, const other_results *others, const char *changed,
                      po_blame *blame) {
  const po_check_result *oracle = others->for_it ? others->for_it : others->against;
  const bool has_oracle = oracle && oracle->ledger == PO_LEDGER_ORACLE;
  if (item->check->quantity == PO_WORK)
    say(blame, item->verdict == PO_IMPROVED ? "pin" : "program",
        item->verdict == PO_IMPROVED ? "the program changed and needs less work: bless it"
                                     : "the program changed and needs more work");
  else if (has_oracle && po_verdict_passes(oracle->verdict) &&
           fabs(item->expected - oracle->expected) > oracle->allowance)
    say(blame, "pin",
        "%s agrees with the result and not with the blessed value; bless would have refused that "
        "value: the pin was altered, or the reference was",
        oracle->check->reference);
  else if (item->verdict == PO_IMPROVED)
    say(blame, "pin", "the %s changed and the error decreased: bless it", changed);
  else if (item->verdict == PO_REGRESSED)
    say(blame, changed, "the %s changed, and its error against %s increased", changed,
        oracle ? oracle->check->reference : "the oracle");
  else
    say(blame, changed,
        "the %s, its compiler or its libraries changed, and no oracle decides which value is "
        "better: find the cause, then correct it or bless the value",
        changed);
}

/* A followed value differs from its trace, of which item->uncertainty is the stated error. */
static void blame_traced(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  const double errors =
      item->uncertainty +
      po_compare_stated_error(item->check->quantity, &run->points[item->point].result);
  if (fabs(item->error) <= errors)
    say(blame, "tolerance",
        "the difference is within the stated errors of both values together, %.2g: the tolerance "
        "is smaller than these",
        errors);
  else
    say(blame, "program",
        "the trace of the same scene finds another pull-off: the continuation left its branch, or "
        "the trace missed a minimum; the greater pull-off force is probably correct");
}

/* Handles the verdicts that do not depend on other references. Returned: whether it did. */
static bool blame_alone(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  const bool pin = item->ledger == PO_LEDGER_PIN;
  if (item->whole && !po_verdict_passes(item->verdict)) {
    say(blame, "solve",
        "more solves failed than the check permits, or one has no reason; each is listed below");
    return true;
  }
  if (item->verdict == PO_OUTSIDE && item->check->type == PO_REFERENCE_TRACED) {
    blame_traced(run, item, blame);
    return true;
  }
  switch (item->verdict) {
  case PO_IDENTICAL:
  case PO_WITHIN:
    say(blame, "none", "%s", "");
    return true;
  case PO_SLACK:
    say(blame, "tolerance",
        "it is so wide that the check would not detect an error a thousand times larger: reduce "
        "it");
    return true;
  case PO_NO_RESULT:
    say(blame, "solve", "the solve did not deliver the quantity");
    return true;
  case PO_MISSING_REFERENCE:
    say(blame, pin ? "pin" : "reference",
        pin ? "it is not blessed yet"
        : item->check->type == PO_REFERENCE_TRACED
            ? "the trace of the scene failed"
            : "it does not contain this scene: add the scene to it, or exclude the scene from the "
              "check by `when`");
    return true;
  default:
    return false;
  }
}

/* A wrong factor is recognised with this relative tolerance, which leaves room for the error of a
 * coarse mesh. */
static const double CLOSE = 0.05;

enum { MOST_PAIRS = 100 };

/* The results of an external solver. A factor between the obtained and the expected numbers of a
 * quantity, the same at all points, is named. */
static void blame_solver(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  po_pair pairs[MOST_PAIRS];
  size_t count = 0;
  char factor[PO_FACTOR_LENGTH] = "1";
  for (size_t i = 0; i < run->check_results.count && count < MOST_PAIRS; ++i) {
    const po_check_result *other = &run->check_results.items[i];
    if (other->check == item->check && strcmp(other->quantity, item->quantity) == 0 &&
        isfinite(other->obtained) && isfinite(other->expected) && other->expected != 0)
      pairs[count++] = (po_pair){other->obtained, other->expected,
                                 &run->plan->kase->points[other->point].request.scene};
  }
  if (count > 0 && po_recognise_factor(pairs, count, CLOSE, factor) && strcmp(factor, "1") != 0)
    say(blame, "solver",
        "the results of %s are the expected values times %s at all %zu %s: a wrong "
        "unit, sign or factor",
        run->plan->solver->name, factor, count, po_one_or_more(count, "point", "points"));
  else if (item->verdict == PO_NOT_REACHABLE)
    say(blame, "none",
        "%s follows stable equilibria and cannot see this value: the check does not "
        "count",
        run->plan->solver->name);
  else if (item->ledger == PO_LEDGER_PUBLISHED)
    say(blame, "solver",
        "%s is a published table: check %s first, and whether its mesh is fine enough, then the "
        "publication and its digitisation",
        item->check->reference, run->plan->solver->name);
  else
    say(blame, "solver",
        "%s was computed by an independent method: check %s first, and whether its mesh is fine "
        "enough",
        item->check->reference, run->plan->solver->name);
}

void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  if (blame_alone(run, item, blame))
    return;
  if (run->plan->solver && item->ledger != PO_LEDGER_PIN) {
    blame_solver(run, item, blame);
    return;
  }
  const other_results others = collect(&run->check_results, item);
  if (item->ledger == PO_LEDGER_ORACLE)
    blame_oracle(run, item, &others, blame);
  else if (item->ledger == PO_LEDGER_PUBLISHED)
    blame_published(item, &others, blame);
  else
    blame_pin(item, &others, run->plan->solver ? "solver" : "program", blame);
}
