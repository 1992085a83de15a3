/* The profile: the initial gap of the two bodies without waves, as a function of the radius.
 *
 * Lengths are in units of epsilon. The bodies touch at one point or on a disc: f(0) = 0. The
 * profile of the paper is the sphere, r^2/(2R). One file implements one family of profiles
 * (po_profile_kind); doc/extending.md says how to add one. Waves are added by the scene
 * (po_initial_gap.h). */
#ifndef PO_PROFILE_H
#define PO_PROFILE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_dd.h"
#include "po_status.h"

// clang-format off
/* The profiles, each with the text that chooses it, but for that of a table; and the parameters of
 * all profiles, each with its name and whether it is a length. A new profile is a row in the first
 * list, its parameters in the order of the text in the second, and a file (po_profile_kind.h);
 * doc/extending.md says the rest. The radius R of the sphere is one of the scene (po_scene.h), which measures loads by it. */
#define PO_PROFILE_ROWS(X) \
  X(SPHERE, "sphere") \
  X(POWER, "power:C,n") \
  X(CONE, "cone:t") \
  X(PUNCH, "punch:b,R") \
  X(TRUNCATED, "truncated:b,R") \
  X(EXACT_SPHERE, "exact_sphere:R") \
  X(HYPERBOLOID, "hyperboloid:t,b")
#define PO_PROFILE_PARAMETER_ROWS(X) \
  X(POWER_C, "power_c", false)        /* C r^n */ \
  X(POWER_N, "power_n", false) \
  X(CONE_T, "cone_t", false)          /* t r, t the tangent of the angle between flank and flat body */ \
  X(PUNCH_B, "punch_b", true)         /* flat to b, then (r - b)^2/(2R) */ \
  X(PUNCH_R, "punch_r", true) \
  X(TRUNCATED_B, "truncated_b", true) /* flat to b, then (r^2 - b^2)/(2R): a sphere that is cut flat */ \
  X(TRUNCATED_R, "truncated_r", true) \
  X(EXACT_SPHERE_R, "exact_sphere_r", true) /* R - sqrt(R^2 - r^2) (po_profile_round.c) */ \
  X(HYPERBOLOID_T, "hyperboloid_t", false)  /* t (sqrt(r^2 + b^2) - b): a cone with a blunt tip */ \
  X(HYPERBOLOID_B, "hyperboloid_b", true) \
  X(TABLE_SCALE, "table_scale", true) /* the unit of the numbers of a table, in epsilon */ \
  X(TABLE_SMOOTH, "smooth", false)    /* standard deviation of their noise, in this unit; INFINITY: it
                                         is estimated; NAN: the spline passes through all rows */
// clang-format on

#define PO_PROFILE_PARAMETER(parameter, ...) PO_##parameter,
typedef enum {
  PO_PROFILE_PARAMETER_ROWS(PO_PROFILE_PARAMETER) PO_PROFILE_PARAMETER_COUNT
} po_profile_parameter;

/* "sphere or power:C,n or ...; a table ..." */
#define PO_OR_PROFILE(profile, text) " or " text
#define PO_PROFILE_EXPECTED                                                                        \
  &(PO_PROFILE_ROWS(PO_OR_PROFILE) "; a table of radii and gaps by profile_file")[sizeof " or " - 1]

enum { PO_PROFILE_PATH_LENGTH = 1000 };

typedef struct po_profile_kind po_profile_kind;
struct po_profile_table;

/* A profile with its parameters. One of which nothing is set is the sphere. */
typedef struct {
  const po_profile_kind *kind;
  double parameter[PO_PROFILE_PARAMETER_COUNT]; /* those of other profiles are not looked at */
  const struct po_profile_table *table;         /* of a profile read from a file */
  const char *shown; /* the name of that file in documents; NULL: its path */
} po_profile;

/* The sphere; the parameters of the other profiles are NAN. */
po_profile po_profile_sphere(void);

