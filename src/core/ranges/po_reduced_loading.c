/* Where loading is reversed at the true range.
 *
 * A smaller range lets loading jump later: the crest of a wave is attracted from less far away. The
 * place of such a jump changes with another power of the range than other numbers
 * (po_range_side_of). Where loading reaches the preload before a jump at the true range, and does
 * not at a greater one, it is reversed on another stretch of the branch, and another pull-off
 * follows. */
#include <math.h>

#include "po_reduced_internal.h"

/* Finds out on which side of the preload a point of loading is at the true range. Given: whether
 * its load or its approach counts. Returned: *side: -1: below, the jump is made; 1: above, it is
 * not; 0: unknown. */
static po_status find_side(const po_range_follower *f, const po_kept_point *p, bool by_load,
                           int *side) {
  const po_preload preload = po_request_preload(f->ranges->request);
  double value[PO_MOST_RANGES];
  po_status status = po_range_course_begin(f->course, p, f->track);
  *side = 0;
  for (int at = f->trace->at; !status; ++at) {
    const po_special_point *here = &f->track->at[at].point;
    value[at] = by_load ? here->load : here->approach * f->ranges->range[at];
    if (at > f->trace->at)
      *side = po_range_side_of(f->ranges, f->trace->at, at, value,
                               by_load ? preload.load : preload.approach);
    if (*side || at + 1 == f->ranges->all)
      return PO_OK;
    status = po_range_course_next(f->course, true, f->track);
  }
  return status;
}

/* A jump of loading: the fold, and the point with the greatest load since the jump before. */
typedef struct {
  const po_kept_point *fold, *crest; /* fold NULL: there is none */
} jump;

/* The next jump of loading before the preload. Given: *k, the index of the kept point to begin
 * with. Returned: *k, where to go on. */
static jump next_jump(const po_range_trace *t, const po_preload *preload, size_t *k) {
  const po_kept_point *crest = NULL;
  for (; *k < t->kept.count; ++*k) {
    const po_kept_point *p = &t->kept.points[*k];
    if (p->kind != PO_POINT_APPROACH_MAX && p->kind != PO_POINT_LOAD_MAX)
      continue;
    if (p->load >= preload->load || p->approach >= preload->approach)
      break;
    if (!crest || p->load > crest->load)
      crest = p;
    if (p->kind == PO_POINT_APPROACH_MAX) {
      ++*k;
      return (jump){p, crest};
    }
  }
  return (jump){NULL, NULL};
}

/* Whether a jump of loading before the preload is made at the true range, as find_side. A maximum
 * of the load that ends at a smaller range leaves the greatest load to the fold. */
static po_status find_side_of_jump(const po_range_follower *f, const jump *j, bool by_load,
                                   int *side) {
  po_status status = find_side(f, by_load ? j->crest : j->fold, by_load, side);
  if (status == PO_NOT_FOUND && by_load && j->crest != j->fold)
    status = find_side(f, j->fold, by_load, side);
  if (status != PO_NOT_FOUND && status != PO_NOT_CONVERGED)
    return status;
  *side = 0;
  return PO_OK;
}

po_status po_range_find_reversal(const po_range_follower *f, bool *known,
                                 const po_kept_point **before) {
  const po_request request = po_reduced_request(f->ranges->request, f->ranges->range[f->trace->at]);
  const po_preload preload = po_request_preload(&request);
  int side = -1;
  *before = NULL;
  for (int by_load = 0; by_load < 2; ++by_load) {
    if (isnan(by_load ? preload.load : preload.approach))
      continue;
    size_t k = 0;
    for (jump j = next_jump(f->trace, &preload, &k); j.fold && side == -1;
         j = next_jump(f->trace, &preload, &k)) {
      const po_status status = find_side_of_jump(f, &j, by_load, &side);
      if (status)
        return status;
      if (side > 0 && (!*before || j.fold->position < (*before)->position))
        *before = j.fold;
    }
    side = side > 0 ? -1 : side;
  }
  *known = side == -1;
  return PO_OK;
}
