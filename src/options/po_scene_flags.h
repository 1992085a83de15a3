/* The options that describe a scene, for the verbs that take one: dimensionless with lengths in
 * epsilon, or in SI units after --from-physical. The two kinds cannot be mixed. */
#ifndef PO_SCENE_FLAGS_H
#define PO_SCENE_FLAGS_H

#include <stdbool.h>

#include "po_input.h"
#include "po_options.h"
#include "po_physical.h"

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

/* The name of the option for a length: "radius", or "radius-m" if the scene is in SI units. */
void po_scene_flags_name(const po_scene_flags *flags, po_length length, char name[32]);

#endif
