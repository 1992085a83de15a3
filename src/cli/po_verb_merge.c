#include <string.h>

#include "po_file.h"
#include "po_session.h"
#include "po_shard.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff merge [OPTION]... DIR...\n"
    "Combines the shards of a run and compares the results with the references. The records are\n"
    "those that one run of all points would write, except for the times. Each DIR is a folder\n"
    "that pulloff run --shard K/N has written; the order is arbitrary. All N shards must be\n"
    "present, finished, and computed by this program for these cases, on whatever machines.\n"
    "\n"
    "  --output DIR    folder to which the records are written (default build/run)\n"
    "  --solver M      the shards are those of the external solver with the manifest M; each DIR\n"
    "                  is then the folder solvers/NAME of a shard\n"
    "  --knob VALUE    value of the knob of that solver (default: the last one); the shards of\n"
    "                  several values are merged once for each value\n"
    "  -h, --help      print this text\n"
    "\n"
    "Example: pulloff merge shards/1 shards/2 shards/3 shards/4\n";

static const po_option OPTIONS[] = {PO_SESSION_SOLVER_OPTIONS, PO_SESSION_OUTPUT, {0}};

static po_status put_together(po_session *session, const po_merge *merge) {
  session->time_limit = merge->time_limit;
  po_status status = po_session_open(session, merge->cases, merge->case_count);
  if (!status)
    status = po_merge_fill(merge, session->runs, session->catalog.count);
  if (!status)
    status = po_session_solve(session); /* nothing is left to solve */
  if (status == PO_INTERRUPTED)
    po_fail(status, "interrupted; the shards are unchanged: run pulloff merge again");
  return status;
}

int po_verb_merge(int argc, char **argv) {
  const po_options options = {"merge", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  po_session session = po_session_default();
  po_merge merge = {0};
  po_status status = PO_OK;
  if (!po_options_read(&options, &session, &status))
    return po_options_end(status);
  status = po_session_check_one(&session, &options);
  if (!status && optind == argc)
    status =
        po_fail(PO_BAD_INPUT, "merge needs the folders of the shards (see pulloff merge --help)");
  if (!status)
    status = po_merge_open(argv + optind, (size_t)(argc - optind), &merge);
  if (!status)
    status = put_together(&session, &merge);
  po_merge_close(&merge);
  return po_session_end(&session, status);
}
