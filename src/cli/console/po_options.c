#include "po_options.h"

#include <stdio.h>
#include <string.h>

#include "po_parameters.h"
#include "po_quote.h"
#include "po_suggest.h"
#include "po_text.h"

enum { DONE = -1, BAD = -2, MOST_OPTIONS = 128 };

/* What the program was given when getopt refused it: a letter of a group such as -xj2, or a word.
 */
static void write_given(const po_options *options, char given[PO_QUOTE_LENGTH]) {
  if (optopt > ' ' && optopt < 127)
    snprintf(given, PO_QUOTE_LENGTH, "-%c", optopt);
  else
    po_quote(options->argv[optind - 1], given);
}

/* Refuses an option that a table does not have, that has a value which it does not take, or that is
 * the beginning of several. */
static void refuse_option(const po_options *options, const struct option *table,
                          const char *given) {
  po_text names = {0}, begun = {0};
  const size_t length = strcspn(given, "=");
  const struct option *exact = NULL;
  for (; table->name; ++table) {
    const bool begins = length > 2 && strncmp(table->name, given + 2, length - 2) == 0;
    po_text_add(&names, "--%s ", table->name);
    exact = begins && !table->name[length - 2] ? table : exact;
    if (begins)
      po_text_add(&begun, "%s--%s", begun.length ? ", " : "", table->name);
  }
  const bool one = begun.length && !strchr(po_text_string(&begun), ',');
  if (exact || one)
    po_fail(PO_BAD_INPUT, "%s of %s has a value: expected %s%s without one (see pulloff %s --help)",
            given, options->verb, one ? "" : "--", one ? po_text_string(&begun) : exact->name,
            options->verb);
  else if (begun.length)
    po_suggest(po_fail(PO_BAD_INPUT,
                       "%s of %s is the beginning of several options: expected one of %s", given,
                       options->verb, po_text_string(&begun)),
               given, po_text_string(&names));
  else
    po_suggest(po_fail(PO_BAD_INPUT, "unknown option %s of %s (see pulloff %s --help)", given,
                       options->verb, options->verb),
               given, po_text_string(&names));
  po_text_clear(&names);
  po_text_clear(&begun);
}

/* Appends the letters of the options to the argument of getopt: ":hj:". */
static void make_letters(const po_options *options, char letters[2 * MOST_OPTIONS]) {
  size_t length = (size_t)snprintf(letters, 2 * MOST_OPTIONS, ":h");
  for (const po_option *row = options->options; row->name; ++row)
    if (row->letter)
      length += (size_t)snprintf(letters + length, 2 * MOST_OPTIONS - length, "%c%s", row->letter,
                                 row->kind == PO_OPTION_IS_FLAG ? "" : ":");
}

/* The value in the table of getopt of an option that was given by its letter. */
static int of_letter(const po_options *options, int letter) {
  for (int k = 0; options->options[k].name; ++k)
    if (options->options[k].letter == letter)
      return PO_OPTION_ROWS + k;
  return BAD;
}

/* The `val` of the next option; DONE if only operands are left; BAD, with the message of po_fail,
 * if the option is unknown or lacks its value. Operands may come before options. */
static int next_option(const po_options *options, const struct option *table) {
  char letters[2 * MOST_OPTIONS], given[PO_QUOTE_LENGTH];
  opterr = 0;
  make_letters(options, letters);
  const int found = getopt_long(options->argc, options->argv, letters, table, NULL);
  switch (found) {
  case ':':
    write_given(options, given);
    po_fail(PO_BAD_INPUT, "the option %s of %s needs a value (see pulloff %s --help)", given,
            options->verb, options->verb);
    return BAD;
  case '?':
    write_given(options, given);
    refuse_option(options, table, given);
    return BAD;
  case 'h':
    return PO_OPTION_HELP;
  default:
    return found > 'A' && found <= 'z' ? of_letter(options, found) : found;
  }
}

_Static_assert(PO_KEY_ALL + 32 < MOST_OPTIONS,
               "a verb has at most 30 options of its own, and --help");

/* Appends the options of the keys of a verb (PO_FOR_...) to a table of `count` rows. Returned: the
 * number of rows. */
static size_t add_key_options(unsigned verb, struct option table[MOST_OPTIONS], size_t count) {
  static char names[PO_KEY_ALL][PO_FLAG_LENGTH];
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    if (!(PO_KEYS[key].verbs & verb))
      continue;
    po_key_flag(key, names[key]);
    table[count++] = (struct option){names[key], required_argument, NULL, PO_OPTION_KEYS + key};
  }
  return count;
}

enum { COLUMN = 26, WIDTH = 93 };

/* Appends words in the right column. Given: used, the characters of the line so far. */
static void add_words(po_text *help, const char *text, size_t used) {
  const bool full = used + 2 > COLUMN;
  po_text_add(help, "%s%*s", full ? "\n" : "", (int)(full ? COLUMN : COLUMN - used), "");
  for (size_t column = COLUMN; *text;) {
    const size_t word = strcspn(text, " ");
    if (column > COLUMN && column + 1 + word > WIDTH) {
      po_text_add(help, "\n%*s", COLUMN, "");
      column = COLUMN;
    }
    po_text_add(help, "%s%.*s", column > COLUMN ? " " : "", (int)word, text);
    column += word + (column > COLUMN);
    text += word + (text[word] == ' ');
  }
  po_text_add(help, "\n");
}

