#include <math.h>

#include "po_observe_parts.h"

/* Allowed error of the gap, eps, divided by the square root of the relative tolerance of the
 * pull-off force, for smooth and for wavy scenes, and its greatest value at any tolerance. The
 * square root, because the error of the load goes as the square of the last Legendre coefficients.
 * Chosen for the smooth sphere (tests/unit/test_panels.c). */
static const double ERROR_OF_TOLERANCE = 0.3, ERROR_OF_WAVES = 1.0, COARSEST_ERROR = 3e-4;
/* Below STIFF_TABOR wavy scenes have a larger allowed error, inversely proportional to the fourth
 * power of the Tabor parameter, up to COARSEST_OF_WAVES. Their minima of the load are sharp; that
 * of a smooth sphere is flat, so that its approach would be less accurate. With 5e-3 at mu = 20
 * spurious folds appear. Below LEAST_PLIANT_TABOR a larger error saves nothing; the value is not 1
 * because rounding would decide for the many scenes of mu = 1. If a curve is wanted, a larger error
 * costs twice as many steps, since the cubics must follow the ripples of coarse panels. */
static const double COARSEST_OF_WAVES = 1e-2, LEAST_PLIANT_TABOR = 1.05, STIFF_TABOR = 14.0;
/* Curvature of the crests, relative to that of the sphere, above which the larger error is allowed.
 * Of random scenes from mu = 4 to 10 at a tolerance of 1e-4 with a smaller curvature, one in eight
 * had spurious folds with the larger error; of the others one in thirty. */
static const double LEAST_CURVATURE = 8.0;
/* Allowed error of the load of a panel, divided by the tolerance. The estimate of this error is
 * usually too large. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* Precision of Newton's method, relative to 1 + H, divided by the tolerance; and its greatest
 * value, which the location of folds requires. */
static const double PRECISION_OF_TOLERANCE = 1e-4, COARSEST_PRECISION = 1e-9;

/* The curvature of the crests relative to that of the sphere; 0 for a smooth scene. */
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

/* The greatest allowed error of the gap, at any tolerance. */
static double coarsest_error(const po_request *request) {
  const double stiff = request->scene.tabor / STIFF_TABOR;
  if (stiff > 1.0 || !may_be_coarse(request))
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
