#include <stdio.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_merge.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff merge [OPTION]... DIR...\n"
    "Puts the shards of a run together: compares, and writes the records, which are those of one\n"
    "run of the whole, but for times. DIR are the folders pulloff run --shard K/N wrote to, in "
    "any\n"
    "order. All N shards must be present and finished, computed by this program for these cases,\n"
    "and with the same kernels of OpenBLAS; the kernels of this machine do not matter.\n\n"
    "  --output DIR    where the records go (build/run)\n"
    "  -h, --help      this text\n\n"
    "Example: pulloff merge shards/1 shards/2 shards/3 shards/4\n";

static const struct option OPTIONS[] = {{"output", required_argument, NULL, PO_SESSION_OUTPUT},
                                        {"help", no_argument, NULL, PO_OPTION_HELP},
                                        {NULL, 0, NULL, 0}};

/* A run reuses records only with the OpenBLAS kernels that computed them. */
static void tell_kernels(const po_arithmetic *arithmetic) {
  po_arithmetic own;
  if (!po_environment_arithmetic(&own) && strcmp(arithmetic->kernels, own.kernels) != 0)
    fprintf(stderr,
            "pulloff: solved with the OpenBLAS kernels %s, here they are %s: a later run keeps "
            "these records with OPENBLAS_CORETYPE=%s, else it solves again\n",
            arithmetic->kernels, own.kernels, arithmetic->kernels);
}

static po_status put_together(po_session *session, const po_merge *merge) {
  char **names = NULL;
  size_t count = 0;
  const po_arithmetic arithmetic = po_merge_arithmetic(merge);
  session->time_limit = po_merge_time_limit(merge);
  session->arithmetic = &arithmetic;
  po_status status = po_merge_cases(merge, &names, &count);
  if (!status)
    status = po_session_open(session, names, count);
  if (!status)
    status = po_merge_fill(merge, session->runs, session->catalog.count);
  if (!status)
    status = po_session_solve(session); /* nothing is left to solve */
  if (status == PO_INTERRUPTED)
    po_fail(status, "interrupted; the shards are as they were, merge them again");
  session->arithmetic = NULL;
  if (!status)
    tell_kernels(&arithmetic);
  po_names_free(names, count);
  return status;
}

int po_verb_merge(int argc, char **argv) {
  const po_options options = {"merge", HELP, OPTIONS, argc, argv};
  po_session session = po_session_default();
  po_merge merge = {0};
  po_status status = PO_OK;
  if (!po_options_read(&options, po_session_option, &session, &status))
    return po_options_end(status);
  if (optind == argc)
    status =
        po_fail(PO_BAD_INPUT, "merge needs the folders of the shards (see pulloff merge --help)");
  if (!status)
    status = po_merge_open(argv + optind, (size_t)(argc - optind), &merge);
  if (!status)
    status = put_together(&session, &merge);
  po_merge_close(&merge);
  return po_session_end(&session, status);
}
