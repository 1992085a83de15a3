#include "po_result_rows.h"

#include <string.h>

#include "po_result.h"
#include "po_row_cells.h"

// clang-format off
#define NO_BOUND "for rings and triangles (unless rigid), and if there was no room for a finer mesh"
#define OTHER_RADIUS                                                                               \
  "the second possible contact radius if the error does not decide whether a crest is in contact"
#define FOLDED "with `--of folds`, from the scene at which the fold ended"

/* -- Special points -- */
const char *const PO_SPECIAL_KINDS[] = {[PO_JUMP_IN] = "jump_in", [PO_JUMP_OUT] = "jump_out",
                                    [PO_MINIMUM] = "minimum", [PO_MAXIMUM] = "maximum", NULL};

#define S po_special_point
static const po_row SPECIAL_POINT[] = {
  WORD("kind", kind, PO_SPECIAL_KINDS, "`jump_in` or `jump_out` (a fold), `minimum` or `maximum` (of the load)"),
  NUMBER("approach", approach, LENGTH, "error_estimate", FOLDED, "approach"),
  NUMBER("load", load, LOAD, "load_error_estimate", FOLDED, "load"),
  NUMBER("energy", energy, ENERGY, "energy_error_estimate", "if followed", "potential energy, as in `curve_point`"),
  NUMBER("energy_error_estimate", energy_error, ENERGY, "", "as `error_estimate`",
         "bound of the error of `energy`, with that of the approach"),
  NUMBER("error_estimate", approach_error, LENGTH, "",
         "for extrema that cannot be the pull-off, for rings and triangles, and if there was no room for a finer mesh",
         "bound of the error of `approach`"),
  NUMBER("load_error_estimate", load_error, LOAD, "", "as `error_estimate`", "bound of the error of `load`"),
  NUMBER("contact_radius", contact_radius, LENGTH, "contact_radius_error_estimate", FOLDED, "contact radius"),
  NUMBER("contact_radius_error_estimate", contact_radius_error, LENGTH, "", "as in `pull_off`",
         "bound of the error of `contact_radius`"),
  NUMBER("contact_radius_other", contact_radius_other, LENGTH, "", "otherwise", OTHER_RADIUS),
  NUMBER("position", position, NONE, "", "if followed",
         "arclength along the branch, in a measure of the solver; it orders special points among the points of the curve"),
  INTEGER("unstable_modes", unstable_modes, "number of unstable modes, at given approach, of the equilibria just after this point"),
  OPTIONAL_INTEGER("unstable_modes_at_base", base_modes, has_base, "absent without a stiffness", "the same at a given base of the spring"),
};
const po_block PO_SPECIAL_POINT_ROWS = BLOCK("special_point", SPECIAL_POINT, NULL);
#undef S

/* -- Curve, profile and contact -- */
#define S po_curve_point
static const po_row CURVE[] = {
  NUMBER("position", position, NONE, "", "", "arclength along the branch, in a measure of the solver"),
  NUMBER("approach", approach, LENGTH, "", "", "approach"),
  NUMBER("load", load, LOAD, "", "", "load"),
  NUMBER("energy", energy, ENERGY, "energy_error_estimate", "if not known",
         "potential energy, elastic and of the interaction; 0 when the bodies are infinitely far apart. Its derivative by the approach along the branch is the load"),
  NUMBER("energy_error_estimate", energy_error, ENERGY, "", "for rings and triangles",
         "bound of the error of `energy` at this approach. The tolerance is on the pull-off force: energies may be off by ten times as much and more, because their errors are mostly those of the attraction far out, which has little effect on the force"),
  NUMBER("contact_radius", contact_radius, LENGTH, "", "", "contact radius"),
  NUMBER("approach_rate", approach_rate, NONE, "", "if not known", "derivative of the approach by `position`; 0 at a fold"),
  NUMBER("load_rate", load_rate, LOAD, "", "if not known", "derivative of the load by `position`; 0 at an extremum of the load"),
  INTEGER("unstable_modes", unstable_modes, "number of unstable modes at given approach; 0: stable"),
  OPTIONAL_INTEGER("unstable_modes_at_base", base_modes, has_base, "absent without a stiffness", "the same at a given base of the spring"),
};
const po_block PO_CURVE_ROWS = BLOCK("curve_point", CURVE, NULL);
#undef S

