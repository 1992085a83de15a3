/* One scene, solved: what is asked, and what was read off the branch. */
#ifndef PO_RESULT_H
#define PO_RESULT_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_contact.h"
#include "po_diagnostics.h"
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

/* The contact radius, in eps, beyond which no equilibrium has a load, in pi w R, below a given one;
 * NAN: not known. */
typedef double (*po_load_bound)(const po_scene *scene, double load);

typedef struct {
  po_scene scene;
  po_mesh mesh;            /* scheme, grading, number of nodes */
  double approach_start;   /* where the trace begins, in eps; NAN: far out, found by itself */
  double approach_end;     /* where it ends, in eps; NAN: at the preload, see po_stopping.h */
  unsigned want;           /* PO_WANT_... */
  double profile_approach; /* in eps, first passage along the branch; NAN: at pull-off */
  po_preload preload;      /* what the sphere is pressed to, see po_request_preload. Approach
                              INFINITY: any, the pull-off is the greatest of all preloads */
  po_search search;        /* beyond the preload; PO_SEARCH_ALL where preloads are wanted */
  po_load_bound bound;     /* NULL: none; then no preload is known to be hard enough */
  double time_limit;       /* seconds of processor time of the thread that solves; NAN: none */
  const volatile sig_atomic_t *stop; /* asked now and then: nonzero stops the solve; may be NULL */
} po_request;

enum { PO_WANT_COUNT = 5 };

/* "curve", "profile", "hysteresis", "diagnostics", "preload": the name of want 1 << k. */
const char *po_want_name(int k);

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
  bool has_staircases;        /* whether these are set: when preloads are wanted */
  po_staircase staircase[2];  /* in displacement and in load control */
  po_diagnostics diagnostics; /* states is NULL unless wanted */
  po_work work;
} po_result;

/* A request with every field at its default (po_scene_default, po_mesh_default, the rest NAN or 0).
 */
po_request po_request_default(void);

/* What the sphere is pressed to, at given approach: the preload of the request; else its
 * approach_end; else the load pi w R. */
po_preload po_request_preload(const po_request *request);

/* How far the trace goes on beyond the preload; for a preload of INFINITY, and with preloads
 * wanted, all the way. */
po_search po_request_search(const po_request *request);

/* PO_BAD_INPUT, naming the key that is wrong, its value and what is expected. */
po_status po_request_check(const po_request *request);

/* Traces the branch of a scene and reads off what the request wants.
 * Given: a request. Returned: a result, to be given to po_result_clear whatever the status.
 * Status: that of the result: PO_OK; PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS, PO_NOT_CONVERGED,
 * PO_INTERRUPTED, PO_OUT_OF_TIME (with reason, and with what was found until then); PO_BAD_INPUT,
 * PO_NO_MEMORY. The time limit is looked at after every converged point of the branch: a solve may
 * exceed it by the time of one such step. */
po_status po_observe(const po_request *request, po_result *result);

/* A result of which nothing is known. */
po_result po_result_none(void);

/* Frees the arrays of a result, of which nothing is known then. */
void po_result_clear(po_result *result);

#endif
