/* The relaxed contact of a viscoelastic body at the preload, by loading it slowly. */
#ifndef PO_RATE_LOADING_H
#define PO_RATE_LOADING_H

#include <stdbool.h>

#include "po_equilibrium.h"
#include "po_request.h"
#include "po_solution.h"
#include "po_surface.h"

typedef struct {
  const po_request *request;
  po_surface *surface;
  po_preload preload;
  po_solution *reached; /* the last state of loading at given approach */
  po_solution *first;   /* its first state */
  double greatest;      /* approach */
  double load;          /* of the preload, pi w R; NAN: none */
  po_preload low, high; /* of loading: the last state below that load, and one that reaches it */
  bool met;
  size_t most_nodes;
  po_status status;
} po_relaxed_loading;

/* Whether a body is loaded at a speed: otherwise it is relaxed at the preload. */
bool po_rate_is_loaded(const po_request *request);

/* Loads to the preload. Given: *e, NULL; in l the request, the surface, the preload, its load, and
 * room for the first and the last state. Returned: *e, to be destroyed whatever the status; the
 * rest of l. Status: PO_NOT_FOUND if the preload is not reached; PO_NOT_CONVERGED if its load is
 * not; those of po_continuation_run. */
po_status po_rate_load_relaxed(const po_request *request, po_equilibrium **e,
                               po_relaxed_loading *l);

#endif
