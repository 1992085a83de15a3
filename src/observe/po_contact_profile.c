#include "po_contact_profile.h"

#include "po_contact.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_memory.h"

po_status po_contact_profile_take(const po_scene *scene, const po_surface *s,
                                  const po_branch_point *p, po_result *o) {
  const size_t most = p->gap ? p->n : s->resolved;
  po_profile_point *profile = po_resize(o->profile, most, sizeof *profile);
  if (!profile)
    return PO_NO_MEMORY;
  const double tabor = scene->tabor > 0.0 ? scene->tabor : 1.0;
  o->profile = profile;
  o->profile_count = 0;
  o->profile_approach = p->approach;
  for (size_t j = 0; j < most; ++j) {
    const double radius = p->gap ? p->node[j] : s->node[j];
    if (radius > s->core_radius)
      break;
    const double gap = p->gap ? p->gap[j] : po_initial_gap(scene, radius) - p->approach;
    profile[o->profile_count++] = (po_profile_point){
        .radius = radius, .gap = gap, .traction = tabor * po_law_at(&scene->law, gap).traction};
  }
  const po_contact_gap field = po_contact_gap_of(scene, s->core_radius, p);
  return po_contact_annuli_fill(&field, &o->annuli);
}
