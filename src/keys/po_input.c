#include "po_input.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_companion_jkr.h"
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

bool po_input_has_coupling(const po_request *request) {
  const po_scene *scene = &request->scene;
  return !po_profile_is_sphere(&scene->profile) && scene->radius == 1.0;
}

const char *po_input_load_unit(const po_request *request) {
  return po_input_has_coupling(request) ? "pi w epsilon" : "pi w R";
}
