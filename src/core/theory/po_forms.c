#include "po_forms.h"

#include <math.h>
#include <string.h>

#include "po_estimates.h"
#include "po_guduru.h"
#include "po_load_unit.h"
#include "po_maugis.h"
#include "po_persson_brener.h"
#include "po_quote.h"
#include "po_request.h"
#include "po_rigid_profile.h"
#include "po_suggest.h"
#include "po_theory_forces.h"

static void put(po_form_values *values, po_form_unit unit, const char *name, double value) {
  values->items[values->count++] = (po_form_value){name, unit, value, false};
}

/* Whether the forms of any profile apply. */
static bool is_general(const po_form_input *in) {
  return in->general || !po_scene_is_of_paper(&in->scene);
}

/* Appends a value that is infinite in the limit of a smooth sphere. */
static void put_limit(const po_form_input *in, po_form_values *v, po_form_unit unit,
                      const char *name, double value) {
  put(v, unit, name, value);
  v->items[v->count - 1].may_be_infinite = !po_scene_is_wavy(&in->scene);
}

static void put_contact(po_form_values *v, const char *const names[3], po_contact c) {
  put(v, PO_FORM_FORCE, names[0], c.load);
  put(v, PO_FORM_LENGTH, names[1], c.approach);
  put(v, PO_FORM_LENGTH, names[2], c.contact_radius);
}

static const char *const HERE[] = {"load", "approach", "contact_radius"};
static const char *const LAST[] = {"last_load", "last_approach", "last_contact_radius"};
static const char *const REVERSAL[] = {"reversal_load", "reversal_approach",
                                       "reversal_contact_radius"};
static const char *const LOWER[] = {"lower_load", "lower_approach", "lower_contact_radius"};
static const char *const UPPER[] = {"upper_load", "upper_approach", "upper_contact_radius"};

static void put_pull_off(po_form_values *v, double force, double approach) {
  put(v, PO_FORM_FORCE, "pull_off_force", force);
  put(v, PO_FORM_LENGTH, "pull_off_approach", approach);
}

static void put_pull_off_contact(po_form_values *v, po_contact c) {
  put_pull_off(v, -c.load, c.approach);
  put(v, PO_FORM_LENGTH, "pull_off_contact_radius", c.contact_radius);
}

/* The forms of any profile, waves and law. Each appends the same numbers whether it succeeds or
 * not: NAN, and the status, if not. */

static const po_contact NO_CONTACT = {NAN, NAN, NAN};

/* Keeps the first failure. */
static void note(po_form_values *v, po_status status) {
  if (!v->status)
    v->status = status;
}

static void jkr_of_profile(const po_form_input *in, po_form_values *v) {
  po_contact least = NO_CONTACT, last = NO_CONTACT;
  double gap = NAN, radius;
  note(v, po_jkr_profile_pull_off(&in->scene, PO_FIXED_LOAD, &least));
  if (!v->status)
    note(v, po_jkr_profile_pull_off(&in->scene, PO_FIXED_APPROACH, &last));
  if (!v->status)
    note(v, po_jkr_profile_check(&in->scene, least.contact_radius, &gap, &radius));
  put_pull_off_contact(v, least);
  put(v, PO_FORM_LENGTH, "pull_off_least_gap", gap);
  put_contact(v, LAST, last);
}

static void jkr_of_profile_along(const po_form_input *in, po_form_values *v) {
  const po_contact here = po_jkr_profile_at(&in->scene, in->at);
  double energy = NAN, gap = NAN, radius;
  note(v, po_jkr_profile_energy(&in->scene, in->at, &energy));
  if (!v->status)
    note(v, po_jkr_profile_check(&in->scene, in->at, &gap, &radius));
  put_contact(v, HERE, here);
  put(v, PO_FORM_PURE, "energy", energy);
  put(v, PO_FORM_PURE, "load_rate", po_jkr_profile_rate(&in->scene, PO_FIXED_LOAD, in->at));
  put(v, PO_FORM_PURE, "approach_rate", po_jkr_profile_rate(&in->scene, PO_FIXED_APPROACH, in->at));
  v->items[v->count - 1].may_be_infinite = in->at == 0.0;
  put(v, PO_FORM_LENGTH, "least_gap", gap);
}

