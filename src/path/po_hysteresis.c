#include "po_hysteresis.h"

#include <math.h>

po_status po_hysteresis_follow(const po_path *path, po_preload preload, po_hysteresis *hysteresis) {
  *hysteresis = (po_hysteresis){.load = {.control = PO_LOAD_CONTROL}};
  po_status status =
      po_loop_follow(path, PO_DISPLACEMENT_CONTROL, preload, &hysteresis->displacement);
  if (status)
    return status;
  const po_preload load = {(double)NAN, fmax(0.0, hysteresis->displacement.preload.load)};
  status = po_loop_follow(path, PO_LOAD_CONTROL, load, &hysteresis->load);
  if (status)
    po_hysteresis_clear(hysteresis);
  return status;
}
