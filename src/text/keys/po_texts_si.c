/* Scenes in SI units, from the texts of their keys. */
#include <math.h>
#include <string.h>

#include "po_load_unit.h"
#include "po_physical.h"
#include "po_profile_table.h"
#include "po_texts_internal.h"

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
    return po_texts_refuse(given, text[0] ? PO_KEY_YOUNG_PA : PO_KEY_POISSON,
                           "it to be left out beside %s, the contact modulus", name);
  }
  for (int k = 0; k < 2; ++k) {
    po_texts_write_name(given, keys[1 - k], name);
    if (!text[k])
      return po_texts_refuse(given, keys[k], "%s, beside %s", PO_KEYS[keys[k]].expected, name);
    count[k] = po_key_parse_list(keys[k], text[k], value[k]);
    if (!count[k])
      return po_texts_refuse(given, keys[k], "%s", PO_KEYS[keys[k]].expected);
  }
  if (count[0] != count[1]) {
    po_texts_write_name(given, PO_KEY_YOUNG_PA, name);
    return po_texts_refuse(given, PO_KEY_POISSON, "one number for each of %s", name);
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
    return po_texts_refuse(given, key, "it to be left out beside %s, the work of adhesion", name);
  return !given->text[key] || po_key_parse(key, given->text[key], work)
             ? PO_OK
             : po_texts_refuse(given, key, "%s", PO_KEYS[key].expected);
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
      return po_texts_refuse(given, items[i].key, "%s", PO_KEYS[items[i].key].expected);
    if (text || !items[i].needed)
      continue;
    char name[4][PO_KEY_NAME_LENGTH];
    for (size_t k = 0; k < 4; ++k)
      po_texts_write_name(given, items[k].key, name[k]);
    return po_texts_refuse(
        given, items[i].key, "%s; a scene in SI units has %s%s%s, %s and, of a sphere, %s",
        PO_KEYS[items[i].key].expected, name[0], given->any_modulus ? " (if elastic), " : ", ",
        name[1], name[2], name[3]);
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
      status = po_texts_set_key(given, key, request);
  given->wrong = status ? given->wrong : PO_KEY_PROFILE;
  if (!status && !given->text[PO_KEY_PROFILE_FILE])
    status = po_profile_check(&request->scene.profile);
  if (status)
    return status;
  po_profile_rescale(&request->scene.profile, distance);
  status = po_texts_set_key(given, PO_KEY_PROFILE_FILE, request);
  const po_profile_table *table = request->scene.profile.table;
  if (!status && table && table->in_metres && given->text[PO_KEY_TABLE_SCALE])
    return po_texts_refuse(given, PO_KEY_TABLE_SCALE,
                           "it to be left out, as the names of the columns have units");
  return status;
}

po_status po_texts_set_physical(po_texts *given, po_request *request) {
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
  return po_texts_add_waves(given, physical.distance, &request->scene);
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
    return po_texts_refuse(given, PO_KEY_RELAXATION_TIME_S, "%s",
                           PO_KEYS[PO_KEY_RELAXATION_TIME_S].expected);
  if (text && !any)
    return po_texts_refuse(given, PO_KEY_RELAXATION_TIME_S,
                           "it beside a speed in m/s or a time in s");
  if (text && in_seconds && time != 1.0)
    return po_texts_refuse(given, PO_KEY_RELAXATION_TIME_S,
                           "1 or nothing, as the times of the material are "
                           "in s");
  if (!any)
    return PO_OK;
  if (!text && !in_seconds)
    return po_texts_refuse(given, PO_KEY_RELAXATION_TIME_S, "%s, as %s",
                           PO_KEYS[PO_KEY_RELAXATION_TIME_S].expected,
                           unload || load ? "the speed is in m/s" : "the dwell is in s");
  request->unload_speed *= unload ? time / request->units.length : 1.0;
  request->load_speed *= load ? time / request->units.length : 1.0;
  request->dwell /= dwell ? time : 1.0;
  return PO_OK;
}

po_status po_texts_set_in_si(po_texts *given, po_request *request) {
  for (int key = PO_KEY_END; key < PO_KEY_ALL; ++key) {
    const po_key_row *target = &PO_KEYS[po_key_target(key)];
    double value = 0;
    if (!given->text[key] || target->owner != PO_OWNER_TRACE)
      continue;
    if (!po_key_parse(key, given->text[key], &value))
      return po_texts_refuse(given, key, "%s", PO_KEYS[key].expected);
    if (PO_KEYS[key].owner == PO_OWNER_SI)
      value = po_texts_without_unit(key, value, &request->units);
    if (target->place != PO_NO_PLACE)
      *(double *)(void *)((char *)request + target->place) = value;
  }
  return set_times(given, request);
}

void po_texts_set_usual_units(po_request *request) {
  const po_scene solved = po_load_unit_request(request).scene;
  request->units.usual_length = request->units.length * fmax(1.0, solved.tabor);
  request->units.usual_force = request->units.force * po_scene_load_unit(&solved);
}

/* The contact modulus over the relaxed modulus of a table. It is 1/(1 - nu^2) of Young's modulus
 * and 2/(1 - nu) of the shear modulus, from 1 to 4, and half of that if both bodies are of the
 * material; with a tenth to spare for the digits of both. */
static const double LEAST_MODULUS_RATIO = 0.45, GREATEST_MODULUS_RATIO = 4.4;

po_status po_texts_check_material(po_texts *given, const po_request *request) {
  const double relaxed = po_creep_relaxed(&request->creep);
  const double modulus = po_scene_stiffness(&request->scene) * request->units.tension;
  if (!request->in_si || isnan(relaxed) || !isfinite(modulus) ||
      (modulus >= LEAST_MODULUS_RATIO * relaxed && modulus <= GREATEST_MODULUS_RATIO * relaxed))
    return PO_OK;
  return po_texts_refuse(
      given, PO_KEY_VISCOELASTIC,
      "a relaxed modulus from 1/4 to 2 times the contact modulus of the scene, %.4g Pa; in "
      "the table it is %.4g Pa. A column without a unit has ratios alone",
      modulus, relaxed);
}
