#include "po_scene.h"

#include <math.h>
#include <string.h>

#include "po_elementary.h"
#include "po_number.h"

po_scene po_scene_default(void) {
  return (po_scene){.tabor = 1.0,
                    .radius = 100.0,
                    .outer_radius = INFINITY,
                    .law = po_law_lennard_jones(),
                    .profile = po_profile_sphere()};
}

static po_status require(bool holds, const char *key, double value, const char *expected) {
  return holds ? PO_OK : po_fail(PO_BAD_INPUT, "%s is %g: expected %s", key, value, expected);
}

/* The traction of an unbounded surface falls as r^-mN far out, with the powers m of the law and N
 * of the profile. The load of a sphere is finite for m > 1, its energy for m > 2. A cone under the
 * law of the paper has mN = 3; the integrals over the panel to infinity need as much. */
static const double LEAST_EXPONENT = 2.0, SLOWEST_DECAY = 3.0 - 1e-9;

static po_status check_far_field(const po_scene *scene) {
  const po_law_numbers *far = po_law_numbers_of(&scene->law);
  const double growth = po_profile_shape(&scene->profile).growth;
  if (isfinite(scene->outer_radius) || isinf(far->exponent))
    return PO_OK;
  if (!(far->exponent > LEAST_EXPONENT))
    return po_fail(PO_BAD_INPUT,
                   "mie_m is %g: the far field of an unbounded surface falls too slowly; "
                   "expected more than %g, or an outer radius",
                   far->exponent, LEAST_EXPONENT);
  if (!(far->exponent * growth >= SLOWEST_DECAY))
    return po_fail(PO_BAD_INPUT,
                   "the profile grows as r^%g far out, and the law falls as gap^-%g: the far field "
                   "of an unbounded surface falls too slowly; expected an outer radius%s",
                   growth, far->exponent,
                   po_profile_is_table(&scene->profile)
                       ? ", or smooth if the rows of the table have noise"
                       : "");
  return PO_OK;
}

static po_status check_waves(const po_scene *scene) {
  po_status status = PO_OK;
  for (size_t k = 1; k < po_scene_waves(scene) && !status; ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    status = require(isfinite(wave.amplitude) && wave.amplitude > 0.0, "the amplitude of a wave",
                     wave.amplitude, "a finite number > 0");
    if (!status)
      status = require(isfinite(wave.length) && wave.length > 0.0, "the length of a wave",
                       wave.length, "a finite number > 0");
  }
  return status;
}

po_status po_scene_check(const po_scene *scene) {
  po_status status = require(isfinite(scene->tabor) && scene->tabor >= 0.0, "tabor", scene->tabor,
                             "a finite number >= 0");
  if (!status)
    status = require(isfinite(scene->amplitude) && scene->amplitude >= 0.0, "amplitude",
                     scene->amplitude, "a finite number >= 0");
  if (!status)
    status = require(isfinite(scene->wavelength) && scene->wavelength >= 0.0, "wavelength",
                     scene->wavelength, "a finite number >= 0");
  if (!status)
    status = require(scene->amplitude == 0.0 || scene->wavelength > 0.0, "wavelength",
                     scene->wavelength, "a finite number > 0 when amplitude is not 0");
  if (!status)
    status = require(isfinite(scene->radius) && scene->radius > 0.0, "radius", scene->radius,
                     "a finite number > 0");
  if (!status)
    status = require(scene->outer_radius > 0.0, "outer_radius", scene->outer_radius,
                     "a number > 0, or inf");
  if (!status)
    status = check_waves(scene);
  if (!status)
    status = po_law_check(&scene->law);
  if (!status)
    status = po_profile_check(&scene->profile);
  if (!status)
    status = check_far_field(scene);
  return status;
}

bool po_scene_is_wavy(const po_scene *scene) {
  return scene->amplitude > 0.0;
}

size_t po_scene_waves(const po_scene *scene) {
  return po_scene_is_wavy(scene) ? 1 + scene->more_waves : 0;
}

po_wave po_scene_wave(const po_scene *scene, size_t k) {
  return k > 0 ? scene->more[k - 1] : (po_wave){scene->amplitude, scene->wavelength};
}

bool po_scene_add_wave(po_scene *scene, po_wave wave) {
  if (po_scene_waves(scene) == PO_MOST_WAVES)
    return false;
  if (po_scene_is_wavy(scene)) {
    scene->more[scene->more_waves++] = wave;
  } else {
    scene->amplitude = wave.amplitude;
    scene->wavelength = wave.length;
    scene->more_waves = 0;
  }
  return true;
}

