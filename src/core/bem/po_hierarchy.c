#include "po_hierarchy.h"

#include <math.h>
#include <stdlib.h>

#include "po_kernel.h"
#include "po_memory.h"
#include "po_skeleton.h"

enum { N = PO_TABLE_ORDER };

/* Gap between two cells, in lengths of a cell, from which the kernel is a polynomial on it. */
static const double SEPARATION = 2.0;

/* Blocks above which the store is cleared at a change of the mesh, if most are not of this mesh: 80
 * MB. */
enum { MOST_BLOCKS = 1 << 16 };

po_status po_hierarchy_create(const po_panel_table *table, bool unbounded, double decay,
                              po_hierarchy **hierarchy) {
  po_hierarchy *h = *hierarchy = po_allocate(1, sizeof *h);
  if (!h)
    return PO_NO_MEMORY;
  h->table = table;
  h->unbounded = unbounded;
  h->decay = decay;
  const po_panel_rule *rule = &table->rule;
  for (int child = 0; child < 2; ++child)
    for (size_t i = 0; i < N; ++i) {
      double value[N];
      po_lagrange(N, rule->node, rule->barycentric, 0.5 * (rule->node[i] + child), value);
      for (size_t j = 0; j < N; ++j)
        h->from_parent[child][i + N * j] = value[j];
    }
  return PO_OK;
}

/* Values of one allocation, and places of the first table. */
enum { CHUNK_VALUES = 1 << 14, FIRST_PLACES = 1024 };

static bool is_key(po_block_key a, po_block_key b) {
  return a.first == b.first && a.second == b.second;
}

/* Returned: the place of the key, or the empty place where it belongs. */
static po_block_place *place_of(const po_block_store *s, po_block_key key) {
  static const uint64_t MIX = 0x9e3779b97f4a7c15U; /* 2^64 over the golden ratio (Knuth) */
  const uint64_t mixed = (key.first * MIX ^ key.second) * MIX;
  size_t k = (size_t)(mixed >> 20) & (s->room - 1);
  while (s->place[k].key.first != 0 && !is_key(s->place[k].key, key))
    k = (k + 1) & (s->room - 1);
  return s->place + k;
}

/* Returned: false if memory runs out; then the store is unchanged. */
static bool enlarge(po_block_store *s) {
  po_block_store larger = *s;
  larger.room = s->room ? 2 * s->room : FIRST_PLACES;
  larger.place = po_allocate(larger.room, sizeof *larger.place);
  if (!larger.place)
    return false;
  for (size_t k = 0; k < s->room; ++k)
    if (s->place[k].key.first != 0)
      *place_of(&larger, s->place[k].key) = s->place[k];
  free(s->place);
  *s = larger;
  return true;
}

static double *new_block(po_block_store *s, size_t size) {
  if (!s->chunk || s->used + size > CHUNK_VALUES) {
    s->chunk = po_arena_reserve(&s->chunks, CHUNK_VALUES, sizeof *s->chunk);
    s->used = 0;
  }
  if (!s->chunk)
    return NULL;
  s->used += size;
  return s->chunk + s->used - size;
}

static void block_store_clear(po_block_store *s) {
  po_arena_free(&s->chunks);
  free(s->place);
  *s = (po_block_store){0};
}

void po_hierarchy_destroy(po_hierarchy *h) {
  if (!h)
    return;
  po_arena_free(&h->mesh);
  free(h->kernel.pair);
  free(h->product.pair);
  block_store_clear(&h->store);
  free(h);
}

/* The length and the ends of a cell on a domain of radius 1. */
static double size_of(const po_cell *cell) {
  return po_panel_size(cell->place);
}

enum kind { KERNEL, PRODUCT, TAIL, HALVES };

/* The number of a panel among all, the coarsest first, from 1 to less than 2^(PO_DEEPEST_LEVEL +
 * 1); 0 if there is none. */
