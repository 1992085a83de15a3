/* The keys of a scene as users write them in case files, options, JSON and reference tables.
 *
 * One table defines for each key its name, the values it accepts and its place in a request, so
 * that all readers accept, refuse and print the same. */
#ifndef PO_INPUT_H
#define PO_INPUT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_dimension.h"
#include "po_key_rows.h"
#include "po_number.h"
#include "po_request.h"
#include "po_text.h"

/* A key, or a group, by its number. */
typedef int po_key;
#define PO_KEY_ENUMERATOR(key, ...) PO_KEY_##key,
enum {
  PO_KEY_ROWS(PO_KEY_ENUMERATOR) PO_KEY_COUNT,
  PO_KEY_BEFORE_GROUPS = PO_KEY_COUNT - 1,
  PO_GROUP_ROWS(PO_KEY_ENUMERATOR) PO_KEY_END,
  PO_KEY_BEFORE_GIVEN = PO_KEY_END - 1,
  PO_TEXTS_ROWS(PO_KEY_ENUMERATOR) PO_KEY_VARIABLES,
  PO_KEY_BEFORE_VARIABLES = PO_KEY_VARIABLES - 1,
  PO_VARIABLE_ROWS(PO_KEY_ENUMERATOR) PO_KEY_ALL
};

/* What a key belongs to. A law or a profile may have a parameter or not. */
typedef enum {
  PO_OWNER_SCENE,
  PO_OWNER_LAW,
  PO_OWNER_PROFILE,
  PO_OWNER_MESH,
  PO_OWNER_TRACE,
  PO_OWNER_SI /* the scene in SI units; what the key sets belongs to another owner */
} po_key_owner;

/* The verbs that have an option for a key; plot has those of solve. */
enum { PO_FOR_SOLVE = 1, PO_FOR_FOLLOW = 2, PO_FOR_THEORY = 4, PO_FOR_COMPARE = 8 };

/* A row of po_key_rows.h. */
typedef struct {
  const char *name;     /* e.g. "tabor" or "outer_radius" */
  int domain;           /* private to po_input.c */
  const char *expected; /* the accepted values, "a finite number > 0", as messages print them */
  po_dimension dimension;
  bool varies;
  po_key_owner owner;
  size_t place; /* offset of its number in a po_request; PO_NO_PLACE: it is kept otherwise */
  int target;   /* the key that it sets; -1: itself */
  unsigned verbs;
  const char *value, *help, *help_of_form; /* the latter of theory; "": the same */
} po_key_row;
#define PO_NO_PLACE ((size_t)-1)
extern const po_key_row PO_KEYS[PO_KEY_ALL];

/* The longest text of a value, and its NUL: a path or all waves. */
enum { PO_KEY_TEXT_LENGTH = 1024 };

/* Returned: a request with every field at its default, and the JKR theory as its theories. */
po_request po_input_default(void);

/* Returned: the key or group with this name, or -1; po_texts_key also finds the keys that only
 * readers take (PO_TEXTS_ROWS, PO_VARIABLE_ROWS). */
int po_key_of_name(const char *name);
int po_texts_key(const char *name);

/* The name of the option of a key: its name with dashes, in the singular for the waves. */
enum { PO_FLAG_LENGTH = 32 };
void po_key_flag(po_key key, char flag[PO_FLAG_LENGTH]);

/* Returned: whether the value is a number (otherwise it is a name, as for scheme). */
bool po_key_is_number(po_key key);

/* Returned: whether the value is a number that can vary continuously along a series of scenes. */
bool po_key_is_continuous(po_key key);

/* Returned: whether a key is a parameter of the laws, or of the profiles. */
bool po_key_is_parameter(po_key key, po_key_owner owner);

/* Returned: whether a key is a group; and the key that a group, `profile_file`, `waves` or a key in
 * SI units sets (otherwise the key itself). A group must be set after all other keys. */
bool po_key_is_group(po_key key);
po_key po_key_target(po_key key);

/* Returned: the key that gives the same in SI units: PO_KEY_RADIUS_M of PO_KEY_RADIUS; -1: none. */
int po_key_in_si(po_key key);

/* Returned: whether a key takes a number for each of two bodies, "R1,R2", or one; the surface
 * energies are those of two bodies and of their interface. */
bool po_key_is_list(po_key key);

/* Parses the numbers of such a key. Returned: how many there are; 0 if the key does not accept the
 * text. */
enum { PO_KEY_LIST_MOST = 3 };
size_t po_key_parse_list(po_key key, const char *text, double value[PO_KEY_LIST_MOST]);

/* Parses the number of a key; of two radii R1 R2/(R1 + R2), of surface energies the work of
 * adhesion. Returned: false if the key does not
 * accept the text. */
bool po_key_parse(po_key key, const char *text, double *value);

/* Sets a key to the value in `text`; a key of po_texts.h that a request cannot hold is only
 * checked. Returned: false if the key does not accept the value; then the request is unchanged. A
 * profile sets the radius to its default, unless the radius was given. A table that cannot be used
 * has its own message (po_message). */
bool po_key_set(po_request *request, po_key key, const char *text);

/* Prints the value of a key; "auto" for an approach that the solver chooses, "none" for no time
 * limit. */
void po_key_print(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]);

/* Returned: the value of a key as a number; for a name its number in the enumeration, for waves
 * their number. */
double po_key_number(const po_request *request, po_key key);

/* Returned: whether a key of the request has the value in `text`; numbers are compared to 4 ulp, so
 * that 0.1 in two files agrees however it was computed, and the coupling to the 15 digits of
 * tables. A table has the value of a file with the same content, or of its SHA-256. False if the
 * key does not accept the value. */
bool po_key_matches(const po_request *request, po_key key, const char *text);

/* Returned: whether a text is what identifies a table in place of its name: its SHA-256, of a
 * material after "prony:". */
bool po_key_is_identity(po_key key, const char *text);

/* Returned: whether a key can be left out of the description of a scene: the solver chooses its
 * value, or does not use it. */
bool po_key_is_idle(const po_request *request, po_key key);

/* Returned: whether the scheme of the request does not use a key: panels use the tolerance, rings
 * and triangles the nodes and the grading. */
bool po_key_is_of_other_scheme(const po_request *request, po_key key);

/* Returned: whether a scene is stated by its coupling: the profile is not a sphere, and its length
 * of reference R is epsilon. */
bool po_input_has_coupling(const po_request *request);

/* Returned: the unit of loads, "pi w R", or "pi w epsilon" if the profile is not a sphere and its
 * length of reference R is epsilon. */
const char *po_input_load_unit(const po_request *request);

/* Returned: whether a key describes what is pressed, and how fast a viscoelastic body is pulled: an
 * external solver has to know it. The others describe the mesh, the part of the branch that is
 * traced, and the time limit. */
bool po_key_is_of_scene(po_key key);

/* Returned: whether a key is of viscoelastic bodies alone: the documents of others lack it. */
bool po_key_is_of_time(po_key key);

/* Appends " --wave A,L" for each wave of a text "A@L;A@L". */
void po_input_add_waves(po_text *command, const char *waves);

/* Appends a command line, e.g. "pulloff solve --tabor 1 ...", that repeats the solve and does not
 * search beyond its preload. */
void po_input_add_command(const po_request *request, po_text *text);

/* Appends a text that differs for solves that may have different results: the command, with the
 * content of a table instead of its path. */
void po_input_add_identity(const po_request *request, po_text *text);

#endif
