/* The theories beside a result, and the theories of a solve. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "po_abel.h"
#include "po_assumptions.h"
#include "po_deadline.h"
#include "po_estimates.h"
#include "po_guduru.h"
#include "po_jkr_profile.h"
#include "po_maugis.h"
#include "po_memory.h"
#include "po_persson_brener.h"
#include "po_profile_kind.h"
#include "po_rigid_profile.h"
#include "po_theory_forces.h"

/* -- The values -- */

/* A scene, and what its closed forms have found so far. */
typedef struct {
  const po_request *request;
  const po_scene *scene;
  po_closed_states states;
} evaluation;

static po_status rigid(evaluation *e, double *force) {
  const po_status status = po_rigid_profile_pull_off(e->scene, &e->states.rigid);
  *force = e->states.rigid.force;
  return status;
}

/* At pull-off the bodies of this theory touch at a point, undeformed: on the axis the gap is that
 * of equilibrium. Of a sphere the force is 2 pi w R under every law. */
static po_status dmt(evaluation *e, double *force) {
  double load, rate;
  const po_status status = po_rigid_profile_load(e->scene, 0.0, &load, &rate);
  *force = -load;
  return status;
}

static po_status jkr(evaluation *e, double *force) {
  const po_status status = po_jkr_profile_pull_off(e->scene, PO_FIXED_LOAD, &e->states.jkr);
  *force = -e->states.jkr.load;
  return status;
}

static po_status maugis(evaluation *e, double *force) {
  const double tension = po_maugis_matched_tension(e->scene);
  po_maugis state;
  po_status status = po_maugis_pull_off(e->scene, tension, PO_FIXED_LOAD, true, &state);
  if (!status)
    status = po_maugis_check(e->scene, tension, &state);
  *force = -state.contact.load;
  return status;
}

/* Points of the curve, which take some tenths of a second: 500 waves. */
enum { MOST_POINTS = 1 << 16 };

/* After any preload it is the lowest minimum of the curve. */
static po_status guduru(evaluation *e, double *force) {
  const po_preload preload = po_request_preload(e->request);
  if (isinf(preload.approach))
    return jkr(e, force);
  po_hysteresis loops;
  const po_status status = po_jkr_hysteresis(e->scene, preload, (double)NAN, MOST_POINTS, &loops);
  *force = status ? NAN : fmax(0.0, -loops.of[PO_AT_APPROACH].pull_off.load);
  po_hysteresis_clear(&loops);
  return status;
}

static po_status rumpf(evaluation *e, double *force) {
  *force = 2.0 * po_rumpf_rabinowicz_ratio(po_scene_alpha(e->scene), e->scene->radius);
  return PO_OK;
}

/* The state of greatest tension at a speed of unloading. */
static po_status at_speed(const evaluation *e, double speed, po_rate_theory *state) {
  return po_persson_brener_of(e->scene, &e->request->creep, speed, po_request_preload(e->request),
                              state);
}

static po_status persson_brener(evaluation *e, double *force) {
  const po_status status = at_speed(e, e->request->unload_speed, &e->states.edge);
  *force = e->states.edge.force;
  return status;
}

static po_status jkr_at_once(evaluation *e, double *force) {
  const po_status status = at_speed(e, INFINITY, &e->states.at_once);
  *force = e->states.at_once.force;
  return status;
}

/* Bradley's 2 pi w R/k. The rigid sphere has its approach, too, which the assumptions ask for. */
static po_status rigid_at_once(evaluation *e, double *force) {
  const po_status status = rigid(e, force);
  *force /= e->request->creep.ratio;
  return status;
}

static double persson_tosatti_work(const po_scene *scene) {
  return po_persson_tosatti_of(scene).work_with_area;
}

/* -- The theories -- */

/* What a scene must be for a theory to exist. */
enum {
  NEEDS_ELASTIC = 1,
  NEEDS_SPHERE = 2,
  NEEDS_WAVES = 4,
  NEEDS_ONE_WAVE = 8,
  NEEDS_LENNARD_JONES = 16,
  NEEDS_NO_WAVES = 32
};

/* The force of a theory is evaluated for a scene, or from the parameter of Maugis, or is that of
 * JKR with an effective work of adhesion, in w, which may be negative. */