/* Sets the profile written by its name alone, or with its parameters in order, as "power:0.05,1.5"
 * or "power:0.05;1.5"; without them those in place stay. False when the text is none of these; then
 * the profile is unchanged. Its parameters are checked by po_profile_check. */
bool po_profile_set(po_profile *profile, const char *text);

/* Sets the profile of a table in a CSV file with the columns r and gap (po_profile_table.h), in
 * units of the parameter PO_TABLE_SCALE, which is 1 unless it was set before. Status:
 * PO_CANNOT_READ, with file and line; PO_BAD_INPUT if the path is longer than
 * PO_PROFILE_PATH_LENGTH. */
po_status po_profile_set_file(po_profile *profile, const char *path);

/* The same, for a scene. Status: PO_CANNOT_READ also if the columns of the table have units of
 * length, and the scale, 1 m in epsilon, is 1: no scene in SI units has given it. */
po_status po_profile_use_file(po_profile *profile, const char *path);

/* The name of a profile, "table" for a table; its number among all profiles;
 * whether it has a parameter. The path of a table, its name in documents, and the SHA-256 of its
 * content; "-" for other profiles. */
const char *po_profile_name(const po_profile *profile);
size_t po_profile_index(const po_profile *profile);
bool po_profile_has(const po_profile *profile, po_profile_parameter parameter);
const char *po_profile_file(const po_profile *profile);
const char *po_profile_shown(const po_profile *profile);
const char *po_profile_digest(const po_profile *profile);

/* PO_BAD_INPUT, naming the parameter that is out of range, its value and what is expected. */
po_status po_profile_check(const po_profile *profile);

bool po_profile_is_sphere(const po_profile *profile);
bool po_profile_is_table(const po_profile *profile);

/* The radius of a scene for which none is given: 100 for the sphere; for every other profile, whose
 * length of reference it is, 1. */
double po_profile_default_radius(const po_profile *profile);

/* Converts the parameters, given in another unit of length, to units of epsilon. Given: epsilon in
 * that unit. A table must be set after it. */
void po_profile_rescale(po_profile *profile, double epsilon);

/* Gaps beyond are this one, eps: nothing acts there, and a gap that overflows leaves no number. */
extern const double PO_PROFILE_FARTHEST;

/* f, df/dr, and f in twice the precision, at a radius r >= 0. Given: `radius`, R of the sphere;
 * other profiles do not look at it. */
double po_profile_gap(const po_profile *profile, double radius, double r);
double po_profile_slope(const po_profile *profile, double radius, double r);
po_dd po_profile_gap_exact(const po_profile *profile, double radius, double r);

/* The least gap at r and beyond; f(r) of a profile that rises everywhere. */
double po_profile_gap_beyond(const po_profile *profile, double radius, double r);

/* The largest radius at which f is not above a gap >= 0. */
double po_profile_radius_of_gap(const po_profile *profile, double radius, double gap);

/* The numbers of a profile. */
typedef struct {
  double kink;   /* the radius at which the slope or the curvature of f jumps; NAN: none */
  double growth; /* N, with f ~ r^N far out */
  double end;    /* the radius from which on f is not known and is continued by a power of r;
                    INFINITY but for a table */
  double detail; /* a length, in which f has at most one extremum; INFINITY if f rises everywhere */
  bool is_convex; /* by JKR theory the load of a convex profile without waves has one minimum */
} po_shape;
po_shape po_profile_shape(const po_profile *profile);

/* The smallest radius > r at which a quadrature over f should begin a new piece; INFINITY if there
 * is none: where f is not analytic, as at the end of a flat part or the next row of a table, and
 * beside a singularity. */
double po_profile_next_joint(const po_profile *profile, double r);

/* The jump of the slope at the kink; 0 if only the curvature jumps, or if there is no kink. */
double po_profile_slope_jump(const po_profile *profile, double radius);
/* Returned: whether the kink is between two radii, and at neither of them but for rounding. */
bool po_profile_has_kink_between(const po_profile *profile, double begin, double end);

#endif
