#include "po_texts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_load_unit.h"
#include "po_physical.h"
#include "po_profile_table.h"
#include "po_quote.h"
#include "po_si.h"
#include "po_suggest.h"

static bool are_options(const po_texts *given) {
  return *given->prefix == '-';
}

void po_texts_write_name(const po_texts *given, int key, char name[PO_KEY_NAME_LENGTH]) {
  char flag[PO_FLAG_LENGTH];
  po_key_flag(key, flag);
  snprintf(name, PO_KEY_NAME_LENGTH, "%s%s", given->prefix,
           are_options(given) ? flag : PO_KEYS[key].name);
}

void po_texts_name(const po_texts *given, po_key key, char name[PO_KEY_NAME_LENGTH]) {
  const int si = po_key_in_si(key);
  po_texts_write_name(given, given->si && si >= 0 ? si : key, name);
}

static const char UNCERTAIN[] =
    "; an uncertain number is written 0.05+-0.01, and only solve and cases take it; in "
    "place of follow, a case with a sweep does";

/* Refuses a key with its value, or because it is missing. */
static po_status __attribute__((format(printf, 3, 4)))
refuse(po_texts *given, int key, const char *format, ...) {
  char name[PO_KEY_NAME_LENGTH], shown[PO_QUOTE_LENGTH], expected[300];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(expected, sizeof expected, format, arguments);
  va_end(arguments);
  given->wrong = key;
  po_texts_write_name(given, key, name);
  if (!given->text[key])
    return po_fail(PO_BAD_INPUT, "%s is missing: expected %s", name, expected);
  const char *text = given->text[key];
  const bool uncertain = strstr(text, "+-") || strstr(text, "+/-") || strstr(text, "\u00B1");
  return po_suggest(po_fail(PO_BAD_INPUT, "%s is %s: expected %s%s", name, po_quote(text, shown),
                            expected, uncertain ? UNCERTAIN : ""),
                    text, expected);
}

static po_status set_key(po_texts *given, int key, po_request *request) {
  const char *text = given->text[key];
  if (!text)
    return PO_OK;
  if (key == PO_KEY_VISCOELASTIC) {
    const po_status read = po_creep_read(text, &request->creep);
    given->wrong = key;
    return read == PO_BAD_INPUT ? refuse(given, key, "%s", PO_KEYS[key].expected) : read;
  }
  if (key != PO_KEY_PROFILE_FILE)
    return po_key_set(request, key, text) ? PO_OK : refuse(given, key, "%s", PO_KEYS[key].expected);
  given->wrong = key; /* the message states what is wrong with the file */
  const po_status status = po_profile_use_file(&request->scene.profile, text);
  if (!status && !request->radius_given)
    request->scene.radius = po_profile_default_radius(&request->scene.profile);
  return status;
}

bool po_texts_has(const po_texts *given, po_key key) {
  const int si = po_key_in_si(key);
  return given->text[key] || (si >= 0 && given->text[si]);
}

/* The value of a key in SI units in that of the key that it sets. */
static double without_unit(int key, double value, const po_units *units) {
  return value / po_si_unit_of(units, PO_KEYS[key].dimension).factor;
}

double po_texts_number(const po_texts *given, po_key key, const po_units *units) {
  const int si = po_key_in_si(key);
  double value = (double)NAN;
  if (given->text[key] && po_key_parse(key, given->text[key], &value))
    return value;
  return si >= 0 && given->text[si] && po_key_parse(si, given->text[si], &value)
             ? without_unit(si, value, units)
             : (double)NAN;
}

/* Refuses two keys that set the same. */
static po_status check_pairs(po_texts *given) {
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key target = po_key_target(key);
    const bool further = are_options(given) && key == PO_KEY_WAVES;
    if (!given->text[key] || target == key || further || !po_texts_has(given, target) ||
        (PO_KEYS[key].owner == PO_OWNER_SI && !given->text[target]))
      continue;
    char name[PO_KEY_NAME_LENGTH], other[PO_KEY_NAME_LENGTH];
    po_texts_write_name(given, key, name);
    po_texts_write_name(given, given->text[target] ? target : po_key_in_si(target), other);
    return refuse(given, key, "only one of %s and %s", other, name);
  }
  return PO_OK;
}

