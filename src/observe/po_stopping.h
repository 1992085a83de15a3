/* The stopping rule: where the trace of a branch ends.
 *
 * The trace ends at the preload: at the first stable equilibrium at which loading at given approach
 * has reached the approach or the load of the preload. If the request has no preload, it is the
 * load pi w R (po_request_preload).
 *
 * If the request asks for what harder preloads give (po_request_search), the trace goes on beyond.
 * It ends where no minimum of the load beyond can be deeper than the deepest so far, by the bound
 * of the request, or at 100 pi w R. The bound applies to a contact without grooves, so it is
 * compared with the radius of the disc in contact about the axis.
 *
 * The load of a smooth sphere has one minimum, so no preload changes its pull-off. If no preload is
 * given, its trace ends at the first stable equilibrium under compression beyond the minimum. */
#ifndef PO_STOPPING_H
#define PO_STOPPING_H

#include <stdbool.h>

#include "po_branch_point.h"
#include "po_contact.h"
#include "po_request.h"
#include "po_result.h"

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

/* Whether the trace only searches for what harder preloads give: the preload is met, or any is
 * asked for and the usual one is met. */
bool po_stopping_is_searching(const po_stopping *stopping);

/* Whether no minimum of the load beyond what was traced can be below a load. */
bool po_stopping_is_complete(const po_stopping *stopping, double load);

/* Why a trace may end at a point; PO_END_NONE: it may not. */
po_end_cause po_stopping_cause(const po_stopping *stopping, const po_branch_point *point);

#endif
