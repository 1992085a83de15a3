/* The result of a solve: what was computed along the branch of a scene. */
#ifndef PO_RESULT_H
#define PO_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_diagnostics.h"
#include "po_loops.h"
#include "po_rate.h"
#include "po_status.h"
#include "po_theories.h"

/* Kinds of special point: the folds in approach and the extrema of the load along the branch. */
typedef enum {
  PO_JUMP_IN,  /* fold: approach has a local maximum along the branch, the surfaces jump closer */
  PO_JUMP_OUT, /* fold: approach has a local minimum along the branch, the surfaces jump apart */
  PO_MINIMUM,  /* the load has a local minimum (a pull-off candidate) */
  PO_MAXIMUM,  /* the load has a local maximum */
} po_special_kind;

extern const char *const PO_SPECIAL_KINDS[]; /* their names; ends with NULL */

typedef struct {
  po_special_kind kind;
  double approach;             /* Delta / eps */
  double load;                 /* W / (pi w R), signed, > 0 compressive */
  double energy, energy_error; /* U / (pi w R eps), see po_curve_point; estimated bound of its
                                  error, NAN: not estimated */
  double
      approach_error; /* estimated bounds of the errors of approach and load; NAN: not estimated */
  double load_error;
  double contact_radius; /* in eps, see po_contact.h */
  double contact_radius_error,
      contact_radius_other; /* see po_contact_edge; NAN: not estimated, none */
  double position;    /* arclength along the branch, which orders special points and other points */
  int unstable_modes; /* of the equilibria just after it, at given approach */
  bool has_base;      /* whether there is a spring */
  int base_modes;     /* the same at a given base of the spring */
} po_special_point;

typedef struct {
  double position;       /* arclength along the branch */
  double approach;       /* Delta / eps */
  double load;           /* W / (pi w R), > 0 compressive */
  double energy;         /* U / (pi w R eps), elastic and of the interaction, 0 infinitely apart;
                            dU/d(approach) along the branch is the load */
  double energy_error;   /* estimated bound of its error at this approach; NAN: not estimated */
  double load_error;     /* the same of the load; not in documents */
  double contact_radius; /* in eps */
  double approach_rate, load_rate; /* derivatives by the position. approach_rate is 0 at a fold,
                                      load_rate at an extremum of the load */
  int unstable_modes;              /* 0: stable at given approach */
  bool has_base;                   /* whether there is a spring */
  int base_modes;                  /* the same at a given base of the spring */
  double held_miss; /* where a spring jumps between two points of the branch: bound of the error of
                       the position of the base by interpolation and by the load that the panels
                       miss; otherwise 0 */
  bool minimum;     /* whether the load has a local minimum here; of a trace and of the JKR curve
                       only, not in documents */
} po_curve_point;

typedef struct {
  double radius;   /* r / eps */
  double gap;      /* H = h / eps - 1 */
  double traction; /* P = p mu eps / w, > 0 compressive */
} po_profile_point;

/* An annulus in which the gap is below a level. The first one may begin on the axis, at 0. */
typedef struct {
  double inner, outer; /* eps */
} po_contact_annulus;

/* The contact annuli of one equilibrium. Compressed: the traction is compressive (H < 0). Held: the
 * gap is below that of the greatest tension. The annulus between two held annuli is a groove, an
 * internal crack. */
typedef struct {
  po_contact_annulus *compressed, *held; /* from the axis outwards; owned */
  size_t compressed_count, held_count;
} po_contact_annuli;

/* Deterministic counters of work, and the time. */
typedef struct {
  uint64_t points;             /* converged equilibria */
  uint64_t newton_iterations;  /* corrector iterations */
  uint64_t factorizations;     /* LU factorisations */
  uint64_t kernel_evaluations; /* of G(r, s), or of F(c, r) for rings */
  uint64_t nodes;              /* largest number of nodes of the surface */
  uint64_t factorized_nodes;   /* largest order of a factorised matrix */
  uint64_t meshes;             /* changes of the mesh */
  double seconds;              /* wall time, but for diagnostics */
} po_work;

/* Adds work to other work. Of nodes, the greater number is kept. */
void po_work_add(const po_work *more, po_work *work);

/* What the uncertainty of one input, or the noise of a profile, does to the pull-off force. */
typedef struct {
  char source[48];         /* the name of the option, or "noise" */
  double value, deviation; /* of the input; of noise: NAN, and that of the rows in their unit */
  double below, above; /* changes of the force, pi w R, when the input is less and more by twice its
                          deviation; NAN: that solve failed */
  double force; /* standard uncertainty of the force, to first order, pi w R; NAN: the force is
                   not linear over these inputs, and the changes are not small beside others */
} po_uncertain;

/* Loops of a solve with greater ranges of the attraction, see po_reduced.h. */
typedef struct {
  bool are_known;
  double least, greatest; /* the ranges of their limits, relative to that of the scene */
  double approach, load;  /* greatest errors of the ends of their jumps: eps, pi w R */
} po_range_loops;

/* Staircases of such a solve. */
typedef struct {
  bool are_known;
  double least, greatest; /* as of loops */
  size_t left_out;        /* steps of light preloads at given approach that not all ranges have */
} po_range_stairs;

