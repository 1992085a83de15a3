/* Checks as a case file states them: which quantity is compared with which reference, and with
 * which tolerance. Axes: a key of the scene and a list of its values, of which sweeps and the
 * conditions of checks consist. */
#ifndef PO_CHECK_H
#define PO_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "po_request.h"

/* A value of an axis as a number. A name, such as that of a scheme, is represented by its place in
 * the list of names. */
typedef struct {
  double number;
  unsigned index; /* of the value in po_axis.values */
} po_axis_value;

/* A key and its values as written; or from, to, count and scale, from which po_axis_fill computes
 * the values. */
typedef struct {
  char *key;
  char **values;
  unsigned values_count;
  char *from_text;
  char *to_text;
  char *count_text;
  char *scale;              /* "log" or "linear"; NULL: linear */
  po_axis_value *ascending; /* the values sorted by number; NULL: not checked yet */
} po_axis;

/* Reports whether a scene fulfils all conditions of a list: for each axis, the value of the key is
 * one of those of the axis. */
bool po_axes_hold(const po_axis *axes, unsigned count, const po_request *request);

typedef enum {
  PO_PULL_OFF_FORCE,
  PO_PULL_OFF_APPROACH,
  PO_CONTACT_RADIUS,       /* at pull-off */
  PO_PULL_OFF_UNCERTAINTY, /* its standard uncertainty by those of the inputs */
  PO_RESIDUAL,             /* of the discrete equations, see po_diagnostics.h */
  PO_MOVED_FORCE,          /* its change with the last bits of the inputs, relative to its errors */
  PO_ENERGY_DEFECT,        /* error of the energy balance dU = W dΔ along the branch */
  PO_REVERSE_TRACE,    /* differences between the folds of the trace and of the reverse trace, see
                          po_diagnose.h */
  PO_HYSTERESIS_FORCE, /* the greatest tension during unloading at given approach */
  PO_HYSTERESIS_APPROACH, /* the approach of that tension */
  PO_HYSTERESIS_LOSS,     /* energy lost in all jumps of loading and unloading at given approach */
  PO_JUMPS,               /* these jumps, one by one */
  PO_PULL_OFF_ANY,        /* the greatest pull-off force over all preloads */
  PO_STEPS,               /* the steps of the staircase at given approach, one by one */
  PO_LOAD_STEPS,          /* the steps of the staircase at given load, one by one */
  PO_FOLD_COUNT,
  PO_FOLDS,
  PO_EXTREMA,
  PO_CURVE,
  PO_SOLVED_SHARE, /* the share of solved points; one number for the whole case */
  PO_QUANTITY_COUNT
} po_quantity;

/* What a check compares with. */
typedef enum {
  PO_REFERENCE_TABLE,       /* a CSV file, given by its path */
  PO_REFERENCE_BRADLEY,     /* the closed form of the rigid smooth sphere */
  PO_REFERENCE_ZERO,        /* the quantity vanishes for an exact solution, e.g. a residual */
  PO_REFERENCE_EVERY_SCENE, /* the share 1, for solved_share: every scene has an equilibrium */
  PO_REFERENCE_TRACED,      /* the full trace of a scene, for a pull-off from a series */
  PO_REFERENCE_ABSENT       /* a table that does not exist; the check names a stand-in for it */
} po_reference_type;

typedef enum { PO_TOLERANCE_ABS, PO_TOLERANCE_REL, PO_TOLERANCE_ULP } po_tolerance_kind;

/* A check, or a measurement (which has no tolerance and no verdict), as written in the file, with
 * its parsed values. */
typedef struct {
  char *quantity_text;
  char *reference;
  char *tolerance_text;
  char *kind_text;
  char *because;
  char *stand_in; /* the reference of another check that replaces this one while the table of this
                     check does not exist; NULL: the table must exist */
  po_axis *as_if; /* keys, each with one value, that replace those of the scene when the reference
                     is looked up */
  unsigned as_if_count;
  po_axis *when; /* the check applies to points that fulfil all these conditions */
  unsigned when_count;
  po_quantity quantity;
  po_reference_type type; /* of the reference */
  double tolerance;
  po_tolerance_kind kind;
  size_t tolerance_line; /* line of the tolerance in the file */
} po_check;

/* Reports whether a check applies to a scene. */
bool po_check_concerns(const po_check *check, const po_request *request);

/* Returned: the scene that is looked up in the reference of a check: `request` with the values of
 * as_if. */
po_request po_check_request(const po_check *check, const po_request *request);

/* Returned: the type of the reference that a case file names: "bradley", "zero", "every_scene"
 * or "traced"; any other text is the path of a table. */
po_reference_type po_reference_type_of(const char *reference);

/* What a quantity is of. Parameter continuation delivers only those of the pull-off; the only
 * reference of a diagnostic is zero. */
typedef enum {
  PO_OF_PULL_OFF,
  PO_OF_INPUTS,    /* the uncertainty of the pull-off force */
  PO_OF_LOOP,      /* loading and unloading at given approach */
  PO_OF_STAIRCASE, /* all preloads */
  PO_OF_DIAGNOSTICS,
  PO_OF_BRANCH, /* unstable equilibria included */
  PO_OF_SOLVE
} po_quantity_family;

/* A quantity: its name in case files, the path of its number in a result (po_result_rows.h; "": it
 * is not a single number), and the column of reference tables that a scene must have for it. */
typedef struct {
  const char *name, *path, *column;
  po_quantity_family family;
} po_quantity_row;
extern const po_quantity_row PO_QUANTITIES[PO_QUANTITY_COUNT];

bool po_quantity_is(po_quantity quantity, po_quantity_family family);
/* Reports whether a quantity is a list of jumps or steps. */
bool po_quantity_is_steps(po_quantity quantity);

/* Returned: the quantity with a name; PO_QUANTITY_COUNT if there is none. */
int po_quantity_of_name(const char *name);

/* Returned: the tolerance of a check around an expected value as an absolute number. */
double po_check_allowance(const po_check *check, double expected);

#endif