static double tension_of(const po_form_input *in) {
  return in->tension > 0.0 ? in->tension : po_maugis_matched_tension(&in->scene);
}

static void solve_pull_off(const po_form_input *in, po_fixed fixed, po_form_values *v,
                           po_maugis *state) {
  const double tension = tension_of(in);
  *state = (po_maugis){NO_CONTACT, NAN, NAN};
  if (!v->status)
    note(v, po_maugis_pull_off(&in->scene, tension, fixed, false, state));
  if (!v->status)
    note(v, po_maugis_check(&in->scene, tension, state));
}

static void maugis(const po_form_input *in, po_form_values *v) {
  po_maugis least, last;
  solve_pull_off(in, PO_FIXED_LOAD, v, &least);
  solve_pull_off(in, PO_FIXED_APPROACH, v, &last);
  put(v, PO_FORM_TENSION, "tension", tension_of(in));
  put_pull_off_contact(v, least.contact);
  put(v, PO_FORM_LENGTH, "pull_off_end_of_tension", least.end);
  put_contact(v, LAST, last.contact);
}

static void maugis_along(const po_form_input *in, po_form_values *v) {
  const double tension = tension_of(in);
  po_maugis here = {NO_CONTACT, NAN};
  note(v, po_maugis_at(&in->scene, tension, in->at, &here));
  if (!v->status)
    note(v, po_maugis_check(&in->scene, tension, &here));
  put_contact(v, HERE, here.contact);
  put(v, PO_FORM_LENGTH, "end_of_tension", here.end);
}

/* All forms. */

static void bradley(const po_form_input *in, po_form_values *v) {
  (void)in;
  put_pull_off(v, 2.0, 0.0);
}

static void bradley_along(const po_form_input *in, po_form_values *v) {
  put(v, PO_FORM_FORCE, "load", po_bradley_load(in->at));
}

static void rigid(const po_form_input *in, po_form_values *v) {
  po_rigid_pull_off p;
  if (is_general(in))
    note(v, po_rigid_profile_pull_off(&in->scene, &p));
  else
    p = po_wavy_rigid_pull_off(in->scene.amplitude, in->alpha);
  put_pull_off(v, p.force, p.approach);
}

static void rigid_along(const po_form_input *in, po_form_values *v) {
  double load, rate;
  if (is_general(in))
    note(v, po_rigid_profile_load(&in->scene, in->at, &load, &rate));
  else
    load = po_wavy_rigid_load(in->scene.amplitude, in->alpha, in->at);
  put(v, PO_FORM_FORCE, "load", load);
}

static void jkr(const po_form_input *in, po_form_values *v) {
  if (is_general(in)) {
    jkr_of_profile(in, v);
    return;
  }
  put_pull_off_contact(v, po_jkr_pull_off(&in->scene));
  put_contact(v, LAST, po_jkr_last(&in->scene));
}

static void jkr_along(const po_form_input *in, po_form_values *v) {
  if (is_general(in))
    jkr_of_profile_along(in, v);
  else
    put_contact(v, HERE, po_jkr_at(&in->scene, in->at));
}

static void dmt(const po_form_input *in, po_form_values *v) {
  put_pull_off_contact(v, po_dmt_at(&in->scene, 0.0));
}

static void dmt_along(const po_form_input *in, po_form_values *v) {
  put_contact(v, HERE, po_dmt_at(&in->scene, in->at));
}

static void guduru(const po_form_input *in, po_form_values *v) {
  put_pull_off_contact(v, po_guduru_pull_off(&in->scene));
}

static void guduru_along(const po_form_input *in, po_form_values *v) {
  put_contact(v, HERE, po_guduru_at(&in->scene, in->at));
}

