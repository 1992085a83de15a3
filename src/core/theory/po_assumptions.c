#include "po_assumptions.h"

#include <math.h>

#include "po_abel.h"
#include "po_elementary.h"
#include "po_estimates.h"
#include "po_maugis.h"

/* -- What each theory assumes -- */

typedef struct {
  po_assumption of;
  bool at_least;
  double limit;
} assumption;

/* Limits of the assumptions, such that a theory is within 5 % where they hold, and the
 * interpolations of the smooth sphere within 7 % (tests/estimates/theories.py). A theory of many
 * waves in the contact needs so MANY_WAVES. Theories that leave the work of adhesion at the mean
 * energy need a BARRIER of the waves that is small. That of one crest needs a next crest that is
 * farther away than NEXT_CREST eps. */
static const double ELONGATION = 0.2, TOUCH = 0.05, ZONE = 0.05, FLAT = 0.06, EFFECT = 0.05,
                    MANY_WAVES = 2.0, BARRIER = 0.01, NEXT_CREST = 40.0;

/* The same of viscoelastic bodies (reports/rate; the case rate_speed). */
static const double SLOW = 0.03, AT_ONCE = 0.95, EDGE_ZONE = 0.05, RELAXED = 0.3, FLATTENED = 3.0,
                    BEYOND = 1.02;

#define STIFF                                                                                      \
  { PO_ASSUMES_ELONGATION, false, ELONGATION }
#define SHORT_ZONE                                                                                 \
  { PO_ASSUMES_ZONE, false, ZONE }
#define WEAK_FLAT                                                                                  \
  { PO_ASSUMES_FLAT, false, FLAT }
#define FULL                                                                                       \
  { PO_ASSUMES_FULL_DISC, true, 1.0 }
#define NO_WAVES                                                                                   \
  { PO_ASSUMES_EFFECT, false, EFFECT }
#define WAVES                                                                                      \
  { PO_ASSUMES_WAVES, true, MANY_WAVES }

enum { MOST_ASSUMPTIONS = 4 };

/* The first one of PO_ASSUMES_NOTHING ends the list. */
static const assumption ASSUMES[PO_THEORY_COUNT][MOST_ASSUMPTIONS] = {
    [PO_THEORY_RIGID] = {STIFF},
    [PO_THEORY_DMT] = {STIFF, {PO_ASSUMES_TOUCH, false, TOUCH}},
    [PO_THEORY_JKR] = {SHORT_ZONE, WEAK_FLAT, FULL, {PO_ASSUMES_SLOW, false, SLOW}},
    [PO_THEORY_MAUGIS] = {{PO_ASSUMES_FORM, false, EFFECT}, WEAK_FLAT, FULL},
    [PO_THEORY_CARPICK] = {NO_WAVES},
    [PO_THEORY_PIETREMENT] = {NO_WAVES},
    [PO_THEORY_SCHWARZ] = {NO_WAVES},
    [PO_THEORY_GUDURU] = {SHORT_ZONE, WEAK_FLAT, FULL},
    [PO_THEORY_KESARI_LEW] = {SHORT_ZONE, FULL, WAVES},
    [PO_THEORY_PERSSON_TOSATTI] = {SHORT_ZONE, FULL, WAVES, {PO_ASSUMES_BARRIER, false, BARRIER}},
    [PO_THEORY_RUMPF] = {STIFF, {PO_ASSUMES_NEXT_CREST, true, NEXT_CREST}},
    [PO_THEORY_PERSSON_BRENER] = {{PO_ASSUMES_EDGE_ZONE, false, EDGE_ZONE},
                                  {PO_ASSUMES_RELAXED, false, RELAXED},
                                  WEAK_FLAT,
                                  FULL},
    [PO_THEORY_JKR_AT_ONCE] = {{PO_ASSUMES_AT_ONCE, true, AT_ONCE},
                               {PO_ASSUMES_EDGE_ZONE, false, EDGE_ZONE},
                               {PO_ASSUMES_BEYOND, true, BEYOND},
                               FULL},
    [PO_THEORY_RIGID_AT_ONCE] = {
        {PO_ASSUMES_AT_ONCE, true, AT_ONCE}, STIFF, {PO_ASSUMES_FLATTENED, true, FLATTENED}}};

