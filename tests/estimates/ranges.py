"""Whether the pull-off by greater ranges of the attraction is that of the true range, within the stated errors.

    python3 tests/estimates/ranges.py build/src/cli/pulloff --count 300 --seed 1

Draws soft wavy spheres: Tabor parameters of 10 to 10^4, R/epsilon of 10^4 to 10^7, wavelengths of 0.13 to 3 sqrt(R mu), A R/lambda^2
of 0.05 to 5 and preloads of 0.1 to 10 pi w R, all uniform in their logarithm. Each scene is solved with both ranges, and with the
default if these do not apply. Prints how many were solved, the stated error over the difference, and every violation. With --solved
only the default is solved, and its times are printed. With --loops the energies lost in loops are compared, too, with --staircases
the numbers of the steps that greater ranges state. With --minutes, scenes that are not begun by then are left out."""

import argparse
import concurrent.futures
import json
import math
import subprocess
import sys
import time

from draw import between, uniform

RANGES = {"tabor": (10, 1e4), "radius": (1e4, 1e7), "length": (0.13, 3), "alpha": (0.05, 5), "load": (0.1, 10)}
SMALL = {"tabor": (20, 400), "radius": (1e4, 3e5), "length": (0.2, 3)}


def scene(seed, index, ranges):
    tabor, radius, length, alpha, load = (between(bounds, uniform(seed, index, name)) for name, bounds in ranges.items())
    wavelength = float(f"{length * math.sqrt(radius * tabor):.6g}")
    amplitude = float(f"{alpha * wavelength**2 / radius:.6g}")
    return {"tabor": tabor, "radius": radius, "amplitude": amplitude, "wavelength": wavelength, "preload-load": load}


def solve(program, flags, kind, wanted):
    if wanted.loops or wanted.staircases:
        flags = {**flags, "want": "hysteresis" if wanted.loops else "preload"}
    words = [word for name, value in {**flags, "range": kind, "tolerance": wanted.tolerance, "time-limit": wanted.time_limit}.items()
             for word in (f"--{name}", str(value))]
    return json.loads(subprocess.run([program, "solve", "--json", *words], capture_output=True, text=True, check=False).stdout)


def compare(index, flags, exact, reduced):
    """The stated error over the difference; a line if it is violated."""
    one, two = exact["pull_off"], reduced["pull_off"]
    stated = one["error_estimate"] + two["error_estimate"]
    apart = abs(one["force"] - two["force"])
    if apart > stated:
        print(f"scene {index}: {one['force']:.10g} and {two['force']:.10g}, stated {stated:.1e}: {flags}")
    return stated / max(apart, 1e-16)


def losses(document):
    """The energies lost in the loop at given approach and in its jumps, with their errors."""
    loop = document["hysteresis"]["displacement_control"]
    return [(part["energy_lost"], part["energy_lost_error_estimate"]) for part in (loop, *loop["jumps"])]


def numbers(step):
    """The numbers of a step with their errors; those of an unknown error, or none, are left out."""
    begin, first = step["preload"], step["cycles"][0]
    found = {"force": (step["force"], step["error_estimate"]), "approach": (step["approach"], step["approach_error_estimate"]),
             "first approach": (begin["approach"], begin["error_estimate"]), "first load": (begin["load"], begin["load_error_estimate"]),
             "energy lost": (first["energy_lost"], first["energy_lost_error_estimate"])}
    return {name: pair for name, pair in found.items() if None not in pair}


def compare_staircases(index, flags, exact, reduced):
    """The stated errors over the differences of the steps at given approach, whose numbers are those of the step of the nearest force."""
    factors = []
    steps = exact["staircase"]["displacement_control"]["steps"]
    for step in reduced["staircase"]["displacement_control"]["steps"]:
        near = min(steps, key=lambda other: abs(other["force"] - step["force"]))
        others = numbers(near)
        for name, (value, error) in numbers(step).items():
            if name not in others:
                continue
            factors.append((error + others[name][1]) / max(abs(value - others[name][0]), 1e-16))
            if factors[-1] < 1:
                print(f"scene {index}, {name} of a step: {others[name][0]:.10g} +- {others[name][1]:.1e} and {value:.10g} +- {error:.1e}: {flags}")
    return factors


