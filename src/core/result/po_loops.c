#include "po_loops.h"

#include <stdlib.h>

bool po_is_spring(po_control control) {
  return control > PO_LOAD_CONTROL && control < PO_DISPLACEMENT_CONTROL;
}

double po_held(po_control control, double approach, double load) {
  return control == PO_LOAD_CONTROL ? load : approach + load / control;
}

int po_modes_held(po_control control, int unstable_modes, double approach_rate, double load_rate) {
  return unstable_modes + (po_held(control, approach_rate, load_rate) * approach_rate < 0.0);
}

void po_hysteresis_clear(po_hysteresis *hysteresis) {
  for (int k = 0; k < PO_TESTS; ++k) {
    po_loop *loop = &hysteresis->of[k];
    free(loop->jumps);
    free(loop->row);
    *loop = (po_loop){.control = loop->control};
  }
}

void po_staircases_clear(po_staircases *staircases) {
  for (int t = 0; t < PO_TESTS; ++t) {
    po_staircase *staircase = &staircases->of[t];
    for (size_t k = 0; k < staircase->count; ++k)
      free(staircase->step[k].cycle);
    free(staircase->step);
    *staircase = (po_staircase){.control = staircase->control};
  }
  staircases->has_spring = false;
}
