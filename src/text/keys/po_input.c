#include "po_input.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_digest.h"
#include "po_theory_forces.h"

typedef enum {
  ANY_NUMBER_DOMAIN,
  NOT_NEGATIVE_DOMAIN,
  POSITIVE_DOMAIN,
  POSITIVE_OR_INFINITE_DOMAIN,
  POSITIVE_OR_AUTO_DOMAIN,
  FINITE_OR_INFINITE_DOMAIN,
  RADII_DOMAIN, /* this and the next two: one number, or two with a comma between */
  MODULI_DOMAIN,
  RATIOS_DOMAIN,
  ENERGIES_DOMAIN, /* two numbers or three */
  NOT_NEGATIVE_OR_INFINITE_DOMAIN,
  COUNT_DOMAIN,
  NAME_DOMAIN
} value_type;

/* The words of the cells. */
#define OTHER(domain, expected) domain##_DOMAIN, expected
#define WORDS(expected) NAME_DOMAIN, expected
#define NOT_NEGATIVE OTHER(NOT_NEGATIVE, "a finite number >= 0")
#define POSITIVE OTHER(POSITIVE, "a finite number > 0")
#define POSITIVE_OR_INFINITE OTHER(POSITIVE_OR_INFINITE, "a finite number > 0, or inf")
#define ANY_NUMBER OTHER(ANY_NUMBER, "a finite number")
#define FINITE_OR_INFINITE OTHER(FINITE_OR_INFINITE, "a finite number, or inf")
#define RADII OTHER(RADII, "a finite number > 0, or two with a comma between")
#define MODULI OTHER(MODULI, "a number > 0 or inf, or two with a comma between")
#define RATIOS OTHER(RATIOS, "a number from -1 to 0.5, or two with a comma between")
#define ENERGIES OTHER(ENERGIES, "G1,G2 or G1,G2,G12, numbers >= 0, with G1 + G2 - G12 > 0")
#define NOT_NEGATIVE_OR_INFINITE OTHER(NOT_NEGATIVE_OR_INFINITE, "a finite number >= 0, or inf")
#define COUNT OTHER(COUNT, "a whole number > 0")
#define NUMBER PO_DIMENSION_NONE
#define LENGTH PO_DIMENSION_LENGTH
#define LOAD PO_DIMENSION_LOAD
#define STIFFNESS PO_DIMENSION_STIFFNESS
enum { CONSTANT = false, VARIES = true };
#define PLACE(member) offsetof(po_request, member), -1
#define SETS(key) PO_NO_PLACE, PO_KEY_##key
#define OF_LAW(number) PLACE(scene.law.parameter[number])
#define OF_PROFILE(number) PLACE(scene.profile.parameter[number])
#define NO_PLACE PO_NO_PLACE, -1
#define NO_VERB 0
#define SPRING PO_FOR_SOLVE
#define SOLVE (PO_FOR_SOLVE | PO_FOR_COMPARE)
#define FOLLOW PO_FOR_FOLLOW
#define SERIES (SOLVE | FOLLOW)
#define EVERY (SERIES | PO_FOR_THEORY)
#define HELP(text) text, ""
#define HELPS(text, theory) text, theory
#define NO_HELP HELP("")

