/* The manifest of an external solver: how it is started, which scenes and quantities it knows.
 * doc/solvers.md is the protocol. */
#ifndef PO_SOLVER_H
#define PO_SOLVER_H

#include <stdbool.h>
#include <stddef.h>

#include "po_check.h"
#include "po_digest.h"
#include "po_file.h"
#include "po_input.h"
#include "po_request.h"

/* The version of the protocol: the value of `protocol` in a manifest, and the schema of requests.
 */
#define PO_SOLVER_PROTOCOL "pulloff-ask/1"

/* A key of the scene that the solver knows, and the values that it accepts: a list, a range, or, if
 * neither is given, all. */
typedef struct {
  po_axis axis;
  double from, to; /* -INFINITY, INFINITY: no bound */
} po_solver_key;

/* A number by which the solver exchanges time for accuracy, e.g. that of its nodes. */
typedef struct {
  char *name;
  char **values; /* from coarse to fine */
  unsigned values_count;
} po_solver_knob;

typedef struct {
  po_solver_key *scene;
  unsigned scene_count;
  char **quantities;
  unsigned quantities_count;
  char *unstable; /* "true" or "false" */
} po_solver_can;

/* The manifest as written. */
typedef struct {
  char *protocol, *name;
  char **command;
  unsigned command_count;
  char **files;
  unsigned files_count;
  char **environment;
  unsigned environment_count;
  po_solver_can can;
  po_solver_knob *knob;     /* NULL: none */
  char *approach_step_text; /* NULL: 0 */
  char *start_limit_text;   /* NULL: the default */
  char *time_limit_text;    /* NULL: the default */
} po_solver_file;

typedef struct {
  po_solver_file *file;
  po_file_path path;    /* of the manifest */
  po_file_path here;    /* its folder, absolute */
  char *name;           /* of the solver: "NAME", or "NAME@VALUE" with another value of the knob */
  const char *knob;     /* the value of the knob; NULL: there is none */
  char **command;       /* with the path of the program; {here} is replaced; ends with NULL */
  unsigned quantities;  /* bit set of 1 << po_quantity */
  bool unstable;        /* whether it finds unstable equilibria */
  double approach_step; /* with which it locates jumps, eps */
  double start_limit;   /* seconds from the start of a process to its first point */
  double time_limit;    /* seconds for a point without a time limit */
  char digest[PO_DIGEST_LENGTH]; /* of the manifest, the files of the command and the knob */
} po_solver;

/* Reads and checks a manifest. Given: `knob`, one of the values of the knob; NULL: the last one.
 * Status: PO_CANNOT_READ (a file, or the program of the command, does not exist), PO_BAD_INPUT with
 * file and line, PO_NO_MEMORY. */
po_status po_solver_read(const char *path, const char *knob, po_solver **solver);
void po_solver_destroy(po_solver *solver);

/* Returned: a copy of `word` in which each `name` ("{here}", ...) is replaced by `value`, to be
 * freed; NULL without memory. */
char *po_solver_replace(const char *word, const char *name, const char *value);

/* Returned: the folder of the records of a solver, OUTPUT/solvers/NAME. */
po_file_path po_solver_folder(const po_solver *solver, const char *output);

/* Returned: what the manifest says of a key of the scene; NULL: nothing. */
const po_solver_key *po_solver_find_key(const po_solver *solver, po_key key);

/* Reports whether the solver accepts a scene: it knows all keys that describe the scene, and
 * accepts their values. Returned: otherwise, in `why`, the key and its value. */
enum { PO_SOLVER_WHY = 160 };
bool po_solver_accepts(const po_solver *solver, const po_request *request, char why[PO_SOLVER_WHY]);

#endif
