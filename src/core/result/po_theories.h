/* What the theories say about the pull-off force of a solve. One row of PO_THEORY_ROWS a theory:
 * enumerator, name, words, source. The documents, the JSON Schema, the printed tables and the
 * messages follow from the rows; how a theory is evaluated is in src/core/theory. */
#ifndef PO_THEORIES_H
#define PO_THEORIES_H

#include <stdbool.h>
#include <stddef.h>

// clang-format off
#define PO_THEORY_ROWS(X) \
  X(RIGID, "rigid", "rigid bodies", "Bradley 1932, Derjaguin 1934; Eqs 21 and 22") \
  X(DMT, "dmt", "DMT", "Derjaguin, Muller and Toporov 1975: attraction of undeformed bodies that touch") \
  X(JKR, "jkr", "JKR", "Johnson, Kendall and Roberts 1971, any profile, any preload") \
  X(MAUGIS, "maugis", "Maugis-Dugdale", "Maugis 1992, any profile, with the greatest tension of the law") \
  X(CARPICK, "carpick-ogletree-salmeron", "Carpick-Ogletree-Salmeron", "Carpick, Ogletree and Salmeron 1999") \
  X(PIETREMENT, "pietrement-troyon", "Pietrement-Troyon", "Pietrement and Troyon 2000") \
  X(SCHWARZ, "schwarz", "Schwarz", "Schwarz 2003, with the alpha of Carpick, Ogletree and Salmeron") \
  X(GUDURU, "guduru", "Eq 5 after the preload", "Guduru 2007; Eq 5, other waves as JKR, after the same preload") \
  X(KESARI_LEW, "kesari-lew", "Kesari-Lew", "Kesari and Lew 2011; Eq 24") \
  X(PERSSON_TOSATTI, "persson-tosatti", "Persson-Tosatti", "Persson and Tosatti 2001; Eqs 25, 27 and 29") \
  X(RUMPF, "rumpf-rabinowicz", "Rumpf-Rabinowicz", "Rumpf 1990; Eq 20") \
  X(PERSSON_BRENER, "persson-brener", "Persson-Brener", "Persson and Brener 2005: work of adhesion of a moving edge, JKR of the relaxed body") \
  X(JKR_AT_ONCE, "jkr-at-once", "JKR, unloaded at once", "Johnson, Kendall and Roberts 1971 with w/k: the glassy body, flattened") \
  X(RIGID_AT_ONCE, "rigid-at-once", "rigid, unloaded at once", "Bradley 1932 with R/k: a rigid sphere, flattened")

/* The numbers that decide whether the assumptions of a theory hold: enumerator, name, words. */
#define PO_ASSUMPTION_ROWS(X) \
  X(NOTHING, "none", "") \
  X(ELONGATION, "elongation", "elastic deformation of rigid bodies over the range of the law") \
  X(TOUCH, "touch", "approach of rigid bodies at pull-off over the range of the law") \
  X(ZONE, "zone", "cohesive zone over the length in which the profile changes") \
  X(FLAT, "flat", "stress of the flat over the greatest tension") \
  X(FORM, "form", "effect of the form of the law") \
  X(FULL_DISC, "full_disc", "part of the contact radius without a groove") \
  X(WAVES, "waves_in_contact", "contact radius over wavelength") \
  X(EFFECT, "effect_of_waves", "effect of the waves") \
  X(BARRIER, "barrier", "barrier of the waves, A sqrt(pi/(2 c lambda))") \
  X(NEXT_CREST, "next_crest", "gap of the sphere at the next crest") \
  X(SLOW, "slow", "increase of the work of adhesion by the speed of the edge") \
  X(AT_ONCE, "at_once", "work of adhesion of the edge over its glassy value") \
  X(EDGE_ZONE, "edge_zone", "cohesive zone of the moving edge over the contact radius") \
  X(RELAXED, "relaxed", "way of the edge in the mean retardation time over the contact radius") \
  X(FLATTENED, "flattened", "relaxed contact radius over that of the attraction of the flattened sphere") \
  X(BEYOND, "beyond", "relaxed contact radius over that of the greatest tension")
// clang-format on

#define PO_THEORY_ENUMERATOR(key, ...) PO_THEORY_##key,
typedef enum { PO_THEORY_ROWS(PO_THEORY_ENUMERATOR) PO_THEORY_COUNT } po_theory;

#define PO_ASSUMPTION_ENUMERATOR(key, ...) PO_ASSUMES_##key,
typedef enum { PO_ASSUMPTION_ROWS(PO_ASSUMPTION_ENUMERATOR) PO_ASSUMPTION_COUNT } po_assumption;

/* Theories from this one on are of viscoelastic bodies, and JKR with the relaxed modulus is, too;
 * those before it are of elastic bodies. */
enum { PO_THEORY_OF_RATE = PO_THEORY_PERSSON_BRENER };

/* Whether the assumptions of a theory hold. */
typedef enum { PO_HOLDS_UNKNOWN, PO_HOLDS_NO, PO_HOLDS_YES } po_holds;

typedef struct {
  po_theory theory;
  char source[88];
  double force;           /* pi w R; NAN: the theory cannot be evaluated */
  double deviation;       /* of the force from the computed one, relative; NAN: one is unknown */
  double deviation_error; /* bound of its error by that of the computed force; NAN: unknown */
  po_holds holds;
  po_assumption decided_by; /* the first assumption that does not hold, otherwise the first one */
  double number;            /* of that assumption; NAN: unknown */
  bool at_least;            /* whether `limit` is the least value; otherwise the greatest */
  double limit;
  char reason[256]; /* why it cannot be evaluated; "" */
} po_theory_row;

/* A theory of the parabola alone. */
typedef struct {
  po_theory theory;
} po_parabola_theory;

/* The name, "kesari-lew", the words, "Kesari-Lew", and the source of each theory; the words of each
 * number. */
typedef struct {
  const char *name, *words, *source;
} po_theory_text;
extern const po_theory_text PO_THEORIES[PO_THEORY_COUNT];
extern const char *const PO_ASSUMPTIONS[PO_ASSUMPTION_COUNT];

/* The names of all theories as a list for messages. */
extern const char *const PO_THEORY_NAMES;

#endif
