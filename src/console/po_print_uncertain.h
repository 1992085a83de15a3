/* Prints the uncertainty of the pull-off force by that of the inputs. */
#ifndef PO_PRINT_UNCERTAIN_H
#define PO_PRINT_UNCERTAIN_H

#include "po_profile.h"
#include "po_result.h"

/* A line for the noise of a smoothed table, or one that recommends to smooth it; nothing if the
 * rows determine the table well. Given: a table. */
void po_print_smoothing(const po_profile *profile);

/* A line for each source, and one for all. Given: the unit of the force, as a factor and by name.
 */
void po_print_uncertain(const po_result *result, double unit, const char *name);

#endif
