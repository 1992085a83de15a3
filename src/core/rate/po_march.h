/* A viscoelastic contact in time: the base is moved, and the half-space creeps (po_creep.h).
 *
 * One step is an elastic equilibrium with another gap and another coupling. With p linear in time
 * over a step of duration h, and for each retardation time the deflection U_m by its part of the
 * creep, Q = coupling G p, x = h/tau_m:
 *
 *   U_m(t + h) = e U_m(t) + c_m [a Q(t) + b Q(t + h)],   c_m = (1 - k) w_m,
 *   e = exp(-x),   b = 1 - (1 - e)/x,   a = (1 - e)/x - e,
 *   H = [f + sum_m (e U_m + c_m a Q)] - approach + coupling (k + sum_m c_m b) G p(H)   at t + h.
 *
 * It is of second order in h, for any h/tau_m. Its coupling is between that of the glassy body (h =
 * 0) and that of the relaxed one (h infinite); the march serves both limits, too, which are exact.
 * See doc/method.md, "Viscoelastic bodies". */
#ifndef PO_MARCH_H
#define PO_MARCH_H

#include <stdbool.h>
#include <stddef.h>

#include "po_creep.h"
#include "po_rate.h"
#include "po_resolution.h"
#include "po_solution.h"

typedef struct po_march po_march;

typedef enum {
  PO_LOADING,   /* the base is moved to the preload */
  PO_DWELLING,  /* what was reached of the preload, the approach or the load, is held */
  PO_UNLOADING, /* the base is moved back */
  PO_MARCH_PHASES
} po_march_phase;

/* Receives the first state and the accepted ones in order. A state at which unloading begins comes
 * twice if there was loading, the second time as that of unloading: its time, and work and losses,
 * begin anew. Returned: true to end unloading, or any phase if the march is to end. */
typedef bool (*po_march_visit)(const po_rate_point *point, po_march_phase phase, void *data);

/* A state of unloading that is to be kept: the first with this approach (eps), load (pi w R) or
 * position of the base (by how much it was moved back, eps). */
typedef enum { PO_WANTED_APPROACH, PO_WANTED_LOAD, PO_WANTED_BASE } po_march_quantity;
typedef struct {
  po_march_quantity by;
  double value;
  po_solution *solution; /* receives it, without its tangent; NULL: none is wanted */
} po_march_wanted;

typedef struct {
  const po_creep_terms *terms;
  double speed;          /* of unloading, eps/tau_0; 0 and INFINITY are the elastic limits */
  double load_speed;     /* of loading, > 0; NAN: the march starts at the preload */
  double dwell;          /* duration of the dwell after loading, tau_0, finite */
  double approach, load; /* the preload at which loading ends, whichever is reached first, eps and
                            pi w R; INFINITY: none of them */
  double stiffness;      /* of a spring, pi w R/eps; NAN: none */
  double base;           /* where the base starts, eps */
  double misfit;  /* the change of the traction in a step against a linear one, see po_march.c, that
                     decides on its length */
  double halving; /* the steps are so many times shorter than `misfit` says: 1 or 2 */
  const struct po_march
      *like;  /* the steps are as long as those of this march, over `halving`; NULL */
  double end; /* by how much unloading moves the base, eps; NAN: until the visitor ends it */
  po_march_wanted wanted;
  po_march_visit visit;
  void *data;
} po_march_options;

/* Given: an equilibrium on panels, which the march meshes anew; the errors that the panels may
 * leave; the equilibrium at which the march starts, relaxed, or before any creep if there is
 * loading. They and the data of the options must outlive the march. Status: PO_NO_MEMORY; those of
 * po_march_run. */
po_status po_march_create(po_equilibrium *e, po_allowance allowed, const po_solution *start,
                          const po_march_options *options, po_march **march);
void po_march_destroy(po_march *march);

/* Refuses a march that would take more steps than there may be: the edge of the contact passes its
 * radius, and is about 1/(coupling k) wide. Given: the coupling of the relaxed body, the radius at
 * the preload, eps. Status: PO_TOO_MANY_POINTS. */
po_status po_march_check(double coupling, const po_creep_terms *terms, double radius);

/* Loads, dwells and unloads until the visitor ends the march. Status: PO_STEP_TOO_SMALL if a jump
 * leads nowhere; PO_TOO_MANY_POINTS, PO_OUT_OF_NODES; those of po_deadline_check. */
po_status po_march_run(po_march *march);

/* The state of greatest tension of unloading. Given: a march that has run. */
typedef struct {
  po_rate_point at;
  bool found;   /* false: the tension is greatest at the last state */
  size_t jumps; /* number of jumps before it */
  /* By how much the last parabola moved the vertex of the first, eps, and the contact radius at
   * that rate: bounds of the errors by the place of the maximum, which the load hardly feels. */
  double spread, radius_spread;
} po_march_peak;
po_march_peak po_march_greatest_tension(const po_march *march);

/* Whether the state that is wanted was met, outside a jump. */
bool po_march_has_wanted(const po_march *march);

size_t po_march_steps(const po_march *march);

/* The number of jumps of the contact while loading and in the dwell, or while unloading. */
size_t po_march_jumps(const po_march *march, bool unloading);

#endif
