#include "po_particle_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_number.h"

const char *const PO_PARTICLE_FORMATS[] = {"c", "csv", "lammps", NULL};

/* The units of the numbers of a law: 1 in reduced units. */
typedef struct {
  double length, radius, force;
} units;

static units units_of(const po_particle_text *t) {
  const po_request *r = t->request;
  if (!r->in_si)
    return (units){1.0, 1.0, 1.0};
  return (units){r->units.length, r->units.length * sqrt(r->scene.radius), r->units.force};
}

/* -- What the law is -- */

/* One number of all keys, as the words of a scene. */
static void add_key(po_text *text, const po_request *request, po_key key, const char *before) {
  char value[PO_KEY_TEXT_LENGTH];
  po_key_print(request, key, value);
  po_text_add(text, "%s%s", before, value);
}

/* For which particles the law holds. */
static void add_validity(const po_particle_text *t, const char *before, po_text *text) {
  const po_scene *scene = &t->request->scene;
  char number[PO_NUMBER_LENGTH];
  po_number_print(scene->tabor * scene->tabor * scene->tabor, number);
  if (!po_profile_is_sphere(&scene->profile)) {
    po_text_add(
        text,
        "%sholds for particles with the same scene in units of epsilon: the same profile,\n"
        "%swaves, law and coupling w/(E* epsilon); of one pair of materials, for one profile\n",
        before, before);
    return;
  }
  po_text_add(text, "%sholds for all pairs of particles with R w^2/(E*^2 epsilon^3) =", before);
  po_text_add(text, " %s (Tabor parameter", number);
  add_key(text, t->request, PO_KEY_TABOR, " ");
  po_text_add(text, ")\n");
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    po_text_add(text, "%sand a wave with A/epsilon = %.10g and L^2/(R epsilon) = %.10g\n", before,
                wave.amplitude, wave.length * wave.length / scene->radius);
  }
  if (isfinite(scene->outer_radius))
    po_text_add(text, "%sand a surface cut at r with r^2/(R epsilon) = %.10g\n", before,
                scene->outer_radius * scene->outer_radius / scene->radius);
  po_text_add(
      text,
      "%swith R = R1 R2/(R1 + R2): of one pair of materials, for one R. Another R has another\n"
      "%stable\n",
      before, before);
}

static void add_units(const po_particle_text *t, const char *before, po_text *text) {
  char number[PO_NUMBER_LENGTH];
  if (t->request->in_si) {
    po_number_print(t->request->scene.radius * t->request->units.length, number);
    po_text_add(text, "%sunits: m, N, N/m, J; R = %s m\n", before, number);
    return;
  }
  const bool unit_of_radius = !po_input_has_coupling(t->request);
  po_text_add(
      text,
      "%sunits: overlap in epsilon, force in %s, stiffness and energy in these by and times\n"
      "%sepsilon, contact radius in %s\n",
      before, po_input_load_unit(t->request), before,
      unit_of_radius ? "sqrt(R epsilon)" : "epsilon");
}

static void add_numbers(const po_particle_numbers *n, const units *u, const char *before,
                        const char *what, po_text *text) {
  po_text_add(text, "%s%spull-off force %.10g at overlap %.10g", before, what,
              n->pull_off * u->force, n->pull_off_overlap * u->length);
  if (!n->jumps) {
    po_text_add(text, "; no jumps, a cycle loses nothing\n");
    return;
  }
  po_text_add(text, "; jumps in at %.10g, out at %.10g;\n%s%*sa cycle loses %.10g, error ",
              n->jump_in * u->length, n->jump_out * u->length, before, (int)strlen(what), "",
              n->energy_lost * u->force * u->length);
  if (isnan(n->energy_lost_error)) /* rings and triangles */
    po_text_add(text, "not estimated\n");
  else
    po_text_add(text, "%.1e\n", n->energy_lost_error * u->force * u->length);
}

