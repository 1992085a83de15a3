/* A sphere in SI units: the jumps of loading and unloading, and the traction at pull-off.
 *
 *     cc loop.c $(pkg-config --cflags --libs pulloff) && ./a.out
 */
#include <math.h>
#include <pulloff.h>
#include <stdio.h>

static double number(const pulloff_result *result, const char *path) {
  double value = NAN;
  pulloff_result_number(result, path, &value, NULL);
  return value;
}

static void print(const pulloff_result *result, const pulloff_units *units) {
  size_t jumps = 0, points = 0;
  pulloff_result_count(result, "hysteresis.displacement_control.jumps", &jumps, NULL);
  for (size_t i = 0; i < jumps; ++i) {
    char from[80], to[80];
    snprintf(from, sizeof from, "hysteresis.displacement_control.jumps.%zu.before.load", i);
    snprintf(to, sizeof to, "hysteresis.displacement_control.jumps.%zu.after.load", i);
    printf("the load jumps from %.4g nN to %.4g nN\n", 1e9 * units->force * number(result, from),
           1e9 * units->force * number(result, to));
  }
  printf("energy lost %.4g J\n", units->force * units->length *
                                     number(result, "hysteresis.displacement_control.energy_lost"));
  const pulloff_profile_point *profile = pulloff_result_profile(result, &points);
  for (size_t i = 0; i < points; i += points / 8 + 1)
    printf("at radius %6.3g nm the traction is %6.3g MPa\n",
           1e9 * units->length * profile[i].radius, 1e-6 * units->traction * profile[i].traction);
}

int main(void) {
  const pulloff_physical tip = {
      .modulus = 2e9, .work = 0.05, .distance = 3e-10, .radius = 1e-7, .outer_radius = INFINITY};
  pulloff_message message = {""};
  pulloff_units units;
  pulloff_scene *scene = NULL;
  pulloff_result *result = NULL;
  pulloff_status status = pulloff_scene_create(&scene, &message);
  if (!status)
    status = pulloff_scene_set_physical(scene, &tip, &units, &message);
  if (!status)
    status = pulloff_scene_set(scene, "want", "profile,hysteresis", &message);
  if (!status)
    status = pulloff_solve(scene, &result, &message);
  if (!status)
    print(result, &units);
  else
    fprintf(stderr, "%s\n", message.text);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  return status ? 1 : 0;
}
