#include "po_result.h"

#include <math.h>
#include <stdlib.h>

po_result po_result_none(void) {
  const po_preload unknown = {(double)NAN, (double)NAN};
  return (po_result){
      .status = PO_OK,
      .start = NAN,
      .ended = {.approach = NAN, .load = NAN},
      .profile_approach = NAN,
      .uncertainty = NAN,
      .parabola = {.wide = NAN, .limit = NAN, .sphere = NAN},
      .pull_off = {.full_disc = NAN, .excess = NAN, .pressed = unknown, .until = unknown},
      .pull_off_any = {.pressed = unknown, .searched = unknown},
      .range = {.least = NAN,
                .greatest = NAN,
                .change = NAN,
                .loops = {.least = NAN, .greatest = NAN, .approach = NAN, .load = NAN},
                .stairs = {.least = NAN, .greatest = NAN}},
      .diagnostics = {.residual = NAN,
                      .rounding = NAN,
                      .energy_defect = NAN,
                      .energy_defect_at = NAN,
                      .reverse_trace = {.excess = NAN},
                      .moved = {.change = NAN, .excess = NAN, .predicted = NAN}}};
}

void po_result_clear(po_result *result) {
  free(result->folds);
  free(result->extrema);
  free(result->curve);
  free(result->profile);
  free(result->annuli.compressed);
  free(result->annuli.held);
  po_hysteresis_clear(&result->hysteresis);
  po_staircases_clear(&result->staircase);
  po_hysteresis_clear(&result->theory.hysteresis);
  po_staircases_clear(&result->theory.staircase);
  free(result->rate.history);
  free(result->noise.change);
  free(result->interpolation.weights);
  free(result->uncertain);
  free(result->theories);
  free(result->parabola.theories);
  free(result->diagnostics.states);
  *result = po_result_none();
}

void po_work_add(const po_work *more, po_work *work) {
  work->points += more->points;
  work->newton_iterations += more->newton_iterations;
  work->factorizations += more->factorizations;
  work->kernel_evaluations += more->kernel_evaluations;
  work->meshes += more->meshes;
  work->nodes = work->nodes > more->nodes ? work->nodes : more->nodes;
  work->factorized_nodes = work->factorized_nodes > more->factorized_nodes ? work->factorized_nodes
                                                                           : more->factorized_nodes;
}
