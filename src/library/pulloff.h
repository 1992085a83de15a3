/* libpulloff: adhesion of an axisymmetric body and an elastic half-space, solved from C.
 *
 * A scene says what is pressed together, by the keys that `pulloff solve` has as options. It is
 * solved to a result, which has typed parts (pull-off, special points, curve, profile) and all
 * numbers of the JSON document that `pulloff solve --json` prints, by their names there. The
 * numbers are those of the program to the last bit.
 *
 *     pulloff_message message;
 *     pulloff_scene *scene = NULL;
 *     pulloff_result *result = NULL;
 *     pulloff_status status = pulloff_scene_create(&scene, &message);
 *     if (!status)
 *       status = pulloff_scene_set_number(scene, "tabor", 2.0, &message);
 *     if (!status)
 *       status = pulloff_solve(scene, &result, &message);
 *     pulloff_pull_off pull_off;
 *     if (!status && pulloff_result_pull_off(result, &pull_off))
 *       printf("%g pi w R\n", pull_off.force);
 *     else
 *       fprintf(stderr, "%s\n", message.text);
 *     pulloff_result_destroy(result);
 *     pulloff_scene_destroy(scene);
 *
 * Units. Lengths are in epsilon, the equilibrium distance of the traction-separation law; loads and
 * forces in pi w R, with the work of adhesion w and the radius R; energies in pi w R epsilon. The
 * approach is positive when the bodies are pressed together, the load when it is compressive.
 * A scene is in SI units if one of its keys is, such as radius_m; pulloff_scene_units and
 * pulloff_result_units then give the units of its results, and a key in epsilon or pi w R, such as
 * preload_load, is refused when it is solved.
 *
 * Failures. A function that can fail returns a status and writes one line that says what happened,
 * to which value, and what was expected, to `message`, which may be NULL. On success the message is
 * empty. No function ends the process, prints, or installs a handler of signals.
 *
 * Threads. Any number of threads may call these functions at the same time. A scene may be changed
 * by one thread while no other one uses it; scenes and results that nobody changes may be used by
 * several threads.
 *
 * The process. While a function of this library runs, the error handler of GSL is off, and while a
 * condition number is computed, OpenBLAS uses one thread. Both settings, which belong to the
 * process, are restored. Locale and floating-point environment are those of the calling thread
 * again when a function returns. */
#ifndef PULLOFF_H
#define PULLOFF_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* -- Status and version -- */

/* 0: success. Positive: the solve ended with this numerical outcome; the result exists and contains
 * what was found before. Negative: wrong input or exhausted resources; there is no result. */
typedef enum {
  PULLOFF_OK = 0,
  PULLOFF_NOT_CONVERGED = 1,   /* Newton's method did not converge */
  PULLOFF_STEP_TOO_SMALL = 2,  /* the branch could not be followed with the shortest step */
  PULLOFF_TOO_MANY_POINTS = 3, /* the branch has more points than allowed */
  PULLOFF_SINGULAR = 4,        /* a matrix is singular to working precision */
  PULLOFF_NOT_FOUND = 5,       /* the result has no value of this name */
  PULLOFF_INTERRUPTED = 6,     /* by the flag of pulloff_scene_set_stop */
  PULLOFF_OUT_OF_DOMAIN = 7,   /* the contact reached the end of the meshed surface */
  PULLOFF_OUT_OF_NODES = 8,    /* the traction needs more nodes than allowed */
  PULLOFF_OUT_OF_TIME = 9,     /* the solve took more processor time than time_limit */
  PULLOFF_BAD_INPUT = -1,
  PULLOFF_NO_MEMORY = -2,
  PULLOFF_CANNOT_READ = -3 /* a file that a key names cannot be read */
} pulloff_status;

/* Why a call failed: one line of text without newline; empty after a success. */
typedef struct {
  char text[1024];
} pulloff_message;

/* Returned: the version of the loaded library, for example "0.1.0". */
const char *pulloff_version(void);

/* Returned: a status in a few words, for example "not converged"; never NULL. */
const char *pulloff_status_text(pulloff_status status);

/* -- Scene -- */

