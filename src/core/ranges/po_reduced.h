/* A solve with a greater range of the attraction, for contact edges that are very narrow: the same
 * bodies, work of adhesion and preload with several greater equilibrium distances, and the limit of
 * their pull-off force, loops and staircases at the true one (doc/method.md, "A greater range").
 *
 * The width of a contact edge is about eps/c, c the coupling. Where the waves, and the contact, are
 * much wider, the range enters results only through a small correction: with a range s times as
 * great the force is F(s) = F0 + s^2 (a + b ln s) + s^3 (c + d ln s) + ... */
#ifndef PO_REDUCED_H
#define PO_REDUCED_H

#include "po_request.h"
#include "po_result.h"
#include "po_trace.h"

/* The width of a contact edge, eps/c, over the shortest wavelength, or over Gamma (Eq 14) if the
 * sphere is smooth. */
double po_reduced_width(const po_scene *scene);

/* The greatest such width with which several ranges are between it and the widest edges. */
extern const double PO_REDUCED_MOST_WIDTH;

/* Returned: whether the pull-off of a request can be found so: its contact edges are narrow, and it
 * is a sphere under a law that falls with the third power, and nothing but the pull-off, the loops,
 * the staircases and the theories are wanted. */
bool po_reduced_applies(const po_request *request);

/* Returned: whether it is found so in place of a solve with the true range. */
bool po_reduced_is_chosen(const po_request *request);

/* Returned: whether it may be found so after a solve with the true range has failed. */
bool po_reduced_is_resort(const po_request *request, po_status status);

/* The narrowest request that is solved, of which the size of the solve is estimated. */
po_request po_reduced_narrowest(const po_request *request);

/* Solves one request; as po_solve, without theories, and keeps points of its trace. */
typedef po_status po_reduced_solver(const po_request *request, po_kept_points *kept,
                                    po_result *result);

/* Traces with two ranges and follows what matters to smaller ones until the error of the
 * extrapolated force is within the tolerance. Given: a request to which it applies; a function that
 * traces one scene. Returned: the result in the units of the request, with special points of which
 * the limit is known; it must be cleared whatever the status. Status: PO_NOT_CONVERGED with the
 * reason if the error stays above ten times the tolerance, or if it is not known on which stretch
 * loading is reversed; if no two traces agree, that of the last. */
po_status po_reduced_solve(const po_request *request, po_reduced_solver *solve, po_result *result);

#endif
