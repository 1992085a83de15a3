/* How large a contact must be for no minimum of the load beyond to be deeper. */
#ifndef PO_LOAD_BOUND_H
#define PO_LOAD_BOUND_H

#include "po_scene.h"

/* A po_load_bound by the JKR theory (Eq 5). NAN for a rigid scene. */
double po_load_bound_of_jkr(const po_scene *scene, double load);

#endif
