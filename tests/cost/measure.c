/* Measures what equilibria cost, and writes one JSON document, pulloff-cost/1
 * (tests/cost/README.md).
 *
 * Meshes: a wavy sphere of growing radius, up to where the waves near the axis jump into contact;
 * the number of waves, and so that of nodes, grows as the root of the radius. Waves: the whole
 * solve of wavy spheres of growing radius, whose contact at pull-off holds more and more waves. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

#include "machine.h"
#include "one_equilibrium.h"
#include "po_deadline.h"
#include "po_file.h"
#include "po_linear.h"
#include "po_solve.h"

/* The waviness of Figures 4 to 9 of the paper with A = 1. */
static const double TABOR = 3.0, AMPLITUDE = 1.0, WAVELENGTH = 20.0;
/* The surface ends where the initial gap without waves is FARTHEST; eps. */
static const double FARTHEST = 40.0, BEGIN = -4.0, END = -2.0;

static const double RADIUS_OF_MESH[] = {20, 50, 200, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1.3e7};
static const double RADIUS_OF_WAVES[] = {50, 100, 200, 400, 800, 1600, 3200, 6400};
enum {
  MESHES = sizeof RADIUS_OF_MESH / sizeof *RADIUS_OF_MESH,
  WAVES = sizeof RADIUS_OF_WAVES / sizeof *RADIUS_OF_WAVES,
  FEW = 3,           /* of either, for a test */
  MOST_DENSE = 3500, /* nodes: the matrix takes 100 MB, its factors half of that */
};

static po_request request_of(double radius) {
  po_request request = po_request_default();
  request.scene.tabor = TABOR;
  request.scene.amplitude = AMPLITUDE;
  request.scene.wavelength = WAVELENGTH;
  request.scene.radius = radius;
  return request;
}

static json_t *json_of_timed(timed t) {
  return json_pack("{s:f, s:f, s:f}", "seconds", t.seconds, "flops", t.work.flops, "bytes",
                   t.work.bytes);
}

static json_t *json_of_way(const way_cost *cost) {
  return json_pack("{s:f, s:I, s:I, s:o, s:o, s:o}", "seconds", cost->seconds, "newton_iterations",
                   (json_int_t)cost->iterations, "active", (json_int_t)cost->active, "product",
                   json_of_timed(cost->product), "factors", json_of_timed(cost->factors), "solve",
                   json_of_timed(cost->solve));
}

/* Solves a request. Returned: the processor time of the trace in *seconds. */
static po_status trace(const po_request *request, po_result *result, double *seconds) {
  const double begin = po_clock_thread();
  const po_status status = po_solve(request, result);
  *seconds = po_clock_thread() - begin;
  return status;
}

static json_t *json_of_trace(const po_result *result, double seconds) {
  return json_pack("{s:f, s:I, s:I, s:I, s:I, s:I}", "seconds", seconds, "points",
                   (json_int_t)result->work.points, "newton_iterations",
                   (json_int_t)result->work.newton_iterations, "factorizations",
                   (json_int_t)result->work.factorizations, "nodes", (json_int_t)result->work.nodes,
                   "factorized_nodes", (json_int_t)result->work.factorized_nodes);
}

/* Adds the object to a list with the key `radius`. */
static void append(json_t *list, double radius, json_t *object) {
  json_object_set_new(object, "radius", json_real(radius));
  json_array_append_new(list, object);
}

static po_status measure_mesh(double radius, json_t *list) {
  po_request request = request_of(radius);
  po_result result;
  double seconds;
  equilibrium_cost cost = {0};
  request.scene.outer_radius = sqrt(2.0 * radius * FARTHEST);
  request.approach_start = BEGIN;
  request.approach_end = request.profile_approach = END;
  request.want = PO_WANT_PROFILE;
  po_status status = trace(&request, &result, &seconds);
  if (!status)
    status = equilibrium_measure(&request.scene, &result, MOST_DENSE, &cost);
  if (!status)
    append(list, radius,
           json_pack("{s:I, s:o, s:o, s:o}", "nodes", (json_int_t)cost.nodes, "trace",
                     json_of_trace(&result, seconds), "hierarchical",
                     json_of_way(&cost.hierarchical), "dense",
                     cost.has_dense ? json_of_way(&cost.dense) : json_null()));
  po_result_clear(&result);
  return status;
}

static po_status measure_waves(double radius, json_t *list) {
  const po_request request = request_of(radius);
  po_result result;
  double seconds;
  const po_status status = trace(&request, &result, &seconds);
  if (!status)
    append(list, radius,
           json_pack("{s:f, s:o}", "waves", result.pull_off.contact_radius / WAVELENGTH, "trace",
                     json_of_trace(&result, seconds)));
  po_result_clear(&result);
  return status;
}

static po_status measure_all(size_t meshes, size_t waves, json_t *document) {
  machine_rates rates;
  json_t *mesh_list = json_array(), *wave_list = json_array();
  po_status status = machine_measure(&rates);
  for (size_t k = 0; !status && k < meshes; ++k)
    status = measure_mesh(RADIUS_OF_MESH[k], mesh_list);
  for (size_t k = 0; !status && k < waves; ++k)
    status = measure_waves(RADIUS_OF_WAVES[k], wave_list);
  json_object_set_new(document, "schema", json_string("pulloff-cost/1"));
  json_object_set_new(document, "scene",
                      json_pack("{s:f, s:f, s:f}", "tabor", TABOR, "amplitude", AMPLITUDE,
                                "wavelength", WAVELENGTH));
  json_object_set_new(document, "meshes", mesh_list);
  json_object_set_new(document, "waves", wave_list);
  if (!status)
    json_object_set_new(document, "machine",
                        json_pack("{s:f, s:f, s:f, s:s}", "flops_double", rates.in_double,
                                  "flops_single", rates.in_single, "bytes", rates.memory, "library",
                                  po_linear_library()));
  return status;
}

int main(int argc, char **argv) {
  const bool few = argc > 1 && strcmp(argv[1], "--few") == 0;
  if (argc != 2 + few) {
    fprintf(stderr,
            "Usage: measure_cost [--few] FILE\n"
            "Measures what equilibria cost, and writes a JSON document. --few: the smallest "
            "scenes only\n");
    return 2;
  }
  json_t *document = json_object();
  const po_status status = measure_all(few ? FEW : MESHES, few ? FEW : WAVES, document);
  char *text = status ? NULL : json_dumps(document, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
  json_decref(document);
  const bool written = text && po_file_write(argv[argc - 1], text, strlen(text)) == PO_OK;
  free(text);
  if (status || !written)
    fprintf(stderr, "measure_cost: %s\n", *po_message() ? po_message() : "no memory");
  return status ? 3 : written ? 0 : 4;
}
