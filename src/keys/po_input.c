#include "po_input.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_companion_jkr.h"
#include "po_load_unit.h"
#include "po_text.h"

typedef enum {
  ANY_NUMBER,
  NOT_NEGATIVE,
  POSITIVE,
  POSITIVE_OR_INFINITE,
  FINITE_OR_INFINITE,
  COUNT,
  NAME
} value_type;

static const struct {
  const char *name;
  value_type type;
  const char *expected;
} KEYS[PO_KEY_END] = {
    [PO_KEY_TABOR] = {"tabor", NOT_NEGATIVE, "a finite number >= 0"},
    [PO_KEY_AMPLITUDE] = {"amplitude", NOT_NEGATIVE, "a finite number >= 0"},
    [PO_KEY_WAVELENGTH] = {"wavelength", POSITIVE, "a finite number > 0"},
    [PO_KEY_RADIUS] = {"radius", POSITIVE, "a finite number > 0"},
    [PO_KEY_OUTER_RADIUS] = {"outer_radius", POSITIVE_OR_INFINITE, "a finite number > 0, or inf"},
    [PO_KEY_LAW] = {"law", NAME, PO_LAW_EXPECTED},
    [PO_KEY_MIE_M] = {"mie_m", POSITIVE, "a finite number > 1"},
    [PO_KEY_MIE_N] = {"mie_n", POSITIVE, "a finite number > mie_m"},
    [PO_KEY_MORSE_A] = {"morse_a", POSITIVE, "a finite number > 0"},
    [PO_KEY_PROFILE] = {"profile", NAME, PO_PROFILE_EXPECTED},
    [PO_KEY_POWER_C] = {"power_c", POSITIVE, "a finite number > 0"},
    [PO_KEY_POWER_N] = {"power_n", POSITIVE, "a number from 1 to 40"},
    [PO_KEY_CONE_T] = {"cone_t", POSITIVE, "a finite number > 0"},
    [PO_KEY_PUNCH_B] = {"punch_b", POSITIVE, "a finite number > 0"},
    [PO_KEY_PUNCH_R] = {"punch_r", POSITIVE, "a finite number > 0"},
    [PO_KEY_TRUNCATED_B] = {"truncated_b", POSITIVE, "a finite number > 0"},
    [PO_KEY_TRUNCATED_R] = {"truncated_r", POSITIVE, "a finite number > 0"},
    [PO_KEY_TABLE_SCALE] = {"table_scale", POSITIVE, "a finite number > 0"},
    [PO_KEY_PROFILE_FILE] = {"profile_file", NAME, "a CSV file with the columns r and gap"},
    [PO_KEY_WAVES] = {"waves", NAME,
                      "A@L;A@L;..., amplitude and wavelength of at most 8 waves, all > 0, or -"},
    [PO_KEY_SCHEME] = {"scheme", NAME, "ring, triangle or panel"},
    [PO_KEY_GRADING] = {"grading", NAME, "uniform or graded"},
    [PO_KEY_NODES] = {"nodes", COUNT, "a whole number > 0"},
    [PO_KEY_TOLERANCE] = {"tolerance", POSITIVE, "a finite number > 0"},
    [PO_KEY_APPROACH_START] = {"approach_start", ANY_NUMBER, "a finite number"},
    [PO_KEY_APPROACH_END] = {"approach_end", ANY_NUMBER, "a finite number"},
    [PO_KEY_PRELOAD] = {"preload", FINITE_OR_INFINITE, "a finite number, or inf"},
    [PO_KEY_PRELOAD_LOAD] = {"preload_load", NOT_NEGATIVE, "a finite number >= 0"},
    [PO_KEY_TIME_LIMIT] = {"time_limit", POSITIVE, "a finite number > 0"},
    [PO_KEY_ALPHA] = {"alpha", POSITIVE, "a finite number > 0"},
    [PO_KEY_AMPLITUDE_RATIO] = {"amplitude_ratio", NOT_NEGATIVE, "a finite number >= 0"},
    [PO_KEY_OUTER_RATIO] = {"outer_ratio", POSITIVE, "a finite number > 0"},
    [PO_KEY_COUPLING] = {"coupling", NOT_NEGATIVE, "a finite number >= 0"},
};

po_request po_input_default(void) {
  po_request request = po_request_default();
  request.companion = &PO_COMPANION_JKR;
  return request;
}

