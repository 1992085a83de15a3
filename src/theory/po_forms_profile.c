#include "po_forms_profile.h"

#include <math.h>

#include "po_maugis.h"
#include "po_rigid_profile.h"

static const po_contact NO_CONTACT = {NAN, NAN, NAN};

void po_form_put(po_form_values *values, po_form_unit unit, const char *name, double value) {
  values->items[values->count++] = (po_form_value){name, unit, value, false};
}

/* Keeps the first failure. */
static void note(po_form_values *v, po_status status) {
  if (!v->status)
    v->status = status;
}

static void put_pull_off(po_form_values *v, po_contact c) {
  po_form_put(v, PO_FORM_FORCE, "pull_off_force", -c.load);
  po_form_put(v, PO_FORM_LENGTH, "pull_off_approach", c.approach);
  po_form_put(v, PO_FORM_LENGTH, "pull_off_contact_radius", c.contact_radius);
}

static void put_last(po_form_values *v, po_contact c) {
  po_form_put(v, PO_FORM_FORCE, "last_load", c.load);
  po_form_put(v, PO_FORM_LENGTH, "last_approach", c.approach);
  po_form_put(v, PO_FORM_LENGTH, "last_contact_radius", c.contact_radius);
}

static void put_here(po_form_values *v, po_contact c) {
  po_form_put(v, PO_FORM_FORCE, "load", c.load);
  po_form_put(v, PO_FORM_LENGTH, "approach", c.approach);
  po_form_put(v, PO_FORM_LENGTH, "contact_radius", c.contact_radius);
}

void po_form_jkr_profile(const po_form_input *in, po_form_values *v) {
  po_contact least = NO_CONTACT, last = NO_CONTACT;
  double gap = NAN, radius;
  note(v, po_jkr_profile_pull_off(&in->scene, PO_GIVEN_LOAD, &least));
  if (!v->status)
    note(v, po_jkr_profile_pull_off(&in->scene, PO_GIVEN_APPROACH, &last));
  if (!v->status)
    note(v, po_jkr_profile_check(&in->scene, least.contact_radius, &gap, &radius));
  put_pull_off(v, least);
  po_form_put(v, PO_FORM_LENGTH, "pull_off_least_gap", gap);
  put_last(v, last);
}

void po_form_jkr_profile_along(const po_form_input *in, po_form_values *v) {
  const po_contact here = po_jkr_profile_at(&in->scene, in->at);
  double energy = NAN, gap = NAN, radius;
  note(v, po_jkr_profile_energy(&in->scene, in->at, &energy));
  if (!v->status)
    note(v, po_jkr_profile_check(&in->scene, in->at, &gap, &radius));
  put_here(v, here);
  po_form_put(v, PO_FORM_PURE, "energy", energy);
  po_form_put(v, PO_FORM_PURE, "load_rate", po_jkr_profile_rate(&in->scene, PO_GIVEN_LOAD, in->at));
  po_form_put(v, PO_FORM_PURE, "approach_rate",
              po_jkr_profile_rate(&in->scene, PO_GIVEN_APPROACH, in->at));
  po_form_put(v, PO_FORM_LENGTH, "least_gap", gap);
  for (size_t k = v->count - 3; k < v->count - 1; ++k)
    v->items[k].may_be_infinite = in->at == 0.0; /* the curve begins with a vertical tangent */
}

static double tension_of(const po_form_input *in) {
  return in->tension > 0.0 ? in->tension : po_maugis_matched_tension(&in->scene);
}

static void solve_pull_off(const po_form_input *in, po_given given, po_form_values *v,
                           po_maugis *state) {
  const double tension = tension_of(in);
  *state = (po_maugis){NO_CONTACT, NAN};
  if (!v->status)
    note(v, po_maugis_pull_off(&in->scene, tension, given, false, state));
  if (!v->status)
    note(v, po_maugis_check(&in->scene, tension, state));
}

void po_form_maugis(const po_form_input *in, po_form_values *v) {
  po_maugis least, last;
  solve_pull_off(in, PO_GIVEN_LOAD, v, &least);
  solve_pull_off(in, PO_GIVEN_APPROACH, v, &last);
  po_form_put(v, PO_FORM_TENSION, "tension", tension_of(in));
  put_pull_off(v, least.contact);
  po_form_put(v, PO_FORM_LENGTH, "pull_off_end_of_tension", least.end);
  put_last(v, last.contact);
}

void po_form_maugis_along(const po_form_input *in, po_form_values *v) {
  const double tension = tension_of(in);
  po_maugis here = {NO_CONTACT, NAN};
  note(v, po_maugis_at(&in->scene, tension, in->at, &here));
  if (!v->status)
    note(v, po_maugis_check(&in->scene, tension, &here));
  put_here(v, here.contact);
  po_form_put(v, PO_FORM_LENGTH, "end_of_tension", here.end);
}

void po_form_rigid_profile(const po_form_input *in, po_form_values *v) {
  po_rigid_pull_off p;
  note(v, po_rigid_profile_pull_off(&in->scene, &p));
  po_form_put(v, PO_FORM_FORCE, "pull_off_force", p.force);
  po_form_put(v, PO_FORM_LENGTH, "pull_off_approach", p.approach);
}

void po_form_rigid_profile_along(const po_form_input *in, po_form_values *v) {
  double load, rate;
  note(v, po_rigid_profile_load(&in->scene, in->at, &load, &rate));
  po_form_put(v, PO_FORM_FORCE, "load", load);
}
