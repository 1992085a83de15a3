/* Curves and profiles as CSV. */
#ifndef PO_TABLES_H
#define PO_TABLES_H

#include "po_request.h"
#include "po_result.h"
#include "po_status.h"

/* Writes position,approach,load,energy,contact_radius,unstable_modes along the branch, under
 * headers that say which scene it is, in which units, and the checksum of all other lines.
 * Returned: that checksum, unless `digest` is NULL. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_tables_write_curve(const char *path, const po_request *request,
                                const po_result *result, char *digest);

/* Writes radius,gap,traction at result->profile_approach. */
po_status po_tables_write_profile(const char *path, const po_request *request,
                                  const po_result *result, char *digest);

/* Writes the steps of both staircases, a row each. */
po_status po_tables_write_staircase(const char *path, const po_request *request,
                                    const po_result *result, char *digest);

/* Read back what the first two wrote into result->curve, result->profile, when it is what has the
 * checksum `digest`. Status: PO_CANNOT_READ. */
po_status po_tables_read_curve(const char *path, const char *digest, po_result *result);
po_status po_tables_read_profile(const char *path, const char *digest, po_result *result);

#endif