static const struct {
  unsigned needs;
  po_status (*evaluate)(evaluation *e, double *force);
  double (*of_parameter)(double parameter);
  double (*work)(const po_scene *scene);
} THEORIES[PO_THEORY_COUNT] = {
    [PO_THEORY_RIGID] = {0, rigid},
    [PO_THEORY_DMT] = {0, dmt},
    [PO_THEORY_JKR] = {NEEDS_ELASTIC, jkr},
    [PO_THEORY_MAUGIS] = {NEEDS_ELASTIC, maugis},
    [PO_THEORY_CARPICK] = {NEEDS_SPHERE, .of_parameter = po_carpick_force},
    [PO_THEORY_PIETREMENT] = {NEEDS_SPHERE, .of_parameter = po_pietrement_force},
    [PO_THEORY_SCHWARZ] = {NEEDS_SPHERE, .of_parameter = po_schwarz_force},
    [PO_THEORY_GUDURU] = {NEEDS_ELASTIC | NEEDS_WAVES, guduru},
    [PO_THEORY_KESARI_LEW] = {NEEDS_ELASTIC | NEEDS_SPHERE | NEEDS_ONE_WAVE,
                              .work = po_kesari_lew_work},
    [PO_THEORY_PERSSON_TOSATTI] = {NEEDS_ELASTIC | NEEDS_SPHERE | NEEDS_ONE_WAVE,
                                   .work = persson_tosatti_work},
    [PO_THEORY_RUMPF] = {NEEDS_SPHERE | NEEDS_ONE_WAVE | NEEDS_LENNARD_JONES, rumpf},
    [PO_THEORY_PERSSON_BRENER] = {NEEDS_ELASTIC, persson_brener},
    [PO_THEORY_JKR_AT_ONCE] = {NEEDS_ELASTIC, jkr_at_once},
    [PO_THEORY_RIGID_AT_ONCE] = {NEEDS_SPHERE | NEEDS_NO_WAVES, rigid_at_once}};

/* Whether a theory is one of the body: JKR is one of elastic and of relaxed ones. */
static bool is_of(po_theory theory, const po_request *request) {
  const bool creeps = request->creep.kind != PO_CREEP_NONE;
  return ((int)theory >= PO_THEORY_OF_RATE) == creeps || theory == PO_THEORY_JKR;
}

static po_status evaluate(po_theory theory, evaluation *e, double *force) {
  const po_scene *scene = e->scene;
  if (THEORIES[theory].evaluate)
    return THEORIES[theory].evaluate(e, force);
  *force = THEORIES[theory].work ? 1.5 * fmax(0.0, THEORIES[theory].work(scene))
                                 : THEORIES[theory].of_parameter(po_maugis_parameter(
                                       scene->tabor, po_maugis_matched_tension(scene)));
  return PO_OK;
}

/* Why a theory does not exist for a scene. Returned: false if it exists. */
static bool is_refused(unsigned needs, const po_scene *scene, po_theory_row *row) {
  const size_t waves = po_scene_waves(scene);
  const struct {
    bool is_so;
    const char *before, *what, *after;
  } reasons[] = {
      {needs & NEEDS_ELASTIC && !(scene->tabor > 0.0), "the bodies are rigid", "", ""},
      {needs & NEEDS_SPHERE && !po_profile_is_sphere(&scene->profile), "the profile is ",
       po_profile_name(&scene->profile), ", not a sphere"},
      {needs & (NEEDS_WAVES | NEEDS_ONE_WAVE) && waves == 0, "the surface has no waves", "", ""},
      {needs & NEEDS_NO_WAVES && waves > 0, "the surface has waves", "", ""},
      {needs & NEEDS_ONE_WAVE && waves > 1, "the surface has more than one wave", "", ""},
      {needs & NEEDS_LENNARD_JONES && po_law_index(&scene->law) != 0, "the law is ",
       po_law_name(&scene->law), ", not lennard-jones"}};
  for (size_t k = 0; k < sizeof reasons / sizeof *reasons; ++k)
    if (reasons[k].is_so) {
      snprintf(row->reason, sizeof row->reason, "%s%s%s", reasons[k].before, reasons[k].what,
               reasons[k].after);
      return true;
    }
  return false;
}

/* -- The rows -- */

static bool has_pull_off(const po_result *result) {
  return result->has_pull_off && !result->status;
}

static void compare(const po_result *result, po_theory_row *row) {
  const double force = has_pull_off(result) ? result->pull_off.force : (double)NAN,
               error = result->pull_off.force_error;
  row->deviation = row->force / force - 1.0;
  row->deviation_error = row->force / force * error / (force - error);
}

/* Whether a theory is a formula, which needs no time. */
static bool is_formula(po_theory theory) {
  return !THEORIES[theory].evaluate || THEORIES[theory].evaluate == rumpf;
}

