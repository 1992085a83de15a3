/* Scenes for tests of the library, each as keys and values with blanks between: every scheme, the
 * rigid limit, all additional results, and one that fails. None has a search of limited time, whose
 * end depends on the machine. */
#ifndef SCENES_H
#define SCENES_H

static const char *const SCENES[] = {
    "tabor 1 preload_load 1",
    "tabor 3 amplitude 1 wavelength 20 outer_radius 100 want curve,profile",
    "tabor 0.5 want hysteresis,preload,curve",
    "tabor 3 amplitude 1 wavelength 20 preload 1 want theories",
    "tabor 2 scheme triangle nodes 101 outer_radius 100 want curve",
    "tabor 0 amplitude 0.9 wavelength 21 want curve,profile,hysteresis",
    "tabor 1 want diagnostics tolerance 1e-4",
    "tabor 2 law mie:4,10 want curve",
    "tabor 1 approach_start 5 approach_end 6",
    "tabor 0.1 scheme ring nodes 61 outer_radius 50 want profile profile_approach -1",
    "tabor 0.5 profile power:0.05,1.5 want curve",
    "coupling 0.05 profile punch:10,20 preload_load 5 outer_radius 100",
    "tabor 1 amplitude_ratio 0.02 wavelength 30 preload_load 2 want hysteresis",
};
enum { SCENE_COUNT = sizeof SCENES / sizeof *SCENES };

#endif