static uint64_t number_of(const po_panel *a) {
  return a ? ((uint64_t)1 << a->level) + a->index : 0;
}

static po_block_key key_of(enum kind kind, const po_panel *a, const po_panel *b) {
  return (po_block_key){1 | (uint64_t)kind << 1 | number_of(a) << 3, number_of(b)};
}

static void place_nodes(const po_hierarchy *h, po_panel place, double *node) {
  const double begin = po_panel_begin(place), size = po_panel_size(place);
  for (size_t j = 0; j < N; ++j)
    node[j] = begin + size * h->table->rule.node[j];
}

static void fill_kernel(const po_hierarchy *h, po_panel target, po_panel source, double *block) {
  double r[N], s[N], apart[N];
  place_nodes(h, target, r);
  place_nodes(h, source, s);
  const double between = po_panel_begin(source) - po_panel_begin(target); /* exact */
  const double *x = h->table->rule.node;
  for (size_t j = 0; j < N; ++j) { /* symmetric: a row of the transpose is a column */
    for (size_t i = 0; i < N; ++i)
      apart[i] = between + (po_panel_size(source) * x[j] - po_panel_size(target) * x[i]);
    po_kernel_row(s[j], r, apart, N, block + N * j);
  }
}

static void fill_product(const po_hierarchy *h, po_panel target, po_panel source, double *block) {
  po_panel_block rows;
  po_panel_table_block(h->table, target, source, rows);
  for (size_t j = 0; j < N; ++j)
    for (size_t i = 0; i < N; ++i)
      block[i + N * j] = rows[i][j];
}

/* The kernel between the skeleton nodes of the halves of a cell. */
static void fill_halves(const po_hierarchy *h, po_panel cell, double *block) {
  const double *x = h->table->skeleton->node;
  const double begin = po_panel_begin(cell), half = 0.5 * po_panel_size(cell);
  double left[PO_SKELETON_NODES], right[PO_SKELETON_NODES];
  for (size_t i = 0; i < PO_SKELETON_NODES; ++i) {
    left[i] = begin + half * x[i];
    right[i] = begin + half + half * x[i];
  }
  for (size_t j = 0; j < PO_SKELETON_NODES; ++j)
    po_kernel_row(right[j], left, NULL, PO_SKELETON_NODES, block + PO_SKELETON_NODES * j);
}

/* The block that maps the panel to infinity to the panel a, or b to it, or, without either, to
 * itself. Returned: the number of kernel evaluations. */
static uint64_t fill_tail(const po_hierarchy *h, const po_panel *a, const po_panel *b,
                          double *block) {
  po_panel_span tail = {.begin = 1.0, .end = INFINITY, .decay = h->decay};
  double r[N];
  if (a)
    place_nodes(h, *a, r);
  for (size_t i = 0; i < N && !a; ++i)
    r[i] = 1.0 / h->table->rule.node[i];
  if (b)
    tail = (po_panel_span){.begin = po_panel_begin(*b), .end = po_panel_end(*b)};
  uint64_t evaluations = 0;
  for (size_t i = 0; i < N; ++i)
    evaluations += po_panel_influence(&h->table->rule, tail, r[i], block + i, N);
  return evaluations;
}

/* The largest coefficients of the columns of a block; see po_hierarchy_reach. */
static void find_reach(const double *block, double *reach) {
  for (size_t j = 0; j < N; ++j) {
    reach[j] = 0.0;
    for (size_t i = 0; i < N; ++i) {
      const double size = fabs(block[i + N * j]);
      reach[j] = size > reach[j] ? size : reach[j];
    }
  }
}

/* Returned: the block of this kind from the store, computed if it is new; NULL, with `trouble`, if
 * memory runs out. Where a panel is not given, it is that to infinity. Blocks to be multiplied by
 * the traction are followed by the reach of their columns. */
