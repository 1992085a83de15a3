/* The command line of a solve whose numbers may have a standard uncertainty: 0.08+-0.01. */
#ifndef PO_UNCERTAIN_LINE_H
#define PO_UNCERTAIN_LINE_H

#include "po_solve_line.h"

/* An option as it was given, in the order of the line. */
typedef struct {
  int option;
  char *text;              /* its value without the uncertainty, owned; NULL: it has none */
  double value, deviation; /* deviation 0: it is not uncertain */
} po_given_option;

typedef struct {
  po_solve_line line;
  const po_options *options;
  po_given_option *given; /* owned, as the next three */
  size_t count, room;
  po_variation *variation;
  po_solve_line *moved; /* the line with each uncertain number less and more */
} po_uncertain_line;

po_uncertain_line po_uncertain_line_begin(const po_options *options);

/* Takes one option of the command line (po_option_taker). */
po_status po_uncertain_line_take(void *line, int option);

/* Completes the request and checks it, also those with the uncertain numbers moved. */
po_status po_uncertain_line_end(po_uncertain_line *line);

/* Frees all that the line owns; its request must not be used any more. */
void po_uncertain_line_clear(po_uncertain_line *line);

#endif