/* Refuses keys in the units of the other kind of scene. */
static po_status check_units(po_texts *given) {
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key_row *row = &PO_KEYS[key];
    const int si = po_key_in_si(key);
    const bool of_scene = row->owner == PO_OWNER_SCENE && key != PO_KEY_AMPLITUDE_RATIO;
    if (!given->text[key])
      continue;
    if (row->owner == PO_OWNER_SI && !given->si)
      return refuse(given, key, "it with --from-physical, as it is in SI units");
    if (!given->si || (si < 0 ? !of_scene : !of_scene && given->mixed))
      continue;
    if (si < 0)
      return refuse(given, key, "it to be left out, as it follows from the values in SI units");
    char name[PO_KEY_NAME_LENGTH];
    po_texts_write_name(given, si, name);
    return refuse(given, key, "%s, as the scene is in SI units", name);
  }
  return PO_OK;
}

/* The contact modulus of two bodies. Given: their moduli and Poisson's ratios, `count` of both; one
 * body: the other is rigid. */
static double contact_modulus(const double young[2], const double poisson[2], size_t count) {
  double compliance = 0.0;
  for (size_t k = 0; k < count; ++k)
    compliance += (1.0 - poisson[k]) * (1.0 + poisson[k]) / young[k];
  return 1.0 / compliance;
}

bool po_texts_bodies(const po_texts *given, double *modulus, double *radius, double *work) {
  const char *young_text = given->text[PO_KEY_YOUNG_PA], *radii = given->text[PO_KEY_RADIUS_M],
             *energies = given->text[PO_KEY_SURFACE_ENERGIES];
  double young[PO_KEY_LIST_MOST], poisson[PO_KEY_LIST_MOST];
  *modulus = *radius = *work = (double)NAN;
  if (energies)
    po_key_parse(PO_KEY_SURFACE_ENERGIES, energies, work);
  if (young_text && given->text[PO_KEY_POISSON]) {
    const size_t count = po_key_parse_list(PO_KEY_YOUNG_PA, young_text, young);
    po_key_parse_list(PO_KEY_POISSON, given->text[PO_KEY_POISSON], poisson);
    *modulus = contact_modulus(young, poisson, count);
  }
  if (radii)
    po_key_parse(PO_KEY_RADIUS_M, radii, radius);
  return young_text || energies || (radii && strchr(radii, ','));
}

/* Reads moduli and Poisson's ratios of the bodies, if they are given. */
static po_status read_bodies(po_texts *given, double *modulus) {
  const char *text[] = {given->text[PO_KEY_YOUNG_PA], given->text[PO_KEY_POISSON]};
  const po_key keys[] = {PO_KEY_YOUNG_PA, PO_KEY_POISSON};
  double value[2][PO_KEY_LIST_MOST];
  size_t count[2] = {0, 0};
  char name[PO_KEY_NAME_LENGTH];
  if (!text[0] && !text[1])
    return PO_OK;
  if (given->text[PO_KEY_MODULUS_PA]) {
    po_texts_write_name(given, PO_KEY_MODULUS_PA, name);
    return refuse(given, text[0] ? PO_KEY_YOUNG_PA : PO_KEY_POISSON,
                  "it to be left out beside %s, the contact modulus", name);
  }
  for (int k = 0; k < 2; ++k) {
    po_texts_write_name(given, keys[1 - k], name);
    if (!text[k])
      return refuse(given, keys[k], "%s, beside %s", PO_KEYS[keys[k]].expected, name);
    count[k] = po_key_parse_list(keys[k], text[k], value[k]);
    if (!count[k])
      return refuse(given, keys[k], "%s", PO_KEYS[keys[k]].expected);
  }
  if (count[0] != count[1]) {
    po_texts_write_name(given, PO_KEY_YOUNG_PA, name);
    return refuse(given, PO_KEY_POISSON, "one number for each of %s", name);
  }
  *modulus = contact_modulus(value[0], value[1], count[0]);
  return PO_OK;
}

/* Reads the surface energies, if they are given. */
static po_status read_energies(po_texts *given, double *work) {
  const po_key key = PO_KEY_SURFACE_ENERGIES;
  char name[PO_KEY_NAME_LENGTH];
  po_texts_write_name(given, PO_KEY_WORK_J_PER_M2, name);
  if (given->text[key] && given->text[PO_KEY_WORK_J_PER_M2])
    return refuse(given, key, "it to be left out beside %s, the work of adhesion", name);
  return !given->text[key] || po_key_parse(key, given->text[key], work)
             ? PO_OK
             : refuse(given, key, "%s", PO_KEYS[key].expected);
}

