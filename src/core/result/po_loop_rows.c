/* The rows of loops and staircases. */
#include <math.h>
#include <stdio.h>

#include "po_result.h"
#include "po_result_rows.h"
#include "po_row_cells.h"

// clang-format off
#define NO_BOUND "for rings and triangles, and for the JKR theory"
/* The tests of a scene, of a structure S with the members `of` and `has_spring`. Given: the rows of
 * one, the row at given load, and the rows through the spring. */
#define TESTS(rows, at_given_load, of_spring, at_approach, through_spring)                         \
  PART("displacement_control", of[PO_AT_APPROACH], rows, at_approach), at_given_load,              \
  {.key = "spring", .type = PO_ROW_PART, .offset = offsetof(S, of[PO_THROUGH_SPRING]),             \
   .present = AT(bool, has_spring), .block = &of_spring, .omitted = true,                          \
   TEXTS("", "absent without a stiffness", through_spring)},
#define UNBOUNDED "if the bodies separate under tension, or come together from apart with a far field of infinite energy, which loses without bound"

/* -- States of the branch -- */
#define S po_path_state
/* The energy of separated bodies is not stated. */
static double energy_of_state(const void *of) {
  const S *s = of;
  return isinf(s->approach) ? (double)NAN : s->energy;
}

static void set_energy(void *of, double value) {
  ((S *)of)->energy = value;
}

/* A null approach means complete separation. */
static void settle_state(void *of) {
  S *s = of;
  if (isnan(s->approach)) {
    s->approach = -INFINITY;
    s->energy = 0.0;
  }
}

static const po_row STATE[] = {
  NUMBER("approach", approach, LENGTH, "", "if the bodies are infinitely far apart", "approach"),
  NUMBER("load", load, LOAD, "", "", "load"),
  FORM("energy", energy, ENERGY, energy_of_state, set_energy, "",
       "if the bodies are infinitely far apart", "potential energy, as in `curve_point`"),
  NUMBER("contact_radius", contact_radius, LENGTH, "", "if not known", "contact radius; 0 if the bodies are infinitely far apart"),
  NUMBER("position", position, NONE, "", "if the state is not on the branch", "arclength along the curve"),
};
static const po_block STATE_ROWS = BLOCK("path_state", STATE, settle_state);

static const po_row PLACE[] = {
  NUMBER("approach", approach, LENGTH, "", "in load control: contact from infinitely far away, or none", "approach"),
  NUMBER("load", load, LOAD, "", "", "load"),
  NUMBER("position", position, NONE, "", "if the state is not on the branch", "arclength along the branch"),
  HIDDEN("energy", energy, ENERGY, "potential energy"),
};
static const po_block PLACE_ROWS = BLOCK("branch_state", PLACE, settle_state);
#undef S

/* -- Loops -- */
void po_jump_label(bool loading, size_t number, po_label label) {
  enum { LETTERS = 26 };
  if (loading) {
    snprintf(label, PO_LABEL_LENGTH, "%u", (unsigned)number % 10000000);
    return;
  }
  po_label backwards;
  size_t n = 0;
  for (; number > 0 && n + 1 < PO_LABEL_LENGTH; number = (number - 1) / LETTERS)
    backwards[n++] = (char)('a' + (number - 1) % LETTERS);
  for (size_t k = 0; k < n; ++k)
    label[k] = backwards[n - 1 - k];
  label[n] = '\0';
}

#define S po_jump
/* The number of a jump in loading or in unloading, from 1. */
static size_t jump_number(const po_loop *loop, size_t index) {
  return index < loop->loading_jumps ? index + 1 : index + 1 - loop->loading_jumps;
}

static void label_jump(const void *of, size_t index, po_label label[2]) {
  const po_loop *loop = of;
  po_jump_label(loop->jumps[index].loading, jump_number(loop, index), label[0]);
}

static void label_ends(const void *of, size_t index, po_label label[2]) {
  const po_loop *loop = of;
  const size_t number = jump_number(loop, index);
  po_jump_label(loop->jumps[index].loading, 2 * number - 1, label[0]);
  po_jump_label(loop->jumps[index].loading, 2 * number, label[1]);
}