/* -- The numbers -- */

/* For profiles sharper than a sphere the zone counts more: the error of JKR for r^n, over d/a, is
 * about 4, 2, 1.2 and 0.65 for n = 1, 1.25, 1.5 and 2, which goes as n^-2.5. */
static const double OF_SHARPNESS = 2.5;

/* That factor, by the exponent n = r f'/f of the profile at the radius a; 1 for blunter ones. */
static double sharpness_of(const po_scene *scene, double a) {
  const double gap = po_profile_gap(&scene->profile, scene->radius, a);
  const double n = a * po_profile_slope(&scene->profile, scene->radius, a) / gap;
  return n > 0.0 && n < 2.0 ? po_pow(2.0 / n, OF_SHARPNESS) : 1.0;
}

/* d over the length l. */
static double zone_of(const po_scene *scene, double tension, double a) {
  const double c = po_scene_coupling(scene), rate = 3.0 * sqrt(0.5 * M_PI * c / a);
  double per_length = sharpness_of(scene, a) / a;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) { /* |g''| <= (pi/2) A k^2 sqrt(2 k a/pi) */
    const po_wave wave = po_scene_wave(scene, k);
    const double number = 2.0 * M_PI / wave.length;
    per_length += M_PI_2 * wave.amplitude * number * number * sqrt(2.0 * number * a / M_PI) / rate;
  }
  return 0.25 * M_PI / (c * tension * tension) * per_length;
}

/* The stress of the flat over the greatest tension, times b/a where the contact is wider. */
static double stress_of_flat(const po_scene *scene, double tension, double a) {
  const double b = po_profile_radius_of_gap(&scene->profile, scene->radius, 0.0);
  return b > 0.0 ? fmin(1.0, b / a) / (tension * sqrt(po_scene_coupling(scene) * b)) : 0.0;
}

/* Displacement of A, in ranges of the law, by a short wave that is not flattened: of the energy,
 * and so of the force, twice the range is lost by the mean of the wave. */
static const double OF_RANGE = 2.0;

/* The effect of the waves on the force of a sphere, relative; at most 1. */
static double effect_of_waves(const po_scene *scene, double tension) {
  double sum = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double number = 2.0 * M_PI / wave.length;
    const double flattened = sqrt(number / po_scene_coupling(scene));
    sum +=
        wave.amplitude * fmin(number * number * scene->radius, fmin(OF_RANGE * tension, flattened));
  }
  return fmin(1.0, sum);
}

/* A sqrt(pi/(2 c lambda)) of all waves: the root of the work of adhesion in Eq 24, less 1. */
static double barrier_of_waves(const po_scene *scene) {
  double sum = 0.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    sum += wave.amplitude * sqrt(M_PI / (2.0 * po_scene_coupling(scene) * wave.length));
  }
  return sum;
}

/* Whether the gap rises everywhere, so that JKR theory has a full disc: of the sphere with one
 * wave, Eqs 3 and 4; profiles without waves. */
static bool is_compact(const po_scene *scene) {
  if (!po_scene_is_wavy(scene))
    return po_abel_fall(scene) == 0.0;
  return po_scene_is_of_paper(scene) &&
         po_scene_alpha(scene) * po_compactness_of(scene).bound < 1.0;
}

/* The part of the contact radius without a groove and the contact radius, of a scene that is not
 * solved: in the JKR theory. NAN: only the solve decides, as where grooves may be open. */
static void find_unsolved(const po_scene *scene, double a, double *full_disc, double *radius) {
  double gap, outside;
  *full_disc = is_compact(scene) ? 1.0 : (double)NAN;
  *radius = a;
  if (isnan(*full_disc) && isfinite(a) && !po_jkr_profile_check(scene, a, &gap, &outside) &&
      gap < 0.0)
    *full_disc = 0.0;
  po_message_clear();
}

/* The numbers of a viscoelastic body; of an elastic one that of JKR, which holds. If the tension at
 * once is greatest where the relaxed contact ends, the edge has not receded yet, and the force
 * depends on the cohesive zone: JKR is up to 14 % above. The flattened
 * sphere has the radius R/k, its attraction the range 1/s, and the deformation of rigid bodies by
 * it goes as the coupling times the root of the radius. */
