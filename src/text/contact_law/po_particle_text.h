/* The law of contact of two particles as text: a C header, a CSV table, a table of LAMMPS. */
#ifndef PO_PARTICLE_TEXT_H
#define PO_PARTICLE_TEXT_H

#include "po_particle_law.h"
#include "po_text.h"

typedef enum { PO_PARTICLE_C, PO_PARTICLE_CSV, PO_PARTICLE_LAMMPS } po_particle_format;

/* Their names, "c", "csv", "lammps"; ends with NULL. */
extern const char *const PO_PARTICLE_FORMATS[];

/* A law, its scene, and what is said beside it. */
typedef struct {
  const po_particle_law *law;
  const po_request *request; /* in SI units, if it was given so; then the text is, too */
  const char *name;          /* of the function, the macros and the table: a C identifier */
  const char *command;       /* that makes the same */
  /* The numbers of the law with half and with twice the radius, in the same units; NULL: the scene
   * has no law of another radius. */
  const po_particle_numbers *half, *twice;
} po_particle_text;

/* Appends what the law is: units, for which particles it holds, its numbers and its errors. Given:
 * `before`, the beginning of each line. */
void po_particle_text_describe(const po_particle_text *t, const char *before, po_text *text);

/* Appends the law in a format. Status: PO_BAD_INPUT if the format cannot hold it: LAMMPS has a
 * distance of centres only for spheres. */
po_status po_particle_text_add(const po_particle_text *t, po_particle_format format, po_text *text);

#endif
