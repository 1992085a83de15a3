/* A request: one scene, and the results that are wanted. */
#ifndef PO_REQUEST_H
#define PO_REQUEST_H

#include <signal.h>
#include <stdbool.h>

#include "po_creep.h"
#include "po_loops.h"
#include "po_mesh.h"
#include "po_physical.h"
#include "po_result.h"
#include "po_scene.h"
#include "po_status.h"

enum {
  PO_WANT_CURVE = 1,       /* the points of the branch */
  PO_WANT_PROFILE = 2,     /* gap and traction over the radius at one equilibrium */
  PO_WANT_HYSTERESIS = 4,  /* loading to a preload and back */
  PO_WANT_DIAGNOSTICS = 8, /* residuals, condition numbers, digits left; solves the scene again with
                              changed parameters */
  PO_WANT_PRELOAD = 16,    /* the pull-off after every preload: the staircases */
  PO_WANT_THEORIES = 32,   /* the theories of the theories; changes nothing else */
  PO_WANT_LOOP = 64,       /* the rows of the loops, which PO_WANT_HYSTERESIS belongs to */
  PO_WANT_HISTORY = 128,   /* the states of unloading of a viscoelastic body */
};

/* Whether the trace continues beyond its preload, to find the pull-off after harder preloads. */
typedef enum {
  PO_SEARCH_NONE,
  PO_SEARCH_SOME, /* until no harder preload gives more, with about as much effort as before at most
                   */
  PO_SEARCH_ALL, /* until no harder preload gives more, or to the hardest preload, see po_stopping.h
                  */
} po_search;

/* Whether a pull-off may be found with greater ranges of the attraction, see po_reduced.h. */
typedef enum {
  PO_RANGE_AUTO,  /* where contact edges are very narrow, or the solve with the true one fails or is
                     long */
  PO_RANGE_EXACT, /* never */
  PO_RANGE_REDUCED, /* always */
} po_range_choice;

extern const char *const PO_RANGES[]; /* their names; ends with NULL */

/* The closed-form theories that are evaluated for the scene beside the solve, as
 * po_theory_forces.h. */
struct po_request;
typedef struct {
  /* The contact radius, eps, beyond which no equilibrium has a load below the given one, pi w R;
   * NAN: unknown. */
  double (*bound)(const po_scene *scene, double load);
  /* The loops of loading and unloading from a preload, and the staircases. NULL if the theory does
   * not give them. The results must be cleared whatever the status. Status: PO_NO_MEMORY; another
   * failure if there are none for the scene. */
  po_status (*hysteresis)(const po_scene *scene, po_preload preload, po_control spring,
                          po_hysteresis *hysteresis);
  po_status (*staircases)(const po_scene *scene, po_control spring, po_staircases *staircases);
  /* The theories beside a result, its `theories`. Status: PO_NO_MEMORY, PO_INTERRUPTED,
   * PO_OUT_OF_TIME. A theory that cannot be evaluated is a row that says why. */
  po_status (*theories)(const struct po_request *request, po_result *result);
  /* The pull-off force of the scene, a sphere, over that of the same scene with the exact sphere in
   * place of the parabola, less 1; NAN: unknown. */
  double (*parabola_excess)(const po_scene *scene);
} po_theories;

/* An uncertain input is moved by so many times its standard uncertainty. At twice, 19 of 20 values
 * are between, and a jump of the force to another minimum is seen that is not there at once. */
enum { PO_VARIATION_REACH = 2 };

/* An uncertain input: the request with the input moved to both sides. */
typedef struct {
  char source[48];                   /* the name of its option */
  double value, deviation;           /* as they were given */
  const struct po_request *moved[2]; /* less, more */
  double unit[2]; /* pi w R of these requests in that of the request that has this variation */
} po_variation;

