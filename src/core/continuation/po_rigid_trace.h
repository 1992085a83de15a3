/* The loading curve of a rigid scene. The approach is the parameter of the curve, and the load is
 * that of po_rigid.h. */
#ifndef PO_RIGID_TRACE_H
#define PO_RIGID_TRACE_H

#include "po_continuation.h"

/* Visits the points of the loading curve, its extrema of the load, stations and end, as
 * po_continuation_run does. The points have no nodes and no gaps: the gap is the initial gap less
 * the approach. Given: begin, the first approach, eps; options whose end is an approach that rigid
 * bodies can reach. Status: PO_BAD_INPUT if they cannot; as po_rigid_load. */
po_status po_rigid_trace(const po_scene *scene, double begin,
                         const po_continuation_options *options);

#endif
