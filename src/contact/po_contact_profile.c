#include "po_contact_profile.h"

#include "po_contact.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_memory.h"

po_status po_contact_profile_fill(const po_scene *scene, const po_surface *s,
                                  const po_branch_point *p, po_profile_point **profile,
                                  size_t *count) {
  const size_t most = p->gap ? p->n : s->resolved;
  po_profile_point *points = po_resize(*profile, most, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  const double tabor = scene->tabor > 0.0 ? scene->tabor : 1.0;
  *profile = points;
  *count = 0;
  for (size_t j = 0; j < most; ++j) {
    const double radius = p->gap ? p->node[j] : s->node[j];
    if (radius > s->core_radius)
      break;
    const double gap = p->gap ? p->gap[j] : po_initial_gap(scene, radius) - p->approach;
    points[(*count)++] = (po_profile_point){
        .radius = radius, .gap = gap, .traction = tabor * po_law_at(&scene->law, gap).traction};
  }
  return PO_OK;
}

po_status po_contact_profile_take(const po_scene *scene, const po_surface *s,
                                  const po_branch_point *p, po_result *o) {
  const po_status status = po_contact_profile_fill(scene, s, p, &o->profile, &o->profile_count);
  if (status)
    return status;
  o->profile_approach = p->approach;
  const po_contact_gap field = po_contact_gap_of(scene, s->core_radius, p);
  return po_contact_annuli_fill(&field, &o->annuli);
}