static const double *stored(po_hierarchy *h, enum kind kind, const po_panel *a, const po_panel *b) {
  po_block_store *s = &h->store;
  const po_block_key key = key_of(kind, a, b);
  const bool had_room = 2 * s->count < s->room || enlarge(s);
  po_block_place *const place = had_room ? place_of(s, key) : NULL;
  if (place && is_key(place->key, key))
    return place->block;
  const bool with_reach = kind == PRODUCT || kind == TAIL;
  const size_t values = kind == HALVES ? PO_SKELETON_SIZE : PO_BLOCK_SIZE;
  double *block = place ? new_block(s, values + (with_reach ? N : 0)) : NULL;
  if (!block) {
    h->trouble = PO_NO_MEMORY;
    return NULL;
  }
  *place = (po_block_place){key, block};
  ++s->count;
  if (kind == KERNEL)
    fill_kernel(h, *a, *b, block);
  else if (kind == PRODUCT)
    fill_product(h, *a, *b, block);
  else if (kind == HALVES)
    fill_halves(h, *a, block);
  h->evaluations += kind == TAIL ? fill_tail(h, a, b, block) : values;
  if (with_reach)
    find_reach(block, block + PO_BLOCK_SIZE);
  return block;
}

static void add(po_hierarchy *h, po_interactions *list, uint32_t target, uint32_t source,
                const double *block) {
  po_interaction *pair = po_grow(list->pair, list->count, &list->room, sizeof *pair);
  if (!pair) {
    h->trouble = PO_NO_MEMORY;
    return;
  }
  list->pair = pair;
  list->pair[list->count++] = (po_interaction){target, source, block};
}

static const double *add_product(po_hierarchy *h, const po_cell *target, const po_cell *source) {
  const double *block = stored(h, PRODUCT, &target->place, &source->place);
  add(h, &h->product, target->panel, source->panel, block);
  return block;
}

/* Adds the interactions between the panels of two cells, the first of which is nearer to the axis.
 */
static void pair_cells(po_hierarchy *h, uint32_t left, uint32_t right) {
  const po_cell *a = h->cell + left, *b = h->cell + right;
  const double gap = po_panel_begin(b->place) - po_panel_end(a->place);
  const bool serves_a = po_cell_is_panel(a) || gap >= SEPARATION * size_of(a);
  const bool serves_b = po_cell_is_panel(b) || gap >= SEPARATION * size_of(b);
  if (serves_a && serves_b) {
    if (gap > 0.0) {
      add(h, &h->kernel, left, right, stored(h, KERNEL, &a->place, &b->place));
    } else {
      add_product(h, a, b);
      add_product(h, b, a);
    }
  } else if (serves_b || (!serves_a && size_of(a) >= size_of(b))) {
    pair_cells(h, left + 1, right);
    pair_cells(h, h->cell[left].right, right);
  } else {
    pair_cells(h, left, right + 1);
    pair_cells(h, left, h->cell[right].right);
  }
}

static void pair_within(po_hierarchy *h, uint32_t at) {
  const po_cell *cell = h->cell + at;
  if (po_cell_is_panel(cell)) {
    h->own[cell->panel] = add_product(h, cell, cell);
    return;
  }
  h->halves[at] = stored(h, HALVES, &cell->place, NULL);
  pair_within(h, at + 1);
  pair_within(h, h->cell[at].right);
  pair_cells(h, at + 1, h->cell[at].right);
}

/* Adds the interactions of all panels with the panel to infinity. */
static void pair_with_tail(po_hierarchy *h) {
  const uint32_t tail = (uint32_t)h->panels.count;
  for (uint32_t k = 0; k < tail; ++k) {
    const po_panel *place = &h->panels.panel[k];
    add(h, &h->product, k, tail, stored(h, TAIL, place, NULL));
    h->to_tail[k] = stored(h, TAIL, NULL, place);
    add(h, &h->product, tail, k, h->to_tail[k]);
  }
  add(h, &h->product, tail, tail, stored(h, TAIL, NULL, NULL));
}