#define S po_profile_point
static const po_row PROFILE[] = {
  NUMBER("radius", radius, LENGTH, "", "", "radius r"),
  NUMBER("gap", gap, GAP, "", "", "H = h/ε − 1"),
  NUMBER("traction", traction, TRACTION, "", "",
         "traction p, positive when compressive; 0 for rigid scenes, where the unit vanishes"),
};
const po_block PO_PROFILE_ROWS = BLOCK("profile_point", PROFILE, NULL);
#undef S

#define S po_contact_annulus
static const po_row ANNULUS[] = {
  NUMBER("inner", inner, LENGTH, "", "", "inner radius"),
  NUMBER("outer", outer, LENGTH, "", "", "outer radius"),
};
static const po_block ANNULUS_ROWS = BLOCK("annulus", ANNULUS, NULL);
#undef S

#define S po_result
static double grooves_of(const void *of) {
  const size_t held = ((const S *)of)->annuli.held_count;
  return held > 0 ? (double)(held - 1) : 0.0;
}

static const po_row CONTACT[] = {
  NUMBER("approach", profile_approach, LENGTH, "", "if the branch does not reach it", "as `profile_approach`"),
  LIST("compressed", annuli.compressed, annuli.compressed_count, ANNULUS_ROWS, NULL, "",
       "annuli in which the traction is compressive, H < 0"),
  LIST("held", annuli.held, annuli.held_count, ANNULUS_ROWS, NULL, "",
       "annuli in contact: closer than at the greatest tension, H < 3^(1/6) − 1"),
  DERIVED_COUNT("grooves", grooves_of, "number of grooves between the annuli of `held`"),
};
const po_block PO_CONTACT_ROWS = BLOCK("contact", CONTACT, NULL);
#undef S

/* -- The result -- */
#define S po_preload
static const po_row PRESSED[] = {
  NUMBER("approach", approach, LENGTH, "", "if there is none", "approach of the state of loading"),
  NUMBER("load", load, LOAD, "", "if there is none", "load of the state of loading"),
};
static const po_block PRESSED_ROWS = BLOCK("preload_state", PRESSED, NULL);
#undef S

#define S po_work
static const po_row WORK[] = {
  COUNT("points", points, "converged equilibria"),
  COUNT("newton_iterations", newton_iterations, "iterations of the corrector"),
  COUNT("factorizations", factorizations, "factorisations of the Jacobian"),
  COUNT("kernel_evaluations", kernel_evaluations, "evaluations of the kernel G(r, s) of Eq 12, for rings of F of Eq A2"),
  COUNT("nodes", nodes, "unknowns of the surface; the largest number if the mesh changes"),
  COUNT("factorized_nodes", factorized_nodes, "largest order of a factorised Jacobian"),
  COUNT("meshes", meshes, "number of changes of the mesh"),
  NUMBER("seconds", seconds, TIME, "", "if not known", "elapsed time, with that of the theories beside the solve"),
};
static const po_block WORK_ROWS = BLOCK("work", WORK, NULL);
#undef S