static const char *const PHASES[] = {"unloading", "loading", NULL};

static const po_row JUMP[] = {
  WORD("phase", loading, PHASES, "whether it occurs in loading or in unloading"),
  LABEL("label", PO_ROW_LABEL, label_jump, "`1`, `2`, … in loading; `a`, `b`, … in unloading"),
  LABEL("ends", PO_ROW_LABELS, label_ends,
        "labels of the state before and after as in the figures of the paper: `1` and `2`, `3` and `4`, …; `a` and `b`, …"),
  PART("before", before, STATE_ROWS, "the state before the jump"),
  PART("after", after, STATE_ROWS, "the state after the jump"),
  NUMBER("energy_lost", energy_lost, ENERGY, "energy_lost_error_estimate", UNBOUNDED,
         "drop of the energy at given approach; at given load, drop of the energy minus load times approach; through a spring, drop of the energy of surface and spring"),
  NUMBER("energy_lost_error_estimate", energy_lost_error, ENERGY, "",
         "as `energy_lost`; " NO_BOUND, "bound of the error of `energy_lost`"),
};
static const po_block JUMP_ROWS = BLOCK("jump", JUMP, NULL);
#undef S

#define S po_loop_row
static const po_row LOOP_ROW[] = {
  WORD("phase", loading, PHASES, "loading or unloading"),
  FLAG("jump", jump, "whether a jump from the row before ends here"),
  NUMBER("base", base, LENGTH, "", "", "position of the base, approach + load/stiffness; without a spring the approach"),
  NUMBER("approach", state.approach, LENGTH, "", "", "approach"),
  NUMBER("indentation", indentation, LENGTH, "", "if loading makes no contact",
         "approach less that of the first row with contact"),
  NUMBER("load", state.load, LOAD, "", "", "load"),
  NUMBER("contact_radius", state.contact_radius, LENGTH, "", "if not known", "contact radius"),
  NUMBER("stiffness", stiffness, STIFFNESS, "", "at a fold, where it is infinite", "derivative of the load by the approach"),
  NUMBER("energy_lost", energy_lost, ENERGY, "", "if the jump loses without bound",
         "energy lost in the jump that ends here; 0 where none ends"),
  HIDDEN("energy", state.energy, ENERGY, "potential energy"),
};
const po_block PO_LOOP_ROW_ROWS = BLOCK("loop_row", LOOP_ROW, NULL);
#undef S

#define S po_loop
static const po_row LOOP_PATH[] = {
  NUMBER("area_error_estimate", row_area_error, ENERGY, "", NO_BOUND,
         "bound of the difference between `energy_lost` of the loop and the area that the rows enclose over the base, by the trapezoidal rule"),
  LIST("rows", row, row_count, PO_LOOP_ROW_ROWS, NULL, "", "the states in the order of the test"),
};
static const po_block LOOP_PATH_ROWS = BLOCK("loop_path", LOOP_PATH, NULL);

static double force_of_loop(const void *of) {
  return fmax(0.0, -((const S *)of)->pull_off.load);
}

static void settle_loop(void *of) {
  S *l = of;
  l->loading_jumps = 0;
  for (size_t k = 0; k < l->jump_count; ++k)
    l->loading_jumps += l->jumps[k].loading;
}

static const po_row LOOP_PULL_OFF[] = {
  INLINE(pull_off, STATE_ROWS),
  DERIVED("force", LOAD, force_of_loop, "error_estimate", "",
          "magnitude of the load, 0 if there is no tension; at a special point approach and load are those of `extrema` or `folds`"),
  NUMBER("error_estimate", pull_off_error.load, LOAD, "", NO_BOUND, "bound of the error of `force`"),
  NUMBER("approach_error_estimate", pull_off_error.approach, LENGTH, "", NO_BOUND, "bound of the error of `approach`"),
};
static const po_block LOOP_PULL_OFF_ROWS = BLOCK("loop_pull_off", LOOP_PULL_OFF, NULL);

