"""Which waviness holds best? The pull-off force of a sphere of 12.5 mm on gelatin after a preload of 2 mN, over amplitude and
wavelength, and over two waves; beside what Eq 5 and Kesari and Lew (Eq 24) advise. Usage: waviness.py FIGURE

The results are in waviness.csv; a few of them are computed again and compared. With --search in place of FIGURE the search is
continued: one, two, wide, then last, in half an hour; what is in the file is not computed again."""
import csv
import pathlib
import sys

import numpy as np
from matplotlib import pyplot
from scipy.optimize import differential_evolution, minimize, minimize_scalar

import pulloff

SPHERE = {"modulus_pa": 0.7e6, "work_j_per_m2": 0.03, "radius_m": 0.0125}
TRUE, SEARCHED, SMALLER = 30.0, 300.0, 3.0  # range of the attraction, nm: the search takes the greater one, which costs a tenth of the time
MILLI = np.pi * SPHERE["work_j_per_m2"] * SPHERE["radius_m"] * 1e3  # pi w R, mN
PRELOAD, WEAKER = 2.0, 1.6  # mN
WAVELENGTHS, AMPLITUDES = np.geomspace(150, 1500, 14), np.geomspace(0.7, 20, 13)  # of the map, um
THEORIES = ("Eq 5", "Eq 5 where it can be", "Kesari and Lew")
STORE = pathlib.Path(__file__).with_name("waviness.csv")
COLUMNS = ("waves_um", "preload_mN", "range_nm", "force_mN", "error_mN", "status")


def name_of(waves):
    return ";".join(f"{amplitude:.5g}@{wavelength:.5g}" for amplitude, wavelength in waves)


def metres(waves):
    """The waves as a scene takes them, with the digits that the file has."""
    return [tuple(1e-6 * float(number) for number in wave.split("@")) for wave in name_of(waves).split(";")]


def solve(waves, preload, nanometres):
    """Force and error in mN, and the status. A solve that fails has no force: nan, never 0."""
    try:
        result = pulloff.solve(**SPHERE, distance_m=1e-9 * nanometres, waves=metres(waves), preload_load_n=1e-3 * preload,
                               tolerance=1e-3, time_limit=60, range="exact")
        return MILLI * result.pull_off.force, MILLI * result.pull_off.force_error, "ok"
    except pulloff.SolveError as error:
        return np.nan, np.nan, error.result.status


def stored():
    with STORE.open() as file:
        return {(row["waves_um"], float(row["preload_mN"]), float(row["range_nm"])):
                (float(row["force_mN"]), float(row["error_mN"]), row["status"]) for row in csv.DictReader(file)}


def force(waves, preload=PRELOAD, nanometres=SEARCHED):
    """The force in mN, nan of a failed solve, from the file, in which a new result is put."""
    key = (name_of(waves), preload, nanometres)
    known = stored()
    if key not in known:
        known[key] = solve(waves, preload, nanometres)
        with STORE.open("a") as file:
            file.write(",".join((key[0], f"{preload:g}", f"{nanometres:g}", *(f"{number:.7g}" for number in known[key][:2]), known[key][2])) + "\n")
        print(*key, *known[key], flush=True)
    return known[key][0]


def eq_5(waves, preload=PRELOAD):
    """What Eq 5 says after the preload, in mN, and whether its state at the reversal can be."""
    found = pulloff.theory("jkr", **SPHERE, distance_m=1e-9 * TRUE, waves=metres(waves), preload_load_n=1e-3 * preload)
    return (MILLI * found["after_preload_force"],
            found["reversal_least_gap"] >= 0 and found["reversal_load"] * MILLI <= preload * (1 + 1e-9))


def edge(wavelength, amplitude, preload=PRELOAD, part=0.01, nanometres=SEARCHED):
    """The greatest amplitude, to a part of it, from which on the preload no longer closes the grooves: up to there the force
    grows with the amplitude, and beyond it falls. Given: an amplitude below. Returned: it, and its force."""
    low, high = amplitude, None
    held = force([(low, wavelength)], preload, nanometres)
    while high is None or high / low > 1 + part:
        middle = 1.15 * low if high is None else np.sqrt(low * high)
        there = force([(middle, wavelength)], preload, nanometres)
        if there > held:
            low, held = middle, there
        else:
            high = middle
    return low, held


