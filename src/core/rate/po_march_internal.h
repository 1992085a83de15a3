/* Private to the files po_march*.c: the state of a march, its fields and its step. */
#ifndef PO_MARCH_INTERNAL_H
#define PO_MARCH_INTERNAL_H

#include "po_march.h"
#include "po_memory.h"

/* Fields on the nodes of the mesh of a state, each of n values; those of the retardation times
 * follow. */
enum {
  PO_OF_DEFLECTION, /* H - f: the deflection less the approach, eps */
  PO_OF_RATE,       /* change of H in the last step over its length */
  PO_OF_BEND,       /* second difference of H over the last two steps */
  PO_OF_TRACTION,   /* change of p in the last step over its length */
  PO_OF_INSTANT,    /* Q = coupling G p */
  PO_OF_CREEP       /* U_m */
};

typedef struct {
  po_panels *panels;
  size_t n;
  double *field; /* (PO_OF_CREEP + terms) x n */
  po_rate_point point;
  double square[PO_MOST_CREEP_TERMS]; /* coupling <z_m, z_m>, z_m the tractions of a term */
  double length;                      /* of the step that led here, eps; 0: none */
} po_march_state;

/* The numbers of one step for one retardation time, x = h/tau_m. */
typedef struct {
  double e, a, b;
  double phi1, phi2; /* (1 - e)/x and (1 - phi1)/x, by which (1 - e)/x, a/x and b/x are given */
} po_creep_step;

/* What is solved: an equilibrium at a position of the base, with the coupling times `factor`. */
typedef struct {
  double length; /* of the step, eps; of the dwell, where the base is not moved, the duration times
                    the speed of the march */
  double factor; /* effective coupling over that of the relaxed body */
  bool relaxing; /* a step of the motion in a jump, at frozen creep */
  double part;   /* of such a step: theta, see po_march_jump.c */
  po_creep_step step[PO_MOST_CREEP_TERMS];
} po_march_scene;

typedef struct {
  po_rate_point point;
  bool jumped;
  double length; /* of the step that led here */
} po_march_record;

/* What is held in an equilibrium. */
typedef enum { PO_HOLD_BASE, PO_HOLD_APPROACH, PO_HOLD_LOAD } po_march_hold;

struct po_march {
  po_equilibrium *e;
  po_resolution resolution;
  po_march_options options;
  double coupling;                                /* of the relaxed body */
  size_t fields;                                  /* of a state */
  po_march_state before, held, here, next, after; /* the state before the last one; the last one, on
                                              its own mesh; the same on the present mesh; a step
                                              from it; a step that waits */
  bool is_here;                                   /* `here` is `held` on the present mesh */
  double *bare;                                   /* initial gap f at the nodes */
  double *creep;                                  /* the history at the nodes: what is added to f */
  double *guess, *solved, *border, *traction, *other; /* n + 1: work */
  double *forces,
      *forces_before; /* n: tractions with the weights of the load, see po_march_step.c */
  double *shape;      /* n: H - f of the mesh before, with its panels */
  po_panels *shape_panels;
  double part; /* of the load on the spring, see po_march_jump.c */
  po_march_phase phase;
  double direction;    /* by which the base moves back in a step, over its length: 1, -1 or 0 */
  double speed;        /* lengths of steps over their durations, eps/tau_0 */
  double end;          /* length of the phase; NAN: not given */
  po_march_hold holds; /* in this phase */
  double held_value;   /* of what is held, unless it is the base */
  int orientation;     /* of a stable state; 0: not known yet */
  double longest;      /* accepted step of this phase, eps */
  double cap;          /* greatest length of the next step, eps */
  po_march_record *records;
  size_t count, room, first[PO_MARCH_PHASES]; /* of the records: the first one of each phase */
  size_t jumps, loading_jumps;                /* in all; before unloading */
  po_march_peak peak;
  bool has_wanted; /* options.wanted.solution is filled */
  po_arena arrays;
};

static inline double *po_march_field(const po_march_state *s, size_t k) {
  return s->field + k * s->n;
}

static inline void po_march_exchange(po_march_state *a, po_march_state *b) {
  const po_march_state first = *a;
  *a = *b;
  *b = first;
}

/* -- po_march_mesh.c -- */

/* Interpolates fields between meshes of the same domain. Given: count fields of from_n values on
 * `from`; the surface, whose mesh is the present one. Returned: count fields of the nodes of the
 * surface. */
void po_march_interpolate(const po_panels *from, size_t from_n, const double *field, size_t count,
                          const po_surface *surface, double *to);

/* Makes `here` the state `held` on the present mesh. */
void po_march_bring(po_march *m);

/* Remeshes the surface so that it resolves the gap m->shape + f, given on m->shape_panels, and the
 * history of `held`. Status: PO_OUT_OF_NODES, PO_NO_MEMORY. */
po_status po_march_remesh(po_march *m);

/* The radius of the outermost contact edge of a state on the present mesh, eps; 0: none. Given: gap
 * and H - f, n each. */
double po_march_contact_radius(const po_march *m, const double *gap, const double *deflection);

/* -- po_march_step.c -- */

po_march_scene po_march_scene_of(const po_march *m, double length);

/* Solves a scene from `here`, on meshes that resolve it. Returned: m->next, without energies and
 * the history. Status: PO_NOT_CONVERGED; PO_OUT_OF_NODES, PO_NO_MEMORY, those of po_deadline_check.
 */
po_status po_march_solve(po_march *m, const po_march_scene *scene);

/* The misfit of a step to m->next: the change of the traction against that of the step before, at
 * the same rate; its integral relative to 1 + the load, or, where that is more, its greatest value
 * relative to the greatest tension, on the scale of options.misfit. */
double po_march_misfit(const po_march *m);

/* Completes m->next after a step: history, energies, rates. */
void po_march_finish(po_march *m, const po_march_scene *scene);

/* Energies of interaction and spring of m->next, and its stored energy. */
void po_march_measure(po_march *m);

/* The work of the base over a step of a given length from the state `from` to m->next. */
double po_march_work(const po_march *m, const po_rate_point *from, double length);

/* Lets `held` creep at its traction for a step of a given length. Returned: the energy dissipated.
 */
double po_march_creep(po_march *m, double length);

/* -- po_march_jump.c -- */

/* Lets the contact jump from `held`, with the base moved by a length. Returned: m->next. Status:
 * PO_STEP_TOO_SMALL if no equilibrium is found. */
po_status po_march_jump(po_march *m, double length);

/* -- po_march_peak.c -- */

/* Looks for the greatest tension about the last accepted state, once the next one is known. */
po_status po_march_watch_peak(po_march *m, bool jumped);

/* -- po_march_profile.c -- */

/* Keeps the state that is wanted if the step from `held` to `next` leads past it. */
po_status po_march_look(po_march *m, bool jumped);

#endif
