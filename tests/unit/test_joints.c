/* Profiles with a kink that only a table can have: the stated errors of the pull-off are not
 * smaller than the true ones, and the energy beyond the mesh is exact. */
#include <math.h>

#include "po_far_energy.h"
#include "po_initial_gap.h"
#include "po_panel_table.h"
#include "po_quadrature.h"
#include "po_solve.h"
#include "profile_table.h"

/* A sphere with a flank of greater slope from a radius on. */
typedef struct {
  double coupling, kink, jump;
} body;

static const body *now;

static double gap_of(double r) {
  return r * r / 200.0 + now->jump * fmax(0.0, r - now->kink);
}

static po_scene scene_of(const body *b) {
  now = b;
  po_scene scene = po_scene_default();
  scene.profile = table_of(gap_of, 61, 120.0, 1.0);
  scene.radius = 1.0;
  scene.tabor = pow(b->coupling, 2.0 / 3.0);
  return scene;
}

/* Kinks inside the mesh, whose error one finer mesh does not show: it changes the approach by
 * nearly nothing; and beyond it, where no mesh does. */
static const body BODIES[] = {
    {0.003, 17.37, 0.05}, {0.003, 18.92, 0.05}, {0.3, 81.0, 0.5}, {0.003, 86.1, 2.0}};

static po_result pull_off_of(const po_scene *scene, double tolerance) {
  po_request request = po_request_default();
  request.scene = *scene;
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = tolerance;
  po_result o = {0};
  ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
  return o;
}

static void compare(const char *what, double loose, double tight, double error) {
  ck_assert_msg(fabs(loose - tight) <= error,
                "%s: %.10g at a loose tolerance, %.10g at a tight one, "
                "errors of %.3g stated",
                what, loose, tight, error);
  ck_assert_double_le(error, 100.0 * 1e-4 * (1.0 + fabs(tight)));
}

TABLE_TEST(errors_of_a_kink_are_stated, BODIES) {
  const po_scene scene = scene_of(&BODIES[_i]);
  po_result loose = pull_off_of(&scene, 1e-4), tight = pull_off_of(&scene, 1e-7);
  compare("force", loose.pull_off.force, tight.pull_off.force,
          loose.pull_off.force_error + tight.pull_off.force_error);
  compare("approach", loose.pull_off.approach, tight.pull_off.approach,
          loose.pull_off.approach_error + tight.pull_off.approach_error);
  compare("contact radius", loose.pull_off.contact_radius, tight.pull_off.contact_radius,
          loose.pull_off.contact_radius_error + tight.pull_off.contact_radius_error);
  po_result_clear(&loose);
  po_result_clear(&tight);
}

/* The traction has the kink of the profile, and so has the deflection: the load that the nodes miss
 * at a given deflection is not the whole error. */
TEST(error_of_a_kink_between_waves_is_stated) {
  po_scene scene = po_scene_default();
  scene.radius = 1.0;
  scene.tabor = pow(0.000362555, 2.0 / 3.0);
  ck_assert(po_profile_set(&scene.profile, "truncated:25.981,47.8932"));
  ck_assert(po_scene_set_waves(&scene, "5.56827@22.9404;0.101679@5.26167;2.00693@16.907"));
  po_result loose = pull_off_of(&scene, 1e-4), tight = pull_off_of(&scene, 1e-7);
  compare("force", loose.pull_off.force, tight.pull_off.force,
          loose.pull_off.force_error + tight.pull_off.force_error);
  po_result_clear(&loose);
  po_result_clear(&tight);
}

/* Far out, panels have many waves, of which Gauss's rule on their halves sees as little as on the
 * whole. The load is small there, the energy is not. Returned: that lost in the first jump at given
 * load, where an unbounded body comes from infinitely far. */
static po_jump first_jump_at_load(const po_scene *scene, double stiffness, double tolerance) {
  po_request request = po_request_default();
  request.scene = *scene;
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = tolerance;
  request.stiffness = stiffness;
  request.want = PO_WANT_HYSTERESIS;
  po_result o = {0};
  ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
  ck_assert(o.hysteresis.has_load);
  ck_assert_uint_ge(o.hysteresis.of[PO_AT_LOAD].jump_count, 1);
  const po_jump jump = o.hysteresis.of[PO_AT_LOAD].jumps[0];
  po_result_clear(&o);
  return jump;
}

typedef struct {
  const char *profile, *law, *waves;
  double coupling, radius, stiffness;
} wavy_body;

static const wavy_body WAVY[] = {
    {"sphere", "lennard-jones", "0.279411@3.34682;0.0814424@6.83993;0.120078@33.7742", 0.0595872,
     58.3373, 0.116727},
    {"cone:0.0618536", "mie:5.022,7.738", "0.208186@57.2641", 6.56279e-05, 1.0, 0.000275888}};

