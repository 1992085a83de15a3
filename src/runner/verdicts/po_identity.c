#include "po_identity.h"

#include <math.h>
#include <string.h>

#include "po_pins.h"
#include "po_record.h"
#include "po_text.h"

/* Relative difference of a pull-off force up to which it may be due to rounding. */
static const double ROUNDING = 1e-9;

/* What differs in one case. */
typedef struct {
  size_t compared, different, pins;
  size_t point; /* with the largest difference */
  double largest, stored;
} difference;

/* A result without a pull-off, or one that has lost or gained it, differs beyond measure. */
static double relative_difference(double force, double stored) {
  return force == stored                 ? 0.0
         : isnan(force) && isnan(stored) ? 0.0
         : isnan(force) || isnan(stored) ? (double)INFINITY
                                         : fabs(force - stored) / fabs(stored);
}

static po_status compare_point(const po_case_run *run, const po_reference *digests, size_t i,
                               po_identity *identity, difference *found) {
  const po_result *result = &run->points[i].result;
  const char *stored = NULL;
  char digest[PO_RESULT_DIGEST_LENGTH];
  double force = 0;
  po_status status = po_digests_find(digests, i, run->plan->kase->points[i].id, &stored, &force);
  if (status)
    return status == PO_NOT_FOUND ? PO_OK : status;
  status = po_record_digest(run, i, digest);
  if (status)
    return status;
  found->compared += 1;
  if (strcmp(digest, stored) == 0)
    return PO_OK;
  const double differs =
      relative_difference(result->has_pull_off ? result->pull_off.force : (double)NAN, force);
  identity->beyond += differs > ROUNDING;
  if (!found->different++ || differs > found->largest) {
    found->point = i;
    found->largest = differs;
    found->stored = force;
  }
  return PO_OK;
}

/* Reports whether a check of a point is against an oracle that has numbers. */
static bool is_judge(const po_case_run *run, unsigned check, size_t point) {
  const po_reference *reference = &run->plan->references[check];
  return reference->ledger == PO_LEDGER_ORACLE && reference->type != PO_REFERENCE_ABSENT &&
         reference->type != PO_REFERENCE_EVERY_SCENE &&
         po_check_concerns(&run->plan->kase->file->checks[check],
                           &run->plan->kase->points[point].request);
}

/* The oracles of the checks that concern a point, each once. */
static void add_oracles(const po_case_run *run, size_t point, po_text *text) {
  const po_case_file *file = run->plan->kase->file;
  const char *before = "";
  for (unsigned c = 0; c < file->checks_count; ++c) {
    char name[64];
    bool again = !is_judge(run, c, point);
    for (unsigned k = 0; k < c; ++k)
      again = again || (is_judge(run, k, point) &&
                        strcmp(file->checks[k].reference, file->checks[c].reference) == 0);
    if (again)
      continue;
    po_check_result_reference(&file->checks[c], name);
    po_text_add(text, "%s%s", before, name);
    before = ", ";
  }
  po_text_add(text, "%s", *before ? " can judge it" : "no oracle can judge it");
}

/* Adds the lines of a case, and counts its pins that differ. */
static void describe(const po_case_run *run, difference *found, po_text *lines) {
  const po_case *kase = run->plan->kase;
  if (found->different) {
    po_text_add(lines,
                "%s: %zu of %zu %s not the stored ones; the pull-off force of %s differs "
                "most, by %.2g of %.10g: ",
                kase->file->name, found->different, found->compared,
                po_one_or_more(found->compared, "result is", "results are"),
                kase->points[found->point].label, found->largest, found->stored);
    add_oracles(run, found->point, lines);
    po_text_add(lines, "\n");
  }
  for (size_t i = 0; i < run->check_results.count; ++i) {
    const po_check_result *pin = &run->check_results.items[i];
    if (pin->ledger != PO_LEDGER_PIN || pin->verdict == PO_IDENTICAL)
      continue;
    found->pins += 1;
    if (pin->verdict == PO_MISSING_REFERENCE)
      po_text_add(lines, "%s: %s has no pin\n", kase->file->name, pin->id);
    else
      po_text_add(lines, "%s: %s is not its pin: %.17g for %.17g\n", kase->file->name, pin->id,
                  pin->obtained, pin->expected);
  }
}

static po_status compare_case(const po_case_run *run, po_identity *identity, po_text *lines) {
  const po_case *kase = run->plan->kase;
  po_reference digests;
  char scenes[PO_DIGEST_LENGTH];
  difference found = {0};
  po_status status = po_digests_open(kase, scenes, &digests);
  if (!status && po_pins_exist(&digests) && !digests.table.row_count) {
    identity->other_scenes += 1;
    po_text_add(lines,
                "%s: its scenes are not those whose results were stored, and none is compared; "
                "pulloff bless %s --reason TEXT stores the results of these scenes\n",
                kase->file->name, po_case_word(kase));
  }
  for (size_t i = 0; !status && i < kase->point_count; ++i)
    if (run->points[i].asked)
      status = compare_point(run, &digests, i, identity, &found);
  po_reference_close(&digests);
  describe(run, &found, lines);
  identity->compared += found.compared;
  identity->identical += found.compared - found.different;
  identity->pins += found.pins;
  identity->largest = fmax(identity->largest, found.largest);
  return status;
}

po_status po_identity_check(const po_case_run *runs, size_t count) {
  po_status status = PO_OK;
  for (size_t r = 0; !status && r < count; ++r) {
    po_reference digests;
    char scenes[PO_DIGEST_LENGTH];
    status = po_digests_open(runs[r].plan->kase, scenes, &digests);
    po_reference_close(&digests);
  }
  return status;
}

po_status po_identity_compare(const po_case_run *runs, size_t count, po_identity *identity,
                              po_text *lines) {
  po_status status = PO_OK;
  *identity = (po_identity){0};
  for (size_t r = 0; !status && r < count; ++r)
    if (!runs[r].plan->solver)
      status = compare_case(&runs[r], identity, lines);
  return status ? status : lines->failed ? PO_NO_MEMORY : PO_OK;
}

void po_identity_add(const po_identity *identity, po_text *text) {
  const size_t different = identity->compared - identity->identical;
  if (!identity->compared)
    return;
  po_text_add(text, "%zu of %zu %s identical to the last bit with the stored ones",
              identity->identical, identity->compared,
              po_one_or_more(identity->compared, "result is", "results are"));
  if (different)
    po_text_add(text, ", %zu differ: their pull-off forces by at most %.2g", different,
                identity->largest);
  if (identity->beyond)
    po_text_add(text, ", %zu by more than rounding", identity->beyond);
  po_text_add(text, "\n");
}
