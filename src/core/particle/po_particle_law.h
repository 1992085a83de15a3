/* The law of contact of two particles, for codes that move particles: force against overlap as
 * piecewise cubics, of the contact that loading makes and of the surfaces before it, with the jumps
 * between both.
 *
 * A contact is either out (the surfaces have not jumped into contact) or in. It goes in where the
 * overlap exceeds that of the jump into contact, and out where it falls below that of the jump out
 * of contact; the difference of the two forces between is the energy that a cycle loses. This is
 * exact at given overlap if loading and unloading each jump once: the stable equilibria of the
 * branch are then two stretches, each a function of the overlap. A scene with more jumps is
 * refused.
 *
 * What one table serves. Lengths along the axis are in epsilon, forces in pi w R, radii in sqrt(R
 * epsilon). In these units the equations of a sphere on the unbounded half-space depend on the
 * Tabor parameter mu alone: the gap r^2/(2R) and the elastic kernel, which is homogeneous of degree
 * -1, keep their form if r is measured in sqrt(R epsilon), and the elastic deflection is
 * mu^(3/2) times a function of the traction. A wave keeps its form if A/epsilon and L^2/(R epsilon)
 * are the same, and a cut surface if r_max^2/(R epsilon) is. The overlap is 0 where undeformed
 * surfaces would be at their equilibrium distance. */
#ifndef PO_PARTICLE_LAW_H
#define PO_PARTICLE_LAW_H

#include <stdbool.h>
#include <stddef.h>

#include "po_request.h"
#include "po_result.h"

/* Between two knots force and contact radius are cubics with these values and derivatives. */
typedef struct {
  double overlap;      /* eps */
  double force;        /* pi w R, repulsive > 0 */
  double stiffness;    /* derivative of the force, pi w R/eps */
  double radius;       /* of the contact, sqrt(R eps) */
  double radius_slope; /* derivative of the radius, sqrt(R eps)/eps */
} po_particle_knot;

typedef struct {
  po_particle_knot *knot; /* overlap ascending; owned */
  size_t count;
} po_particle_stretch;

/* What characterises a law, in the same units. */
typedef struct {
  bool jumps;                        /* whether there are jumps; without, the next two are NAN */
  double jump_in, jump_out;          /* overlaps */
  double pull_off, pull_off_overlap; /* greatest attraction in unloading, > 0, and where */
  double energy_lost, energy_lost_error; /* in a cycle through both jumps, pi w R eps; bound of its
                                            error by the solver */
} po_particle_numbers;

typedef struct {
  po_particle_numbers numbers;
  po_particle_stretch out, in; /* without jumps all is in */
  double error;                /* greatest difference of the force from the curve, over pull_off */
  double radius_error; /* the same of the radius, sqrt(R eps); between points of the curve that is a
                          monotone spline */
  double table_lost;   /* energy lost by the cubics */
  /* Beyond the last knot the force is f + hertz ((d - d_0)^(3/2) - (d_last - d_0)^(3/2)), with f
   * and the derivative of the last knot: a sphere is continued by Hertz, 4/3 E* sqrt(R). With hertz
   * = 0 it is continued by its last stiffness. */
  double hertz, hertz_origin; /* 4/(3 pi mu^(3/2)), and d_0 */
} po_particle_law;

/* The least and the greatest error that may be asked for, over the pull-off force. */
#define PO_LEAST_LAW_ERROR 1e-6
#define PO_GREATEST_LAW_ERROR 1e-2

/* The load up to which the law of a sphere is tabulated unless a preload is given, pi w R: in JKR
 * theory, Hertz beyond it has then an error of at most 5.1e-4 of the force. */
extern const double PO_LAW_PRELOAD;

/* Makes the law of a scene, up to the preload of the request. Given: a request that was checked;
 * the greatest error of the force, over the pull-off force. Far out the table begins where the
 * attraction is as small as that. Status: PO_BAD_INPUT if the law needs more than two states, with
 * the reason; otherwise as po_solve, with the reason in the message. */
po_status po_particle_law_make(const po_request *request, double error, po_particle_law *law);

/* Solves a scene for the numbers of its law alone. Status: as before. */
po_status po_particle_law_numbers(const po_request *request, po_particle_numbers *numbers);

/* The force of a law, from its first knot on; and its integral over the overlap between two
 * overlaps of a stretch, pi w R eps. */
double po_particle_law_force(const po_particle_law *law, const po_particle_stretch *stretch,
                             double overlap);
double po_particle_law_work(const po_particle_stretch *stretch, double from, double to);

void po_particle_law_clear(po_particle_law *law);

#endif