#define S po_result
static const po_row PULL_OFF[] = {
  NUMBER("force", pull_off.force, LOAD, "error_estimate", "", "pull-off force, positive"),
  NUMBER("approach", pull_off.approach, LENGTH, "approach_error_estimate", "", "approach at pull-off"),
  NUMBER("contact_radius", pull_off.contact_radius, LENGTH, "contact_radius_error_estimate", "", "contact radius at pull-off"),
  NUMBER("error_estimate", pull_off.force_error, LOAD, "", NO_BOUND, "bound of the error of `force`"),
  NUMBER("approach_error_estimate", pull_off.approach_error, LENGTH, "", "as `error_estimate`", "bound of the error of `approach`"),
  NUMBER("contact_radius_error_estimate", pull_off.contact_radius_error, LENGTH, "",
         "as `error_estimate`", "bound of the error of `contact_radius`"),
  NUMBER("contact_radius_other", pull_off.contact_radius_other, LENGTH, "", "otherwise", OTHER_RADIUS),
  NUMBER("error_over_tolerance", pull_off.excess, NONE, "", "as `error_estimate`",
         "`error_estimate` over the tolerance times `force`. Above 1 the tolerance is not met; above 10 the solve fails"),
  PART("preload", pull_off.pressed, PRESSED_ROWS,
       "the least preload that gives this pull-off; its members are null if no test at given approach measures it"),
  PART("until", pull_off.until, PRESSED_ROWS,
       "the hardest preload that gives it before a change; its members are null if no change was traced"),
};
const po_block PO_PULL_OFF_ROWS = BLOCK("pull_off", PULL_OFF, NULL);

static const po_row ANY[] = {
  NUMBER("force", pull_off_any.force, LOAD, "error_estimate", "", "pull-off force, positive"),
  NUMBER("error_estimate", pull_off_any.force_error, LOAD, "", "as in `pull_off`", "bound of the error of `force`"),
  NUMBER("approach", pull_off_any.approach, LENGTH, "approach_error_estimate", "", "approach at pull-off"),
  NUMBER("approach_error_estimate", pull_off_any.approach_error, LENGTH, "", "as in `pull_off`",
         "bound of the error of `approach`"),
  PART("preload", pull_off_any.pressed, PRESSED_ROWS, "the least preload that gives it"),
  FLAG("complete", pull_off_any.complete, "whether it is known that no harder preload gives more ([guide](guide.md#preload))"),
  PART("searched", pull_off_any.searched, PRESSED_ROWS, "the hardest preload that was examined"),
};
static const po_block ANY_ROWS = BLOCK("pull_off_any", ANY, NULL);

#define NOT_LINEAR "if a solve failed, or if the force is not linear over the uncertainty of a source"
#undef S
#define S po_uncertain
static const po_row UNCERTAIN[] = {
  TEXT("source", source, "the key of an uncertain input, or `noise` of the profile"),
  NUMBER("value", value, NONE, "", "of noise", "the input as it was given"),
  NUMBER("deviation", deviation, NONE, "", "", "its standard uncertainty; of noise, in the unit of the file"),
  NUMBER("below", below, LOAD, "", "if that solve failed", "change of the pull-off force when the input is less by twice `deviation`"),
  NUMBER("above", above, LOAD, "", "if that solve failed", "the same when it is more"),
  NUMBER("force", force, LOAD, "", NOT_LINEAR, "standard uncertainty of the pull-off force"),
};
const po_block PO_UNCERTAIN_ROWS = BLOCK("uncertain", UNCERTAIN, NULL);
#undef S
#define S po_result
static const po_row UNCERTAINTY[] = {
  NUMBER("force", uncertainty, LOAD, "", NOT_LINEAR, "root of the sum of squares of the sources"),
  LIST("sources", uncertain, uncertain_count, PO_UNCERTAIN_ROWS, NULL, "", "one row an uncertain input"),
};
static const po_block UNCERTAINTY_ROWS = BLOCK("uncertainty", UNCERTAINTY, NULL);

static const po_row INTERPOLATION[] = {
  NUMBER("force", interpolation.force, LOAD, "", "if a solve failed", "the greatest modulus of the three changes"),
  NUMBER("without_odd_rows", interpolation.without_odd, LOAD, "", "if that solve failed",
         "change of the pull-off force if the rows of odd number, counted from 0 on the axis, are left out"),
  NUMBER("without_even_rows", interpolation.without_even, LOAD, "", "if that solve failed", "the same of even number, but for the first and the last row"),
  NUMBER("round_apex", interpolation.round_apex, LOAD, "", "if that solve failed", "the same if the spline is level on the axis"),
  INTEGER("interval", interpolation.interval, "the interval of the rows, from 1, in which the contact ends at pull-off"),
  FLAG("solved", interpolation.solved, "whether a change was so large that the scene was solved with the changed spline; otherwise they are of first order"),
};
static const po_block INTERPOLATION_ROWS = BLOCK("interpolation", INTERPOLATION, NULL);