/* What is solved: the scene, its discretisation, the preload, and the results that are wanted. */
typedef struct pulloff_scene pulloff_scene;

/* Creates a scene in which no key is set: a smooth sphere with Tabor parameter 1 and R = 100
 * epsilon on the unbounded half-space, solved as `pulloff solve` does without options. Status:
 * PULLOFF_NO_MEMORY. */
pulloff_status pulloff_scene_create(pulloff_scene **scene, pulloff_message *message);

/* Creates a copy, without the flag and the counter of pulloff_scene_set_stop and
 * pulloff_scene_set_seen. Status: PULLOFF_NO_MEMORY. */
pulloff_status pulloff_scene_copy(const pulloff_scene *scene, pulloff_scene **copy,
                                  pulloff_message *message);

/* Releases a scene; nothing for NULL. */
void pulloff_scene_destroy(pulloff_scene *scene);

/* The keys: their number, and of one its name, the accepted values, and what it sets, for example
 * "outer_radius", "a finite number > 0, or inf", and "radius at which the elastic surface is cut,
 * in epsilon; inf is the unbounded half-space (default inf)". They are the options of `pulloff
 * solve` with _ for -, and dimensionless groups such as amplitude_ratio, each of which sets another
 * key when the scene is solved. Three more are of this library: `want`, the additional results, any
 * of curve, profile, hysteresis, diagnostics, preload, theories, loop and history with commas
 * between; and `profile_approach` and `profile_load`, approach or load of the profile in epsilon
 * or pi w R. Returned: NULL if there is no key of this number. */
size_t pulloff_key_count(void);
const char *pulloff_key_name(size_t number);
const char *pulloff_key_expected(size_t number);
const char *pulloff_key_help(size_t number);

/* Sets a key to the value in a text, in decimal notation whatever the locale; NULL unsets it. The
 * value of pulloff_scene_set_number reaches the solver unchanged; INFINITY is "inf".
 * Status: PULLOFF_BAD_INPUT, if there is no such key or it does not accept the value;
 * PULLOFF_CANNOT_READ; PULLOFF_NO_MEMORY. The scene is then unchanged. Whether the values of
 * several keys agree is checked when the scene is solved. */
pulloff_status pulloff_scene_set(pulloff_scene *scene, const char *key, const char *value,
                                 pulloff_message *message);
pulloff_status pulloff_scene_set_number(pulloff_scene *scene, const char *key, double value,
                                        pulloff_message *message);

/* Prints the value that a key has when the scene is solved, defaults included, as `pulloff solve`
 * prints it: "auto" and "none" for values that the solver chooses. A text that does not fit is cut
 * short. Status: PULLOFF_BAD_INPUT, also if the keys that are set do not agree. */
pulloff_status pulloff_scene_get(const pulloff_scene *scene, const char *key, char *text,
                                 size_t size, pulloff_message *message);

/* A scene in SI units. */
typedef struct {
  double modulus;      /* E* = E/(1 - nu^2) of both bodies together, Pa; INFINITY: rigid */
  double work;         /* w, work of adhesion, J/m^2 */
  double distance;     /* epsilon, equilibrium distance of the law, m */
  double radius;       /* R, m */
  double amplitude;    /* A of the waviness, m; 0: smooth */
  double wavelength;   /* lambda of the waviness, m; not used if smooth */
  double outer_radius; /* r_max, m; INFINITY: unbounded half-space */
} pulloff_physical;

/* The SI values of the units of dimensionless numbers: a number times its unit is its SI value. */
typedef struct {
  double length;   /* epsilon, m: unit of approach and radii */
  double force;    /* pi w R, N: unit of load and force */
  double work;     /* w, J/m^2 */
  double traction; /* w/(mu epsilon), Pa: unit of tractions; INFINITY if rigid */
} pulloff_units;

/* Sets modulus_pa, work_j_per_m2, distance_m, radius_m, amplitude_m, wavelength_m and
 * outer_radius_m, in place of tabor, radius, amplitude, wavelength and outer_radius. Given:
 * `units`, may be NULL. Returned: the units of the results in *units. Status: PULLOFF_BAD_INPUT,
 * with the quantity that is out of range; the scene is then unchanged. */
