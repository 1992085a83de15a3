#include "po_adaptive.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

enum { ORDER = PO_TABLE_ORDER, MOST_PANELS = 400 };

struct po_adaptive {
  const po_panel_table *table;
  double root;
  bool unbounded, wavy;
  po_leaves leaves, before;
  po_surface surface;
  double *spare;           /* the matrix of the next mesh */
  size_t room, spare_room; /* of the matrices, in numbers */
};

static size_t nodes_of(const po_adaptive *a, const po_leaves *leaves) {
  return (leaves->count + (a->unbounded ? 1 : 0)) * ORDER;
}

size_t po_adaptive_capacity(const po_adaptive *a) {
  (void)a;
  return (MOST_PANELS + 1) * ORDER;
}

const po_surface *po_adaptive_surface(const po_adaptive *a) {
  return &a->surface;
}
const po_leaves *po_adaptive_leaves(const po_adaptive *a) {
  return &a->leaves;
}
double po_adaptive_root(const po_adaptive *a) {
  return a->root;
}

po_status po_adaptive_create(const po_scene *scene, double root, uint32_t level,
                             po_adaptive **adaptive) {
  po_adaptive *a = po_allocate(1, sizeof *a);
  *adaptive = a;
  if (!a)
    return PO_NO_MEMORY;
  a->table = po_panel_table_get();
  a->root = root;
  a->unbounded = isinf(scene->outer_radius);
  a->wavy = po_scene_is_wavy(scene);
  const size_t most = po_adaptive_capacity(a);
  po_surface *s = &a->surface;
  s->core_radius = root;
  s->node = po_allocate(most, sizeof *s->node);
  s->weight = po_allocate(most, sizeof *s->weight);
  s->length = po_allocate(most, sizeof *s->length);
  po_leaves leaves;
  po_leaves_uniform(&leaves, level);
  po_status status = PO_NO_MEMORY;
  if (a->table && s->node && s->weight && s->length)
    status = po_adaptive_mesh(a, &leaves);
  if (status) {
    po_adaptive_destroy(a);
    *adaptive = NULL;
  }
  return status;
}

void po_adaptive_destroy(po_adaptive *a) {
  if (!a)
    return;
  free(a->surface.node);
  free(a->surface.weight);
  free(a->surface.length);
  free(a->surface.influence);
  free(a->spare);
  free(a);
}

/* Whether `node` are the nodes of a leaf, to rounding. */
static bool has_nodes(const po_adaptive *a, po_leaf leaf, const double *node) {
  const double begin = a->root * po_leaf_begin(leaf), size = a->root * po_leaf_size(leaf);
  for (size_t j = 0; j < ORDER; ++j)
    if (!(fabs(begin + size * a->table->rule.node[j] - node[j]) < 1e-9 * size))
      return false;
  return true;
}

po_status po_adaptive_leaves_of(const po_adaptive *a, size_t n, const double *node,
                                po_leaves *leaves) {
  const double *x = a->table->rule.node;
  leaves->count = 0;
  for (size_t j = 0; j + ORDER <= n && leaves->count < PO_MOST_LEAVES; j += ORDER) {
    const double size = (node[j + ORDER - 1] - node[j]) / (x[ORDER - 1] - x[0]);
    const double begin = (node[j] - x[0] * size) / size;
    const po_leaf leaf = {(uint32_t)lround(log2(a->root / size)), (uint32_t)lround(begin)};
    if (!has_nodes(a, leaf, node + j))
      break;
    leaves->leaf[leaves->count++] = leaf;
  }
  return leaves->count * ORDER == n ? PO_OK
                                    : po_fail(PO_BAD_INPUT, "radii that are not those of panels");
}

static po_panel panel_of(const po_adaptive *a, const po_leaves *leaves, size_t k) {
  if (k == leaves->count)
    return (po_panel){a->root, INFINITY};
  return (po_panel){a->root * po_leaf_begin(leaves->leaf[k]),
                    a->root * po_leaf_end(leaves->leaf[k])};
}

