/* One row a key: all that readers, writers, options, help and the tables of the documents need.
 *
 * Each list calls X for its rows, with the cells: enumerator, name, domain, expected values,
 * dimension, owner, place in a po_request, whether a series may vary it, the verbs that have an
 * option for it, the name of its value, and help: of the verb solve, of follow (series) and of
 * theory, where "" means that of solve. A row without help has the help of the next row.
 *
 * A new parameter of a law is one row after those of the other laws (doc/extending.md). */
#ifndef PO_KEY_ROWS_H
#define PO_KEY_ROWS_H

// clang-format off
#define PO_KEY_ROWS(X)                                                                             \
  X(TABOR, "tabor", NOT_NEGATIVE, "a finite number >= 0", NUMBER, SCENE, PLACE(scene.tabor), VARIES, \
    EVERY, "MU", "Tabor parameter, >= 0; 0 is a rigid sphere (default 1)",                         \
    "Tabor parameter, >= 0 (default 1)", "Tabor parameter, > 0 for the elastic forms (default 1)") \
  X(AMPLITUDE, "amplitude", NOT_NEGATIVE, "a finite number >= 0", LENGTH, SCENE,                   \
    PLACE(scene.amplitude), VARIES, EVERY, "A",                                                    \
    "amplitude of the waviness, in epsilon; 0 is a smooth sphere (default 0)", "",                 \
    "amplitude of the waviness, in epsilon; 0 is a smooth sphere")                                 \
  X(WAVELENGTH, "wavelength", POSITIVE, "a finite number > 0", LENGTH, SCENE,                      \
    PLACE(scene.wavelength), VARIES, EVERY, "L",                                                   \
    "wavelength of the waviness, in epsilon; needed if the amplitude is > 0",                      \
    "wavelength of the waviness, in epsilon", "wavelength of the waviness, in epsilon")            \
  X(RADIUS, "radius", POSITIVE, "a finite number > 0", LENGTH, SCENE, PLACE(scene.radius), VARIES, \
    EVERY, "R", "radius of the sphere, in epsilon (default 100); for another profile the length "  \
    "R in the unit of the load, pi w R (default 1)", "", "")                                       \
  X(OUTER_RADIUS, "outer_radius", POSITIVE_OR_INFINITE, "a finite number > 0, or inf", LENGTH,     \
    SCENE, PLACE(scene.outer_radius), VARIES, SOLVE | FOLLOW, "R",                                 \
    "radius at which the elastic surface is cut, in epsilon; inf is the unbounded half-space "     \
    "(default inf)", "", "")                                                                       \
  X(LAW, "law", NAME, PO_LAW_EXPECTED, NUMBER, LAW, NO_PLACE, CONSTANT, EVERY, "LAW",              \
    "traction-separation law: lennard-jones (Eq 9), mie:M,N with 1<M<N, or morse:A (default "      \
    "lennard-jones)", "",                                                                          \
    "traction-separation law: lennard-jones, mie:M,N or morse:A (rigid, maugis; default "          \
    "lennard-jones)")                                                                              \
  X(MIE_M, "mie_m", POSITIVE, "a finite number > 1", NUMBER, LAW,                                  \
    PLACE(scene.law.parameter[PO_MIE_M]), VARIES, SOLVE | FOLLOW, "M", "", "", "")                 \
  X(MIE_N, "mie_n", POSITIVE, "a number > mie_m, at most 60", NUMBER, LAW,                              \
    PLACE(scene.law.parameter[PO_MIE_N]), VARIES, SOLVE | FOLLOW, "N",                             \
    "exponents M and N, for --law mie without exponents", "", "")                                  \
  X(MORSE_A, "morse_a", POSITIVE, "a number from 0.05 to 50", NUMBER, LAW,                              \
    PLACE(scene.law.parameter[PO_MORSE_A]), VARIES, SOLVE | FOLLOW, "A",                           \
    "parameter A, for --law morse without parameter", "", "")                                      \
  X(PROFILE, "profile", NAME, PO_PROFILE_EXPECTED, NUMBER, PROFILE, NO_PLACE, CONSTANT, EVERY,     \
    "PROFILE", "initial gap without waves: sphere, power:C,N (C r^N), cone:T (T r), punch:B,R (0 " \
    "up to B, (r-B)^2/2R beyond) or truncated:B,R (0 up to B, (r^2-B^2)/2R beyond); lengths in "   \
    "epsilon (default sphere)", "",                                                                \
    "initial gap without waves (rigid, jkr, maugis): sphere, power:C,N (C r^N), cone:T (T r), "    \
    "punch:B,R (0 up to B, (r-B)^2/2R beyond) or truncated:B,R (0 up to B, (r^2-B^2)/2R beyond); " \
    "lengths in epsilon (default sphere)")                                                         \
  X(POWER_C, "power_c", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                          \
    PLACE(scene.profile.parameter[PO_POWER_C]), VARIES, EVERY, "C", "", "", "")                    \
  X(POWER_N, "power_n", POSITIVE, "a number from 1 to 40", NUMBER, PROFILE,                        \
    PLACE(scene.profile.parameter[PO_POWER_N]), VARIES, EVERY, "N", "", "", "")                    \
  X(CONE_T, "cone_t", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                            \
    PLACE(scene.profile.parameter[PO_CONE_T]), VARIES, EVERY, "T", "", "", "")                     \
  X(PUNCH_B, "punch_b", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                          \
    PLACE(scene.profile.parameter[PO_PUNCH_B]), VARIES, EVERY, "B", "", "", "")                    \
  X(PUNCH_R, "punch_r", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                          \
    PLACE(scene.profile.parameter[PO_PUNCH_R]), VARIES, EVERY, "R", "", "", "")                    \
  X(TRUNCATED_B, "truncated_b", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                  \
    PLACE(scene.profile.parameter[PO_TRUNCATED_B]), VARIES, EVERY, "B", "", "", "")                \
  X(TRUNCATED_R, "truncated_r", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                  \
    PLACE(scene.profile.parameter[PO_TRUNCATED_R]), VARIES, EVERY, "R",                            \
    "parameters, for --profile with the name alone", "", "")                                       \
  X(TABLE_SCALE, "table_scale", POSITIVE, "a finite number > 0", NUMBER, PROFILE,                  \
    PLACE(scene.profile.parameter[PO_TABLE_SCALE]), CONSTANT, EVERY, "S",                          \
    "unit of the numbers of --profile-file, in epsilon (default 1)", "", "")                       \
  X(PROFILE_FILE, "profile_file", NAME, "a CSV file with the columns r and gap", NUMBER, PROFILE,  \
    NO_PLACE, CONSTANT, EVERY, "FILE",                                                             \
    "profile from a CSV file with the columns r and gap, in epsilon", "", "")                      \
  X(WAVES, "waves", NAME,                                                                          \
    "A@L;A@L;..., amplitude and wavelength of at most 8 waves, all > 0, or -", NUMBER, PROFILE,    \
    NO_PLACE, CONSTANT, EVERY, "A,L",                                                              \
    "add a wave of amplitude A and wavelength L, in epsilon; up to 8", "", "")                     \
  X(SCHEME, "scheme", NAME, "ring, triangle or panel", NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE,    \
    "NAME", "elements that discretise the surface: ring, triangle or panel (default panel)", "", "") \
  X(GRADING, "grading", NAME, "uniform or graded", NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE, "NAME", \
    "spacing of the nodes, uniform or graded; ring and triangle only (default uniform)", "", "")   \
  X(NODES, "nodes", COUNT, "a whole number > 0", NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE, "N",     \
    "number of nodes, 8 to 2500; ring and triangle only (default 501)", "", "")                    \
  X(TOLERANCE, "tolerance", POSITIVE, "a number from 1e-10 to 1e-2", NUMBER, MESH, PLACE(mesh.tolerance),  \
    CONSTANT, SOLVE | FOLLOW, "T",                                                                 \
    "relative tolerance on the pull-off force, 1e-10 to 0.01; panel only (default 1e-6)",          \
    "relative tolerance on the pull-off force, 1e-10 to 0.01 (default 1e-6)", "")                  \
  X(APPROACH_START, "approach_start", ANY_NUMBER, "a finite number", LENGTH, TRACE,                \
    PLACE(approach_start), CONSTANT, SOLVE, "D",                                                   \
    "approach at which the trace begins, in epsilon (default: chosen by the solver, with the "     \
    "bodies far apart)", "", "")                                                                   \
  X(APPROACH_END, "approach_end", ANY_NUMBER, "a finite number", LENGTH, TRACE,                    \
    PLACE(approach_end), CONSTANT, SOLVE, "D",                                                     \
    "approach at which the trace ends, in epsilon; also the preload if no preload is given "       \
    "(default: the trace ends once the preload is reached)", "", "")                               \
  X(PRELOAD, "preload", FINITE_OR_INFINITE, "a finite number, or inf", LENGTH, TRACE,              \
    PLACE(preload.approach), CONSTANT, SOLVE | FOLLOW, "D",                                        \
    "approach up to which the sphere is loaded before it is pulled off, in epsilon; inf searches " \
    "all preloads for the greatest pull-off force",                                                \
    "approach up to which each sphere is loaded before it is pulled off, in epsilon; inf "         \
    "searches all preloads for the greatest pull-off force", "")                                   \
  X(PRELOAD_LOAD, "preload_load", NOT_NEGATIVE, "a finite number >= 0", NUMBER, TRACE,             \
    PLACE(preload.load), CONSTANT, SOLVE | FOLLOW, "W",                                            \
    "load up to which the sphere is loaded, in pi w R; with --preload, loading ends at whichever " \
    "is reached first (default 1, unless --preload or --approach-end is given)",                   \
    "load up to which each sphere is loaded, in pi w R; with --preload, loading ends at "          \
    "whichever is reached first (default 1, unless --preload is given)", "")                       \
  X(TIME_LIMIT, "time_limit", POSITIVE, "a finite number > 0", NUMBER, TRACE, PLACE(time_limit),   \
    CONSTANT, SOLVE | FOLLOW, "S",                                                                 \
    "processor time after which the solve is stopped, in seconds (default: no limit)",             \
    "processor time after which each solve is stopped, in seconds (default: no limit)", "")

