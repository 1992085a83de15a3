/* Scenes drawn at random: the generator against published outputs, the drawn values against another
 * implementation, and that a scene depends on nothing but seed, number and name. */
#include <check.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_case.h"
#include "po_file.h"
#include "po_input.h"
#include "po_random.h"
#include "po_range.h"
#include "po_text.h"
#include "run.h"

/* The first outputs of splitmix64 seeded with 1234567, as published for other languages. */
LOOP_TEST(mix_is_splitmix64, 0, 5) {
  static const uint64_t KNOWN[] = {UINT64_C(6457827717110365317), UINT64_C(3203168211198807973),
                                   UINT64_C(9817491932198370423), UINT64_C(4593380528125082431),
                                   UINT64_C(16408922859458223821)};
  const uint64_t step = UINT64_C(0x9e3779b97f4a7c15);
  ck_assert_uint_eq(po_random_mix(UINT64_C(1234567) + (uint64_t)_i * step), KNOWN[_i]);
}

/* Mean, variance, and the correlations of neighbouring scenes and of different keys, each within
 * five standard deviations of 10000 draws. */
TEST(draws_are_uniform_and_unrelated) {
  enum { COUNT = 10000 };
  double mean = 0, square = 0, neighbour = 0, other = 0;
  for (uint64_t i = 0; i < COUNT; ++i) {
    const double u = po_random_uniform(2385, i, "tabor");
    ck_assert(u > 0 && u < 1);
    mean += u / COUNT;
    square += (u - 0.5) * (u - 0.5) / COUNT;
    neighbour += (u - 0.5) * (po_random_uniform(2385, i + 1, "tabor") - 0.5) / COUNT;
    other += (u - 0.5) * (po_random_uniform(2385, i, "radius") - 0.5) / COUNT;
  }
  ck_assert_double_eq_tol(mean, 0.5, 5 * sqrt(1.0 / 12 / COUNT));
  ck_assert_double_eq_tol(square, 1.0 / 12, 5 * sqrt(1.0 / 180 / COUNT));
  ck_assert_double_eq_tol(neighbour, 0, 5.0 / 12 / sqrt(COUNT));
  ck_assert_double_eq_tol(other, 0, 5.0 / 12 / sqrt(COUNT));
}

/* Computed in Python from the description in doc/cases.md, for the ranges of
 * cases/random.yaml. */
static const struct {
  size_t number;
  const char *label;
} KNOWN[] = {{0, "tabor=0.565234 radius=152.189 wavelength=26.6656 amplitude=21.6577"},
             {1, "tabor=0.389001 radius=448.486 wavelength=28.4642 amplitude=27.9679"},
             {7, "tabor=0.404938 radius=107.931 wavelength=53.1856 amplitude=46.5894"},
             {199, "tabor=0.00108449 radius=52.0513 wavelength=12.2236 amplitude=10.43"},
             {999, "tabor=0.00416498 radius=113.855 wavelength=20.2887 amplitude=19.7204"}};

TEST(random_case_draws_what_another_program_draws) {
  po_case *kase = NULL;
  ck_assert_msg(po_case_read(SOURCE_ROOT "/cases/random.yaml", "random.yaml", &kase) == PO_OK, "%s",
                po_message());
  ck_assert_uint_eq(kase->point_count, 1000);
  for (size_t k = 0; k < sizeof KNOWN / sizeof *KNOWN; ++k)
    ck_assert_str_eq(kase->points[KNOWN[k].number].label, KNOWN[k].label);
  ck_assert_double_eq(kase->points[0].request.time_limit, 20);
  po_case_destroy(kase);
}

/* The drawn values equal those in the label and in the command that repeats the solve, to the last
 * bit. */
