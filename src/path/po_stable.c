#include "po_stable.h"

#include <math.h>

double po_stable_controlled(const po_path *path, po_control control, size_t point) {
  const po_path_point *p = &path->point[point];
  return control == PO_LOAD_CONTROL ? p->load : p->approach;
}

po_path_axis po_stable_axis(po_control control) {
  return control == PO_LOAD_CONTROL ? PO_PATH_LOAD : PO_PATH_APPROACH;
}

bool po_stable_is(const po_path *path, po_control control, size_t point) {
  const po_path_point *p = &path->point[point];
  return point + 1 < path->count && p->unstable_modes == 0 && p[1].approach > p->approach &&
         po_stable_controlled(path, control, point + 1) >
             po_stable_controlled(path, control, point);
}

bool po_stable_find(const po_path *path, po_control control, size_t from, int by, double value,
                    po_path_place *found) {
  for (size_t k = from; by > 0 ? k + 1 < path->count : k-- > 0; k += by > 0) {
    if (!po_stable_is(path, control, k))
      continue;
    const double here = po_stable_controlled(path, control, k);
    const double next = po_stable_controlled(path, control, k + 1);
    if (by > 0 ? here <= value && value < next : here < value && value <= next) {
      *found = po_path_where(path, k, po_stable_axis(control), value);
      return true;
    }
  }
  return false;
}

po_path_state po_stable_apart(double load) {
  return (po_path_state){.approach = -INFINITY, .load = load, .position = (double)NAN};
}

double po_stable_potential(po_control control, const po_path_state *s) {
  if (control == PO_DISPLACEMENT_CONTROL)
    return s->energy;
  if (isinf(s->approach))
    return s->load == 0.0 ? 0.0 : (double)NAN;
  return s->energy - s->load * s->approach;
}

po_loss po_loss_of_jump(po_control control, const po_path_state *before, const po_path_state *after,
                        po_path_doubt doubt) {
  const double moved =
      control == PO_LOAD_CONTROL ? before->approach - after->approach : before->load - after->load;
  return (po_loss){
      .energy = po_stable_potential(control, before) - po_stable_potential(control, after),
      .moved = isfinite(moved) ? fabs(moved) : 0.0, /* separation is at a load that is exact */
      .size = 1.0 + fabs(before->load) + fabs(after->load),
      .doubt = doubt,
      .jumps = 1};
}

po_loss po_loss_sum(po_loss a, po_loss b) {
  return (po_loss){
      a.energy + b.energy,
      a.moved + b.moved,
      a.size + b.size,
      {a.doubt.interpolated + b.doubt.interpolated, a.doubt.of_points + b.doubt.of_points},
      a.jumps + b.jumps};
}
