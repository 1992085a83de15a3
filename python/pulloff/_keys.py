"""The keys of a scene, for type checkers and editors. This file is made of the keys of the library: after a change of
them, python3 tests/python/keys.py --write makes it anew."""

from typing import TypedDict

from ._values import Energies, Name, Names, Number, Pair, Path, Waves


class Keys(TypedDict, total=False):
    tabor: Number
    amplitude: Number
    wavelength: Number
    radius: Number
    outer_radius: Number
    law: Name
    mie_m: Number
    mie_n: Number
    morse_a: Number
    profile: Name
    power_c: Number
    power_n: Number
    cone_t: Number
    punch_b: Number
    punch_r: Number
    truncated_b: Number
    truncated_r: Number
    exact_sphere_r: Number
    hyperboloid_t: Number
    hyperboloid_b: Number
    table_scale: Number
    smooth: Number
    profile_file: Path
    waves: Waves
    scheme: Name
    grading: Name
    nodes: Number
    tolerance: Number
    approach_start: Number
    approach_end: Number
    preload: Number
    preload_load: Number
    stiffness: Number
    range: Name
    viscoelastic: Name
    unload_speed: Number
    load_speed: Number
    dwell: Number
    time_limit: Number
    alpha: Number
    amplitude_ratio: Number
    outer_ratio: Number
    coupling: Number
    modulus_pa: Number
    young_pa: Pair
    poisson: Pair
    work_j_per_m2: Number
    surface_energies_j_per_m2: Energies
    distance_m: Number
    radius_m: Pair
    amplitude_m: Number
    wavelength_m: Number
    outer_radius_m: Number
    approach_start_m: Number
    approach_end_m: Number
    preload_m: Number
    preload_load_n: Number
    stiffness_n_per_m: Number
    relaxation_time_s: Number
    unload_speed_m_per_s: Number
    load_speed_m_per_s: Number
    dwell_s: Number
    profile_approach: Number
    profile_approach_m: Number
    profile_load: Number
    profile_load_n: Number
    want: Names
