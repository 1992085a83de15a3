/* The parts of po_dense.c that are written in vectors, for numbers of one type and vectors of one
 * length. The includer defines
 *   REAL         double or float
 *   ROWS         rows of a tile, 8 or 16: 64 bytes
 *   BYTES        length of a vector
 *   COLUMNS      columns of a tile, which stays in registers
 *   TARGET       the attribute of the processors that have such vectors
 *   SIZED(x)     the name of a function x for this type and this length
 * Every element is changed by c -= l u in the order of the columns of l, as in the plain algorithm,
 * so that results depend neither on the length of the vectors nor on the sizes of the blocks.
 * po_dense.c says what these sizes are. */

typedef REAL SIZED(lanes) __attribute__((vector_size(BYTES), aligned(_Alignof(REAL)), may_alias));
enum { SIZED(VECTORS) = ROWS * sizeof(REAL) / BYTES };

/* C -= A B with ROWS rows and `columns` <= COLUMNS columns, a constant. Given: A, packed by columns
 * of ROWS rows; B, `depth` rows. */
PO_INLINE void SIZED(tile)(size_t columns, size_t depth, const REAL *a, const REAL *b,
                           size_t b_stride, REAL *c, size_t c_stride) {
  enum { V = SIZED(VECTORS) };
  SIZED(lanes) sum[COLUMNS][V];
  for (size_t j = 0; j < columns; ++j)
    for (size_t v = 0; v < V; ++v)
      sum[j][v] = ((const SIZED(lanes) *)(c + j * c_stride))[v];
  for (size_t k = 0; k < depth; ++k) {
    const SIZED(lanes) *of_a = (const SIZED(lanes) *)a + k * V;
    for (size_t j = 0; j < columns; ++j)
      for (size_t v = 0; v < V; ++v)
        sum[j][v] -= of_a[v] * b[k + j * b_stride];
  }
  for (size_t j = 0; j < columns; ++j)
    for (size_t v = 0; v < V; ++v)
      ((SIZED(lanes) *)(c + j * c_stride))[v] = sum[j][v];
}

PO_INLINE void SIZED(tile_of)(size_t columns, size_t depth, const REAL *a, const REAL *b,
                              size_t b_stride, REAL *c, size_t c_stride) {
  if (columns == COLUMNS)
    SIZED(tile)(COLUMNS, depth, a, b, b_stride, c, c_stride);
  else
    for (size_t j = 0; j < columns; ++j)
      SIZED(tile)(1, depth, a, b + j * b_stride, b_stride, c + j * c_stride, c_stride);
}

/* As `tile_of` for fewer rows than ROWS, in a copy of C. */
PO_INLINE void SIZED(part_of_tile)(size_t rows, size_t columns, size_t depth, const REAL *a,
                                   const REAL *b, size_t b_stride, REAL *c, size_t c_stride) {
  REAL copy[ROWS * COLUMNS] = {0};
  for (size_t j = 0; j < columns; ++j)
    memcpy(copy + j * ROWS, c + j * c_stride, rows * sizeof *copy);
  SIZED(tile_of)(columns, depth, a, b, b_stride, copy, ROWS);
  for (size_t j = 0; j < columns; ++j)
    memcpy(c + j * c_stride, copy + j * ROWS, rows * sizeof *copy);
}

/* Copies a block of A with at most STRIPS * ROWS rows: ROWS rows after another, by columns; missing
 * rows are zero. */
PO_INLINE void SIZED(pack)(size_t rows, size_t depth, const REAL *a, size_t stride, REAL *packed) {
  for (size_t i = 0; i < rows; i += ROWS, packed += ROWS * depth)
    for (size_t k = 0; k < depth; ++k) {
      const size_t count = rows - i < ROWS ? rows - i : ROWS;
      for (size_t l = 0; l < ROWS; ++l)
        packed[ROWS * k + l] = l < count ? a[i + l + k * stride] : 0;
    }
}

/* C -= A B: C rows x columns, A rows x depth, all in one matrix of this stride. */
TARGET static void SIZED(subtract)(size_t rows, size_t columns, size_t depth, const REAL *a,
                                   const REAL *b, REAL *c, size_t stride) {
  REAL packed[STRIPS * ROWS * DEPTH];
  for (size_t k = 0; k < depth; k += DEPTH) {
    const size_t deep = depth - k < DEPTH ? depth - k : DEPTH;
    for (size_t i = 0; i < rows; i += STRIPS * ROWS) {
      const size_t high = rows - i < STRIPS * ROWS ? rows - i : STRIPS * ROWS;
      SIZED(pack)(high, deep, a + i + k * stride, stride, packed);
      for (size_t j = 0; j < columns; j += COLUMNS) {
        const size_t wide = columns - j < COLUMNS ? columns - j : COLUMNS;
        const REAL *right = b + k + j * stride;
        for (size_t s = 0; s < high; s += ROWS) {
          REAL *to = c + i + s + j * stride;
          if (high - s >= ROWS)
            SIZED(tile_of)(wide, deep, packed + s * deep, right, stride, to, stride);
          else
            SIZED(part_of_tile)
          (high - s, wide, deep, packed + s * deep, right, stride, to, stride);
        }
      }
    }
  }
}

/* B = L^-1 B, L of order n <= PANEL, unit lower triangular, in groups of columns, which a processor
 * can work on side by side. The upper triangle of the copy of L is zero and changes nothing. */
TARGET static void SIZED(forward)(size_t n, size_t columns, const REAL *l, REAL *b, size_t stride) {
  enum { GROUP = 8, PARTS = PANEL / ROWS * SIZED(VECTORS) };
  REAL lower[PANEL * PANEL] = {0}, x[GROUP * PANEL] = {0};
  for (size_t k = 0; k < n; ++k)
    for (size_t i = k + 1; i < n; ++i)
      lower[i + k * PANEL] = l[i + k * stride];
  for (size_t j = 0; j < columns; j += GROUP) {
    const size_t count = columns - j < GROUP ? columns - j : GROUP;
    for (size_t c = 0; c < count; ++c)
      memcpy(x + c * PANEL, b + (j + c) * stride, n * sizeof *x);
    for (size_t k = 0; k + 1 < n; ++k)
      for (size_t c = 0; c < GROUP; ++c) {
        const REAL factor = x[k + c * PANEL];
        for (size_t p = 0; p < PARTS; ++p)
          ((SIZED(lanes) *)x)[p + c * PARTS] -=
              ((const SIZED(lanes) *)lower)[p + k * PARTS] * factor;
      }
    for (size_t c = 0; c < count; ++c)
      memcpy(b + (j + c) * stride, x + c * PANEL, n * sizeof *x);
  }
}

static const NAME(vector_parts) SIZED(parts) = {SIZED(subtract), SIZED(forward)};

#undef BYTES
#undef COLUMNS
#undef TARGET
#undef SIZED