def compare_losses(index, flags, exact, reduced):
    """The stated errors over the differences; a line for each that is violated. Loops with other jumps lose another energy."""
    one, two = losses(exact), losses(reduced)
    if len(one) != len(two):
        print(f"scene {index}: {len(one) - 1} and {len(two) - 1} jumps: {flags}")
        one, two = one[:1], two[:1]
    factors = []
    for number, ((lost, error), (limit, bound)) in enumerate(zip(one, two)):
        factors.append((error + bound) / max(abs(lost - limit), 1e-16))
        if factors[-1] < 1:
            print(f"scene {index}, {f'jump {number}' if number else 'loop'}: {lost:.10g} +- {error:.1e} and {limit:.10g} +- {bound:.1e}: "
                  f"{flags}")
    return factors


def summary(what, factors):
    print(f"{len(factors)} {what}, {sum(factor < 1 for factor in factors)} violated; stated over true: least {factors[0]:.2g}, median "
          f"{factors[len(factors) // 2]:.2g}, greatest {factors[-1]:.2g}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerance", type=float, default=1e-4)
    parser.add_argument("--time-limit", type=float, default=20)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--small", action="store_true", help="less soft and less large spheres: most are solved with both ranges")
    parser.add_argument("--solved", action="store_true")
    parser.add_argument("--loops", action="store_true")
    parser.add_argument("--staircases", action="store_true")
    parser.add_argument("--minutes", type=float, default=math.inf, help="no scene is begun later than this (no limit)")
    wanted = parser.parse_args()
    kinds = ["auto"] if wanted.solved else ["exact", "reduced"]
    scenes = [scene(wanted.seed, index, {**RANGES, **(SMALL if wanted.small else {})}) for index in range(wanted.count)]
    end = time.monotonic() + 60.0 * wanted.minutes

    def solve_all(flags):
        return [solve(wanted.program, flags, kind, wanted) for kind in kinds] if time.monotonic() < end else None

    with concurrent.futures.ThreadPoolExecutor(wanted.jobs) as pool:
        found = [results for results in pool.map(solve_all, scenes) if results]
    if not found:
        print("no scene was begun")
        return 3
    for kind, results in zip(kinds, zip(*found)):
        seconds = sorted(document["work"]["seconds"] for document in results)
        statuses = [document["status"] for document in results]
        print(f"{kind}: {', '.join(f'{statuses.count(name)} {name}' for name in sorted(set(statuses)))}; "
              f"{sum('range' in document for document in results)} by greater ranges; seconds: median "
              f"{seconds[len(seconds) // 2]:.2f}, greatest {seconds[-1]:.1f}")
    if wanted.solved:
        for index, (document,) in enumerate(found):
            if document["status"] != "ok":
                print(f"scene {index}: {document['reason']}: {scenes[index]}")
        return 0
    both = [(index, *pair) for index, pair in enumerate(found) if all(document["status"] == "ok" for document in pair)]
    factors = sorted(compare(index, scenes[index], *pair) for index, *pair in both)
    if not factors:
        print("no scene was solved with both ranges")
        return 3
    summary("scenes with both ranges", factors)
    other = compare_losses if wanted.loops else compare_staircases if wanted.staircases else None
    more = sorted(factor for index, *pair in both for factor in other(index, scenes[index], *pair)) if other else []
    if more:
        summary("energies lost in loops and jumps" if wanted.loops else "numbers of steps", more)
    return 1 if min([factors[0], *more[:1]]) < 1 else 0


if __name__ == "__main__":
    sys.exit(main())
