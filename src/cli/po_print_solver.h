/* Says which program of the user is run. */
#ifndef PO_PRINT_SOLVER_H
#define PO_PRINT_SOLVER_H

#include <stdio.h>

#include "po_solver.h"

/* Prints the name of a solver, its manifest, the value of its knob, and its command. */
void po_print_solver(const po_solver *solver, FILE *stream);

#endif
