/* Smooth spheres whose pull-off is known and that an external solver accepts, for the test of the
 * protocol. */
#ifndef PO_KNOWN_SCENES_H
#define PO_KNOWN_SCENES_H

#include "po_solver.h"

enum { PO_MOST_KNOWN = 4 };
enum { PO_KNOWN_FORCE, PO_KNOWN_APPROACH, PO_KNOWN_CONTACT_RADIUS, PO_KNOWN_NUMBERS };

typedef struct {
  po_request request;
  double expected[PO_KNOWN_NUMBERS]; /* at the pull-off, dimensionless; accurate to 1 % */
} po_known_scene;

typedef struct {
  po_known_scene scenes[PO_MOST_KNOWN];
  size_t count;            /* 0: the manifest accepts none */
  char why[PO_SOLVER_WHY]; /* of the first scene that it does not accept; "" if there is none */
} po_known_scenes;

/* Chooses up to four scenes: the most rigid one, the softest one, one between them, and one with a
 * second radius; of usual values, else of the values and ranges of the manifest, whatever these
 * are. A scene with a Tabor parameter beyond the last row of reference/feng_pull_off.csv, 10, is
 * not known. Status: PO_CANNOT_READ (the table). */
po_status po_known_scenes_choose(const po_solver *solver, const char *data_folder,
                                 po_known_scenes *known);

#endif
