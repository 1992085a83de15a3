/* One row a key: all that readers, writers, options and help need.
 *
 * Each list calls X for its rows, with the cells: enumerator, name, domain, dimension, owner, place
 * in a po_request (SETS: of the key that it sets), whether a series may vary it, the verbs that
 * have an option for it, the name of its value, and help: of all verbs, or of the others and of
 * theory. A row without help has that of the next row. po_input.c defines the words of the cells. A
 * new parameter of a law is one row after those of the other laws. */
#ifndef PO_KEY_ROWS_H
#define PO_KEY_ROWS_H

// clang-format off
#define PO_KEY_ROWS(X) \
  X(TABOR, "tabor", NOT_NEGATIVE, NUMBER, SCENE, PLACE(scene.tabor), VARIES, EVERY, "MU", \
    HELPS("Tabor parameter, >= 0; 0 is a rigid sphere (default 1)", \
          "Tabor parameter, > 0 for the elastic forms (default 1)")) \
  X(AMPLITUDE, "amplitude", NOT_NEGATIVE, LENGTH, SCENE, PLACE(scene.amplitude), VARIES, EVERY, "A", \
    HELPS("amplitude of the waviness, in epsilon; 0 is a smooth sphere (default 0)", \
          "amplitude of the waviness, in epsilon; 0 is a smooth sphere")) \
  X(WAVELENGTH, "wavelength", POSITIVE, LENGTH, SCENE, PLACE(scene.wavelength), VARIES, EVERY, "L", \
    HELP("wavelength of the waviness, in epsilon; needed if the amplitude is > 0")) \
  X(RADIUS, "radius", POSITIVE, LENGTH, SCENE, PLACE(scene.radius), VARIES, EVERY, "R", \
    HELP("radius of the sphere, in epsilon (default 100); for another profile the length R in the unit of the " \
         "load, pi w R (default 1)")) \
  X(OUTER_RADIUS, "outer_radius", POSITIVE_OR_INFINITE, LENGTH, SCENE, PLACE(scene.outer_radius), VARIES, SERIES, "R", \
    HELP("radius at which the elastic surface is cut, in epsilon; inf is the unbounded half-space (default inf)")) \
  X(LAW, "law", WORDS(PO_LAW_EXPECTED), NUMBER, LAW, NO_PLACE, CONSTANT, EVERY, "LAW", \
    HELPS("traction-separation law: lennard-jones (Eq 9), mie:M,N with 1<M<N, or morse:A (default lennard-jones)", \
          "traction-separation law: lennard-jones, mie:M,N or morse:A (rigid, maugis, persson-brener; default lennard-jones)")) \
  X(MIE_M, "mie_m", OTHER(POSITIVE, "a finite number > 1"), NUMBER, LAW, OF_LAW(PO_MIE_M), VARIES, SERIES, "M", NO_HELP) \
  X(MIE_N, "mie_n", OTHER(POSITIVE, "a number > mie_m, at most 60"), NUMBER, LAW, OF_LAW(PO_MIE_N), VARIES, SERIES, "N", \
    HELP("exponents M and N, for --law mie without exponents")) \
  X(MORSE_A, "morse_a", OTHER(POSITIVE, "a number from 0.05 to 50"), NUMBER, LAW, OF_LAW(PO_MORSE_A), VARIES, SERIES, "A", \
    HELP("parameter A, for --law morse without parameter")) \
  X(PROFILE, "profile", WORDS(PO_PROFILE_EXPECTED), NUMBER, PROFILE, NO_PLACE, CONSTANT, EVERY, "PROFILE", \
    HELPS("initial gap without waves: sphere, power:C,N (C r^N), cone:T (T r), punch:B,R (0 up to B, (r-B)^2/2R " \
          "beyond), truncated:B,R (0 up to B, (r^2-B^2)/2R beyond), exact_sphere:R (R-sqrt(R^2-r^2)) or " \
          "hyperboloid:T,B (T(sqrt(r^2+B^2)-B)); lengths in epsilon (default sphere: the parabola r^2/2R)", \
          "initial gap without waves (rigid, jkr, maugis, persson-brener): sphere, power:C,N (C r^N), cone:T (T r), punch:B,R " \
          "(0 up to B, (r-B)^2/2R beyond), truncated:B,R (0 up to B, (r^2-B^2)/2R beyond), exact_sphere:R " \
          "(R-sqrt(R^2-r^2)) or hyperboloid:T,B (T(sqrt(r^2+B^2)-B)); lengths in epsilon (default sphere: the " \
          "parabola r^2/2R)")) \
  X(POWER_C, "power_c", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_POWER_C), VARIES, EVERY, "C", NO_HELP) \
  X(POWER_N, "power_n", OTHER(POSITIVE, "a number from 1 to 40"), \
    NUMBER, PROFILE, OF_PROFILE(PO_POWER_N), VARIES, EVERY, "N", NO_HELP) \
  X(CONE_T, "cone_t", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_CONE_T), VARIES, EVERY, "T", NO_HELP) \
  X(PUNCH_B, "punch_b", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_PUNCH_B), VARIES, EVERY, "B", NO_HELP) \
  X(PUNCH_R, "punch_r", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_PUNCH_R), VARIES, EVERY, "R", NO_HELP) \
  X(TRUNCATED_B, "truncated_b", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_TRUNCATED_B), VARIES, EVERY, "B", NO_HELP) \
  X(TRUNCATED_R, "truncated_r", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_TRUNCATED_R), VARIES, EVERY, "R", NO_HELP) \
  X(EXACT_SPHERE_R, "exact_sphere_r", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_EXACT_SPHERE_R), VARIES, EVERY, "R", NO_HELP) \
  X(HYPERBOLOID_T, "hyperboloid_t", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_HYPERBOLOID_T), VARIES, EVERY, "T", NO_HELP) \
  X(HYPERBOLOID_B, "hyperboloid_b", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_HYPERBOLOID_B), VARIES, EVERY, "B", \
    HELP("parameters, for --profile with the name alone")) \
  X(TABLE_SCALE, "table_scale", POSITIVE, NUMBER, PROFILE, OF_PROFILE(PO_TABLE_SCALE), CONSTANT, EVERY, "S", \
    HELP("unit of the numbers of --profile-file, in epsilon (default 1)")) \
  X(SMOOTH, "smooth", OTHER(POSITIVE_OR_AUTO, "a finite number > 0, or auto"), NUMBER, PROFILE, \
    OF_PROFILE(PO_TABLE_SMOOTH), CONSTANT, EVERY, "SIGMA", \
    HELP("standard deviation of the noise of --profile-file, in the unit of the file, m if its columns have units; auto estimates it. The profile " \
         "is then a smoothing spline (default: no noise)")) \
  X(PROFILE_FILE, "profile_file", WORDS("a CSV file with the columns r and gap"), \
    NUMBER, PROFILE, SETS(PROFILE), CONSTANT, EVERY, "FILE", HELP("profile from a CSV file with the columns r and gap, in epsilon")) \
  X(WAVES, "waves", WORDS("A@L;A@L;..., amplitude and wavelength of at most 8 waves, all > 0, or -"), \
    NUMBER, PROFILE, SETS(AMPLITUDE), CONSTANT, EVERY, "A,L", HELP("add a wave of amplitude A and wavelength L, in epsilon; up to 8")) \
  X(SCHEME, "scheme", WORDS("ring, triangle or panel"), NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE, "NAME", \
    HELP("elements that discretise the surface: ring, triangle or panel (default panel)")) \
  X(GRADING, "grading", WORDS("uniform or graded"), NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE, "NAME", \
    HELP("spacing of the nodes, uniform or graded; ring and triangle only (default uniform)")) \
  X(NODES, "nodes", COUNT, NUMBER, MESH, NO_PLACE, CONSTANT, SOLVE, "N", \
    HELP("number of nodes, 8 to 2500; ring and triangle only (default 501)")) \
  X(TOLERANCE, "tolerance", OTHER(POSITIVE, "a number from 1e-10 to 1e-2"), NUMBER, MESH, PLACE(mesh.tolerance), CONSTANT, SERIES, "T", \
    HELP("relative tolerance on the pull-off force, 1e-10 to 0.01; panel only (default 1e-6)")) \
  X(APPROACH_START, "approach_start", ANY_NUMBER, LENGTH, TRACE, PLACE(approach_start), CONSTANT, SOLVE, "D", \
    HELP("approach at which the trace begins, in epsilon (default: chosen by the solver, with the bodies far " \
         "apart)")) \
  X(APPROACH_END, "approach_end", ANY_NUMBER, LENGTH, TRACE, PLACE(approach_end), CONSTANT, SOLVE, "D", \
    HELP("approach at which the trace ends, in epsilon; also the preload if no preload is given (default: the " \
         "trace ends once the preload is reached)")) \
  X(PRELOAD, "preload", FINITE_OR_INFINITE, LENGTH, TRACE, PLACE(preload.approach), CONSTANT, EVERY, "D", \
    HELPS("approach up to which the bodies are loaded before they are pulled off, in epsilon; inf searches all " \
          "preloads for the greatest pull-off force", \
          "approach up to which the bodies are loaded, in epsilon (jkr, guduru, persson-brener)")) \
  X(PRELOAD_LOAD, "preload_load", NOT_NEGATIVE, LOAD, TRACE, PLACE(preload.load), CONSTANT, EVERY, "W", \
    HELPS("load up to which the bodies are loaded, in pi w R; with --preload, loading ends at whichever is reached " \
          "first (default 1, unless a preload or the end of the trace is given as an approach)", \
          "load up to which the bodies are loaded, in pi w R (jkr, guduru, persson-brener): the pull-off after loading to the " \
          "preload along the curve of the theory, with its jumps, and the state at the reversal")) \
  X(STIFFNESS, "stiffness", POSITIVE, STIFFNESS, TRACE, PLACE(stiffness), CONSTANT, SPRING, "K", \
    HELP("stiffness of a spring through which the body is moved, in pi w R/epsilon: --want hysteresis and preload " \
         "then have the loop and the staircase through the spring, too (default: none)")) \
  X(RANGE, "range", WORDS("auto, exact or reduced"), NUMBER, TRACE, NO_PLACE, CONSTANT, SERIES, "NAME", \
    HELP("range of the attraction with which pull-off and loops are found: exact, the true one; reduced, several greater " \
         "ones and their limit; auto, the latter where contact edges are very narrow or the solve fails or is long (default auto)")) \
  X(VISCOELASTIC, "viscoelastic", WORDS(PO_CREEP_EXPECTED), NUMBER, TRACE, NO_PLACE, CONSTANT, EVERY, "MATERIAL", \
    HELPS("viscoelastic half-space, loaded slowly, or at --load-speed, to the preload and unloaded at --unload-speed: sls:K, the standard " \
         "linear solid, gamma:K,N, the Gamma spectrum with the exponent N, or prony:FILE, a table of times and weights of " \
         "the modulus or the compliance; K is the ratio of the relaxed to the glassy modulus, and --tabor belongs to the " \
         "relaxed one (default: elastic)", \
         "viscoelastic half-space (persson-brener): sls:K, gamma:K,N or prony:FILE, as in solve")) \
  X(UNLOAD_SPEED, "unload_speed", NOT_NEGATIVE_OR_INFINITE, NUMBER, TRACE, PLACE(unload_speed), VARIES, EVERY, "V", \
    HELP("speed of unloading of --viscoelastic, in epsilon/tau_0; 0 and inf are the slow and the fast limit")) \
  X(LOAD_SPEED, "load_speed", NOT_NEGATIVE_OR_INFINITE, NUMBER, TRACE, PLACE(load_speed), VARIES, SERIES, "V", \
    HELP("speed of loading of --viscoelastic, in epsilon/tau_0, from a state before any creep with the bodies apart; 0 is " \
         "slow loading, after which the body is relaxed at the preload (default 0)")) \
  X(DWELL, "dwell", NOT_NEGATIVE_OR_INFINITE, NUMBER, TRACE, PLACE(dwell), VARIES, SERIES, "T", \
    HELP("time in tau_0 for which the preload is held after loading at --load-speed: the load, if loading ended there, " \
         "or the approach; inf: until the body is relaxed, as it always is after slow loading and before unloading at " \
         "speed 0 (default inf)")) \
  X(TIME_LIMIT, "time_limit", POSITIVE, NUMBER, TRACE, PLACE(time_limit), CONSTANT, SERIES, "S", \
    HELP("processor time after which a solve is stopped, in seconds (default: no limit)"))

