/* Reads the command line of a verb. All verbs read long options in the same way and refuse a wrong
 * one with one line on standard error. */
#ifndef PO_OPTIONS_H
#define PO_OPTIONS_H

#include <getopt.h>
#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"
#include "po_text.h"
#include "po_texts.h"

/* Exit codes of the program. */
enum {
  PO_EXIT_OK = 0,
  PO_EXIT_OUTSIDE = 1,      /* a check does not pass */
  PO_EXIT_USAGE = 2,        /* wrong usage or wrong input */
  PO_EXIT_SOLVE = 3,        /* a solve failed */
  PO_EXIT_FILE = 4,         /* a file could not be read or written, or a program is missing */
  PO_EXIT_INTERRUPTED = 130 /* 128 + SIGINT, the convention of shells */
};

/* Takes optarg as the value of an option, from the place of its row on. Status: PO_BAD_INPUT. */
typedef po_status po_option_taker(const char *name, void *value);

typedef enum {
  PO_OPTION_IS_FLAG,   /* has no value, and sets a bool */
  PO_OPTION_IS_TEXT,   /* a path or names: a const char * */
  PO_OPTION_IS_NUMBER, /* a double, more than `least` */
  PO_OPTION_IS_TAKEN   /* by the function `take` */
} po_option_kind;

/* An option of a verb, and the place of its value in the struct `line` of the verb. */
typedef struct {
  const char *name;
  po_option_kind kind;
  size_t place;
  const char *expected; /* of a text: NULL: it may be empty */
  double least;
  po_option_taker *take;
  char letter; /* of its short form, such as 'j'; 0: none */
} po_option;
// clang-format off
/* The place of a member, which must have the type of the option: another one does not compile. */
#define PO_OPTION_PLACE(line, member, type) _Generic(((line *)0)->member, type: offsetof(line, member))
#define PO_FLAG(key, line, member) \
  {.name = key, .kind = PO_OPTION_IS_FLAG, .place = PO_OPTION_PLACE(line, member, bool)}
#define PO_TEXT(key, line, member, what) \
  {.name = key, .kind = PO_OPTION_IS_TEXT, .place = PO_OPTION_PLACE(line, member, const char *), .expected = what}
/* Where results are written: --output and -o. */
#define PO_OUTPUT(line, member, what) \
  {.name = "output", .kind = PO_OPTION_IS_TEXT, .place = PO_OPTION_PLACE(line, member, const char *), \
   .expected = what, .letter = 'o'}
#define PO_NUMBER(key, line, member, above, what) \
  {.name = key, .kind = PO_OPTION_IS_NUMBER, .place = PO_OPTION_PLACE(line, member, double), .expected = what, \
   .least = above}
#define PO_TAKEN(key, line, member, function) \
  {.name = key, .kind = PO_OPTION_IS_TAKEN, .place = offsetof(line, member), .take = function}
/* Rows of a verb on whose result a stiffness has no effect, which say why. */
#define PO_REFUSED_STIFFNESS \
  {.name = "stiffness", .kind = PO_OPTION_IS_TAKEN, .take = po_options_refuse_stiffness}, \
  {.name = "stiffness-n-per-m", .kind = PO_OPTION_IS_TAKEN, .take = po_options_refuse_stiffness}
// clang-format on

/* The values of options in the table of getopt: of --from-physical, of the keys, of the rows of a
 * verb, and of --help. getopt itself returns ':', '?' and 'h'. */
enum { PO_OPTION_PHYSICAL = 1, PO_OPTION_KEYS = 200, PO_OPTION_ROWS = 400, PO_OPTION_HELP = 1000 };

/* An option of a verb that may be given more than once. */
enum { PO_SEVERAL = 1 << 20 };

/* The command line of one verb, and the options it may have beside --help. */
typedef struct {
  const char *verb;
  const char *help;         /* printed by --help */
  const po_option *options; /* ends with a row without a name */
  int argc;
  char **argv;
  int operands;          /* at most so many; PO_SEVERAL: as many as there are */
  const char *more_help; /* printed after `help`; NULL: none */
  unsigned keys; /* PO_FOR_...: the options of the keys of this verb are added, and its helps have
                    lines such as @scene, see add_help; 0: none */
  po_status (*take_key)(void *line, int option); /* takes PO_OPTION_PHYSICAL, or that of a key */
  po_status (*take)(void *line, int option);     /* in place of po_options_take; NULL: that */
} po_options;

/* Stores one option, whose value is in optarg, in the line. Status: PO_BAD_INPUT. */
po_status po_options_take(const po_options *options, void *line, int option);

/* Stores every option. Returned: whether the verb continues; its operands begin at argv[optind]. If
 * it does not, *status is PO_OK if --help was given and the help printed, and PO_BAD_INPUT if an
 * option is unknown, lacks its value, or was refused, or if there are too many operands. */
bool po_options_read(const po_options *options, void *line, po_status *status);

/* Refuses the value of an option: PO_BAD_INPUT. */
po_status po_options_refuse(const char *option, const char *value, const char *expected);

/* Refuses --stiffness and --stiffness-n-per-m (po_option_taker): PO_BAD_INPUT. */
po_status po_options_refuse_stiffness(const char *option, void *line);

/* Takes a path or names from optarg; refuses an empty text, if something is expected. */
po_status po_options_take_text(const char *option, const char *expected, const char **text);

/* Prints the message of a failed status as `pulloff: ...` on standard error. If the verb takes the
 * options of a scene, the message names these in place of keys. Returned: the exit code of the
 * status. */
int po_options_end(po_status status);

/* The verb (PO_FOR_..., 0: it takes no scene) whose options the message names; its scene is in SI
 * units. Called while the command line is read. */
void po_options_begin_messages(unsigned verb);
void po_options_message_in_si(void);

/* Appends the names of the options of the keys that a series may vary, with commas between. */
void po_options_add_varying(po_text *names);

/* -- The options that describe a scene, for the verbs that take one: dimensionless with lengths in
 * epsilon, or in SI units after --from-physical -- */

/* The SI options in the help of a verb. */
#define PO_SCENE_OPTIONS_HELP                                                                      \
  "SI units:\n"                                                                                    \
  "  --from-physical         take the scene in SI units and print the results in both units;\n"    \
  "                          numbers are then given by these options:\n"                           \
  "@si\n"                                                                                          \
  "  --profile, --profile-file, --wave and the parameters of the profile are then in m, too;\n"    \
  "                          C of --profile power in m^(1-N)\n"

typedef struct {
  po_texts given;
  char waves[PO_KEY_TEXT_LENGTH]; /* the text of all --wave */
} po_scene_options;

/* No option given. */
po_scene_options po_scene_options_begin(void);

/* Stores one option in a po_scene_options, which is the first member of the lines of verbs:
 * PO_OPTION_PHYSICAL, or PO_OPTION_KEYS and a key. Status: PO_BAD_INPUT. */
po_status po_scene_options_take(void *options, int option);

/* Warns, on standard error, of lengths in epsilon that only make sense as metres, and of inputs in
 * SI units that only make sense in another unit. */
void po_scene_options_warn(const po_texts *given);

#endif