/* The row of a theory. Given: `late`, whether the time is over; a search is then not begun. */
static po_theory_row row_of(po_theory theory, evaluation *e, const po_result *result, bool late) {
  po_theory_row row = {.theory = theory,
                       .force = NAN,
                       .deviation = NAN,
                       .deviation_error = NAN,
                       .number = NAN,
                       .limit = NAN};
  snprintf(row.source, sizeof row.source, "%s", PO_THEORIES[theory].source);
  if (is_refused(THEORIES[theory].needs, e->scene, &row))
    return row;
  const po_status status =
      late && !is_formula(theory) ? po_deadline_check() : evaluate(theory, e, &row.force);
  if (status || !isfinite(row.force)) {
    row.force = NAN;
    snprintf(row.reason, sizeof row.reason, "%.*s", (int)sizeof row.reason - 1,
             status ? po_message() : "a number exceeds the range of double precision");
    po_message_clear();
    return row;
  }
  compare(result, &row);
  return row;
}

/* A row for every theory of the body, in the order of PO_THEORY_ROWS. Each is evaluated by a closed
 * form of src/core/theory, for the scene alone; no theory reads the value of another one, nor the
 * computed force. If the time ends, the formulas are evaluated still, and the others say so. */
static po_status theories(const po_request *request, po_result *result) {
  po_theory_row *rows = po_allocate(PO_THEORY_COUNT, sizeof *rows);
  if (!rows)
    return PO_NO_MEMORY;
  result->theories = rows;
  result->theory_count = 0;
  evaluation e = {request,
                  &request->scene,
                  {{NAN, NAN}, {NAN, NAN, NAN}, PO_NO_RATE_THEORY, PO_NO_RATE_THEORY}};
  double number[PO_ASSUMPTION_COUNT];
  po_status status = PO_OK;
  for (int theory = 0; theory < PO_THEORY_COUNT && status != PO_INTERRUPTED; ++theory) {
    if (!is_of((po_theory)theory, request))
      continue;
    rows[result->theory_count++] = row_of((po_theory)theory, &e, result, status == PO_OUT_OF_TIME);
    status = po_deadline_check();
  }
  po_assumptions_find(request, result, &e.states, number);
  for (size_t k = 0; k < result->theory_count; ++k)
    if (isfinite(rows[k].force))
      po_assumptions_decide(number, &rows[k]);
  const po_status noted = po_request_find_parabola(request, result);
  return noted ? noted : status;
}

/* -- The theories -- */

/* Margins of the bound. EXCESS: the adhesive part of Eq 5 is multiplied by 1 + EXCESS. WAVES: the
 * contact radius of a minimum may exceed that of the same minimum of Eq 5 by this fraction of the
 * longest wavelength. tests/estimates/preloads.py measures the bound: on random scenes it held with
 * EXCESS = 0. For smooth spheres of small Tabor parameter the JKR theory is no bound (its pull-off
 * force is 1.5 pi w R, that of a rigid sphere 2 pi w R); there the smallest load of a search
 * applies (po_stopping.c). */
static const double EXCESS = 0.1, WAVES = 0.25;

static double bound(const po_scene *scene, double load) {
  if (!po_scene_is_of_paper(scene))
    return po_jkr_profile_last_minimum(scene, load, EXCESS) + WAVES * po_abel_longest_wave(scene);
  return po_guduru_last_minimum(scene, load, EXCESS) + WAVES * scene->wavelength;
}

static po_status hysteresis(const po_scene *scene, po_preload preload, po_control spring,
                            po_hysteresis *loops) {
  return po_jkr_hysteresis(scene, preload, spring, SIZE_MAX, loops);
}

static double parabola_excess(const po_scene *scene) {
  po_scene exact = *scene;
  po_contact of_parabola, of_sphere;
  exact.profile.kind = &PO_EXACT_SPHERE;
  exact.profile.parameter[PO_EXACT_SPHERE_R] = scene->radius;
  const bool are_known = !po_jkr_profile_pull_off(scene, PO_FIXED_LOAD, &of_parabola) &&
                         !po_jkr_profile_pull_off(&exact, PO_FIXED_LOAD, &of_sphere);
  po_message_clear();
  return are_known ? of_parabola.load / of_sphere.load - 1.0 : (double)NAN;
}

const po_theories PO_THEORY_FORCES = {bound, hysteresis, po_jkr_staircases, theories,
                                      parabola_excess};