int po_key_of_name(const char *name) {
  for (int key = 0; key < PO_KEY_END; ++key)
    if (strcmp(KEYS[key].name, name) == 0)
      return key;
  return -1;
}

const char *po_key_name(po_key key) {
  return KEYS[key].name;
}

const char *po_key_expected(po_key key) {
  return KEYS[key].expected;
}

bool po_key_is_number(po_key key) {
  return KEYS[key].type != NAME;
}

bool po_key_is_group(int key) {
  return key >= PO_KEY_COUNT;
}

static bool is_of_law(int key) {
  return key >= PO_KEY_MIE_M && key <= PO_KEY_MORSE_A;
}

static bool is_of_profile(int key) {
  return key >= PO_KEY_POWER_C && key <= PO_KEY_TABLE_SCALE;
}

bool po_key_is_continuous(int key) {
  return (key >= PO_KEY_TABOR && key <= PO_KEY_OUTER_RADIUS) || is_of_law(key) ||
         (is_of_profile(key) && key != PO_KEY_TABLE_SCALE) || po_key_is_group(key);
}

po_key po_key_target(po_key key) {
  switch (key) {
  case PO_KEY_ALPHA:
    return PO_KEY_WAVELENGTH;
  case PO_KEY_OUTER_RATIO:
    return PO_KEY_OUTER_RADIUS;
  case PO_KEY_AMPLITUDE_RATIO:
  case PO_KEY_WAVES:
    return PO_KEY_AMPLITUDE;
  case PO_KEY_COUPLING:
    return PO_KEY_TABOR;
  case PO_KEY_PROFILE_FILE:
    return PO_KEY_PROFILE;
  default:
    return key;
  }
}

/* Returned: the place of the value of a key in a request; NULL for names and counts. */
static double *key_place(po_request *request, po_key key) {
  switch (key) {
  case PO_KEY_TABOR:
    return &request->scene.tabor;
  case PO_KEY_AMPLITUDE:
    return &request->scene.amplitude;
  case PO_KEY_WAVELENGTH:
    return &request->scene.wavelength;
  case PO_KEY_RADIUS:
    return &request->scene.radius;
  case PO_KEY_OUTER_RADIUS:
    return &request->scene.outer_radius;
  case PO_KEY_MIE_M:
  case PO_KEY_MIE_N:
  case PO_KEY_MORSE_A:
    return &request->scene.law.parameter[key - PO_KEY_MIE_M];
  case PO_KEY_POWER_C:
  case PO_KEY_POWER_N:
  case PO_KEY_CONE_T:
  case PO_KEY_PUNCH_B:
  case PO_KEY_PUNCH_R:
  case PO_KEY_TRUNCATED_B:
  case PO_KEY_TRUNCATED_R:
  case PO_KEY_TABLE_SCALE:
    return &request->scene.profile.parameter[key - PO_KEY_POWER_C];
  case PO_KEY_TOLERANCE:
    return &request->mesh.tolerance;
  case PO_KEY_APPROACH_START:
    return &request->approach_start;
  case PO_KEY_APPROACH_END:
    return &request->approach_end;
  case PO_KEY_PRELOAD:
    return &request->preload.approach;
  case PO_KEY_PRELOAD_LOAD:
    return &request->preload.load;
  case PO_KEY_TIME_LIMIT:
    return &request->time_limit;
  default:
    return NULL;
  }
}

/* The radius of a profile for which none was given. */
static bool with_radius(po_request *request, bool set) {
  if (set && !request->radius_given)
    request->scene.radius = po_profile_default_radius(&request->scene.profile);
  return set;
}

static bool set_name(po_request *request, po_key key, const char *text) {
  if (key == PO_KEY_LAW)
    return po_law_set(&request->scene.law, text);
  if (key == PO_KEY_PROFILE)
    return with_radius(request, po_profile_set(&request->scene.profile, text));
  if (key == PO_KEY_PROFILE_FILE)
    return with_radius(request, po_profile_set_file(&request->scene.profile, text) == PO_OK);
  if (key == PO_KEY_WAVES)
    return po_scene_set_waves(&request->scene, text);
  const int found = key == PO_KEY_SCHEME ? po_scheme_of_name(text) : po_grading_of_name(text);
  if (found < 0)
    return false;
  if (key == PO_KEY_SCHEME)
    request->mesh.scheme = (po_scheme)found;
  else
    request->mesh.grading = (po_grading)found;
  return true;
}

