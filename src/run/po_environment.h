/* Which program this is, made of what, running where. */
#ifndef PO_ENVIRONMENT_H
#define PO_ENVIRONMENT_H

#include "po_digest.h"
#include "po_json_value.h"

/* {"pulloff", "compiler", "gsl", "openblas", "lapacke", "jansson", "libyaml"}; `openblas` is what
 * the numbers were computed with. */
json_t *po_environment_versions(const char *openblas);

/* {"system", "machine", "processor", "cores", "jobs", "date"}. */
json_t *po_environment_describe(int jobs);

/* The number of processors this process may run on. */
int po_environment_cores(void);

/* What determines every bit of a number, beside the scene: two runs of equal arithmetic give the
 * same numbers. */
typedef struct {
  char program[PO_DIGEST_LENGTH]; /* a digest of the executable */
  char openblas[256]; /* the library that it uses, with its kernels: po_linear_library */
  char kernels[32];   /* the kernels alone: po_linear_kernels */
} po_arithmetic;

/* The arithmetic of this process; the digest of the executable is left out if the system has no
 * /proc/self/exe. Status: PO_CANNOT_READ if the executable cannot be read, as results would be
 * taken for those of another program; PO_NO_MEMORY. */
po_status po_environment_arithmetic(po_arithmetic *own);

/* A digest of an arithmetic. */
void po_arithmetic_digest(const po_arithmetic *arithmetic, char digest[PO_DIGEST_LENGTH]);

/* The folder that holds cases/, reference/ and reports/: PULLOFF_DATA of the environment, else the
 * source tree this program was built from. */
const char *po_environment_data(void);

#endif
