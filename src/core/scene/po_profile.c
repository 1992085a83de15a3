#include "po_profile.h"

#include <math.h>
#include <string.h>

#include "po_elementary.h"
#include "po_parameters.h"
#include "po_profile_kind.h"
#include "po_profile_table.h"

#define KIND(profile, text) &PO_##profile,
static const po_profile_kind *const KINDS[] = {PO_PROFILE_ROWS(KIND) KIND(TABLE, "")};
enum { KIND_COUNT = sizeof KINDS / sizeof *KINDS };

#define NAME(parameter, name, is_length) name,
static const char *const PARAMETERS[] = {PO_PROFILE_PARAMETER_ROWS(NAME)};
#define IS_LENGTH(parameter, name, is_length) is_length,
static const bool LENGTHS[] = {PO_PROFILE_PARAMETER_ROWS(IS_LENGTH)};

static const po_profile_kind *kind_of(const po_profile *profile) {
  return profile->kind ? profile->kind : &PO_SPHERE;
}

po_profile po_profile_sphere(void) {
  po_profile profile = {.kind = &PO_SPHERE};
  for (size_t k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    profile.parameter[k] = NAN;
  return profile;
}

bool po_profile_set(po_profile *profile, const char *text) {
  const char *rest;
  for (size_t k = 0; k < KIND_COUNT; ++k) {
    const po_profile_kind *kind = KINDS[k];
    if (kind == &PO_TABLE || !po_parameters_follow(text, kind->name, &rest))
      continue;
    po_profile read = *profile;
    read.kind = kind;
    read.table = NULL;
    if (rest && (!kind->parameters ||
                 !po_parameters_read(rest, kind->parameters, read.parameter + kind->first)))
      return false;
    *profile = read;
    return true;
  }
  return false;
}

po_status po_profile_set_file(po_profile *profile, const char *path) {
  if (strlen(path) > PO_PROFILE_PATH_LENGTH)
    return po_fail(PO_BAD_INPUT, "the path of a profile has %zu bytes: expected at most %d",
                   strlen(path), PO_PROFILE_PATH_LENGTH);
  const po_profile_table *table;
  const double given = profile->parameter[PO_TABLE_SCALE], scale = isnan(given) ? 1.0 : given;
  const po_status status =
      po_profile_table_read(path, scale, profile->parameter[PO_TABLE_SMOOTH], &table);
  if (status)
    return status;
  profile->kind = &PO_TABLE;
  profile->table = table;
  profile->shown = NULL;
  profile->parameter[PO_TABLE_SCALE] = scale;
  return PO_OK;
}

po_status po_profile_use_file(po_profile *profile, const char *path) {
  po_profile read = *profile;
  const po_status status = po_profile_set_file(&read, path);
  if (status)
    return status;
  if (read.table->in_metres && read.parameter[PO_TABLE_SCALE] == 1.0)
    return po_fail(PO_CANNOT_READ,
                   "%s: the names of the columns have units of length, and lengths of this scene "
                   "are in epsilon: expected a scene in SI units (--from-physical, "
                   "scene.physical), or columns r and gap without units",
                   path);
  *profile = read;
  return PO_OK;
}

const char *po_profile_name(const po_profile *profile) {
  return kind_of(profile)->name;
}

size_t po_profile_index(const po_profile *profile) {
  size_t index = 0;
  while (KINDS[index] != kind_of(profile))
    ++index;
  return index;
}

bool po_profile_has(const po_profile *profile, po_profile_parameter parameter) {
  const po_profile_kind *kind = kind_of(profile);
  return parameter >= kind->first && parameter < kind->first + kind->parameters;
}

const char *po_profile_file(const po_profile *profile) {
  return profile->table ? profile->table->path : "-";
}

const char *po_profile_shown(const po_profile *profile) {
  return profile->shown ? profile->shown : po_profile_file(profile);
}

const char *po_profile_digest(const po_profile *profile) {
  return profile->table ? profile->table->digest : "-";
}

po_status po_profile_check(const po_profile *profile) {
  const po_profile_kind *kind = kind_of(profile);
  if (kind->check)
    return kind->check(profile);
  po_status status = PO_OK;
  for (size_t k = 0; k < kind->parameters && !status; ++k)
    status = po_profile_require_positive(profile, (po_profile_parameter)(kind->first + k));
  return status;
}

bool po_profile_is_sphere(const po_profile *profile) {
  return kind_of(profile) == &PO_SPHERE;
}

bool po_profile_is_table(const po_profile *profile) {
  return kind_of(profile) == &PO_TABLE;
}

double po_profile_default_radius(const po_profile *profile) {
  return po_profile_is_sphere(profile) ? 100.0 : 1.0;
}

void po_profile_rescale(po_profile *profile, double epsilon) {
  double *p = profile->parameter;
  p[PO_POWER_C] *= po_pow(epsilon, p[PO_POWER_N] - 1.0);
  if (isnan(p[PO_TABLE_SCALE]))
    p[PO_TABLE_SCALE] = 1.0;
  for (int k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    if (LENGTHS[k])
      p[k] /= epsilon;
}

const double PO_PROFILE_FARTHEST = 1e150;

double po_profile_gap(const po_profile *profile, double radius, double r) {
  const po_profile_kind *kind = kind_of(profile);
  const double gap = kind->over_radius ? kind->gap(profile, r) / radius : kind->gap(profile, r);
  return gap < PO_PROFILE_FARTHEST ? gap : PO_PROFILE_FARTHEST;
}

double po_profile_slope(const po_profile *profile, double radius, double r) {
  const po_profile_kind *kind = kind_of(profile);
  return kind->over_radius ? kind->slope(profile, r) / radius : kind->slope(profile, r);
}

po_dd po_profile_gap_exact(const po_profile *profile, double radius, double r) {
  const po_profile_kind *kind = kind_of(profile);
  if (!(po_profile_gap(profile, radius, r) < PO_PROFILE_FARTHEST))
    return po_dd_of(PO_PROFILE_FARTHEST);
  const po_dd gap = kind->gap_exact(profile, r);
  return kind->over_radius ? po_dd_divide(gap, po_dd_of(radius)) : gap;
}

double po_profile_gap_beyond(const po_profile *profile, double radius, double r) {
  const po_profile_kind *kind = kind_of(profile);
  return kind->gap_beyond ? kind->gap_beyond(profile, r) : po_profile_gap(profile, radius, r);
}

double po_profile_radius_of_gap(const po_profile *profile, double radius, double gap) {
  const po_profile_kind *kind = kind_of(profile);
  return kind->radius_of_gap(profile, kind->over_radius ? gap * radius : gap);
}

po_shape po_profile_shape(const po_profile *profile) {
  po_shape shape = {
      .kink = (double)NAN, .growth = 2.0, .end = INFINITY, .detail = INFINITY, .is_convex = true};
  if (kind_of(profile)->shape)
    kind_of(profile)->shape(profile, &shape);
  return shape;
}

/* Difference of two slopes, relative to one farther out, that is due to rounding. */
static const double ROUNDING = 1e-9;

double po_profile_slope_jump(const po_profile *profile, double radius) {
  const double kink = po_profile_shape(profile).kink;
  if (isnan(kink))
    return 0.0;
  const double jump = po_profile_slope(profile, radius, nextafter(kink, INFINITY)) -
                      po_profile_slope(profile, radius, nextafter(kink, 0.0));
  const double beyond = po_profile_slope(profile, radius, 2.0 * kink);
  return fabs(jump) > ROUNDING * fabs(beyond) ? jump : 0.0;
}

/* Part of an interval beside its ends within which a kink is at the end. */
static const double AT_END = 1e-9;

bool po_profile_has_kink_between(const po_profile *profile, double begin, double end) {
  const double kink = po_profile_shape(profile).kink, beside = AT_END * (end - begin);
  return kink > begin + beside && kink < end - beside;
}

double po_profile_next_joint(const po_profile *profile, double r) {
  if (kind_of(profile)->next_joint)
    return kind_of(profile)->next_joint(profile, r);
  const double kink = po_profile_shape(profile).kink;
  return kink > r ? kink : INFINITY;
}

po_status po_profile_require_positive(const po_profile *profile, po_profile_parameter parameter) {
  const double value = profile->parameter[parameter];
  if (isnan(value))
    return po_fail(PO_BAD_INPUT, "%s is not given: the profile %s needs it", PARAMETERS[parameter],
                   po_profile_name(profile));
  return isfinite(value) && value > 0.0
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "%s is %g: expected a finite number > 0",
                       PARAMETERS[parameter], value);
}
