#include "po_identity.h"

#include <math.h>
#include <string.h>

#include "po_record.h"
#include "po_text.h"

/* Relative difference of a pull-off force up to which it may be due to rounding. */
static const double ROUNDING = 1e-9;

/* Increase of a counter of work that makes a case fail. */
static const double MORE = 0.1;

/* A result without a pull-off, or one that has lost or gained it, differs beyond measure. */
static double relative_difference(double force, double stored) {
  return force == stored                 ? 0.0
         : isnan(force) && isnan(stored) ? 0.0
         : isnan(force) || isnan(stored) ? (double)INFINITY
                                         : fabs(force - stored) / fabs(stored);
}

po_status po_identity_point(const po_case_run *run, size_t point, po_point_identity *identity) {
  const po_pins *pins = &run->plan->pins;
  const po_result *result = &run->points[point].result;
  char digest[PO_RESULT_DIGEST_LENGTH];
  size_t row = 0;
  *identity = (po_point_identity){0};
  if (run->plan->solver || !po_pins_find(pins, point, run->plan->kase->points[point].id, &row))
    return PO_OK;
  po_status status = po_pins_read(pins, row, &identity->pin);
  if (!status)
    status = po_record_digest(run, point, digest);
  if (status)
    return status;
  identity->known = identity->worked = true;
  identity->same = strcmp(digest, identity->pin.digest) == 0;
  identity->difference = relative_difference(
      result->has_pull_off ? result->pull_off.force : (double)NAN, identity->pin.force);
  for (int counter = 0; counter < PO_WORK_COUNTERS; ++counter) {
    const double stored = identity->pin.work[counter];
    identity->worked = identity->worked && (isnan(stored) || result->status ||
                                            stored == po_work_count(&result->work, counter));
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

/* What was found in one case. */
typedef struct {
  po_identity *counts;
  size_t point;                                                 /* with the largest difference */
  double stored;                                                /* its force */
  double work[PO_WORK_COUNTERS], stored_work[PO_WORK_COUNTERS]; /* sums */
} comparison;

static void count_point(const po_case_run *run, size_t point, const po_point_identity *one,
                        comparison *found) {
  po_identity *counts = found->counts;
  const po_result *result = &run->points[point].result;
  const bool first = counts->identical == counts->compared;
  counts->compared += 1;
  counts->identical += one->same;
  counts->other_work += !one->worked;
  for (int counter = 0; counter < PO_WORK_COUNTERS; ++counter)
    if (!isnan(one->pin.work[counter]) && !result->status) {
      found->work[counter] += po_work_count(&result->work, counter);
      found->stored_work[counter] += one->pin.work[counter];
    }
  if (one->same)
    return;
  counts->beyond += one->difference > ROUNDING;
  if (first || one->difference > counts->largest) {
    found->point = point;
    found->stored = one->pin.force;
    counts->largest = one->difference;
  }
}

static void describe_results(const po_case_run *run, const comparison *found, po_text *lines) {
  const po_case *kase = run->plan->kase;
  const po_identity *counts = found->counts;
  const char *label = kase->points[found->point].label;
  po_text_add(lines, "%s: %zu of %zu %s not the stored ones; ", kase->file->name,
              counts->compared - counts->identical, counts->compared,
              po_one_or_more(counts->compared, "result is", "results are"));
  if (isinf(counts->largest))
    po_text_add(lines, "only one of both results of %s has a pull-off force: ", label);
  else
    po_text_add(lines, "the pull-off force of %s differs most, by %.2g of %.10g: ", label,
                counts->largest, found->stored);
  add_oracles(run, found->point, lines);
  po_text_add(lines, "\n");
}

static void describe_work(const po_case_run *run, comparison *found, po_text *lines) {
  po_text_add(lines,
              "%s: %zu of %zu %s other work than the stored ones:", run->plan->kase->file->name,
              found->counts->other_work, found->counts->compared,
              po_one_or_more(found->counts->compared, "result took", "results took"));
  const char *before = " ";
  for (int counter = 0; counter < PO_WORK_COUNTERS; ++counter) {
    const double more = found->work[counter] / found->stored_work[counter] - 1;
    if (found->work[counter] == found->stored_work[counter])
      continue;
    po_text_add(lines, "%s%s %+.1f %%", before, PO_WORK_COUNTER_NAMES[counter], 100 * more);
    before = ", ";
    if (more > MORE)
      found->counts->more_work = 1;
  }
  po_text_add(lines, "%s\n", *before == ',' ? " in all" : " the sums are the same");
}

po_status po_identity_compare(const po_case_run *run, po_identity *identity, po_text *lines) {
  const po_case *kase = run->plan->kase;
  comparison found = {.counts = identity};
  po_status status = PO_OK;
  *identity = (po_identity){0};
  if (run->plan->solver)
    return PO_OK;
  if (run->plan->pins.other_scenes) {
    identity->other_scenes = 1;
    po_text_add(lines,
                "%s: its scenes are not those whose results were stored, and none is compared; "
                "pulloff bless %s --reason TEXT stores the results of these scenes\n",
                kase->file->name, po_case_word(kase));
  }
  for (size_t i = 0; !status && i < kase->point_count; ++i) {
    po_point_identity one = {0};
    if (!run->points[i].asked)
      continue;
    status = po_identity_point(run, i, &one);
    if (!status && one.known)
      count_point(run, i, &one, &found);
    identity->not_stored += !one.known;
  }
  if (!status && identity->not_stored)
    po_text_add(lines, "%s: %zu %s not stored; pulloff bless %s --reason TEXT stores them\n",
                kase->file->name, identity->not_stored,
                po_one_or_more(identity->not_stored, "result is", "results are"),
                po_case_word(kase));
  if (!status && identity->identical < identity->compared)
    describe_results(run, &found, lines);
  if (!status && identity->other_work)
    describe_work(run, &found, lines);
  return status ? status : lines->failed ? PO_NO_MEMORY : PO_OK;
}

bool po_identity_passes(const po_identity *identity) {
  const bool differs = identity->identical < identity->compared || identity->other_work ||
                       identity->other_scenes || identity->not_stored;
  return !identity->beyond && !identity->more_work && !(identity->exact && differs);
}

bool po_identity_counts(const po_identity *identity) {
  return identity->compared ||
         (identity->exact && (identity->other_scenes || identity->not_stored));
}

po_identity po_identity_sum(const po_identity *identities, size_t count) {
  po_identity sum = {0};
  for (size_t i = 0; i < count; ++i) {
    const po_identity *one = &identities[i];
    sum = (po_identity){.compared = sum.compared + one->compared,
                        .identical = sum.identical + one->identical,
                        .beyond = sum.beyond + one->beyond,
                        .other_work = sum.other_work + one->other_work,
                        .more_work = sum.more_work + one->more_work,
                        .other_scenes = sum.other_scenes + one->other_scenes,
                        .not_stored = sum.not_stored + one->not_stored,
                        .largest = fmax(sum.largest, one->largest),
                        .exact = sum.exact || one->exact};
  }
  return sum;
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
  if (identity->other_work)
    po_text_add(text, "; %zu took other work", identity->other_work);
  po_text_add(text, "\n");
}
