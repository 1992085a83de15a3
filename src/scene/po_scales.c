#include "po_scales.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"

/* W = 0 in Eq 7 at a contact radius of 2.42 Gamma. */
static const double CONTACT_OF_SPHERE = 2.42;

/* Points of the rules, of which some percent are asked. */
enum { ABEL_POINTS = 48, LOAD_POINTS = 200, APPROACHES = 24 };

double po_scales_abel(const po_scene *scene, double a) {
  double sum = 0.0;
  for (int k = 0; k < ABEL_POINTS; ++k) {
    const double t = (k + 0.5) / ABEL_POINTS * M_PI_2;
    sum += po_profile_slope(&scene->profile, scene->radius, a * po_sin(t));
  }
  return a * M_PI_2 / ABEL_POINTS * sum;
}

/* The load of rigid bodies, pi w R, by the midpoint rule in the square root of the radius. */
static double rigid_load(const po_scene *scene, double approach, double end) {
  double sum = 0.0;
  for (int k = 0; k < LOAD_POINTS; ++k) {
    const double x = (k + 0.5) / LOAD_POINTS, r = end * x * x;
    const double gap = po_profile_gap(&scene->profile, scene->radius, r) - approach;
    sum += po_law_at(&scene->law, gap).traction * r * 2.0 * x * end / LOAD_POINTS;
  }
  return 2.0 / scene->radius * sum;
}

static double rigid_pull_off(const po_scene *scene) {
  const double end =
      fmin(scene->outer_radius, po_initial_gap_radius(scene, po_law_reach(&scene->law)));
  const double near = -po_law_peak_gap(&scene->law), far = -0.5 * po_law_closest(&scene->law);
  double least = 0.0;
  for (int k = 0; k < APPROACHES; ++k)
    least = fmin(least, rigid_load(scene, near + (far - near) * k / (APPROACHES - 1), end));
  return -least;
}

/* JKR theory of the profile, over contact radii from a small to a large one. */
typedef struct {
  double pull_off, contact; /* pi w R, eps; contact: at zero load */
} jkr;

/* Contact radii of the search, relative to the radius at which the initial gap is the smallest and
 * the largest; and the factor between them. */
static const double SMALLEST_GAP = 1e-6, LARGEST_GAP = 1e9, NEXT_RADIUS = 1.05;

/* Given: the factor of the work of adhesion in the adhesive term. */
static jkr jkr_of(const po_scene *scene, double adhesion) {
  const double coupling = po_scene_coupling(scene);
  const double end = fmin(scene->outer_radius, po_initial_gap_radius(scene, LARGEST_GAP));
  double a = fmin(end, po_initial_gap_radius(scene, SMALLEST_GAP)), area = 0.0, before = 0.0;
  double g = po_scales_abel(scene, a);
  jkr j = {0.0, a};
  area = 0.5 * a * g;
  for (; a <= end; a *= NEXT_RADIUS) {
    before = g;
    g = po_scales_abel(scene, a);
    area += 0.5 * (g + before) * a * (1.0 - 1.0 / NEXT_RADIUS);
    const double load = 2.0 / (M_PI * scene->radius * coupling) *
                        (a * g - area - sqrt(2.0 * M_PI * coupling * adhesion * a * a * a));
    if (load < 0.0)
      j.contact = a;
    if (load < -j.pull_off)
      j.pull_off = -load;
    else if (load > j.pull_off)
      break;
  }
  return j;
}

/* The greatest factor of the work of adhesion by waves. Internal cracks limit it: in Figure 11 of
 * the paper it is about 8, at A/lambda ~ 0.1. */
static const double MOST_ADHESION = 8.0;

/* The factor by which waves may increase the work of adhesion: Eq 24, (1 + 1/(sqrt(pi)
 * alpha_KLJ))^2 with alpha_KLJ^2 = 2 coupling lambda/(pi A)^2. The oscillations that waves add to
 * the approach of JKR theory go as sqrt(a), as does the adhesive term; those of several waves add.
 */
static double adhesion_of_waves(const po_scene *scene) {
  double root = 1.0;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    root += wave.amplitude * sqrt(M_PI / (2.0 * po_scene_coupling(scene) * wave.length));
  }
  return fmin(MOST_ADHESION, root * root);
}

po_scales po_scene_scales(const po_scene *scene) {
  const double mu = scene->tabor, per_stretch = 0.5 * CONTACT_OF_SPHERE * CONTACT_OF_SPHERE;
  const bool sphere = po_profile_is_sphere(&scene->profile);
  const double rigid = sphere ? 1.0 : 0.5 * rigid_pull_off(scene);
  if (!(mu > 0.0))
    return (po_scales){.load = rigid, .load_factor = 1.0};
  const double adhesion = adhesion_of_waves(scene), root = po_cbrt(adhesion);
  if (sphere)
    return (po_scales){.load = 1.0,
                       .load_factor = adhesion,
                       .stretch = mu,
                       .wavy_stretch = mu * root * root,
                       .contact_gap = per_stretch * mu * root * root};
  const jkr smooth = jkr_of(scene, 1.0), wavy = adhesion > 1.0 ? jkr_of(scene, adhesion) : smooth;
  const double gap = po_profile_gap(&scene->profile, scene->radius, smooth.contact);
  const double wavy_gap = po_profile_gap(&scene->profile, scene->radius, wavy.contact);
  const double load = fmin(rigid, smooth.pull_off / 1.5), stretch = gap / per_stretch;
  const double usual = stretch > 1.0 ? smooth.pull_off / 1.5 : rigid;
  const double by_waves = fmax(adhesion, wavy.pull_off / smooth.pull_off);
  return (po_scales){.load = load,
                     .load_factor = load > 0.0 ? usual / load * by_waves : 1.0,
                     .stretch = stretch,
                     .wavy_stretch = wavy_gap / per_stretch,
                     .contact_gap = wavy_gap};
}