static void find_of_rate(const po_request *request, double tension, const po_closed_states *states,
                         double number[PO_ASSUMPTION_COUNT]) {
  const po_rate_theory *edge = &states->edge;
  const po_creep *creep = &request->creep;
  const double k = creep->ratio, a = edge->contact_radius;
  const bool creeps = creep->kind != PO_CREEP_NONE;
  number[PO_ASSUMES_SLOW] = creeps ? edge->work - 1.0 : 0.0;
  number[PO_ASSUMES_AT_ONCE] = k * edge->work;
  number[PO_ASSUMES_EDGE_ZONE] = edge->work * zone_of(&request->scene, tension, a);
  number[PO_ASSUMES_RELAXED] = edge->edge_speed * po_creep_mean_time(creep) / a;
  number[PO_ASSUMES_FLATTENED] =
      edge->preload_radius / sqrt(2.0 * request->scene.radius / (k * tension));
  number[PO_ASSUMES_BEYOND] = states->at_once.preload_radius / states->at_once.contact_radius;
  if (creeps)
    number[PO_ASSUMES_ELONGATION] *= sqrt(k);
  /* the states of these theories start at the relaxed contact */
  if (request->load_speed > 0.0 && isfinite(request->dwell) && request->unload_speed > 0.0)
    number[PO_ASSUMES_RELAXED] = number[PO_ASSUMES_FLATTENED] = number[PO_ASSUMES_BEYOND] = NAN;
}

void po_assumptions_find(const po_request *request, const po_result *result,
                         const po_closed_states *states, double number[PO_ASSUMPTION_COUNT]) {
  const po_scene *scene = &request->scene;
  const double tension = po_maugis_matched_tension(scene), a = states->jkr.contact_radius;
  const bool is_sphere = po_profile_is_sphere(&scene->profile),
             is_solved =
                 result->has_pull_off && !result->status && request->creep.kind == PO_CREEP_NONE;
  const double zone = zone_of(scene, tension, a),
               effect = is_sphere ? effect_of_waves(scene, tension) : 1.0;
  const double length = po_abel_longest_wave(scene);
  double full_disc = result->pull_off.full_disc, radius = result->pull_off.contact_radius;
  if (!is_solved)
    find_unsolved(scene, a, &full_disc, &radius);
  number[PO_ASSUMES_NOTHING] = NAN;
  number[PO_ASSUMES_ELONGATION] =
      tension * po_rigid_profile_elongation(scene, states->rigid.approach);
  number[PO_ASSUMES_TOUCH] = tension * fabs(states->rigid.approach);
  number[PO_ASSUMES_ZONE] = zone;
  number[PO_ASSUMES_FLAT] = stress_of_flat(scene, tension, a);
  number[PO_ASSUMES_FORM] = effect > 0.0 ? effect * zone / (1.0 + zone) : 0.0;
  number[PO_ASSUMES_FULL_DISC] = full_disc;
  number[PO_ASSUMES_WAVES] = radius / length;
  number[PO_ASSUMES_EFFECT] = effect;
  number[PO_ASSUMES_BARRIER] = barrier_of_waves(scene);
  number[PO_ASSUMES_NEXT_CREST] = 0.5 * length * length / scene->radius;
  find_of_rate(request, tension, states, number);
}

static po_holds holds(const assumption *a, double number) {
  if (isnan(number))
    return PO_HOLDS_UNKNOWN;
  return (a->at_least ? number >= a->limit : number <= a->limit) ? PO_HOLDS_YES : PO_HOLDS_NO;
}

void po_assumptions_decide(const double number[PO_ASSUMPTION_COUNT], po_theory_row *row) {
  const assumption *list = ASSUMES[row->theory], *decides = &list[0];
  row->holds = PO_HOLDS_YES;
  for (int k = 0; k < MOST_ASSUMPTIONS && list[k].of; ++k) {
    const po_holds found = holds(&list[k], number[list[k].of]);
    if (row->holds == PO_HOLDS_YES ? found != PO_HOLDS_YES
                                   : row->holds == PO_HOLDS_UNKNOWN && found == PO_HOLDS_NO) {
      row->holds = found;
      decides = &list[k];
    }
  }
  row->decided_by = decides->of;
  row->number = number[decides->of];
  row->at_least = decides->at_least;
  row->limit = decides->limit;
}
