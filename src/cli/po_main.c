/* The program pulloff: solves the adhesive contact of a sphere with axisymmetric waviness, checks
 * the results against references, and writes a report. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "po_options.h"
#include "po_verbs.h"

int main(int argc, char **argv) {
  signal(SIGXFSZ, SIG_IGN); /* writing beyond the file-size limit then fails with EFBIG */
  int code = po_verbs_run(argc, argv);
  /* If memory ran out somewhere, the output may be incomplete. */
  if (code == PO_EXIT_OK && po_no_memory_or(PO_OK))
    code = po_options_end(PO_NO_MEMORY);
  /* Buffered output may still fail to be written, e.g. on a full disk. */
  if ((fflush(stdout) != 0 || ferror(stdout)) && code == PO_EXIT_OK) {
    po_fail(PO_CANNOT_WRITE, "standard output cannot be written: %s", strerror(errno));
    return po_options_end(PO_CANNOT_WRITE);
  }
  return code;
}