static const char *const CAUSES[] = {
  [PO_END_NONE] = "none", [PO_END_COMPRESSED] = "compressed", [PO_END_PRELOAD] = "preload",
  [PO_END_COMPLETE] = "complete", [PO_END_SEARCHED] = "searched", [PO_END_ASKED] = "approach_end",
  NULL};

static const char *why_of(const void *of) {
  const S *o = of;
  return o->ended.cause == PO_END_NONE ? po_status_name(o->status) : CAUSES[o->ended.cause];
}

static void take_why(void *of, const char *word) {
  ((S *)of)->ended.cause = PO_END_NONE; /* the status states the reason */
  for (int k = 0; word && CAUSES[k]; ++k)
    if (strcmp(word, CAUSES[k]) == 0)
      ((S *)of)->ended.cause = (po_end_cause)k;
}

static const po_row ENDED[] = {
  {.key = "why", .type = PO_ROW_WORD, .names = CAUSES + 1, .word = why_of, .take = take_why,
   TEXTS("", "", "`compressed`, `preload`, `complete`, `searched`, `approach_end`, or the status of a trace that failed ([guide](guide.md#why-a-trace-ended))")},
  NUMBER("approach", ended.approach, LENGTH, "", "if nothing was traced", "approach of the last point of the trace"),
  NUMBER("load", ended.load, LOAD, "", "if nothing was traced", "load of the last point"),
};
static const po_block ENDED_ROWS = BLOCK("ended", ENDED, NULL);

static double end_of(const void *of) {
  return ((const S *)of)->ended.approach;
}

static bool is_followed(const void *of) {
  return ((const S *)of)->followed;
}

/* For a followed pull-off the special points are unknown, which differs from an empty list.
 * Followed folds are listed. */
static bool lacks_folds(const void *of) {
  return ((const S *)of)->followed && !((const S *)of)->fold_count;
}

static bool lacks_extrema(const void *of) {
  return ((const S *)of)->followed && !((const S *)of)->extremum_count;
}

static bool lacks_diagnostics(const void *of) {
  return !((const S *)of)->diagnostics.states && !((const S *)of)->diagnostics.moved.solves;
}

#define UNWANTED "absent unless wanted, or if the solve failed"
static const po_row RESULT[] = {
  STATUS("status", status,
         "`ok`, or why the solve failed ([guide](guide.md#why-a-trace-ended)); then the other keys contain what was found until then"),
  TEXT("reason", reason, "the message of a failure; empty for `ok`"),
  FLAG("rigid", rigid, "whether the surfaces are rigid (`tabor` 0), so that nothing was solved"),
  FLAG("followed", followed,
       "whether the pull-off was obtained by parameter continuation from other scenes ([follow](cases.md#follow))"),
  NUMBER("start", start, LENGTH, "", "if nothing was traced", "approach at which the trace began"),
  DERIVED("end", LENGTH, end_of, "", "if nothing was traced", "approach at which the trace ended; the same as `ended.approach`"),
  {.key = "ended", .type = PO_ROW_PART, .block = &ENDED_ROWS, .absent = is_followed,
   TEXTS("", "if followed", "where and why the trace ended")},
  OPTIONAL_GROUP("pull_off", has_pull_off, PO_PULL_OFF_ROWS, "if none was found, or the trace failed before the preload", "the pull-off that belongs to the preload"),
  OPTIONAL_GROUP("pull_off_any", pull_off_any.is_known, ANY_ROWS,
                 "if no test at given approach measures a pull-off on this branch, or if followed",
                 "the greatest pull-off that any preload gives"),
  LIST("folds", folds, fold_count, PO_SPECIAL_POINT_ROWS, lacks_folds,
       "if followed, except by `follow --of folds`",
       "folds in approach, in order along the branch"),
  LIST("extrema", extrema, extremum_count, PO_SPECIAL_POINT_ROWS, lacks_extrema, "if followed",
       "extrema of the load, in order along the branch"),
  PART("work", work, WORK_ROWS, "counters of work, and the time"),
};