def search_one():
    """The map, then the edge of closed grooves along the wavelength: with the greater range, and near its best with the true one,
    as the cliffs are elsewhere then."""
    grid = [(force([(a, w)]), a, w) for w in WAVELENGTHS for a in AMPLITUDES]
    _, amplitude, wavelength = max(cell for cell in grid if cell[0] == cell[0])
    step = WAVELENGTHS[1] / WAVELENGTHS[0]
    for nanometres, tries in ((SEARCHED, 10), (TRUE, 7)):
        best = minimize_scalar(lambda logarithm: -edge(np.exp(logarithm), 0.9 * amplitude, nanometres=nanometres)[1],
                               method="bounded", bounds=np.log([wavelength / step, wavelength * step]),
                               options={"xatol": 0.01, "maxiter": tries})
    wavelength = np.exp(best.x)
    for preload in (PRELOAD, WEAKER):
        edge(wavelength, 0.9 * amplitude, preload, 0.002, TRUE)
        for factor in (0.4, 0.6, 0.8, 0.9, 1.15, 1.3):
            force([(factor * amplitude, wavelength)], preload, TRUE)


def loss(x):
    """Of two waves, from the logarithms of their numbers; a failed solve is worse than any."""
    found = force(np.exp(x).reshape(2, 2))
    return -found if found == found else np.inf


def search_two(starts=((6, 620, 1, 310), (4, 500, 1, 250), (6, 620, 1, 900), (6, 620, 3, 450)), most=90):
    """A second wave beside the first one, from several starts; the cliff of open grooves stops a search, and it starts again
    from its best point."""
    for start in starts:
        minimize(loss, np.log(start), method="Nelder-Mead",
                 options={"initial_simplex": np.log(start) + np.vstack([np.zeros(4), np.diag([0.1, 0.1, 0.4, -0.2])]),
                          "maxfev": most, "xatol": 0.01, "fatol": 0.01})


def search_wide():
    """Two waves, from everywhere."""
    differential_evolution(loss, [(0, np.log(12)), (np.log(200), np.log(900))] * 2, popsize=8, maxiter=10, seed=1, polish=False)


def waves_of(name):
    return [tuple(float(number) for number in wave.split("@")) for wave in name.split(";")]


def best_of(known, waves, preload=PRELOAD, nanometres=TRUE):
    """The designs with so many waves, and their forces, from the best one on; failed solves have none."""
    found = [(result[0], name) for (name, load, reach), result in known.items()
             if name.count("@") == waves and (load, reach) == (preload, nanometres) and result[0] == result[0]]
    return [(value, waves_of(name)) for value, name in sorted(found, reverse=True)]


def search_last():
    """Pairs of waves that were good with the greater range, with the true one; the best designs with less preload and another
    amplitude; the designs that the theories advise."""
    for _, pair in best_of(stored(), 2, nanometres=SEARCHED)[:60:4]:
        force(pair, nanometres=TRUE)
    for waves, factors in ((1, (0.98, 1.0, 1.02)), (2, (1.0,))):
        design = best_of(stored(), waves)[0][1]
        for factor, preload in [(factor, preload) for factor in factors for preload in (PRELOAD, WEAKER)]:
            force([(factor * amplitude, wavelength) for amplitude, wavelength in design], preload, TRUE)
        force(design, nanometres=SEARCHED)
        force(design, nanometres=SMALLER)
    for _, design in advice():
        for preload in (PRELOAD, WEAKER):
            force([design], preload, TRUE)


def advice():
    """The best of the map according to Eq 5 after the preload; to Eq 5 where its own state at the reversal can be: the preload is
    not passed by a jump, and the surfaces do not overlap; to Kesari and Lew. Of each: the force in mN, and the design."""
    grid = [(a, w) for w in WAVELENGTHS for a in AMPLITUDES]
    values = {design: eq_5([design]) for design in grid}
    envelope = {(a, w): MILLI * pulloff.theory("kesari-lew", **SPHERE, distance_m=1e-9 * TRUE, amplitude_m=1e-6 * a,
                                               wavelength_m=1e-6 * w)["pull_off_force"] for a, w in grid}
    return [(max(table.values()), max(table, key=table.get)) for table in (
        {design: value for design, (value, _) in values.items()},
        {design: value for design, (value, can_be) in values.items() if can_be}, envelope)]


def check(known):
    """Some of the stored results are computed again: the best designs, failures, and a few others."""
    again = [(name_of(best_of(known, waves, preload, reach)[0][1]), preload, reach)
             for waves, preload, reach in ((1, PRELOAD, TRUE), (1, WEAKER, SEARCHED), (2, PRELOAD, SEARCHED)) if best_of(known, waves, preload, reach)]
    again += list(known)[7:180:57]
    for name, preload, nanometres in again:
        found, before = solve(waves_of(name), preload, nanometres), known[name, preload, nanometres]
        if found[2] != before[2] or not np.isclose(found[0], before[0], rtol=1e-6, equal_nan=True):
            sys.exit(f"{name} at {preload} mN, {nanometres} nm: {found}, but in {STORE.name} {before}")
    print(f"{len(again)} results computed again: as in {STORE.name}")


