/* The command line of `pulloff contact-law`, and the law of one scene. */
#ifndef PO_LAW_LINE_H
#define PO_LAW_LINE_H

#include "po_options.h"
#include "po_particle_text.h"

typedef struct {
  po_scene_options scene;
  po_request request;
  po_particle_format format;
  double error;
  const char *name, *output;
  const char *sets; /* a table of parameter sets; NULL: one scene, that of the options */
  int jobs;
} po_law_line;

/* The longest name of a function and a table. */
enum { PO_LAW_NAME_MOST = 60 };

/* The law of a scene as text. */
typedef struct {
  po_particle_numbers numbers;
  double error;           /* of the force, over the pull-off force */
  double parabola_excess; /* of the pull-off force of the parabola over that of the sphere, by JKR
                             theory; 0: there is no sphere to compare with */
  po_text file;           /* in the format of the line */
  po_text said;           /* what the law is */
} po_law_made;

/* Excess from which on a warning is due. */
extern const double PO_LAW_PARABOLA_EXCESS;

/* Completes the request from the texts of the scene: the preload of a sphere is PO_LAW_PRELOAD,
 * unless it is given. Given: whether unlikely inputs are remarked on standard error. Status:
 * PO_BAD_INPUT, and those of po_texts_read. */
po_status po_law_line_complete(po_law_line *line, bool warns);

/* Appends the command that makes the law of a completed line, but for its name and output. */
void po_law_line_add_command(const po_law_line *line, po_text *text);

/* Makes the law of a completed line. Returned: to be cleared also after a failure. Status: as
 * po_particle_law_make and po_particle_text_add. */
po_status po_law_line_make(const po_law_line *line, po_law_made *made);
void po_law_made_clear(po_law_made *made);

#endif
