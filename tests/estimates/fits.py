"""Whether the standard errors of fitted force curves hold: the same curve with other noise, fitted again and again.

    PULLOFF_LIBRARY=build/src/library/libpulloff.so python3 tests/estimates/fits.py --count 200 --case soft

A curve of known values is made by the program and given normal noise. Prints of each value by how many of its standard errors the
fits are off: how many within one, two and three (68, 95 and 99.7 % of normal errors), mean and standard deviation; the greatest
relative error of w; and the processor time of a fit. Cases: a soft sample of a sphere of 45 nm (`soft`), the same with a paraboloid
(`paraboloid`), a sphere through a lever (`stiff`). Exits with 1 if fewer than 60 % are within one or 90 % within two standard errors
of a value."""

import argparse
import pathlib
import sys
import time

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TREE / "python"), str(TREE / "tests" / "python")]

from pulloff import fit  # noqa: E402
from test_fit import SOFT, STIFF, measured  # noqa: E402

CASES = {"soft": (SOFT, (0.05, 0.7, -300, 2), True), "paraboloid": (SOFT, (0.05, 0.7, -300, 2), False),
         "stiff": (STIFF, (0.04, 0.1, -60, 9), False)}
LEAST = 0.60, 0.90      # shares within one and two standard errors, of 200 fits far below those of normal errors


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--case", choices=CASES, default="soft")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=1, help="seed of the first curve")
    parser.add_argument("--minutes", type=float, default=np.inf, help="no fit is begun later than this")
    wanted = parser.parse_args()
    case, shape, sphere = CASES[wanted.case]
    truth, off, seconds, end = np.array(case[2]), [], [], time.monotonic() + 60 * wanted.minutes
    for seed in range(wanted.first, wanted.first + wanted.count):
        if time.monotonic() > end:
            break
        z, into, out = measured(case, *shape, seed, sphere)
        begin = time.process_time()
        try:
            found, _ = fit.fit_shapes(fit.curve_of(z, into, z, out), *case[:2])
        except fit.NoFit as error:
            print(f"seed {seed}: no fit: {error}", flush=True)
            off.append(np.full(6, np.inf))
            continue
        seconds.append(time.process_time() - begin)
        off.append(np.array([*(found.values - truth) / found.errors, found.values[0] / truth[0] - 1]))
        print(f"seed {seed}: w {found.values[0]:.6g}, chi2/n {found.chi2:.3f}, off by", *(f"{value:.2f}" for value in off[-1][:5]),
              f"standard errors; {seconds[-1]:.1f} s", flush=True)
    off = np.array(off)
    shares = [np.mean(abs(off[:, :5]) < bound, axis=0) for bound in (1, 2, 3)]
    for number, name in enumerate(fit.NAMES):
        print(f"{name:18} within one {shares[0][number]:.3f}, two {shares[1][number]:.3f}, three {shares[2][number]:.3f}; "
              f"mean {off[:, number].mean():+.2f}, deviation {off[:, number].std():.2f}")
    print(f"{len(off)} fits; w off by at most {100 * abs(off[:, 5]).max():.2g} %; processor time of a fit: median {np.median(seconds):.1f} s, "
          f"greatest {max(seconds):.1f} s (branches that an earlier fit solved are not solved again)")
    return 0 if shares[0].min() >= LEAST[0] and shares[1].min() >= LEAST[1] else 1


if __name__ == "__main__":
    sys.exit(main())