/* Reads the numbers in SI units of which the groups are computed. */
static po_status read_physical(po_texts *given, po_physical *p) {
  const bool profile =
      given->text[PO_KEY_PROFILE_FILE] ||
      (given->text[PO_KEY_PROFILE] && strcmp(given->text[PO_KEY_PROFILE], "sphere") != 0);
  *p = (po_physical){.modulus = (double)INFINITY, .outer_radius = (double)INFINITY};
  const struct {
    po_key key;
    double *value;
    bool needed;
  } items[] = {
      {PO_KEY_MODULUS_PA, &p->modulus, !given->any_modulus && !given->text[PO_KEY_YOUNG_PA]},
      {PO_KEY_WORK_J_PER_M2, &p->work, !given->text[PO_KEY_SURFACE_ENERGIES]},
      {PO_KEY_DISTANCE_M, &p->distance, true},
      {PO_KEY_RADIUS_M, &p->radius, !profile && !given->any_radius},
      {PO_KEY_AMPLITUDE_M, &p->amplitude, false},
      {PO_KEY_WAVELENGTH_M, &p->wavelength, false},
      {PO_KEY_OUTER_RADIUS_M, &p->outer_radius, false}};
  po_status status = read_bodies(given, &p->modulus);
  if (!status)
    status = read_energies(given, &p->work);
  if (status)
    return status;
  for (size_t i = 0; i < sizeof items / sizeof *items; ++i) {
    const char *text = given->text[items[i].key];
    if (text && !po_key_parse(items[i].key, text, items[i].value))
      return refuse(given, items[i].key, "%s", PO_KEYS[items[i].key].expected);
    if (text || !items[i].needed)
      continue;
    char name[4][PO_KEY_NAME_LENGTH];
    for (size_t k = 0; k < 4; ++k)
      po_texts_write_name(given, items[k].key, name[k]);
    return refuse(given, items[i].key,
                  "%s; a scene in SI units has %s%s%s, %s and, of a sphere, %s",
                  PO_KEYS[items[i].key].expected, name[0],
                  given->any_modulus ? " (if elastic), " : ", ", name[1], name[2], name[3]);
  }
  if (!given->text[PO_KEY_RADIUS_M])
    p->radius = p->distance;
  return PO_OK;
}

/* Sets the profile, without waves, whose lengths are in m. */
static po_status set_profile(po_texts *given, double distance, po_request *request) {
  po_status status = PO_OK;
  for (int key = 0; key < PO_KEY_COUNT && !status; ++key)
    if (PO_KEYS[key].owner == PO_OWNER_PROFILE && po_key_target(key) == key)
      status = set_key(given, key, request);
  given->wrong = status ? given->wrong : PO_KEY_PROFILE;
  if (!status && !given->text[PO_KEY_PROFILE_FILE])
    status = po_profile_check(&request->scene.profile);
  if (status)
    return status;
  po_profile_rescale(&request->scene.profile, distance);
  status = set_key(given, PO_KEY_PROFILE_FILE, request);
  const po_profile_table *table = request->scene.profile.table;
  if (!status && table && table->in_metres && given->text[PO_KEY_TABLE_SCALE])
    return refuse(given, PO_KEY_TABLE_SCALE,
                  "it to be left out, as the names of the columns have units");
  return status;
}

/* Adds the waves to those of the scene. Given: the unit of their lengths, in epsilon or 1 over it.
 */
static po_status add_waves(po_texts *given, double distance, po_scene *scene) {
  po_scene waves = po_scene_default();
  if (!given->text[PO_KEY_WAVES])
    return PO_OK;
  if (!po_scene_set_waves(&waves, given->text[PO_KEY_WAVES]))
    return refuse(given, PO_KEY_WAVES, "%s", PO_KEYS[PO_KEY_WAVES].expected);
  for (size_t k = 0; k < po_scene_waves(&waves); ++k) {
    const po_wave wave = po_scene_wave(&waves, k);
    if (!po_scene_add_wave(scene, (po_wave){wave.amplitude / distance, wave.length / distance}))
      return refuse(given, PO_KEY_WAVES, "at most %d waves, with that of the amplitude",
                    PO_MOST_WAVES);
  }
  return PO_OK;
}