static void kesari_lew(const po_form_input *in, po_form_values *v) {
  put_limit(in, v, PO_FORM_PURE, "johnson_parameter", po_johnson_parameter(&in->scene));
  put(v, PO_FORM_WORK, "effective_work", po_kesari_lew_work(&in->scene));
  put(v, PO_FORM_FORCE, "pull_off_force", 1.5 * po_kesari_lew_work(&in->scene));
}

static void kesari_lew_along(const po_form_input *in, po_form_values *v) {
  put_contact(v, LOWER, po_kesari_lew_edge(&in->scene, in->at, -1));
  put_contact(v, UPPER, po_kesari_lew_edge(&in->scene, in->at, 1));
}

static void persson_tosatti(const po_form_input *in, po_form_values *v) {
  const po_persson_tosatti p = po_persson_tosatti_of(&in->scene);
  put_limit(in, v, PO_FORM_PURE, "johnson_parameter", po_johnson_parameter(&in->scene));
  put(v, PO_FORM_PURE, "area_ratio", p.area);
  put(v, PO_FORM_PURE, "area_ratio_printed", p.area_printed);
  put(v, PO_FORM_WORK, "effective_work", p.work);
  put(v, PO_FORM_WORK, "effective_work_with_area", p.work_with_area);
}

static void rumpf_rabinowicz(const po_form_input *in, po_form_values *v) {
  const double ratio = po_rumpf_rabinowicz_ratio(in->alpha, in->scene.radius);
  put(v, PO_FORM_PURE, "part_of_bradley", ratio);
  put(v, PO_FORM_FORCE, "pull_off_force", 2.0 * ratio);
}

static void compactness(const po_form_input *in, po_form_values *v) {
  const po_compactness c = po_compactness_of(&in->scene);
  put(v, PO_FORM_PURE, "bound", c.bound);
  put_limit(in, v, PO_FORM_PURE, "wavelength2_over_amplitude_radius", 1.0 / in->alpha);
  put(v, PO_FORM_LENGTH, "critical_radius", c.critical_radius);
}

static void crest(const po_form_input *in, po_form_values *v) {
  const po_crest c = po_crest_of(&in->scene);
  put_limit(in, v, PO_FORM_LENGTH, "crest_radius", c.radius);
  put(v, PO_FORM_LENGTH, "composite_radius", c.composite_radius);
  put(v, PO_FORM_FORCE, "pull_off_force", c.force);
}

static void lennard_jones(const po_form_input *in, po_form_values *v) {
  const po_lennard_jones_peak peak = po_lennard_jones_greatest();
  (void)in;
  put(v, PO_FORM_TENSION, "peak_tension", peak.tension);
  put(v, PO_FORM_LENGTH, "peak_distance", peak.distance);
}

static void lennard_jones_along(const po_form_input *in, po_form_values *v) {
  put(v, PO_FORM_TENSION, "traction", po_lennard_jones_traction(in->at));
}

/* -- The state at a given load or approach, and after a preload -- */

/* The preload from which a viscoelastic body is unloaded: without one that of a solve, whose unit
 * of loads may be another. */
static po_preload preload_of(const po_form_input *in) {
  if (in->has_preload)
    return in->preload;
  po_request request = po_request_default();
  request.scene = in->scene;
  const po_scene solved = po_load_unit_request(&request).scene;
  return (po_preload){(double)NAN, PO_USUAL_PRELOAD * po_scene_load_unit(&solved)};
}

