/* A curve of equilibria: points from far separation to compression, with interpolation between
 * them. It may be a traced branch or a closed form. And its stable parts, at given approach
 * (displacement control) or at given load (load control), with the equilibria at which jumps end
 * (po_loop.h gives the reason). */
#ifndef PO_PATH_H
#define PO_PATH_H

#include <stdbool.h>
#include <stddef.h>

#include "po_result.h"
#include "po_status.h"

/* The folds and the extrema of the load must be points, so that approach and load are monotonic
 * between neighbouring points. `position` increases along the curve: arclength, or another
 * parameter. The number of unstable modes is that of the equilibria just after the point, at fixed
 * approach; the members of the spring are not used. */
typedef struct {
  const po_curve_point *point;
  size_t count;
  double miss; /* bound of its distance from the cubics between its points, in approach and load; 0:
                  it is not known, and the estimates of that distance are not used */
} po_path;

/* A place on a curve: the fraction (0 to 1) of the segment from point `index` to the next point. */
typedef struct {
  size_t index;
  double fraction;
} po_path_place;

/* Returned: whether an approach is the requested one, or at least the requested one, up to 1e-9
 * eps. A trace meets a requested approach to 1e-12 eps. */
bool po_path_is_at(double approach, double asked);
bool po_path_reaches(double approach, double asked);

/* Returned: the interpolated equilibrium at a place: approach, load and energy by cubic Hermite
 * interpolation over the position with the derivatives at both points, the contact radius linearly.
 * The interpolation error is of the fourth order in the length of the segment. */
po_path_state po_path_at(const po_path *path, po_path_place place);

/* The derivatives of approach and load by the position at a place inside a segment. */
typedef struct {
  double approach, load;
} po_curve_rates;
po_curve_rates po_path_rates(const po_path *path, po_path_place place);

/* Returned: the doubt at a place. */
po_path_doubt po_path_doubt_at(const po_path *path, po_path_place place);

/* Returned: a state of the curve, moved along it until the held quantity has changed by `by`, which
 * is so little that approach and load change in proportion; unchanged where the held quantity
 * turns. */
po_path_state po_path_moved(const po_path *path, po_control control, po_path_state state,
                            double by);

/* Finds the place on the segment from point `index` at which the held quantity has a value between
 * those of the two points. */
po_path_place po_path_where(const po_path *path, size_t index, po_control control, double value);

/* Returned: the integral of the load over the approach between two fractions of the segment from
 * point `index`, exact for the interpolating cubics; the stored energies are not used. */
double po_path_work(const po_path *path, size_t index, double from, double to);

/* The held quantity at a point of the curve. */
double po_stable_controlled(const po_path *path, po_control control, size_t point);

/* Gives a curve further points where the position of the base has an extremum between two points:
 * a spring jumps there. Their held_miss is a bound of the error of that position by the cubics.
 * Returned: all points, to be freed with free(); NULL: there is no spring, and the curve stays.
 * Status: PO_NO_MEMORY. */
po_status po_path_add_extrema(po_path *path, po_control control, po_curve_point **point);

/* Returned: whether the segment from a point to the next is stable: there are no unstable modes at
 * fixed approach, and approach and held quantity increase. At a fixed base one more mode is
 * unstable where k + dW/d(approach) < 0: where approach and held quantity do not change alike. */
bool po_stable_is(const po_path *path, po_control control, size_t point);

/* Finds the next stable place along the curve, from point `from` upwards (by = 1) or before it
 * downwards (by = -1), at which the held quantity has a value. Returned: false if there is
 * none. */
bool po_stable_find(const po_path *path, po_control control, size_t from, int by, double value,
                    po_path_place *found);

/* Returned: the state of complete separation at a held quantity, without energy, position NAN:
 * under load control the approach is -INFINITY, otherwise the load is 0. */
po_path_state po_stable_apart(po_control control, double held);

/* Returned: the loss in one jump. Given: its ends, and the doubt where it ends. */
po_loss po_loss_of_jump(po_control control, const po_path_state *before, const po_path_state *after,
                        po_path_doubt doubt);

/* Returned: the doubt in a jump from a point of the curve to a place on it, NULL: the bodies
 * separate. A spring jumps between special points, and beyond the beginning of the curve the
 * attraction and the energy are smaller than there. */
po_path_doubt po_doubt_of_jump(const po_path *path, po_control control, size_t from,
                               const po_path_place *to);

/* Returned: the loss in the jumps of both. */
po_loss po_loss_sum(po_loss a, po_loss b);

#endif