/* A table that was read before is read again in the new unit. */
static bool set_scale(po_request *request, double scale) {
  po_profile profile = request->scene.profile;
  po_profile_set_parameter(&profile, PO_TABLE_SCALE, scale);
  const bool set = !po_profile_is_table(&profile) ||
                   po_profile_set_file(&profile, po_profile_file(&profile)) == PO_OK;
  if (set)
    request->scene.profile = profile;
  return set;
}

static bool parse_value(value_type type, const char *text, double *value) {
  switch (type) {
  case ANY_NUMBER:
    return po_number_parse(text, value);
  case NOT_NEGATIVE:
    return po_number_parse(text, value) && *value >= 0;
  case POSITIVE:
    return po_number_parse(text, value) && *value > 0;
  case POSITIVE_OR_INFINITE:
    return po_number_parse_or_infinity(text, value) && *value > 0;
  case FINITE_OR_INFINITE:
    return po_number_parse_or_infinity(text, value) && *value > -INFINITY;
  default:
    return false;
  }
}

bool po_key_set(po_request *request, po_key key, const char *text) {
  if (KEYS[key].type == NAME)
    return set_name(request, key, text);
  if (KEYS[key].type == COUNT) {
    size_t count = 0;
    if (!po_number_parse_count(text, &count) || count == 0)
      return false;
    request->mesh.nodes = count;
    return true;
  }
  double value = 0;
  if (!parse_value(KEYS[key].type, text, &value))
    return false;
  if (key == PO_KEY_ALPHA)
    value = sqrt(request->scene.amplitude * request->scene.radius / value);
  else if (key == PO_KEY_AMPLITUDE_RATIO)
    value *= request->scene.wavelength;
  else if (key == PO_KEY_OUTER_RATIO)
    value *= request->scene.radius;
  else if (key == PO_KEY_COUPLING)
    value = po_scene_tabor_of_coupling(value, request->scene.radius);
  else if (key == PO_KEY_RADIUS)
    request->radius_given = true;
  if (key == PO_KEY_TABLE_SCALE)
    return set_scale(request, value);
  if (is_of_law(key))
    po_law_set_parameter(&request->scene.law, (po_law_parameter)(key - PO_KEY_MIE_M), value);
  else
    *key_place(request, po_key_target(key)) = value;
  return true;
}

double po_key_number(const po_request *request, po_key key) {
  if (is_of_law(key) && !po_law_has(&request->scene.law, (po_law_parameter)(key - PO_KEY_MIE_M)))
    return (double)NAN;
  if (is_of_profile(key) &&
      !po_profile_has(&request->scene.profile, (po_profile_parameter)(key - PO_KEY_POWER_C)))
    return (double)NAN;
  if (key == PO_KEY_COUPLING)
    return po_scene_coupling(&request->scene);
  if (key == PO_KEY_ALPHA)
    return po_scene_alpha(&request->scene);
  if (key == PO_KEY_AMPLITUDE_RATIO)
    return request->scene.amplitude > 0 ? request->scene.amplitude / request->scene.wavelength : 0;
  if (key == PO_KEY_OUTER_RATIO)
    return request->scene.outer_radius / request->scene.radius;
  po_request copy = *request;
  const double *place = key_place(&copy, key);
  if (place)
    return *place;
  if (key == PO_KEY_NODES)
    return (double)request->mesh.nodes;
  if (key == PO_KEY_LAW)
    return (double)po_law_index(&request->scene.law);
  if (key == PO_KEY_PROFILE || key == PO_KEY_PROFILE_FILE)
    return (double)po_profile_index(&request->scene.profile);
  if (key == PO_KEY_WAVES)
    return (double)po_scene_waves(&request->scene);
  return key == PO_KEY_SCHEME ? (double)request->mesh.scheme : (double)request->mesh.grading;
}

static void print_waves(const po_scene *scene, char text[PO_KEY_TEXT_LENGTH]) {
  size_t length = 0;
  snprintf(text, PO_KEY_TEXT_LENGTH, "-");
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    char amplitude[PO_NUMBER_LENGTH], wavelength[PO_NUMBER_LENGTH];
    po_number_print(wave.amplitude, amplitude);
    po_number_print(wave.length, wavelength);
    length += (size_t)snprintf(text + length, PO_KEY_TEXT_LENGTH - length, "%s%s@%s", k ? ";" : "",
                               amplitude, wavelength);
  }
}

