/* The traction–separation law between two half-spaces: the traction as a function of the gap.
 *
 * Lengths are in units of epsilon, the length of the law, tractions in w/epsilon with the work of
 * adhesion w. H = h/epsilon - 1 for laws that are singular at contact, and H = 0 is the equilibrium
 * distance of every law: p(0) = 0, and the integral of -p over H from 0 to infinity is 1. The law
 * of the paper, Eq 9, is the Mie law (3, 9). One file implements one law (po_law_kind);
 * doc/extending.md says how to add one. */
#ifndef PO_LAW_H
#define PO_LAW_H

#include <stdbool.h>
#include <stddef.h>

#include "po_dd.h"
#include "po_status.h"

// clang-format off
/* The laws, each with the text that chooses it, and the parameters of all laws with their names,
 * which begin with that of their law. A new law is a row in the first list, its parameters in the
 * order of the text in the second, and a file (po_law_kind.h); doc/extending.md says the rest. */
#define PO_LAW_ROWS(X) \
  X(LENNARD_JONES, "lennard-jones") \
  X(MIE, "mie:m,n") \
  X(MORSE, "morse:a")
#define PO_LAW_PARAMETER_ROWS(X) \
  X(MIE_M, "mie_m") \
  X(MIE_N, "mie_n") \
  X(MORSE_A, "morse_a")
// clang-format on

#define PO_LAW_PARAMETER(parameter, name) PO_##parameter,
typedef enum { PO_LAW_PARAMETER_ROWS(PO_LAW_PARAMETER) PO_LAW_PARAMETER_COUNT } po_law_parameter;

/* "lennard-jones or mie:m,n or ..." */
#define PO_OR_LAW(law, text) " or " text
#define PO_LAW_EXPECTED &(PO_LAW_ROWS(PO_OR_LAW))[sizeof " or " - 1]

typedef struct po_law_kind po_law_kind;

/* The numbers of a law; gaps in eps. */
typedef struct {
  double peak_gap; /* of the greatest tension; for Lennard-Jones 3^(1/6) - 1 (after Eq 9). It
                      defines the edge of a contact */
  double closest; /* the gap that no state reaches: that at which the law is singular; for the Morse
                     law, which is not, an overlap at which its repulsion is beyond any pressure of
                     a contact */
  double least;   /* at which the law is evaluated: a closer gap can only be an error of a
                     prediction */
  double reach;   /* the initial gap from which on the interaction is that of the far field, which
                     one panel to infinity carries */
  /* The far field: the traction tends to -factor * (1 + H)^-exponent. Exponent INFINITY: it falls
   * exponentially, and beyond the reach there is none. */
  double factor, exponent;
} po_law_numbers;

/* A law with its parameters. One of which nothing is set is that of the paper. */
typedef struct {
  const po_law_kind *kind;
  double parameter[PO_LAW_PARAMETER_COUNT]; /* those of other laws are not looked at */
  double constant;                          /* what its kind derives from the parameters */
  po_law_numbers numbers;                   /* derived, too; read by po_law_numbers_of */
} po_law;

typedef struct {
  double traction; /* p = P / mu, P of Eq 16; > 0 compressive */
  double slope;    /* dp/dH */
} po_law_value;

/* The length over which a law changes at a gap, eps, and its rate dsize/dH. */
typedef struct {
  double size, rate;
} po_law_scale;

/* Lennard-Jones, Eq 9; the parameters of the other laws are NAN. */
po_law po_law_lennard_jones(void);

/* Sets the law written by its name alone, or with its parameters in order, as "mie:4,10" or
 * "mie:4;10"; without them those in place stay. False when the text is none of these; then the law
 * is unchanged. Its parameters are checked by po_law_check. */
bool po_law_set(po_law *law, const char *text);

/* Sets one parameter. */
void po_law_set_parameter(po_law *law, po_law_parameter parameter, double value);

/* The name of a law; its number among all laws; whether it has a parameter. */
const char *po_law_name(const po_law *law);
size_t po_law_index(const po_law *law);
bool po_law_has(const po_law *law, po_law_parameter parameter);

/* PO_BAD_INPUT, naming the parameter that is out of range, its value and what is expected. */
po_status po_law_check(const po_law *law);

/* Traction and slope at gap H, above the closest one. */
po_law_value po_law_at(const po_law *law, double gap);

/* The traction in twice the precision. */
po_dd po_law_traction(const po_law *law, double gap);

/* The law averaged over one period of a waviness about the mean gap: the mean over phi of the law
 * at H - A cos(phi), for A < H - closest. Accuracy: 1e-13 relative
 * (tests/unit/test_scene.c). */
po_law_value po_law_averaged(const po_law *law, double gap, double amplitude);

/* The interaction energy per area, phi / w with dphi/dH = -p and phi = 0 at infinity; and the same
 * averaged over one period of a waviness. */
double po_law_energy(const po_law *law, double gap);
double po_law_energy_averaged(const po_law *law, double gap, double amplitude);

/* The length in which changes of a gap are measured, by Newton's method, steps and the arclength
 * functional: positive, growing as the gap far out; the distance from the singularity where there
 * is one. For Lennard-Jones 1 + H. */
po_law_scale po_law_scale_at(const po_law *law, double gap);

/* The same, its size alone. */
double po_law_size(const po_law *law, double gap);

/* How close the surfaces are, from 1 in contact to 0 far apart: 1 up to the equilibrium distance,
 * |phi/w|^g beyond, phi the energy. The exponent g makes it fall as the slope of the law does at
 * large gaps: g = (m + 1)/(m - 1) if the traction falls as (1 + H)^-m, g = 1 if it falls
 * exponentially. Value and rate are continuous at the equilibrium distance, where phi' = 0. Used by
 * the depth of the necks (po_arclength.h). */
typedef struct {
  double value, rate; /* rate: d(value)/dH */
} po_law_closeness;
po_law_closeness po_law_closeness_at(const po_law *law, double gap);

/* Returned: the numbers of a law; of one of which nothing is set, those of the law of the paper.
 * They belong to the law, and are valid until it is set again. */
const po_law_numbers *po_law_numbers_of(const po_law *law);

/* The greater of a predicted gap and the least one at which the law is evaluated. */
double po_law_expected_gap(const po_law *law, double gap);

/* An approach at which the repulsion pushes a rigid body, which is a paraboloid of `share` times
 * the radius R near its axis, with a load, in pi w R. */
double po_law_approach_of_push(const po_law *law, double share, double load);

#endif
