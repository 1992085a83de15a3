/* What the pull-off of a viscoelastic body gives: the states of unloading, energies and their
 * errors.
 */
#ifndef PO_RATE_H
#define PO_RATE_H

#include <stdbool.h>
#include <stddef.h>

/* Energies, and work and losses since unloading began (before it: less those until then), pi w R
 * eps: work = change of (stored + adhesive + spring) + dissipated + jumps, but for errors. */
typedef struct {
  double stored;     /* elastic energy of the half-space */
  double adhesive;   /* energy of the interaction, 0 infinitely apart */
  double spring;     /* of the spring through which the base is moved */
  double work;       /* of the base */
  double dissipated; /* in the half-space */
  double jumps;      /* lost in jumps of the contact */
} po_rate_energy;

/* A state of unloading; of loading and the dwell, before it. */
typedef struct {
  double moved;          /* by how much the base was moved back, eps; < 0 where it was farther */
  double time;           /* since unloading began, tau_0; NAN at its speeds 0 and INFINITY */
  double base, approach; /* eps; base = approach without a spring */
  double load;           /* pi w R, > 0 compressive */
  double contact_radius; /* outermost contact edge, eps; 0: none */
  po_rate_energy energy;
} po_rate_point;

/* Loading at a speed, and the dwell. */
typedef struct {
  bool is_known;        /* false: the body was relaxed at the preload */
  size_t jumps;         /* number of jumps of the contact */
  po_rate_point start;  /* the state before any creep from which it was loaded */
  po_rate_energy error; /* of the energies of `start` */
} po_rate_loading;

typedef struct {
  bool is_known;
  double instant;          /* J(0), the ratio of relaxed to glassy modulus */
  double speed;            /* of unloading, eps/tau_0 */
  double time, time_error; /* from the preload to the pull-off, tau_0 */
  size_t jumps;            /* number of jumps of the contact while unloading */
  size_t terms, steps;     /* retardation times, and steps in time of the finest march */
  po_rate_loading loading;
  po_rate_point begin, end; /* at the preload; where unloading ends, see po_rate_solve.c */
  po_rate_energy end_error; /* of the energies at the end; its `stored` and `adhesive` are bounds of
                               the values at the begin, too */
  double time_part, mesh_part; /* of the error of the force, pi w R: by the steps, by the panels */
  double imbalance;       /* greatest miss of the balance of energy of all states, pi w R eps */
  po_rate_point *history; /* NULL unless wanted; owned */
  size_t history_count;
} po_rate;

#endif
