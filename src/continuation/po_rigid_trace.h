/* The loading curve of a rigid scene: its load is that of po_rigid.h, and the approach is the
 * parameter of the curve. */
#ifndef PO_RIGID_TRACE_H
#define PO_RIGID_TRACE_H

#include "po_continuation.h"

/* Visits the loading curve as po_continuation_run does: points, extrema of the load, stations and
 * end. gap and traction of the points are NULL: the gap is shape - approach. Given: the first
 * approach, eps; options with an end below 1. Status: PO_BAD_INPUT. */
po_status po_rigid_trace(const po_scene *scene, double begin,
                         const po_continuation_options *options);

#endif