#define ROW(key, name, domain, dimension, owner, place, varies, verbs, value, help)                \
  [PO_KEY_##key] = {name, domain, dimension, varies, PO_OWNER_##owner, place, verbs, value, help},
const po_key_row PO_KEYS[PO_KEY_ALL] = {PO_KEY_ROWS(ROW) PO_GROUP_ROWS(ROW) PO_TEXTS_ROWS(ROW)
                                            PO_VARIABLE_ROWS(ROW)};

po_request po_input_default(void) {
  po_request request = po_request_default();
  request.theories = &PO_THEORY_FORCES;
  return request;
}

int po_key_of_name(const char *name) {
  const int key = po_texts_key(name);
  return key < PO_KEY_END ? key : -1;
}

int po_texts_key(const char *name) {
  for (int key = 0; key < PO_KEY_ALL; ++key)
    if (PO_KEYS[key].name[0] == name[0] && strcmp(PO_KEYS[key].name, name) == 0)
      return key;
  return -1;
}

bool po_key_is_number(po_key key) {
  return PO_KEYS[key].domain != NAME_DOMAIN;
}

bool po_key_is_group(po_key key) {
  return key >= PO_KEY_COUNT && key < PO_KEY_END;
}

bool po_key_is_parameter(po_key key, po_key_owner owner) {
  return key >= 0 && PO_KEYS[key].owner == owner && PO_KEYS[key].domain != NAME_DOMAIN;
}

bool po_key_is_continuous(po_key key) {
  return key >= 0 && PO_KEYS[key].varies;
}

po_key po_key_target(po_key key) {
  return PO_KEYS[key].target < 0 ? key : PO_KEYS[key].target;
}

int po_key_in_si(po_key key) {
  for (int si = PO_KEY_END; si < PO_KEY_ALL; ++si)
    if (PO_KEYS[si].target == key)
      return si;
  return -1;
}

/* Returned: the place of the value of a key in a request; NULL for names, counts and groups. */
static double *key_place(po_request *request, po_key key) {
  const size_t place = PO_KEYS[key].place;
  return place == PO_NO_PLACE ? NULL : (double *)(void *)((char *)request + place);
}

/* The number of a parameter among those of all laws, or of all profiles. */
static int parameter_of(po_key key) {
  const size_t first = PO_KEYS[key].owner == PO_OWNER_LAW
                           ? offsetof(po_request, scene.law.parameter)
                           : offsetof(po_request, scene.profile.parameter);
  return (int)((PO_KEYS[key].place - first) / sizeof(double));
}

/* Whether the law or the profile of a request has the parameter that a key is. */
static bool has_parameter(const po_request *request, po_key key) {
  if (po_key_is_parameter(key, PO_OWNER_LAW))
    return po_law_has(&request->scene.law, (po_law_parameter)parameter_of(key));
  return !po_key_is_parameter(key, PO_OWNER_PROFILE) ||
         po_profile_has(&request->scene.profile, (po_profile_parameter)parameter_of(key));
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
    return with_radius(request, po_profile_use_file(&request->scene.profile, text) == PO_OK);
  if (key == PO_KEY_WAVES)
    return po_scene_set_waves(&request->scene, text);
  if (key == PO_KEY_VISCOELASTIC)
    return po_creep_read(text, &request->creep) == PO_OK;
  const char *const *names = key == PO_KEY_SCHEME    ? PO_SCHEMES
                             : key == PO_KEY_GRADING ? PO_GRADINGS
                                                     : PO_RANGES;
  int found = 0;
  while (names[found] && strcmp(names[found], text) != 0)
    ++found;
  if (!names[found])
    return false;
  if (key == PO_KEY_SCHEME)
    request->mesh.scheme = (po_scheme)found;
  else if (key == PO_KEY_GRADING)
    request->mesh.grading = (po_grading)found;
  else
    request->range = (po_range_choice)found;
  return true;
}

/* A table that was read before is read again in the new unit, or is smoothed. */
static bool set_of_table(po_request *request, po_profile_parameter parameter, double value) {
  po_profile profile = request->scene.profile;
  profile.parameter[parameter] = value;
  const bool set = !po_profile_is_table(&profile) ||
                   po_profile_use_file(&profile, po_profile_file(&profile)) == PO_OK;
  if (set)
    request->scene.profile = profile;
  return set;
}

/* As po_number_parse, but "inf" is accepted and gives INFINITY. */
static bool parse_or_infinity(const char *text, double *value) {
  if (strcmp(text, "inf") == 0) {
    *value = (double)INFINITY;
    return true;
  }
  return po_number_parse(text, value);
}

bool po_key_is_list(po_key key) {
  return key >= 0 && PO_KEYS[key].domain >= RADII_DOMAIN && PO_KEYS[key].domain <= ENERGIES_DOMAIN;
}

/* Whether a list may have a number. */
static bool is_of_list(value_type domain, double value) {
  if (domain == ENERGIES_DOMAIN)
    return value >= 0.0 && isfinite(value);
  return domain == RATIOS_DOMAIN ? value > -1.0 && value <= 0.5
                                 : value > 0.0 && (domain == MODULI_DOMAIN || isfinite(value));
}

size_t po_key_parse_list(po_key key, const char *text, double value[PO_KEY_LIST_MOST]) {
  const value_type domain = (value_type)PO_KEYS[key].domain;
  const size_t least = domain == ENERGIES_DOMAIN ? 2 : 1, most = least + 1;
  size_t count = 0;
  for (const char *next = text; next; ++count) {
    char number[PO_NUMBER_LENGTH];
    const size_t length = strcspn(next, ",");
    if (count == most || length >= sizeof number)
      return 0;
    memcpy(number, next, length);
    number[length] = '\0';
    if (!parse_or_infinity(number, &value[count]) || !is_of_list(domain, value[count]))
      return 0;
    next = next[length] ? next + length + 1 : NULL;
  }
  return count < least ? 0 : count;
}

/* The number that follows from those of a list. */
static bool parse_whole(po_key key, const char *text, double *whole) {
  double value[PO_KEY_LIST_MOST];
  const size_t count = po_key_parse_list(key, text, value);
  *whole = value[0];
  if (PO_KEYS[key].domain == ENERGIES_DOMAIN) /* Dupre's equation */
    *whole = count ? value[0] + value[1] - (count > 2 ? value[2] : 0.0) : 0.0;
  else if (PO_KEYS[key].domain == RADII_DOMAIN && count == 2) /* 1/R = 1/R1 + 1/R2 */
    *whole = value[0] / (1.0 + value[0] / value[1]);
  return count && (PO_KEYS[key].domain != ENERGIES_DOMAIN || *whole > 0.0);
}

bool po_key_parse(po_key key, const char *text, double *value) {
  switch ((value_type)PO_KEYS[key].domain) {
  case ANY_NUMBER_DOMAIN:
    return po_number_parse(text, value);
  case NOT_NEGATIVE_DOMAIN:
    return po_number_parse(text, value) && *value >= 0;
  case POSITIVE_DOMAIN:
    return po_number_parse(text, value) && *value > 0;
  case POSITIVE_OR_INFINITE_DOMAIN:
    return parse_or_infinity(text, value) && *value > 0;
  case POSITIVE_OR_AUTO_DOMAIN:
    *value = INFINITY;
    return strcmp(text, "auto") == 0 || (po_number_parse(text, value) && *value > 0);
  case RADII_DOMAIN:
  case MODULI_DOMAIN:
  case RATIOS_DOMAIN:
  case ENERGIES_DOMAIN:
    return parse_whole(key, text, value);
  case FINITE_OR_INFINITE_DOMAIN:
    return parse_or_infinity(text, value) && *value > -INFINITY;
  case NOT_NEGATIVE_OR_INFINITE_DOMAIN:
    return parse_or_infinity(text, value) && *value >= 0;
  default:
    return false;
  }
}

/* Whether a text is the wavelength 0 that documents state for a scene without waves. */
static bool is_of_smooth(const po_request *request, po_key key, const char *text) {
  double value = 1;
  return key == PO_KEY_WAVELENGTH && request->scene.amplitude == 0.0 &&
         po_number_parse(text, &value) && value == 0;
}

bool po_key_set(po_request *request, po_key key, const char *text) {
  if (PO_KEYS[key].domain == NAME_DOMAIN)
    return set_name(request, key, text);
  if (PO_KEYS[key].domain == COUNT_DOMAIN) {
    size_t count = 0;
    if (!po_number_parse_count(text, &count) || count == 0)
      return false;
    request->mesh.nodes = count;
    return true;
  }
  double value = 0;
  if (!po_key_parse(key, text, &value) && !is_of_smooth(request, key, text))
    return false;
  if (PO_KEYS[key].owner == PO_OWNER_SI)
    return true;
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
  /* What a group amounts to has to be a number that is printed and read back. */
  if (po_key_is_group(key) && !isnormal(value) && (value != 0 || key == PO_KEY_OUTER_RATIO))
    return false;
  if (key == PO_KEY_TABLE_SCALE || key == PO_KEY_SMOOTH)
    return set_of_table(request, (po_profile_parameter)parameter_of(key), value);
  if (po_key_is_parameter(key, PO_OWNER_LAW))
    po_law_set_parameter(&request->scene.law, (po_law_parameter)parameter_of(key), value);
  else
    *key_place(request, po_key_target(key)) = value;
  return true;
}

double po_key_number(const po_request *request, po_key key) {
  if (!has_parameter(request, key))
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
  if (key == PO_KEY_RANGE)
    return (double)request->range;
  if (key == PO_KEY_VISCOELASTIC)
    return request->creep.kind == PO_CREEP_NONE ? (double)NAN : (double)request->creep.kind;
  return key == PO_KEY_SCHEME ? (double)request->mesh.scheme : (double)request->mesh.grading;
}

bool po_key_is_of_other_scheme(const po_request *request, po_key key) {
  const bool panel = request->mesh.scheme == PO_PANEL;
  return panel ? key == PO_KEY_NODES || key == PO_KEY_GRADING : key == PO_KEY_TOLERANCE;
}

bool po_key_is_of_scene(po_key key) {
  return (PO_KEYS[key].owner < PO_OWNER_MESH && !po_key_is_group(key)) || po_key_is_of_time(key);
}

bool po_key_is_of_time(po_key key) {
  return key == PO_KEY_VISCOELASTIC || key == PO_KEY_UNLOAD_SPEED || key == PO_KEY_LOAD_SPEED ||
         key == PO_KEY_DWELL;
}

bool po_input_has_coupling(const po_request *request) {
  const po_scene *scene = &request->scene;
  return !po_profile_is_sphere(&scene->profile) && scene->radius == 1.0;
}

const char *po_input_load_unit(const po_request *request) {
  return po_input_has_coupling(request) ? "pi w epsilon" : "pi w R";
}

/* -- Whether a request has the value that a table or a case file gives -- */

static bool is_near(double a, double b, int ulps) {
  return a == b || (isfinite(b) && fabs(a - b) <= ulps * DBL_EPSILON * fabs(b));
}

static bool is_close(double a, double b) {
  return is_near(a, b, 4);
}

/* The coupling is computed from the Tabor parameter, and tables give it with 15 digits: half a unit
 * of the last is up to 23 ulp. */
enum { ULPS_OF_COUPLING = 32 };

/* The scale of a table is not compared: the content of the table is. */
static bool parameters_match(const po_request *a, const po_request *b, po_key_owner owner) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!po_key_is_parameter(key, owner) || !po_key_is_continuous(key))
      continue;
    const double x = po_key_number(a, key), y = po_key_number(b, key);
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

