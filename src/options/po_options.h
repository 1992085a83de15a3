/* Reads the command line of a verb. All verbs read long options in the same way and refuse a wrong
 * one with one line on standard error. */
#ifndef PO_OPTIONS_H
#define PO_OPTIONS_H

#include <getopt.h>
#include <stdbool.h>
#include <stddef.h>

#include "po_input.h"
#include "po_status.h"
#include "po_text.h"

enum { PO_MOST_OPTIONS = 100, PO_FLAG_LENGTH_OF_NAME = 32 };

/* Exit codes of the program. */
enum {
  PO_EXIT_OK = 0,
  PO_EXIT_OUTSIDE = 1,      /* a check does not pass */
  PO_EXIT_USAGE = 2,        /* wrong usage or wrong input */
  PO_EXIT_SOLVE = 3,        /* a solve failed */
  PO_EXIT_FILE = 4,         /* a file could not be read or written, or a program is missing */
  PO_EXIT_INTERRUPTED = 130 /* 128 + SIGINT, the convention of shells */
};

/* The value of --help in every table of options. A verb's own are > 0 and smaller, and none of the
 * characters ':', '?' and 'h', which getopt returns: either smaller than ':', or from
 * PO_OPTION_KEYS on. */
enum { PO_OPTION_KEYS = 200, PO_OPTION_HELP = 1000 };

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

/* The names of these lengths. */
typedef struct {
  const char *name;
  int key; /* the po_key with the same domain of values; -1: none */
} po_length_row;
extern const po_length_row PO_LENGTHS[PO_LENGTH_COUNT];

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

/* The command line of one verb, and the options it may have. */
typedef struct {
  const char *verb;
  const char *help; /* printed by --help */
  const struct option *options;
  int argc;
  char **argv;
  const char *more_help; /* printed after `help`; NULL: none */
  unsigned keys; /* PO_FOR_...: the options of the keys of this verb are added, and its helps have
                    lines such as @scene, see add_help; 0: none */
} po_options;

/* Fills the table of all options of a verb, whose last row is zero. */
void po_options_table(const po_options *options, struct option table[PO_MOST_OPTIONS]);

/* Stores one option, whose value is in optarg, in the struct `line` of the verb. Status:
 * PO_BAD_INPUT. */
typedef po_status po_option_taker(void *line, int option);

/* Passes every option to `take`. NULL: the verb has no option but --help.
 * Returned: whether the verb continues; its operands begin at argv[optind]. If it does not, *status
 * is PO_OK if --help was given and the help printed, and PO_BAD_INPUT if an option is unknown,
 * lacks its value, or was refused by `take`. */
bool po_options_read(const po_options *options, po_option_taker *take, void *line,
                     po_status *status);

/* Refuses the value of an option: PO_BAD_INPUT. */
po_status po_options_refuse(const char *option, const char *value, const char *expected);

/* Takes a path or names from optarg; refuses an empty text. */
po_status po_options_take_text(const char *option, const char *expected, const char **text);

/* Refuses operands, for verbs that take none. */
po_status po_options_no_operands(const po_options *options);

/* Prints the message of a failed status as `pulloff: ...` on standard error. Returned: the exit
 * code of the status. */
int po_options_end(po_status status);

/* The name of the option of a key: its name with dashes, in the singular for the waves. */
void po_key_flag(int key, char flag[PO_FLAG_LENGTH_OF_NAME]);

#endif
