/* The pull-off along a series of scenes (parameter continuation). Some scenes, the checkpoints, are
 * traced completely; between them the minima of the load are followed from scene to scene, at a few
 * factorisations for each. The deepest of the followed minima is the pull-off of a scene between,
 * if the followed minima agree with both traces; otherwise the scene half way between is traced,
 * and the method is applied to both halves. doc/cases.md, "Follow", has the rule, and what it
 * misses. A trace ends where the sphere is pressed enough; a minimum beyond that end is not the
 * pull-off, although it can be followed. */
#ifndef PO_SERIES_H
#define PO_SERIES_H

#include "po_request.h"
#include "po_result.h"

/* The default number of scenes from one checkpoint to the next. */
enum { PO_CHECKPOINT_EVERY = 15 };

/* Computes the pull-off of all scenes of a series. Given: requests, `count` of neighbouring scenes
 * that differ in keys of the scene only; checkpoint_every, at least 1, the largest number of scenes
 * from one checkpoint to the next. Minima are followed between two scenes if both are elastic and
 * on panels, both wavy or both smooth, both bounded or both unbounded, and only the pull-off is
 * wanted; other scenes, as those of a viscoelastic body, are traced. Returned: a result for each
 * scene, to be cleared whatever the status. The member `followed` is true if the pull-off was
 * followed; the result then contains the pull-off with its error estimates, and the work, including
 * that of minima which are not the deepest, but no folds, extrema, start or end. Status:
 * PO_INTERRUPTED, PO_NO_MEMORY; a trace that fails does not fail the series. */
po_status po_series_pull_offs(const po_request *requests, size_t count, size_t checkpoint_every,
                              po_result *results);

/* Traces the first scene and follows each of its folds from scene to scene. Two folds that merge
 * end there; folds that appear later in the series are not found. Given: requests, `count` of
 * neighbouring scenes, elastic and on panels, all wavy or all smooth, all bounded or all unbounded.
 * Returned: a result for each scene, to be cleared whatever the status: for the first scene that of
 * its trace; for the others `followed` and as many folds as the first scene has, in its order, with
 * error estimates but without energy and position; approach and load are NAN from the scene on
 * where a fold has ended. Status: PO_INTERRUPTED, PO_NO_MEMORY; PO_BAD_INPUT for other scenes. A
 * trace that fails does not fail the series. */
po_status po_series_folds(const po_request *requests, size_t count, po_result *results);

/* Counts the scenes of a series of which a trace or a followed minimum has been seen, and shows
 * their number after every point of a trace. */
typedef struct {
  void (*show)(void *user, size_t seen);
  void *user;
  size_t seen;
} po_series_progress;

/* Makes the requests of a series report to *progress, which must exist while they are solved.
 * Returned: an object to be freed afterwards; NULL with a message if memory runs out. */
void *po_series_watch(po_request *requests, size_t count, po_series_progress *progress);

#endif
