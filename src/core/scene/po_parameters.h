/* Parameters in the text that names a law or a profile. */
#ifndef PO_PARAMETERS_H
#define PO_PARAMETERS_H

#include <stdbool.h>
#include <stddef.h>

/* Reads `count` numbers from "4,10", or "4;10" as in tables with commas. False if the text is not
 * exactly so many numbers; then values may have changed. */
bool po_parameters_read(const char *text, size_t count, double *values);

/* Returned: whether `text` is `name`, or `name` and a colon; *rest is then what follows the colon,
 * or NULL. */
bool po_parameters_follow(const char *text, const char *name, const char **rest);

#endif