/* Why the trace of a branch ended; see po_stopping.h. */
typedef enum {
  PO_END_NONE,       /* nothing was traced, or the status gives the reason */
  PO_END_COMPRESSED, /* a smooth sphere, at a stable point under compression */
  PO_END_PRELOAD,    /* at the preload */
  PO_END_COMPLETE,   /* no minimum beyond can be as deep, by the bound of the request */
  PO_END_SEARCHED,   /* at the hardest preload of a search, see po_stopping.h */
  PO_END_ASKED,      /* at the approach_end of the request */
} po_end_cause;

typedef struct {
  po_status status; /* PO_OK: complete; otherwise the results are those found before the failure */
  char reason[640]; /* why the status is not PO_OK; "" otherwise */
  bool rigid;       /* solved without elasticity */
  bool followed;    /* only the pull-off, by parameter continuation, see po_series.h */
  double start;     /* first approach traced, in eps */
  struct {
    po_end_cause cause;
    double approach, load; /* the last point of the trace: eps, pi w R */
  } ended;
  bool has_pull_off; /* whether the fields of pull_off are set */
  struct {
    double force;          /* |min W| of the branch up to the preload, / (pi w R) */
    double approach;       /* at pull-off, eps */
    double contact_radius; /* at pull-off, eps */
    double
        force_error; /* estimated bound of the error of force; NAN: not estimated by this scheme */
    double far_force_error; /* the part of force_error that no other mesh reduces */
    double excess; /* force_error over the tolerance times the force; NAN: without force_error */
    double approach_error; /* the same of approach */
    double contact_radius_error,
        contact_radius_other; /* see po_contact_edge; NAN: not estimated, none */
    double full_disc; /* radius of the disc about the axis that is in contact without a groove, over
                         the contact radius; NAN: unknown, no contact */
    bool has_sensitivity; /* whether `sensitivity` is set; on panels only */
    po_sensitivity
        sensitivity;    /* d ln(force) / d ln(parameter); its residual and rounding are NAN */
    po_preload pressed; /* the least preload with this pull-off; NAN: none on the trace */
    po_preload
        until; /* the hardest preload with this pull-off; NAN: the trace ended before it changed */
  } pull_off;
  struct {
    bool is_known;                   /* whether the fields are set */
    double force, force_error;       /* greatest pull-off force of all preloads, / (pi w R) */
    double approach, approach_error; /* where, in eps */
    po_preload pressed;              /* the least preload with this pull-off */
    bool complete;                   /* no harder preload gives more */
    po_preload searched;             /* otherwise: the hardest preload of the trace */
  } pull_off_any;
  struct {           /* of a solve with greater ranges of the attraction, see po_reduced.h */
    bool is_reduced; /* whether it was one; then the special points are those of which the limit is
                        known */
    double least, greatest; /* the last six ranges, relative to that of the scene */
    double change;          /* of the force from the least range to the true one, / (pi w R) */
    po_range_loops loops;   /* if they are wanted */
    po_range_stairs stairs; /* if they are wanted */
  } range;
  po_special_point *folds; /* along the branch */
  size_t fold_count;
  po_special_point *extrema; /* along the branch */
  size_t extremum_count;
  po_curve_point *curve; /* along the branch, special points included; NULL unless wanted */
  size_t curve_count;
  po_profile_point *profile; /* NULL unless wanted */
  size_t profile_count;
  double profile_approach;  /* approach of the profile, eps */
  po_contact_annuli annuli; /* at the same approach; none unless the profile is wanted */
  bool has_hysteresis;      /* whether `hysteresis` is set */
  po_hysteresis hysteresis;
  po_rate rate;        /* unloading of a viscoelastic body */
  bool has_staircases; /* whether `staircase` is set */
  po_staircases staircase;
  struct { /* of the theories of the request, if it gives them */
    bool has_hysteresis, has_staircases;
    po_hysteresis hysteresis;
    po_staircases staircase;
  } theory;
  struct {
    double deviation; /* of the force by the noise of a smoothed table, pi w R of the solve */
    double *change;   /* of the table that belongs to it (po_profile_table_noise); NULL: none */
  } noise;
  struct {           /* of the pull-off force by the interpolation of a table without noise */
    double *weights; /* the radii, eps, and the derivatives of the load by the gap there, in pairs;
                        NULL: not known */
    size_t weight_count;
    bool is_known;
    double force;                     /* the greatest modulus of the next three, pi w R */
    double without_odd, without_even; /* change of the force if every other row is left out */
    double round_apex;                /* if the spline is level on the axis; NAN: no solution */
    int interval;                     /* of the rows in which the contact ends; the first is 1 */
    bool solved;                      /* by solves, otherwise to first order */
  } interpolation;
  po_uncertain *uncertain; /* one a source; NULL: there is none */
  size_t uncertain_count;
  double
      uncertainty; /* of the force by all of them: the root of the sum of squares; NAN: unknown */
  po_theory_row *theories; /* one a theory; NULL unless wanted */
  size_t theory_count;
  struct {         /* of a contact that is too wide for a parabola in place of a sphere */
    double wide;   /* the contact radius at pull-off over R */
    double limit;  /* of it */
    double sphere; /* R of the profile exact_sphere, eps */
    po_parabola_theory *theories; /* those that hold, for the parabola alone; NULL: none */
    size_t theory_count;
  } parabola;
  double seconds_beside; /* the part of the wall time for solves with changed inputs and for the
                            theories beside the solve; not in documents */
  po_diagnostics diagnostics; /* states is NULL unless wanted */
  po_work work;
} po_result;

/* An empty result. */
po_result po_result_none(void);

/* Frees the arrays of a result, which is then empty. */
void po_result_clear(po_result *result);

#endif