#undef S
#define S po_range_loops
static const po_row RANGE_LOOPS[] = {
  NUMBER("least", least, NONE, "", "", "the least range, relative to that of the scene"),
  NUMBER("greatest", greatest, NONE, "", "", "the greatest of the six ranges from which the limits follow"),
  NUMBER("approach_error_estimate", approach, LENGTH, "", "", "greatest error of an approach at which a jump begins or ends"),
  NUMBER("load_error_estimate", load, LOAD, "", "", "greatest error of a load there"),
};
static const po_block RANGE_LOOPS_ROWS = BLOCK("range_loops", RANGE_LOOPS, NULL);
#undef S
#define S po_range_stairs
static const po_row RANGE_STAIRS[] = {
  NUMBER("least", least, NONE, "", "", "the least range, relative to that of the scene"),
  NUMBER("greatest", greatest, NONE, "", "", "the greatest of the six ranges from which the limits follow"),
  COUNT("left_out", left_out, "number of steps of light preloads at given approach that are left out, because not all ranges have them"),
};
static const po_block RANGE_STAIRS_ROWS = BLOCK("range_stairs", RANGE_STAIRS, NULL);
#undef S
#define S po_result

static const po_row RANGE[] = {
  NUMBER("least", range.least, NONE, "", "", "the least range, relative to that of the scene"),
  NUMBER("greatest", range.greatest, NONE, "", "", "the greatest of the six ranges from which the limit follows"),
  NUMBER("change", range.change, LOAD, "", "", "change of the pull-off force from the least range to the true one; its error is in `error_estimate`"),
  {.key = "loops", .type = PO_ROW_PART, .block = &RANGE_LOOPS_ROWS, .omitted = true, .offset = offsetof(S, range.loops),
   .present = AT(bool, range.loops.are_known),
   TEXTS("", "absent without loops", "the ranges of the loops; numbers at their jumps of loading change with powers of the range as low as 4/7")},
  {.key = "stairs", .type = PO_ROW_PART, .block = &RANGE_STAIRS_ROWS, .omitted = true, .offset = offsetof(S, range.stairs),
   .present = AT(bool, range.stairs.are_known), TEXTS("", "absent without staircases", "the ranges of the staircases")},
};
static const po_block RANGE_ROWS = BLOCK("range", RANGE, NULL);

#undef S
#define S po_rate_energy
static const po_row ENERGIES[] = {
  NUMBER("stored", stored, ENERGY, "", "", "elastic energy of the half-space"),
  NUMBER("adhesive", adhesive, ENERGY, "", "", "energy of the interaction, 0 infinitely apart"),
  NUMBER("spring", spring, ENERGY, "", "", "energy of the spring; 0 without a stiffness"),
  NUMBER("work", work, ENERGY, "", "", "work of the base since unloading began; before it, less that until then"),
  NUMBER("dissipated", dissipated, ENERGY, "", "", "energy dissipated in the half-space, as the work"),
  NUMBER("jumps", jumps, ENERGY, "", "", "energy lost in jumps of the contact, as the work"),
};
static const po_block ENERGIES_ROWS = BLOCK("unloading_energies", ENERGIES, NULL);
#undef S

