/* The functions of the library, through the public header. */
#include <fenv.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>

#include "../unit/run.h"
#include "use.h"

static pulloff_message message;
static pulloff_scene *scene;
static pulloff_result *result;

static void begin(void) {
  ck_assert_int_eq(pulloff_scene_create(&scene, &message), PULLOFF_OK);
  result = NULL;
}

static void end(void) {
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
}

static void expect_value(const char *key, const char *expected) {
  char text[64];
  ck_assert_int_eq(pulloff_scene_get(scene, key, text, sizeof text, &message), PULLOFF_OK);
  ck_assert_str_eq(text, expected);
}

TEST(keys_have_names_and_defaults) {
  ck_assert_uint_gt(pulloff_key_count(), 20);
  for (size_t k = 0; k < pulloff_key_count(); ++k) {
    ck_assert_ptr_nonnull(pulloff_key_name(k));
    ck_assert_ptr_nonnull(pulloff_key_expected(k));
    ck_assert_str_ne(pulloff_key_help(k), "");
    if (strcmp(pulloff_key_name(k), "mie_m") == 0) /* one text for both exponents */
      ck_assert_ptr_nonnull(strstr(pulloff_key_help(k), "exponents M and N"));
  }
  ck_assert_ptr_null(pulloff_key_help(pulloff_key_count()));
  ck_assert_ptr_null(pulloff_key_name(pulloff_key_count()));
  ck_assert_ptr_null(pulloff_key_expected(pulloff_key_count()));
  expect_value("tabor", "1");
  expect_value("outer_radius", "inf");
  expect_value("law", "lennard-jones");
  expect_value("approach_end", "auto");
  expect_value("time_limit", "none");
  expect_value("want", "");
  expect_value("profile_approach", "auto");
}