void po_particle_text_describe(const po_particle_text *t, const char *before, po_text *text) {
  const po_particle_law *law = t->law;
  const units u = units_of(t);
  const po_particle_knot *first = law->out.count ? law->out.knot : law->in.knot,
                         *last = &law->in.knot[law->in.count - 1];
  po_text_add(
      text,
      "%slaw of contact by pulloff: force (repulsive > 0) against overlap, which is 0 where\n"
      "%sundeformed surfaces are at their equilibrium distance epsilon\n"
      "%smade by: %s\n",
      before, before, before, t->command);
  add_units(t, before, text);
  add_validity(t, before, text);
  add_numbers(&law->numbers, &u, before, "", text);
  po_text_add(text,
              "%scubics: force within %.1e of the pull-off force, contact radius within %.1e;\n"
              "%senergy lost by the cubics %.10g\n",
              before, law->error, law->radius_error * u.radius, before,
              law->table_lost * u.force * u.length);
  po_text_add(text, "%sbelow overlap %.10g (force %.1e): 0; beyond %.10g (force %.6g): %s\n",
              before, first->overlap * u.length, first->force * u.force, last->overlap * u.length,
              last->force * u.force,
              law->hertz > 0.0 ? "Hertz with the same force and stiffness there"
                               : "by the stiffness there");
  if (t->half && t->twice) {
    add_numbers(t->half, &u, before, "for comparison, half of R:  ", text);
    add_numbers(t->twice, &u, before, "for comparison, twice R:    ", text);
  }
}

/* -- C -- */

enum { CELLS = 5 };

static void cells_of(const po_particle_knot *knot, const units *u, double cell[CELLS]) {
  cell[0] = knot->overlap * u->length;
  cell[1] = knot->force * u->force;
  cell[2] = knot->stiffness * (u->force / u->length);
  cell[3] = knot->radius * u->radius;
  cell[4] = knot->radius_slope * (u->radius / u->length);
}

static void add_array(const char *name, const po_particle_stretch *s, const units *u,
                      po_text *text) {
  po_text_add(text, "  static const double %s[%zu][%d] = {\n", name, s->count, CELLS);
  for (size_t k = 0; k < s->count; ++k) {
    double cell[CELLS];
    char number[PO_NUMBER_LENGTH];
    cells_of(&s->knot[k], u, cell);
    po_text_add(text, "    {");
    for (int c = 0; c < CELLS; ++c) {
      po_number_print(cell[c], number);
      po_text_add(text, "%s%s", c ? ", " : "", number);
    }
    po_text_add(text, "}%s\n", k + 1 < s->count ? "," : "");
  }
  po_text_add(text, "  };\n");
}

static void add_macro(const char *upper, const char *what, double value, po_text *text) {
  char number[PO_NUMBER_LENGTH];
  po_number_print(value, number);
  if (isfinite(value))
    po_text_add(text, "#define %s_%s (%s)\n", upper, what, number);
}

/* What a function of the law does, from the interval of the overlap on. */
static const char BODY[] =
    "  if (overlap < row[0][0])\n"
    "    return 0.0;\n"
    "  if (overlap > row[high][0]) {\n"
    "%s"
    "    *radius = row[high][3];\n"
    "    return force;\n"
    "  }\n"
    "  while (high - low > 1) {\n"
    "    const int middle = (low + high) / 2;\n"
    "    if (row[middle][0] <= overlap)\n"
    "      low = middle;\n"
    "    else\n"
    "      high = middle;\n"
    "  }\n"
    "  const double *const a = row[low], *const b = row[high], h = b[0] - a[0], t = (overlap - "
    "a[0]) / h;\n"
    "  const double rise = b[1] - a[1], p = h * a[2], q = h * b[2], wider = b[3] - a[3];\n"
    "  *radius = a[3] + t * (h * a[4] + t * (3.0 * wider - h * (2.0 * a[4] + b[4]) +\n"
    "            t * (h * (a[4] + b[4]) - 2.0 * wider)));\n"
    "  *stiffness = (p + t * (2.0 * (3.0 * rise - 2.0 * p - q) + t * 3.0 * (p + q - 2.0 * rise))) "
    "/ h;\n"
    "  return a[1] + t * (p + t * (3.0 * rise - 2.0 * p - q + t * (p + q - 2.0 * rise)));\n"
    "}\n\n";

