/* The vocabulary of checks: which quantity is compared with which reference, and how close it must
 * be.
 */
#ifndef PO_CHECK_H
#define PO_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "po_axis.h"
#include "po_request.h"

typedef enum {
  PO_PULL_OFF_FORCE,
  PO_PULL_OFF_APPROACH,
  PO_CONTACT_RADIUS, /* at pull-off */
  PO_RESIDUAL,       /* of the discrete equations, see po_diagnostics.h */
  PO_MOVED_FORCE,    /* change of the force with the last bits of the inputs */
  PO_ENERGY_DEFECT,  /* of dU = W dapproach */
  PO_REVERSE_TRACE, /* differences of folds when the branch is followed back, see po_reverse_trace.h
                     */
  PO_HYSTERESIS_FORCE, /* the greatest tension met in unloading at given approach */
  PO_HYSTERESIS_APPROACH,
  PO_HYSTERESIS_LOSS, /* energy lost in all jumps of loading and unloading at given approach */
  PO_JUMPS,           /* these jumps, one by one */
  PO_PULL_OFF_ANY,    /* the force, the greatest that any preload gives */
  PO_STEPS,           /* of the staircase at given approach, one by one */
  PO_LOAD_STEPS,      /* at given load */
  PO_FOLD_COUNT,
  PO_FOLDS,
  PO_EXTREMA,
  PO_CURVE,
  PO_WORK,         /* the counters of work, each on its own; only our own pins speak of them */
  PO_SOLVED_SHARE, /* of the points of the case, not of one */
  PO_QUANTITY_COUNT
} po_quantity;

/* What a check compares with: a table, or what one of the other words stands for. */
typedef enum {
  PO_REFERENCE_TABLE,   /* a CSV file, by its path */
  PO_REFERENCE_BRADLEY, /* the closed form of the rigid smooth sphere */
  PO_REFERENCE_PINS,    /* our own last blessed values, see po_pins.h */
  PO_REFERENCE_ZERO,    /* the quantity vanishes for an exact solution: residuals and the like */
  PO_REFERENCE_EVERY_SCENE, /* of a solved_share: every scene has its equilibria */
  PO_REFERENCE_TRACED,      /* of a pull-off that was followed: what the trace of the scene finds */
  PO_REFERENCE_ABSENT /* a table that is not there, and the check says what stands in for it */
} po_reference_type;

typedef enum { PO_TOLERANCE_ABS, PO_TOLERANCE_REL, PO_TOLERANCE_ULP } po_tolerance_kind;

/* A check, or a measurement (no tolerance, no verdict), as written in the file; parsed values
 * beside it. */
typedef struct {
  char *quantity_text;
  char *reference;
  char *tolerance_text;
  char *kind_text;
  char *because;
  char *stand_in; /* the reference that stands in while that of this check is absent, which leaves
                     the check out; NULL: it must be there */
  po_axis
      *as_if; /* the reference is asked of the scene with these keys changed, each of one value */
  unsigned as_if_count;
  po_axis *when; /* the points it concerns: all these must match; none: every point */
  unsigned when_count;
  po_quantity quantity;
  double tolerance;
  po_tolerance_kind kind;
  size_t line; /* of the tolerance in the file */
} po_check;

bool po_check_concerns(const po_check *check, const po_request *request);

/* The scene of which the reference of a check is asked: as_if applied. */
po_request po_check_request(const po_check *check, const po_request *request);

/* The type of the reference that a case file names: "bradley", "pin", "zero", "every_scene",
 * "traced"; any other text is the path of a table. */
po_reference_type po_reference_type_of(const char *reference);
bool po_check_is_pin(const po_check *check);
bool po_check_is_traced(const po_check *check);

/* Whether a quantity is one of the pull-off: all that is known of a scene that is followed. */
bool po_quantity_is_pull_off(po_quantity quantity);

/* Whether a quantity is of the diagnostics, and so only set beside zero. */
bool po_quantity_is_diagnostic(po_quantity quantity);

/* Whether a quantity is of loading and unloading, which are followed for it. */
bool po_quantity_is_hysteresis(po_quantity quantity);

/* Whether a quantity is read off the staircases. */
bool po_quantity_is_preload(po_quantity quantity);
bool po_quantity_is_steps(po_quantity quantity);

/* Names, as in case files. */
const char *po_quantity_name(po_quantity quantity);
const char *po_tolerance_kind_name(po_tolerance_kind kind);

/* The tolerance of a check around an expected value, as an absolute number. */
double po_check_allowance(const po_check *check, double expected);

#endif
