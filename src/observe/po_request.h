/* One scene, and what is wanted of it. */
#ifndef PO_REQUEST_H
#define PO_REQUEST_H

#include <signal.h>
#include <stdbool.h>

#include "po_hysteresis.h"
#include "po_scene.h"
#include "po_staircase.h"
#include "po_status.h"
#include "po_surface.h"

enum {
  PO_WANT_CURVE = 1,       /* the points of the branch */
  PO_WANT_PROFILE = 2,     /* gap and traction over the radius at one equilibrium */
  PO_WANT_HYSTERESIS = 4,  /* loading to a preload and back */
  PO_WANT_DIAGNOSTICS = 8, /* residuals, condition numbers, digits left; solves the scene anew */
  PO_WANT_PRELOAD = 16,    /* what every preload gives: the staircases */
};

/* Whether a trace goes on beyond its preload, to find what harder ones give. */
typedef enum {
  PO_SEARCH_NONE,
  PO_SEARCH_SOME, /* until none gives more, but at most for about as long as it took so far */
  PO_SEARCH_ALL,  /* until none gives more, or the hardest preload that is looked at */
} po_search;

/* What a closed-form theory says of a scene, evaluated beside the solve. po_companion_jkr.h is one.
 */
typedef struct {
  /* The contact radius, in eps, beyond which no equilibrium has a load, in pi w R, below a given
   * one; NAN: not known. */
  double (*bound)(const po_scene *scene, double load);
  /* The loops of loading and unloading from a preload, and the staircases in displacement and load
   * control; to be cleared whatever the status, which is PO_NO_MEMORY or says that there are none.
   * NULL: the theory does not give them. */
  po_status (*hysteresis)(const po_scene *scene, po_preload preload, po_hysteresis *hysteresis);
  po_status (*staircases)(const po_scene *scene, po_staircase staircase[2]);
} po_companion;

typedef struct {
  po_scene scene;
  po_mesh mesh;                  /* scheme, grading, number of nodes */
  double approach_start;         /* where the trace begins, in eps; NAN: far out, found by itself */
  double approach_end;           /* where it ends, in eps; NAN: at the preload, see po_stopping.h */
  unsigned want;                 /* PO_WANT_... */
  double profile_approach;       /* in eps, first passage along the branch; NAN: at pull-off */
  po_preload preload;            /* what the sphere is pressed to, see po_request_preload. Approach
                                    INFINITY: any, the pull-off is the greatest of all preloads */
  po_search search;              /* beyond the preload; PO_SEARCH_ALL where preloads are wanted */
  const po_companion *companion; /* NULL: none; then no preload is known to be hard enough */
  double time_limit; /* seconds of processor time of the thread that solves; NAN: none */
  const volatile sig_atomic_t *stop; /* asked now and then: nonzero stops the solve; may be NULL */
} po_request;

enum { PO_WANT_COUNT = 5 };

/* "curve", "profile", "hysteresis", "diagnostics", "preload": the name of want 1 << k. */
const char *po_want_name(int k);

/* A request with every field at its default (po_scene_default, po_mesh_default, the rest NAN or 0).
 */
po_request po_request_default(void);

/* The load of the preload where none is asked for, in pi w R. */
extern const double PO_USUAL_PRELOAD;

/* What the sphere is pressed to, at given approach: the preload of the request; else its
 * approach_end; else the usual load. */
po_preload po_request_preload(const po_request *request);

/* How far the trace goes on beyond the preload; for a preload of INFINITY, and with preloads
 * wanted, all the way. */
po_search po_request_search(const po_request *request);

/* PO_BAD_INPUT, naming the key that is wrong, its value and what is expected. */
po_status po_request_check(const po_request *request);

/* The bound of its companion for a load; NAN: not known. */
double po_request_bound(const po_request *request, double load);

#endif
