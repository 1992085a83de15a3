/* The dimensions of numbers, and their dimensionless units. */
#ifndef PO_DIMENSION_H
#define PO_DIMENSION_H

typedef enum {
  PO_DIMENSION_NONE = 1,  /* 0: the row states no dimension, which only numbers must */
  PO_DIMENSION_TIME,      /* s */
  PO_DIMENSION_LENGTH,    /* eps */
  PO_DIMENSION_GAP,       /* H = h/eps - 1 */
  PO_DIMENSION_LOAD,      /* pi w R, also by arclength */
  PO_DIMENSION_ENERGY,    /* pi w R eps */
  PO_DIMENSION_STIFFNESS, /* pi w R/eps */
  PO_DIMENSION_TRACTION,  /* w/(mu eps) */
  PO_DIMENSION_COUNT
} po_dimension;

#endif
