/* The loops that a test measures from a given preload, under displacement control and under load
 * control. */
#ifndef PO_HYSTERESIS_H
#define PO_HYSTERESIS_H

#include "po_loop.h"

/* Computes both loops along a curve of equilibria. The load-controlled loop is reversed at the load
 * of the displacement-controlled preload, or at load 0 if that load is tensile. Given: a preload
 * with an approach or a load >= 0. Returned: hysteresis, to be cleared with po_hysteresis_clear.
 * Status: as po_loop_follow. */
po_status po_hysteresis_follow(const po_path *path, po_preload preload, po_hysteresis *hysteresis);
#endif
