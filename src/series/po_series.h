/* The pull-off along a line of scenes: some are traced, the checkpoints; between them the minima of
 * the load are followed from scene to scene, at a few factorisations each.
 *
 * A trace finds all minima of its scene. From either of two neighbouring checkpoints every minimum
 * is followed to the other that is not much shallower than the deepest there, and the deepest of
 * those followed is the pull-off of a scene between. That holds when what was followed agrees
 * with the trace it arrives at: no minimum arrives deeper than the pull-off traced there, none
 * ended on the way as the deepest, and what is the deepest anywhere between is a minimum that
 * both traces came to, well before they ended: a trace ends where the sphere is pressed enough,
 * and what lies beyond is not the pull-off, though it can be followed. At mu = 3, lambda = 50, R
 * = 200 the minimum that pulls off with 5.8 at A = 5.6 is beyond at 5.74. Where it does not
 * agree the scene half way between is traced, and so on. So every pull-off is traced, or lies
 * between two traces that agree with what was followed between them. Not seen is a minimum that
 * becomes the deepest and ceases to be so between two checkpoints, and is much shallower, or beyond
 * the ends, at either of them.
 */
#ifndef PO_SERIES_H
#define PO_SERIES_H

#include "po_request.h"
#include "po_result.h"

/* Scenes from one checkpoint to the next when nobody says otherwise. */
enum { PO_CHECKPOINT_EVERY = 15 };

/* Given: requests of neighbouring scenes, `count` of them, that differ in some keys of the scene;
 * how far checkpoints are apart at most, at least 1. Scenes are followed when both are elastic, on
 * panels, wavy both or neither, bounded both or neither, and nothing but the pull-off is wanted;
 * others are traced. Returned: a result for each, to be cleared whatever the status; `followed`
 * says how it was had. Of one that was followed there are the pull-off with its errors, and the
 * work, that of minima which turned out not to be the deepest included; no folds, extrema, start,
 * end. Status: PO_INTERRUPTED, PO_NO_MEMORY; a trace that fails is no failure of the line. */
po_status po_series_observe(const po_request *requests, size_t count, size_t checkpoint_every,
                            po_result *results);

#endif