pulloff_status pulloff_scene_set_physical(pulloff_scene *scene, const pulloff_physical *physical,
                                          pulloff_units *units, pulloff_message *message);

/* The units of the results of a scene in SI units, as its keys are now. Status: PULLOFF_BAD_INPUT,
 * also if the scene is not in SI units; *units is then unchanged. */
pulloff_status pulloff_scene_units(const pulloff_scene *scene, pulloff_units *units,
                                   pulloff_message *message);

/* Sets a flag that ends solves of the scene soon after it becomes nonzero, with the status
 * PULLOFF_INTERRUPTED; NULL: none. A handler of a signal may set it. It must exist while the scene
 * is solved. */
void pulloff_scene_set_stop(pulloff_scene *scene, const volatile sig_atomic_t *stop);

/* Sets a counter which during pulloff_follow is the number of the scenes of which a trace or a
 * followed minimum has been seen; NULL: none. Another thread may read it, to show progress. It must
 * exist while the scene is solved. */
void pulloff_scene_set_seen(pulloff_scene *scene, volatile sig_atomic_t *seen);

/* -- Solve -- */

typedef struct pulloff_result pulloff_result;

/* Solves a scene. Returned: *result, to be destroyed; NULL for a negative status. A positive status
 * is also pulloff_result_status; the message then says where the solve ended. Status: all. */
pulloff_status pulloff_solve(const pulloff_scene *scene, pulloff_result **result,
                             pulloff_message *message);

/* Solves scenes that differ in one key, by parameter continuation between scenes that are traced in
 * full, as `pulloff follow` does. Given: values[count] of the key, ascending or descending.
 * Returned: results[count], each to be destroyed; NULL unless the status is PULLOFF_OK. A solve
 * that fails does not fail the series: see pulloff_result_status of each. Status:
 * PULLOFF_INTERRUPTED, PULLOFF_BAD_INPUT, PULLOFF_CANNOT_READ, PULLOFF_NO_MEMORY. */
pulloff_status pulloff_follow(const pulloff_scene *scene, const char *key, const double *values,
                              size_t count, pulloff_result **results, pulloff_message *message);

/* Evaluates a closed form: bradley, rigid, jkr, guduru, kesari-lew and the others that `pulloff
 * theory --help` lists; after the preload of the scene, if it has one and the form depends on it.
 * Given: `alpha`, A R/lambda^2 in place of the wavelength; NAN: that of the
 * scene; `at`, the value of the variable of the form (approach, contact radius or gap); NAN: none.
 * A key that is set, and on which the form does not depend, is refused.
 * Returned: *result, with the numbers that `pulloff theory --json` prints, such as pull_off_force.
 * Status: PULLOFF_BAD_INPUT, PULLOFF_NO_MEMORY. */
pulloff_status pulloff_theory(const char *form, const pulloff_scene *scene, double alpha, double at,
                              pulloff_result **result, pulloff_message *message);

/* The same in the state with a load, an approach or a contact radius. Given: `variable`, "load",
 * "approach" or "contact_radius", or in SI units "load_n", "approach_m" or "contact_radius_m";
 * `at`, its value. At a load or an approach it is the stable state of unloading, after the preload
 * of the scene (keys preload and preload_load), without one from the hardest preload. The key want
 * may be "curve" for a form that has a curve. Status: also PULLOFF_BAD_INPUT if there is no such
 * state. */
pulloff_status pulloff_theory_at(const char *form, const pulloff_scene *scene, double alpha,
                                 const char *variable, double at, pulloff_result **result,
                                 pulloff_message *message);

/* -- Result -- */

/* Releases a result and everything that was obtained from it by pointer; nothing for NULL. */
void pulloff_result_destroy(pulloff_result *result);

/* PULLOFF_OK, or why the solve ended before its end, and in which state; "" for PULLOFF_OK. */
pulloff_status pulloff_result_status(const pulloff_result *result);
const char *pulloff_result_reason(const pulloff_result *result);

