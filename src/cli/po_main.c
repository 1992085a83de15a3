/* pulloff: adhesion of a sphere with axisymmetric waviness, solved, checked and reported. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "po_options.h"
#include "po_verbs.h"

int main(int argc, char **argv) {
  const int code = po_verbs_run(argc, argv);
  /* What was printed may still fail to arrive, e.g. on a full disk. */
  if ((fflush(stdout) != 0 || ferror(stdout)) && code == PO_EXIT_OK) {
    po_fail(PO_CANNOT_WRITE, "standard output cannot be written: %s", strerror(errno));
    return po_options_end(PO_CANNOT_WRITE);
  }
  return code;
}
