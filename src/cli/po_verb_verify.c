#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_identity.h"
#include "po_memory.h"
#include "po_reference_list.h"
#include "po_session.h"
#include "po_text.h"
#include "po_verbs.h"
#include "po_verdicts.h"

static const char HELP[] =
    "Usage: pulloff verify [OPTION]... [CASE]...\n"
    "Solves the points that have no valid record, compares the results with the references and\n"
    "prints a line for each case, each failure with the command that explains it, and the\n"
    "totals, among them how many results are identical to the last bit with those that were\n"
    "stored (see pulloff bless). The exit code is 3 if a solve failed, and otherwise 1 if a check\n"
    "does not pass (the verdicts within and slack pass), a pull-off force differs from the stored\n"
    "one by more than 1e-9, or a case takes over a tenth more work than the stored results.\n"
    "CASE is a name (see pulloff list) or the path of a YAML file. Without CASE, all reference\n"
    "tables are checked first. Without CASE and --suite, all cases are taken except those of\n"
    "random, theories and rate, which take long.\n"
    "\n"
    "  --suite S[,S]     take the cases of these suites instead (see pulloff list)\n"
    "  --output DIR      folder of the records (default build/run)\n" PO_SESSION_JOBS_HELP
        PO_SESSION_POINTS_HELP PO_SESSION_SOLVE_HELP
    "  --identical       exit code 1 also if a result is not the same to the last bit, or took "
    "other\n"
    "                    work, or is not stored; prints how far each case is off, and which\n"
    "                    oracles can judge it\n"
    "  --verbose         print a line for every check\n"
    "  --tap             print the verdicts as TAP 13, one line a check\n"
    "  --junit FILE      write the verdicts also to FILE, as JUnit XML\n"
    "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff verify --suite smoke\n";

typedef struct {
  po_session session;
  bool tap, verbose, identical;
  const char *junit;       /* a file; NULL: none */
  po_identity *identities; /* one a run */
} verify_line;

static const po_option OPTIONS[] = {PO_SESSION_OPTIONS,
                                    PO_FLAG("tap", verify_line, tap),
                                    PO_FLAG("verbose", verify_line, verbose),
                                    PO_FLAG("identical", verify_line, identical),
                                    PO_TEXT("junit", verify_line, junit, "the name of a file"),
                                    {0}};

/* If no case is named, no reference table may be missing, truncated or altered, even one that no
 * case uses. */
static po_status check_references(void) {
  po_reference_list list;
  po_status status = po_reference_list_open(po_environment_data(), &list);
  if (!status)
    status = po_reference_list_check(&list);
  po_reference_list_close(&list);
  return status;
}

static const char *label_of(const po_finding *finding) {
  return finding->label ? finding->label : "all points";
}

static void add_case(const po_case_run *run, po_text *text) {
  po_finding worst = {0};
  size_t remarkable = 0; /* pass, and are not within */
  for (po_finding f = {0}; po_finding_next(run, &f);) {
    remarkable += !f.plain && f.passes;
    if (f.item && isfinite(f.item->ratio) && (!worst.item || f.item->ratio > worst.item->ratio))
      worst = f;
  }
  const size_t outside = po_case_run_outside(run);
  po_text_add(text, "%-18s %7zu %7zu %8zu %9.1f ", run->plan->name,
              run->check_results.count - outside, outside, po_case_run_failures(run), run->elapsed);
  if (worst.item)
    po_text_add(text, "%10.*f  %s, %s", worst.item->ratio < 1e5 ? 3 : 0, worst.item->ratio,
                worst.item->subject, label_of(&worst));
  else
    po_text_add(text, "%10s", "-");
  if (remarkable)
    po_text_add(text, "; %zu %sslack", remarkable,
                run->coverage.not_reachable ? "not reachable or " : "");
  if (run->plan->solver)
    po_text_add(text, "; coverage %zu/%zu %s, %zu/%zu %s", run->coverage.asked,
                run->coverage.points, po_one_or_more(run->coverage.points, "point", "points"),
                run->coverage.made, run->coverage.checks,
                po_one_or_more(run->coverage.checks, "check", "checks"));
  po_text_add(text, "\n");
}

/* The command that explains a point of a case (NULL: all its points). */
static void add_command(const po_case_run *run, const po_point *point, const char *output,
                        po_text *text) {
  po_text_add(text, "    pulloff explain %s", po_case_word(run->plan->kase));
  if (point)
    po_text_add(text, " --point %s", point->id);
  po_plan_add_options(run->plan, text);
  if (output) {
    po_text_add(text, " --output ");
    po_text_add_word(text, output);
  }
  po_text_add(text, "\n");
}

/* Whether a result is further off than another. One without a number is not. */
static bool is_worse(const po_check_result *item, const po_check_result *than) {
  return isfinite(than->ratio) && !(item->ratio <= than->ratio);
}

static void add_result(const po_check_result *item, po_text *text) {
  po_text_add(text, "%s", PO_VERDICTS[item->verdict]);
  if (isfinite(item->ratio) && !(item->verdict == PO_OUTSIDE && item->ratio <= 1))
    po_text_add(text, ", %.4g times the tolerance", item->ratio);
  po_text_add(text, " (%s)%s%s", item->reference->name, item->note[0] ? ": " : "", item->note);
}

/* What does not pass of one check of a case (NULL: the solves that failed): how many, the worst
 * (the first), and its command. */
