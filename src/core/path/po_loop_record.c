#include "po_loop_record.h"

#include <math.h>

#include "po_memory.h"

/* Greatest difference of the mean load between two rows from that of the curve, relative to the
 * greatest tension: a tenth of the width of a line in a figure of 1000 pixels. Ten times more has a
 * third of the rows. */
static const double OF_LOAD = 1e-5;

/* Parts into which a segment may be halved in succession: rows at a fold, where the load is a
 * square root, are then closer than any reader resolves. */
enum { MOST_HALVINGS = 12 };

po_loop_record po_loop_record_begin(const po_path *path, po_control control, po_loop *loop) {
  po_loop_record r = {.path = path, .control = control, .loading = true, .loop = loop};
  loop->has_rows = loop->has_rows && control != PO_LOAD_CONTROL;
  loop->row_area_error = loop->has_rows ? 0.0 : (double)NAN;
  for (size_t k = 0; k < path->count; ++k)
    r.unit = fmax(r.unit, -path->point[k].load);
  return r;
}

static po_status add(po_loop_record *r, po_loop_row row) {
  po_loop *loop = r->loop;
  po_loop_row *rows = po_grow(loop->row, loop->row_count, &r->room, sizeof *rows);
  if (!rows)
    return PO_NO_MEMORY;
  row.loading = r->loading;
  loop->row = rows;
  rows[loop->row_count++] = row;
  return PO_OK;
}

/* The row of a place; at an end of its segment exactly that point of the curve. */
static po_loop_row row_at(const po_loop_record *r, po_path_place place) {
  const po_curve_point *point = &r->path->point[place.index + (place.fraction == 1.0)];
  po_curve_rates rates = {point->approach_rate, point->load_rate};
  if (place.fraction == 1.0)
    place = (po_path_place){place.index + 1, 0.0};
  if (place.fraction != 0.0)
    rates = po_path_rates(r->path, place);
  return (po_loop_row){.state = po_path_at(r->path, place),
                       .stiffness =
                           rates.approach == 0.0 ? (double)NAN : rates.load / rates.approach};
}

static double base_of(const po_loop_record *r, const po_path_state *s) {
  return po_held(r->control, s->approach, s->load);
}

/* The area under the cubics less that under the straight line, over the position of the base. */
static double area_beyond(const po_loop_record *r, size_t index, double from, double to) {
  const po_path_state a = po_path_at(r->path, (po_path_place){index, from}),
                      b = po_path_at(r->path, (po_path_place){index, to});
  const double of_spring = 0.5 * (b.load - a.load) * (b.load + a.load) / r->control;
  return po_path_work(r->path, index, from, to) + of_spring -
         0.5 * (a.load + b.load) * (base_of(r, &b) - base_of(r, &a));
}

static po_status add_between(po_loop_record *r, size_t index, double from, double to,
                             int halvings) {
  const po_path_place end = {index, to};
  const po_path_state a = po_path_at(r->path, (po_path_place){index, from}),
                      b = po_path_at(r->path, end);
  const double beyond = area_beyond(r, index, from, to);
  const double way = fabs(base_of(r, &b) - base_of(r, &a)) + fabs(b.approach - a.approach);
  if (halvings < MOST_HALVINGS && fabs(beyond) > OF_LOAD * r->unit * way) {
    const double middle = 0.5 * (from + to);
    const po_status status = add_between(r, index, from, middle, halvings + 1);
    return status ? status : add_between(r, index, middle, to, halvings + 1);
  }
  r->loop->row_area_error += beyond;
  return add(r, row_at(r, end));
}

po_status po_loop_record_way(po_loop_record *r, size_t index, double from, double to) {
  if (!r->loop->has_rows)
    return PO_OK;
  po_status status = PO_OK;
  if (!r->loop->row_count)
    status = add(r, row_at(r, (po_path_place){index, from}));
  return status || from == to ? status : add_between(r, index, from, to, 0);
}

po_status po_loop_record_jump(po_loop_record *r, const po_path_place *to, po_path_state after) {
  if (!r->loop->has_rows)
    return PO_OK;
  po_loop_row row = {.state = after};
  if (to)
    row = row_at(r, *to);
  row.jump = true;
  return add(r, row);
}

void po_loop_rows_end(po_loop *loop) {
  const po_loop_row *first = NULL;
  size_t jump = 0;
  for (size_t k = 0; k < loop->row_count; ++k) {
    po_loop_row *row = &loop->row[k];
    if (row->jump) {
      row[-1].state = loop->jumps[jump].before;
      row->state = loop->jumps[jump].after;
      row->energy_lost = loop->jumps[jump++].energy_lost;
    }
    if (!first && row->loading && row->state.contact_radius > 0.0)
      first = row;
  }
  for (size_t k = 0; k < loop->row_count; ++k) {
    po_loop_row *row = &loop->row[k];
    row->base = po_held(loop->control, row->state.approach, row->state.load);
    row->indentation = first ? row->state.approach - first->state.approach : (double)NAN;
  }
}