TEST(label_and_command_are_exact) {
  po_case *kase = NULL;
  ck_assert_int_eq(po_case_read(SOURCE_ROOT "/cases/random.yaml", "random.yaml", &kase), PO_OK);
  for (size_t i = 0; i < kase->point_count; i += 13) {
    const po_request *request = &kase->points[i].request;
    double tabor, radius, wavelength, amplitude;
    ck_assert_int_eq(sscanf(kase->points[i].label,
                            "tabor=%lf radius=%lf wavelength=%lf amplitude=%lf", &tabor, &radius,
                            &wavelength, &amplitude),
                     4);
    ck_assert(tabor == request->scene.tabor && radius == request->scene.radius);
    ck_assert(wavelength == request->scene.wavelength && amplitude == request->scene.amplitude);
    ck_assert(wavelength >= 0.39999 * sqrt(radius) && wavelength <= 6.00001 * sqrt(radius));
    ck_assert(amplitude <= 1.00001 * wavelength);
    po_text command = {0};
    po_input_add_command(request, &command);
    double again[4];
    ck_assert_int_eq(sscanf(command.data,
                            "pulloff solve --tabor %lf --amplitude %lf --wavelength %lf --radius "
                            "%lf --outer-radius inf --scheme panel --tolerance 0.0001 --time-limit "
                            "20",
                            &again[0], &again[1], &again[2], &again[3]),
                     4);
    ck_assert(again[0] == tabor && again[1] == amplitude && again[2] == wavelength &&
              again[3] == radius);
    po_text_clear(&command);
  }
  po_case_destroy(kase);
}

/* A table of r^2/200 plus a wave of the given amplitude and length 20, read into a request. */
static void set_table(po_request *request, double amplitude) {
  char path[] = "/tmp/pulloff-test-XXXXXX";
  const int file = mkstemp(path);
  ck_assert_int_ge(file, 0);
  close(file);
  po_text rows = {0};
  po_text_add(&rows, "r,gap\n");
  for (int k = 0; k <= 200; ++k) {
    const double r = 0.2 * k;
    po_text_add(&rows, "%.17g,%.17g\n", r, r * r / 200 + amplitude * (1 - cos(M_PI * r / 10)));
  }
  ck_assert_int_eq(po_file_write(path, rows.data, rows.length), PO_OK);
  po_text_clear(&rows);
  ck_assert(po_key_set(request, PO_KEY_PROFILE_FILE, path));
  unlink(path);
}

/* A single solve of a scene whose load may have several minima searches beyond the default preload.
 * The command that repeats a point states that preload: for waves, and for a table that contains
 * some. */
LOOP_TEST(the_command_states_the_preload_if_the_load_may_have_several_minima, 0, 4) {
  static const char *const WAVES[] = {"-", "0.5@20", "-", "-"};
  static const double IN_TABLE[] = {-1, -1, 0, 0.5}; /* negative: a sphere */
  po_request request = po_input_default();
  ck_assert(po_key_set(&request, PO_KEY_WAVES, WAVES[_i]));
  if (IN_TABLE[_i] >= 0)
    set_table(&request, IN_TABLE[_i]);
  request.scene.tabor = po_scene_tabor_of_coupling(0.05, request.scene.radius);
  po_text command = {0};
  po_input_add_command(&request, &command);
  const char *stated = strstr(command.data, " --preload-load ");
  ck_assert_int_eq(stated != NULL, _i % 2);
  /* a profile that is no sphere is pressed to half the pull-off force of JKR or so, in pi w eps */
  const double load = stated ? strtod(stated + strlen(" --preload-load "), NULL) : 0.0;
  ck_assert_double_ge(load, _i == 3 ? 50.0 : _i == 1);
  ck_assert_double_le(load, _i == 3 ? 500.0 : 1.0);
  po_text_clear(&command);
}

static po_case *case_of(const char *sample) {
  static const char HEAD[] = "name: made\ntitle: Made up\nsuites: [random]\nwant: [pull_off]\n"
                             "scene: {outer_radius: inf, scheme: panel}\n";
  char path[] = "/tmp/pulloff-test-XXXXXX", text[600];
  snprintf(text, sizeof text, "%s%s", HEAD, sample);
  const int file = mkstemp(path);
  ck_assert_int_ge(file, 0);
  close(file);
  ck_assert_int_eq(po_file_write(path, text, strlen(text)), PO_OK);
  po_case *kase = NULL;
  ck_assert_msg(po_case_read(path, "made.yaml", &kase) == PO_OK, "%s", po_message());
  unlink(path);
  return kase;
}

