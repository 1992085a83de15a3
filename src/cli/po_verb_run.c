#include "po_run_summary.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff run [OPTION]... [CASE]...\n"
    "Solves the points of cases and writes a record of each case. Points that an earlier run\n"
    "solved are reused if their case, reference tables and program are unchanged. CASE is a name\n"
    "(see pulloff list) or the path of a YAML file. Without CASE and --suite, all cases are taken\n"
    "except those of random, theories and rate, which take long.\n"
    "\n"
    "  --suite S[,S]     take the cases of these suites instead (see pulloff list)\n"
    "  --output DIR      folder to which the records are written (default "
    "build/run)\n" PO_SESSION_JOBS_HELP PO_SESSION_POINTS_HELP
    "  --shard K/N       solve only the K-th of N parts of all points, so that N machines can\n"
    "                    share a run; pulloff merge combines the parts\n"
    "  --summary FILE    write one row for each point to FILE, as CSV: the keys that vary, "
    "status,\n"
    "                    pull-off, energy lost, and their errors, in SI units if the scenes are;\n"
    "                    - is standard output\n" PO_SESSION_SOLVE_HELP
    "  -h, --help        print this text\n"
    "\n"
    "For a case whose scenes are drawn at random, a summary is printed: the number of solves with\n"
    "each status, their times, and for each failure its reason and the command that repeats it.\n"
    "\n"
    "Example: pulloff run fig03 --jobs 2\n"
    "         pulloff run --suite paper --shard 1/4 --output shards/1\n";

static const po_option OPTIONS[] = {PO_SESSION_OPTIONS,
                                    PO_TAKEN("shard", po_session, shard, po_session_take_shard),
                                    PO_TEXT("summary", po_session, summary, "the name of a file"),
                                    {0}};

int po_verb_run(int argc, char **argv) {
  const po_options options = {"run", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  po_session session = po_session_default();
  po_status status = PO_OK;
  if (!po_options_read(&options, &session, &status))
    return po_options_end(status);
  status = po_session_run(&session, argv + optind, (size_t)(argc - optind));
  if (!status && session.summary)
    status = po_run_summary_write(session.summary, session.runs, session.run_count);
  return po_session_end(&session, status);
}
