/* Prints the JSON document of the scene whose keys and values are the arguments; the theory of the
 * first argument, if it is `theory NAME`. Exit code: 0, or 1 with the message on standard error. */
#include <math.h>
#include <stdio.h>

#include "use.h"

int main(int argc, char **argv) {
  const bool theory = argc > 2 && strcmp(argv[1], "theory") == 0;
  pulloff_message message = {""};
  pulloff_scene *scene = NULL;
  pulloff_result *result = NULL;
  char *text = NULL;
  pulloff_status status = pulloff_scene_create(&scene, &message);
  for (int i = theory ? 3 : 1; i + 1 < argc && !status; i += 2)
    status = pulloff_scene_set(scene, argv[i], argv[i + 1], &message);
  if (!status)
    status = theory ? pulloff_theory(argv[2], scene, (double)NAN, (double)NAN, &result, &message)
                    : pulloff_solve(scene, &result, &message);
  if (status)
    fprintf(stderr, "%s\n", message.text);
  if (result && pulloff_result_json(result, &text, &message) == PULLOFF_OK)
    fputs(text, stdout);
  pulloff_free(text);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  return status ? 1 : 0;
}