static const po_row LOOP[] = {
  PART("preload", preload, STATE_ROWS, "the state at which loading is reversed"),
  GROUP("pull_off", LOOP_PULL_OFF_ROWS, "the state of greatest tension in unloading"),
  NUMBER("energy_lost", energy_lost, ENERGY, "energy_lost_error_estimate", "if a jump loses without bound", "sum over the jumps"),
  NUMBER("energy_lost_error_estimate", energy_lost_error, ENERGY, "",
         "as `energy_lost`; " NO_BOUND, "bound of the error of `energy_lost`"),
  NUMBER("work", work, ENERGY, "work_error_estimate",
         "if a jump loses without bound, and in load control",
         "∮ load d(approach), through a spring ∮ load d(base), over the closed path; on panels equal to `energy_lost` to about a tenth of the tolerance"),
  NUMBER("work_error_estimate", work_error, ENERGY, "", "as `work`; " NO_BOUND, "bound of the error of `work`"),
  NUMBER("energy_error_estimate", energy_error, ENERGY, "", NO_BOUND,
         "bound of the errors of the energies of `preload` and of the ends of all jumps, at their approaches"),
  LIST("jumps", jumps, jump_count, JUMP_ROWS, NULL, "", "the jumps, first those of loading"),
  {.key = "path", .type = PO_ROW_PART, .block = &LOOP_PATH_ROWS, .omitted = true, .present = AT(bool, has_rows),
   TEXTS("", "absent unless `loop` is wanted, and in load control", "what a test records")},
};
static const po_block LOOP_ROWS = BLOCK("loop", LOOP, settle_loop);

static const po_row SPRING[] = {
  NUMBER("stiffness", control, STIFFNESS, "", "", "stiffness of the spring"),
  {.key = "", .type = PO_ROW_INLINE, .block = &LOOP_ROWS, TEXTS("", "", "")},
};
static const po_block SPRING_ROWS = BLOCK("spring_loop", SPRING, NULL);
#undef S

#define S po_hysteresis
static void settle_loops(void *of) {
  ((S *)of)->of[PO_AT_APPROACH].control = PO_DISPLACEMENT_CONTROL;
  ((S *)of)->of[PO_AT_LOAD].control = PO_LOAD_CONTROL;
}

static const po_row LOOPS[] = {
  TESTS(LOOP_ROWS,
        OPTIONAL("load_control", of[PO_AT_LOAD], has_load, LOOP_ROWS,
                 "if the curve has no equilibrium at load 0, at which this loop begins", "the same at given load"),
        SPRING_ROWS, "loading and unloading at given approach",
        "the same through a spring, whose other end, the base, is moved: it is at approach + load/stiffness")
};
static const po_block LOOPS_ROWS = BLOCK("loops", LOOPS, settle_loops);
#undef S

/* -- Staircases -- */
#define S po_cycle
static const po_row CYCLE[] = {
  PART("preload", preload, PLACE_ROWS, "the preload from which the cycle holds"),
  NUMBER("energy_lost", loss.energy, ENERGY, "energy_lost_error_estimate",
         "in load control, where the last jump loses without bound",
         "energy lost in all jumps of loading and unloading just beyond this preload"),
  NUMBER("energy_lost_error_estimate", energy_error, ENERGY, "",
         "as `energy_lost`; where the ranges of `range.stairs` have other jumps; " NO_BOUND, "bound of the error of `energy_lost`"),
  COUNT("jumps", loss.jumps, "number of these jumps"),
};
static const po_block CYCLE_ROWS = BLOCK("cycle", CYCLE, NULL);
#undef S

#define S po_step
static double force_of_step(const void *of) {
  return fmax(0.0, -((const S *)of)->pull_off.load);
}

static void set_force_of_step(void *of, double force) {
  ((S *)of)->pull_off.load = -force;
}

static const po_row STEP_PRELOAD[] = {
  INLINE(preload, PLACE_ROWS),
  NUMBER("error_estimate", preload_error.approach, LENGTH, "", "if there is no estimate", "bound of the error of `approach`"),
  NUMBER("load_error_estimate", preload_error.load, LOAD, "", "if there is no estimate", "bound of the error of `load`"),
};
static const po_block STEP_PRELOAD_ROWS = BLOCK("step_preload", STEP_PRELOAD, NULL);

