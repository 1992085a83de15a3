#include "po_mesh.h"

const char *const PO_SCHEMES[] = {
    [PO_RING] = "ring", [PO_TRIANGLE] = "triangle", [PO_PANEL] = "panel", NULL};
const char *const PO_GRADINGS[] = {[PO_UNIFORM] = "uniform", [PO_GRADED] = "graded", NULL};

/* Below the smallest tolerance rounding dominates; above the greatest one the coarsest mesh already
 * meets the tolerance. */
const double PO_LEAST_TOLERANCE = 1e-10;
static const double GREATEST_TOLERANCE = 1e-2;
/* Fewer nodes do not resolve the contact; more would need over 200 MB for a solve, and panels reach
 * the same accuracy with fewer. */
enum { LEAST_NODES = 8, MOST_NODES_ASKED = 2500 };

po_mesh po_mesh_default(void) {
  return (po_mesh){.scheme = PO_PANEL, .grading = PO_UNIFORM, .nodes = 501, .tolerance = 1e-6};
}

po_status po_mesh_check(const po_mesh *mesh) {
  if ((int)mesh->scheme < 0 || mesh->scheme > PO_PANEL)
    return po_fail(PO_BAD_INPUT, "scheme is %d: expected ring, triangle or panel",
                   (int)mesh->scheme);
  if ((int)mesh->grading < 0 || mesh->grading > PO_GRADED)
    return po_fail(PO_BAD_INPUT, "grading is %d: expected uniform or graded", (int)mesh->grading);
  if (mesh->scheme == PO_PANEL) {
    if (!(mesh->tolerance >= PO_LEAST_TOLERANCE && mesh->tolerance <= GREATEST_TOLERANCE))
      return po_fail(PO_BAD_INPUT, "tolerance is %g: expected %g to %g", mesh->tolerance,
                     PO_LEAST_TOLERANCE, GREATEST_TOLERANCE);
    return PO_OK;
  }
  if (mesh->nodes < LEAST_NODES || mesh->nodes > MOST_NODES_ASKED)
    return po_fail(PO_BAD_INPUT, "nodes is %zu: expected %d to %d", mesh->nodes, LEAST_NODES,
                   MOST_NODES_ASKED);
  return PO_OK;
}