/* Reads "A@L" up to the end or a semicolon. */
static bool read_wave(const char *text, size_t length, po_wave *wave) {
  char copy[2 * PO_NUMBER_LENGTH];
  if (length >= sizeof copy)
    return false;
  memcpy(copy, text, length);
  copy[length] = '\0';
  char *at = strchr(copy, '@');
  if (!at)
    return false;
  *at = '\0';
  return po_number_parse(copy, &wave->amplitude) && po_number_parse(at + 1, &wave->length) &&
         wave->amplitude > 0.0 && wave->length > 0.0;
}

bool po_scene_set_waves(po_scene *scene, const char *text) {
  po_scene set = *scene;
  set.amplitude = 0.0;
  set.more_waves = 0;
  const bool none = strcmp(text, "-") == 0;
  while (!none) {
    po_wave wave;
    const size_t length = strcspn(text, ";");
    if (!read_wave(text, length, &wave) || !po_scene_add_wave(&set, wave))
      return false;
    text += length;
    if (!*text)
      break;
    ++text;
  }
  *scene = set;
  return true;
}

bool po_scene_is_simple(const po_scene *scene) {
  return !po_scene_is_wavy(scene) && po_profile_shape(&scene->profile).is_convex;
}

bool po_scene_is_of_paper(const po_scene *scene) {
  return po_profile_is_sphere(&scene->profile) && po_scene_waves(scene) < 2;
}

/* Where the power of the energy exceeds 2 by less than this, the energy far out is more than ten
 * thousand times that of the contact, and the rounding of N decides it: the rows of a cone may give
 * N = 1 + 1e-7. */
static const double BARELY_FINITE = 1e-4;

bool po_scene_has_infinite_energy(const po_scene *scene) {
  const double fall = po_law_numbers_of(&scene->law)->exponent - 1.0;
  return isinf(scene->outer_radius) &&
         fall * po_profile_shape(&scene->profile).growth <= 2.0 + BARELY_FINITE;
}

/* The greatest decay on a panel to infinity. Its outermost node is at 1/0.0053 of its beginning,
 * where r^132 times the square of a radius of 1e8 eps overflows. */
static const double STEEPEST_DECAY = 130.0;

/* Part of the work of adhesion that is nothing beside it. With a decay above STEEPEST_DECAY it is
 * left at 1.4 times the radius at which half of the attraction is left, or nearer. */
static const double NOTHING = 1e-18;

double po_scene_decay(const po_scene *scene) {
  const double decay =
      po_law_numbers_of(&scene->law)->exponent * po_profile_shape(&scene->profile).growth;
  return decay > STEEPEST_DECAY ? INFINITY : decay;
}

double po_scene_reach(const po_scene *scene) {
  const po_law_numbers *far = po_law_numbers_of(&scene->law);
  if (isinf(far->exponent) || isfinite(po_scene_decay(scene)))
    return far->reach;
  return fmax(far->reach, po_pow(NOTHING, -1.0 / (far->exponent - 1.0)));
}

double po_scene_load_unit(const po_scene *scene) {
  return scene->load_unit > 0.0 ? scene->load_unit : 1.0;
}

double po_scene_length_unit(const po_scene *scene) {
  return scene->length_unit > 0.0 ? scene->length_unit : 1.0;
}

double po_scene_coupling(const po_scene *scene) {
  return scene->tabor * sqrt(scene->tabor / scene->radius);
}

double po_scene_tabor_of_coupling(double coupling, double radius) {
  return po_cbrt(coupling) * po_cbrt(coupling) * po_cbrt(radius);
}

double po_scene_gamma(const po_scene *scene) {
  const double product = scene->radius * scene->tabor;
  return isnormal(product) ? sqrt(product) : sqrt(scene->radius) * sqrt(scene->tabor);
}

double po_scene_stiffness(const po_scene *scene) {
  const double mu = scene->tabor, ratio = scene->radius / (mu * mu * mu);
  return isnormal(mu * mu * mu) && isnormal(ratio) ? sqrt(ratio) : sqrt(scene->radius / mu) / mu;
}

double po_scene_alpha(const po_scene *scene) {
  if (!po_scene_is_wavy(scene))
    return 0.0;
  return scene->amplitude * scene->radius / (scene->wavelength * scene->wavelength);
}