/* The lines that continue the force beyond the table. */
static void add_beyond(const po_particle_text *t, const units *u, po_text *text) {
  const po_particle_law *law = t->law;
  char hertz[PO_NUMBER_LENGTH], origin[PO_NUMBER_LENGTH];
  if (law->hertz == 0.0) {
    po_text_add(text,
                "    const double force = row[high][1] + row[high][2] * (overlap - row[high][0]);\n"
                "    *stiffness = row[high][2];\n");
    return;
  }
  po_number_print(law->hertz * u->force / (u->length * sqrt(u->length)), hertz);
  po_number_print(law->hertz_origin * u->length, origin);
  po_text_add(
      text,
      "    const double hertz = %s, origin = %s;\n"
      "    const double there = row[high][0] - origin, here = overlap - origin;\n"
      "    const double force = row[high][1] + hertz * (here * sqrt(here) - there * sqrt(there));\n"
      "    *stiffness = 1.5 * hertz * sqrt(here);\n",
      hertz, origin);
}

static void add_c(const po_particle_text *t, po_text *text) {
  const po_particle_law *law = t->law;
  const po_particle_numbers *n = &law->numbers;
  const units u = units_of(t);
  char upper[80];
  size_t length = 0;
  for (const char *c = t->name; *c && length + 1 < sizeof upper; ++c)
    upper[length++] = (char)toupper((unsigned char)*c);
  upper[length] = '\0';
  po_text_add(text, "/*\n");
  po_particle_text_describe(t, " * ", text);
  po_text_add(
      text,
      " *\n"
      " * double force = %s(overlap, &state, &stiffness, &radius);\n"
      " *\n"
      " * state is 0 before the first call of a contact, then what the last call left: 0 out of\n"
      " * contact, 1 in. The function goes from one to the other where the overlap passes a jump.\n"
      " * stiffness is the derivative of the force, radius that of the contact; beyond the table\n"
      " * the radius stays.\n"
      " */\n"
      "#ifndef %s_H\n#define %s_H\n\n#include <math.h>\n\n",
      t->name, upper, upper);
  add_macro(upper, "JUMP_IN", n->jump_in * u.length, text);
  add_macro(upper, "JUMP_OUT", n->jump_out * u.length, text);
  add_macro(upper, "PULL_OFF", n->pull_off * u.force, text);
  add_macro(upper, "ENERGY_LOST", n->energy_lost * u.force * u.length, text);
  add_macro(upper, "FAR", (law->out.count ? law->out.knot : law->in.knot)->overlap * u.length,
            text);
  po_text_add(text,
              "\nstatic inline double %s(double overlap, int *state, double *stiffness, double "
              "*radius) {\n",
              t->name);
  if (n->jumps)
    add_array("out", &law->out, &u, text);
  add_array("in", &law->in, &u, text);
  if (n->jumps)
    po_text_add(text,
                "  *state = *state ? overlap >= in[0][0] : overlap > out[%zu][0];\n"
                "  const double(*const row)[%d] = *state ? in : out;\n"
                "  int low = 0, high = *state ? %zu : %zu;\n",
                law->out.count - 1, CELLS, law->in.count - 1, law->out.count - 1);
  else
    po_text_add(text, "  const double(*const row)[%d] = in;\n  int low = 0, high = %zu;\n", CELLS,
                law->in.count - 1);
  po_text_add(text, "  *stiffness = *radius = 0.0;\n");
  if (!n->jumps)
    po_text_add(text, "  *state = 0;\n");
  po_text beyond = {0};
  add_beyond(t, &u, &beyond);
  po_text_add(text, BODY, po_text_string(&beyond));
  po_text_clear(&beyond);
  po_text_add(text, "#endif\n");
}

/* -- CSV -- */

static void add_stretch(const char *branch, const po_particle_stretch *s, const units *u,
                        po_text *text) {
  for (size_t k = 0; k < s->count; ++k) {
    double cell[CELLS];
    char number[PO_NUMBER_LENGTH];
    cells_of(&s->knot[k], u, cell);
    po_text_add(text, "%s", branch);
    for (int c = 0; c < CELLS; ++c) {
      po_number_print(cell[c], number);
      po_text_add(text, ",%s", number);
    }
    po_text_add(text, "\n");
  }
}