/* Computes the scene from values in SI units, but for its law. */
static po_status set_physical(po_texts *given, po_request *request) {
  po_physical physical;
  po_status status = read_physical(given, &physical);
  if (!status)
    status = set_profile(given, physical.distance, request);
  if (status)
    return status;
  double ratio = 0;
  if (given->text[PO_KEY_AMPLITUDE_RATIO] &&
      po_key_parse(PO_KEY_AMPLITUDE_RATIO, given->text[PO_KEY_AMPLITUDE_RATIO], &ratio))
    physical.amplitude = ratio * physical.wavelength;
  const double amplitude = physical.amplitude / physical.distance;
  if (!(physical.wavelength > 0.0)) /* a closed form may have another key in place of it */
    physical.amplitude = 0.0;
  given->wrong = PO_KEY_DISTANCE_M;
  status = po_physical_scene(&physical, &request->scene);
  if (status)
    return status;
  request->scene.amplitude = amplitude;
  request->units = po_physical_units(&physical, &request->scene);
  request->in_si = true;
  return add_waves(given, physical.distance, &request->scene);
}

/* Converts speeds in m/s to epsilon/tau_0, and a time in s to tau_0. */
static po_status set_times(po_texts *given, po_request *request) {
  const char *const unload = given->text[PO_KEY_UNLOAD_SPEED_M_PER_S];
  const char *const load = given->text[PO_KEY_LOAD_SPEED_M_PER_S];
  const char *const dwell = given->text[PO_KEY_DWELL_S];
  const bool any = unload || load || dwell;
  const char *const text = given->text[PO_KEY_RELAXATION_TIME_S];
  const bool in_seconds = po_creep_is_in_seconds(&request->creep);
  double time = 1.0;
  if (text && !po_key_parse(PO_KEY_RELAXATION_TIME_S, text, &time))
    return refuse(given, PO_KEY_RELAXATION_TIME_S, "%s",
                  PO_KEYS[PO_KEY_RELAXATION_TIME_S].expected);
  if (text && !any)
    return refuse(given, PO_KEY_RELAXATION_TIME_S, "it beside a speed in m/s or a time in s");
  if (text && in_seconds && time != 1.0)
    return refuse(given, PO_KEY_RELAXATION_TIME_S,
                  "1 or nothing, as the times of the material are "
                  "in s");
  if (!any)
    return PO_OK;
  if (!text && !in_seconds)
    return refuse(given, PO_KEY_RELAXATION_TIME_S, "%s, as %s",
                  PO_KEYS[PO_KEY_RELAXATION_TIME_S].expected,
                  unload || load ? "the speed is in m/s" : "the dwell is in s");
  request->unload_speed *= unload ? time / request->units.length : 1.0;
  request->load_speed *= load ? time / request->units.length : 1.0;
  request->dwell /= dwell ? time : 1.0;
  return PO_OK;
}

/* Sets the keys in SI units that do not belong to the scene. */
static po_status set_in_si(po_texts *given, po_request *request) {
  for (int key = PO_KEY_END; key < PO_KEY_ALL; ++key) {
    const po_key_row *target = &PO_KEYS[po_key_target(key)];
    double value = 0;
    if (!given->text[key] || target->owner != PO_OWNER_TRACE)
      continue;
    if (!po_key_parse(key, given->text[key], &value))
      return refuse(given, key, "%s", PO_KEYS[key].expected);
    if (PO_KEYS[key].owner == PO_OWNER_SI)
      value = without_unit(key, value, &request->units);
    if (target->place != PO_NO_PLACE)
      *(double *)(void *)((char *)request + target->place) = value;
  }
  return set_times(given, request);
}

/* Refuses keys that the mesh, the law or the profile of a request does not have. */
static po_status check_idle(po_texts *given, const po_request *request) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!given->text[key])
      continue;
    if (po_key_is_of_other_scheme(request, key))
      return refuse(given, key, "it with the scheme %s, not %s",
                    key == PO_KEY_TOLERANCE ? "panel" : "ring or triangle",
                    PO_SCHEMES[request->mesh.scheme]);
    if (!isnan(po_key_number(request, key)))
      continue;
    if (PO_KEYS[key].owner == PO_OWNER_TRACE) /* a value that is no number is the default */
      continue;
    if (key == PO_KEY_TABLE_SCALE || key == PO_KEY_SMOOTH)
      return refuse(given, key, "it beside the file of a profile");
    const bool law = PO_KEYS[key].owner == PO_OWNER_LAW;
    const char *name = PO_KEYS[key].name; /* begins with that of its law or profile */
    return refuse(
        given, key, "it with the %s %.*s, not %s", law ? "law" : "profile", (int)strcspn(name, "_"),
        name, law ? po_law_name(&request->scene.law) : po_profile_name(&request->scene.profile));
  }
  return PO_OK;
}

