/* Private to the files po_reduced*.c: the ranges of the attraction that are solved, the special
 * points that are followed from one to the next, and their limit. */
#ifndef PO_REDUCED_INTERNAL_H
#define PO_REDUCED_INTERNAL_H

#include <stddef.h>

#include "po_estimate.h"
#include "po_reduced.h"

/* The ranges, in units of the true one; each is 1/sqrt(2) of the one before, with which the width
 * of the contact edges is halved, but for the last, which is the true one if there is room. */
enum { PO_MOST_RANGES = 40 };
typedef struct {
  const po_request *request; /* with the true range */
  double range[PO_MOST_RANGES];
  int count; /* of those that are traced, and from which limits are found */
  int all;   /* of those to which a jump of loading is followed */
} po_ranges;

/* From a range to the true one a number changes by at most this multiple of its last change, or of
 * what a power law says: by the next range the error of a limit falls to 0.6 or less (a scene of an
 * independent campaign has 0.502), and so does the change of the force of a minimum, which is 1/3
 * by its expansion. */
static const double PO_CHANGES_ON = 1.5;

/* Ranges from a trace to the next one: each has half the range of the one before. */
enum { PO_RANGE_STRIDE = 2 };

/* Part of the tolerance at which an extrapolated number is accurate enough. */
static const double PO_RANGE_ENOUGH = 0.5;

po_ranges po_ranges_of(const po_request *request);

/* The request with one of the ranges: every length in units of eps is so much smaller, and so is
 * the Tabor parameter; loads in pi w R are the same. */
po_request po_reduced_request(const po_request *request, double range);

/* The tolerance of these requests. */
double po_reduced_tolerance(const po_request *request);

/* Whether a status ends the solve: another range does not help. */
bool po_reduced_ends(po_status status);

/* -- Special points that are followed (po_reduced_follow.c) -- */

/* A trace with one of the ranges, of PO_KEEP_LOADING. */
typedef struct {
  int at; /* index of the range */
  po_kept_points kept;
  po_result result; /* lengths in the unit of the range */
} po_range_trace;

/* A special point at the ranges first to last, in the unit of each; of a minimum of the load also
 * the sensitivity of the load and the part of the contact radius that is a full disc. */
typedef struct {
  int first, last;
  po_estimate at[PO_MOST_RANGES];
  po_sensitivity sensitivity[PO_MOST_RANGES];
  bool has_sensitivity[PO_MOST_RANGES];
} po_range_track;

typedef struct po_range_course po_range_course;

/* Given: a successful trace, which must outlive the course. Status: PO_NO_MEMORY. */
po_status po_range_course_create(const po_ranges *ranges, const po_range_trace *trace,
                                 po_range_course **course);

/* Frees the course and adds its work. */
void po_range_course_destroy(po_range_course *course, po_work *work);

/* Begins at a special point of the trace. Returned: its track, at the range of the trace. */
po_status po_range_course_begin(po_range_course *course, const po_kept_point *point,
                                po_range_track *track);

/* Begins there again, to follow the point to greater ranges. */
po_status po_range_course_again(po_range_course *course, const po_kept_point *point);

/* Follows the point of the last begin to the neighbouring smaller or greater range, and adds that
 * to the track. Status: PO_NOT_FOUND if the special point ends before; as po_follow_to. */
po_status po_range_course_next(po_range_course *course, bool smaller, po_range_track *track);

/* What is followed from a trace. */
typedef struct {
  const po_ranges *ranges;
  const po_range_trace *trace;
  po_range_course *course;
  po_range_track *track; /* work */
} po_range_follower;

/* Where loading is reversed at the true range (po_reduced_loading.c). Returned: *known, whether
 * that is known; *before, the first jump of the trace that is not made; NULL: all are made. */
po_status po_range_find_reversal(const po_range_follower *f, bool *known,
                                 const po_kept_point **before);

/* -- Limits at the true range (po_reduced_limit.c) -- */

/* Terms of F(s), found from as many ranges; and one range more, for the error. */
enum { PO_RANGE_TERMS = 5, PO_RANGES_OF_LIMIT = PO_RANGE_TERMS + 1 };

/* On what a number depends: on contact edges, and changes as F(s) in po_reduced.h; on a crest that
 * jumps into contact, and changes with powers of s^(4/7). */
typedef enum { PO_BY_EDGES, PO_BY_CRESTS } po_range_terms;

