#include "po_bless.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "po_compare.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_pins.h"
#include "po_record.h"

typedef struct {
  size_t point;
  char name[PO_PIN_NAME_LENGTH];
  double value; /* NAN: the solve did not deliver it */
} pinned;

typedef struct {
  pinned *items;
  size_t count;
  size_t *scenes; /* see po_pins_scenes */
} pin_list;

/* Adds a value, unless another check, or a point with the same scene, has added it already. */
static po_status add(pin_list *list, size_t point, const char *name, double value) {
  point = list->scenes[point];
  for (size_t i = 0; i < list->count; ++i)
    if (list->items[i].point == point && strcmp(list->items[i].name, name) == 0)
      return PO_OK;
  pinned *items = po_resize(list->items, list->count + 1, sizeof *items);
  if (!items)
    return PO_NO_MEMORY;
  list->items = items;
  pinned *pin = &items[list->count++];
  *pin = (pinned){.point = point, .value = value};
  snprintf(pin->name, sizeof pin->name, "%s", name);
  return PO_OK;
}

static po_status add_special_points(pin_list *list, size_t point, po_quantity quantity,
                                    const po_result *result) {
  const bool folds = quantity == PO_FOLDS, solved = result->status == PO_OK;
  const po_special_point *marks = folds ? result->folds : result->extrema;
  const size_t count = folds ? result->fold_count : result->extremum_count;
  char name[PO_PIN_NAME_LENGTH];
  snprintf(name, sizeof name, "%s/count", PO_QUANTITIES[quantity].name);
  po_status status = add(list, point, name, solved ? (double)count : (double)NAN);
  for (size_t i = 0; !status && solved && i < count; ++i)
    for (int load = 0; !status && load < 2; ++load) {
      po_pins_name_special_point(quantity, marks[i].kind, i, load, name);
      status = add(list, point, name, load ? marks[i].load : marks[i].approach);
    }
  return status;
}

static po_status add_work(pin_list *list, size_t point, const po_result *result) {
  po_status status = PO_OK;
  for (int counter = 0; !status && counter < PO_WORK_COUNTERS; ++counter) {
    char name[PO_PIN_NAME_LENGTH];
    snprintf(name, sizeof name, "work/%s", PO_WORK_COUNTER_NAMES[counter]);
    status = add(list, point, name,
                 result->status == PO_OK ? po_work_count(&result->work, counter) : (double)NAN);
  }
  return status;
}

static po_status add_check(const po_case_run *run, const po_check *check, size_t point,
                           pin_list *list) {
  const po_result *result = &run->points[point].result;
  if (check->type != PO_REFERENCE_PINS ||
      !po_check_concerns(check, &run->plan->kase->points[point].request))
    return PO_OK;
  if (check->quantity == PO_WORK)
    return add_work(list, point, result);
  if (check->quantity == PO_FOLDS || check->quantity == PO_EXTREMA)
    return add_special_points(list, point, check->quantity, result);
  return add(list, point, PO_QUANTITIES[check->quantity].name,
             po_compare_obtained(check->quantity, result));
}

/* Lists all values that the checks of the case pin, each once. The caller frees both arrays.
 * Status: PO_NO_MEMORY. */
static po_status list_pins(const po_case_run *run, pin_list *list) {
  const po_case *kase = run->plan->kase;
  *list = (pin_list){.scenes = po_allocate(kase->point_count, sizeof *list->scenes)};
  po_status status = list->scenes ? po_pins_scenes(kase, list->scenes) : PO_NO_MEMORY;
  for (size_t point = 0; !status && point < kase->point_count; ++point)
    for (unsigned c = 0; !status && c < kase->file->checks_count; ++c)
      status = add_check(run, &kase->file->checks[c], point, list);
  return status;
}

/* Reports whether a key has the same value for all scenes of the list. Returned: in `text`, this
 * value. */
static bool is_shared(const po_case *kase, const pin_list *list, po_key key,
                      char text[PO_KEY_TEXT_LENGTH]) {
  strcpy(text, "-");
  for (size_t i = 0; i < list->count; ++i) {
    char other[PO_KEY_TEXT_LENGTH];
    po_pins_key_text(&kase->points[list->items[i].point].request, key, i ? other : text);
    if (i && strcmp(other, text) != 0)
      return false;
  }
  return true;
}

