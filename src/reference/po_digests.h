/* The stored digests of the results of a case: the table pins/NAME.digests.csv in the folder of the
 * case file, with the columns point, digest and pull_off_force ("-": none), a row each point. The
 * force says by how much a result with another digest differs. */
#ifndef PO_DIGESTS_H
#define PO_DIGESTS_H

#include "po_case.h"
#include "po_reference_table.h"

/* Opens the table; if there is none, the status is PO_OK, and it has no rows. The caller closes it
 * with po_reference_close. Status: PO_CANNOT_READ with file and line, PO_NO_MEMORY. */
po_status po_digests_open(const po_case *kase, po_reference *digests);

/* Looks up a point. Returned: in *digest, its digest, which belongs to the table; in *force, its
 * pull-off force in pi w R, NAN: none. Status: PO_NOT_FOUND, PO_CANNOT_READ. */
po_status po_digests_find(const po_reference *digests, size_t point, const char *id,
                          const char **digest, double *force);

#endif
