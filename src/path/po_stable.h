/* The stable parts of a curve of equilibria at given approach (displacement control) or at given
 * load (load control), and the equilibria at which jumps end (po_loop.h gives the reason). */
#ifndef PO_STABLE_H
#define PO_STABLE_H

#include <stdbool.h>

#include "po_path.h"

/* The controlled quantity at a point of the curve: its approach (eps) or its load (pi w R). */
double po_stable_controlled(const po_path *path, po_control control, size_t point);
po_path_axis po_stable_axis(po_control control);

/* Returned: whether the segment from a point to the next is stable: there are no unstable modes,
 * and the controlled quantity increases. Under load control the approach must increase too. */
bool po_stable_is(const po_path *path, po_control control, size_t point);

/* Finds the next stable place along the curve, from point `from` upwards (by = 1) or before it
 * downwards (by = -1), at which the controlled quantity has a value. Returned: false if there is
 * none. */
bool po_stable_find(const po_path *path, po_control control, size_t from, int by, double value,
                    po_path_place *found);

/* Returned: the state of complete separation under a load: approach -INFINITY, position NAN. */
po_path_state po_stable_apart(double load);

/* Returned: the potential whose decrease a jump dissipates: U under displacement control, U - W
 * approach under load control. After complete separation it is 0 at load 0, and NAN under tension,
 * where it decreases without bound. */
double po_stable_potential(po_control control, const po_path_state *state);

/* Returned: the loss in one jump. Given: its ends, and the doubt where it ends. */
po_loss po_loss_of_jump(po_control control, const po_path_state *before, const po_path_state *after,
                        po_path_doubt doubt);

/* Returned: the loss in the jumps of both. */
po_loss po_loss_sum(po_loss a, po_loss b);

#endif
