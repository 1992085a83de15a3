/* What a test measures, coming from a preload, in displacement and in load control. */
#ifndef PO_HYSTERESIS_H
#define PO_HYSTERESIS_H

#include "po_loop.h"

typedef struct {
  po_loop displacement, load;
} po_hysteresis;

/* Both loops along a curve. In load control loading is reversed at the load of the preload in
 * displacement control, or under no load where that is in tension. Given: a preload that says
 * approach or load, the load >= 0. Returned: to be given to po_hysteresis_clear. Status:
 * as po_loop_follow. */
po_status po_hysteresis_follow(const po_path *path, po_preload preload, po_hysteresis *hysteresis);
void po_hysteresis_clear(po_hysteresis *hysteresis);

#endif
