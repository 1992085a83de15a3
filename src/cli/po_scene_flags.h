/* The flags that say what is pressed, shared by the verbs that take a scene: dimensionless, in
 * units of epsilon, or in SI units after --from-physical. Never both. */
#ifndef PO_SCENE_FLAGS_H
#define PO_SCENE_FLAGS_H

#include <stdbool.h>

#include "po_input.h"
#include "po_options.h"
#include "po_physical.h"

/* Lengths that can be given, as --NAME in epsilon or as --NAME-m in metres. */
typedef enum {
  PO_LENGTH_RADIUS,
  PO_LENGTH_AMPLITUDE,
  PO_LENGTH_WAVELENGTH,
  PO_LENGTH_OUTER_RADIUS,
  PO_LENGTH_APPROACH_START,
  PO_LENGTH_APPROACH_END,
  PO_LENGTH_PROFILE_APPROACH,
  PO_LENGTH_PRELOAD,
  PO_LENGTH_APPROACH,
  PO_LENGTH_CONTACT_RADIUS,
  PO_LENGTH_COUNT
} po_length;

/* Values of the options below; a verb's own begin at PO_FLAG_NEXT. */
enum {
  PO_FLAG_FROM_PHYSICAL = 1,
  PO_FLAG_TABOR,
  PO_FLAG_MODULUS,
  PO_FLAG_WORK,
  PO_FLAG_DISTANCE,
  PO_FLAG_LENGTH,
  PO_FLAG_METRES = PO_FLAG_LENGTH + PO_LENGTH_COUNT,
  PO_FLAG_NEXT = PO_FLAG_METRES + PO_LENGTH_COUNT
};

// clang-format off
#define PO_LENGTH_OPTIONS(name, length)                                                            \
  {name, required_argument, NULL, PO_FLAG_LENGTH + (length)},                                      \
  {name "-m", required_argument, NULL, PO_FLAG_METRES + (length)}

/* For the option table of a verb. */
#define PO_SCENE_OPTIONS                                                                           \
  {"tabor", required_argument, NULL, PO_FLAG_TABOR},                                               \
  {"from-physical", no_argument, NULL, PO_FLAG_FROM_PHYSICAL},                                     \
  {"modulus-pa", required_argument, NULL, PO_FLAG_MODULUS},                                        \
  {"work-j-per-m2", required_argument, NULL, PO_FLAG_WORK},                                        \
  {"distance-m", required_argument, NULL, PO_FLAG_DISTANCE},                                       \
  PO_LENGTH_OPTIONS("radius", PO_LENGTH_RADIUS),                                                   \
  PO_LENGTH_OPTIONS("amplitude", PO_LENGTH_AMPLITUDE),                                             \
  PO_LENGTH_OPTIONS("wavelength", PO_LENGTH_WAVELENGTH)
// clang-format on

/* For the help of a verb; what other lengths it takes it says itself. */
#define PO_SCENE_FLAGS_HELP                                                                        \
  "In SI units, the results in both:\n"                                                            \
  "  --from-physical         then, and only then, the flags that name a unit:\n"                   \
  "  --modulus-pa E          contact modulus E* of the pair; inf: rigid\n"                         \
  "  --work-j-per-m2 W       work of adhesion\n"                                                   \
  "  --distance-m EPSILON    equilibrium distance\n"                                               \
  "  --radius-m R            and every other length above so: --amplitude-m, --wavelength-m...\n"

typedef struct {
  bool from_physical;
  double tabor, modulus, work, distance; /* as given; NAN: not given, as all below */
  double length[PO_LENGTH_COUNT];        /* in epsilon, from either kind of flag after _end */
  double metres[PO_LENGTH_COUNT];
  po_units units; /* after _end, of a physical scene */
} po_scene_flags;

/* Nothing given. */
po_scene_flags po_scene_flags_default(void);

/* Takes one option below PO_FLAG_NEXT. Status: PO_BAD_INPUT. */
po_status po_scene_flags_take(po_scene_flags *flags, int option);

/* Refuses flags of both kinds and names what a physical scene lacks; then puts the scene together,
 * what was not given staying as it is in *scene. Without `elastic` the modulus may be left out.
 * Status: PO_BAD_INPUT. */
po_status po_scene_flags_end(po_scene_flags *flags, bool elastic, po_scene *scene);

/* Refuses a parameter that the law of a scene does not have. Given: whether each was given.
 * Status: PO_BAD_INPUT. */
po_status po_scene_flags_check_law(const po_law *law, const bool given[PO_LAW_PARAMETER_COUNT]);

/* The name of a length flag as the user is to write it here: "radius", or "radius-m". */
void po_scene_flags_name(const po_scene_flags *flags, po_length length, char name[32]);

#endif
