/* Solves with several ranges for what a trace leads to: loops, and staircases. */
#include <math.h>

#include "po_load_unit.h"
#include "po_reduced_internal.h"

/* The most ranges that are solved. */
enum { SOLVES = PO_RANGES_OF_LIMIT, MOST = 9 };

/* The traces of staircases end at this multiple of the preload, or of the default one: each is made
 * six times, and that to a hundred times takes five times as long. */
static const double HARDER = 10.0;

void po_range_solves_clear(po_range_solves *s) {
  for (int k = 0; k < s->count; ++k)
    po_result_clear(&s->solved[k]);
  s->count = 0;
}

/* Solves with one range and keeps the result; the first gives way if there are SOLVES. */
static po_status add_range(po_range_solves *s, double range, unsigned want,
                           po_reduced_solver *solve, po_work *work) {
  po_request request = po_reduced_request(s->request, range);
  request.want = want;
  request.watch = NULL;
  const double load = po_request_preload(s->request).load;
  request.hardest = HARDER * (load > 0.0 ? load : PO_USUAL_PRELOAD);
  po_result solved;
  const po_status status = solve(&request, NULL, &solved);
  po_work_add(&solved.work, work);
  if (status || !(want == PO_WANT_PRELOAD ? solved.has_staircases : solved.has_hysteresis)) {
    po_result_clear(&solved);
    return status;
  }
  if (s->count == SOLVES) {
    po_result_clear(&s->solved[0]);
    for (int k = 1; k < SOLVES; ++k) {
      s->solved[k - 1] = s->solved[k];
      s->range[k - 1] = s->range[k];
    }
    --s->count;
  }
  po_load_unit_lengthen(&solved, range);
  s->range[s->count] = range;
  s->solved[s->count++] = solved;
  return PO_OK;
}

static bool is_known(po_range_solves *s, po_range_judge *judge, double *excess) {
  *excess = INFINITY;
  if (s->count < SOLVES)
    return false;
  s->edges = po_range_limit_of(PO_BY_EDGES, s->range);
  s->crests = po_range_limit_of(PO_BY_CRESTS, s->range);
  return judge(s, excess);
}

po_status po_range_solves_make(const po_ranges *ranges, unsigned want, po_range_judge *judge,
                               po_reduced_solver *solve, po_range_solves *s, po_work *work,
                               bool *known) {
  *s = (po_range_solves){.request = ranges->request};
  po_status status = PO_OK;
  double excess = INFINITY;
  *known = false;
  for (int at = 0, made = 0;
       at < ranges->count && made < MOST && !status && excess > PO_RANGE_ENOUGH;
       at += PO_RANGE_STRIDE, ++made) {
    status = add_range(s, ranges->range[at], want, solve, work);
    const bool fails = status && !po_reduced_ends(status);
    if (fails)
      status = PO_OK;
    if (fails && *known) /* smaller ranges are harder */
      break;
    if (fails)
      po_range_solves_clear(s);
    *known = is_known(s, judge, &excess);
  }
  return status;
}
