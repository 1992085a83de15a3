/* The scene: the dimensionless description of what is pressed together, and the groups of the paper
 * (Eq 6, Eq 14, Eq 17). A scene is a profile with waves, a traction-separation law, one elastic
 * number and a domain.
 *
 * The elastic number is the coupling c = w/(E* epsilon). A scene holds it as the Tabor parameter mu
 * of a sphere of radius R, c = mu^(3/2)/sqrt(R/epsilon). R is the radius of the sphere; for every
 * other profile it is a length of reference: loads are in pi w R, and with R = epsilon they are in
 * pi w epsilon.
 *
 * All lengths of a scene, and all radii in the solver, are in units of the equilibrium distance
 * epsilon. The radial unit of the paper is Gamma = (R^2 w/E*)^(1/3), Eq 14, with Gamma/epsilon =
 * sqrt(R mu). */
#ifndef PO_SCENE_H
#define PO_SCENE_H

#include <stdbool.h>

#include "po_law.h"
#include "po_profile.h"
#include "po_status.h"

/* A wave of the initial gap, A (1 - cos(2 pi r/length)). */
typedef struct {
  double amplitude, length; /* eps */
} po_wave;

enum { PO_MOST_WAVES = 8 };

typedef struct {
  double tabor;        /* mu = (R w^2/(E*^2 eps^3))^(1/3), text after Eq 15; 0: rigid */
  double amplitude;    /* A/eps of the first wave; 0: smooth */
  double wavelength;   /* lambda/eps of the first wave; ignored when smooth */
  double radius;       /* R / eps */
  double outer_radius; /* r_max/eps, where the half-space ends; INFINITY: unbounded */
  po_law law;          /* Lennard-Jones unless it is set */
  po_profile profile;  /* the sphere unless it is set */
  double load_unit; /* inside a solve, pi w R of this scene in that of the scene asked for; 0: 1 */
  double length_unit; /* the same of eps: of a greater range of the attraction */
  size_t more_waves;  /* number of further waves */
  po_wave more[PO_MOST_WAVES - 1];
} po_scene;

/* The default scene: a smooth sphere with Tabor parameter 1 and R = 100 eps on the unbounded
 * half-space. */
po_scene po_scene_default(void);

/* Checks a scene. Status: PO_BAD_INPUT, naming the first key that is not finite or out of range,
 * its value and the expected range. */
po_status po_scene_check(const po_scene *scene);

/* Returned: whether there are waves: whether the amplitude is above 0. */
bool po_scene_is_wavy(const po_scene *scene);

/* The number of waves, and one of them; the first is that of amplitude and wavelength. */
size_t po_scene_waves(const po_scene *scene);
po_wave po_scene_wave(const po_scene *scene, size_t k);

/* Sets the waves written as "A@L;A@L;..."; "-" for none. False when the text is not that, or has
 * more than PO_MOST_WAVES waves; then the scene is unchanged. */
bool po_scene_set_waves(po_scene *scene, const char *text);

/* Adds a wave to those of the scene. False if there are PO_MOST_WAVES. */
bool po_scene_add_wave(po_scene *scene, po_wave wave);

/* Returned: whether the load has one minimum by JKR theory: there are no waves, and the profile is
 * convex. */
bool po_scene_is_simple(const po_scene *scene);

/* Returned: whether the scene is one that the paper, and the closed forms for it, describe: a
 * sphere with one wave or none. */
bool po_scene_is_of_paper(const po_scene *scene);

/* Whether the energy of the interaction far out, in proportion to the integral of r^(N(1-m)) r dr
 * with the powers m of the law and N of the profile, is infinite, or so large that N is not known
 * well enough for it. Energies are then relative to that of the initial gap at approach 0, far out.
 */
bool po_scene_has_infinite_energy(const po_scene *scene);

/* The power with which the traction of an unbounded surface falls far out: the exponent of the law
 * times the power by which the profile grows. INFINITY if nothing acts beyond the reach: the law
 * falls exponentially, or the power is too large for a panel to infinity. */
double po_scene_decay(const po_scene *scene);

/* The initial gap, eps, from which on the interaction is that of the far field. */
double po_scene_reach(const po_scene *scene);

/* The factors of a load and of a length in messages, see po_load_unit.h and po_reduced.h. */
double po_scene_load_unit(const po_scene *scene);
double po_scene_length_unit(const po_scene *scene);

/* The coupling c = w/(E* eps) = mu^(3/2)/sqrt(R/eps). */
double po_scene_coupling(const po_scene *scene);

/* The Tabor parameter of a coupling >= 0 and a radius. */
double po_scene_tabor_of_coupling(double coupling, double radius);

/* Gamma / epsilon = sqrt(R mu), Eq 14. */
double po_scene_gamma(const po_scene *scene);

/* Returned: E* eps/w = sqrt(R/mu^3), R in eps, the form in which the Tabor parameter enters the JKR
 * theory (beta of Eq 6 and the Johnson parameter after Eq 4). */
double po_scene_stiffness(const po_scene *scene);

/* Returned: alpha = A R/lambda^2, Eq 6; 0 for a smooth sphere. */
double po_scene_alpha(const po_scene *scene);

#endif