/* Adds, as headers, the keys that have the same value for all scenes of the list. */
static void add_shared_keys(const po_case *kase, const pin_list *list, po_text *text) {
  char value[PO_KEY_TEXT_LENGTH];
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (is_shared(kase, list, key, value) && strcmp(value, "-") != 0)
      po_text_add(text, "# %s: %s\n", PO_KEYS[key].name, value);
}

/* Adds the line of column names and the rows of the table. */
static void add_rows(const po_case *kase, const pin_list *list, po_text *rows) {
  bool column[PO_KEY_COUNT];
  char value[PO_KEY_TEXT_LENGTH];
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    column[key] = !is_shared(kase, list, key, value);
    if (column[key])
      po_text_add(rows, "%s,", PO_KEYS[key].name);
  }
  po_text_add(rows, "quantity,value\n");
  for (size_t i = 0; i < list->count; ++i) {
    const pinned *pin = &list->items[i];
    for (int key = 0; key < PO_KEY_COUNT; ++key)
      if (column[key]) {
        po_pins_key_text(&kase->points[pin->point].request, key, value);
        po_text_add(rows, "%s,", value);
      }
    po_number_print(pin->value, value);
    po_text_add(rows, "%s,%s\n", pin->name, value);
  }
}

/* Returned: the present pins of the case; NULL if no check is against pins. */
static const po_reference *old_pins(const po_plan *plan) {
  const po_case_file *file = plan->kase->file;
  for (unsigned c = 0; c < file->checks_count; ++c)
    if (plan->references[c].type == PO_REFERENCE_PINS)
      return &plan->references[c];
  return NULL;
}

/* Largest length of a reason, which is a header of one line. */
enum { LONGEST_REASON = 500 };

static po_status check_reason(const char *reason) {
  bool blank = true, plain = true;
  for (const char *c = reason; *c; ++c) {
    blank = blank && isspace((unsigned char)*c);
    plain = plain && !iscntrl((unsigned char)*c);
  }
  if (blank || !plain || strlen(reason) > LONGEST_REASON)
    return po_fail(PO_BAD_INPUT, "the reason is %s: expected one line that states the reason",
                   blank    ? "empty"
                   : !plain ? "of several lines, or contains control characters"
                            : "longer than 500 characters");
  return PO_OK;
}

/* Refuses results that may not be pinned: failed solves, missing results, and results that an
 * oracle contradicts. */
static po_status check_results(const po_case_run *run) {
  const po_case *kase = run->plan->kase;
  const char *name = kase->file->name;
  if (run->altered)
    return po_fail(
        PO_CHECK_FAILED,
        "%s is not blessed: %zu stored %s altered or damaged; solved again now, the case "
        "can be blessed when it was looked at",
        name, run->altered, po_one_or_more(run->altered, "result was", "results were"));
  for (size_t i = 0; i < kase->point_count; ++i)
    if (po_case_run_failed(run, i))
      return po_fail(PO_NOT_CONVERGED, "%s is not blessed: the solve of %s failed: %s", name,
                     kase->points[i].label, run->points[i].result.reason);
  for (size_t i = 0; i < run->check_results.count; ++i) {
    const po_check_result *item = &run->check_results.items[i];
    const bool bad_oracle = item->ledger == PO_LEDGER_ORACLE && !po_verdict_passes(item->verdict);
    if (bad_oracle || item->verdict == PO_NO_RESULT)
      return po_fail(PO_CHECK_FAILED, "%s is not blessed: %s is %s (see pulloff explain %s)", name,
                     item->id, PO_VERDICTS[item->verdict], po_case_word(kase));
  }
  return PO_OK;
}

po_status po_bless_check_request(const po_plan *plan, const char *reason) {
  if (plan->solver && !old_pins(plan))
    return po_fail(PO_BAD_INPUT, "%s pins nothing: expected a check whose reference is pin",
                   plan->kase->file->name);
  return check_reason(reason);
}

/* The numbers of new, changed and removed pins. */
typedef struct {
  size_t new, moved, dropped;
} changes;