static const char *help_of(const po_key_row *row, unsigned verb) {
  return verb == PO_FOR_THEORY && *row->help_of_form ? row->help_of_form : row->help;
}

/* Appends the options of the keys of some owners. Those without help come before the next one. */
static void add_options_of(unsigned verb, po_key_owner first, po_key_owner last, po_text *help) {
  size_t used = 0;
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key_row *row = &PO_KEYS[key];
    if (!(row->verbs & verb) || row->owner < first || row->owner > last)
      continue;
    char flag[PO_FLAG_LENGTH], option[64];
    po_key_flag(key, flag);
    const size_t length = (size_t)snprintf(option, sizeof option, "--%s %s", flag, row->value);
    const bool fits = used && used + 2 + length <= WIDTH;
    po_text_add(help, "%s%s", fits ? ", " : used ? ",\n  " : "  ", option);
    used = (fits ? used : 0) + 2 + length;
    if (!*help_of(row, verb))
      continue;
    add_words(help, help_of(row, verb), used);
    used = 0;
  }
}

void po_options_add_varying(po_text *names) {
  for (int key = 0, named = 0; key < PO_KEY_ALL; ++key)
    if (po_key_is_continuous(key) && PO_KEYS[key].verbs & PO_FOR_FOLLOW) {
      char flag[PO_FLAG_LENGTH];
      po_key_flag(key, flag);
      po_text_add(names, "%s%s%s", named++ ? ", " : "",
                  key == PO_KEY_MODULUS_PA ? "or in SI units " : "", flag);
    }
}

/* Appends the names of the keys that a series may vary, as the end of the help of an option. */
static void add_varying(po_text *help) {
  po_text names = {0};
  po_options_add_varying(&names);
  add_words(help, po_text_string(&names), 0);
  po_text_clear(&names);
}

/* Appends a help text in which lines stand for the options of a verb: @scene for those of what is
 * pressed, @trace for the preload and the range of the trace, @mesh for the discretisation, @si for
 * those in SI units; and @varying for the names of the keys that a series may vary. */
static void add_help(unsigned verb, const char *text, po_text *help) {
  while (*text) {
    const int line = (int)strcspn(text, "\n");
    if (strncmp(text, "@scene", 6) == 0)
      add_options_of(verb, PO_OWNER_SCENE, PO_OWNER_PROFILE, help);
    else if (strncmp(text, "@trace", 6) == 0)
      add_options_of(verb, PO_OWNER_TRACE, PO_OWNER_TRACE, help);
    else if (strncmp(text, "@mesh", 5) == 0)
      add_options_of(verb, PO_OWNER_MESH, PO_OWNER_MESH, help);
    else if (strncmp(text, "@si", 3) == 0)
      add_options_of(verb, PO_OWNER_SI, PO_OWNER_SI, help);
    else if (strncmp(text, "@varying", 8) == 0)
      add_varying(help);
    else
      po_text_add(help, "%.*s\n", line, text);
    text += line + (text[line] == '\n');
  }
}

/* Fills the table of all options of a verb, whose last row is zero. */
static void make_table(const po_options *options, struct option table[MOST_OPTIONS]) {
  size_t count = 0;
  for (const po_option *row = options->options; row->name; ++row, ++count)
    table[count] =
        (struct option){row->name, row->kind == PO_OPTION_IS_FLAG ? no_argument : required_argument,
                        NULL, PO_OPTION_ROWS + (int)count};
  table[count++] = (struct option){"help", no_argument, NULL, PO_OPTION_HELP};
  if (options->keys)
    table[count++] = (struct option){"from-physical", no_argument, NULL, PO_OPTION_PHYSICAL};
  count = add_key_options(options->keys, table, count);
  table[count] = (struct option){0};
}

po_status po_options_take(const po_options *options, void *line, int option) {
  if (option < PO_OPTION_ROWS)
    return options->take_key(line, option);
  const po_option *row = &options->options[option - PO_OPTION_ROWS];
  void *value = (char *)line + row->place;
  switch (row->kind) {
  case PO_OPTION_IS_FLAG:
    *(bool *)value = true;
    return PO_OK;
  case PO_OPTION_IS_TEXT:
    return po_options_take_text(row->name, row->expected, value);
  case PO_OPTION_IS_NUMBER:
    return po_number_parse(optarg, value) && *(double *)value > row->least
               ? PO_OK
               : po_options_refuse(row->name, optarg, row->expected);
  default:
    return row->take(row->name, value);
  }
}

/* Prints the help of a verb. Status: PO_NO_MEMORY. */
static po_status print_help(const po_options *options) {
  po_text help = {0};
  add_help(options->keys, options->help, &help);
  add_help(options->keys, options->more_help ? options->more_help : "", &help);
  return po_text_print(&help);
}

