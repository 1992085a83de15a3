/* The rows of the diagnostics. */
#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_result.h"
#include "po_result_rows.h"
#include "po_row_cells.h"

// clang-format off
static const char *const KEPT[] = {[PO_KEPT_START] = "start", [PO_KEPT_FOLD] = "fold",
                                   [PO_KEPT_PULL_OFF] = "pull_off", [PO_KEPT_END] = "end", NULL};

#define S po_diagnosed_state
static const po_row STATE[] = {
  WORD("at", at, KEPT, "which state it is"),
  NUMBER("approach", approach, LENGTH, "", "", "approach"),
  NUMBER("load", load, LOAD, "", "", "load"),
  COUNT("nodes", nodes, "number of nodes"),
  NUMBER("residual", found.residual, NONE, "", "for rigid scenes", "as in `diagnostics`, at this state"),
  NUMBER("rounding", found.rounding, NONE, "", "for rigid scenes", "as in `diagnostics`, at this state"),
  NUMBER("condition", found.condition, NONE, "", "if the matrix is singular",
         "condition number of the Jacobian at given approach (LAPACK's estimate in the 1-norm to seven digits, for changes relative to 1 + H). It is meaningless at a fold, where the Jacobian is singular"),
  NUMBER("bordered_condition", found.bordered_condition, NONE, "", "if the matrix is singular",
         "condition number with the arclength equation added"),
};
static const po_block STATE_ROWS = BLOCK("diagnosed_state", STATE, NULL);
#undef S

#define S po_sensitivity
#define DERIVATIVE(name, member)                                                                   \
  NUMBER(name, member, NONE, "", "if not known",                                                   \
         "d ln(force) / d ln(parameter) at pull-off; 0 for a parameter that the scene does not have")
static const po_row SENSITIVITY[] = {
  DERIVATIVE("tabor", tabor),
  DERIVATIVE("amplitude", amplitude),
  DERIVATIVE("wavelength", wavelength),
  DERIVATIVE("radius", radius),
  NUMBER("residual", residual, NONE, "", "if not known", "relative change of the force if the residual were removed"),
  NUMBER("rounding", rounding, NONE, "", "if not known", "bound of the relative change of the force by rounding"),
};
static const po_block SENSITIVITY_ROWS = BLOCK("sensitivity", SENSITIVITY, NULL);
#undef S

#define S po_moved
/* Number of decimal digits that are unchanged by a relative change, at most those of a double; NAN
 * for NAN. */
static double digits_left(double change) {
  return isnan(change) ? change : -po_log10(fmax(fabs(change), 0.5 * DBL_EPSILON));
}

static double digits_kept(const void *of) {
  return digits_left(((const S *)of)->change);
}

static double digits_predicted(const void *of) {
  return digits_left(((const S *)of)->predicted);
}

static const po_row MOVED[] = {
  COUNT("solves", solves,
        "number of solves with a changed input: each input is replaced by the next larger and the next smaller double"),
  COUNT("failed", failed, "number of these that failed"),
  NUMBER("force_change", change, NONE, "", "if none succeeded", "largest relative change of the pull-off force"),
  NUMBER("force_excess", excess, NONE, "", "if none succeeded, or without error estimates",
         "largest change of the pull-off force, divided by the sum of the error estimates of both solves"),
  NUMBER("force_change_predicted", predicted, NONE, "", "if there are no sensitivities",
         "the same change from the sensitivities, with residual and rounding"),
  DERIVED("digits_kept", NONE, digits_kept, "", "as `force_change`", "`force_change` as the number of decimal digits that remain"),
  DERIVED("digits_predicted", NONE, digits_predicted, "", "as `force_change_predicted`", "the same of `force_change_predicted`"),
  NUMBER("fold_change", folds, LENGTH, "", "if the number of folds changed", "largest change of the approach of a fold"),
};
static const po_block MOVED_ROWS = BLOCK("moved", MOVED, NULL);
#undef S

#define S po_reverse_trace
#define DIFFERENCE(name, member, of, what)                                                         \
  NUMBER(name, member, of, "", "if not `same`",                                                    \
         "largest difference of the " what " between trace and reverse trace")
static const po_row REVERSE[] = {
  STATUS("status", status, "as in a result, for the reverse trace"),
  TEXT("reason", reason, "as in a result, for the reverse trace"),
  COUNT("points", points, "number of points"),
  COUNT("folds", folds, "number of folds"),
  COUNT("extrema", extrema, "number of extrema of the load"),
  FLAG("same", same,
       "whether folds and extrema are the same as on the trace, in opposite order, by kind and number of unstable modes"),
  DIFFERENCE("fold_approach_change", fold_approach, LENGTH, "approach of a fold"),
  DIFFERENCE("fold_load_change", fold_load, LOAD, "load of a fold"),
  DIFFERENCE("extremum_approach_change", extremum_approach, LENGTH, "approach of an extremum"),
  DIFFERENCE("extremum_load_change", extremum_load, LOAD, "load of an extremum"),
  NUMBER("excess", excess, NONE, "", "if not `same`",
         "largest difference in approach or load of a fold, divided by the sum of the error estimates of both traces"),
};
static const po_block REVERSE_ROWS = BLOCK("reverse_trace", REVERSE, NULL);
#undef S

#define S po_diagnostics
static const po_row DIAGNOSTICS[] = {
  NUMBER("residual", residual, NONE, "", "for rigid scenes",
         "largest residual of the discrete equations at the diagnosed states, evaluated in twice the precision, relative to 1 + H"),
  NUMBER("rounding", rounding, NONE, "", "for rigid scenes",
         "the residual that one rounding of each term of these equations would cause"),
  COUNT("undiagnosed", undiagnosed, "number of states whose diagnosis failed"),
  LIST("states", states, state_count, STATE_ROWS, NULL, "", "the diagnosed states: start, pull-off, end, and at most twelve folds"),
  OPTIONAL("sensitivity", force, has_sensitivity, SENSITIVITY_ROWS, "for rigid scenes",
           "how the pull-off force depends on the inputs"),
  PART("moved", moved, MOVED_ROWS, "the scene solved again with inputs changed by their last bit"),
  NUMBER("energy_defect", energy_defect, NONE, "", "if there are too few points",
         "largest difference between energy gained and work done along the branch, relative to the range of the energy"),
  NUMBER("energy_defect_at", energy_defect_at, LENGTH, "", "if there are too few points", "approach at which it occurs"),
  OPTIONAL("reverse_trace", reverse_trace, reverse_trace.made, REVERSE_ROWS,
           "for rings and triangles, and for rigid scenes",
           "the branch followed back from its end, with steps and meshes of its own"),
  NUMBER("seconds", seconds, TIME, "", "", "elapsed time for all diagnostics"),
};
const po_block PO_DIAGNOSTICS_ROWS = BLOCK("diagnostics", DIAGNOSTICS, NULL);
#undef S