TABLE_TEST(error_of_energy_of_waves_far_out_is_stated, WAVY) {
  const wavy_body *b = &WAVY[_i];
  po_scene scene = po_scene_default();
  scene.radius = b->radius;
  scene.tabor = pow(b->radius * b->coupling * b->coupling, 1.0 / 3.0);
  ck_assert(po_profile_set(&scene.profile, b->profile));
  ck_assert(po_law_set(&scene.law, b->law));
  ck_assert(po_scene_set_waves(&scene, b->waves));
  const po_jump loose = first_jump_at_load(&scene, b->stiffness, 1e-4),
                tight = first_jump_at_load(&scene, b->stiffness, 1e-7);
  compare("energy lost", loose.energy_lost, tight.energy_lost,
          loose.energy_lost_error + tight.energy_lost_error);
  /* and not much larger: what is added up are small differences of large numbers */
  ck_assert_double_le(loose.energy_lost_error, 5.0 * fabs(loose.energy_lost - tight.energy_lost));
}

/* Energies are of the second order, and the polynomials of two panels nearly meet: of the order of
 * 1e-8 at a tolerance of 1e-4. */
TEST(errors_of_energies_of_a_cone_are_small) {
  po_request request = po_request_default();
  request.scene.radius = 1.0;
  request.scene.tabor = pow(0.0228548, 2.0 / 3.0);
  ck_assert(po_profile_set(&request.scene.profile, "cone:0.0752"));
  ck_assert(po_law_set(&request.scene.law, "mie:5.779,11.34"));
  request.mesh.scheme = PO_PANEL;
  request.mesh.tolerance = 1e-4;
  request.want = PO_WANT_CURVE;
  po_result o = {0};
  ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
  double greatest = 0.0, error = 0.0;
  for (size_t k = 0; k < o.curve_count; ++k) {
    greatest = fmax(greatest, fabs(o.curve[k].energy));
    error = fmax(error, o.curve[k].energy_error);
  }
  ck_assert_double_gt(error, 1e-10 * greatest);
  ck_assert_double_le(error, 1e-7 * greatest);
  po_result_clear(&o);
}

static const double APPROACH = -3.0;

/* phi r beyond the mesh, of bodies that do not deform. */
static double integrand(double r, void *data) {
  const po_scene *scene = data;
  const double initial = po_initial_gap(scene, r);
  const double zero =
      po_scene_has_infinite_energy(scene) ? po_law_energy(&scene->law, initial) : 0.0;
  return r * (po_law_energy(&scene->law, initial - APPROACH) - zero);
}

static double far_energy(const po_scene *scene, double begin) {
  const double gap = po_initial_gap(scene, begin) - APPROACH;
  return po_far_energy(scene, begin, 1, &begin, &gap, APPROACH);
}

/* Between the begin and the last row it is the sum of the integrals between the rows. */
TEST(far_energy_of_a_table_is_exact) {
  ck_assert_ptr_nonnull(po_panel_table_get());
  po_scene scene = scene_of(&BODIES[2]);
  double sum = 0.0;
  for (double r = 41.0; r < 120.0; r = r == 41.0 ? 42.0 : r + 2.0) {
    double part = NAN;
    ck_assert_int_eq(
        po_integrate(integrand, &scene, r, r == 41.0 ? 42.0 : r + 2.0, 0.0, 1e-13, &part), PO_OK);
    sum += part;
  }
  const double expected = sum + far_energy(&scene, 120.0);
  ck_assert_double_eq_tol(far_energy(&scene, 41.0), expected, 1e-9 * fabs(expected));
}

static double cone_by_rows(double r) {
  return 0.1432 * r * (1.0 + 1e-9 * r);
}

/* The energy far out goes as r^(2 - 2N). Rows that are those of a cone but for their last digits
 * must not have 1e7 times the energy of the cone. */
TEST(rows_of_a_cone_have_the_energies_of_the_cone) {
  po_scene rows = scene_of(&BODIES[0]), cone = rows;
  rows.profile = table_of(cone_by_rows, 61, 120.0, 1.0);
  cone.profile = po_profile_sphere();
  ck_assert(po_profile_set(&cone.profile, "cone:0.1432"));
  po_result of_rows = pull_off_of(&rows, 1e-6), of_cone = pull_off_of(&cone, 1e-6);
  ck_assert_uint_ge(of_cone.extremum_count, 1);
  ck_assert_uint_eq(of_rows.extremum_count, of_cone.extremum_count);
  const po_special_point *a = &of_rows.extrema[0], *b = &of_cone.extrema[0];
  ck_assert_double_eq_tol(a->load, b->load, 1e-5 * fabs(b->load));
  ck_assert_double_eq_tol(a->energy, b->energy, 1e-5 * fabs(b->energy));
  po_result_clear(&of_rows);
  po_result_clear(&of_cone);
}
