/* The stable stretches of a curve of equilibria at given approach, or at given load, and where a
 * jump lands among them (po_loop.h says why there). */
#ifndef PO_STABLE_H
#define PO_STABLE_H

#include <stdbool.h>

#include "po_path.h"

typedef enum { PO_DISPLACEMENT_CONTROL, PO_LOAD_CONTROL } po_control;

/* What is given at a point of the curve: its approach (eps) or its load (pi w R). */
double po_stable_driven(const po_path *path, po_control control, size_t point);
po_path_axis po_stable_axis(po_control control);

/* Whether the curve from a point to the next is stable: no unstable modes, and the driven quantity
 * rises. At given load the approach is free, too, and the load must rise with it. */
bool po_stable_is(const po_path *path, po_control control, size_t point);

/* The next stable place along the curve, from point `from` upwards (by = 1) or from before it
 * downwards (by = -1), at which the driven quantity has a value. Returned: false: there is none. */
bool po_stable_find(const po_path *path, po_control control, size_t from, int by, double value,
                    po_path_place *found);

/* The bodies apart for ever under a load: approach -INFINITY, position NAN. */
po_path_state po_stable_apart(double load);

/* What a jump loses: U, or U - W approach at given load; 0 apart without a load, NAN apart under
 * tension, where it falls without bound. */
double po_stable_potential(po_control control, const po_path_state *state);

#endif
