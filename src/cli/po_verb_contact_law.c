#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_elementary.h"
#include "po_file.h"
#include "po_live.h"
#include "po_options.h"
#include "po_particle_text.h"
#include "po_quote.h"
#include "po_suggest.h"
#include "po_theory_forces.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff contact-law [OPTION]...\n"
    "Writes the law of contact of two particles for codes that move particles: force, contact\n"
    "radius and stiffness against overlap, on loading and unloading, as piecewise cubics within a\n"
    "stated error of the computed curve, with both jumps and the energy that a cycle loses. The\n"
    "scene is the contact of a particle of radius R = R1 R2/(R1 + R2) with a half-space. The "
    "overlap\n"
    "is the approach. In reduced units one table serves all pairs of particles with the same "
    "Tabor\n"
    "parameter; after --from-physical the table is in m and N. A scene whose loading or unloading\n"
    "jumps more than once up to the preload needs more states than out and in, and is refused.\n"
    "\n"
    "Scene:\n"
    "@scene\n"
    "\n"
    "Preload, up to which the law is tabulated:\n"
    "@trace\n"
    "Without a preload, that of a sphere is the load 10 pi w R. Beyond the table a sphere is\n"
    "continued by Hertz, with the same force and stiffness at its end; other profiles by their "
    "last\n"
    "stiffness. Far out, where the attraction is less than the error, the force is 0.\n"
    "\n"
    "Discretisation:\n"
    "@mesh\n"
    "\n"
    "Results:\n"
    "  --format NAME           c: a header with one function, which keeps the state of a contact, "
    "out\n"
    "                          or in, in an integer; csv: the knots of the cubics; lammps: a file "
    "of\n"
    "                          pair_style table, which holds the branch of loading alone (default "
    "c)\n"
    "  --error E               greatest difference of the force from the computed one, over the\n"
    "                          pull-off force, 1e-6 to 0.01 (default 1e-4)\n"
    "  --name NAME             name of the function and the table, letters, digits and _ (default\n"
    "                          pulloff_law)\n"
    "  -o, --output FILE       write to FILE, and print what the law is (default: standard "
    "output)\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff contact-law --tabor 2 --output law.h\n"
    "Example: pulloff contact-law --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7 --format csv\n";

typedef struct {
  po_scene_options scene;
  po_request request;
  po_particle_format format;
  double error;
  const char *name, *output;
} law_line;

static po_status take_format(const char *name, void *format) {
  for (int k = 0; PO_PARTICLE_FORMATS[k]; ++k)
    if (strcmp(PO_PARTICLE_FORMATS[k], optarg) == 0) {
      *(po_particle_format *)format = (po_particle_format)k;
      return PO_OK;
    }
  return po_options_refuse(name, optarg, "c, csv or lammps");
}

static po_status take_error(const char *name, void *error) {
  return po_number_parse(optarg, error) && *(double *)error >= PO_LEAST_LAW_ERROR &&
                 *(double *)error <= PO_GREATEST_LAW_ERROR
             ? PO_OK
             : po_options_refuse(name, optarg, "a number from 1e-6 to 0.01");
}

enum { LONGEST_NAME = 60 };

/* The words of C and C++ that are written as names are. */
static const char RESERVED[] =
    " alignas alignof and asm auto bool break case catch char class concept const constexpr "
    "continue decltype default delete do double else enum explicit export extern false float for "
    "friend goto if inline int long main mutable namespace new noexcept not nullptr operator or "
    "private protected public register requires restrict return short signed sizeof static struct "
    "switch template this throw true try typedef typeid typename union unsigned using virtual void "
    "volatile while xor ";

static bool is_reserved(const char *name) {
  char word[LONGEST_NAME + 3];
  snprintf(word, sizeof word, " %.*s ", LONGEST_NAME, name);
  return strstr(RESERVED, word);
}

static po_status take_name(const char *name, void *value) {
  const char *c = optarg;
  while (isalnum((unsigned char)*c) || *c == '_')
    ++c;
  *(const char **)value = optarg;
  return c > optarg && !*c && !isdigit((unsigned char)*optarg) && c - optarg <= LONGEST_NAME &&
                 !is_reserved(optarg)
             ? PO_OK
             : po_options_refuse(name, optarg,
                                 "letters, digits and _, at most 60, no digit first, and no word "
                                 "of C or C++");
}