typedef struct {
  /* Weights of the values: of all terms by the last ranges, by those before, and with one term
   * less. */
  double weight[PO_RANGES_OF_LIMIT], before[PO_RANGES_OF_LIMIT], fewer[PO_RANGES_OF_LIMIT];
  po_range_terms terms;
} po_range_limit;

/* Given: the ranges, decreasing. */
po_range_limit po_range_limit_of(po_range_terms terms, const double range[PO_RANGES_OF_LIMIT]);

/* Returned: the limit of values, and a bound of its error. Given: values and their errors. */
double po_range_limit_at(const po_range_limit *limit, const double value[PO_RANGES_OF_LIMIT],
                         const double error[PO_RANGES_OF_LIMIT], double *bound);

/* The tracks of the special points that are stated; NULL: there is none, or it ends before the last
 * range. */
typedef struct {
  const po_range_track *pull_off, *any; /* any: the greatest pull-off, if it is another */
  const po_range_track *begin;          /* the fold at which the stretch of the pull-off begins */
  const po_range_track *jump, *crest;   /* the last jump of loading before the preload, and the
                                           maximum of the load before it */
} po_range_points;

/* Replaces pull-off and special points of a result, in units of the true range, by their limits.
 * Given: the tracks; the index of the last of the ranges. */
po_status po_range_limit_take(const po_ranges *ranges, const po_range_points *points, int last,
                              po_result *result);

/* Whether a number that changes with the power 4/7 of the range is above or below a bound for
 * certain at the true range: 1, -1; 0: it is not known. Given: its values at the ranges first to
 * last. */
int po_range_side_of(const po_ranges *ranges, int first, int last, const double value[],
                     double bound);

/* The same struct of the results with the last ranges, in units of the true range. */
typedef struct {
  const po_request *request;
  const char *at[PO_RANGES_OF_LIMIT];
} po_range_group;

/* The limit of a double of these structs at an offset. Given: the offset of its error;
 * PO_RANGE_NO_ERROR: it is of the order of the tolerance. Returned: also *bound. A number that is
 * not finite at one of the ranges is that of the last one, with the bound 0. */
enum { PO_RANGE_NO_ERROR = 0 };
double po_range_limit_of_number(const po_range_group *g, const po_range_limit *limit, size_t offset,
                                size_t error_offset, double *bound);

/* The limit of a po_path_state of these structs at an offset, and in *error bounds of the errors of
 * approach and load, *energy that of its energy. Where these are of a crest, and fall to less than
 * half from the last range to the limit, the change is the least bound: the power is another one
 * where the gap, across which the crest jumps, becomes less than the height of the waves. */
po_path_state po_range_limit_of_state(const po_range_group *g, const po_range_limit *limit,
                                      size_t offset, po_path_error *error, double *energy);

/* -- Several solves for what a trace leads to (po_reduced_solves.c) -- */

/* The last solves, each range half of the one before, in units of the true range; and the limits
 * by them. */
typedef struct {
  const po_request *request;
  double range[PO_RANGES_OF_LIMIT];
  po_result solved[PO_RANGES_OF_LIMIT];
  int count;
  po_range_limit edges, crests;
} po_range_solves;

/* Given: PO_RANGES_OF_LIMIT solves and their limits. Returned: whether what is wanted is known;
 * *excess: its greatest error over the tolerance times the number; INFINITY: another range is
 * needed whatever the error is. */
typedef bool po_range_judge(const po_range_solves *s, double *excess);

/* Solves with smaller and smaller ranges for one of the additional results, PO_WANT_*, until it is
 * known with a small error, or no smaller range is solved; adds the work. Returned: *known. The
 * solves have to be cleared. */
po_status po_range_solves_make(const po_ranges *ranges, unsigned want, po_range_judge *judge,
                               po_reduced_solver *solve, po_range_solves *s, po_work *work,
                               bool *known);
void po_range_solves_clear(po_range_solves *s);

/* Solves for the loops, until the error of the energy lost at given approach is within the
 * tolerance, and adds them to a result, and the work. Given: the ranges; a result with the
 * pull-off. Status: PO_NOT_CONVERGED if the last six do not have the same jumps
 * (po_reduced_loops.c). */
po_status po_reduced_loops(const po_ranges *ranges, po_reduced_solver *solve, po_result *result);

/* The same for the staircases, of which the steps of the hardest preloads are stated, as many as
 * all ranges have. Status: PO_NOT_CONVERGED if they do not have the same last step
 * (po_reduced_staircases.c). */
po_status po_reduced_staircases(const po_ranges *ranges, po_reduced_solver *solve,
                                po_result *result);

#endif