static const char *const DECISIONS[] = {"minimum", "jump", NULL};

static const po_row STEP[] = {
  GROUP("preload", STEP_PRELOAD_ROWS, "the preload from which the step holds: the special point at which loading changes"),
  WORD("decided_by", jumped, DECISIONS, "`jump`: loading jumps there; `minimum`: loading passes a minimum of the load"),
  PART("until", until, PLACE_ROWS, "the hardest preload for which the step holds"),
  FLAG("open", open, "whether the trace ends before the step does"),
  FORM("force", pull_off.load, LOAD, force_of_step, set_force_of_step, "error_estimate", "", "pull-off force after such a preload"),
  NUMBER("error_estimate", pull_off_error.load, LOAD, "", "if there is no estimate", "bound of the error of `force`"),
  NUMBER("approach", pull_off.approach, LENGTH, "approach_error_estimate", "", "approach at pull-off"),
  NUMBER("approach_error_estimate", pull_off_error.approach, LENGTH, "", "if there is no estimate",
         "bound of the error of `approach`"),
  NUMBER("position", pull_off.position, NONE, "", "if not on the branch", "arclength of the pull-off along the branch"),
  LIST("cycles", cycle, cycle_count, CYCLE_ROWS, NULL, "", "the preloads of the step at which the jumps of a test change"),
  HIDDEN("energy", pull_off.energy, ENERGY, "potential energy at pull-off"),
};
const po_block PO_STEP_ROWS = BLOCK("step", STEP, NULL);
#undef S

#define S po_staircase
static const po_row STAIRS[] = {
  LIST("steps", step, count, PO_STEP_ROWS, NULL, "", "the steps, in the order of the preload"),
  PART("reached", reached, PLACE_ROWS, "the last state of loading that was traced"),
};
static const po_block STAIRS_ROWS = BLOCK("stairs", STAIRS, NULL);

static const po_row SPRING_STAIRS[] = {
  NUMBER("stiffness", control, STIFFNESS, "", "", "stiffness of the spring"),
  {.key = "", .type = PO_ROW_INLINE, .block = &STAIRS_ROWS, TEXTS("", "", "")},
};
static const po_block SPRING_STAIRS_ROWS = BLOCK("spring_stairs", SPRING_STAIRS, NULL);
#undef S

#define S po_staircases
static void settle_staircases(void *of) {
  ((S *)of)->of[PO_AT_APPROACH].control = PO_DISPLACEMENT_CONTROL;
  ((S *)of)->of[PO_AT_LOAD].control = PO_LOAD_CONTROL;
}

static const po_row STAIRCASES[] = {
  TESTS(STAIRS_ROWS, PART("load_control", of[PO_AT_LOAD], STAIRS_ROWS, "the staircase at given load"),
        SPRING_STAIRS_ROWS, "the staircase at given approach", "the staircase through the spring")
};
static const po_block STAIRCASES_ROWS = BLOCK("staircases", STAIRCASES, settle_staircases);
#undef S

#define S po_result
static const po_row HYSTERESIS[] = {
  INLINE(hysteresis, LOOPS_ROWS),
  OPTIONAL("jkr", theory.hysteresis, theory.has_hysteresis, LOOPS_ROWS, "for rigid scenes",
           "the same for the JKR theory of the sphere (Eq 5; Eq 7 if smooth), reversed at the same approach if `--preload` was given, otherwise at the same load"),
};
const po_block PO_HYSTERESIS_ROWS = BLOCK("hysteresis", HYSTERESIS, NULL);

static const po_row STAIRCASE[] = {
  INLINE(staircase, STAIRCASES_ROWS),
  OPTIONAL("jkr", theory.staircase, theory.has_staircases, STAIRCASES_ROWS, "for rigid scenes",
           "the same for the JKR theory of the sphere (Eq 5)"),
};
const po_block PO_STAIRCASE_ROWS = BLOCK("staircase", STAIRCASE, NULL);
#undef S
