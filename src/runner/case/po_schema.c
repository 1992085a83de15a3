#include "po_case_internal.h"
#include "po_field_table.h"

static const char A_KEY[] = "a key of the scene", VALUES[] = "a list of values",
                  WHEN[] = "a list of {key, values}", COUNT[] = "a whole number from 2 to 10000",
                  SEED[] = "a whole number of at most 15 digits", FROM[] = "a finite number",
                  TO[] = "a finite number > from", SCALE[] = "linear or log",
                  NAME[] = "letters, digits, _ and -";

static const po_field AXIS[] = {
    TEXT("key", po_axis, key, A_KEY),
    TEXTS("values", po_axis, values, VALUES),
    {0},
};

#define RANGE_OF(structure, axis)                                                                  \
  OPTIONAL_TEXTS("values", structure, axis values, VALUES),                                        \
      OPTIONAL_TEXT("from", structure, axis from_text, FROM),                                      \
      OPTIONAL_TEXT("to", structure, axis to_text, TO),                                            \
      OPTIONAL_TEXT("count", structure, axis count_text, COUNT),                                   \
      OPTIONAL_TEXT("scale", structure, axis scale, SCALE)

static const po_field RANGE[] = {
    TEXT("key", po_axis, key, A_KEY),
    RANGE_OF(po_axis, ),
    {0},
};

static const po_field LINE[] = {
    TEXT("name", po_case_line, name, NAME),
    TEXT("theory", po_case_line, theory, "the name of a closed form"),
    LIST("sweep", po_case_line, sweep, RANGE, WHEN),
    {0},
};

static const po_field DRAW[] = {
    TEXT("key", po_draw, key, A_KEY),
    TEXT("from", po_draw, from_text, FROM),
    TEXT("to", po_draw, to_text, TO),
    OPTIONAL_TEXT("scale", po_draw, scale, SCALE),
    OPTIONAL_TEXT("times", po_draw, times,
                  "root_radius, or a key given in scene, sweep or an earlier item"),
    {0},
};

static const po_field SAMPLE[] = {
    TEXT("seed", po_sample_words, seed_text, SEED),
    TEXT("count", po_sample_words, count_text, "a whole number from 1 to 100000"),
    LIST("keys", po_sample_words, keys, DRAW, "a list of {key, from, to}"),
    {0},
};

static const po_field TRACED[] = {
    TEXT("seed", po_traced_words, seed_text, SEED),
    TEXT("count", po_traced_words, count_text,
         "a whole number from 1 to the number of scenes between checkpoints"),
    {0},
};

static const po_field CHECK[] = {
    TEXT("quantity", po_check, quantity_text,
         "pull_off_force, pull_off_approach, contact_radius, pull_off_uncertainty, residual, "
         "moved_force, energy_defect, reverse_trace, hysteresis_force, hysteresis_approach, "
         "hysteresis_loss, jumps, pull_off_any, steps, load_steps, fold_count, folds, extrema, "
         "curve or solved_share"),
    TEXT("reference", po_check, reference,
         "bradley, every_scene, zero, traced or the path of a CSV file"),
    OPTIONAL_TEXT("tolerance", po_check, tolerance_text, "a finite number > 0"),
    OPTIONAL_TEXT("kind", po_check, kind_text, "abs, rel or ulp"),
    OPTIONAL_TEXT("because", po_check, because, "the reason for the tolerance"),
    OPTIONAL_TEXT(
        "stand_in", po_check, stand_in,
        "the reference of another check, used while the table of this check does not exist"),
    OPTIONAL_LIST("as_if", po_check, as_if, AXIS, "a list of {key, values}, each with one value"),
    OPTIONAL_LIST("when", po_check, when, AXIS, WHEN),
    {0},
};

#define SCENE_KEY(key, name, ...) OPTIONAL_TEXT(name, po_scene_words, values[PO_KEY_##key], NULL),
#define SCENE_KEYS PO_KEY_ROWS(SCENE_KEY) SCENE_KEY(COUPLING, "coupling", )

// clang-format off
/* With lengths in m. */
static const po_field PHYSICAL[] = {
    PO_SI_ROWS(SCENE_KEY)
    SCENE_KEY(PROFILE, "profile", )
    SCENE_KEY(PROFILE_FILE, "profile_file", )
    SCENE_KEY(WAVES, "waves", )
    {0},
};

static const po_field SCENE[] = {
    SCENE_KEYS
    OPTIONAL_PART("physical", po_scene_words, physical, PHYSICAL,
                  "a mapping of modulus_pa, work_j_per_m2, distance_m, radius_m and more"),
    {0},
};

static const po_field SETTINGS[] = {
    SCENE_KEYS
    PO_SI_ROWS(SCENE_KEY)
    {0},
};
// clang-format on

static const po_field SWEEP[] = {
    OPTIONAL_TEXT("key", po_sweep, axis.key, A_KEY),
    RANGE_OF(po_sweep, axis.),
    OPTIONAL_TEXT("table", po_sweep, table, "the name of a CSV file"),
    OPTIONAL_LIST("together", po_sweep, together, SETTINGS, "a list of mappings of scene keys"),
    {0},
};

static const po_field LEAVE_OUT[] = {
    LIST("when", po_leave_out, when, AXIS, WHEN),
    TEXT("because", po_leave_out, because, "the reason why these points are not solved"),
    {0},
};

static const po_field MEASURE[] = {
    TEXT("quantity", po_check, quantity_text,
         "pull_off_force, pull_off_approach, contact_radius, fold_count, folds, extrema or curve"),
    TEXT("reference", po_check, reference, "bradley or the path of a CSV file"),
    OPTIONAL_LIST("when", po_check, when, AXIS, WHEN),
    {0},
};

const po_field PO_CASE_FIELDS[] = {
    TEXT("name", po_case_file, name, NAME),
    TEXT("title", po_case_file, title, "a line of text"),
    OPTIONAL_TEXT("figure", po_case_file, figure, "the number of a figure"),
    OPTIONAL_TEXT("equations", po_case_file, equations, "the numbers of equations"),
    OPTIONAL_TEXT("figure_script", po_case_file, figure_script, "the name of a script"),
    TEXTS("suites", po_case_file, suite_names, "a list of names of suites"),
    PART("scene", po_case_file, scene, SCENE, "a mapping of scene keys"),
    OPTIONAL_LIST("sweep", po_case_file, sweep, SWEEP, "a list of {key, values} or {together}"),
    OPTIONAL_LIST("leave_out", po_case_file, leave_out, LEAVE_OUT, "a list of {when, because}"),
    OPTIONAL_PART("sample", po_case_file, sample, SAMPLE, "a mapping of seed, count, keys"),
    OPTIONAL_TEXT("follow", po_case_file, follow,
                  "the last key of the sweep, whose value is a number"),
    OPTIONAL_TEXT("checkpoint_every", po_case_file, checkpoints_text,
                  "a whole number from 1 to 1000, beside follow"),
    OPTIONAL_PART("traced", po_case_file, traced, TRACED,
                  "a mapping of seed and count, beside follow"),
    OPTIONAL_TEXT("repeats", po_case_file, repeats_text, "a whole number from 1 to 1000"),
    TEXTS("want", po_case_file, want_names,
          "a list of pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, preload, "
          "theories, loop, history"),
    OPTIONAL_LIST("checks", po_case_file, checks, CHECK, "a list of checks"),
    OPTIONAL_LIST("lines", po_case_file, lines, LINE, "a list of {name, theory, sweep}"),
    OPTIONAL_LIST("measure", po_case_file, measure, MEASURE, "a list of {quantity, reference}"),
    {0},
};
