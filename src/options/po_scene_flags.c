#include "po_scene_flags.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_options.h"
#include "po_parameters.h"

po_scene_flags po_scene_flags_default(void) {
  po_scene_flags flags = {
      .tabor = NAN, .modulus = NAN, .work = NAN, .distance = NAN, .coupling = NAN};
  for (int k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    flags.parameter[k] = NAN;
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
  snprintf(name, sizeof name, "%s%s", PO_LENGTHS[length].name, suffix);
  if (PO_LENGTHS[length].key >= 0)
    return take_key((po_key)PO_LENGTHS[length].key, name, value);
  const bool positive = length == PO_LENGTH_CONTACT_RADIUS;
  if (po_number_parse(optarg, value) && !(positive && *value < 0))
    return PO_OK;
  return po_options_refuse(name, optarg, positive ? "a finite number >= 0" : "a finite number");
}

po_status po_scene_flags_take_wave(po_wave wave[PO_MOST_WAVES], size_t *count) {
  double values[2];
  if (*count == PO_MOST_WAVES)
    return po_fail(PO_BAD_INPUT, "--wave is given more than %d times: expected at most %d waves",
                   PO_MOST_WAVES, PO_MOST_WAVES);
  if (!po_parameters_read(optarg, 2, values) || !(values[0] > 0.0 && values[1] > 0.0))
    return po_options_refuse("wave", optarg, "A,L: amplitude and wavelength, two numbers > 0");
  wave[(*count)++] = (po_wave){values[0], values[1]};
  return PO_OK;
}

/* Adds waves to those of a scene. Given: the unit of their lengths, in epsilon. Status:
 * PO_BAD_INPUT. */
static po_status scene_flags_add_waves(const po_wave *wave, size_t count, double unit,
                                       po_scene *scene) {
  for (size_t k = 0; k < count; ++k)
    if (!po_scene_add_wave(scene, (po_wave){wave[k].amplitude * unit, wave[k].length * unit}))
      return po_fail(PO_BAD_INPUT,
                     "--wave is given %zu times beside --amplitude: expected at most %d waves",
                     count, PO_MOST_WAVES);
  return PO_OK;
}

static po_status take_profile(po_scene_flags *flags) {
  po_profile scratch = po_profile_sphere();
  flags->profile = optarg;
  return po_profile_set(&scratch, optarg)
             ? PO_OK
             : po_options_refuse("profile", optarg, PO_PROFILE_EXPECTED);
}

static po_status take_parameter(po_profile_parameter parameter, double *value) {
  char name[PO_FLAG_LENGTH_OF_NAME];
  const int key = po_key_of_name(po_profile_parameter_name(parameter));
  po_key_flag(key, name);
  if (parameter == PO_TABLE_SMOOTH && strcmp(optarg, "auto") == 0) {
    *value = INFINITY;
    return PO_OK;
  }
  return po_number_parse(optarg, value) && *value > 0.0
             ? PO_OK
             : po_options_refuse(name, optarg, po_key_expected((po_key)key));
}

po_status po_scene_flags_take(po_scene_flags *flags, int option) {
  switch (option) {
  case PO_FLAG_FROM_PHYSICAL:
    flags->from_physical = true;
    return PO_OK;
  case PO_FLAG_TABOR:
    return take_key(PO_KEY_TABOR, "tabor", &flags->tabor);
  case PO_FLAG_MODULUS: /* like an outer radius: a finite number > 0, or inf */
    return take_key(PO_KEY_OUTER_RADIUS, "modulus-pa", &flags->modulus);
  case PO_FLAG_WORK: /* like a radius: a finite number > 0 */
    return take_key(PO_KEY_RADIUS, "work-j-per-m2", &flags->work);
  case PO_FLAG_DISTANCE:
    return take_key(PO_KEY_RADIUS, "distance-m", &flags->distance);
  case PO_FLAG_COUPLING:
    if (po_number_parse(optarg, &flags->coupling) && flags->coupling >= 0.0)
      return PO_OK;
    return po_options_refuse("coupling", optarg, po_key_expected(PO_KEY_COUPLING));
  case PO_FLAG_PROFILE:
    return take_profile(flags);
  case PO_FLAG_PROFILE_FILE:
    return po_options_take_text("profile-file", "the name of a file", &flags->profile_file);
  case PO_FLAG_WAVE:
    return po_scene_flags_take_wave(flags->wave, &flags->waves);
  default:
    if (option < PO_FLAG_LENGTH)
      return take_parameter((po_profile_parameter)(option - PO_FLAG_PARAMETER),
                            &flags->parameter[option - PO_FLAG_PARAMETER]);
    if (option < PO_FLAG_METRES)
      return take_length((po_length)(option - PO_FLAG_LENGTH), "",
                         &flags->length[option - PO_FLAG_LENGTH]);
    return take_length((po_length)(option - PO_FLAG_METRES), "-m",
                       &flags->metres[option - PO_FLAG_METRES]);
  }
}

void po_scene_flags_name(const po_scene_flags *flags, po_length length, char name[32]) {
  snprintf(name, 32, "%s%s", PO_LENGTHS[length].name, flags->from_physical ? "-m" : "");
}

static po_status refuse_si(const char *name, const char *suffix) {
  return po_fail(PO_BAD_INPUT, "--%s%s is in SI units: expected --from-physical, too", name,
                 suffix);
}

/* Writes the name of a profile and its parameters. */
static void show_profile(const po_profile *profile, char *shown, size_t size) {
  char number[PO_NUMBER_LENGTH];
  int length = snprintf(shown, size, "%s", po_profile_name(profile));
  for (int k = 0, named = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    if (po_profile_has(profile, (po_profile_parameter)k)) {
      po_number_print(profile->parameter[k], number);
      length +=
          snprintf(shown + length, size - (size_t)length, "%c%s", named++ ? ',' : ':', number);
    }
}

/* Refuses a parameter of another law or profile: "mie_m" belongs to `mie`. */
static po_status refuse_parameter(const char *what, const char *name, int key) {
  char flag[PO_FLAG_LENGTH_OF_NAME];
  po_key_flag(key, flag);
  const int length = (int)strcspn(flag, "-");
  if (key == PO_KEY_TABLE_SCALE || key == PO_KEY_SMOOTH)
    return po_fail(PO_BAD_INPUT, "--%s has no effect on the %s %s: expected --profile-file", flag,
                   what, name);
  return po_fail(PO_BAD_INPUT, "--%s has no effect on the %s %s: expected --%s %.*s", flag, what,
                 name, what, length, flag);
}

po_status po_scene_flags_check_law(const po_law *law, const bool given[PO_KEY_END]) {
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (given[key] && po_key_is_parameter(key, PO_OWNER_LAW) &&
        !po_law_has(law, (po_law_parameter)po_key_parameter(key)))
      return refuse_parameter("law", po_law_name(law), key);
  return PO_OK;
}

/* Refuses a parameter that the profile of the scene does not have. */
static po_status check_profile(const po_profile *profile,
                               const bool given[PO_PROFILE_PARAMETER_COUNT]) {
  for (int k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    if (given[k] && !po_profile_has(profile, (po_profile_parameter)k))
      return refuse_parameter("profile", po_profile_name(profile),
                              po_key_of_name(po_profile_parameter_name((po_profile_parameter)k)));
  return PO_OK;
}

/* Sets the profile and its default radius. Given: epsilon in the unit of the parameters. */
static po_status set_profile(po_scene_flags *flags, double epsilon, po_scene *scene) {
  bool given[PO_PROFILE_PARAMETER_COUNT];
  po_status status = PO_OK;
  if (flags->profile && flags->profile_file)
    return po_fail(PO_BAD_INPUT, "both --profile and --profile-file are given: expected only one");
  for (int k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k) {
    given[k] = !isnan(flags->parameter[k]);
    if (given[k])
      po_profile_set_parameter(&scene->profile, (po_profile_parameter)k, flags->parameter[k]);
  }
  if (flags->profile)
    po_profile_set(&scene->profile, flags->profile);
  if (!flags->profile_file)
    status = po_profile_check(&scene->profile);
  if (flags->profile)
    show_profile(&scene->profile, flags->shown, sizeof flags->shown);
  if (epsilon != 1.0)
    po_profile_rescale(&scene->profile, epsilon);
  if (flags->profile_file)
    status = po_profile_set_file(&scene->profile, flags->profile_file);
  if (!status)
    status = check_profile(&scene->profile, given);
  if (flags->profile || flags->profile_file)
    scene->radius = po_profile_default_radius(&scene->profile);
  return status;
}

static po_status end_dimensionless(po_scene_flags *flags, po_scene *scene) {
  if (!isnan(flags->modulus))
    return refuse_si("modulus-pa", "");
  if (!isnan(flags->work))
    return refuse_si("work-j-per-m2", "");
  if (!isnan(flags->distance))
    return refuse_si("distance-m", "");
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    if (!isnan(flags->metres[i]))
      return refuse_si(PO_LENGTHS[i].name, "-m");
  if (!isnan(flags->coupling) && !isnan(flags->tabor))
    return po_fail(PO_BAD_INPUT, "both --coupling and --tabor are given: expected only one");
  const po_status status = set_profile(flags, 1.0, scene);
  if (status)
    return status;
  double *const places[] = {&scene->radius, &scene->amplitude, &scene->wavelength,
                            &scene->outer_radius};
  for (int i = 0; i <= PO_LENGTH_OUTER_RADIUS; ++i)
    if (!isnan(flags->length[i]))
      *places[i] = flags->length[i];
  if (!isnan(flags->tabor))
    scene->tabor = flags->tabor;
  if (!isnan(flags->coupling))
    scene->tabor = po_scene_tabor_of_coupling(flags->coupling, scene->radius);
  return scene_flags_add_waves(flags->wave, flags->waves, 1.0, scene);
}

static bool has_sphere(const po_scene_flags *flags) {
  return !flags->profile_file && (!flags->profile || strcmp(flags->profile, "sphere") == 0);
}

/* Names all missing options in one message. */
static po_status require_all(const po_scene_flags *flags, bool elastic) {
  const struct {
    const char *name;
    double value;
  } needed[] = {{"--modulus-pa", elastic ? flags->modulus : 0},
                {"--work-j-per-m2", flags->work},
                {"--distance-m", flags->distance},
                {"--radius-m", has_sphere(flags) ? flags->metres[PO_LENGTH_RADIUS] : 0}};
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
                     PO_LENGTHS[i].name, PO_LENGTHS[i].name);
  if (!isnan(flags->coupling))
    return po_fail(PO_BAD_INPUT, "--coupling is given with --from-physical: expected --modulus-pa, "
                                 "--work-j-per-m2 and --distance-m, from which it is computed");
  po_status status = require_all(flags, elastic);
  if (status)
    return status;
  const double *m = flags->metres;
  const bool wavy = !isnan(m[PO_LENGTH_AMPLITUDE]) && !isnan(m[PO_LENGTH_WAVELENGTH]);
  const po_physical physical = {
      .modulus = isnan(flags->modulus) ? (double)INFINITY : flags->modulus,
      .work = flags->work,
      .distance = flags->distance,
      .radius = isnan(m[PO_LENGTH_RADIUS]) ? flags->distance : m[PO_LENGTH_RADIUS],
      .amplitude = wavy ? m[PO_LENGTH_AMPLITUDE] : 0,
      .wavelength = wavy ? m[PO_LENGTH_WAVELENGTH] : 0,
      .outer_radius =
          isnan(m[PO_LENGTH_OUTER_RADIUS]) ? (double)INFINITY : m[PO_LENGTH_OUTER_RADIUS]};
  status = set_profile(flags, flags->distance, scene);
  if (!status)
    status = po_physical_scene(&physical, scene);
  if (status)
    return status;
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    flags->length[i] = m[i] / flags->distance;
  if (!isnan(flags->length[PO_LENGTH_AMPLITUDE])) /* also if --alpha replaces the wavelength */
    scene->amplitude = flags->length[PO_LENGTH_AMPLITUDE];
  flags->units = po_physical_units(&physical, scene);
  return scene_flags_add_waves(flags->wave, flags->waves, 1.0 / flags->distance, scene);
}

/* Warns of lengths in epsilon that only make sense as metres. */
static void warn_of_metres(const po_scene_flags *flags) {
  /* Much less than an atom, for a radius; still less for the waves, which may be extreme. */
  const double least_radius = 1e-2, least_wave = 1e-6;
  const double *length = flags->length;
  const double amplitude = length[PO_LENGTH_AMPLITUDE], wavelength = length[PO_LENGTH_WAVELENGTH];
  po_length suspect = PO_LENGTH_COUNT;
  if (length[PO_LENGTH_RADIUS] < least_radius)
    suspect = PO_LENGTH_RADIUS;
  else if (amplitude > 0 && amplitude < least_wave && wavelength < least_wave)
    suspect = PO_LENGTH_WAVELENGTH;
  if (suspect < PO_LENGTH_COUNT)
    fprintf(stderr,
            "pulloff: warning: --%s is %g epsilon, which looks like metres: for SI units, use "
            "--from-physical and --%s-m\n",
            PO_LENGTHS[suspect].name, length[suspect], PO_LENGTHS[suspect].name);
}

po_status po_scene_flags_end(po_scene_flags *flags, bool elastic, po_scene *scene) {
  if (!flags->from_physical && !flags->warned)
    warn_of_metres(flags);
  return flags->from_physical ? end_physical(flags, elastic, scene)
                              : end_dimensionless(flags, scene);
}
