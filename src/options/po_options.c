#include "po_options.h"

#include <stdio.h>
#include <string.h>

#include "po_quote.h"
#include "po_scene_flags.h"
#include "po_text.h"

enum { DONE = -1, BAD = -2 };

/* The `val` of the next option; DONE if only operands are left; BAD, with the message of po_fail,
 * if the option is unknown or lacks its value. */
static int next(const po_options *options, const struct option *table) {
  opterr = 0;
  int index = 0;
  const int at = optind ? optind : 1;
  const int found = getopt_long(options->argc, options->argv, ":h", table, &index);
  const char *given = at < options->argc ? options->argv[optind > 1 ? optind - 1 : at] : "";
  switch (found) {
  case ':':
    po_fail(PO_BAD_INPUT, "the option %s of %s needs a value (see pulloff %s --help)", given,
            options->verb, options->verb);
    return BAD;
  case '?':
    po_fail(PO_BAD_INPUT, "unknown option %s of %s (see pulloff %s --help)", given, options->verb,
            options->verb);
    return BAD;
  case 'h':
    return PO_OPTION_HELP;
  default:
    return found;
  }
}

void po_options_table(const po_options *options, struct option table[PO_MOST_OPTIONS]) {
  static const struct option PHYSICAL[] = {PO_PHYSICAL_OPTIONS};
  size_t count = 0;
  for (const struct option *own = options->options; own->name; ++own)
    table[count++] = *own;
  for (size_t i = 0; options->keys && i < sizeof PHYSICAL / sizeof *PHYSICAL; ++i)
    table[count++] = PHYSICAL[i];
  count = po_key_options(options->keys, table, count);
  table[count] = (struct option){0};
}

/* Prints the help of a verb. Status: PO_NO_MEMORY. */
static po_status print_help(const po_options *options) {
  po_text help = {0};
  po_key_help(options->keys, options->help, &help);
  po_key_help(options->keys, options->more_help ? options->more_help : "", &help);
  fputs(po_text_string(&help), stdout);
  const po_status status = help.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&help);
  return status;
}

bool po_options_read(const po_options *options, po_option_taker *take, void *line,
                     po_status *status) {
  struct option table[PO_MOST_OPTIONS];
  int option = 0;
  po_options_table(options, table);
  *status = PO_OK;
  while (!*status && (option = next(options, table)) != DONE) {
    if (option == PO_OPTION_HELP) {
      *status = print_help(options);
      return false;
    }
    *status = option == BAD ? PO_BAD_INPUT : take(line, option);
  }
  return *status == PO_OK;
}

po_status po_options_refuse(const char *option, const char *value, const char *expected) {
  char shown[PO_QUOTE_LENGTH];
  return po_fail(PO_BAD_INPUT, "--%s is %s: expected %s", option, po_quote(value, shown), expected);
}

po_status po_options_take_text(const char *option, const char *expected, const char **text) {
  *text = optarg;
  return *optarg ? PO_OK : po_options_refuse(option, optarg, expected);
}

po_status po_options_no_operands(const po_options *options) {
  if (optind >= options->argc)
    return PO_OK;
  char shown[PO_QUOTE_LENGTH];
  return po_fail(PO_BAD_INPUT, "unexpected argument %s of %s (see pulloff %s --help)",
                 po_quote(options->argv[optind], shown), options->verb, options->verb);
}

static int exit_code(po_status status) {
  switch (status) {
  case PO_OK:
    return PO_EXIT_OK;
  case PO_BAD_INPUT:
    return PO_EXIT_USAGE;
  case PO_CANNOT_READ:
  case PO_CANNOT_WRITE:
  case PO_MISSING_TOOL:
    return PO_EXIT_FILE;
  case PO_INTERRUPTED:
    return PO_EXIT_INTERRUPTED;
  case PO_CHECK_FAILED:
    return PO_EXIT_OUTSIDE;
  default:
    return PO_EXIT_SOLVE;
  }
}

int po_options_end(po_status status) {
  if (status)
    fprintf(stderr, "pulloff: %s\n", *po_message() ? po_message() : po_status_text(status));
  return exit_code(status);
}