static void add_csv(const po_particle_text *t, po_text *text) {
  const units u = units_of(t);
  const bool si = t->request->in_si;
  po_particle_text_describe(t, "# ", text);
  po_text_add(
      text, "%s\n",
      si ? "branch,overlap_m,force_n,stiffness_n_per_m,contact_radius_m,contact_radius_slope"
         : "branch,overlap,force,stiffness,contact_radius,contact_radius_slope");
  if (t->law->out.count)
    add_stretch("out", &t->law->out, &u, text);
  add_stretch("in", &t->law->in, &u, text);
}

/* -- LAMMPS -- */

/* Rows of a table of LAMMPS, which are evenly spaced. */
enum { ROWS = 10000 };

/* The work of loading from the first knot to an overlap. */
static double work_to(const po_particle_law *law, double overlap) {
  double work = 0.0;
  if (law->out.count) {
    const double jump = law->out.knot[law->out.count - 1].overlap;
    work = po_particle_law_work(&law->out, -INFINITY, fmin(overlap, jump));
    return overlap <= jump ? work : work + po_particle_law_work(&law->in, jump, overlap);
  }
  return work + po_particle_law_work(&law->in, -INFINITY, overlap);
}

static po_status add_lammps(const po_particle_text *t, po_text *text) {
  const po_particle_law *law = t->law;
  const po_scene *scene = &t->request->scene;
  const units u = units_of(t);
  if (!po_profile_is_sphere(&scene->profile))
    return po_fail(PO_BAD_INPUT, "--format is lammps: expected c or csv, as only spheres have a "
                                 "distance of their centres");
  const double sum = 4.0 * scene->radius; /* of the radii of two equal spheres: R1 = R2 = 2 R */
  const po_particle_knot *last = &law->in.knot[law->in.count - 1];
  const double jump = law->out.count ? law->out.knot[law->out.count - 1].overlap : -INFINITY;
  const double low = sum - last->overlap,
               high = sum - (law->out.count ? law->out.knot : law->in.knot)->overlap;
  char number[4][PO_NUMBER_LENGTH];
  if (!(low > 0.0))
    return po_fail(PO_BAD_INPUT,
                   "the preload overlaps the spheres by more than their radii: expected a lower "
                   "preload than approach %g",
                   last->overlap);
  po_particle_text_describe(t, "# ", text);
  po_text_add(text, "# for the distance of the centres of two equal spheres of radius 2 R\n");
  if (law->numbers.jumps)
    po_text_add(
        text,
        "# This table is the branch of loading alone, as a table holds one force for each "
        "distance:\n"
        "# a cycle loses nothing, surfaces that touched part where they met, and nothing sticks.\n"
        "# The force jumps at overlap %.6g, within one row: %.3g.\n",
        jump * u.length, (high - low) / (ROWS - 1) * u.length);
  else
    po_text_add(text, "# This table is the whole law: loading and unloading have the same path.\n");
  po_number_print(low * u.length, number[0]);
  po_number_print(high * u.length, number[1]);
  /* LAMMPS refuses a cutoff beyond the last row, as one that is rounded may be */
  po_text_add(text, "# pair_style table linear %d\n# pair_coeff 1 1 FILE %s %s\n\n", ROWS, t->name,
              number[1]);
  po_text_add(text, "%s\nN %d R %s %s\n\n", t->name, ROWS, number[0], number[1]);
  for (int k = 0; k < ROWS; ++k) {
    const double r = low + (high - low) * k / (ROWS - 1);
    const double overlap = k + 1 == ROWS ? sum - high : sum - r;
    const double force = po_particle_law_force(law, overlap > jump ? &law->in : &law->out,
                                               fmin(overlap, last->overlap));
    const double value[] = {r * u.length, work_to(law, overlap) * u.force * u.length,
                            force * u.force};
    for (int c = 0; c < 3; ++c)
      po_number_print(value[c], number[c]);
    po_text_add(text, "%d %s %s %s\n", k + 1, number[0], number[1], number[2]);
  }
  return PO_OK;
}

po_status po_particle_text_add(const po_particle_text *t, po_particle_format format,
                               po_text *text) {
  if (format == PO_PARTICLE_LAMMPS)
    return add_lammps(t, text);
  if (format == PO_PARTICLE_C)
    add_c(t, text);
  else
    add_csv(t, text);
  return PO_OK;
}
