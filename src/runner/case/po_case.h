/* A case: the scenes to solve, the wanted results, and the checks that the results must pass. */
#ifndef PO_CASE_H
#define PO_CASE_H

#include <signal.h>
#include <stddef.h>

#include "po_check.h"
#include "po_forms.h"
#include "po_input.h"
#include "po_physical.h"
#include "po_request.h"
#include "po_status.h"
#include "po_text.h"
#include "po_uncertain.h"

/* The wanted results: PO_WANT_..., and these three, which every traced branch delivers. */
enum {
  PO_CASE_PULL_OFF = 1 << PO_WANT_COUNT,
  PO_CASE_FOLDS = 2 << PO_WANT_COUNT,
  PO_CASE_EXTREMA = 4 << PO_WANT_COUNT
};

/* A key whose value is drawn at random: as written, and parsed. */
typedef struct {
  char *key;
  char *from_text;
  char *to_text;
  char *scale; /* "log" or "linear"; NULL: linear */
  char *times; /* the unit of the drawn number: a key, or "root_radius"; NULL: no unit */
  po_key drawn;
  double from, to;
  bool log;
  po_key unit;  /* the key named by `times` */
  bool by_root; /* the unit is the square root of the value of that key */
} po_draw;

/* Scenes drawn at random. A value depends on the seed, the number of the scene and the name of the
 * key alone; the number of scenes and the other keys have no influence. */
typedef struct {
  char *seed_text;
  char *count_text;
  po_draw *keys;
  unsigned keys_count;
  uint64_t seed;
  size_t count;
} po_sample_words;

/* A number of scenes of the series, drawn at random, that are traced in addition to the parameter
 * continuation, for comparison. */
typedef struct {
  char *seed_text;
  char *count_text;
} po_traced_words;

/* A set of keys and groups. */
typedef struct {
  bool has[PO_KEY_VARIABLES];
} po_keys;

/* One scene. */
typedef struct {
  char id[24];        /* "0", "1"...: in the order of the sample, then of the sweep */
  char *label;        /* "tabor=1 nodes=501"; "scene" in a case without sweep and sample */
  po_request request; /* of a scene in SI units with its units */
  size_t setting;     /* number of its combination of sample and sweep, before leave_out */
  bool traced; /* the scene belongs to a series and is traced in addition, see po_traced_words */
  po_uncertain_inputs *uncertain; /* its uncertain numbers, of which the request has the variations;
                                     NULL: none */
} po_point;

/* An uncertain number of the file, whose text is in the scene or in an item of the sweep. */
typedef struct {
  po_uncertain_number number;
  int item; /* -1: the scene */
  unsigned setting;
} po_case_number;

/* The scene as written. Keys that are not given are NULL; the parser fills in those that follow
 * from a block `physical`, which is the scene in SI units. */
typedef struct po_scene_words {
  char *values[PO_KEY_ALL]; /* of groups only the coupling can be given */
  struct po_scene_words *physical;
} po_scene_words;

/* A closed form evaluated along a sweep, to be drawn beside the computed results. */
typedef struct {
  char *name;
  char *theory; /* as `pulloff theory` names it */
  po_axis *sweep;
  unsigned sweep_count;
} po_case_line;

/* An item of a sweep: a key and its values, or a list of settings, each of several keys, which a
 * table may give. */
typedef struct {
  po_axis axis;             /* its key is NULL if the item is a list of settings */
  char *table;              /* of settings, which it fills, see po_case_table_read; NULL: none */
  po_scene_words *together; /* the settings; NULL if the item is a key and its values */
  unsigned together_count;
  po_keys named;  /* the keys and groups in the item; filled by po_case_sweep_parse */
  po_keys varied; /* these, and the keys that the groups set */
} po_sweep;

/* A rule that excludes combinations of a sweep, with its reason. */
typedef struct {
  po_axis *when; /* a combination is excluded if all these conditions hold */
  unsigned when_count;
  char *because;
  size_t points; /* number of combinations for which they hold; rules may overlap */
} po_leave_out;

