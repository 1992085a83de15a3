/* The theories beside a solve, for the terminal. */
#ifndef PO_PRINT_THEORIES_H
#define PO_PRINT_THEORIES_H

#include "po_physical.h"
#include "po_result.h"

/* Prints one line with the deviations of the best known theories; nothing without any. */
void po_print_theories_line(const po_result *result);

/* Prints the table of the theories and their sources. Given: `only`, the one to be printed, or NULL
 * for all; the units for a column in N, or NULL. */
void po_print_theories(const po_result *result, const po_theory *only, const po_units *units);

#endif
