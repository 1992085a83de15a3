/* DOCUMENT = pulloff_mex(KEY, VALUE, ...) solves the scene with these keys, texts or numbers, in
 * MATLAB and Octave. Returned: the JSON document, which jsondecode makes a structure. A scene that
 * is refused, or whose solve fails, is an error with the message of the library.
 *
 *     mex pulloff_mex.c -lpulloff                                                  (MATLAB)
 *     mkoctfile --mex pulloff_mex.c $(pkg-config --cflags --libs pulloff)          (Octave)
 */
#include <mex.h>
#include <pulloff.h>
#include <stdio.h>

static pulloff_status set(pulloff_scene *scene, const mxArray *key, const mxArray *value,
                          pulloff_message *message) {
  char *name = mxIsChar(key) ? mxArrayToString(key) : NULL;
  char *text = mxIsChar(value) ? mxArrayToString(value) : NULL;
  pulloff_status status = PULLOFF_BAD_INPUT;
  if (name && text)
    status = pulloff_scene_set(scene, name, text, message);
  else if (name && mxIsDouble(value) && !mxIsComplex(value) && mxGetNumberOfElements(value) == 1)
    status = pulloff_scene_set_number(scene, name, mxGetScalar(value), message);
  else
    snprintf(message->text, sizeof message->text, "expected a key and a text or a real number");
  mxFree(name);
  mxFree(text);
  return status;
}

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[]) {
  pulloff_message message = {""};
  pulloff_scene *scene = NULL;
  pulloff_result *result = NULL;
  char *document = NULL;
  (void)outputs;
  if (inputs % 2)
    mexErrMsgIdAndTxt("pulloff:input", "expected pairs of a key and its value");
  pulloff_status status = pulloff_scene_create(&scene, &message);
  for (int k = 0; k < inputs && !status; k += 2)
    status = set(scene, input[k], input[k + 1], &message);
  if (!status)
    status = pulloff_solve(scene, &result, &message);
  if (!status)
    status = pulloff_result_json(result, &document, &message);
  if (document)
    output[0] = mxCreateString(document);
  pulloff_free(document);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  if (status)
    mexErrMsgIdAndTxt("pulloff:solve", "%s", message.text);
}