#define S po_rate_point
static const po_row RATE_POINT[] = {
  NUMBER("moved", moved, LENGTH, "", "", "by how much the base was moved back; before unloading, how far it was from where that begins"),
  NUMBER("time", time, NONE, "", "at the speeds 0 and inf of unloading", "time since unloading began, τ₀; < 0 before"),
  NUMBER("base", base, LENGTH, "", "", "position of the base; the approach without a stiffness"),
  NUMBER("approach", approach, LENGTH, "", "", "approach"),
  NUMBER("load", load, LOAD, "", "", "load"),
  NUMBER("contact_radius", contact_radius, LENGTH, "", "", "contact radius"),
  PART("energies", energy, ENERGIES_ROWS, "energies, work and losses"),
};
static const po_block RATE_POINT_ROWS = BLOCK("unloading_point", RATE_POINT, NULL);
#undef S

#define S po_rate_loading
static const po_row RATE_LOADING[] = {
  COUNT("jumps", jumps, "number of jumps of the contact in loading and the dwell"),
  PART("start", start, RATE_POINT_ROWS, "the state before any creep, with the bodies apart, from which they are loaded; its work and losses are those of loading and the dwell, times −1"),
  PART("error_estimate", error, ENERGIES_ROWS, "bounds of the errors of the energies of `start`"),
};
static const po_block RATE_LOADING_ROWS = BLOCK("unloading_loading", RATE_LOADING, NULL);
#undef S

#define S po_rate
static const po_row RATE[] = {
  NUMBER("instant_compliance", instant, NONE, "", "", "ratio of the relaxed to the glassy modulus"),
  NUMBER("time", time, NONE, "time_error_estimate", "at the speeds 0 and inf", "time from the preload to the pull-off, τ₀"),
  NUMBER("time_error_estimate", time_error, NONE, "", "as `time`", "bound of the error of `time`"),
  NUMBER("step_error_estimate", time_part, LOAD, "", "", "the part of the error of the force by the steps in time"),
  NUMBER("panel_error_estimate", mesh_part, LOAD, "", "", "the part of it by the panels"),
  NUMBER("imbalance", imbalance, ENERGY, "", "",
         "greatest miss of the balance of energy along the finest march, whose values are not extrapolated"),
  COUNT("jumps", jumps, "number of jumps of the contact while unloading"),
  COUNT("terms", terms, "number of retardation times"),
  COUNT("steps", steps, "number of steps of the finest march"),
  {.key = "loading", .type = PO_ROW_PART, .block = &RATE_LOADING_ROWS, .omitted = true, .offset = offsetof(S, loading),
   .present = AT(bool, loading.is_known),
   TEXTS("", "absent if the body is relaxed at the preload", "loading at a speed, and the dwell")},
  PART("begin", begin, RATE_POINT_ROWS, "the contact at the preload: relaxed, or as loading and the dwell left it"),
  PART("end", end, RATE_POINT_ROWS,
       "where unloading ends: nowhere in contact, with a tension below 1 % of the pull-off force"),
  PART("error_estimate", end_error, ENERGIES_ROWS, "bounds of the errors of the energies of `end` and `begin`"),
  LIST("history", history, history_count, RATE_POINT_ROWS, NULL, "", "states of loading at a speed, of the dwell and of unloading, if the history is wanted; otherwise empty"),
};
static const po_block RATE_ROWS = BLOCK("unloading", RATE, NULL);
#undef S
#define S po_result

static const po_row PARABOLA[] = {
  NUMBER("contact_radius_over_radius", parabola.wide, NONE, "", "", "contact radius at pull-off over R"),
  NUMBER("limit", parabola.limit, NONE, "", "", "limit of it, up to which the parabola stands for a sphere"),
  NUMBER("exact_sphere", parabola.sphere, LENGTH, "", "", "R of the profile `exact_sphere:R`, which is the sphere"),
  LIST("theories", parabola.theories, parabola.theory_count, PO_PARABOLA_THEORY_ROWS, NULL, "",
       "theories whose assumptions hold, for the parabola"),
};
static const po_block PARABOLA_ROWS = BLOCK("parabola", PARABOLA, NULL);

