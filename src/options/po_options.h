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

/* The values of options in every table: of --from-physical, of the keys, and of --help. A verb's
 * own begin at PO_OPTION_NEXT and are smaller than ':', which getopt returns, as '?' and 'h'. */
enum { PO_OPTION_PHYSICAL = 1, PO_OPTION_NEXT, PO_OPTION_KEYS = 200, PO_OPTION_HELP = 1000 };

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

/* Appends the names of the options of the keys that a series may vary, with commas between. */
void po_options_add_varying(po_text *names);

/* The name of the option of a key: its name with dashes, in the singular for the waves. */
void po_key_flag(int key, char flag[PO_FLAG_LENGTH_OF_NAME]);

#endif
