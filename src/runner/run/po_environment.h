/* The program, the versions of its libraries, and the machine. */
#ifndef PO_ENVIRONMENT_H
#define PO_ENVIRONMENT_H

#include "po_digest.h"
#include "po_json_value.h"

/* Returned: {"pulloff", "compiler", "gsl", "openblas", "lapacke", "jansson", "libyaml"}. */
json_t *po_environment_versions(void);

/* Returned: {"system", "machine", "processor", "cores", "jobs", "date"}. */
json_t *po_environment_describe(int jobs);

/* Returned: the number of processors on which this process may run. */
int po_environment_cores(void);

/* Returned: in `digest`, that of version, compiler and executable. Two runs of the same program
 * give equal results for a scene, to the last bit, whatever the machine. If the system has no
 * /proc/self/exe, it does not depend on the executable. Status: PO_CANNOT_READ (the executable
 * cannot be read, so that results could be mistaken for those of another program), PO_NO_MEMORY. */
po_status po_environment_program(char digest[PO_DIGEST_LENGTH]);

/* Returned: the folder that contains cases/, reference/ and reports/. It is, in this order: that of
 * the environment variable PULLOFF_DATA; the source tree, which the file `data-folder.txt` beside
 * the program names in a build folder; the data folder of the installation, first by its path
 * relative to the program, so that an installed tree can be moved, then by the prefix. The pointer
 * stays valid. Not for several threads at once. */
const char *po_environment_data(void);

#endif