/* Dimensionless groups of these keys, for sweeps, conditions and reference tables. Each sets one
 * key: the wavelength by A R/lambda^2, Eq 6; the amplitude by A/lambda; the outer
 * radius by r_max/R; tabor by w/(E* epsilon). */
#define PO_GROUP_ROWS(X) \
  X(ALPHA, "alpha", POSITIVE, NUMBER, SCENE, SETS(WAVELENGTH), VARIES, NO_VERB, "ALPHA", HELP("A R/L^2")) \
  X(AMPLITUDE_RATIO, "amplitude_ratio", NOT_NEGATIVE, NUMBER, SCENE, SETS(AMPLITUDE), VARIES, FOLLOW, "Q", \
    HELP("amplitude divided by wavelength, instead of --amplitude; constant if the wavelength varies")) \
  X(OUTER_RATIO, "outer_ratio", POSITIVE, NUMBER, SCENE, SETS(OUTER_RADIUS), VARIES, NO_VERB, "Q", \
    HELP("outer radius divided by radius")) \
  X(COUPLING, "coupling", NOT_NEGATIVE, NUMBER, SCENE, SETS(TABOR), VARIES, EVERY, "C", \
    HELP("w/(E* epsilon), >= 0, instead of --tabor"))

/* Keys that readers take beside these, and no document states: the scene in SI units (po_texts.h), and
 * the approach or load of the profile, which no case has. */