/* Dimensionless groups of these keys, for sweeps, conditions and reference tables. Each sets one
 * key (po_key_target): the wavelength by A R/lambda^2, Eq 6; the amplitude by A/lambda; the outer
 * radius by r_max/R; tabor by w/(E* epsilon). */
#define PO_GROUP_ROWS(X)                                                                           \
  X(ALPHA, "alpha", POSITIVE, "a finite number > 0", NUMBER, SCENE, NO_PLACE, VARIES, 0, "ALPHA",  \
    "A R/L^2", "", "")                                                                             \
  X(AMPLITUDE_RATIO, "amplitude_ratio", NOT_NEGATIVE, "a finite number >= 0", NUMBER, SCENE,       \
    NO_PLACE, VARIES, FOLLOW, "Q", "",                                                             \
    "amplitude divided by wavelength, instead of --amplitude; constant if the wavelength varies",  \
    "")                                                                                            \
  X(OUTER_RATIO, "outer_ratio", POSITIVE, "a finite number > 0", NUMBER, SCENE, NO_PLACE, VARIES,  \
    0, "Q", "outer radius divided by radius", "", "")                                              \
  X(COUPLING, "coupling", NOT_NEGATIVE, "a finite number >= 0", NUMBER, SCENE, NO_PLACE, VARIES,   \
    EVERY, "C", "w/(E* epsilon), >= 0, instead of --tabor", "", "")
// clang-format on

#endif