TEST(values_are_set_and_unset) {
  ck_assert_int_eq(pulloff_scene_set_number(scene, "tabor", 0.1 + 0.2, &message), PULLOFF_OK);
  ck_assert_str_eq(message.text, "");
  expect_value("tabor", "0.30000000000000004");
  ck_assert_int_eq(pulloff_scene_set_number(scene, "outer_radius", INFINITY, NULL), PULLOFF_OK);
  ck_assert_int_eq(
      set_words(scene, "amplitude_ratio 0.1 wavelength 20 want profile,curve", &message),
      PULLOFF_OK);
  expect_value("amplitude", "2");
  expect_value("want", "curve,profile");
  pulloff_scene *copy;
  ck_assert_int_eq(pulloff_scene_copy(scene, &copy, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_scene_set(scene, "amplitude_ratio", NULL, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_scene_set(scene, "want", NULL, &message), PULLOFF_OK);
  expect_value("amplitude", "0");
  expect_value("want", "");
  pulloff_scene_destroy(scene);
  scene = copy;
  expect_value("amplitude", "2");
  ck_assert_int_eq(pulloff_scene_set(scene, "amplitude_ratio", NULL, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_scene_set(scene, "wavelength", NULL, &message), PULLOFF_OK);
  ck_assert_int_eq(set_words(scene, "waves 0.5@20;0.2@9 profile cone:0.2", &message), PULLOFF_OK);
  expect_value("waves", "0.5@20;0.2@9");
  expect_value("profile", "cone");
  expect_value("cone_t", "0.2");
  char text[4] = "xyz";
  ck_assert_int_eq(pulloff_scene_get(scene, "law", text, sizeof text, &message), PULLOFF_OK);
  ck_assert_str_eq(text, "len");
}

TEST(wrong_values_are_refused) {
  const struct {
    const char *key, *value, *message;
  } wrong[] = {
      {"tabor", "-1", "tabor is -1: expected a finite number >= 0"},
      {"tabor", "0,5",
       "tabor is 0,5: expected a finite number >= 0; it has a comma in place of a decimal point"},
      {"scheme", "square", "scheme is square: expected ring, triangle or panel"},
      {"taber", "1",
       "unknown key taber of a scene: expected one that pulloff_key_name names; did you mean "
       "tabor?"},
      {"want", "curve,work",
       "want is curve,work: expected any of curve, profile, hysteresis, diagnostics, preload, "
       "theories, loop, history, with "
       "commas between"},
      {"profile_approach", "inf", "profile_approach is inf: expected a finite number"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    ck_assert_int_eq(pulloff_scene_set(scene, wrong[i].key, wrong[i].value, &message),
                     PULLOFF_BAD_INPUT);
    ck_assert_str_eq(message.text, wrong[i].message);
    ck_assert_int_eq(pulloff_scene_set(scene, wrong[i].key, wrong[i].value, NULL),
                     PULLOFF_BAD_INPUT);
  }
  ck_assert_int_eq(pulloff_scene_set_number(scene, "tabor", NAN, &message), PULLOFF_BAD_INPUT);
  ck_assert_str_eq(message.text, "tabor is nan: expected a finite number >= 0");
  expect_value("tabor", "1");
  ck_assert_int_eq(pulloff_scene_set(scene, "profile_file", "nowhere.csv", &message),
                   PULLOFF_CANNOT_READ);
  ck_assert_ptr_nonnull(strstr(message.text, "nowhere.csv"));
}

#define TIP "modulus_pa 2e9 work_j_per_m2 0.05 distance_m 3e-10 radius_m 1e-7 "

/* Keys that do not agree are refused when the scene is solved. Dimensionless preloads of a scene in
 * SI units were taken in epsilon, where the command line refuses them. */
TEST(wrong_scenes_are_refused) {
  const struct {
    const char *words, *message;
  } wrong[] = {
      {"nodes 101", "nodes is 101: expected it with the scheme ring or triangle, not panel"},
      {"mie_m 4", "mie_m is 4: expected it with the law mie, not lennard-jones"},
      {"power_n 2", "power_n is 2: expected it with the profile power, not sphere"},
      {"tabor 1 coupling 0.1", "coupling is 0.1: expected only one of tabor and coupling"},
      {"approach_start 3 approach_end 2",
       "approach_end is 2: expected more than approach_start, 3"},
      {TIP "preload 1", "preload is 1: expected preload_m, as the scene is in SI units"},
      {TIP "preload_load 1",
       "preload_load is 1: expected preload_load_n, as the scene is in SI units"},
      {TIP "stiffness 1",
       "stiffness is 1: expected stiffness_n_per_m, as the scene is in SI units"},
      {TIP "approach_end 1",
       "approach_end is 1: expected approach_end_m, as the scene is in SI units"},
      {TIP "profile_approach 1",
       "profile_approach is 1: expected profile_approach_m, as the scene is in SI units"},
      {TIP "profile_load 1",
       "profile_load is 1: expected profile_load_n, as the scene is in SI units"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    ck_assert_int_eq(solve_words(wrong[i].words, &result, &message), PULLOFF_BAD_INPUT);
    ck_assert_ptr_null(result);
    ck_assert_str_eq(message.text, wrong[i].message);
  }
  ck_assert_int_eq(solve_words("amplitude 1", &result, &message), PULLOFF_BAD_INPUT);
  ck_assert_ptr_null(result);
}

TEST(a_result_has_its_parts) {
  ck_assert_int_eq(solve_words("tabor 3 amplitude 1 wavelength 20 want curve,profile,hysteresis",
                               &result, &message),
                   PULLOFF_OK);
  ck_assert_int_eq(pulloff_result_status(result), PULLOFF_OK);
  ck_assert_str_eq(pulloff_result_reason(result), "");
  pulloff_pull_off p;
  ck_assert(pulloff_result_pull_off(result, &p));
  ck_assert_double_eq_tol(p.force, 2.65119276, 1e-7);
  ck_assert_double_lt(p.force_error, 1e-5);
  double force = 0;
  ck_assert_int_eq(pulloff_result_number(result, "pull_off.force", &force, &message), PULLOFF_OK);
  ck_assert(force == p.force);
  size_t folds, extrema, points, radii, jumps, count;
  const pulloff_special_point *fold = pulloff_result_folds(result, &folds);
  ck_assert_uint_ge(folds, 2);
  ck_assert_int_eq(fold[0].kind, PULLOFF_JUMP_IN);
  ck_assert_int_eq(fold[1].kind, PULLOFF_JUMP_OUT);
  const pulloff_special_point *extremum = pulloff_result_extrema(result, &extrema);
  ck_assert_uint_ge(extrema, 2);
  ck_assert(extremum[0].kind == PULLOFF_MINIMUM || extremum[0].kind == PULLOFF_MAXIMUM);
  const pulloff_curve_point *curve = pulloff_result_curve(result, &points);
  ck_assert_uint_gt(points, 50);
  ck_assert_int_eq(pulloff_result_count(result, "curve", &count, &message), PULLOFF_OK);
  ck_assert_uint_eq(count, points);
  double *load = calloc(points, sizeof *load);
  ck_assert_int_eq(pulloff_result_column(result, "curve", "load", load, points, &message),
                   PULLOFF_OK);
  for (size_t i = 0; i < points; ++i)
    ck_assert(load[i] == curve[i].load);
  ck_assert_int_eq(pulloff_result_column(result, "curve", "load", load, points - 1, &message),
                   PULLOFF_NOT_FOUND);
  ck_assert_int_eq(pulloff_result_column(result, "curve", "weight", load, points, &message),
                   PULLOFF_NOT_FOUND);
  free(load);
  const pulloff_profile_point *profile = pulloff_result_profile(result, &radii);
  ck_assert_uint_gt(radii, 20);
  ck_assert_double_gt(profile[radii - 1].radius, profile[0].radius);
  ck_assert_int_eq(
      pulloff_result_count(result, "hysteresis.displacement_control.jumps", &jumps, &message),
      PULLOFF_OK);
  ck_assert_uint_ge(jumps, 2);
}

TEST(values_are_found_by_their_path) {
  ck_assert_int_eq(solve_words("tabor 1", &result, &message), PULLOFF_OK);
  double value = 0;
  const char *text = NULL;
  size_t count = 7;
  ck_assert_int_eq(pulloff_result_text(result, "input.scheme", &text, &message), PULLOFF_OK);
  ck_assert_str_eq(text, "panel");
  ck_assert_int_eq(pulloff_result_number(result, "input.outer_radius", &value, &message),
                   PULLOFF_OK);
  ck_assert(isinf(value));
  ck_assert_int_eq(pulloff_result_number(result, "input.approach_end", &value, &message),
                   PULLOFF_OK);
  ck_assert(isnan(value));
  ck_assert_int_eq(pulloff_result_number(result, "folds.1.load", &value, &message), PULLOFF_OK);
  ck_assert_double_eq_tol(value, -1.0324330652, 1e-6);
  static const char *const WRONG[] = {
      "folds.2.load", "folds.x.load",     "folds.-1", "folds", "", ".",
      "pull_off.",    "pull_off.force.0", "status",   "curve"};
  for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; ++i) {
    ck_assert_int_eq(pulloff_result_number(result, WRONG[i], &value, &message), PULLOFF_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(message.text, "the result has no number"));
  }
  ck_assert_int_eq(pulloff_result_text(result, "pull_off.force", &text, NULL), PULLOFF_NOT_FOUND);
  ck_assert_int_eq(pulloff_result_count(result, "status", &count, NULL), PULLOFF_NOT_FOUND);
  ck_assert_uint_eq(count, 7);
  ck_assert_ptr_null(pulloff_result_curve(result, &count));
  ck_assert_uint_eq(count, 0);
}

TEST(a_solve_that_ends_early_has_a_result) {
  ck_assert_int_eq(solve_words("tabor 5 amplitude 2 wavelength 9 time_limit 1e-6 preload_load 1",
                               &result, &message),
                   PULLOFF_OUT_OF_TIME);
  ck_assert_ptr_nonnull(result);
  ck_assert_int_eq(pulloff_result_status(result), PULLOFF_OUT_OF_TIME);
  ck_assert_ptr_nonnull(strstr(message.text, pulloff_result_reason(result)));
  pulloff_result_destroy(result);
  static volatile sig_atomic_t stop = 1;
  pulloff_scene_set_stop(scene, &stop);
  ck_assert_int_eq(pulloff_solve(scene, &result, &message), PULLOFF_INTERRUPTED);
  ck_assert_int_eq(pulloff_result_status(result), PULLOFF_INTERRUPTED);
  pulloff_pull_off p;
  ck_assert(!pulloff_result_pull_off(result, &p));
}

TEST(a_series_is_followed) {
  enum { COUNT = 5 };
  const double values[COUNT] = {1, 1.1, 1.2, 1.3, 1.4};
  pulloff_result *results[COUNT];
  volatile sig_atomic_t seen = 0, stop = 1;
  pulloff_scene_set_seen(scene, &seen);
  ck_assert_int_eq(pulloff_follow(scene, "tabor", values, COUNT, results, &message), PULLOFF_OK);
  ck_assert_int_eq(seen, COUNT);
  for (size_t k = 0; k < COUNT; ++k) {
    double tabor = 0;
    pulloff_pull_off p, alone;
    ck_assert_int_eq(pulloff_result_number(results[k], "input.tabor", &tabor, NULL), PULLOFF_OK);
    ck_assert(tabor == values[k]);
    ck_assert(pulloff_result_pull_off(results[k], &p));
    pulloff_scene_set_number(scene, "tabor", values[k], NULL);
    ck_assert_int_eq(pulloff_solve(scene, &result, &message), PULLOFF_OK);
    ck_assert(pulloff_result_pull_off(result, &alone));
    ck_assert_double_le(fabs(p.force - alone.force), p.force_error + alone.force_error);
    pulloff_result_destroy(result);
    pulloff_result_destroy(results[k]);
  }
  result = NULL;
  pulloff_scene_set(scene, "tabor", NULL, NULL);
  pulloff_scene_set_stop(scene, &stop);
  ck_assert_int_eq(pulloff_follow(scene, "tabor", values, COUNT, results, &message),
                   PULLOFF_INTERRUPTED);
  for (size_t k = 0; k < COUNT; ++k)
    ck_assert_ptr_null(results[k]);
  pulloff_scene_set_stop(scene, NULL);
  pulloff_scene_set_seen(scene, NULL);
  ck_assert_int_eq(pulloff_follow(scene, "law", values, COUNT, results, &message),
                   PULLOFF_BAD_INPUT);
  ck_assert_ptr_null(results[COUNT - 1]);
  ck_assert_int_eq(pulloff_follow(scene, "tabor", values, 0, results, &message), PULLOFF_BAD_INPUT);
  const double bad[2] = {1, -1};
  ck_assert_int_eq(pulloff_follow(scene, "tabor", bad, 2, results, &message), PULLOFF_BAD_INPUT);
  ck_assert_str_eq(message.text, "tabor is -1: expected a finite number >= 0");
}

TEST(closed_forms_are_evaluated_in_a_state) {
  const double none = NAN;
  double value = 0;
  ck_assert_int_eq(pulloff_theory_at("jkr", scene, none, "approach", 0, &result, &message),
                   PULLOFF_OK);
  ck_assert_int_eq(pulloff_result_number(result, "load", &value, NULL), PULLOFF_OK);
  ck_assert_double_eq_tol(value, -4.0 / 3.0, 1e-13);
  const struct {
    const char *variable;
    double at;
    const char *message;
  } wrong[] = {
      {"tabor", 1, "the variable of a closed form is tabor: expected load, approach or "},
      {"", 1, "the variable of a closed form is "},
      {"load", NAN, "load is nan: expected a finite number"},
      {"load", -2, "the JKR theory has no stable state at load -2: the lowest of all states is "},
      {"load_n", 0, "modulus_pa is missing: expected "},
      {"contact_radius", -1, "contact_radius is -1: expected a finite number >= 0"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    pulloff_result *other;
    ck_assert_int_eq(
        pulloff_theory_at("jkr", scene, none, wrong[i].variable, wrong[i].at, &other, &message),
        PULLOFF_BAD_INPUT);
    ck_assert_ptr_null(other);
    ck_assert_msg(strncmp(message.text, wrong[i].message, strlen(wrong[i].message)) == 0, "%s",
                  message.text);
  }
}

TEST(closed_forms_are_evaluated) {
  const double none = NAN;
  double value = 0;
  ck_assert_int_eq(pulloff_theory("jkr", scene, none, none, &result, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_result_number(result, "pull_off_force", &value, NULL), PULLOFF_OK);
  ck_assert_double_eq_tol(value, 1.5, 1e-15);
  pulloff_result_destroy(result);
  ck_assert_int_eq(pulloff_theory("bradley", scene, none, -1, &result, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_result_number(result, "load", &value, NULL), PULLOFF_OK);
  const struct {
    const char *form, *words;
    double alpha, at;
    const char *message;
  } wrong[] = {
      {"nobody", "", none, none, "no closed form is named nobody: expected "},
      {"bradley", "", none, 1, "approach of theory bradley is 1: expected a finite number < 1"},
      {"crest", "amplitude 0", none, 3, "the variable of theory crest is 3: expected none"},
      {"guduru", "amplitude 0 tabor 0", none, none, "tabor is 0: expected a finite number > 0"},
      {"rigid", "amplitude 0", -2, none, "alpha is -2: expected a finite number > 0"},
      /* a key without effect used to be ignored, where the command line refuses the option */
      {"bradley", "tabor 1", none, none,
       "tabor has no effect on theory bradley: expected only approach"},
      {"dmt", "amplitude 1 wavelength 20", none, none,
       "amplitude has no effect on theory dmt: expected only tabor, coupling, radius, load, "
       "approach or contact_radius"},
      {"rigid", "amplitude 1 wavelength 20", 0.3, none,
       "wavelength has no effect on theory rigid with alpha: expected only amplitude, alpha or "
       "approach"},
      {"guduru", "amplitude 1 wavelength 20 profile cone:0.3", none, none,
       "profile has no effect on theory guduru: expected only tabor, coupling, amplitude, "
       "wavelength, radius, preload, preload_load, load, approach or contact_radius"},
      {"jkr", "want profile", none, none, "want has no effect on theory jkr: expected only "},
      {"jkr",
       "profile_approach_m 1e-9 work_j_per_m2 0.05 distance_m 3e-10 modulus_pa 1e9 radius_m 1e-7",
       none, none, "profile_approach_m has no effect on theory jkr: expected only "},
      {"jkr", "outer_radius 30", none, none, "outer_radius has no effect on theory jkr: "},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    pulloff_result *other;
    for (size_t k = 0; k < pulloff_key_count(); ++k)
      ck_assert_int_eq(pulloff_scene_set(scene, pulloff_key_name(k), NULL, NULL), PULLOFF_OK);
    ck_assert_int_eq(set_words(scene, wrong[i].words, &message), PULLOFF_OK);
    ck_assert_int_eq(
        pulloff_theory(wrong[i].form, scene, wrong[i].alpha, wrong[i].at, &other, &message),
        PULLOFF_BAD_INPUT);
    ck_assert_ptr_null(other);
    ck_assert_msg(strncmp(message.text, wrong[i].message, strlen(wrong[i].message)) == 0, "%s",
                  message.text);
  }
  pulloff_scene_set(scene, "outer_radius", NULL, NULL);
  pulloff_result *other;
  ck_assert_int_eq(pulloff_theory("guduru", scene, none, none, &other, &message),
                   PULLOFF_BAD_INPUT);
  ck_assert_str_eq(message.text, "theory guduru needs the key amplitude");
  /* keys that SI units set are no such keys */
  const pulloff_physical tip = {
      .modulus = 2e9, .work = 0.05, .distance = 3e-10, .radius = 1e-7, .outer_radius = INFINITY};
  ck_assert_int_eq(pulloff_scene_set_physical(scene, &tip, NULL, &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_theory("bradley", scene, none, none, &other, &message), PULLOFF_OK);
  pulloff_result_destroy(other);
}

TEST(scenes_in_si_units) {
  const pulloff_physical tip = {
      .modulus = 2e9, .work = 0.05, .distance = 3e-10, .radius = 1e-7, .outer_radius = INFINITY};
  pulloff_units units;
  ck_assert_int_eq(pulloff_scene_set(scene, "wavelength", "20", &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_scene_set_physical(scene, &tip, &units, &message), PULLOFF_OK);
  ck_assert_double_eq_tol(units.length, 3e-10, 1e-24);
  ck_assert_double_eq_tol(units.force, M_PI * 0.05 * 1e-7, 1e-22);
  ck_assert_double_eq_tol(units.work, 0.05, 1e-17);
  char text[40];
  ck_assert_int_eq(pulloff_scene_get(scene, "tabor", text, sizeof text, &message), PULLOFF_OK);
  ck_assert_double_eq_tol(strtod(text, NULL), cbrt(1e-7 * 0.0025 / (4e18 * 2.7e-29)), 1e-13);
  ck_assert_double_gt(units.traction, 0);
  pulloff_physical wrong = tip;
  wrong.work = -1;
  ck_assert_int_eq(pulloff_scene_set_physical(scene, &wrong, NULL, &message), PULLOFF_BAD_INPUT);
  ck_assert_str_ne(message.text, "");
  /* the same scene by its keys, beside a preload and a spring */
  pulloff_scene *same;
  double number = 0;
  ck_assert_int_eq(pulloff_scene_create(&same, &message), PULLOFF_OK);
  const char *const keys[][2] = {{"modulus_pa", "2e9"},      {"work_j_per_m2", "0.05"},
                                 {"distance_m", "3e-10"},    {"radius_m", "1e-7"},
                                 {"preload_load_n", "3e-9"}, {"stiffness_n_per_m", "2"}};
  for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i)
    ck_assert_int_eq(pulloff_scene_set(same, keys[i][0], keys[i][1], &message), PULLOFF_OK);
  char other[40];
  ck_assert_int_eq(pulloff_scene_get(same, "tabor", other, sizeof other, &message), PULLOFF_OK);
  ck_assert_str_eq(other, text);
  ck_assert_int_eq(pulloff_scene_get(same, "preload_load", other, sizeof other, &message),
                   PULLOFF_OK);
  number = strtod(other, NULL);
  ck_assert_double_eq_tol(number * units.force, 3e-9, 1e-23);
  ck_assert_int_eq(pulloff_scene_get(same, "stiffness_n_per_m", other, sizeof other, &message),
                   PULLOFF_OK);
  ck_assert_str_eq(other, "2");
  ck_assert_int_eq(pulloff_scene_set(same, "preload_load", "1", &message), PULLOFF_OK);
  ck_assert_int_eq(pulloff_solve(same, &result, &message), PULLOFF_BAD_INPUT);
  ck_assert_str_eq(message.text,
                   "preload_load_n is 3e-9: expected only one of preload_load and preload_load_n");
  ck_assert_int_eq(pulloff_scene_set(same, "preload_load_n", "x", &message), PULLOFF_BAD_INPUT);
  ck_assert_str_eq(message.text, "preload_load_n is x: expected a finite number >= 0");
  pulloff_scene_destroy(same);
  wrong = tip;
  wrong.modulus = INFINITY;
  ck_assert_int_eq(pulloff_scene_set_physical(scene, &wrong, NULL, &message), PULLOFF_OK);
  expect_value("tabor", "0");
}

/* The state of the calling thread is that of the program during a call, and its own afterwards. */
TEST(the_thread_keeps_its_state) {
  pulloff_pull_off usual, changed;
  ck_assert_int_eq(solve_words("tabor 1 preload_load 1", &result, &message), PULLOFF_OK);
  ck_assert(pulloff_result_pull_off(result, &usual));
  pulloff_result_destroy(result);
  const locale_t other = newlocale(LC_ALL_MASK, "de_DE.UTF-8", (locale_t)0);
  if (other)
    uselocale(other);
  fesetround(FE_UPWARD);
  ck_assert_int_eq(solve_words("tabor 1 preload_load 1", &result, &message), PULLOFF_OK);
  ck_assert_int_eq(fegetround(), FE_UPWARD);
  fesetround(FE_TONEAREST);
  if (other) {
    ck_assert_ptr_eq(uselocale(LC_GLOBAL_LOCALE), other);
    freelocale(other);
  }
  ck_assert(pulloff_result_pull_off(result, &changed));
  ck_assert(changed.force == usual.force && changed.approach == usual.approach);
}

TEST(statuses_have_texts) {
  ck_assert_str_eq(pulloff_version(), PULLOFF_VERSION);
  ck_assert_str_eq(pulloff_status_text(PULLOFF_OK), "ok");
  ck_assert_str_eq(pulloff_status_text(PULLOFF_CANNOT_READ), "a file could not be read");
  ck_assert_str_eq(pulloff_status_text((pulloff_status)77), "unknown status");
}

FIXTURE(begin, end)