/* Makes the cell that contains panels from `first` on, and those below it. Returned: the end of its
 * panels. */
static uint32_t make_cell(po_hierarchy *h, po_panel place, uint32_t first) {
  const uint32_t at = (uint32_t)h->cells++;
  po_cell *cell = h->cell + at;
  *cell = (po_cell){place, PO_NO_CELL, first, first + 1};
  if (po_panel_equal(h->panels.panel[first], place)) {
    h->cell_of_panel[first] = at;
    return first + 1;
  }
  const po_panel child = {place.level + 1, 2 * place.index};
  const uint32_t middle = make_cell(h, child, first);
  cell->right = (uint32_t)h->cells;
  cell->end = make_cell(h, (po_panel){child.level, child.index + 1}, middle);
  return cell->end;
}

static po_status reserve(po_hierarchy *h, size_t panels) {
  if (panels <= h->room)
    return PO_OK;
  const size_t room = panels + panels / 2;
  po_arena_free(&h->mesh);
  h->cell = po_arena_allocate(&h->mesh, 2 * room, sizeof *h->cell);
  h->cell_of_panel = po_arena_allocate(&h->mesh, room, sizeof *h->cell_of_panel);
  h->own = po_arena_allocate(&h->mesh, room, sizeof *h->own);
  h->to_tail = po_arena_allocate(&h->mesh, room, sizeof *h->to_tail);
  h->halves = po_arena_allocate(&h->mesh, 2 * room, sizeof *h->halves);
  h->weight = po_arena_allocate(&h->mesh, room * N, sizeof *h->weight);
  h->charge = po_arena_allocate(&h->mesh, 2 * room * N, sizeof *h->charge);
  h->field = po_arena_allocate(&h->mesh, 2 * room * N, sizeof *h->field);
  h->room = h->mesh.ran_out ? 0 : room;
  return h->mesh.ran_out ? PO_NO_MEMORY : PO_OK;
}

po_status po_hierarchy_mesh(po_hierarchy *h, const po_panels *panels) {
  po_panels_copy(panels, &h->panels);
  h->trouble = reserve(h, panels->count);
  if (h->trouble)
    return h->trouble;
  if (h->store.count > MOST_BLOCKS &&
      h->store.count > 4 * (h->kernel.count + h->product.count)) /* blocks of the mesh before */
    block_store_clear(&h->store);
  h->cells = h->kernel.count = h->product.count = 0;
  make_cell(h, (po_panel){0, 0}, 0);
  double node[N];
  for (size_t k = 0; k < panels->count; ++k) {
    place_nodes(h, panels->panel[k], node);
    for (size_t j = 0; j < N; ++j)
      h->weight[k * N + j] = h->table->rule.weight[j] * po_panel_size(panels->panel[k]) * node[j];
  }
  pair_within(h, 0);
  if (h->unbounded)
    pair_with_tail(h);
  return h->trouble;
}

void po_hierarchy_fill_matrix(const po_hierarchy *h, double radius, double *matrix) {
  const size_t n = po_hierarchy_nodes(h);
  for (size_t target = 0; target < n / N; ++target)
    for (size_t source = 0; source < n / N; ++source) {
      const po_panel *a = target < h->panels.count ? h->panels.panel + target : NULL;
      const po_panel *b = source < h->panels.count ? h->panels.panel + source : NULL;
      double block[PO_BLOCK_SIZE];
      if (a && b)
        fill_product(h, *a, *b, block);
      else
        fill_tail(h, a, b, block);
      for (size_t j = 0; j < N; ++j)
        for (size_t i = 0; i < N; ++i)
          matrix[target * N + i + n * (source * N + j)] = radius * block[i + N * j];
    }
}

size_t po_hierarchy_nodes(const po_hierarchy *h) {
  return (h->panels.count + (h->unbounded ? 1 : 0)) * N;
}