/* The content of a case file. po_schema.c fills it; po_case_parse.c checks and parses it. */
typedef struct {
  char *name;
  char *title;
  char *figure;    /* of the paper; NULL: not given */
  char *equations; /* of the paper; NULL: not given */
  char *figure_script;
  char **suite_names;
  unsigned suite_names_count;
  po_scene_words scene;
  po_sweep *sweep;
  unsigned sweep_count;
  po_leave_out *leave_out;
  unsigned leave_out_count;
  po_sample_words *sample; /* NULL: no scene is drawn */
  char *follow;            /* the parameter of the continuation; NULL: every scene is traced */
  char *checkpoints_text;  /* key checkpoint_every; NULL: PO_CHECKPOINT_EVERY */
  po_traced_words *traced; /* NULL: only checkpoints are traced */
  char *repeats_text;
  char **want_names;
  unsigned want_names_count;
  po_check *checks;
  unsigned checks_count;
  po_case_line *lines;
  unsigned lines_count;
  po_check *measure; /* measurements: without tolerance, kind and reason */
  unsigned measure_count;
  /* What sweep and sample vary, directly or by a group, and both; filled by po_case_sweep_parse. */
  po_keys swept, drawn, varied;
} po_case_file;

typedef struct {
  char *path;   /* of the file */
  char *shown;  /* name of the file in messages and records, e.g. "cases/fig03.yaml" */
  bool is_own;  /* the file lies outside the folder of cases; it is found by its path alone */
  char *word;   /* the argument that selects the case, quoted for a shell; NULL: the name */
  char *source; /* the text of the file */
  size_t source_size;
  po_case_file *file;
  bool is_physical;     /* the scene is given in SI units; results are reported in them as well */
  po_units units;       /* if is_physical; of the first point, if the sweep varies them */
  bool varies_units;    /* the sweep has keys in SI units */
  unsigned want;        /* bit set of PO_WANT_... and PO_CASE_... */
  unsigned repeats;     /* number of timed repetitions of each solve */
  size_t series_length; /* scenes of a series in parameter continuation; 1: every scene is traced */
  size_t checkpoints;   /* every so many scenes of a series one is a checkpoint */
  po_point *points;
  size_t point_count;
  po_case_number *uncertain;
  size_t uncertain_count, uncertain_room;
  double time_limit; /* of the command line, which replaces those of the points; else 0 or NAN */
} po_case;

/* The folder beside those of the cases that contains the records of external solvers. No case has
 * this name. */
#define PO_CASE_FOLDER_OF_SOLVERS "solvers"

/* Reports whether a text may be the name of a case, a suite, a script or a line: letters, digits, _
 * and -; not empty, and not beginning with -. */
bool po_case_is_name(const char *text);

/* Returned: check number `index`, after the checks the measurements, and after these NULL. */
const po_check *po_case_check(const po_case_file *file, unsigned index);

/* Returned: the argument that selects the case on a command line, which is its name, or the path of
 * a file outside the folder of cases as it was given; po_case_word quotes it for a shell, so that a
 * printed command can be pasted. */
const char *po_case_word(const po_case *kase);

/* Adds the table of a line, with one row for each combination of its sweep. The columns are the
 * keys of the sweep, then the values of the form: those along its variable if the sweep contains
 * the variable, else its fixed values. Values that do not exist are nan. Given: `stop`, which ends
 * the computation when it becomes nonzero; may be NULL. Status: PO_INTERRUPTED, and those of the
 * form. */
po_status po_case_line_table(const po_case_file *file, const po_case_line *line,
                             const volatile sig_atomic_t *stop, po_text *rows);

/* Given: the path of the table of a profile or a material, as it is in the request of a point.
 * Returned: the name relative to the folder of the case file, a part of `path`; `path` if it is
 * elsewhere. */
const char *po_case_profile_shown(const po_case *kase, const char *path);

/* Returned: the value of a key that an item of the sweep varies, at a point; NULL: it has none. */
const char *po_case_swept_text(const po_case *kase, const po_point *point, unsigned item,
                               po_key key);

/* Reads and checks one case file.
 * Given: `shown`, the name of the file in messages.
 * Status: PO_BAD_INPUT with one line `file:line: path is VALUE: expected ...`; PO_CANNOT_READ. */
po_status po_case_read(const char *path, const char *shown, po_case **result);
void po_case_destroy(po_case *kase);

#endif