static bool creeps_match(const po_creep *a, const po_creep *b) {
  char text[2][PO_CREEP_TEXT];
  if (a->kind != b->kind || a->kind != PO_CREEP_PRONY)
    return a->kind == b->kind && is_close(a->ratio, b->ratio) && is_close(a->exponent, b->exponent);
  po_creep_write_identity(a, text[0]);
  po_creep_write_identity(b, text[1]);
  return strcmp(text[0], text[1]) == 0;
}

/* The Lennard-Jones law of the paper is the Mie law (3, 9): one name for both. */
static po_request with_one_name(po_request request) {
  if (po_law_index(&request.scene.law) == 0)
    po_law_set(&request.scene.law, "mie:3,9");
  return request;
}

bool po_key_is_identity(po_key key, const char *text) {
  const char *digest = key == PO_KEY_VISCOELASTIC   ? po_creep_file_of(text)
                       : key == PO_KEY_PROFILE_FILE ? text
                                                    : NULL;
  const size_t length = PO_DIGEST_LENGTH - 1;
  return digest && strlen(digest) == length && strspn(digest, "0123456789abcdef") == length;
}

bool po_key_matches(const po_request *request, po_key key, const char *text) {
  po_request wanted = *request;
  const po_scene *scene = &request->scene;
  if (key == PO_KEY_PROFILE_FILE && strcmp(text, po_profile_digest(&scene->profile)) == 0)
    return true;
  if (key == PO_KEY_VISCOELASTIC && request->creep.kind == PO_CREEP_PRONY) {
    char identity[PO_CREEP_TEXT];
    po_creep_write_identity(&request->creep, identity);
    if (strcmp(text, identity) == 0)
      return true;
  }
  if (po_key_is_identity(key, text))
    return false;
  const bool optional = key == PO_KEY_STIFFNESS || key == PO_KEY_LOAD_SPEED || key == PO_KEY_DWELL;
  if (optional && strcmp(text, "-") == 0)
    return isnan(po_key_number(request, key));
  if (!po_key_set(&wanted, key, text))
    return false;
  switch (key) {
  case PO_KEY_LAW: {
    const po_request own = with_one_name(*request);
    wanted = with_one_name(wanted);
    return po_law_index(&wanted.scene.law) == po_law_index(&own.scene.law) &&
           parameters_match(&own, &wanted, PO_OWNER_LAW);
  }
  case PO_KEY_PROFILE:
    return po_profile_index(&wanted.scene.profile) == po_profile_index(&scene->profile) &&
           parameters_match(request, &wanted, PO_OWNER_PROFILE);
  case PO_KEY_PROFILE_FILE:
    return strcmp(po_profile_digest(&wanted.scene.profile), po_profile_digest(&scene->profile)) ==
           0;
  case PO_KEY_WAVES:
    return waves_match(scene, &wanted.scene);
  case PO_KEY_VISCOELASTIC:
    return creeps_match(&wanted.creep, &request->creep);
  case PO_KEY_COUPLING:
    return is_near(po_key_number(request, key), po_key_number(&wanted, key), ULPS_OF_COUPLING);
  default:
    return is_close(po_key_number(request, key), po_key_number(&wanted, key));
  }
}
