/* What was read off the branch of a scene. */
#ifndef PO_RESULT_H
#define PO_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_contact.h"
#include "po_diagnostics.h"
#include "po_hysteresis.h"
#include "po_staircase.h"
#include "po_status.h"

/* Kinds of special point: the folds in approach and the extrema of the load along the branch. */
typedef enum {
  PO_JUMP_IN,  /* fold: approach has a local maximum along the branch, the surfaces jump closer */
  PO_JUMP_OUT, /* fold: approach has a local minimum along the branch, the surfaces jump apart */
  PO_MINIMUM,  /* the load has a local minimum (a pull-off candidate) */
  PO_MAXIMUM,  /* the load has a local maximum */
} po_special_kind;

/* "jump_in", "jump_out", "minimum", "maximum". */
const char *po_special_kind_name(po_special_kind kind);

typedef struct {
  po_special_kind kind;
  double approach;       /* Delta / eps */
  double load;           /* W / (pi w R), signed, > 0 compressive */
  double energy;         /* U / (pi w R eps), see po_curve_point */
  double approach_error; /* bounds of the errors of approach and load, estimated; NAN: not */
  double load_error;
  double contact_radius;                             /* in eps, see po_contact.h */
  double contact_radius_error, contact_radius_other; /* see po_contact_edge; NAN: not, none */
  double position;    /* arclength along the branch, to order special points among points */
  int unstable_modes; /* of the equilibria just after it, in displacement control */
} po_special_point;

typedef struct {
  double position; /* arclength along the branch */
  double approach; /* Delta / eps */
  double load;     /* W / (pi w R), > 0 compressive */
  double energy;   /* U / (pi w R eps), elastic and of the interaction, 0 infinitely apart: its
                      rate by the approach along the branch is the load */
  double contact_radius;           /* in eps */
  double approach_rate, load_rate; /* per position: the direction of the curve. 0 at a fold, and at
                                      an extremum of the load */
  int unstable_modes;              /* 0: stable at fixed approach */
} po_curve_point;

typedef struct {
  double radius;   /* r / eps */
  double gap;      /* H = h / eps - 1 */
  double traction; /* P = p mu eps / w, > 0 compressive */
} po_profile_point;

/* Deterministic counters of work, and the time. */
typedef struct {
  uint64_t points;             /* converged equilibria */
  uint64_t newton_iterations;  /* corrector iterations */
  uint64_t factorizations;     /* LU factorisations */
  uint64_t kernel_evaluations; /* of G(r, s), or of F(c, r) for rings */
  uint64_t nodes;              /* unknowns of the surface (the largest, when it changes) */
  uint64_t factorized_nodes;   /* largest order of a factorised matrix */
  uint64_t meshes;             /* changes of the mesh */
  double seconds;              /* wall time */
} po_work;

/* What the sphere is pressed to: eps, pi w R. */
typedef struct {
  double approach, load;
} po_pressed;

/* Why the trace of a branch ended; see po_stopping.h. */
typedef enum {
  PO_END_NONE,       /* nothing was traced, or the status says why */
  PO_END_COMPRESSED, /* a smooth sphere, stably under compression */
  PO_END_PRELOAD,    /* at the preload */
  PO_END_COMPLETE,   /* no minimum beyond can be as deep, by the bound of the request */
  PO_END_SEARCHED,   /* at the hardest preload that is looked at, see po_stopping.h */
  PO_END_ASKED,      /* at the approach_end of the request */
} po_end_cause;

/* "none", "compressed", "preload", "complete", "searched", "approach_end". */
const char *po_end_cause_name(po_end_cause cause);

/* The cause of that name; false when there is none. */
bool po_end_cause_find(const char *name, po_end_cause *cause);

typedef struct {
  po_status status; /* PO_OK: complete; else the results below are those found until then */
  char reason[256]; /* why the status is not PO_OK; "" otherwise */
  bool rigid;       /* solved without elasticity */
  bool followed;    /* the pull-off alone, continued from other scenes, see po_series.h */
  double start;     /* first approach traced, in eps */
  struct {
    po_end_cause cause;
    double approach, load; /* the last point of the trace: eps, pi w R */
  } ended;
  bool has_pull_off; /* whether the fields of pull_off are set */
  struct {
    double force;          /* |min W| of the branch up to the preload, / (pi w R) */
    double approach;       /* where, in eps */
    double contact_radius; /* there, in eps */
    double force_error;    /* bound of the error of force, estimated; NAN: not by this scheme */
    double approach_error; /* the same of approach */
    double contact_radius_error, contact_radius_other; /* see po_contact_edge; NAN: not, none */
    po_pressed pressed; /* the least preload that gives it; NAN: none of those traced does */
    po_pressed until;   /* the hardest that gives it, before a change; NAN: none such is traced */
  } pull_off;
  struct {
    bool is_known; /* whether the fields are set: a test measures a pull-off on the branch */
    double force, force_error;       /* the greatest that any preload gives, / (pi w R) */
    double approach, approach_error; /* where, in eps */
    po_pressed pressed;              /* the least preload that gives it */
    bool complete;                   /* no harder preload gives more */
    po_pressed searched;             /* else: the hardest preload looked at */
  } pull_off_any;
  po_special_point *folds; /* along the branch */
  size_t fold_count;
  po_special_point *extrema; /* along the branch */
  size_t extremum_count;
  po_curve_point *curve; /* along the branch, special points included; NULL unless wanted */
  size_t curve_count;
  po_profile_point *profile; /* NULL unless wanted */
  size_t profile_count;
  double profile_approach;  /* where it was taken */
  po_contact_annuli annuli; /* there; none unless wanted */
  bool has_hysteresis;      /* whether the loops below are set: when wanted */
  po_hysteresis hysteresis;
  bool has_staircases;       /* whether these are set: when preloads are wanted */
  po_staircase staircase[2]; /* in displacement and in load control */
  struct {                   /* by the companion of the request, where it has them */
    bool has_hysteresis, has_staircases;
    po_hysteresis hysteresis;
    po_staircase staircase[2];
  } theory;
  po_diagnostics diagnostics; /* states is NULL unless wanted */
  po_work work;
} po_result;

/* A result of which nothing is known. */
po_result po_result_none(void);

/* Frees the arrays of a result, of which nothing is known then. */
void po_result_clear(po_result *result);

#endif
