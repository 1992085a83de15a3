#include "po_scene_flags.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct {
  const char *name;
  int key; /* the po_key with the same domain of values; -1: none */
} LENGTHS[PO_LENGTH_COUNT] = {
    [PO_LENGTH_RADIUS] = {"radius", PO_KEY_RADIUS},
    [PO_LENGTH_AMPLITUDE] = {"amplitude", PO_KEY_AMPLITUDE},
    [PO_LENGTH_WAVELENGTH] = {"wavelength", PO_KEY_WAVELENGTH},
    [PO_LENGTH_OUTER_RADIUS] = {"outer-radius", PO_KEY_OUTER_RADIUS},
    [PO_LENGTH_APPROACH_START] = {"approach-start", PO_KEY_APPROACH_START},
    [PO_LENGTH_APPROACH_END] = {"approach-end", PO_KEY_APPROACH_END},
    [PO_LENGTH_PROFILE_APPROACH] = {"profile-approach", -1},
    [PO_LENGTH_PRELOAD] = {"preload", PO_KEY_PRELOAD},
    [PO_LENGTH_APPROACH] = {"approach", -1},
    [PO_LENGTH_CONTACT_RADIUS] = {"contact-radius", -1},
};

po_scene_flags po_scene_flags_default(void) {
  po_scene_flags flags = {.tabor = NAN, .modulus = NAN, .work = NAN, .distance = NAN};
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    flags.length[i] = flags.metres[i] = NAN;
  return flags;
}

/* Reads a value in the domain of a key of the scene. */
static po_status take_key(po_key key, const char *name, double *value) {
  po_request scratch = po_request_default();
  if (!po_key_set(&scratch, key, optarg))
    return po_options_refuse(name, optarg, po_key_expected(key));
  *value = po_key_number(&scratch, key);
  return PO_OK;
}

static po_status take_length(po_length length, const char *suffix, double *value) {
  char name[32];
  snprintf(name, sizeof name, "%s%s", LENGTHS[length].name, suffix);
  if (LENGTHS[length].key >= 0)
    return take_key((po_key)LENGTHS[length].key, name, value);
  const bool positive = length == PO_LENGTH_CONTACT_RADIUS;
  if (po_number_parse(optarg, value) && !(positive && *value < 0))
    return PO_OK;
  return po_options_refuse(name, optarg, positive ? "a finite number >= 0" : "a finite number");
}

po_status po_scene_flags_take(po_scene_flags *flags, int option) {
  switch (option) {
  case PO_FLAG_FROM_PHYSICAL:
    flags->from_physical = true;
    return PO_OK;
  case PO_FLAG_TABOR:
    return take_key(PO_KEY_TABOR, "tabor", &flags->tabor);
  case PO_FLAG_MODULUS: /* its domain is that of an outer radius; that of work and distance, of a
                           radius */
    return take_key(PO_KEY_OUTER_RADIUS, "modulus-pa", &flags->modulus);
  case PO_FLAG_WORK:
    return take_key(PO_KEY_RADIUS, "work-j-per-m2", &flags->work);
  case PO_FLAG_DISTANCE:
    return take_key(PO_KEY_RADIUS, "distance-m", &flags->distance);
  default:
    if (option < PO_FLAG_METRES)
      return take_length((po_length)(option - PO_FLAG_LENGTH), "",
                         &flags->length[option - PO_FLAG_LENGTH]);
    return take_length((po_length)(option - PO_FLAG_METRES), "-m",
                       &flags->metres[option - PO_FLAG_METRES]);
  }
}

void po_scene_flags_name(const po_scene_flags *flags, po_length length, char name[32]) {
  snprintf(name, 32, "%s%s", LENGTHS[length].name, flags->from_physical ? "-m" : "");
}

static po_status refuse_si(const char *name, const char *suffix) {
  return po_fail(PO_BAD_INPUT, "--%s%s is in SI units: expected --from-physical, too", name,
                 suffix);
}

