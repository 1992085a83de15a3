#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff run [OPTION]... [CASE]...\n"
    "Solves cases, points side by side, and keeps a record of each. What an earlier run left and\n"
    "still holds is kept. CASE is a name (see pulloff list) or the path of a YAML file; without\n"
    "any, all cases but those of the suite random, which is long.\n\n"
    "  --suite S[,S]   the cases of these suites\n"
    "  --output DIR    where the records go (build/run)\n"
    "  --jobs N        points solved side by side (0: all cores); the numbers do not depend\n"
    "                  on it\n"
    "  --points A[-B]  only these points of each case, counted from 0; they are kept for a run of\n"
    "                  the whole\n"
    "  --shard K/N     only the K-th of N parts of all points, for one of several machines; see\n"
    "                  pulloff merge\n"
    "  --time-limit S  seconds of processor time a solve may take, instead of what the case says\n"
    "  --fresh         solve again what is there\n"
    "  -h, --help      this text\n\n"
    "Of a case whose scenes are drawn at random a summary is printed: how many ended how, what "
    "they\n"
    "took, and for each failure its reason and the line that repeats it.\n\n"
    "Example: pulloff run fig03 --jobs 2\n"
    "         pulloff run --suite paper --shard 1/4 --output shards/1\n";

static const struct option OPTIONS[] = {
    PO_SESSION_OPTIONS, {"shard", required_argument, NULL, PO_SESSION_SHARD}, {NULL, 0, NULL, 0}};

int po_verb_run(int argc, char **argv) {
  const po_options options = {"run", HELP, OPTIONS, argc, argv};
  po_session session = po_session_default();
  po_status status = PO_OK;
  if (!po_options_read(&options, po_session_option, &session, &status))
    return po_options_end(status);
  status = po_session_run(&session, argv + optind, (size_t)(argc - optind));
  return po_session_end(&session, status);
}