#define PO_SI_ROWS(X) \
  X(MODULUS_PA, "modulus_pa", POSITIVE_OR_INFINITE, NUMBER, SI, NO_PLACE, VARIES, EVERY, "E", \
    HELP("contact modulus E* of the two bodies, in Pa; inf is a rigid sphere")) \
  X(YOUNG_PA, "young_pa", MODULI, NUMBER, SI, NO_PLACE, CONSTANT, EVERY, "E1[,E2]", \
    HELP("Young's moduli of the two bodies, in Pa, instead of E*; one number: the other body is rigid")) \
  X(POISSON, "poisson", RATIOS, NUMBER, SI, NO_PLACE, CONSTANT, EVERY, "N1[,N2]", \
    HELP("Poisson's ratio of each body of --young-pa")) \
  X(WORK_J_PER_M2, "work_j_per_m2", POSITIVE, NUMBER, SI, NO_PLACE, VARIES, EVERY, "W", HELP("work of adhesion, in J/m^2")) \
  X(SURFACE_ENERGIES, "surface_energies_j_per_m2", ENERGIES, NUMBER, SI, NO_PLACE, CONSTANT, EVERY, "G1,G2[,G12]", \
    HELP("surface energies of the two bodies and of their interface (default 0), in J/m^2, instead of the work of " \
         "adhesion, which is G1 + G2 - G12")) \
  X(DISTANCE_M, "distance_m", POSITIVE, LENGTH, SI, NO_PLACE, VARIES, EVERY, "EPSILON", HELP("equilibrium distance, in m")) \
  X(RADIUS_M, "radius_m", RADII, LENGTH, SI, SETS(RADIUS), VARIES, EVERY, "R1[,R2]", \
    HELP("radius of the sphere, or of two spheres, in m; may be missing for other profiles")) \
  X(AMPLITUDE_M, "amplitude_m", NOT_NEGATIVE, LENGTH, SI, SETS(AMPLITUDE), VARIES, EVERY, "A", HELP("amplitude of the waviness, in m")) \
  X(WAVELENGTH_M, "wavelength_m", POSITIVE, LENGTH, SI, SETS(WAVELENGTH), VARIES, EVERY, "L", \
    HELP("wavelength of the waviness, in m")) \
  X(OUTER_RADIUS_M, "outer_radius_m", POSITIVE_OR_INFINITE, LENGTH, SI, SETS(OUTER_RADIUS), VARIES, SERIES, "R", \
    HELP("radius at which the elastic surface is cut, in m")) \
  X(APPROACH_START_M, "approach_start_m", ANY_NUMBER, LENGTH, SI, SETS(APPROACH_START), CONSTANT, SOLVE, "D", \
    HELP("approach at which the trace begins, in m")) \
  X(APPROACH_END_M, "approach_end_m", ANY_NUMBER, LENGTH, SI, SETS(APPROACH_END), CONSTANT, SOLVE, "D", \
    HELP("approach at which the trace ends, in m")) \
  X(PRELOAD_M, "preload_m", FINITE_OR_INFINITE, LENGTH, SI, SETS(PRELOAD), CONSTANT, EVERY, "D", \
    HELP("approach up to which the bodies are loaded, in m")) \
  X(PRELOAD_LOAD_N, "preload_load_n", NOT_NEGATIVE, LOAD, SI, SETS(PRELOAD_LOAD), CONSTANT, EVERY, "F", \
    HELP("load up to which the bodies are loaded, in N")) \
  X(STIFFNESS_N_PER_M, "stiffness_n_per_m", POSITIVE, STIFFNESS, SI, SETS(STIFFNESS), CONSTANT, SPRING, "K", \
    HELP("stiffness of the spring through which the body is moved, in N/m")) \
  X(RELAXATION_TIME_S, "relaxation_time_s", POSITIVE, NUMBER, SI, NO_PLACE, CONSTANT, EVERY, "TAU", \
    HELP("time tau_0 of --viscoelastic, in s: that of creep under a held load; the modulus of sls:K relaxes in K tau_0")) \
  X(UNLOAD_SPEED_M_PER_S, "unload_speed_m_per_s", NOT_NEGATIVE_OR_INFINITE, NUMBER, SI, SETS(UNLOAD_SPEED), VARIES, \
    EVERY, "V", HELP("speed of unloading of --viscoelastic, in m/s; needs --relaxation-time-s, unless the " \
         "times of a table are in s")) \
  X(LOAD_SPEED_M_PER_S, "load_speed_m_per_s", NOT_NEGATIVE_OR_INFINITE, NUMBER, SI, SETS(LOAD_SPEED), VARIES, \
    SERIES, "V", HELP("speed of loading of --viscoelastic, in m/s")) \
  X(DWELL_S, "dwell_s", NOT_NEGATIVE_OR_INFINITE, NUMBER, SI, SETS(DWELL), VARIES, SERIES, "T", \
    HELP("time for which the preload is held, in s"))

