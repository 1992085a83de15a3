/* The stopping rule: where the trace of a branch ends.
 *
 * The trace ends where the declared preload is met: at the first stable equilibrium beyond which
 * loading at given approach has come to that approach, or to that load. Nobody else says so: by
 * default the sphere is pressed with the load pi w R. What a harder preload would give is found by
 * a preload of INFINITY, or with the staircase wanted: then the trace goes on until no minimum of
 * the load beyond can be as deep as the deepest so far, by the bound of the request, or until the
 * load is a hundred times pi w R. The bound is that of a contact without grooves: what counts is
 * the disc in contact about the axis.
 *
 * A smooth sphere has one minimum of the load, whatever it is pressed with: if no preload is given,
 * its trace ends at the first stable equilibrium under compression beyond that. */
#ifndef PO_STOPPING_H
#define PO_STOPPING_H

#include <stdbool.h>

#include "po_branch.h"
#include "po_contact.h"
#include "po_outcome.h"

typedef struct {
  const po_request *request;
  po_preload preload; /* that the trace must come to */
  bool has_minimum;
  double deepest; /* load of the deepest minimum so far */
  double enough;  /* contact radius beyond which none is deeper, by the bound of the request; NAN:
                     not known */
  /* Of loading at given approach, which follows the points at which the approach exceeds all
   * before: greatest approach, greatest load. -INFINITY: none yet. */
  double greatest_approach, greatest_load;
  double carried; /* greatest load under which loading at given load is stable */
  double disc;    /* greatest disc in contact without a groove, in loading; looked at where the
                     contact radius is enough, or all of the surface is in contact; eps */
  bool met;       /* the preload: minima beyond are not the pull-off's */
  double effort;  /* spent on points so far, see po_stopping.c */
  double before;  /* on those up to the preload */
  double margin;  /* how near the trace has been to its end: the least distance of what is loaded
                     from the preload; at most 1 */
} po_stopping;

po_stopping po_stopping_begin(const po_request *request);

/* Takes note of a minimum of the load. Returned: whether it is the deepest so far, and of those up
 * to the preload. */
bool po_stopping_note_minimum(po_stopping *stopping, double load);

/* Takes note of a point. Given: the gap there, and its contact radius. */
void po_stopping_note_point(po_stopping *stopping, const po_branch_point *point,
                            const po_contact_gap *gap, double contact_radius);

/* Whether the trace only searches for what harder preloads give: the preload is met, or any is asked
 * for and the usual one is met. */
bool po_stopping_is_searching(const po_stopping *stopping);

/* Whether no minimum of the load beyond what was traced can be below a load. */
bool po_stopping_is_complete(const po_stopping *stopping, double load);

/* Why a trace may end at a point; PO_END_NONE: it may not. */
po_end_cause po_stopping_cause(const po_stopping *stopping, const po_branch_point *point);

#endif
