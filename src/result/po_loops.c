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

void po_loop_clear(po_loop *loop) {
  free(loop->jumps);
  *loop = (po_loop){.control = loop->control};
}

void po_hysteresis_clear(po_hysteresis *hysteresis) {
  for (int k = 0; k < PO_TESTS; ++k)
    po_loop_clear(&hysteresis->of[k]);
}

void po_staircase_clear(po_staircase *staircase) {
  for (size_t k = 0; k < staircase->count; ++k)
    free(staircase->step[k].cycle);
  free(staircase->step);
  *staircase = (po_staircase){.control = staircase->control};
}

void po_staircases_clear(po_staircases *staircases) {
  for (int k = 0; k < PO_TESTS; ++k)
    po_staircase_clear(&staircases->of[k]);
  staircases->has_spring = false;
}