static po_status report_changes(const po_case_run *run, const po_reference *old,
                                const pin_list *list, changes *found, po_text *report) {
  const po_case *kase = run->plan->kase;
  size_t known = 0;
  for (size_t i = 0; i < list->count; ++i) {
    const pinned *pin = &list->items[i];
    const po_point *point = &kase->points[pin->point];
    double before = 0;
    if (!isfinite(pin->value))
      return po_fail(PO_CHECK_FAILED,
                     "%s is not blessed: there is no %s of %s (see pulloff explain %s)",
                     kase->file->name, pin->name, point->label, po_case_word(kase));
    const po_status status = po_pins_value(old, pin->name, &point->request, &before);
    if (status && status != PO_NOT_FOUND)
      return status;
    known += status == PO_OK;
    found->new += status == PO_NOT_FOUND;
    if (status)
      po_text_add(report, "%-24s %-28s new    %.15g\n", point->label, pin->name, pin->value);
    else if (before != pin->value) {
      found->moved += 1;
      po_text_add(report, "%-24s %-28s moved  %.15g -> %.15g, by %+.3g\n", point->label, pin->name,
                  before, pin->value, pin->value - before);
    }
  }
  found->dropped = old->table.row_count - known;
  return PO_OK;
}

/* Adds a header with the checksum of each oracle whose checks pass now. If an oracle fails later
 * and the pin does not, the checksum shows whether the oracle was altered since. */
static void add_oracles(const po_plan *plan, po_text *text) {
  const po_case_file *file = plan->kase->file;
  size_t number = 0;
  for (unsigned c = 0; c < file->checks_count; ++c) {
    const po_reference *reference = &plan->references[c];
    bool again = reference->type != PO_REFERENCE_TABLE || reference->ledger != PO_LEDGER_ORACLE;
    for (unsigned k = 0; k < c; ++k)
      again = again || strcmp(file->checks[k].reference, file->checks[c].reference) == 0;
    if (!again)
      po_text_add(text, "# checked %zu: %s sha256 %s\n", ++number, reference->name,
                  reference->table.digest);
  }
}

/* Copies the headers of `old` that begin with `start`. Returned: their number. */
static size_t copy_headers(const po_csv *old, const char *start, po_text *text) {
  size_t count = 0;
  for (size_t i = 0; i < old->header_count; ++i)
    if (strncmp(old->headers[i].key, start, strlen(start)) == 0) {
      po_text_add(text, "# %s: %s\n", old->headers[i].key, old->headers[i].value);
      count += 1;
    }
  return count;
}

/* Given: `what` is in the table. */
static void add_headers(const po_case_run *run, const po_reference *old, const char *what,
                        const char *who, const char *reason, po_text *text) {
  const po_case *kase = run->plan->kase;
  char date[32];
  const time_t now = time(NULL);
  struct tm utc;
  gmtime_r(&now, &utc);
  strftime(date, sizeof date, "%Y-%m-%d", &utc);
  po_text_add(text,
              "# what: %s of the case %s, to notice change\n"
              "# source: this program; accepted, which is no evidence of being right\n"
              "# kind: pin\n"
              "# method: that of the scheme of each scene\n"
              "# units: as in the records: lengths in epsilon, load in pi w R, work in counts\n"
              "# uncertainty: 0\n"
              "# generator: pulloff bless\n"
              "# command: pulloff bless %s --reason TEXT\n"
              "# date: %s\n",
              what, kase->file->name, po_case_word(kase), date);
  const size_t before = copy_headers(&old->table, "blessing ", text);
  po_text_add(text, "# blessing %zu: %s, ", before + 1, date);
  for (const char *c = who; *c; ++c) {
    const char plain = iscntrl((unsigned char)*c) ? ' ' : *c;
    po_text_add_bytes(text, &plain, 1);
  }
  po_text_add(text, ", pulloff " PULLOFF_VERSION ": %s\n", reason);
}

/* Writes a table into the folder of its path, which is made if need be, and clears its texts. */
static po_status write_table(const char *path, po_text *header, po_text *rows) {
  po_text text = {0};
  char digest[PO_DIGEST_LENGTH];
  po_csv_seal(header, rows, &text, digest);
  po_file_path folder = po_path_join("", path);
  *strrchr(folder.text, '/') = '\0';
  po_status status = po_folder_make(folder.text);
  if (!status)
    status = po_file_write(path, text.data, text.length);
  po_text_clear(header);
  po_text_clear(rows);
  po_text_clear(&text);
  return status;
}

