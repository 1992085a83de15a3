#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "po_file.h"
#include "po_law_line.h"
#include "po_law_sets.h"
#include "po_live.h"
#include "po_session.h"
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
    "output);\n"
    "                          with --sets, a folder\n"
    "  -h, --help              print this text\n"
    "\n"
    "Many laws:\n"
    "  --sets TABLE            make a law for each row of a CSV table, whose columns are named "
    "like\n"
    "                          the options of the scene (tabor, radius_m), or like a group "
    "(alpha,\n"
    "                          amplitude_ratio, outer_ratio); - is a value that is "
    "not\n"
    "                          given, and semicolons stand for the commas of a value. Options "
    "hold\n"
    "                          for all rows. The folder --output gets a file for each row, "
    "named\n"
    "                          like its function, NAME_ROW, and summary.csv: status, jumps, "
    "pull-off\n"
    "                          force, energy lost, errors and seconds of each row. A row that "
    "has no\n"
    "                          law has the reason in the summary. What is in the folder already,\n"
    "                          made from the same row and options, is kept\n"
    "  -j, --jobs N            rows computed in parallel; 0 means all cores (default 0)\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff contact-law --tabor 2 --output law.h\n"
    "Example: pulloff contact-law --sets particles.csv --output laws\n"
    "Example: pulloff contact-law --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7 --format csv\n";

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

/* The words of C and C++ that are written as names are. */
static const char RESERVED[] =
    " alignas alignof and asm auto bool break case catch char class concept const constexpr "
    "continue decltype default delete do double else enum explicit export extern false float for "
    "friend goto if inline int long main mutable namespace new noexcept not nullptr operator or "
    "private protected public register requires restrict return short signed sizeof static struct "
    "switch template this throw true try typedef typeid typename union unsigned using virtual void "
    "volatile while xor ";

static bool is_reserved(const char *name) {
  char word[PO_LAW_NAME_MOST + 3];
  snprintf(word, sizeof word, " %.*s ", PO_LAW_NAME_MOST, name);
  return strstr(RESERVED, word);
}

static po_status take_name(const char *name, void *value) {
  const char *c = optarg;
  while (isalnum((unsigned char)*c) || *c == '_')
    ++c;
  *(const char **)value = optarg;
  return c > optarg && !*c && !isdigit((unsigned char)*optarg) && c - optarg <= PO_LAW_NAME_MOST &&
                 !is_reserved(optarg)
             ? PO_OK
             : po_options_refuse(name, optarg,
                                 "letters, digits and _, at most 60, no digit first, and no word "
                                 "of C or C++");
}

/* Beside the options of keys. */
static const po_option OPTIONS[] = {PO_TAKEN("format", po_law_line, format, take_format),
                                    PO_TAKEN("error", po_law_line, error, take_error),
                                    PO_TAKEN("name", po_law_line, name, take_name),
                                    PO_OUTPUT(po_law_line, output, "the name of a file"),
                                    PO_TEXT("sets", po_law_line, sets, "the name of a file"),
                                    {.name = "jobs",
                                     .kind = PO_OPTION_IS_TAKEN,
                                     .place = offsetof(po_law_line, jobs),
                                     .take = po_session_take_jobs,
                                     .letter = 'j'},
                                    PO_REFUSED_STIFFNESS,
                                    {0}};

/* Warns if the contact is so wide that the parabola is no sphere. */
static void warn_of_parabola(const po_request *request, double excess) {
  if (excess > PO_LAW_PARABOLA_EXCESS)
    fprintf(stderr,
            "pulloff: warning: the contact is so wide that by JKR theory the parabola r^2/(2R) "
            "pulls %.0f %% more than a sphere; --profile exact_sphere:%.6g is the sphere\n",
            100.0 * excess, request->scene.radius * request->units.length);
}

static po_status make_one(po_law_line *line) {
  po_law_made made = {.numbers = {0}};
  po_status status = po_law_line_complete(line, true);
  if (!status)
    status = po_law_line_make(line, &made);
  if (!status)
    warn_of_parabola(&line->request, made.parabola_excess);
  if (!status && line->output)
    status = po_file_write(line->output, made.file.data, made.file.length);
  if (!status)
    status = po_text_print(line->output ? &made.said : &made.file);
  po_law_made_clear(&made);
  return status;
}

int po_verb_contact_law(int argc, char **argv) {
  const po_options options = {
      "contact-law", HELP, OPTIONS, argc, argv, 0, NULL, PO_FOR_COMPARE, po_scene_options_take};
  po_law_line line = {.request = po_input_default(),
                      .scene = po_scene_options_begin(),
                      .format = PO_PARTICLE_C,
                      .error = 1e-4,
                      .name = "pulloff_law",
                      .jobs = -1};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  line.request.stop = po_interrupt_listen();
  if (line.sets)
    return po_options_end(po_law_sets(&line));
  return po_options_end(line.jobs >= 0
                            ? po_fail(PO_BAD_INPUT, "--jobs has no effect without --sets")
                            : make_one(&line));
}