def along(known, wavelength, preload, nanometres=TRUE):
    """Amplitudes and forces at a wavelength."""
    return sorted((waves_of(name)[0][0], result[0]) for (name, load, reach), result in known.items()
                  if (load, reach) == (preload, nanometres) and name.count("@") == 1 and waves_of(name)[0][1] == wavelength)


def report(known, advised):
    def at(waves, preload=PRELOAD, nanometres=TRUE):
        return known[name_of(waves), preload, nanometres]

    smooth = 1.5 * MILLI
    print(f"{len(known)} solves, {sum(result[2] != 'ok' for result in known.values())} failed; smooth sphere {smooth:.4f} mN")
    for waves in (1, 2):
        value, design = best_of(known, waves)[0]
        print(f"{waves} wave{'s' * (waves > 1)}: {value:.4f} +- {at(design)[1]:.0e} mN, {value / smooth:.2f} times, amplitude@wavelength "
              f"{name_of(design)} um; after {WEAKER} mN {at(design, WEAKER)[0]:.4f}; with a range of "
              + ", ".join(f"{reach:g} nm {at(design, nanometres=reach)[0]:.4f} ({at(design, nanometres=reach)[2]})" for reach in (SEARCHED, SMALLER)))
    design = best_of(known, 1)[0][1]
    for factor in (0.98, 1.02):
        scaled = [(factor * amplitude, wavelength) for amplitude, wavelength in design]
        print(f"  {factor:.2f} of the amplitude: {at(scaled)[0]:.4f} mN")
    for who, (value, design) in zip(THEORIES, advised):
        print(f"{who} advises {name_of([design])} um: {value:.2f} mN; it holds {at([design])[0]:.4f}, after {WEAKER} mN "
              f"{at([design], WEAKER)[0]:.4f}")


def draw(known, advised, file):
    value, ((amplitude, wavelength),) = best_of(known, 1)[0]
    values = np.array([[known[name_of([(a, w)]), PRELOAD, SEARCHED][0] for w in WAVELENGTHS] for a in AMPLITUDES])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(8.4, 3.6), constrained_layout=True)
    shown = left.pcolormesh(WAVELENGTHS, AMPLITUDES, np.ma.masked_invalid(values), cmap="viridis", shading="nearest")
    failed = np.argwhere(np.isnan(values))
    left.plot(WAVELENGTHS[failed[:, 1]], AMPLITUDES[failed[:, 0]], "x", color="tab:red")
    left.plot(wavelength, amplitude, "*", color="tab:red", markersize=13, markeredgecolor="white", label="best")
    for (_, design), mark, who in zip(advised, "^sv", THEORIES):
        left.plot(design[1], design[0], mark, color="white", markeredgecolor="black", label=who, clip_on=False)
    left.set(xscale="log", yscale="log", xlabel="wavelength / µm", ylabel="amplitude / µm", title=f"after {PRELOAD:g} mN")
    left.minorticks_off()
    left.set_xticks([150, 300, 600, 1200], ["150", "300", "600", "1200"])
    left.set_yticks([1, 3, 10], ["1", "3", "10"])
    left.legend(fontsize=7, loc="lower right")
    figure.colorbar(shown, ax=left, label="pull-off force / mN")
    for preload, mark, colour in ((PRELOAD, "o", "tab:blue"), (WEAKER, "x", "tab:orange")):
        right.plot(*zip(*along(known, wavelength, preload)), mark, color=colour, markersize=4, label=f"after {preload:g} mN")
    fine = np.linspace(0.3 * amplitude, 1.4 * amplitude, 40)
    right.plot(fine, [eq_5([(a, wavelength)])[0] for a in fine], ":", color="black", linewidth=1, label="Eq 5 after 2 mN")
    right.axhline(1.5 * MILLI, color="0.6", linewidth=0.8, label="smooth")
    right.axhline(best_of(known, 2)[0][0], color="tab:red", linewidth=0.8, label="two waves")
    right.set(xlabel="amplitude / µm", ylabel="pull-off force / mN", title=f"wavelength {wavelength:.0f} µm")
    right.legend(fontsize=7, loc="center right")
    figure.savefig(file, dpi=90)


if __name__ == "__main__" and sys.argv[1] == "--search":
    if not STORE.exists():
        STORE.write_text(",".join(COLUMNS) + "\n")
    {"one": search_one, "two": search_two, "wide": search_wide, "last": search_last}[sys.argv[2]]()
elif __name__ == "__main__":
    results = stored()
    check(results)
    advised = advice()
    report(results, advised)
    draw(results, advised, sys.argv[1])
