#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_bless.h"
#include "po_memory.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff bless [OPTION]... CASE... --reason TEXT\n"
    "Accepts the present results of cases: their digests, with which verify compares to the last\n"
    "bit, and the expected values of checks against the reference pin. First solves the points\n"
    "that have no valid record. Digests are written to pins/CASE.digests.csv and pins to\n"
    "pins/CASE.csv in the folder of the case file, with the date, the author, the version of the\n"
    "program and the reason. Prints by how much each pin moved. Refuses if no reason is given, if\n"
    "a solve failed (exit code 3), or if a check against an oracle does not pass or a stored "
    "result\n"
    "was altered (exit code 1).\n"
    "\n"
    "  --suite S[,S]     take the cases of these suites instead (see pulloff list)\n"
    "  --reason TEXT     why the values are accepted, in one line (required)\n"
    "  --output DIR      folder of the records (default build/run)\n" PO_SESSION_JOBS_HELP
        PO_SESSION_SOLVE_HELP "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff bless smoke --reason \"Newton stops two digits later\"\n";

typedef struct {
  po_session session;
  const char *reason; /* NULL: not given */
} bless_line;

static const po_option OPTIONS[] = {
    PO_SESSION_CASE_OPTIONS, PO_SESSION_SUITE, PO_TEXT("reason", bless_line, reason, NULL), {0}};

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

static po_status bless(const po_session *session, const char *reason) {
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
  if (!status && session->manifest_count)
    status = po_session_open_one(session, &options);
  else if (!status)
    status = open_several(session, &options);
  for (size_t r = 0; !status && r < session->run_count; ++r)
    status = po_bless_check_request(session->runs[r].plan, line.reason);
  if (!status)
    status = po_session_solve(session);
  if (!status)
    status = bless(session, line.reason);
  const int code = po_options_end(status);
  po_session_clear(session);
  return code;
}