static po_status end_dimensionless(const po_scene_flags *flags, po_scene *scene) {
  if (!isnan(flags->modulus))
    return refuse_si("modulus-pa", "");
  if (!isnan(flags->work))
    return refuse_si("work-j-per-m2", "");
  if (!isnan(flags->distance))
    return refuse_si("distance-m", "");
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    if (!isnan(flags->metres[i]))
      return refuse_si(LENGTHS[i].name, "-m");
  double *const places[] = {&scene->radius, &scene->amplitude, &scene->wavelength,
                            &scene->outer_radius};
  for (int i = 0; i <= PO_LENGTH_OUTER_RADIUS; ++i)
    if (!isnan(flags->length[i]))
      *places[i] = flags->length[i];
  if (!isnan(flags->tabor))
    scene->tabor = flags->tabor;
  return PO_OK;
}

/* Names all missing options in one message. */
static po_status require_all(const po_scene_flags *flags, bool elastic) {
  const struct {
    const char *name;
    double value;
  } needed[] = {{"--modulus-pa", elastic ? flags->modulus : 0},
                {"--work-j-per-m2", flags->work},
                {"--distance-m", flags->distance},
                {"--radius-m", flags->metres[PO_LENGTH_RADIUS]}};
  char missing[100] = "";
  for (size_t i = 0; i < sizeof needed / sizeof *needed; ++i)
    if (isnan(needed[i].value))
      snprintf(missing + strlen(missing), sizeof missing - strlen(missing), "%s%s",
               *missing ? ", " : "", needed[i].name);
  return *missing ? po_fail(PO_BAD_INPUT,
                            "--from-physical is given without %s: expected these, too", missing)
                  : PO_OK;
}

static po_status end_physical(po_scene_flags *flags, bool elastic, po_scene *scene) {
  if (!isnan(flags->tabor))
    return po_fail(PO_BAD_INPUT, "--tabor is given with --from-physical: expected --modulus-pa, "
                                 "--work-j-per-m2, --distance-m and --radius-m, from which it is "
                                 "computed");
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    if (!isnan(flags->length[i]))
      return po_fail(PO_BAD_INPUT,
                     "--%s is in units of epsilon: expected --%s-m with --from-physical",
                     LENGTHS[i].name, LENGTHS[i].name);
  po_status status = require_all(flags, elastic);
  if (status)
    return status;
  const double *m = flags->metres;
  const bool wavy = !isnan(m[PO_LENGTH_AMPLITUDE]) && !isnan(m[PO_LENGTH_WAVELENGTH]);
  const po_physical physical = {
      .modulus = isnan(flags->modulus) ? (double)INFINITY : flags->modulus,
      .work = flags->work,
      .distance = flags->distance,
      .radius = m[PO_LENGTH_RADIUS],
      .amplitude = wavy ? m[PO_LENGTH_AMPLITUDE] : 0,
      .wavelength = wavy ? m[PO_LENGTH_WAVELENGTH] : 0,
      .outer_radius =
          isnan(m[PO_LENGTH_OUTER_RADIUS]) ? (double)INFINITY : m[PO_LENGTH_OUTER_RADIUS]};
  status = po_physical_scene(&physical, scene);
  if (status)
    return status;
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    flags->length[i] = m[i] / flags->distance;
  if (!isnan(flags->length[PO_LENGTH_AMPLITUDE])) /* also if --alpha replaces the wavelength */
    scene->amplitude = flags->length[PO_LENGTH_AMPLITUDE];
  flags->units = po_physical_units(&physical, scene);
  return PO_OK;
}

po_status po_scene_flags_end(po_scene_flags *flags, bool elastic, po_scene *scene) {
  return flags->from_physical ? end_physical(flags, elastic, scene)
                              : end_dimensionless(flags, scene);
}

po_status po_scene_flags_check_law(const po_law *law, const bool given[PO_LAW_PARAMETER_COUNT]) {
  for (int k = 0; k < PO_LAW_PARAMETER_COUNT; ++k)
    if (given[k] && !po_law_has(law, (po_law_parameter)k)) {
      char flag[32];
      snprintf(flag, sizeof flag, "%s", po_law_parameter_name((po_law_parameter)k));
      *strchr(flag, '_') = '-';
      return po_fail(PO_BAD_INPUT, "--%s has no effect on the law %s: expected --law %.*s", flag,
                     po_law_name(law), (int)strcspn(flag, "-"), flag);
    }
  return PO_OK;
}