/* The forces of both limits are bounds in the limit of short range. */
static void persson_brener(const po_form_input *in, po_form_values *v) {
  const po_preload preload = preload_of(in);
  const double speeds[] = {in->unload_speed, 0.0, INFINITY};
  po_rate_theory of[] = {PO_NO_RATE_THEORY, PO_NO_RATE_THEORY, PO_NO_RATE_THEORY};
  po_jkr_preloaded state = {NO_CONTACT, NO_CONTACT, 0};
  note(v, po_jkr_after_preload(&in->scene, preload, &state));
  if (!v->status && !(state.reversal.contact_radius > 0.0))
    note(v, po_fail(PO_BAD_INPUT,
                    "loading to the preload, approach %.9g, makes no contact: expected "
                    "a harder one",
                    state.reversal.approach));
  for (int k = 0; k < 3 && !v->status; ++k) {
    const bool is_limit = speeds[k] == 0.0 || isinf(speeds[k]);
    note(v, (is_limit ? po_persson_brener_limit
                      : po_persson_brener_of)(&in->scene, &in->creep, speeds[k], preload, &of[k]));
  }
  put(v, PO_FORM_WORK, "effective_work", of->work);
  put_pull_off_contact(v, (po_contact){-of->force, of->approach, of->contact_radius});
  put(v, PO_FORM_PURE, "edge_speed", of->edge_speed);
  v->items[v->count - 1].may_be_infinite = isinf(in->unload_speed);
  put(v, PO_FORM_FORCE, "relaxed_force", of[1].force);
  put(v, PO_FORM_FORCE, "at_once_force", of[2].force);
  put_contact(v, REVERSAL, state.reversal);
}

/* Appends the states of the JKR curve after the preload. Returned: the contact radius at which
 * loading is reversed; INFINITY without a preload. */
static double jkr_after_preload(const po_form_input *in, po_form_values *v) {
  po_jkr_preloaded state = {NO_CONTACT, NO_CONTACT, 0};
  double gap = NAN, radius;
  if (!in->has_preload)
    return INFINITY;
  if (!v->status)
    note(v, po_jkr_after_preload(&in->scene, in->preload, &state));
  if (!v->status)
    note(v, po_jkr_profile_check(&in->scene, state.reversal.contact_radius, &gap, &radius));
  put_contact(v, REVERSAL, state.reversal);
  put(v, PO_FORM_LENGTH, "reversal_least_gap", gap);
  put(v, PO_FORM_PURE, "loading_jumps", (double)state.loading_jumps);
  put(v, PO_FORM_FORCE, "after_preload_force", fmax(0.0, -state.pull_off.load));
  put(v, PO_FORM_LENGTH, "after_preload_approach", state.pull_off.approach);
  put(v, PO_FORM_LENGTH, "after_preload_contact_radius", state.pull_off.contact_radius);
  return state.reversal.contact_radius;
}

/* Finds the contact radius of the stable state that is held, within that of the preload. */
static po_status find_radius(const po_form *form, const po_form_input *in, double within,
                             double *a) {
  const bool by_load = in->held == PO_FORM_HOLDS_LOAD;
  const po_fixed fixed = by_load ? PO_FIXED_LOAD : PO_FIXED_APPROACH;
  const double least = by_load ? -2.0 : 0.0;
  *a = NAN;
  if (form->along == maugis_along)
    return po_maugis_outermost(&in->scene, tension_of(in), fixed, in->value, a);
  if (form->along != dmt_along)
    return po_jkr_profile_outermost(&in->scene, fixed, in->value, within, a);
  *a = po_dmt_radius(&in->scene, fixed, in->value);
  return in->value >= least
             ? PO_OK
             : po_fail(PO_NOT_FOUND, "DMT has no contact at %s %.9g: expected at least %g",
                       by_load ? "load" : "approach", in->value, least);
}

/* Appends the state that is held. It has the held number as it was given. */
static void held_state(const po_form *form, const po_form_input *in, double within,
                       po_form_values *v) {
  po_form_input here = *in;
  const size_t first = v->count;
  const char *held = HERE[in->held == PO_FORM_HOLDS_LOAD ? 0 : 1];
  note(v, find_radius(form, in, within, &here.at));
  if (v->status)
    return;
  form->along(&here, v);
  for (size_t i = first; i < v->count; ++i)
    if (strcmp(v->items[i].name, held) == 0)
      v->items[i].value = in->value;
}

/* -- The table -- */

enum {
  WAVES = PO_TAKES_AMPLITUDE | PO_TAKES_WAVELENGTH | PO_TAKES_RADIUS,
  ALL = PO_TAKES_TABOR | WAVES,
  STATES = PO_TAKES_STATE | PO_TAKES_CURVE
};

