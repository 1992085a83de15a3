/* A measure of where on the branch a state is that does not depend on the mesh: the approach, the
 * load and the amount of contact, integral of (1 + H)^-2 dr, each scaled to be of order one. */
#ifndef PO_ARCLENGTH_H
#define PO_ARCLENGTH_H

#include "po_equilibrium.h"

enum { PO_ARCLENGTH_SIZE = 3 };

/* The three numbers of the state last evaluated, and their changes with a change of state. */
void po_arclength_values(const po_equilibrium *e, const double *state,
                         double value[PO_ARCLENGTH_SIZE]);
void po_arclength_rates(const po_equilibrium *e, const double *state, const double *change,
                        double rate[PO_ARCLENGTH_SIZE]);

/* direction . values */
double po_arclength_along(const double direction[PO_ARCLENGTH_SIZE],
                          const double value[PO_ARCLENGTH_SIZE]);

/* The gradient of direction . values by the state: a border. */
void po_arclength_border(const po_equilibrium *e, const double *state,
                         const double direction[PO_ARCLENGTH_SIZE], double *border);

#endif