/* An error is an estimated bound; NAN if the scheme does not estimate it. */
typedef struct {
  double force, force_error;                   /* magnitude, pi w R */
  double approach, approach_error;             /* epsilon */
  double contact_radius, contact_radius_error; /* epsilon */
} pulloff_pull_off;

/* The pull-off of the preload. Returned: false if the result has none; *pull_off is then unchanged.
 */
bool pulloff_result_pull_off(const pulloff_result *result, pulloff_pull_off *pull_off);

typedef enum {
  PULLOFF_JUMP_IN,  /* fold at which the surfaces jump closer */
  PULLOFF_JUMP_OUT, /* fold at which they jump apart */
  PULLOFF_MINIMUM,  /* of the load */
  PULLOFF_MAXIMUM   /* of the load */
} pulloff_kind;

typedef struct {
  pulloff_kind kind;
  int unstable_modes; /* at given approach, of the equilibria that follow along the branch */
  double approach, approach_error; /* epsilon */
  double load, load_error;         /* pi w R */
  double contact_radius;           /* epsilon */
  double energy, energy_error;     /* pi w R epsilon; NAN: not estimated */
  double position;                 /* arclength along the branch */
} pulloff_special_point;

typedef struct {
  double position;                 /* arclength along the branch */
  double approach, load;           /* epsilon, pi w R */
  double energy, energy_error;     /* pi w R epsilon; 0 infinitely far apart; the error: at this
                                      approach, NAN: not estimated */
  double contact_radius;           /* epsilon */
  double approach_rate, load_rate; /* derivatives with respect to the position */
  int unstable_modes;              /* 0: stable at given approach */
} pulloff_curve_point;

typedef struct {
  double radius;   /* epsilon */
  double gap;      /* H = h/epsilon - 1 */
  double traction; /* P = p mu epsilon/w, > 0 compressive */
} pulloff_profile_point;

/* The special points and the points of the branch in order along it, and the profile over the
 * radius. Returned: *count of them, which stay valid until the result is destroyed; NULL and 0 if
 * there are none. The curve and the profile exist if `want` of the scene named them. */
const pulloff_special_point *pulloff_result_folds(const pulloff_result *result, size_t *count);
const pulloff_special_point *pulloff_result_extrema(const pulloff_result *result, size_t *count);
const pulloff_curve_point *pulloff_result_curve(const pulloff_result *result, size_t *count);
const pulloff_profile_point *pulloff_result_profile(const pulloff_result *result, size_t *count);

/* Any value of the result by its path in the JSON document (doc/json.md): names and, in arrays,
 * numbers from 0, with points between, for example "pull_off_any.force" or
 * "hysteresis.displacement_control.jumps.0.energy_lost". A number that is null there is NAN. A text
 * stays valid until the result is destroyed. The count is that of the members of an array.
 * Status: PULLOFF_NOT_FOUND, if there is no such value or it is of another kind. */
pulloff_status pulloff_result_number(const pulloff_result *result, const char *path, double *value,
                                     pulloff_message *message);
pulloff_status pulloff_result_text(const pulloff_result *result, const char *path,
                                   const char **text, pulloff_message *message);
pulloff_status pulloff_result_count(const pulloff_result *result, const char *path, size_t *count,
                                    pulloff_message *message);

/* One number of each member of an array of objects, for example "load" of "curve".
 * Given: `count`, that of the array. Returned: values[count]. Status: PULLOFF_NOT_FOUND, also if
 * the array has another count. */
pulloff_status pulloff_result_column(const pulloff_result *result, const char *path,
                                     const char *name, double *values, size_t count,
                                     pulloff_message *message);

/* The units of a result, for each of a series its own. Returned: false if its scene was not in SI
 * units; *units is then unchanged. */
bool pulloff_result_units(const pulloff_result *result, pulloff_units *units);

/* The JSON document, as the program prints it, without its part `physical`. Returned: *text, to be
 * released with pulloff_free. Status: PULLOFF_NO_MEMORY. */
pulloff_status pulloff_result_json(const pulloff_result *result, char **text,
                                   pulloff_message *message);
void pulloff_free(char *text);

#ifdef __cplusplus
}
#endif

#endif
