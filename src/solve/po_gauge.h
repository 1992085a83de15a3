/* A measure of where on the branch a state is that does not depend on the mesh: the approach, the
 * load and the amount of contact, integral of (1 + H)^-2 dr, each scaled to be of order one. */
#ifndef PO_GAUGE_H
#define PO_GAUGE_H

#include "po_equilibrium.h"

enum { PO_GAUGE_SIZE = 3 };

/* The three numbers of the state last evaluated, and their changes with a change of state. */
void po_gauge_values(const po_equilibrium *e, const double *state, double value[PO_GAUGE_SIZE]);
void po_gauge_rates(const po_equilibrium *e, const double *state, const double *change,
                    double rate[PO_GAUGE_SIZE]);

/* direction . values */
double po_gauge_along(const double direction[PO_GAUGE_SIZE], const double value[PO_GAUGE_SIZE]);

/* The gradient of direction . values by the state: a border. */
void po_gauge_border(const po_equilibrium *e, const double *state,
                     const double direction[PO_GAUGE_SIZE], double *border);

#endif