void po_key_print(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]) {
  const po_scene *scene = &request->scene;
  const char *name = NULL;
  if (key == PO_KEY_LAW)
    name = po_law_name(&scene->law);
  else if (key == PO_KEY_PROFILE)
    name = po_profile_name(&scene->profile);
  else if (key == PO_KEY_PROFILE_FILE)
    name = po_profile_file(&scene->profile);
  else if (key == PO_KEY_SCHEME)
    name = po_scheme_name(request->mesh.scheme);
  else if (key == PO_KEY_GRADING)
    name = po_grading_name(request->mesh.grading);
  if (name)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%s", name);
  else if (key == PO_KEY_WAVES)
    print_waves(scene, text);
  else if (key == PO_KEY_NODES)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%zu", request->mesh.nodes);
  else if (isnan(po_key_number(request, key)))
    snprintf(text, PO_KEY_TEXT_LENGTH, key == PO_KEY_TIME_LIMIT ? "none" : "auto");
  else
    po_number_print(po_key_number(request, key), text);
}

static bool is_near(double a, double b, int ulps) {
  return a == b || (isfinite(b) && fabs(a - b) <= ulps * DBL_EPSILON * fabs(b));
}

static bool is_close(double a, double b) {
  return is_near(a, b, 4);
}

/* The coupling is computed from the Tabor parameter, and tables give it with 15 digits: half a unit
 * of the last is up to 23 ulp. */
enum { ULPS_OF_COUPLING = 32 };

static bool parameters_match(const po_request *a, const po_request *b, int first, int last) {
  for (int key = first; key <= last; ++key) {
    const double x = po_key_number(a, (po_key)key), y = po_key_number(b, (po_key)key);
    if (!isnan(y) && !is_close(x, y))
      return false;
  }
  return true;
}

static bool waves_match(const po_scene *a, const po_scene *b) {
  bool match = po_scene_waves(a) == po_scene_waves(b);
  for (size_t k = 0; match && k < po_scene_waves(a); ++k) {
    const po_wave x = po_scene_wave(a, k), y = po_scene_wave(b, k);
    match = is_close(x.amplitude, y.amplitude) && is_close(x.length, y.length);
  }
  return match;
}

/* The Lennard-Jones law of the paper is the Mie law (3, 9): one name for both. */
static po_request with_one_name(po_request request) {
  if (po_law_index(&request.scene.law) == 0)
    po_law_set(&request.scene.law, "mie:3,9");
  return request;
}

bool po_key_matches(const po_request *request, po_key key, const char *text) {
  po_request wanted = *request;
  const po_scene *scene = &request->scene;
  if (key == PO_KEY_PROFILE_FILE && strcmp(text, po_profile_digest(&scene->profile)) == 0)
    return true;
  if (!po_key_set(&wanted, key, text))
    return false;
  switch (key) {
  case PO_KEY_LAW: {
    const po_request own = with_one_name(*request);
    wanted = with_one_name(wanted);
    return po_law_index(&wanted.scene.law) == po_law_index(&own.scene.law) &&
           parameters_match(&own, &wanted, PO_KEY_MIE_M, PO_KEY_MORSE_A);
  }
  case PO_KEY_PROFILE:
    return po_profile_index(&wanted.scene.profile) == po_profile_index(&scene->profile) &&
           parameters_match(request, &wanted, PO_KEY_POWER_C, PO_KEY_TRUNCATED_R);
  case PO_KEY_PROFILE_FILE:
    return strcmp(po_profile_digest(&wanted.scene.profile), po_profile_digest(&scene->profile)) ==
           0;
  case PO_KEY_WAVES:
    return waves_match(scene, &wanted.scene);
  case PO_KEY_COUPLING:
    return is_near(po_key_number(request, key), po_key_number(&wanted, key), ULPS_OF_COUPLING);
  default:
    return is_close(po_key_number(request, key), po_key_number(&wanted, key));
  }
}

bool po_key_same(po_key key, const char *a, const char *b) {
  po_request request = po_request_default();
  return po_key_set(&request, key, a) && po_key_matches(&request, key, b);
}

