/* Loops of loading and unloading along a curve of equilibria, and the staircases of all preloads:
 * what a test does. po_loop.h and po_staircase.h compute them. */
#ifndef PO_LOOPS_H
#define PO_LOOPS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* An equilibrium at any place on the curve; approach and contact radius in eps, load in pi w R,
 * energy in pi w R eps (see po_curve_point), position as arclength or another parameter of the
 * curve. */
typedef struct {
  double approach, load, energy, contact_radius, position;
} po_path_state;

/* Error bounds of a state. */
typedef struct {
  double approach, load;
} po_path_error;

/* The error of the potential at a place: of the energy at given approach, and of energy - load
 * approach at given load. */
typedef struct {
  /* The greatest difference between the interpolated energy and the energies of both points plus
   * the integrals of the load from there, which are exact for the cubics. To the fourth order it is
   * the error by interpolation. */
  double interpolated;
  double of_points; /* the greater error of the energies of both points; NAN: unknown */
  double held;      /* of a jump: po_curve_point.held_miss where it begins */
} po_path_doubt;

/* How a body is held: the stiffness k of the spring, pi w R/eps, by whose other end, the base, it
 * is moved. The position of the base is approach + load/k. A stiff spring gives the approach, an
 * infinitely soft one the load. */
typedef double po_control;
#define PO_DISPLACEMENT_CONTROL ((double)INFINITY)
#define PO_LOAD_CONTROL 0.0

/* Whether it is a spring between displacement and load control. */
bool po_is_spring(po_control control);

/* What is held: the position of the base (eps), under displacement control the approach; under load
 * control the load (pi w R). */
double po_held(po_control control, double approach, double load);

/* Returned: the number of unstable modes of an equilibrium at given held quantity, from that at
 * given approach: the second derivative of the energy of surface and spring by the approach is k +
 * dW/d(approach), and where it is negative one more mode is unstable. Given: the derivatives of
 * approach and load along the branch. */
int po_modes_held(po_control control, int unstable_modes, double approach_rate, double load_rate);

/* A preload: approach, eps, and load, pi w R. Of a test that is to be made: loading is reversed
 * when one of them is reached; NAN: no limit; under load control only the load counts. */
typedef struct {
  double approach, load;
} po_preload;

/* A jump between two equilibria at a fixed position of the base. After complete separation the
 * position is NAN, and under load control the approach is -INFINITY. */
typedef struct {
  bool loading;
  po_path_state before, after;
  double energy_lost;  /* decrease of U at fixed approach, of U - W approach at fixed load, of U +
                          W^2/(2 k) through a spring, in pi w R eps; NAN: unbounded, the bodies
                          separate  under tension */
  po_path_doubt doubt; /* where it ends */
  double energy_lost_error; /* bound of the error of energy_lost; NAN: unknown */
} po_jump;

/* A row of what a test records. The rows of a loop are its states in the order of the test: every
 * point of the curve that it passes, and others between, so many that the loads by straight lines
 * over the base follow the cubics of the curve. A jump is two rows. */
typedef struct {
  bool loading;
  bool jump; /* whether a jump from the row before ends here */
  po_path_state state;
  double base;        /* position of the base, eps: approach + load/stiffness, without a spring the
                         approach */
  double indentation; /* approach less that of the first row with contact, eps; NAN: no contact */
  double stiffness;   /* d(load)/d(approach), pi w R/eps; NAN: infinite, at a fold */
  double energy_lost; /* in that jump; otherwise 0 */
} po_loop_row;

typedef struct {
  po_control control;
  po_path_state preload;        /* the state at which loading was reversed */
  po_path_state pull_off;       /* the state with the greatest tension in unloading */
  po_path_error pull_off_error; /* bounds of the errors of its approach and load; NAN: unknown */
  po_jump *jumps;               /* the jumps of loading, then those of unloading */
  size_t jump_count, loading_jumps;
  double energy_lost; /* the sum over all jumps; NAN if one of them is */
  double work; /* integral of the load over the position of the base along the complete loop, by
                  quadrature of the loads; NAN unless the loop is closed */
  double energy_lost_error, work_error; /* bounds of their errors; NAN: unknown */
  bool has_rows;                        /* whether the rows are wanted */
  po_loop_row *row;                     /* not under load control; owned */
  size_t row_count;
  double row_area_error; /* bound of the difference of the area of the rows, by the trapezoidal
                            rule, from the energy lost; NAN: unknown, or there are no rows */
  double interpolated;   /* greatest error by interpolation of preload and ends of jumps */
  double energy_error;   /* bound of the errors of the energies of all states at their approaches;
                            NAN: unknown */
} po_loop;

/* The tests of a scene: at given approach, at given load, and through the spring if there is one.
 */
enum { PO_AT_APPROACH, PO_AT_LOAD, PO_THROUGH_SPRING, PO_TESTS };

/* The loops of all tests. */
typedef struct {
  po_loop of[PO_TESTS];
  bool has_load; /* whether there is a loop at given load: the curve has an equilibrium at load 0 */
  bool has_spring;
} po_hysteresis;

/* What jumps lose, and what determines the error of that: sums over the jumps. */
typedef struct {
  double energy;       /* decrease of the potential; NAN: unbounded */
  double moved;        /* derivative of energy by the held quantity at which the jumps begin:
                          |load before - load after|, at given load |approach before - approach after| */
  double size;         /* 1 + |load before| + |load after| */
  double of_held;      /* moved times po_path_doubt.held */
  po_path_doubt doubt; /* where the jumps end */
  size_t jumps;
} po_loss;

/* All preloads from `preload` up to that of the next cycle: they have the same jumps. */
typedef struct {
  po_path_state preload; /* the fold at which loading jumps, before the jump */
  po_loss loss; /* in all jumps of loading and unloading; its energy is NAN: unbounded, because the
                   bodies separate under tension, or the curve does not begin far enough out */
  double energy_error; /* bound of the error of that energy; NAN: unknown */
} po_cycle;

/* A step: all preloads from `preload` to `until`, which have the same pull-off. */
typedef struct {
  po_path_state preload; /* the state at which the step begins: a special point of the curve */
  po_path_state until;   /* the state at which it ends, or the last state of loading on the curve */
  bool jumped; /* whether it begins at a jump of loading; otherwise it begins at a minimum of the
                  load */
  bool open;   /* whether the curve ends before the step does */
  po_path_state pull_off; /* the state with the greatest tension in unloading */
  po_path_error preload_error, pull_off_error; /* NAN: unknown */
  po_cycle *cycle;                             /* in the order of their preloads */
  size_t cycle_count;
} po_step;

typedef struct {
  po_control control;
  po_step *step; /* in the order of their preloads */
  size_t count;
  po_path_state reached; /* the last state of loading on the curve */
} po_staircase;

/* The staircases of all tests. */
typedef struct {
  po_staircase of[PO_TESTS];
  bool has_spring;
} po_staircases;

/* Free the lists; the controls stay. */
void po_hysteresis_clear(po_hysteresis *hysteresis);
void po_staircases_clear(po_staircases *staircases);

#endif
