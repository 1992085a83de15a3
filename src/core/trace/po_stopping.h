/* Where the trace of a branch ends: doc/method.md, "The stopping rule". The bound of a search
 * applies to a contact without grooves, so it is compared with the radius of the disc in contact
 * about the axis. */
#ifndef PO_STOPPING_H
#define PO_STOPPING_H

#include <stdbool.h>

#include "po_branch_point.h"
#include "po_contact.h"
#include "po_path.h"
#include "po_request.h"
#include "po_result.h"

typedef struct {
  const po_request *request;
  po_preload preload; /* the preload of the request, po_request_preload */
  bool has_minimum;
  double deepest; /* load of the deepest minimum so far */
  double enough;  /* contact radius, eps, beyond which no minimum is deeper, by the bound of the
                     request; NAN: unknown */
  /* Greatest approach and greatest load of loading at given approach, which visits the points whose
   * approach exceeds that of all points before; -INFINITY: none yet. */
  double greatest_approach, greatest_load;
  double carried; /* greatest load under which loading at given load is stable */
  double
      disc; /* radius, eps, of the greatest disc in contact without a groove, in loading; computed
               only if the contact radius exceeds `enough` or the whole surface is in contact */
  bool met; /* the preload is met: later minima do not count for the pull-off */
  double effort; /* effort of all points so far, see po_stopping.c */
  double before; /* effort of the points up to the preload */
  double margin; /* least distance, at most 1, of approach and load from the preload in loading: a
                    small value means that a slightly different scene might have ended there */
} po_stopping;

po_stopping po_stopping_begin(const po_request *request);

/* Adds a minimum of the load. Returned: whether it is the deepest so far and before the preload. */
bool po_stopping_note_minimum(po_stopping *stopping, double load);

/* Adds a point. Given: its gap and its contact radius, eps. */
void po_stopping_note_point(po_stopping *stopping, const po_branch_point *point,
                            const po_contact_gap *gap, double contact_radius);

/* Whether the trace is a search for harder preloads: the preload is met, or the preload is INFINITY
 * and the default one is met. */
bool po_stopping_is_searching(const po_stopping *stopping);

/* Whether no minimum of the load beyond the present end of the trace can be below a load, pi w R.
 */
bool po_stopping_is_complete(const po_stopping *stopping, double load);

/* The cause for which the trace ends at a point; PO_END_NONE if it continues. */
po_end_cause po_stopping_cause(const po_stopping *stopping, const po_branch_point *point);

#endif
