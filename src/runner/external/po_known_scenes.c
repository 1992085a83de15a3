#include "po_known_scenes.h"

#include <math.h>
#include <stdio.h>

#include "po_input.h"
#include "po_reference.h"

/* The pull-off of the smooth sphere on the unbounded half-space; and that of the rigid one. */
static const char TABLE[] = "reference/feng_pull_off.csv", RIGID_SPHERE[] = "bradley";

static const po_quantity QUANTITIES[PO_KNOWN_NUMBERS] = {[PO_KNOWN_FORCE] = PO_PULL_OFF_FORCE,
                                                         [PO_KNOWN_APPROACH] = PO_PULL_OFF_APPROACH,
                                                         [PO_KNOWN_CONTACT_RADIUS] =
                                                             PO_CONTACT_RADIUS};

typedef struct {
  const po_solver *solver;
  po_reference table, bradley;
  po_known_scenes *known;
} choice;

/* The two rows of the table between which a Tabor parameter is, or twice the row that has it.
 * Returned: false if it is beyond the last row. */
static bool find_rows(const po_csv *table, double tabor, double at[2]) {
  const int column = po_csv_find_column(table, PO_KEYS[PO_KEY_TABOR].name);
  at[0] = -INFINITY;
  at[1] = INFINITY;
  for (size_t row = 0; column >= 0 && row < table->row_count; ++row) {
    double there = NAN;
    if (po_csv_number(table, row, (size_t)column, &there))
      return false;
    at[0] = there <= tabor ? fmax(at[0], there) : at[0];
    at[1] = there >= tabor ? fmin(at[1], there) : at[1];
  }
  return isfinite(at[1]);
}

/* Expected numbers of a smooth scene: those of the table, between its rows by linear interpolation,
 * which is right to 1 %; before its first row those of Bradley, from which that differs by less.
 * Returned: false if the scene is softer than the last row. */
static bool expect(const choice *c, po_known_scene *scene) {
  po_request unbounded = scene->request;
  const double tabor = unbounded.scene.tabor;
  double at[2];
  unbounded.scene.outer_radius = INFINITY;
  if (!find_rows(&c->table.table, tabor, at))
    return false;
  const bool rigid = isinf(at[0]);
  const double part = rigid || at[0] == at[1] ? 0.0 : (tabor - at[0]) / (at[1] - at[0]);
  for (size_t i = 0; i < PO_KNOWN_NUMBERS; ++i) {
    po_reference_number number[2];
    for (int k = 0; k < 2; ++k) {
      unbounded.scene.tabor = rigid ? tabor : at[k];
      if (po_reference_find(rigid ? &c->bradley : &c->table, QUANTITIES[i], &unbounded, &number[k]))
        return false;
    }
    scene->expected[i] = number[0].value + part * (number[1].value - number[0].value);
  }
  return true;
}

/* Values of one key, tried in this order. */
enum { MOST_VALUES = 64 };
typedef struct {
  double value[MOST_VALUES];
  size_t count;
} value_list;

static void add_value(value_list *list, double value) {
  if (list->count < MOST_VALUES && isfinite(value))
    list->value[list->count++] = value;
}

/* Adds the values of a key that the manifest lists, or the ends of its range and values between. */
static void add_own(const po_solver *solver, po_key key, value_list *list) {
  const po_solver_key *item = po_solver_find_key(solver, key);
  for (unsigned v = 0; item && v < item->axis.values_count; ++v) {
    double value = NAN;
    if (po_key_parse(key, item->axis.values[v], &value))
      add_value(list, value);
  }
  if (!item || item->axis.values)
    return;
  static const double PART[] = {0, 0.5, 1, 0.25, 0.75};
  const bool ends = isfinite(item->from) && isfinite(item->to);
  add_value(list, ends ? NAN : item->from);
  add_value(list, ends ? NAN : item->to);
  for (size_t k = 0; ends && k < sizeof PART / sizeof *PART; ++k)
    add_value(list, item->from + PART[k] * (item->to - item->from));
}