static const po_row WANTED[] = {
  {.key = "range", .type = PO_ROW_PART, .block = &RANGE_ROWS, .omitted = true, .present = AT(bool, range.is_reduced),
   TEXTS("", "absent unless the pull-off was found with greater ranges of the attraction", "the ranges with which the scene was solved ([guide](guide.md#a-greater-range)); `folds` and `extrema` are then those of which the limit is known")},
  {.key = "unloading", .type = PO_ROW_PART, .block = &RATE_ROWS, .omitted = true, .offset = offsetof(S, rate),
   .present = AT(bool, rate.is_known),
   TEXTS("", "absent but for a viscoelastic body", "unloading of a viscoelastic body ([guide](guide.md#viscoelastic-bodies))")},
  {.key = "interpolation", .type = PO_ROW_PART, .block = &INTERPOLATION_ROWS, .omitted = true,
   .present = AT(bool, interpolation.is_known),
   TEXTS("", "absent but for a table without noise", "uncertainty of the pull-off force by the interpolation between the rows of a table; it has no part in `error_estimate`, nor in the digest")},
  {.key = "uncertainty", .type = PO_ROW_PART, .block = &UNCERTAINTY_ROWS, .omitted = true, .count = AT(size_t, uncertain_count),
   TEXTS("", "absent without uncertain inputs", "standard uncertainty of the pull-off force by that of the inputs; it has no part in `error_estimate`")},
  {.key = "hysteresis", .type = PO_ROW_PART, .block = &PO_HYSTERESIS_ROWS, .omitted = true,
   .present = AT(bool, has_hysteresis), TEXTS("", UNWANTED, "loading and unloading")},
  {.key = "staircase", .type = PO_ROW_PART, .block = &PO_STAIRCASE_ROWS, .omitted = true,
   .present = AT(bool, has_staircases), TEXTS("", UNWANTED, "the pull-off for every preload")},
  {.key = "diagnostics", .type = PO_ROW_PART, .block = &PO_DIAGNOSTICS_ROWS, .omitted = true,
   .offset = offsetof(S, diagnostics), .absent = lacks_diagnostics,
   TEXTS("", "absent unless wanted", "how far the numbers can be relied on")},
  {.key = "theories", .type = PO_ROW_LIST, .block = &PO_THEORIES_ROWS, .omitted = true,
   .offset = offsetof(S, theories), .count = AT(size_t, theory_count),
   TEXTS("", UNWANTED, "what the theories say about the pull-off force, one row a theory")},
  {.key = "parabola", .type = PO_ROW_PART, .block = &PARABOLA_ROWS, .omitted = true,
   .count = AT(size_t, parabola.theory_count),
   TEXTS("", "absent but for a wide contact of a parabola of which a theory holds",
         "where theories hold for the parabola r²/(2R), which was solved, and not for a sphere of this R; it has no part in the digest")},
};
const po_block PO_RESULT_ROWS = BLOCK("result", RESULT, NULL);
const po_block PO_WANTED_ROWS = BLOCK("result", WANTED, NULL);

static const po_row BRANCH[] = {
  LIST("curve", curve, curve_count, PO_CURVE_ROWS, NULL, "", "points of the branch, in order"),
};
const po_block PO_BRANCH_ROWS = BLOCK("branch", BRANCH, NULL);

static const po_row SURFACE[] = {
  NUMBER("profile_approach", profile_approach, LENGTH, "", "if the branch does not reach it", "approach of the profile"),
  LIST("profile", profile, profile_count, PO_PROFILE_ROWS, NULL, "", "gap and traction over the radius"),
  GROUP("contact", PO_CONTACT_ROWS, "the regions in contact at the approach of the profile"),
};
const po_block PO_SURFACE_ROWS = BLOCK("surface", SURFACE, NULL);

#define ALSO(rows) {.key = "", .type = PO_ROW_INLINE, .block = &rows, TEXTS("", "", "")}
static const po_row ALL[] = {ALSO(PO_RESULT_ROWS), ALSO(PO_WANTED_ROWS), ALSO(PO_BRANCH_ROWS), ALSO(PO_SURFACE_ROWS)};
const po_block PO_ALL_ROWS = BLOCK("solve", ALL, NULL);
#undef S