static po_status write_pins(const po_case_run *run, const po_reference *old, const pin_list *list,
                            const char *who, const char *reason) {
  po_text header = {0}, rows = {0};
  add_headers(run, old, "blessed values", who, reason, &header);
  add_oracles(run->plan, &header);
  add_shared_keys(run->plan->kase, list, &header);
  add_rows(run->plan->kase, list, &rows);
  return write_table(old->path.text, &header, &rows);
}

static bool same_oracles(const po_plan *plan, const po_reference *old) {
  po_text before = {0}, now = {0};
  copy_headers(&old->table, "checked ", &before);
  add_oracles(plan, &now);
  const bool same = strcmp(po_text_string(&before), po_text_string(&now)) == 0;
  po_text_clear(&before);
  po_text_clear(&now);
  return same;
}

static po_status bless_pins(const po_case_run *run, const char *who, const char *reason,
                            po_text *report) {
  const po_reference *old = old_pins(run->plan);
  pin_list list = {0};
  changes found = {0};
  po_status status = list_pins(run, &list);
  if (!status)
    status = report_changes(run, old, &list, &found, report);
  const bool changed = found.new + found.moved + found.dropped > 0 || !same_oracles(run->plan, old);
  if (!status && changed)
    status = write_pins(run, old, &list, who, reason);
  if (!status && changed)
    po_text_add(report, "%s: %zu %s, %zu moved, %zu new, %zu dropped\n", old->shown.text,
                list.count, po_one_or_more(list.count, "pin", "pins"), found.moved, found.new,
                found.dropped);
  else if (!status)
    po_text_add(report, "%s: %zu %s, all as they were; nothing is written\n", old->shown.text,
                list.count, po_one_or_more(list.count, "pin", "pins"));
  free(list.items);
  free(list.scenes);
  return status;
}

/* Adds the row of a point to a table of digests. Adds 1 to *changed if the old table has another.
 */
static po_status add_digest(const po_case_run *run, size_t i, const po_reference *old,
                            po_text *rows, size_t *changed) {
  const po_result *result = &run->points[i].result;
  const char *id = run->plan->kase->points[i].id, *before = "";
  char digest[PO_RESULT_DIGEST_LENGTH], force[PO_NUMBER_LENGTH] = "-";
  double unused;
  po_status status = po_record_digest(run, i, digest);
  if (!status && (status = po_digests_find(old, i, id, &before, &unused)) == PO_NOT_FOUND)
    status = PO_OK;
  if (result->has_pull_off)
    po_number_print(result->pull_off.force, force);
  po_text_add(rows, "%s,%s,%s\n", id, digest, force);
  *changed += !status && strcmp(digest, before) != 0;
  return status;
}

static po_status bless_digests(const po_case_run *run, const char *who, const char *reason,
                               po_text *report) {
  const size_t count = run->plan->kase->point_count;
  po_reference old;
  po_text header = {0}, rows = {0};
  size_t changed = 0;
  char scenes[PO_DIGEST_LENGTH];
  po_status status = po_digests_open(run->plan->kase, scenes, &old);
  po_text_add(&rows, "point,digest,pull_off_force\n");
  for (size_t i = 0; !status && i < count; ++i)
    status = add_digest(run, i, &old, &rows, &changed);
  if (!status && (changed || old.table.row_count != count)) {
    add_headers(run, &old, "digests of the results", who, reason, &header);
    po_text_add(&header, "# scenes: %s\n", scenes);
    status = write_table(old.path.text, &header, &rows);
  }
  if (!status)
    po_text_add(report, "%s: %zu %s, %zu new\n", old.shown.text, count,
                po_one_or_more(count, "digest", "digests"), changed);
  po_text_clear(&rows);
  po_reference_close(&old);
  return status;
}

po_status po_bless(const po_case_run *runs, size_t count, const char *who, const char *reason,
                   po_text *report) {
  po_status status = PO_OK;
  for (size_t r = 0; !status && r < count; ++r)
    status = check_results(&runs[r]);
  for (size_t r = 0; !status && r < count; ++r) {
    if (old_pins(runs[r].plan))
      status = bless_pins(&runs[r], who, reason, report);
    if (!status && !runs[r].plan->solver)
      status = bless_digests(&runs[r], who, reason, report);
  }
  return status ? status : report->failed ? PO_NO_MEMORY : PO_OK;
}
