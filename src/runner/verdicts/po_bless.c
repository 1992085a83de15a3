#include "po_bless.h"

#include <ctype.h>
#include <string.h>
#include <time.h>

#include "po_file.h"
#include "po_identity.h"
#include "po_record.h"

/* Largest length of a reason, which is a header of one line. */
enum { LONGEST_REASON = 500 };

po_status po_bless_check_reason(const char *reason) {
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

/* Refuses results that may not be pinned: altered ones, failed solves, missing quantities, and
 * results that an oracle contradicts. */
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

static void add_header(const po_plan *plan, const char *who, const char *reason, po_text *text) {
  char date[32];
  const time_t now = time(NULL);
  struct tm utc;
  gmtime_r(&now, &utc);
  strftime(date, sizeof date, "%Y-%m-%d", &utc);
  po_text_add(text,
              "# what: digests and work of the results of the case %s, which show change, not "
              "correctness\n# command: pulloff bless %s --reason TEXT\n# accepted: %s, ",
              plan->kase->file->name, po_case_word(plan->kase), date);
  for (const char *c = who; *c; ++c) {
    const char plain = iscntrl((unsigned char)*c) ? ' ' : *c;
    po_text_add_bytes(text, &plain, 1);
  }
  po_text_add(text, ", pulloff " PULLOFF_VERSION ": %s\n# scenes: %s\n", reason, plan->pins.scenes);
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

/* Adds the row of a point. Adds 1 to *changed if the stored row is another. */
static po_status add_point(const po_case_run *run, size_t point, po_text *rows, size_t *changed) {
  const char *id = run->plan->kase->points[point].id;
  const size_t length = rows->length;
  char digest[PO_RESULT_DIGEST_LENGTH];
  po_text before = {0};
  size_t row = 0;
  const po_status status = po_record_digest(run, point, digest);
  po_pins_add(id, digest, &run->points[point].result, rows);
  if (po_pins_find(&run->plan->pins, point, id, &row))
    po_pins_add_stored(&run->plan->pins, row, &before);
  *changed += strcmp(po_text_string(rows) + length, po_text_string(&before)) != 0;
  rows->failed = rows->failed || before.failed;
  po_text_clear(&before);
  return status;
}

/* Adds by how much the results differ from the stored ones, and writes them if they do. */
static po_status bless_case(const po_case_run *run, const char *who, const char *reason,
                            po_text *report) {
  const po_pins *pins = &run->plan->pins;
  const size_t count = run->plan->kase->point_count;
  po_identity identity;
  po_text header = {0}, rows = {0};
  size_t changed = 0;
  po_status status = po_identity_compare(run, &identity, report);
  po_pins_add_columns(&rows);
  for (size_t i = 0; !status && i < count; ++i)
    status = add_point(run, i, &rows, &changed);
  const bool differs = changed || pins->table.row_count != count;
  if (!status && differs) {
    add_header(run->plan, who, reason, &header);
    status = write_table(pins->path.text, &header, &rows);
  }
  if (!status)
    po_text_add(report, "%s: %zu %s, %zu new%s\n", pins->shown.text, count,
                po_one_or_more(count, "result", "results"), changed,
                differs ? "" : "; nothing is written");
  po_text_clear(&rows);
  return status;
}

po_status po_bless(const po_case_run *runs, size_t count, const char *who, const char *reason,
                   po_text *report) {
  po_status status = PO_OK;
  for (size_t r = 0; !status && r < count; ++r)
    status = check_results(&runs[r]);
  for (size_t r = 0; !status && r < count; ++r)
    status = bless_case(&runs[r], who, reason, report);
  return status ? status : report->failed ? PO_NO_MEMORY : PO_OK;
}