#define LOWEST "any that reaches this pull-off, the lowest minimum over every contact radius"

static const po_form FORMS[] = {
    {"bradley", bradley, bradley_along, PO_FORM_AT_APPROACH, 0, 0,
     "Eq 23; Bradley 1932: rigid smooth sphere", "any: rigid bodies have one load at an approach"},
    {"rigid", rigid, rigid_along, PO_FORM_AT_APPROACH, PO_NEEDS_ALPHA | PO_NEEDS_AMPLITUDE,
     WAVES | PO_TAKES_ALPHA | PO_TAKES_PROFILE | PO_TAKES_LAW,
     "Eqs 21 and 22, other profiles and laws Derjaguin 1934: rigid bodies",
     "any: rigid bodies have one load at an approach"},
    {"jkr", jkr, jkr_along, PO_FORM_AT_CONTACT_RADIUS, PO_NEEDS_ELASTIC,
     ALL | PO_TAKES_PROFILE | PO_TAKES_PRELOAD | STATES,
     "Eqs 7 and 8, other profiles and waves Sneddon 1965; Johnson, Kendall and Roberts 1971",
     LOWEST},
    {"dmt", dmt, dmt_along, PO_FORM_AT_CONTACT_RADIUS, PO_NEEDS_ELASTIC,
     PO_TAKES_TABOR | PO_TAKES_RADIUS | STATES,
     "Derjaguin, Muller and Toporov 1975: Hertz contact under the load and 2 pi w R",
     "any: DMT has one state at a load"},
    {"maugis", maugis, maugis_along, PO_FORM_AT_CONTACT_RADIUS, PO_NEEDS_ELASTIC,
     ALL | PO_TAKES_PROFILE | PO_TAKES_LAW | PO_TAKES_TENSION | STATES,
     "Maugis 1992, any profile and waves: a constant tension around a full disc of contact",
     LOWEST},
    {"guduru", guduru, guduru_along, PO_FORM_AT_CONTACT_RADIUS, PO_NEEDS_WAVES | PO_NEEDS_ELASTIC,
     ALL | PO_TAKES_PRELOAD | STATES,
     "Eq 5; Guduru 2007: JKR of a wavy sphere, contact on a full disc", LOWEST},
    {"kesari-lew", kesari_lew, kesari_lew_along, PO_FORM_AT_CONTACT_RADIUS,
     PO_NEEDS_WAVES | PO_NEEDS_ELASTIC, ALL, "Eq 24; Kesari and Lew 2011: envelope of Eq 5",
     "one that closes all grooves of many waves"},
    {"persson-tosatti", persson_tosatti, NULL, PO_FORM_AT_NOTHING,
     PO_NEEDS_WAVES | PO_NEEDS_ELASTIC, ALL,
     "Eqs 25 to 30; Persson and Tosatti 2001: energy of complete contact",
     "one that closes all grooves"},
    {"persson-brener", persson_brener, NULL, PO_FORM_AT_NOTHING, PO_NEEDS_ELASTIC | PO_NEEDS_RATE,
     ALL | PO_TAKES_PROFILE | PO_TAKES_LAW | PO_TAKES_RATE,
     "Persson and Brener 2005: work of adhesion of a moving edge, JKR of the relaxed body",
     "slow loading to the preload that a solve has by default, where the body is relaxed"},
    {"rumpf-rabinowicz", rumpf_rabinowicz, NULL, PO_FORM_AT_NOTHING, PO_NEEDS_ALPHA,
     WAVES | PO_TAKES_ALPHA, "Eq 20; Rumpf 1990, Rabinowicz: rigid crest on a rigid sphere",
     "any: rigid bodies have one load at an approach"},
    {"compactness", compactness, NULL, PO_FORM_AT_NOTHING, PO_NEEDS_WAVES, WAVES,
     "Eqs 3 and 4: geometry", NULL},
    {"crest", crest, NULL, PO_FORM_AT_NOTHING, PO_NEEDS_WAVES, WAVES,
     "Eqs 18 and 19: rigid central crest", "any: rigid bodies have one load at an approach"},
    {"lennard-jones", lennard_jones, lennard_jones_along, PO_FORM_AT_GAP, 0, 0,
     "Eq 9: traction-separation law", NULL}};

