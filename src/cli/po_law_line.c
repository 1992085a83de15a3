#include "po_law_line.h"

#include <math.h>
#include <string.h>

#include "po_elementary.h"
#include "po_theory_forces.h"

po_status po_law_line_complete(po_law_line *line, bool warns) {
  po_request *r = &line->request;
  po_status status = po_texts_read(&line->scene.given, r);
  if (!status)
    status = po_texts_check_waves(&line->scene.given);
  if (status)
    return status;
  if (r->creep.kind != PO_CREEP_NONE)
    return po_fail(PO_BAD_INPUT,
                   "viscoelastic is given: expected elastic particles, whose force is a "
                   "function of the overlap");
  if (warns)
    po_scene_options_warn(&line->scene.given);
  if (isnan(r->preload.approach) && isnan(r->preload.load) && isnan(r->approach_end) &&
      po_profile_is_sphere(&r->scene.profile))
    r->preload.load = PO_LAW_PRELOAD;
  if (isinf(r->preload.approach))
    return po_fail(PO_BAD_INPUT,
                   "--preload is inf: expected a finite number, up to which the law is "
                   "tabulated");
  r->want = PO_WANT_HYSTERESIS;
  return po_request_check(r);
}

/* The numbers of the law of another radius. */
static po_status of_other_radius(const po_request *request, double factor,
                                 po_particle_numbers *numbers) {
  po_request other = *request;
  other.scene.tabor *= po_cbrt(factor);
  other.preload = (po_preload){NAN, PO_USUAL_PRELOAD}; /* which is beyond the jumps and cheap */
  other.approach_start = other.approach_end = NAN;
  return po_particle_law_numbers(&other, numbers);
}

/* Appends the amplitude of a scene in SI units whose ratio to the wavelength is given, which is a
 * key of tables and no option of this verb. */
static void add_amplitude(const po_texts *given, po_text *made) {
  const char *wavelength = given->text[PO_KEY_WAVELENGTH_M];
  double ratio, length;
  char amplitude[PO_NUMBER_LENGTH];
  if (!wavelength || !po_key_parse(PO_KEY_WAVELENGTH_M, wavelength, &length) ||
      !po_key_parse(PO_KEY_AMPLITUDE_RATIO, given->text[PO_KEY_AMPLITUDE_RATIO], &ratio))
    return;
  po_number_print(ratio * length, amplitude);
  po_text_add(made, " --amplitude-m %s", amplitude);
}

/* Appends the options of the scene: those of a scene in SI units as they were given, but for the
 * amplitude by its ratio. */
static void add_scene(const po_law_line *line, po_text *made) {
  const po_texts *given = &line->scene.given;
  if (!line->request.in_si) {
    po_request shown = line->request;
    po_text command = {0};
    shown.want = 0;
    po_input_add_command(&shown, &command);
    po_text_add(made, "%s", po_text_string(&command) + strlen("pulloff solve"));
    made->failed = made->failed || command.failed;
    po_text_clear(&command);
    return;
  }
  po_text_add(made, " --from-physical");
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    char flag[PO_FLAG_LENGTH];
    if (key == PO_KEY_AMPLITUDE_M && given->text[PO_KEY_AMPLITUDE_RATIO])
      add_amplitude(given, made);
    if (!given->text[key] || key == PO_KEY_AMPLITUDE_RATIO)
      continue;
    if (key == PO_KEY_WAVES) {
      po_input_add_waves(made, given->text[key]);
      continue;
    }
    po_key_flag(key, flag);
    po_text_add(made, " --%s ", flag);
    po_text_add_word(made, given->text[key]);
  }
}

void po_law_line_add_command(const po_law_line *line, po_text *text) {
  char error[PO_NUMBER_LENGTH];
  po_number_print(line->error, error);
  po_text_add(text, "pulloff contact-law");
  add_scene(line, text);
  po_text_add(text, " --format %s --error %s", PO_PARTICLE_FORMATS[line->format], error);
}

const double PO_LAW_PARABOLA_EXCESS = 0.04;

/* In reduced units a law belongs to parabolas of every radius, and there is no sphere to compare
 * with. */
static double parabola_excess(const po_request *request) {
  const po_scene *scene = &request->scene;
  return request->in_si && po_profile_is_sphere(&scene->profile) && scene->tabor > 0.0
             ? PO_THEORY_FORCES.parabola_excess(scene)
             : 0.0;
}

po_status po_law_line_make(const po_law_line *line, po_law_made *made) {
  po_particle_law law;
  po_particle_numbers half, twice;
  *made = (po_law_made){.numbers = {0}};
  po_status status = po_particle_law_make(&line->request, line->error, &law);
  if (status)
    return status;
  po_particle_text t = {&law, &line->request, line->name, NULL, NULL, NULL};
  const po_scene *scene = &line->request.scene;
  if (!line->request.in_si && po_scene_is_simple(scene) && po_profile_is_sphere(&scene->profile) &&
      scene->tabor > 0.0 && !of_other_radius(&line->request, 0.5, &half) &&
      !of_other_radius(&line->request, 2.0, &twice)) {
    t.half = &half;
    t.twice = &twice;
  }
  made->numbers = law.numbers;
  made->error = law.error;
  made->parabola_excess = parabola_excess(&line->request);
  po_text command = {0};
  po_law_line_add_command(line, &command);
  t.command = po_text_string(&command);
  status = po_particle_text_add(&t, line->format, &made->file);
  if (!status)
    po_particle_text_describe(&t, "", &made->said);
  if (!status && (command.failed || made->file.failed || made->said.failed))
    status = PO_NO_MEMORY;
  po_text_clear(&command);
  po_particle_law_clear(&law);
  return status;
}

void po_law_made_clear(po_law_made *made) {
  po_text_clear(&made->file);
  po_text_clear(&made->said);
}