static void place_nodes(po_adaptive *a) {
  po_surface *s = &a->surface;
  s->n = nodes_of(a, &a->leaves);
  s->resolved = a->unbounded && a->wavy ? s->n - ORDER : s->n;
  for (size_t k = 0; k < s->n / ORDER; ++k)
    po_panel_nodes(&a->table->rule, panel_of(a, &a->leaves, k), s->node + k * ORDER,
                   s->weight + k * ORDER, s->length + k * ORDER);
}

/* Where each panel of the mesh was in the mesh before: its place, or SIZE_MAX. */
static void match_panels(const po_adaptive *a, size_t *was) {
  size_t old = 0;
  for (size_t k = 0; k < a->leaves.count; ++k) {
    const po_leaf leaf = a->leaves.leaf[k];
    while (old < a->before.count && po_leaf_end(a->before.leaf[old]) <= po_leaf_begin(leaf))
      ++old;
    was[k] = old < a->before.count && po_leaf_equal(a->before.leaf[old], leaf) ? old : SIZE_MAX;
  }
  was[a->leaves.count] =
      a->before.count; /* the panel to infinity stays; unless there was no mesh */
  if (a->before.count == 0)
    was[a->leaves.count] = SIZE_MAX;
}

static void copy_block(const double *from, size_t from_stride, double *to, size_t to_stride) {
  for (size_t j = 0; j < ORDER; ++j)
    memcpy(to + j * to_stride, from + j * from_stride, ORDER * sizeof *to);
}

static void compute_block(po_adaptive *a, size_t target, size_t source, double *to, size_t stride) {
  const po_leaves *leaves = &a->leaves;
  if (target < leaves->count && source < leaves->count) {
    po_panel_block block;
    po_panel_table_block(a->table, leaves->leaf[target], leaves->leaf[source], block);
    for (size_t j = 0; j < ORDER; ++j)
      for (size_t i = 0; i < ORDER; ++i)
        to[i + j * stride] = a->root * block[i][j];
    a->surface.kernel_evaluations += ORDER * ORDER;
    return;
  }
  const po_panel panel = panel_of(a, leaves, source);
  for (size_t i = 0; i < ORDER; ++i)
    a->surface.kernel_evaluations += po_panel_influence(
        &a->table->rule, panel, a->surface.node[target * ORDER + i], to + i, stride);
}

po_status po_adaptive_mesh(po_adaptive *a, const po_leaves *leaves) {
  if (leaves->count > MOST_PANELS)
    return po_fail(PO_OUT_OF_NODES, "the traction needs more than %d panels", MOST_PANELS);
  a->spare = po_reserve_matrix(a->spare, &a->spare_room, nodes_of(a, leaves), sizeof *a->spare);
  if (!a->spare)
    return PO_NO_MEMORY;
  const size_t old_n = a->surface.n;
  size_t was[PO_MOST_LEAVES + 1];
  a->before = a->leaves;
  a->leaves = *leaves;
  place_nodes(a);
  match_panels(a, was);
  const size_t n = a->surface.n, panels = n / ORDER;
  for (size_t source = 0; source < panels; ++source)
    for (size_t target = 0; target < panels; ++target) {
      double *to = a->spare + target * ORDER + n * source * ORDER;
      if (was[target] != SIZE_MAX && was[source] != SIZE_MAX)
        copy_block(a->surface.influence + was[target] * ORDER + old_n * was[source] * ORDER, old_n,
                   to, n);
      else
        compute_block(a, target, source, to, n);
    }
  double *const matrix = a->surface.influence;
  const size_t room = a->room;
  a->surface.influence = a->spare;
  a->room = a->spare_room;
  a->spare = matrix;
  a->spare_room = room;
  return PO_OK;
}

/* Lengths go with the root: nodes and the influence as the root, weights as its square. */
void po_adaptive_resize(po_adaptive *a, double root) {
  const double factor = root / a->root;
  if (factor == 1.0)
    return;
  po_surface *s = &a->surface;
  a->root = s->core_radius = root;
  place_nodes(a);
  for (size_t j = 0; j < s->n * s->n; ++j)
    s->influence[j] *= factor;
}
