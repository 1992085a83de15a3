/* A case: scenes to solve, what is wanted of them, and the checks their numbers must pass. */
#ifndef PO_CASE_H
#define PO_CASE_H

#include <stddef.h>

#include "po_check.h"
#include "po_input.h"
#include "po_physical.h"
#include "po_request.h"
#include "po_status.h"

/* What a case wants; the first three come with every branch. */
typedef enum {
  PO_CASE_PULL_OFF = 1,
  PO_CASE_FOLDS = 2,
  PO_CASE_EXTREMA = 4,
  PO_CASE_CURVE = 8,
  PO_CASE_PROFILE = 16,
  PO_CASE_HYSTERESIS = 32,
  PO_CASE_DIAGNOSTICS = 64,
  PO_CASE_PRELOAD = 128,
} po_case_want;

/* One key drawn at random, as written, and parsed. */
typedef struct {
  char *key;
  char *from_text;
  char *to_text;
  char *scale; /* "log", "linear"; NULL: linear */
  char *times; /* what the value is in units of: a key, or "root_radius"; NULL: none */
  po_key drawn;
  double from, to;
  bool log;
  po_key unit;  /* when `times` is there */
  bool by_root; /* the root of that */
} po_draw;

/* Scenes drawn at random: each value depends on the seed, the number of the scene and the name of
 * the key, and so not on how many scenes or other keys there are. */
typedef struct {
  char *seed_text;
  char *count_text;
  po_draw *keys;
  unsigned keys_count;
  uint64_t seed;
  size_t count;
} po_sample_words;

/* Of scenes that are followed, so many are traced as well, drawn at random. */
typedef struct {
  char *seed_text;
  char *count_text;
} po_traced_words;

/* One scene. */
typedef struct {
  char id[24]; /* "0", "1"...: in the order of the sample, then of the sweep */
  char *label; /* "tabor=1 nodes=501", or "scene" without either */
  po_request request;
  bool traced; /* by itself, too, beside what following finds */
} po_point;

/* The scene in SI units as written; NULL: not given. */
typedef struct {
  char *modulus, *work, *distance, *radius, *amplitude, *wavelength, *outer_radius;
} po_physical_words;

/* The scene as written; NULL: not given. What a physical block makes is filled in when it is
 * parsed.
 */
typedef struct {
  char *values[PO_KEY_COUNT];
  po_physical_words *physical;
} po_scene_words;

/* Closed forms along a sweep, to be drawn beside what is solved. */
typedef struct {
  char *name;
  char *theory; /* as `pulloff theory` names it */
  po_axis *sweep;
  unsigned sweep_count;
} po_case_line;

/* One item of a sweep: a key and its values, or settings of several keys that go together. */
typedef struct {
  po_axis axis;             /* its key is NULL: settings */
  po_scene_words *together; /* NULL: a key */
  unsigned together_count;
  unsigned named; /* the keys and groups it names, a bit each; filled when it is checked */
} po_sweep;

/* Which combinations of a sweep are not solved, and why. */
typedef struct {
  po_axis *when; /* all these must match */
  unsigned when_count;
  char *because;
  size_t points; /* so many */
} po_leave_out;

/* What the file says, filled as po_schema.c describes it, then checked and parsed. */
typedef struct {
  char *name;
  char *title;
  char *figure;    /* NULL: none */
  char *equations; /* NULL: none */
  char *figure_script;
  char **suite_names;
  unsigned suite_names_count;
  po_scene_words scene;
  po_sweep *sweep;
  unsigned sweep_count;
  po_leave_out *leave_out;
  unsigned leave_out_count;
  po_sample_words *sample; /* NULL: none */
  char *follow;           /* the key along which minima are followed; NULL: every scene is traced */
  char *checkpoints_text; /* of a line of scenes, one in so many is traced; NULL: as po_case_line.h
                             says */
  po_traced_words *traced; /* NULL: none of them is traced as well */
  char *repeats_text;
  char **want_names;
  unsigned want_names_count;
  po_check *checks;
  unsigned checks_count;
  po_case_line *lines;
  unsigned lines_count;
  po_check *measure; /* without tolerance, kind and reason */
  unsigned measure_count;
} po_case_file;

typedef struct {
  char *path;   /* where it was read */
  char *shown;  /* how messages and records call it, e.g. "cases/fig03.yaml" */
  bool is_own;  /* a file outside the folder of cases: found by its path alone */
  char *word;   /* how a command line calls it, quoted for a shell; NULL: by its name */
  char *source; /* the text of the file */
  size_t source_size;
  po_case_file *file;
  bool is_physical; /* the scene is in SI units, and results are told in them, too: */
  po_units units;
  unsigned want;      /* of po_case_want */
  unsigned repeats;   /* how often each solve is timed */
  size_t line;        /* points that are solved together, one after another; 1: each by itself */
  size_t checkpoints; /* of them one in so many is traced for certain */
  po_point *points;
  size_t point_count;
} po_case;

/* Reads and checks one case file. `shown` is its name in messages.
 * Status: PO_BAD_INPUT with one line `file:line: path is VALUE: expected ...`; PO_CANNOT_READ. */
po_status po_case_read(const char *path, const char *shown, po_case **result);
void po_case_destroy(po_case *kase);

/* How many settings an item of a sweep has; the value that setting number `index` gives a key or a
 * group (NULL: none); whether the item names that key or group; whether it varies a key, by itself
 * or by a group. */
unsigned po_sweep_count(const po_sweep *sweep);
bool po_sweep_names(const po_sweep *sweep, po_key key);
bool po_sweep_varies(const po_sweep *sweep, po_key key);
const char *po_sweep_value(const po_sweep *sweep, unsigned index, po_key key);

/* Marks a case as a file outside the folder of cases. Status: PO_NO_MEMORY. */
po_status po_case_set_own(po_case *kase);

/* How a command line calls a case: its name, or the path of a file of one's own, as it was given;
 * the same quoted for a shell, to be printed in a command that can be pasted. */
const char *po_case_argument(const po_case *kase);
const char *po_case_word(const po_case *kase);

#endif
