#include "po_scene_options.h"

#include <stdio.h>
#include <string.h>

#include "po_parameters.h"

po_scene_options po_scene_options_begin(void) {
  return (po_scene_options){.given = {.prefix = "--"}};
}

/* Appends a wave, which is given as "A,L", to the text of all. */
static po_status take_wave(po_scene_options *options) {
  double values[2];
  const size_t length = strlen(options->waves);
  if (!po_parameters_read(optarg, 2, values) || !(values[0] > 0.0 && values[1] > 0.0))
    return po_options_refuse("wave", optarg, "A,L: amplitude and wavelength, two numbers > 0");
  const int end =
      snprintf(options->waves + length, sizeof options->waves - length, "%s%.*s@%s",
               length ? ";" : "", (int)strcspn(optarg, ","), optarg, strchr(optarg, ',') + 1);
  options->given.text[PO_KEY_WAVES] = options->waves;
  po_scene scratch = po_scene_default();
  return length + (size_t)end < sizeof options->waves &&
                 po_scene_set_waves(&scratch, options->waves)
             ? PO_OK
             : po_options_refuse("wave", optarg, "at most 8 waves");
}

po_status po_scene_options_take(void *to, int option) {
  po_scene_options *options = to;
  const int key = option - PO_OPTION_KEYS;
  if (option == PO_OPTION_PHYSICAL)
    options->given.si = true;
  else if (key == PO_KEY_WAVES)
    return take_wave(options);
  else if (key == PO_KEY_PROFILE_FILE)
    return po_options_take_text("profile-file", "the name of a file", &options->given.text[key]);
  else
    options->given.text[key] = optarg;
  return PO_OK;
}

void po_scene_options_warn(const po_given *given) {
  /* Much less than an atom, for a radius; still less for the waves, which may be extreme. */
  const double least_radius = 1e-2, least_wave = 1e-6;
  if (given->si)
    return;
  const double amplitude = po_given_number(given, PO_KEY_AMPLITUDE, NULL);
  const double wavelength = po_given_number(given, PO_KEY_WAVELENGTH, NULL);
  const double radius = po_given_number(given, PO_KEY_RADIUS, NULL);
  const bool waves = amplitude > 0 && amplitude < least_wave && wavelength < least_wave;
  if (radius < least_radius || waves)
    fprintf(stderr,
            "pulloff: warning: --%s is %g epsilon, which looks like metres: for SI units, use "
            "--from-physical and --%s-m\n",
            radius < least_radius ? "radius" : "wavelength",
            radius < least_radius ? radius : wavelength,
            radius < least_radius ? "radius" : "wavelength");
}
