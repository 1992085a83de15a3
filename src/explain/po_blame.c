#include "po_blame.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_plan.h"

static void say(po_blame *blame, const char *side, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void say(po_blame *blame, const char *side, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(blame->why, sizeof blame->why, format, arguments);
  va_end(arguments);
  blame->side = side;
}

static bool is_verdict_of_pin_moved(po_verdict verdict) {
  return verdict == PO_MOVED || verdict == PO_REGRESSED || verdict == PO_IMPROVED;
}

/* What the other results of the same point say. */
typedef struct {
  const po_check_result *pin;     /* of the same quantity; NULL: none */
  const po_check_result *for_it;  /* another oracle, else a published value, that passes */
  const po_check_result *against; /* the same that fails */
  size_t pins_held, pins_moved;   /* of any quantity but work */
} witnesses;

static witnesses hear(const po_check_results *check_results, const po_check_result *item) {
  witnesses heard = {0};
  for (size_t i = 0; i < check_results->count; ++i) {
    const po_check_result *other = &check_results->items[i];
    if (other == item || other->point != item->point || other->check->quantity == PO_WORK)
      continue;
    const bool same = strcmp(other->subject, item->subject) == 0;
    if (other->ledger == PO_LEDGER_PIN) {
      heard.pins_held += other->verdict == PO_WITHIN;
      heard.pins_moved += is_verdict_of_pin_moved(other->verdict);
      if (same)
        heard.pin = other;
    } else if (same && isfinite(other->error)) {
      const po_check_result **place =
          po_verdict_passes(other->verdict) ? &heard.for_it : &heard.against;
      if (!*place || other->ledger == PO_LEDGER_ORACLE)
        *place = other;
    }
  }
  return heard;
}

/* The program gives what was blessed, when every oracle held, and this one fails now. */
static void blame_frozen(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  const po_plan *plan = run->plan;
  const po_reference *oracle = &plan->references[item->check - plan->kase->file->checks];
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
        "the result is what was blessed, so the program did not change; %s was not among the "
        "oracles that held then: the result was wrong before, or the reference is",
        oracle->name);
  else if (strcmp(then, oracle->table.digest) != 0)
    say(blame, "reference",
        "the result is what was blessed, when %s held; it is not what it was then (sha256 "
        "%.12s..., then %.12s...): the reference was altered, see git log -- %s",
        oracle->name, oracle->table.digest, then, oracle->name);
  else
    say(blame, "tolerance",
        "the result is what was blessed, when %s held, and it is what it was then: the "
        "tolerance, or the check, is newer than the blessing",
        oracle->name);
}

static void blame_oracle(const po_case_run *run, const po_check_result *item,
                         const witnesses *heard, po_blame *blame) {
  const char *name = item->check->reference;
  const po_check_result *pin = heard->pin;
  if (item->verdict == PO_WRONG_AND_FROZEN ||
      (!pin && heard->pins_held > 0 && heard->pins_moved == 0))
    blame_frozen(run, item, blame);
  else if (pin && is_verdict_of_pin_moved(pin->verdict) &&
           fabs(pin->expected - item->expected) <= item->allowance)
    say(blame, "program",
        "%s and the blessed value %.10g agree, the result has left both: the program changed", name,
        pin->expected);
  else if (heard->pins_moved > 0)
    say(blame, "program", "the result is not what was blessed either: the program changed%s",
        pin && fabs(item->error) < fabs(pin->expected - item->expected) ? ", though for the better"
                                                                        : "");
  else if (heard->for_it)
    say(blame, "reference", "%s (%s) agrees with the result: look at %s first",
        heard->for_it->check->reference, po_ledger_name(heard->for_it->ledger), name);
  else if (heard->against)
    say(blame, "program", "%s (%s) does not agree with the result either",
        heard->against->check->reference, po_ledger_name(heard->against->ledger));
  else
    say(blame, "program",
        "%s was computed by an independent route and nothing else speaks of this: look at the "
        "program, and at whether its mesh is fine enough, first",
        name);
}

static void blame_published(const po_check_result *item, const witnesses *heard, po_blame *blame) {
  if (heard->for_it)
    say(blame, "publication",
        "%s (%s) agrees with the result: the publication, or its reading, "
        "is off",
        heard->for_it->check->reference, po_ledger_name(heard->for_it->ledger));
  else if (heard->against)
    say(blame, "program", "%s (%s) does not agree with the result either",
        heard->against->check->reference, po_ledger_name(heard->against->ledger));
  else
    say(blame, "publication",
        "only %s speaks of this: the publication, its reading, or the program; an oracle would "
        "tell",
        item->check->reference);
}

static void blame_pin(const po_check_result *item, const witnesses *heard, po_blame *blame) {
  const po_check_result *oracle = heard->for_it ? heard->for_it : heard->against;
  const bool heard_oracle = oracle && oracle->ledger == PO_LEDGER_ORACLE;
  if (item->check->quantity == PO_WORK)
    say(blame, item->verdict == PO_IMPROVED ? "pin" : "program",
        item->verdict == PO_IMPROVED ? "the program does the same with less work: bless it"
                                     : "the program changed and works more for the same");
  else if (heard_oracle && po_verdict_passes(oracle->verdict) &&
           fabs(item->expected - oracle->expected) > oracle->allowance)
    say(blame, "pin",
        "%s agrees with the result and not with the blessed value, at which bless would have "
        "refused: the pin was altered, or the reference was",
        oracle->check->reference);
  else if (item->verdict == PO_IMPROVED)
    say(blame, "pin", "the program changed for the better: bless it");
  else if (item->verdict == PO_REGRESSED)
    say(blame, "program", "the program changed, away from %s",
        oracle ? oracle->check->reference : "the oracle");
  else
    say(blame, "program",
        "the program, its compiler or its libraries changed, and no oracle says whether for the "
        "better: find what did it, then mend it or bless it");
}

/* Verdicts that do not need the other ledgers. */
static bool blame_plainly(const po_check_result *item, po_blame *blame) {
  const bool pin = item->ledger == PO_LEDGER_PIN;
  if (item->whole && !po_verdict_passes(item->verdict)) {
    say(blame, "solve", "more failed than may, or without a reason; each is told below");
    return true;
  }
  if (item->verdict == PO_OUTSIDE && po_check_is_traced(item->check)) {
    say(blame, "program",
        "the trace of the same scene finds another pull-off: following went astray, or the trace "
        "missed a minimum; whichever pulls harder is nearer the truth");
    return true;
  }
  switch (item->verdict) {
  case PO_WITHIN:
    say(blame, "none", "%s", "");
    return true;
  case PO_SLACK:
    say(blame, "tolerance",
        "it is so wide that it would not notice an error a thousand times larger: narrow it");
    return true;
  case PO_NO_RESULT:
    say(blame, "solve", "the solve did not deliver the quantity");
    return true;
  case PO_MISSING_REFERENCE:
    say(blame, pin ? "pin" : "reference",
        pin ? "it was not blessed yet"
        : po_check_is_traced(item->check)
            ? "the trace of the scene failed"
            : "it does not speak of this scene: add it there, or leave "
              "the scene out by a `when`");
    return true;
  default:
    return false;
  }
}

void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame) {
  if (blame_plainly(item, blame))
    return;
  const witnesses heard = hear(&run->check_results, item);
  if (item->ledger == PO_LEDGER_ORACLE)
    blame_oracle(run, item, &heard, blame);
  else if (item->ledger == PO_LEDGER_PUBLISHED)
    blame_published(item, &heard, blame);
  else
    blame_pin(item, &heard, blame);
}
