/* Options and keys that have no effect. If one were ignored silently, the user would misread the
 * result. */
#ifndef PO_USE_H
#define PO_USE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* An option or a key, whether it was given, and whether it has an effect in the present use. */
typedef struct {
  char name[48]; /* with the dashes of an option */
  bool given, taken;
} po_use;

/* Refuses the first one that was given although it has no effect on `what`, and names those that
 * have an effect. Status: PO_BAD_INPUT, PO_OK. */
po_status po_use_check(const char *what, const po_use *uses, size_t count);

#endif
