/* Which program this is, made of what, running where. */
#ifndef PO_ENVIRONMENT_H
#define PO_ENVIRONMENT_H

#include "po_digest.h"
#include "po_json_value.h"

/* {"pulloff", "compiler", "gsl", "openblas", "lapacke", "jansson", "libcyaml"}. */
json_t *po_environment_versions(void);

/* {"system", "machine", "processor", "cores", "jobs", "date"}. */
json_t *po_environment_describe(int jobs);

/* The number of processors this process may run on. */
int po_environment_cores(void);

/* A digest of the running program and of the algebra under it: two runs under the same digest give
 * the same numbers. */
void po_environment_digest(char digest[PO_DIGEST_LENGTH]);

/* The folder that holds cases/, reference/ and reports/: PULLOFF_DATA of the environment, else the
 * source tree this program was built from. */
const char *po_environment_data(void);

#endif