const char *po_form_preload(const po_form *form, const po_form_input *input) {
  if (input->has_preload && form->takes & PO_TAKES_RATE)
    return "slow loading to the preload, where the body is relaxed";
  return input->has_preload
             ? "of after_preload: loading at given approach from separation, with the jumps of "
               "this theory; of pull_off: any"
             : form->preload;
}

const char *po_form_branch(const po_form_input *input) {
  if (input->held == PO_FORM_HOLDS_NOTHING)
    return NULL;
  const bool by_load = input->held == PO_FORM_HOLDS_LOAD;
  if (input->has_preload)
    return by_load ? "stable at given load: that of unloading after the preload"
                   : "stable at given approach: that of unloading after the preload";
  return by_load ? "stable at given load: that of unloading from the hardest preload"
                 : "stable at given approach: that of unloading from the hardest preload";
}

const char *const PO_FORM_NAMES =
    "bradley, rigid, jkr, dmt, maugis, guduru, kesari-lew, persson-tosatti, "
    "persson-brener, rumpf-rabinowicz, compactness, crest or lennard-jones";

const po_form *po_form_find(const char *name) {
  for (size_t i = 0; i < sizeof FORMS / sizeof *FORMS; ++i)
    if (strcmp(name, FORMS[i].name) == 0)
      return &FORMS[i];
  return NULL;
}

po_status po_form_refuse(const char *name) {
  char shown[PO_QUOTE_LENGTH];
  return po_suggest(po_fail(PO_BAD_INPUT, "no closed form is named %s: expected %s",
                            po_quote(name, shown), PO_FORM_NAMES),
                    name, PO_FORM_NAMES);
}

bool po_form_lacks_rate(const po_form *form, const po_form_input *input) {
  return form->needs & PO_NEEDS_RATE &&
         (input->creep.kind == PO_CREEP_NONE || isnan(input->unload_speed));
}

unsigned po_form_takes(const po_form *form, bool alpha_is_given) {
  const unsigned in_place = form->needs & PO_NEEDS_AMPLITUDE
                                ? PO_TAKES_WAVELENGTH | PO_TAKES_RADIUS
                                : PO_TAKES_WAVELENGTH | PO_TAKES_AMPLITUDE;
  const unsigned replaced = in_place | PO_TAKES_PROFILE | PO_TAKES_LAW;
  return alpha_is_given && form->takes & PO_TAKES_ALPHA ? form->takes & ~replaced : form->takes;
}

po_status po_form_evaluate(const po_form *form, const po_form_input *input,
                           po_form_values *values) {
  values->count = 0;
  values->status = PO_OK;
  form->fixed(input, values);
  if (!isnan(input->at) && !values->status)
    form->along(input, values);
  if (!values->status && form->takes & (PO_TAKES_PRELOAD | PO_TAKES_STATE)) {
    const double within = jkr_after_preload(input, values);
    if (input->held && !values->status)
      held_state(form, input, within, values);
  }
  if (values->status) /* a state that does not exist was asked for */
    return values->status == PO_NOT_FOUND ? PO_BAD_INPUT : values->status;
  for (size_t i = 0; i < values->count; ++i) {
    const po_form_value *item = &values->items[i];
    if (!isfinite(item->value) && !(isinf(item->value) && item->may_be_infinite))
      return po_fail(
          PO_BAD_INPUT,
          "%s of theory %s cannot be computed: an intermediate value exceeds the range of "
          "double precision; expected values of more similar size",
          item->name, form->name);
  }
  return PO_OK;
}

const char *const PO_FORM_VARIABLES[] = {"", "approach", "contact_radius", "gap"};
