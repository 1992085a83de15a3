/* Solves the scene that the arguments give, such as tabor=3 amplitude=1 wavelength=20, and prints
 * the pull-off with bounds of its errors, and the folds. Lengths in epsilon, loads in pi w R.
 *
 *     cc pull_off.c $(pkg-config --cflags --libs pulloff) && ./a.out tabor=3 amplitude=1
 * wavelength=20
 */
#include <pulloff.h>
#include <stdio.h>
#include <string.h>

static pulloff_status set_all(pulloff_scene *scene, int count, char **arguments,
                              pulloff_message *message) {
  pulloff_status status = PULLOFF_OK;
  for (int i = 0; i < count && !status; ++i) {
    char *value = strchr(arguments[i], '=');
    if (value)
      *value++ = '\0';
    status = pulloff_scene_set(scene, arguments[i], value, message);
  }
  return status;
}

static void print(const pulloff_result *result) {
  pulloff_pull_off p;
  if (pulloff_result_pull_off(result, &p))
    printf("pull-off force %.10g (error %.1e) at approach %.10g (%.1e), contact radius %.8g\n",
           p.force, p.force_error, p.approach, p.approach_error, p.contact_radius);
  size_t count;
  const pulloff_special_point *folds = pulloff_result_folds(result, &count);
  for (size_t i = 0; i < count; ++i)
    printf("%s at approach %.10g, load %.10g\n",
           folds[i].kind == PULLOFF_JUMP_IN ? "jump in " : "jump out", folds[i].approach,
           folds[i].load);
}

int main(int argc, char **argv) {
  pulloff_message message = {""};
  pulloff_scene *scene = NULL;
  pulloff_result *result = NULL;
  pulloff_status status = pulloff_scene_create(&scene, &message);
  if (!status)
    status = set_all(scene, argc - 1, argv + 1, &message);
  if (!status)
    status = pulloff_solve(scene, &result, &message);
  if (result)
    print(result);
  if (status)
    fprintf(stderr, "%s\n", message.text);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  return status ? 1 : 0;
}
