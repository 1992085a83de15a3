#include <math.h>

#include "po_observe_parts.h"

/* Error of the gap, in eps, that panels may make by their last coefficients, over the root of the
 * relative tolerance of the pull-off force: what these coefficients do to the load goes as their
 * square, by Gauss's rule. Set by the smooth sphere (tests/unit/test_panels.c). */
static const double ERROR_OF_TOLERANCE = 0.3, ERROR_OF_WAVES = 1.0, COARSEST_ERROR = 3e-4;
/* Beyond this Tabor parameter the coarsest error falls as its square: on coarser panels the
 * iteration onto mu = 50 needs steps three times shorter. */
static const double STIFF_TABOR = 14.0;
/* Below it waves may have more, by the fourth power: their minima are sharp, whereas that of a
 * sphere is flat, and its approach would suffer. With 5e-3 at mu = 20 folds appear that are not.
 * Nothing is gained where the surface hardly gives way (a limit at 1 would be crossed by the last
 * bit of many a scene), nor when a curve is wanted: its cubics need twice as many steps over what
 * coarse panels leave of ripples. */
static const double COARSEST_OF_WAVES = 1e-2, LEAST_PLIANT_TABOR = 1.05;
/* Waves whose crests are no more than so many times as curved as the sphere are hardly more than a
 * smooth one: of random scenes from mu = 4 to 10 at 1e-4 one in eight had a fold that no finer mesh
 * found, or two folds too many; of the others one in thirty. */
static const double LEAST_CURVATURE = 8.0;
/* Error of the load that a panel may make, by an estimate that is mostly too large, over the same
 * tolerance. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* Where Newton's method may stop, in parts of 1 + H, per relative tolerance; and what locating
 * folds needs. */
static const double PRECISION_OF_TOLERANCE = 1e-4, COARSEST_PRECISION = 1e-9;

/* In that of the sphere; 0: smooth. */
static double curvature_of_crests(const po_scene *scene) {
  if (!po_scene_is_wavy(scene))
    return 0.0;
  const double wave_number = 2.0 * M_PI / scene->wavelength;
  return scene->amplitude * wave_number * wave_number * scene->radius;
}

static bool may_be_coarse(const po_request *request) {
  const po_scene *scene = &request->scene;
  return curvature_of_crests(scene) > LEAST_CURVATURE && scene->tabor > LEAST_PLIANT_TABOR &&
         !(request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS));
}

/* The error of the gap that panels may make at any tolerance. */
static double coarsest_error(const po_request *request) {
  const double stiff = request->scene.tabor / STIFF_TABOR;
  if (stiff > 1.0)
    return COARSEST_ERROR / (stiff * stiff);
  if (!may_be_coarse(request))
    return COARSEST_ERROR;
  return fmin(COARSEST_OF_WAVES, COARSEST_ERROR / pow(stiff, 4.0));
}

po_allowance po_observe_allowance(const po_request *request, double tolerance) {
  const double coarsest = coarsest_error(request);
  const double error = may_be_coarse(request) ? ERROR_OF_WAVES : ERROR_OF_TOLERANCE;
  return (po_allowance){fmin(coarsest, error * sqrt(tolerance)),
                        fmin(coarsest, LOAD_OF_TOLERANCE * tolerance)};
}

double po_observe_precision(double tolerance) {
  return fmax(PO_FINEST_PRECISION, fmin(COARSEST_PRECISION, PRECISION_OF_TOLERANCE * tolerance));
}