#define PO_TEXTS_ROWS(X) PO_SI_ROWS(X) \
  X(PROFILE_APPROACH, "profile_approach", ANY_NUMBER, LENGTH, TRACE, PLACE(profile_approach), CONSTANT, NO_VERB, "D", \
    HELP("approach at which the profile is taken, in epsilon (default: that of the pull-off)")) \
  X(PROFILE_APPROACH_M, "profile_approach_m", ANY_NUMBER, LENGTH, SI, SETS(PROFILE_APPROACH), CONSTANT, NO_VERB, "D", \
    HELP("approach at which the profile is taken, in m")) \
  X(PROFILE_LOAD, "profile_load", ANY_NUMBER, LOAD, TRACE, PLACE(profile_load), CONSTANT, NO_VERB, "W", \
    HELP("load at which the profile is taken, in pi w R: where the branch first has it, which for W >= 0 is the state " \
         "that loading at given load reaches")) \
  X(PROFILE_LOAD_N, "profile_load_n", ANY_NUMBER, LOAD, SI, SETS(PROFILE_LOAD), CONSTANT, NO_VERB, "F", \
    HELP("load at which the profile is taken, in N"))

/* The variables of closed forms. */
#define PO_VARIABLE_ROWS(X) \
  X(LOAD, "load", ANY_NUMBER, LOAD, TRACE, NO_PLACE, CONSTANT, PO_FOR_THEORY, "W", \
    HELP("the stable state at this load, in pi w R, < 0 in tension: that of unloading after the preload, or from " \
         "the hardest one (jkr, dmt, maugis, guduru)")) \
  X(APPROACH, "approach", ANY_NUMBER, LENGTH, TRACE, NO_PLACE, CONSTANT, PO_FOR_THEORY, "D", \
    HELP("the same at this approach, in epsilon; the load of rigid bodies, for D < 1 (bradley, rigid)")) \
  X(CONTACT_RADIUS, "contact_radius", NOT_NEGATIVE, LENGTH, TRACE, NO_PLACE, CONSTANT, PO_FOR_THEORY, "A", \
    HELP("load and approach at this contact radius, in epsilon, stable or not (jkr, dmt, maugis, guduru, " \
         "kesari-lew)")) \
  X(LOAD_N, "load_n", ANY_NUMBER, LOAD, SI, SETS(LOAD), CONSTANT, PO_FOR_THEORY, "F", \
    HELP("the stable state at this load, in N")) \
  X(APPROACH_M, "approach_m", ANY_NUMBER, LENGTH, SI, SETS(APPROACH), CONSTANT, PO_FOR_THEORY, "D", \
    HELP("the state at this approach, in m")) \
  X(CONTACT_RADIUS_M, "contact_radius_m", NOT_NEGATIVE, LENGTH, SI, SETS(CONTACT_RADIUS), CONSTANT, PO_FOR_THEORY, "A", \
    HELP("load and approach at this contact radius, in m"))
// clang-format on

#endif