/* Sets the usual length and force of a scene in SI units: of a profile that is not a sphere, from
 * the unit of its solve. */
static void set_usual_units(po_request *request) {
  const po_scene solved = po_load_unit_request(request).scene;
  request->units.usual_length = request->units.length * fmax(1.0, solved.tabor);
  request->units.usual_force = request->units.force * po_scene_load_unit(&solved);
}

/* The contact modulus over the relaxed modulus of a table. It is 1/(1 - nu^2) of Young's modulus
 * and 2/(1 - nu) of the shear modulus, from 1 to 4, and half of that if both bodies are of the
 * material; with a tenth to spare for the digits of both. */
static const double LEAST_MODULUS_RATIO = 0.45, GREATEST_MODULUS_RATIO = 4.4;

/* Refuses a table of moduli in another range than the modulus of the scene, of which only the
 * ratios would be used: a slip of the unit, or another material. */
static po_status check_material(po_texts *given, const po_request *request) {
  const double relaxed = po_creep_relaxed(&request->creep);
  const double modulus = po_scene_stiffness(&request->scene) * request->units.tension;
  if (!request->in_si || isnan(relaxed) || !isfinite(modulus) ||
      (modulus >= LEAST_MODULUS_RATIO * relaxed && modulus <= GREATEST_MODULUS_RATIO * relaxed))
    return PO_OK;
  return refuse(
      given, PO_KEY_VISCOELASTIC,
      "a relaxed modulus from 1/4 to 2 times the contact modulus of the scene, %.4g Pa; in "
      "the table it is %.4g Pa. A column without a unit has ratios alone",
      modulus, relaxed);
}

po_status po_texts_read(po_texts *given, po_request *request) {
  po_status status = check_pairs(given);
  if (!status)
    status = check_units(given);
  if (!status && given->si)
    status = set_physical(given, request);
  const bool further = are_options(given) && given->text[PO_KEY_AMPLITUDE];
  for (int key = 0; key < PO_KEY_END && !status; ++key) {
    const po_key_owner owner = PO_KEYS[key].owner;
    if (given->si ? owner == PO_OWNER_SCENE || owner == PO_OWNER_PROFILE
                  : further && key == PO_KEY_WAVES)
      continue;
    status = set_key(given, key, request);
  }
  if (!status && !given->si && further)
    status = add_waves(given, 1.0, &request->scene);
  if (!status)
    status = set_in_si(given, request);
  if (!status && request->in_si)
    set_usual_units(request);
  if (!status)
    status = check_material(given, request);
  return status ? status : check_idle(given, request);
}

/* Whether a key is given as a number other than 0, in its own unit or in SI units. */
static bool is_not_zero(const po_texts *given, po_key key) {
  const int si = po_key_in_si(key);
  const char *text = given->text[key] || si < 0 ? given->text[key] : given->text[si];
  double value = 0;
  return text && po_number_parse(text, &value) && value != 0;
}

po_status po_texts_check_waves(po_texts *given) {
  const bool amplitude =
      po_texts_has(given, PO_KEY_AMPLITUDE) || given->text[PO_KEY_AMPLITUDE_RATIO];
  const bool smooth =
      !is_not_zero(given, PO_KEY_AMPLITUDE) && !is_not_zero(given, PO_KEY_AMPLITUDE_RATIO);
  if (amplitude ? smooth || given->text[PO_KEY_ALPHA] || is_not_zero(given, PO_KEY_WAVELENGTH)
                : !po_texts_has(given, PO_KEY_WAVELENGTH) && !given->text[PO_KEY_ALPHA])
    return PO_OK;
  const po_key key = amplitude ? PO_KEY_WAVELENGTH : PO_KEY_AMPLITUDE;
  char name[PO_KEY_NAME_LENGTH];
  po_texts_name(given, amplitude ? PO_KEY_AMPLITUDE : PO_KEY_WAVELENGTH, name);
  return refuse(given, given->si ? po_key_in_si(key) : key, "%s beside %s",
                given->text[key] ? PO_KEYS[key].expected : "it", name);
}

bool po_texts_is_general(const po_texts *given, const po_form *form, const po_scene *scene) {
  /* a wave makes the form that of any profile, unless the paper has a formula with the wave */
  const bool by_wave = form->takes & PO_TAKES_PROFILE && !(form->needs & PO_NEEDS_AMPLITUDE);
  return given->text[PO_KEY_LAW] || given->text[PO_KEY_PROFILE] ||
         given->text[PO_KEY_PROFILE_FILE] || given->text[PO_KEY_WAVES] ||
         (by_wave && po_scene_is_wavy(scene));
}

