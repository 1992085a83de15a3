#include "po_load_bound.h"

#include "po_guduru.h"

/* TODO measured */
static const double EXCESS = 0.1, WAVES = 0.25;

double po_load_bound_of_jkr(const po_scene *scene, double load) {
  return po_guduru_last_minimum(scene, load, EXCESS) + WAVES * scene->wavelength;
}