#define TABOR "{key: tabor, from: 0.01, to: 2.385, scale: log}"
#define RADIUS "{key: radius, from: 30, to: 500}"

LOOP_TEST(a_scene_does_not_depend_on_the_others, 0, 3) {
  static const char *const OTHERS[] = {
      "sample: {seed: 7, count: 50, keys: [" TABOR ", " RADIUS "]}",
      "sample: {seed: 7, count: 12, keys: [" RADIUS ", " TABOR "]}",
      "sample: {seed: 7, count: 12, keys: [" TABOR ", " RADIUS
      ", {key: wavelength, from: 1, to: 2}, {key: amplitude, from: 1, to: 2, times: tabor}]}"};
  po_case *one = case_of("sample: {seed: 7, count: 12, keys: [" TABOR ", " RADIUS "]}");
  po_case *other = case_of(OTHERS[_i]);
  for (size_t i = 0; i < one->point_count; ++i) {
    ck_assert(one->points[i].request.scene.tabor == other->points[i].request.scene.tabor);
    ck_assert(one->points[i].request.scene.radius == other->points[i].request.scene.radius);
  }
  po_case_destroy(one);
  po_case_destroy(other);
}

TEST(another_seed_draws_other_scenes) {
  po_case *one = case_of("sample: {seed: 7, count: 12, keys: [" TABOR ", " RADIUS "]}");
  po_case *other = case_of("sample: {seed: 8, count: 12, keys: [" TABOR ", " RADIUS "]}");
  for (size_t i = 0; i < one->point_count; ++i)
    ck_assert(one->points[i].request.scene.tabor != other->points[i].request.scene.tabor);
  po_case_destroy(one);
  po_case_destroy(other);
}

/* Each drawn scene is combined with every combination of the sweep; a unit may be swept. */
TEST(sample_times_sweep) {
  po_case *kase = case_of("sweep: [{key: tabor, values: [1, 2.385]}]\n"
                          "sample: {seed: 7, count: 3, keys: [" RADIUS
                          ", {key: wavelength, from: 1, to: 2, times: tabor},"
                          " {key: amplitude, from: 0, to: 1}]}");
  ck_assert_uint_eq(kase->point_count, 6);
  for (size_t i = 0; i < 6; ++i) {
    const po_scene *scene = &kase->points[i].request.scene;
    ck_assert_double_eq(scene->tabor, i % 2 ? 2.385 : 1);
    ck_assert(scene->radius == kase->points[i / 2 * 2].request.scene.radius);
    ck_assert_double_eq_tol(scene->wavelength / scene->tabor,
                            kase->points[i / 2 * 2].request.scene.wavelength, 1e-5);
  }
  po_case_destroy(kase);
}

/* Both ends are exact; between them equal steps or equal factors, rounded to 6 digits. */
TEST(ranges_have_their_ends_and_equal_steps) {
  static const char *const VALUES[2][4] = {{"1", "334", "667", "1000"}, {"1", "10", "100", "1000"}};
  bool log = false;
  char text[PO_NUMBER_LENGTH];
  for (int scale = 0; scale < 2; ++scale)
    for (size_t k = 0; k < 4; ++k) {
      po_range_print(&(po_range){1, 1000, 4, scale == 1}, k, text);
      ck_assert_str_eq(text, VALUES[scale][k]);
    }
  po_range_print(&(po_range){0.1, 7, 3, true}, 1, text);
  ck_assert_str_eq(text, "0.83666"); /* sqrt(0.7) = 0.836660027 */
  ck_assert(po_range_read_scale("log", &log) && log);
  ck_assert(po_range_read_scale("linear", &log) && !log);
  ck_assert(!po_range_read_scale("logarithmic", &log));
}