/* Refuses the first operand that a verb does not take. */
static po_status check_operands(const po_options *options) {
  const int first = optind + options->operands;
  char shown[PO_QUOTE_LENGTH];
  return first >= options->argc
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "unexpected argument %s of %s (see pulloff %s --help)",
                       po_quote(options->argv[first], shown), options->verb, options->verb);
}

bool po_options_read(const po_options *options, void *line, po_status *status) {
  struct option table[MOST_OPTIONS];
  int option = 0;
  make_table(options, table);
  *status = PO_OK;
  po_options_begin_messages(options->keys);
  while (!*status && (option = next_option(options, table)) != DONE) {
    if (option == PO_OPTION_HELP) {
      *status = print_help(options);
      return false;
    }
    *status = option == BAD   ? PO_BAD_INPUT
              : options->take ? options->take(line, option)
                              : po_options_take(options, line, option);
  }
  if (!*status)
    *status = check_operands(options);
  return *status == PO_OK;
}

po_status po_options_refuse(const char *option, const char *value, const char *expected) {
  char shown[PO_QUOTE_LENGTH];
  return po_suggest(
      po_fail(PO_BAD_INPUT, "--%s is %s: expected %s", option, po_quote(value, shown), expected),
      value, expected);
}

po_status po_options_refuse_stiffness(const char *option, void *line) {
  (void)line;
  return po_fail(PO_BAD_INPUT,
                 "--%s has no effect here: the pull-off force is that of a minimum of the load, "
                 "which is the same through every spring, and a spring decides only which preload "
                 "leads to it; expected pulloff solve with the stiffness, and --want preload or "
                 "--viscoelastic",
                 option);
}

po_status po_options_take_text(const char *option, const char *expected, const char **text) {
  *text = optarg;
  return *optarg || !expected ? PO_OK : po_options_refuse(option, optarg, expected);
}

/* -- The options that describe a scene -- */

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
  if (option == PO_OPTION_PHYSICAL) {
    options->given.si = true;
    po_options_message_in_si();
  } else if (key == PO_KEY_WAVES)
    return take_wave(options);
  else if (key == PO_KEY_PROFILE_FILE)
    return po_options_take_text("profile-file", "the name of a file", &options->given.text[key]);
  else
    options->given.text[key] = optarg;
  return PO_OK;
}

/* Remarks inputs in SI units that are likely slips of a unit: outside what matter and machines
 * have. Distances go from a tenth of an atom to long-ranged forces, radii from the sharpest tips to
 * lenses of large mirrors, moduli from soft gels to twice diamond, works from forces that are
 * screened in a liquid to twice the strongest solids. */
static void remark_units(const po_texts *given) {
  static const struct {
    po_key key;
    double least, most;
    const char *unit;
  } USUAL[] = {{PO_KEY_DISTANCE_M, 1e-11, 1e-7, "m"}, {PO_KEY_RADIUS_M, 1e-10, 100, "m"},
               {PO_KEY_MODULUS_PA, 1, 2.5e12, "Pa"},  {PO_KEY_WORK_J_PER_M2, 1e-8, 20, "J/m^2"},
               {PO_KEY_AMPLITUDE_M, 1e-12, 1, "m"},   {PO_KEY_WAVELENGTH_M, 1e-11, 100, "m"}};
  for (size_t i = 0; i < sizeof USUAL / sizeof *USUAL; ++i) {
    const char *text = given->text[USUAL[i].key];
    double value = 0;
    if (!text || !po_number_parse(text, &value) || !(value > 0.0) ||
        (value >= USUAL[i].least && value <= USUAL[i].most))
      continue;
    char name[PO_KEY_NAME_LENGTH];
    po_texts_name(given, USUAL[i].key, name);
    fprintf(stderr,
            "pulloff: warning: %s is %g %s, which looks like another unit: usual are %g to %g %s\n",
            name, value, USUAL[i].unit, USUAL[i].least, USUAL[i].most, USUAL[i].unit);
  }
}

void po_scene_options_warn(const po_texts *given) {
  /* Much less than an atom, for a radius; still less for the waves, which may be extreme. */
  const double least_radius = 1e-2, least_wave = 1e-6;
  if (given->si) {
    remark_units(given);
    return;
  }
  const double amplitude = po_texts_number(given, PO_KEY_AMPLITUDE, NULL);
  const double wavelength = po_texts_number(given, PO_KEY_WAVELENGTH, NULL);
  const double radius = po_texts_number(given, PO_KEY_RADIUS, NULL);
  const bool waves = amplitude > 0 && amplitude < least_wave && wavelength < least_wave;
  if (radius < least_radius || waves)
    fprintf(stderr,
            "pulloff: warning: --%s is %g epsilon, which looks like metres: for SI units, use "
            "--from-physical and --%s-m\n",
            radius < least_radius ? "radius" : "wavelength",
            radius < least_radius ? radius : wavelength,
            radius < least_radius ? "radius" : "wavelength");
}
