#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_bless.h"
#include "po_memory.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff bless [OPTION]... CASE... --reason TEXT\n"
    "Accepts the present results of cases: their digests and their counters of work, with which\n"
    "verify compares. First solves the points that have no valid record. Writes pins/CASE.csv in\n"
    "the folder of the case file, with the date, the author, the version of the program and the\n"
    "reason. Prints by how much results and work differ from the stored ones. Refuses if no "
    "reason\n"
    "is given, if a solve failed (exit code 3), or if a check against an oracle does not pass or "
    "a\n"
    "stored result was altered (exit code 1).\n"
    "\n"
    "  --suite S[,S]     take the cases of these suites instead (see pulloff list)\n"
    "  --reason TEXT     why the values are accepted, in one line (required)\n"
    "  --output DIR      folder of the records (default build/run)\n" PO_SESSION_JOBS_HELP
        PO_SESSION_TIME_HELP PO_SESSION_FRESH_HELP "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff bless smoke --reason \"Newton stops two digits later\"\n";

typedef struct {
  po_session session;
  const char *reason; /* NULL: not given */
} bless_line;

static const po_option OPTIONS[] = {
    PO_SESSION_OWN_OPTIONS, PO_SESSION_SUITE, PO_TEXT("reason", bless_line, reason, NULL), {0}};

/* The author of the pins: user.name of git, or else the name of the account. */
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
    return po_fail(PO_NO_MEMORY, "memory ran out while git was asked for user.name");
  who[strcspn(who, "\n")] = '\0';
  const char *account = getenv("USER");
  if (!who[0])
    snprintf(who, 128, "%s", account && *account ? account : "unknown");
  return PO_OK;
}

static po_status bless_runs(const po_session *session, const char *reason) {
  char who[128];
  po_text report = {0};
  po_status status = find_who(who);
  if (!status)
    status = po_bless(session->runs, session->run_count, who, reason, &report);
  if (!status)
    fputs(po_text_string(&report), stdout);
  po_text_clear(&report);
  return status;
}

static po_status open_several(po_session *session, const po_options *options) {
  if (optind == options->argc && !session->suites)
    return po_fail(PO_BAD_INPUT, "bless needs the name of a case (see pulloff bless --help)");
  return po_session_open(session, options->argv + optind, (size_t)(options->argc - optind));
}

int po_verb_bless(int argc, char **argv) {
  const po_options options = {"bless", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  bless_line line = {.session = po_session_default()};
  po_session *session = &line.session;
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  if (!line.reason)
    status = po_fail(PO_BAD_INPUT, "bless needs --reason TEXT (see pulloff bless --help)");
  if (!status)
    status = open_several(session, &options);
  if (!status)
    status = po_bless_check_reason(line.reason);
  if (!status)
    status = po_session_solve(session);
  if (!status)
    status = bless_runs(session, line.reason);
  const int code = po_options_end(status);
  po_session_clear(session);
  return code;
}