static void add_check(const po_case_run *run, const po_check *check, const char *output,
                      po_text *text) {
  po_finding worst = {0};
  size_t count = 0;
  for (po_finding f = {0}; po_finding_next(run, &f);)
    if (!f.passes && (f.item ? f.item->check : NULL) == check)
      if (count++ == 0 || (check && is_worse(f.item, worst.item)))
        worst = f;
  if (!count)
    return;
  const po_check_result *item = worst.item;
  po_text_add(text, "%s %s, %s: ", run->plan->name, check ? item->subject : "solve",
              label_of(&worst));
  if (check)
    add_result(item, text);
  else
    po_text_add(text, "failed: %s", run->points[worst.point].result.reason);
  if (count > 1)
    po_text_add(text,
                check ? "; %zu results of this check do not pass, this is the worst"
                      : "; %zu solves failed, this is the first",
                count);
  po_text_add(text, "\n");
  add_command(run, worst.label ? &run->plan->kase->points[worst.point] : NULL, output, text);
}

/* The points of an external solver that its manifest excludes: how many, the first, and why. */
static void add_excluded(const po_case_run *run, po_text *text) {
  const po_case *kase = run->plan->kase;
  size_t count = 0, first = 0;
  for (size_t i = kase->point_count; i-- > 0;)
    if (run->points[i].asked && run->points[i].beyond) {
      count += 1;
      first = i;
    }
  if (count)
    po_text_add(text, "%s: the manifest excludes %zu of %zu %s; the first, %s, is %s\n",
                run->plan->name, count, run->asked_count,
                po_one_or_more(run->asked_count, "point", "points"), kase->points[first].label,
                run->points[first].result.reason);
}

/* Adds the overview of finished runs: a line a case, what does not pass with the command that
 * explains it, the totals. Given: `output`, the folder of the records; NULL: it is the default. */
static void add_overview(const po_case_run *runs, size_t count, const char *output, po_text *text) {
  po_text_add(text, "%-18s %7s %7s %8s %9s %10s  %s\n", "case", "pass", "fail", "unsolved",
              "seconds", "|err|/tol", "of the worst check");
  for (size_t r = 0; r < count; ++r)
    add_case(&runs[r], text);
  for (size_t r = 0; r < count; ++r) {
    const po_case_file *file = runs[r].plan->kase->file;
    for (unsigned c = 0; c < file->checks_count; ++c)
      add_check(&runs[r], &file->checks[c], output, text);
    add_check(&runs[r], NULL, output, text);
    add_excluded(&runs[r], text);
  }
  po_verdicts_totals(runs, count, text);
}

static po_status print_verdicts(const verify_line *line) {
  const po_session *session = &line->session;
  const size_t count = session->run_count;
  po_text text = {0};
  if (line->tap)
    po_verdicts_tap(session->runs, line->identities, count, &text);
  else if (line->verbose)
    po_verdicts_table(session->runs, count, &text);
  else
    add_overview(session->runs, count, po_session_output(session), &text);
  return po_text_print(&text);
}

/* Compares each run with the pins of its case. */
static po_status compare_stored(verify_line *line, po_text *lines) {
  const po_session *session = &line->session;
  line->identities = po_allocate(session->run_count, sizeof *line->identities);
  po_status status = line->identities ? PO_OK : PO_NO_MEMORY;
  for (size_t r = 0; !status && r < session->run_count; ++r) {
    status = po_identity_compare(&session->runs[r], &line->identities[r], lines);
    line->identities[r].exact = line->identical;
  }
  return status;
}

/* Prints what is not as it was stored. Returned: whether that is a failure. */
static bool print_stored(const verify_line *line, const po_text *lines) {
  const po_identity sum = po_identity_sum(line->identities, line->session.run_count);
  const bool differs = !po_identity_passes(&sum);
  po_text text = {0};
  if (differs)
    po_text_add(&text, "%s", po_text_string(lines));
  po_identity_add(&sum, &text);
  const char *next = po_text_string(&text);
  for (size_t length; (length = strcspn(next, "\n")) > 0; next += length + 1)
    printf("%s%.*s\n", line->tap ? "# " : "", (int)length, next);
  po_text_clear(&text);
  return differs;
}

static po_status write_junit(const verify_line *line) {
  po_text text = {0};
  po_verdicts_junit(line->session.runs, line->identities, line->session.run_count, &text);
  const po_status status = po_file_write(line->junit, text.data, text.length);
  po_text_clear(&text);
  return status;
}

static size_t session_outside(const po_session *session) {
  size_t total = 0;
  for (size_t i = 0; i < session->run_count; ++i)
    total += po_case_run_outside(&session->runs[i]);
  return total;
}

int po_verb_verify(int argc, char **argv) {
  const po_options options = {"verify", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  verify_line line = {.session = po_session_default()};
  po_session *session = &line.session;
  po_status status = PO_OK;
  bool differs = false;
  po_text lines = {0};
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  if (optind == argc)
    status = check_references();
  session->options.brief = !line.verbose;
  if (!status)
    status = po_session_open(session, argv + optind, (size_t)(argc - optind));
  if (!status)
    status = po_session_solve(session);
  if (!status)
    status = compare_stored(&line, &lines);
  if (!status)
    status = print_verdicts(&line);
  if (!status)
    differs = print_stored(&line, &lines);
  if (!status && !line.tap)
    status = po_session_summarise(session);
  if (!status && line.junit)
    status = write_junit(&line);
  int code = po_options_end(status);
  if (!status && po_session_failures(session))
    code = PO_EXIT_SOLVE;
  else if (!status && (session_outside(session) || differs))
    code = PO_EXIT_OUTSIDE;
  free(line.identities);
  po_text_clear(&lines);
  po_session_clear(session);
  return code;
}
