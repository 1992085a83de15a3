#include <stdio.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_identity.h"
#include "po_list_references.h"
#include "po_overview.h"
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
    "does not pass (the verdicts identical, within, improved and slack pass) or a pull-off force\n"
    "differs from the stored one by more than 1e-9. Without CASE, all reference tables are "
    "checked\n"
    "first. CASE is a name (see pulloff list) or the path of a YAML file. Without CASE and\n"
    "--suite, all cases are taken except those of the suite random, which take long.\n"
    "\n"
    "  --suite S[,S]     take the cases of these suites instead (see pulloff list)\n"
    "  --output DIR      folder of the records (default build/run)\n"
    "  --jobs N          number of points solved in parallel; 0 means all cores (default 0); the\n"
    "                    results do not depend on it\n"
    "  --points A[-B][,C[-D]]...  solve only points A to B, C to D of each case, counted from 0\n"
    "                    (default: all); a later run of all points reuses them\n"
    "  --time-limit S    limit of the processor time of each solve, in seconds (default: the\n"
    "                    limit in the case file, if any)\n" PO_SESSION_SOLVER_HELP
    "  --fresh           solve all points again, even those with a valid record\n"
    "  --identical       exit code 1 also if a result or a pin is not the same to the last bit;\n"
    "                    prints how far each case is off, and which oracles can judge it\n"
    "  --verbose         print a line for every check\n"
    "  --tap             print the verdicts as TAP 13, one line a check\n"
    "  --junit FILE      write the verdicts also to FILE, as JUnit XML\n"
    "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff verify --suite smoke\n";

enum { TAP = PO_SESSION_NEXT, JUNIT, VERBOSE, IDENTICAL };

static const struct option OPTIONS[] = {PO_SESSION_OPTIONS,
                                        {"tap", no_argument, NULL, TAP},
                                        {"verbose", no_argument, NULL, VERBOSE},
                                        {"identical", no_argument, NULL, IDENTICAL},
                                        {"junit", required_argument, NULL, JUNIT},
                                        {NULL, 0, NULL, 0}};

/* If no case is named, no reference table may be missing, truncated or altered, even one that no
 * case uses. */
static po_status check_references(void) {
  po_reference_list list;
  po_status status = po_reference_list_open(po_environment_data(), &list);
  if (!status)
    status = po_list_references_check(&list);
  po_reference_list_close(&list);
  return status;
}

typedef struct {
  po_session session;
  bool tap, verbose, identical;
  const char *junit; /* a file; NULL: none */
} verify_line;

static po_status print(const verify_line *line) {
  const po_session *session = &line->session;
  const size_t count = session->run_count;
  po_text text = {0};
  if (line->tap)
    po_verdicts_tap(session->runs, count, &text);
  else if (line->verbose)
    po_verdicts_table(session->runs, count, &text);
  else
    po_overview_add(session->runs, count, po_session_output(session), &text);
  fputs(po_text_string(&text), stdout);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

/* Prints what is not as it was stored. Returned: in *differs, whether that is a failure. */
static po_status print_identity(const verify_line *line, bool *differs) {
  po_identity identity;
  po_text lines = {0}, text = {0};
  const po_status status =
      po_identity_compare(line->session.runs, line->session.run_count, &identity, &lines);
  *differs = identity.beyond > 0 ||
             (line->identical && (identity.pins > 0 || identity.identical < identity.compared));
  if (*differs)
    po_text_add(&text, "%s", po_text_string(&lines));
  po_identity_add(&identity, &text);
  const char *next = po_text_string(&text);
  for (size_t length; !status && (length = strcspn(next, "\n")) > 0; next += length + 1)
    printf("%s%.*s\n", line->tap ? "# " : "", (int)length, next);
  po_text_clear(&lines);
  po_text_clear(&text);
  return status;
}

static po_status write_junit(const po_session *session, const char *junit) {
  po_text text = {0};
  po_verdicts_junit(session->runs, session->run_count, &text);
  const po_status status =
      text.failed ? PO_NO_MEMORY : po_file_write(junit, text.data, text.length);
  po_text_clear(&text);
  return status;
}

static po_status take_option(void *to, int option) {
  verify_line *line = to;
  if (option == TAP)
    line->tap = true;
  else if (option == VERBOSE)
    line->verbose = true;
  else if (option == IDENTICAL)
    line->identical = true;
  else if (option == JUNIT)
    return po_options_take_text("junit", "the name of a file", &line->junit);
  else
    return po_session_option(&line->session, option);
  return PO_OK;
}

int po_verb_verify(int argc, char **argv) {
  const po_options options = {"verify", HELP, OPTIONS, argc, argv, NULL};
  verify_line line = {.session = po_session_default()};
  po_session *session = &line.session;
  po_status status = PO_OK;
  bool differs = false;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  if (optind == argc)
    status = check_references();
  session->options.brief = !line.verbose;
  if (!status)
    status = po_session_open(session, argv + optind, (size_t)(argc - optind));
  if (!status)
    status = po_identity_check(session->runs, session->run_count);
  if (!status)
    status = po_session_solve(session);
  if (!status)
    status = print(&line);
  if (!status)
    status = print_identity(&line, &differs);
  if (!status && !line.tap)
    status = po_session_summarise(session);
  if (!status && line.junit)
    status = write_junit(session, line.junit);
  int code = po_options_end(status);
  if (!status && po_session_failures(session))
    code = PO_EXIT_SOLVE;
  else if (!status && (po_session_outside(session) || differs))
    code = PO_EXIT_OUTSIDE;
  po_session_clear(session);
  return code;
}
