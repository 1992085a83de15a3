/* The options of the keys of a scene, and their help, made of the rows of keys (po_key_rows.h). */
#ifndef PO_KEY_OPTIONS_H
#define PO_KEY_OPTIONS_H

#include <getopt.h>

#include "po_text.h"

enum { PO_MOST_OPTIONS = 100, PO_FLAG_LENGTH_OF_NAME = 32 };

/* Appends the options of a verb (PO_FOR_...) to a table of `count` rows, with the values that
 * po_scene_flags.h defines, and PO_OPTION_KEYS + key for the others. Returned: the number of rows.
 */
size_t po_key_options(unsigned verb, struct option table[PO_MOST_OPTIONS], size_t count);

/* Appends a help text in which lines stand for the options of a verb: @scene for those of what is
 * pressed, @trace for the preload and the range of the trace, @mesh for the discretisation; and
 * @varying for the names of the keys that a series may vary. */
void po_key_help(unsigned verb, const char *text, po_text *help);

/* The name of the option of a key: its name with dashes, in the singular for the waves. */
void po_key_flag(int key, char flag[PO_FLAG_LENGTH_OF_NAME]);

#endif
