/* pulloff: adhesion of a sphere with axisymmetric waviness, solved, checked and reported. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "po_options.h"
#include "po_verbs.h"

int main(int argc, char **argv) {
  signal(SIGXFSZ, SIG_IGN); /* a file that would grow too large is a write that fails */
  int code = po_verbs_run(argc, argv);
  /* Memory that was lacking somewhere on the way: the output may be incomplete. */
  if (code == PO_EXIT_OK && po_no_memory_or(PO_OK))
    code = po_options_end(PO_NO_MEMORY);
  /* What was printed may still fail to arrive, e.g. on a full disk. */
  if ((fflush(stdout) != 0 || ferror(stdout)) && code == PO_EXIT_OK) {
    po_fail(PO_CANNOT_WRITE, "standard output cannot be written: %s", strerror(errno));
    return po_options_end(PO_CANNOT_WRITE);
  }
  return code;
}