static bool is_chosen(const choice *c, double tabor, double radius) {
  for (size_t i = 0; i < c->known->count; ++i) {
    const po_scene *scene = &c->known->scenes[i].request.scene;
    if (scene->tabor == tabor && scene->radius == radius)
      return true;
  }
  return false;
}

/* Adds a scene if the solver accepts it: on the unbounded surface, else on one that is cut at the
 * radius of the sphere or, if the manifest accepts neither, at a larger radius of its own, where
 * the force differs by less than a thousandth. */
static bool add_scene(choice *c, double tabor, double radius) {
  value_list outer = {{INFINITY, radius}, 2};
  add_own(c->solver, PO_KEY_OUTER_RADIUS, &outer);
  for (size_t i = 0; i < outer.count && c->known->count < PO_MOST_KNOWN; ++i) {
    char why[PO_SOLVER_WHY];
    po_known_scene scene = {.request = po_input_default()};
    po_scene *of = &scene.request.scene;
    of->tabor = tabor;
    of->radius = radius;
    of->outer_radius = outer.value[i];
    if (of->outer_radius < radius || is_chosen(c, tabor, radius) || po_scene_check(of) ||
        !expect(c, &scene))
      continue;
    if (!po_solver_accepts(c->solver, &scene.request, why)) {
      if (!*c->known->why)
        snprintf(c->known->why, sizeof c->known->why, "%s", why);
      continue;
    }
    c->known->scenes[c->known->count++] = scene;
    return true;
  }
  return false;
}

/* Adds the first scene that the solver accepts, if there is one. */
static bool add_first(choice *c, const value_list *tabor, double radius) {
  size_t i = 0;
  while (i < tabor->count && !add_scene(c, tabor->value[i], radius))
    ++i;
  return i < tabor->count;
}

/* Adds up to four scenes: the first one accepted of each list, and the last of these with a second
 * radius. */
static void choose_of(choice *c, const value_list *rigid, const value_list *soft,
                      const value_list *middle, const value_list *radius) {
  size_t r = 0;
  while (r < radius->count && !add_first(c, rigid, radius->value[r]))
    ++r;
  if (r == radius->count)
    return;
  add_first(c, soft, radius->value[r]);
  add_first(c, middle, radius->value[r]);
  const double tabor = c->known->scenes[c->known->count - 1].request.scene.tabor;
  while (++r < radius->count && !add_scene(c, tabor, radius->value[r]))
    continue;
}

/* The most rigid scene, the softest one up to a Tabor parameter of 3, and one between them: of
 * values that many manifests accept, else of those of the manifest itself. */
static void choose_scenes(choice *c) {
  static const value_list RIGID = {{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.25, 1.5, 2, 2.5,
                                    3, 3.5, 4, 5, 10},
                                   18},
                          SOFT = {{3, 2.5, 2, 1.5, 1.25, 1, 3.5, 4, 5, 10}, 10},
                          MIDDLE = {{0.8, 1, 1.25, 0.6, 1.5, 0.5, 0.3, 2, 0.1, 3.5, 4, 5}, 12};
  value_list radius = {{100, 50, 200, 30, 500, 20, 10, 1000}, 8}, own = {.count = 0};
  add_own(c->solver, PO_KEY_RADIUS, &radius);
  add_own(c->solver, PO_KEY_TABOR, &own);
  choose_of(c, &RIGID, &SOFT, &MIDDLE, &radius);
  if (!c->known->count)
    choose_of(c, &own, &own, &own, &radius);
}

po_status po_known_scenes_choose(const po_solver *solver, const char *data_folder,
                                 po_known_scenes *known) {
  choice c = {.solver = solver, .known = known};
  *known = (po_known_scenes){.count = 0};
  po_status status = po_reference_open(data_folder, TABLE, &c.table);
  if (!status)
    status = po_reference_open(data_folder, RIGID_SPHERE, &c.bradley);
  if (!status)
    choose_scenes(&c);
  po_reference_close(&c.table);
  po_reference_close(&c.bradley);
  return status;
}