po_status po_use_check(const char *what, const po_use *uses, size_t count) {
  const po_use *idle = NULL;
  size_t taken = 0, named = 0;
  for (size_t i = 0; i < count; ++i) {
    if (uses[i].given && !uses[i].taken && !idle)
      idle = &uses[i];
    taken += uses[i].taken;
  }
  char names[1000] = "";
  for (size_t i = 0; idle && i < count; ++i)
    if (uses[i].taken) {
      const char *before = named == 0 ? "only " : named + 1 < taken ? ", " : " or ";
      snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", before, uses[i].name);
      ++named;
    }
  return idle ? po_fail(PO_BAD_INPUT, "%s has no effect on %s: expected %s", idle->name, what,
                        *names ? names : "it to be left out")
              : PO_OK;
}

/* The part of a scene to which a key belongs, as in po_form.takes; 0: no form depends on it. */
static unsigned part_of(po_key key) {
  const po_key_owner owner = PO_KEYS[key].owner;
  if (owner == PO_OWNER_LAW || owner == PO_OWNER_PROFILE)
    return owner == PO_OWNER_LAW ? PO_TAKES_LAW : PO_TAKES_PROFILE;
  switch (po_key_target(key)) {
  case PO_KEY_TABOR:
    return PO_TAKES_TABOR;
  case PO_KEY_AMPLITUDE:
    return PO_TAKES_AMPLITUDE;
  case PO_KEY_WAVELENGTH:
    return PO_TAKES_WAVELENGTH;
  case PO_KEY_RADIUS:
    return PO_TAKES_RADIUS;
  case PO_KEY_PRELOAD:
  case PO_KEY_PRELOAD_LOAD:
    return PO_TAKES_PRELOAD | PO_TAKES_RATE;
  case PO_KEY_VISCOELASTIC:
  case PO_KEY_UNLOAD_SPEED:
    return PO_TAKES_RATE;
  default:
    return 0;
  }
}

po_status po_texts_check_rate(const po_texts *given, const po_form *form,
                              const po_form_input *input) {
  char name[3][PO_KEY_NAME_LENGTH];
  const po_key keys[] = {PO_KEY_VISCOELASTIC, PO_KEY_UNLOAD_SPEED, PO_KEY_PRELOAD};
  for (int k = 0; k < 3; ++k)
    po_texts_name(given, keys[k], name[k]);
  if (po_form_lacks_rate(form, input))
    return po_fail(PO_BAD_INPUT, "theory %s needs %s and %s", form->name, name[0], name[1]);
  if (form->needs & PO_NEEDS_RATE && isinf(input->preload.approach))
    return po_fail(PO_BAD_INPUT, "%s is %g: expected a finite number", name[2],
                   input->preload.approach);
  return PO_OK;
}

po_status po_texts_check_form(const po_texts *given, const po_form *form, bool alpha,
                              const po_use *others, size_t count) {
  enum { MOST_OTHERS = 8 };
  const unsigned takes = po_form_takes(form, alpha);
  po_use uses[PO_KEY_END + MOST_OTHERS];
  size_t used = 0;
  char what[80];
  snprintf(what, sizeof what, "theory %s%s%s", form->name,
           takes == form->takes ? ""
           : are_options(given) ? " with --"
                                : " with ",
           takes == form->takes ? "" : "alpha");
  for (int other = 0; other < 2; ++other) /* tabor and coupling first */
    for (int k = 0; k < PO_KEY_END; ++k) {
      const po_key key = k;
      if ((po_key_target(key) != PO_KEY_TABOR) != (other != 0))
        continue;
      const bool named = !po_key_is_number(key) || key == PO_KEY_COUPLING ||
                         part_of(key) & PO_TAKES_RATE ||
                         (po_key_is_of_scene(key) && PO_KEYS[k].owner == PO_OWNER_SCENE);
      po_use *use = &uses[used++];
      po_texts_name(given, key, use->name);
      use->given = po_texts_has(given, key);
      use->taken = takes & part_of(key) && (named || use->given);
      if (given->si && !other) /* follows from the units */
        use->taken = false;
      if (given->si && key == PO_KEY_RADIUS) /* the unit of force contains it */
        use->taken = true;
    }
  memcpy(uses + used, others, count * sizeof *others);
  return po_use_check(what, uses, used + count);
}
