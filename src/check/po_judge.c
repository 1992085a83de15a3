#include "po_judge.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A tolerance so many times wider than every error it met would not notice the program getting a
 * hundred times worse. */
static const double SLACK = 1000;

/* Errors below so many units of rounding of the value are those of the last digits of a long sum,
 * not of the method. */
static const double ROUNDING = 4 * DBL_EPSILON;

static bool is_of_same(const po_check_result *a, const po_check_result *b) {
  return a->point == b->point && strcmp(a->subject, b->subject) == 0;
}

static bool is_counted(const po_check_result *item) {
  return item->verdict != PO_NO_RESULT && item->verdict != PO_MISSING_REFERENCE;
}

/* The error below which a reference cannot tell one value from another. */
static double resolution(const po_check_result *item) {
  const double rounding = ROUNDING * fmax(fabs(item->obtained), fabs(item->expected));
  return fmax(isnan(rounding) ? 0 : rounding, isnan(item->uncertainty) ? 0 : item->uncertainty);
}

/* What all oracles say of a pinned value and of that which took its place. */
typedef struct {
  bool fell, rose, outside;
  char note[128]; /* by how much, against the one it rose against, else the last it fell against */
} testimony;

static void hear(const po_check_result *oracle, double pinned, testimony *said) {
  const double before = fabs(pinned - oracle->expected), after = fabs(oracle->error);
  said->outside = said->outside || oracle->verdict == PO_OUTSIDE;
  if (fmax(before, after) <= resolution(oracle) || before == after)
    return;
  const bool rose = after > before;
  if (rose || !said->rose) {
    char reference[64];
    po_check_result_reference(oracle->check, reference);
    snprintf(said->note, sizeof said->note, "the error against %.40s %s from %.2g to %.2g",
             reference, rose ? "rose" : "fell", before, after);
  }
  said->rose = said->rose || rose;
  said->fell = said->fell || !rose;
}

static void judge_moved(const po_check_results *check_results, po_check_result *pin) {
  testimony said = {0};
  bool any = false;
  for (size_t i = 0; i < check_results->count; ++i) {
    const po_check_result *other = &check_results->items[i];
    if (other->ledger != PO_LEDGER_ORACLE || !is_of_same(other, pin) || !is_counted(other))
      continue;
    any = true;
    hear(other, pin->expected, &said);
  }
  char why[sizeof pin->note];
  if (said.rose) {
    pin->verdict = PO_REGRESSED;
    snprintf(why, sizeof why, "%s", said.note);
  } else if (said.fell && !said.outside) {
    pin->verdict = PO_IMPROVED;
    snprintf(why, sizeof why, "%s: bless it", said.note);
  } else {
    pin->verdict = PO_MOVED;
    snprintf(why, sizeof why, "%s",
             said.fell ? "the error fell, but the oracle still fails"
             : any     ? "no oracle can tell the two values apart"
                       : "no oracle speaks of it");
  }
  char had[sizeof pin->note]; /* a special point that is missing or spurious */
  snprintf(had, sizeof had, "%s", pin->note);
  snprintf(pin->note, sizeof pin->note, "%.100s%s%.90s", had, had[0] ? "; " : "", why);
}

static void judge_work(po_check_result *pin) {
  const bool more = pin->error > 0;
  pin->verdict = more ? PO_REGRESSED : PO_IMPROVED;
  snprintf(pin->note, sizeof pin->note, more ? "%.1f %% more work" : "%.1f %% less work: bless it",
           100 * fabs(pin->error) / fmax(fabs(pin->expected), 1));
}

static void judge_pins(po_check_results *check_results) {
  for (size_t i = 0; i < check_results->count; ++i) {
    po_check_result *pin = &check_results->items[i];
    if (pin->ledger != PO_LEDGER_PIN || pin->verdict != PO_OUTSIDE)
      continue;
    if (pin->check->quantity == PO_WORK)
      judge_work(pin);
    else
      judge_moved(check_results, pin);
  }
}

static void judge_oracles(po_check_results *check_results) {
  for (size_t i = 0; i < check_results->count; ++i) {
    po_check_result *oracle = &check_results->items[i];
    if (oracle->ledger != PO_LEDGER_ORACLE || oracle->verdict != PO_OUTSIDE)
      continue;
    for (size_t k = 0; k < check_results->count; ++k) {
      const po_check_result *pin = &check_results->items[k];
      if (pin->ledger == PO_LEDGER_PIN && pin->verdict == PO_WITHIN && is_of_same(pin, oracle))
        oracle->verdict = PO_WRONG_AND_FROZEN;
    }
  }
}

/* A number that is counted, not computed. */
static bool is_exact(const po_check_result *item) {
  return item->whole || strcmp(item->quantity, "fold_count") == 0 ||
         strcmp(item->quantity, "extremum_count") == 0 || strcmp(item->quantity, "jump_count") == 0;
}

/* Of the results of one check, from `first` on, the one with the largest error in units of the
 * tolerance; *last is the end of them. NULL: none to be measured by, no error at all, or
 * one that fails. */
static po_check_result *worst_of_check(po_check_results *check_results, size_t first, size_t *last,
                                       double *largest) {
  const po_check *check = check_results->items[first].check;
  po_check_result *worst = NULL;
  bool measurable = check_results->items[first].ledger != PO_LEDGER_PIN;
  *largest = 0.0;
  for (*last = first; *last < check_results->count && check_results->items[*last].check == check;
       ++*last) {
    po_check_result *item = &check_results->items[*last];
    measurable = measurable && item->verdict == PO_WITHIN;
    const double error = fmax(fabs(item->error), resolution(item)) / item->allowance;
    if (!is_exact(item) && error > *largest) {
      *largest = error;
      worst = item;
    }
  }
  return measurable ? worst : NULL;
}

static void judge_tolerances(po_check_results *check_results) {
  for (size_t first = 0, last = 0; first < check_results->count; first = last) {
    double largest = 0;
    po_check_result *worst = worst_of_check(check_results, first, &last, &largest);
    if (!worst || largest * SLACK >= 1)
      continue;
    worst->verdict = PO_SLACK;
    snprintf(worst->note, sizeof worst->note,
             "the tolerance is %.0f times the largest error this check met, here", 1 / largest);
  }
}

void po_judge(po_check_results *check_results) {
  judge_pins(check_results);
  judge_oracles(check_results);
  judge_tolerances(check_results);
}