bool po_key_is_of_other_scheme(const po_request *request, po_key key) {
  const bool panel = request->mesh.scheme == PO_PANEL;
  return panel ? key == PO_KEY_NODES || key == PO_KEY_GRADING : key == PO_KEY_TOLERANCE;
}

bool po_key_is_of_scene(po_key key) {
  switch (key) {
  case PO_KEY_SCHEME:
  case PO_KEY_GRADING:
  case PO_KEY_NODES:
  case PO_KEY_TOLERANCE:
  case PO_KEY_APPROACH_START:
  case PO_KEY_APPROACH_END:
  case PO_KEY_PRELOAD:
  case PO_KEY_PRELOAD_LOAD:
  case PO_KEY_TIME_LIMIT:
    return false;
  default:
    return !po_key_is_group((int)key);
  }
}

bool po_key_is_idle(const po_request *request, po_key key) {
  const po_scene *scene = &request->scene;
  const bool sphere = po_profile_is_sphere(&scene->profile);
  switch (key) {
  case PO_KEY_AMPLITUDE:
  case PO_KEY_WAVELENGTH:
    return po_scene_waves(scene) != 1;
  case PO_KEY_WAVES:
    return po_scene_waves(scene) < 2;
  case PO_KEY_LAW:
    return po_law_index(&scene->law) == 0;
  case PO_KEY_PROFILE:
    return sphere || po_profile_is_table(&scene->profile);
  case PO_KEY_PROFILE_FILE:
    return !po_profile_is_table(&scene->profile);
  case PO_KEY_TABLE_SCALE:
    return !po_profile_is_table(&scene->profile) || po_key_number(request, key) == 1.0;
  default:
    return isnan(po_key_number(request, key)) || po_key_is_of_other_scheme(request, key);
  }
}

const char *po_input_load_unit(const po_request *request) {
  const po_scene *scene = &request->scene;
  return po_profile_is_sphere(&scene->profile) || scene->radius != 1.0 ? "pi w R" : "pi w epsilon";
}

/* Returned: whether the command must state the default preload. */
static bool adds_preload(const po_request *request) {
  return !po_scene_is_simple(&request->scene) && !request->want &&
         isnan(request->preload.approach) && isnan(request->preload.load) &&
         isnan(request->approach_end);
}

/* Adds an option for each wave. */
static void add_waves(po_text *command, const char *waves) {
  for (const char *wave = waves; *wave;) {
    const int amplitude = (int)strcspn(wave, "@");
    const int length = (int)strcspn(wave + amplitude + 1, ";");
    po_text_add(command, " --wave %.*s,%.*s", amplitude, wave, length, wave + amplitude + 1);
    wave += amplitude + 1 + length;
    wave += *wave == ';';
  }
}

static void add_option(po_text *command, const po_request *request, po_key key, bool identity) {
  char value[PO_KEY_TEXT_LENGTH], flag[PO_NUMBER_LENGTH];
  po_key_print(request, key, value);
  if (key == PO_KEY_WAVES) {
    add_waves(command, value);
    return;
  }
  snprintf(flag, sizeof flag, "%s", KEYS[key].name);
  for (char *c = flag; *c; ++c)
    if (*c == '_')
      *c = '-';
  po_text_add(command, " --%s ", flag);
  if (key == PO_KEY_PROFILE_FILE)
    po_text_add_word(command, identity ? po_profile_digest(&request->scene.profile) : value);
  else
    po_text_add(command, "%s", value);
}

static char *describe(const po_request *request, bool identity) {
  po_text command = {0};
  po_text_add(&command, "pulloff solve");
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (!po_key_is_idle(request, (po_key)key))
      add_option(&command, request, (po_key)key, identity);
  /* without the preload, a single solve would search beyond the default one */
  if (adds_preload(request)) {
    char load[PO_NUMBER_LENGTH];
    po_number_print(po_load_unit_preload(request).load, load);
    po_text_add(&command, " --preload-load %s", load);
  }
  const char *before = " --want ";
  for (int k = 0; k < PO_WANT_COUNT; ++k)
    if (request->want & (1u << k)) {
      po_text_add(&command, "%s%s", before, po_want_name(k));
      before = ",";
    }
  if (command.failed)
    po_text_clear(&command);
  return command.data;
}

char *po_input_command(const po_request *request) {
  return describe(request, false);
}

char *po_input_identity(const po_request *request) {
  return describe(request, true);
}
