#include "po_size.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_panel_table.h"
#include "po_panels.h"
#include "po_rigid.h"
#include "po_scales.h"
#include "po_trace.h"

/* Panels of the finest mesh, fitted to random scenes, whose meshes had between 0.5 and 2.2 times as
 * many. A contact edge is 1/coupling wide; the mesh is halved towards the edges, and within each
 * wave as far as the amplitude asks for it. */
static const double PANELS = 4.5, PANELS_A_HALVING = 2.9, PANELS_A_WAVE = 1.0,
                    PANELS_A_HALVING_OF_WAVE = 1.9;

/* The error of a panel of 12 nodes goes as its length to the power 24 (the load). */
static const double TOLERANCE_POWER = 1.0 / 24.0, USUAL_TOLERANCE = 1e-6;
static const double PANELS_MARGIN = 2.5;

/* Memory: of the program and its libraries; for a node, factors, lists and states; and blocks of
 * influence coefficients of former meshes, which are kept as far as MOST_BLOCKS of po_hierarchy.c.
 */
static const double PROGRAM_BYTES = 12e6, NODE_BYTES = 8e3, BLOCK_BYTES = 80e6,
                    BLOCK_BYTES_A_NODE = 32e3;

const size_t PO_MOST_NODES_OF_MESH = (size_t)PO_MOST_PANELS * PO_TABLE_ORDER;

/* The radius of the part of the surface that may come into contact. */
static double contact_part(const po_request *request) {
  po_request unbounded = *request;
  unbounded.scene.outer_radius = INFINITY;
  return fmin(po_trace_core(&unbounded), request->scene.outer_radius);
}

static double panels_of(const po_request *request) {
  const po_scene *scene = &request->scene;
  const double core = contact_part(request);
  double panels = PANELS + PANELS_A_HALVING * po_log1p(core * po_scene_coupling(scene)) / M_LN2;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    panels += core / wave.length *
              (PANELS_A_WAVE + PANELS_A_HALVING_OF_WAVE * po_log1p(wave.amplitude) / M_LN2);
  }
  return PANELS_MARGIN * panels *
         po_pow(USUAL_TOLERANCE / request->mesh.tolerance, TOLERANCE_POWER);
}

/* Rings and triangles, whose matrices are dense. */
static po_size size_of_fixed(const po_request *request) {
  const po_scene *scene = &request->scene;
  double nodes = (double)request->mesh.nodes;
  if (isinf(scene->outer_radius)) {
    const double core = po_trace_core(request);
    const double beyond = po_averaging_radius(scene, po_averaging_phase(scene, core)) - core;
    nodes += PO_TABLE_ORDER;
    if (po_scene_is_wavy(scene))
      nodes += PO_TABLE_ORDER * ceil(beyond / po_initial_gap_detail(scene));
  }
  return (po_size){(size_t)nodes, PROGRAM_BYTES + 2.0 * sizeof(double) * nodes * nodes};
}

po_size po_trace_size(const po_request *request) {
  if (po_rigid_suffices(&request->scene))
    return (po_size){0, PROGRAM_BYTES};
  if (request->mesh.scheme != PO_PANEL)
    return size_of_fixed(request);
  const double nodes = PO_TABLE_ORDER * ceil(panels_of(request));
  double bytes = PROGRAM_BYTES + NODE_BYTES * nodes + fmin(BLOCK_BYTES, BLOCK_BYTES_A_NODE * nodes);
  if (request->want & PO_WANT_DIAGNOSTICS) /* a dense matrix and its factors */
    bytes += 2.0 * sizeof(double) * nodes * nodes;
  return (po_size){(size_t)nodes, bytes};
}
