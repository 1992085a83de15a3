#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_bless.h"
#include "po_memory.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff bless [OPTION]... CASE --reason TEXT\n"
    "Runs what is missing of a case and makes its numbers the pins of its checks against `pin`:\n"
    "pins/CASE.csv beside the case file, with the date, who did it, the version and the reason.\n"
    "Says which pins moved by how much. Refused without a reason, when a solve failed (exit code\n"
    "3), and while a check of the case against an oracle does not pass (exit code 1).\n\n"
    "  --reason TEXT  why these numbers are accepted, in one line\n"
    "  --output DIR   where the records are (build/run)\n"
    "  --jobs N       points solved side by side (0: all cores); the numbers do not depend on it\n"
    "  --time-limit S seconds of processor time a solve may take, instead of what the case says\n"
    "  --fresh        solve again what is there\n"
    "  -h, --help     this text\n\n"
    "Example: pulloff bless smoke --reason \"Newton stops two digits later\"\n";

enum { REASON = PO_SESSION_NEXT };

static const struct option OPTIONS[] = {
    PO_SESSION_CASE_OPTIONS, {"reason", required_argument, NULL, REASON}, {NULL, 0, NULL, 0}};

/* Who blesses: the name git signs commits with, else that of the account. */
static po_status find_who(char who[128]) {
  who[0] = '\0';
  po_memory_watch();
  FILE *git = popen("git config user.name 2>/dev/null", "r");
  if (git) {
    if (!fgets(who, 128, git))
      who[0] = '\0';
    pclose(git);
  }
  if (po_memory_ran_out())
    return po_fail(PO_NO_MEMORY, "no memory to ask git who blesses");
  who[strcspn(who, "\n")] = '\0';
  const char *account = getenv("USER");
  if (!who[0])
    snprintf(who, 128, "%s", account && *account ? account : "unknown");
  return PO_OK;
}

static po_status bless(const po_session *session, const char *reason) {
  char who[128];
  po_text report = {0};
  po_status status = find_who(who);
  if (!status)
    status = po_bless(&session->runs[0], who, reason, &report);
  if (!status)
    fputs(po_text_string(&report), stdout);
  po_text_clear(&report);
  return status;
}

typedef struct {
  po_session session;
  const char *reason; /* NULL: not given */
} bless_line;

static po_status take_option(void *to, int option) {
  bless_line *line = to;
  if (option != REASON)
    return po_session_option(&line->session, option);
  line->reason = optarg;
  return PO_OK;
}

int po_verb_bless(int argc, char **argv) {
  const po_options options = {"bless", HELP, OPTIONS, argc, argv};
  bless_line line = {.session = po_session_default()};
  po_session *session = &line.session;
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  if (!line.reason)
    status = po_fail(PO_BAD_INPUT, "bless needs --reason TEXT (see pulloff bless --help)");
  if (!status)
    status = po_session_open_one(session, &options);
  if (!status)
    status = po_bless_check_request(session->runs[0].plan, line.reason);
  if (!status)
    status = po_session_solve(session);
  if (!status)
    status = bless(session, line.reason);
  if (status == PO_CHECK_FAILED) {
    char *why = po_copy_text(po_message());
    po_fail(status, "%s (see pulloff explain %s)", why ? why : "a check does not pass",
            po_case_word(session->catalog.cases[0]));
    free(why);
  }
  const int code = po_options_end(status);
  po_session_clear(session);
  return code;
}
