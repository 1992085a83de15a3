/* The options that describe a scene, for the verbs that take one: dimensionless with lengths in
 * epsilon, or in SI units after --from-physical. The two kinds cannot be mixed. */
#ifndef PO_SCENE_FLAGS_H
#define PO_SCENE_FLAGS_H

#include <stdbool.h>

#include "po_input.h"
#include "po_options.h"
#include "po_physical.h"

/* Lengths that can be given: --NAME is in epsilon, --NAME-m in metres. */
typedef enum {
  PO_LENGTH_RADIUS,
  PO_LENGTH_AMPLITUDE,
  PO_LENGTH_WAVELENGTH,
  PO_LENGTH_OUTER_RADIUS,
  PO_LENGTH_APPROACH_START,
  PO_LENGTH_APPROACH_END,
  PO_LENGTH_PRELOAD,
  PO_LENGTH_PROFILE_APPROACH,
  PO_LENGTH_APPROACH,
  PO_LENGTH_CONTACT_RADIUS,
  PO_LENGTH_COUNT
} po_length;

/* Values of the options below. Those of the verb's own options begin at PO_FLAG_NEXT. */
enum {
  PO_FLAG_FROM_PHYSICAL = 1,
  PO_FLAG_TABOR,
  PO_FLAG_MODULUS,
  PO_FLAG_WORK,
  PO_FLAG_DISTANCE,
  PO_FLAG_COUPLING,
  PO_FLAG_PROFILE,
  PO_FLAG_PROFILE_FILE,
  PO_FLAG_WAVE,
  PO_FLAG_PARAMETER, /* of the profile */
  PO_FLAG_LENGTH = PO_FLAG_PARAMETER + PO_PROFILE_PARAMETER_COUNT,
  PO_FLAG_METRES = PO_FLAG_LENGTH + PO_LENGTH_COUNT,
  PO_FLAG_NEXT = PO_FLAG_METRES + PO_LENGTH_COUNT
};

// clang-format off
#define PO_LENGTH_OPTIONS(name, length)                                                            \
  {name, required_argument, NULL, PO_FLAG_LENGTH + (length)},                                      \
  {name "-m", required_argument, NULL, PO_FLAG_METRES + (length)}

/* The options that only --from-physical takes. */
#define PO_PHYSICAL_OPTIONS                                                                        \
  {"from-physical", no_argument, NULL, PO_FLAG_FROM_PHYSICAL},                                     \
  {"modulus-pa", required_argument, NULL, PO_FLAG_MODULUS},                                        \
  {"work-j-per-m2", required_argument, NULL, PO_FLAG_WORK},                                        \
  {"distance-m", required_argument, NULL, PO_FLAG_DISTANCE}
// clang-format on

/* The SI options in the help of a verb. The verb documents its other lengths itself. */
#define PO_SCENE_FLAGS_HELP                                                                        \
  "SI units:\n"                                                                                    \
  "  --from-physical         take the scene in SI units and print the results in both units;\n"    \
  "                          lengths are then given by options that end in -m, such as\n"          \
  "                          --amplitude-m\n"                                                      \
  "  --modulus-pa E          contact modulus E* of the two bodies, in Pa; inf is a rigid sphere\n" \
  "  --work-j-per-m2 W       work of adhesion, in J/m^2\n"                                         \
  "  --distance-m EPSILON    equilibrium distance, in m\n"                                         \
  "  --radius-m R            radius of the sphere, in m; may be missing for other profiles\n"      \
  "  --profile, --profile-file, --wave and the parameters of the profile are then in m, too;\n"    \
  "                          C of --profile power in m^(1-N)\n"

typedef struct {
  bool from_physical;
  bool warned; /* whether _end need not warn of lengths that look like metres */
  double tabor, modulus, work, distance; /* NAN: not given; the same for the lengths */
  double length[PO_LENGTH_COUNT];        /* in epsilon; after _end, also those given in metres */
  double metres[PO_LENGTH_COUNT];
  double coupling;
  const char *profile, *profile_file;           /* NULL: not given */
  double parameter[PO_PROFILE_PARAMETER_COUNT]; /* of the profile */
  po_wave wave[PO_MOST_WAVES];                  /* of --wave; in metres with --from-physical */
  size_t waves;
  char shown[128]; /* the profile with its parameters as they were given; empty: the sphere */
  po_units units;  /* of a scene in SI units; set by _end */
} po_scene_flags;

/* No option given. */
po_scene_flags po_scene_flags_default(void);

/* Stores one option whose value is below PO_FLAG_NEXT. Status: PO_BAD_INPUT. */
po_status po_scene_flags_take(po_scene_flags *flags, int option);

/* Refuses a mixture of both kinds and names the missing options of a scene in SI units. Then fills
 * *scene; values that were not given keep what is in it. The modulus may be missing if `elastic` is
 * false. Status: PO_BAD_INPUT. */
po_status po_scene_flags_end(po_scene_flags *flags, bool elastic, po_scene *scene);

/* Refuses a parameter that the law of the scene does not have. `given`: whether each key was given.
 * Status: PO_BAD_INPUT. */
po_status po_scene_flags_check_law(const po_law *law, const bool given[PO_KEY_END]);

/* Stores one more wave, which optarg gives as "A,L". Status: PO_BAD_INPUT. */
po_status po_scene_flags_take_wave(po_wave wave[PO_MOST_WAVES], size_t *count);

/* Adds waves to those of a scene. Given: the unit of their lengths, in epsilon. Status:
 * PO_BAD_INPUT. */
po_status po_scene_flags_add_waves(const po_wave *wave, size_t count, double unit, po_scene *scene);

/* The length that is a key; -1: none. */
int po_length_of_key(int key);

/* The name of the option for a length: "radius", or "radius-m" if the scene is in SI units. */
void po_scene_flags_name(const po_scene_flags *flags, po_length length, char name[32]);

#endif