typedef struct po_request {
  po_scene scene;
  bool in_si;            /* the scene was given in SI units; results are written in them, too */
  po_units units;        /* if in_si */
  bool radius_given;     /* the radius of the scene stays when a profile is set, see po_input.h */
  po_mesh mesh;          /* scheme, grading, number of nodes */
  double approach_start; /* approach at which the trace begins, eps; NAN: chosen by the solver */
  double approach_end; /* approach at which it ends, eps; NAN: at the preload, see po_stopping.h */
  unsigned want;       /* PO_WANT_... */
  double profile_approach; /* approach of the profile, eps, at the first passage along the branch;
                              NAN: at profile_load */
  double profile_load; /* load of the profile, pi w R, at the first passage along the branch, which
                          is the state that slow loading at given load reaches if it is >= 0; NAN,
                          as is then profile_approach: at pull-off */
  po_preload preload;  /* see po_request_preload. With the approach INFINITY the pull-off is the
                          greatest of all preloads */
  double stiffness;    /* of a spring through which the body is moved, pi w R/eps; NAN: none */
  po_creep creep;      /* of the half-space; PO_CREEP_NONE: elastic */
  double unload_speed; /* of the base of a viscoelastic body, eps/tau_0; NAN: not given */
  double load_speed;   /* the same of loading; 0 or NAN: it is relaxed */
  double dwell;        /* at the preload, tau_0; INFINITY or NAN: until it is relaxed */
  po_search search;    /* beyond the preload; PO_SEARCH_ALL if PO_WANT_PRELOAD */
  double hardest; /* load, pi w R, at which a search ends; 0.0: a usual one, see po_stopping.c */
  const po_theories *theories;   /* NULL: none; a search is then never known to be complete */
  const po_variation *variation; /* of uncertain inputs; NULL: none */
  size_t variations;
  po_range_choice range;
  double time_limit; /* seconds of processor time of the solving thread; NAN: none */
  const volatile sig_atomic_t
      *stop; /* nonzero interrupts the solve; see po_deadline.h; may be NULL */
  /* Told of every point of a trace: approach, eps, and load, pi w R; of a scene of a series that is
   * followed: NAN. NULL: nobody. */
  void (*watch)(void *watcher, double approach, double load);
  /* Given gap and traction at every point of the curve, if the curve is wanted; a number that is
   * not above the previous one begins the trace again from that point. NULL: nobody. */
  void (*show)(void *watcher, size_t number, const po_profile_point *profile, size_t count);
  void *watcher;
} po_request;

enum { PO_WANT_COUNT = 8 };

extern const char *const PO_WANTS[PO_WANT_COUNT]; /* the name of want 1 << k */

/* Adds the results that a list names, with commas between, to *want. Returned: false if a name is
 * unknown; then *want is unchanged. */
bool po_want_read(const char *list, unsigned *want);
#define PO_WANT_EXPECTED                                                                           \
  "any of curve, profile, hysteresis, diagnostics, preload, theories, loop, history, with "        \
  "commas between"

/* A request with every field at its default (po_scene_default, po_mesh_default, the rest NAN or 0).
 */
po_request po_request_default(void);

/* The error of the pull-off force over the tolerance times the force. Returned: NAN if the error is
 * not estimated, or without a pull-off. */
double po_request_excess(const po_request *request, const po_result *result);

/* The load of the default preload, pi w R. */
extern const double PO_USUAL_PRELOAD;

/* The preload, in displacement control: that of the request, otherwise its approach_end, otherwise
 * the default load. */
po_preload po_request_preload(const po_request *request);

/* Completes a request that was given key by key: a stiffness and the rows of loops ask for loading
 * and unloading, and an approach or a load of the profile for the profile. The search of a single
 * solve is PO_SEARCH_SOME if neither a preload nor an additional result is wanted but the theories.
 * Status: as po_request_check. */
po_status po_request_complete(po_request *request);

/* Whether the trace continues beyond the preload: PO_SEARCH_ALL for a preload of INFINITY and if
 * PO_WANT_PRELOAD, otherwise that of the request. */
po_search po_request_search(const po_request *request);

/* Checks a request. Status: PO_BAD_INPUT, with a message that names the wrong key, its value and
 * the expected one. */
po_status po_request_check(const po_request *request);

/* The relative tolerance of the pull-off force: that of the mesh; of a viscoelastic body that of
 * its steps in time. */
double po_request_tolerance(const po_request *request);

/* The contact radius at pull-off over R, if it exceeds PO_WIDE_CONTACT, where the parabola r^2/(2R)
 * no longer stands for a sphere; otherwise, and of other profiles, 0. */
double po_request_wide_contact(const po_request *request, const po_result *result);
extern const double PO_WIDE_CONTACT;

/* Finds `parabola` of a result from its theories. Status: PO_NO_MEMORY. */
po_status po_request_find_parabola(const po_request *request, po_result *result);

/* The bound of the theories for a load, pi w R; NAN: unknown. */
double po_request_bound(const po_request *request, double load);

#endif
