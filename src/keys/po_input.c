#include "po_input.h"

#include <float.h>
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

po_key po_key_target(po_key key) {
  if (key == PO_KEY_ALPHA)
    return PO_KEY_WAVELENGTH;
  if (key == PO_KEY_OUTER_RATIO)
    return PO_KEY_OUTER_RADIUS;
  return key == PO_KEY_AMPLITUDE_RATIO ? PO_KEY_AMPLITUDE : key;
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

static bool is_of_law(po_key key) {
  return key >= PO_KEY_MIE_M && key <= PO_KEY_MORSE_A;
}

static bool set_name(po_request *request, po_key key, const char *text) {
  if (key == PO_KEY_LAW)
    return po_law_set(&request->scene.law, text);
  const int found = key == PO_KEY_SCHEME ? po_scheme_of_name(text) : po_grading_of_name(text);
  if (found < 0)
    return false;
  if (key == PO_KEY_SCHEME)
    request->mesh.scheme = (po_scheme)found;
  else
    request->mesh.grading = (po_grading)found;
  return true;
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
  if (is_of_law(key))
    po_law_set_parameter(&request->scene.law, (po_law_parameter)(key - PO_KEY_MIE_M), value);
  else
    *key_place(request, po_key_target(key)) = value;
  return true;
}

double po_key_number(const po_request *request, po_key key) {
  if (is_of_law(key) && !po_law_has(&request->scene.law, (po_law_parameter)(key - PO_KEY_MIE_M)))
    return (double)NAN;
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
  return key == PO_KEY_SCHEME ? (double)request->mesh.scheme : (double)request->mesh.grading;
}

void po_key_print(const po_request *request, po_key key, char text[PO_NUMBER_LENGTH]) {
  if (key == PO_KEY_LAW)
    snprintf(text, PO_NUMBER_LENGTH, "%s", po_law_name(&request->scene.law));
  else if (key == PO_KEY_SCHEME)
    snprintf(text, PO_NUMBER_LENGTH, "%s", po_scheme_name(request->mesh.scheme));
  else if (key == PO_KEY_GRADING)
    snprintf(text, PO_NUMBER_LENGTH, "%s", po_grading_name(request->mesh.grading));
  else if (key == PO_KEY_NODES)
    snprintf(text, PO_NUMBER_LENGTH, "%zu", request->mesh.nodes);
  else if (isnan(po_key_number(request, key)))
    snprintf(text, PO_NUMBER_LENGTH, key == PO_KEY_TIME_LIMIT ? "none" : "auto");
  else
    po_number_print(po_key_number(request, key), text);
}

static bool is_close(double a, double b) {
  return a == b || (isfinite(b) && fabs(a - b) <= 4 * DBL_EPSILON * fabs(b));
}

bool po_key_matches(const po_request *request, po_key key, const char *text) {
  po_request wanted = *request;
  if (!po_key_set(&wanted, key, text))
    return false;
  if (key == PO_KEY_LAW && po_law_index(&wanted.scene.law) == po_law_index(&request->scene.law)) {
    for (int k = PO_KEY_MIE_M; k <= PO_KEY_MORSE_A; ++k)
      if (po_law_has(&wanted.scene.law, (po_law_parameter)(k - PO_KEY_MIE_M)) &&
          !is_close(po_key_number(request, (po_key)k), po_key_number(&wanted, (po_key)k)))
        return false;
    return true;
  }
  return is_close(po_key_number(request, key), po_key_number(&wanted, key));
}

bool po_key_is_of_other_scheme(const po_request *request, po_key key) {
  const bool panel = request->mesh.scheme == PO_PANEL;
  return panel ? key == PO_KEY_NODES || key == PO_KEY_GRADING : key == PO_KEY_TOLERANCE;
}

bool po_key_is_idle(const po_request *request, po_key key) {
  const bool smooth = request->scene.amplitude == 0;
  return (key == PO_KEY_AMPLITUDE && smooth) || (key == PO_KEY_WAVELENGTH && smooth) ||
         (key == PO_KEY_LAW && po_law_index(&request->scene.law) == 0) ||
         isnan(po_key_number(request, key)) || po_key_is_of_other_scheme(request, key);
}

/* Returned: whether the command must state the default preload. */
static bool adds_preload(const po_request *request) {
  return request->scene.amplitude > 0 && !request->want && isnan(request->preload.approach) &&
         isnan(request->preload.load) && isnan(request->approach_end);
}

char *po_input_command(const po_request *request) {
  po_text command = {0};
  po_text_add(&command, "pulloff solve");
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (po_key_is_idle(request, (po_key)key))
      continue;
    char value[PO_NUMBER_LENGTH], flag[PO_NUMBER_LENGTH];
    po_key_print(request, (po_key)key, value);
    snprintf(flag, sizeof flag, "%s", KEYS[key].name);
    for (char *c = flag; *c; ++c)
      if (*c == '_')
        *c = '-';
    po_text_add(&command, " --%s %s", flag, value);
  }
  /* without the preload, a single solve would search beyond the default one */
  if (adds_preload(request))
    po_text_add(&command, " --preload-load %g", po_request_preload(request).load);
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
