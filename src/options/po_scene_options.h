/* The options that describe a scene, for the verbs that take one: dimensionless with lengths in
 * epsilon, or in SI units after --from-physical. */
#ifndef PO_SCENE_OPTIONS_H
#define PO_SCENE_OPTIONS_H

#include "po_given.h"
#include "po_options.h"

/* The SI options in the help of a verb. */
#define PO_SCENE_OPTIONS_HELP                                                                      \
  "SI units:\n"                                                                                    \
  "  --from-physical         take the scene in SI units and print the results in both units;\n"    \
  "                          numbers are then given by these options:\n"                           \
  "@si\n"                                                                                          \
  "  --profile, --profile-file, --wave and the parameters of the profile are then in m, too;\n"    \
  "                          C of --profile power in m^(1-N)\n"

typedef struct {
  po_given given;
  char waves[PO_KEY_TEXT_LENGTH]; /* the text of all --wave */
} po_scene_options;

/* No option given. */
po_scene_options po_scene_options_begin(void);

/* Stores one option in a po_scene_options, which is the first member of the lines of verbs:
 * PO_OPTION_PHYSICAL, or PO_OPTION_KEYS and a key. Status: PO_BAD_INPUT. */
po_status po_scene_options_take(void *options, int option);

/* Warns, on standard error, of lengths in epsilon that only make sense as metres. */
void po_scene_options_warn(const po_given *given);

#endif