/* Beside the options of keys. */
static const po_option OPTIONS[] = {PO_TAKEN("format", law_line, format, take_format),
                                    PO_TAKEN("error", law_line, error, take_error),
                                    PO_TAKEN("name", law_line, name, take_name),
                                    PO_OUTPUT(law_line, output, "the name of a file"),
                                    PO_REFUSED_STIFFNESS,
                                    {0}};

/* Completes the request: the preload of a sphere is PO_LAW_PRELOAD, unless it is given. */
static po_status complete_line(law_line *line) {
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
  po_scene_options_warn(&line->scene.given);
  if (isnan(r->preload.approach) && isnan(r->preload.load) && isnan(r->approach_end) &&
      po_profile_is_sphere(&r->scene.profile))
    r->preload.load = PO_LAW_PRELOAD;
  if (isinf(r->preload.approach))
    return po_fail(PO_BAD_INPUT,
                   "--preload is inf: expected a finite number, up to which the law is "
                   "tabulated");
  r->want = PO_WANT_HYSTERESIS;
  r->stop = po_interrupt_listen();
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

static po_status write_text(const law_line *line, const po_particle_text *t) {
  po_text text = {0};
  po_status status = po_particle_text_add(t, line->format, &text);
  if (!status && text.failed)
    status = PO_NO_MEMORY;
  if (!status && line->output) {
    status = po_file_write(line->output, text.data, text.length);
    po_text_clear(&text);
    if (!status) {
      po_particle_text_describe(t, "", &text);
      status = po_text_print(&text);
    }
  } else if (!status) {
    status = po_text_print(&text);
  }
  po_text_clear(&text);
  return status;
}

/* Appends the options of the scene: those of a scene in SI units as they were given. */
static void add_scene(const law_line *line, po_text *made) {
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
    if (!given->text[key])
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

/* Excess of the pull-off force of the parabola over that of the sphere, by JKR theory, from which
 * on a warning is due. */
static const double EXCESS_OF_PARABOLA = 0.04;

/* Warns if the contact is so wide that the parabola is no sphere. In reduced units a law belongs to
 * parabolas of every radius, and there is no sphere to compare with. */
static void warn_of_parabola(const po_request *request) {
  const po_scene *scene = &request->scene;
  if (!request->in_si || !po_profile_is_sphere(&scene->profile) || !(scene->tabor > 0.0))
    return;
  const double excess = PO_THEORY_FORCES.parabola_excess(scene);
  if (excess > EXCESS_OF_PARABOLA)
    fprintf(stderr,
            "pulloff: warning: the contact is so wide that by JKR theory the parabola r^2/(2R) "
            "pulls %.0f %% more than a sphere; --profile exact_sphere:%.6g is the sphere\n",
            100.0 * excess, scene->radius * request->units.length);
}

static po_status make_law(const law_line *line) {
  po_particle_law law;
  po_particle_numbers half, twice;
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
  warn_of_parabola(&line->request);
  char error[PO_NUMBER_LENGTH];
  po_number_print(line->error, error);
  po_text made = {0};
  po_text_add(&made, "pulloff contact-law");
  add_scene(line, &made);
  po_text_add(&made, " --format %s --error %s", PO_PARTICLE_FORMATS[line->format], error);
  t.command = po_text_string(&made);
  status = made.failed ? PO_NO_MEMORY : write_text(line, &t);
  po_text_clear(&made);
  po_particle_law_clear(&law);
  return status;
}

int po_verb_contact_law(int argc, char **argv) {
  const po_options options = {
      "contact-law", HELP, OPTIONS, argc, argv, 0, NULL, PO_FOR_COMPARE, po_scene_options_take};
  law_line line = {.request = po_input_default(),
                   .scene = po_scene_options_begin(),
                   .format = PO_PARTICLE_C,
                   .error = 1e-4,
                   .name = "pulloff_law"};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  status = complete_line(&line);
  if (!status)
    status = make_law(&line);
  return po_options_end(status);
}
