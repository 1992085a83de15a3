/* Command lines: long options read the same way, refused with one line, by every verb. */
#ifndef PO_OPTIONS_H
#define PO_OPTIONS_H

#include <getopt.h>
#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* Exit codes of the program. */
enum {
  PO_EXIT_OK = 0,
  PO_EXIT_OUTSIDE = 1,      /* a check does not pass */
  PO_EXIT_USAGE = 2,        /* bad usage or bad input */
  PO_EXIT_SOLVE = 3,        /* a solve failed */
  PO_EXIT_FILE = 4,         /* a file could not be read or written, a tool is missing */
  PO_EXIT_INTERRUPTED = 130 /* 128 + SIGINT, as shells say it */
};

/* The value of --help in every table of options; a verb's own are > 0 and smaller than 'h', which
 * is the value of -h. */
enum { PO_OPTION_HELP = 1000 };

/* A reader of one command line. */
typedef struct {
  const char *verb;
  const char *help; /* printed by --help */
  const struct option *options;
  int argc;
  char **argv;
} po_options;

/* Takes one option, whose value is in optarg, into the verb's `line`. Status: PO_BAD_INPUT. */
typedef po_status po_option_taker(void *line, int option);

/* Hands every option to `take` (NULL: --help is the only one).
 * Returned: whether the verb goes on, with the operands from optind on. If not, *status says how it
 * ends: PO_OK, --help was asked for and printed; PO_BAD_INPUT, an option is unknown, lacks its
 * argument, or was refused by `take`. */
bool po_options_read(const po_options *options, po_option_taker *take, void *line,
                     po_status *status);

/* Refuses the value of an option: PO_BAD_INPUT. */
po_status po_options_refuse(const char *option, const char *value, const char *expected);

/* Takes a path or names from optarg; refuses an empty text. */
po_status po_options_take_text(const char *option, const char *expected, const char **text);

/* A flag, whether it was given, and whether it has an effect here. */
typedef struct {
  char name[32]; /* without dashes */
  bool given, taken;
} po_flag_use;

/* Refuses the first flag that was given and has no effect on `what`, and names the flags that have
 * an effect: a user whose flag is ignored silently would misread the result. Status: PO_BAD_INPUT,
 * PO_OK. */
po_status po_options_refuse_idle(const char *what, const po_flag_use *flags, size_t count);

/* Refuses operands where a verb takes none. */
po_status po_options_no_operands(const po_options *options);

/* Prints the message of a status as `pulloff: ...` on standard error; the exit code that belongs to
 * it. */
int po_options_end(po_status status);

#endif
