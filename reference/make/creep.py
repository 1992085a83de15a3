"""Creep of a linear viscoelastic half-space, and the theory of Persson and Brener for the edge of a crack.

The compliance is J(t) = 1 - (1 - k) phi(t) over that of the relaxed solid, with k the relaxed over the glassy modulus,
phi = sum_m w_m exp(-t/tau_m), sum_m w_m = 1. Times are in tau_0.

    sls       the standard linear solid: one term, tau = 1
    gamma:n   phi = (1/Gamma(n)) int_0^inf tau^(n-1) exp(-tau) exp(-t/tau) dtau
    terms:tau_1@w_1;tau_2@w_2   a series, w_1 + w_2 + ... = 1

A table of a material (cases/materials) has such a series of the compliance, or one of the modulus, which is converted.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import gamma

LONGEST = 3.6             # ln tau of the last term of a Gamma spectrum: exp(-exp(3.6)) = 1e-16
SPACING = 0.5             # of its terms in ln tau. The trapezoidal rule has an error of exp(-pi^2/spacing) = 3e-9
SHORTEST = 1e-6           # its shortest time, in the time in which the base moves by epsilon; shorter ones are lumped


@dataclass(frozen=True)
class Creep:
    """The terms: k, times, and the compliances (1 - k) w_m."""
    k: float
    times: np.ndarray
    parts: np.ndarray


def series(text):
    """The times and weights of `tau_1@w_1;tau_2@w_2`."""
    times, weights = np.array([[float(number) for number in term.split("@")] for term in text.split(";")]).T
    if not (np.all(times > 0.0) and np.all(weights > 0.0) and abs(weights.sum() - 1.0) < 1e-12):
        raise ValueError(f"series {text}: expected times > 0, and weights > 0 with the sum 1")
    return times, weights


def measured(path):
    """The spectrum and k of a table: times with weights of the compliance and the instantaneous one, or of the modulus and
    the relaxed one."""
    lines = [line.split(",") for line in path.read_text().splitlines() if not line.startswith("#")]
    kind, numbers = lines[0][1], np.array(lines[1:], dtype=float)
    limit = np.isin(numbers[:, 0], (0.0, np.inf))
    (_, alone), (times, weights) = *numbers[limit], numbers[~limit].T
    k = float(alone / (alone + weights.sum()))
    if kind == "modulus":
        # s times the Laplace transform of the modulus is N(s)/prod (1 + tau s). The zeros of N are -1/tau of the compliance;
        # the weights follow from the residues there of the inverse.
        poles = np.poly1d(1.0)
        for time in times:
            poles = poles * np.poly1d([time, 1.0])
        zeros = poles * alone
        for time, weight in zip(times, weights):
            zeros = zeros + np.poly1d([weight * time, 0.0]) * np.poly1d(np.polydiv(poles.coeffs, [time, 1.0])[0])
        at = np.sort(zeros.roots.real)
        times, weights = -1.0 / at, alone * poles(at) / (at * zeros.deriv()(at))
    weights = weights / weights.sum()
    return "terms:" + ";".join(f"{time:.17g}@{weight:.17g}" for time, weight in zip(times, weights)), k


def creep(spectrum, k, speed, refine=1.0):
    """The terms of a spectrum that matter at a speed of the base, in epsilon/tau_0."""
    if not 0.0 < k <= 1.0:
        raise ValueError(f"k = {k:g}: expected 0 < k <= 1")
    if spectrum == "sls":
        return Creep(k, np.ones(1), np.full(1, 1.0 - k))
    name, _, exponent = spectrum.partition(":")
    if name == "terms":
        times, weights = series(exponent)
        return Creep(k, times, (1.0 - k) * weights)
    if name != "gamma":
        raise ValueError(f"spectrum {spectrum}: expected sls, gamma:n or terms:tau@w;...")
    n, spacing = float(exponent), SPACING / refine
    shortest = np.log(min(SHORTEST / refine**10 / speed, 1e-3))
    log = LONGEST - spacing * np.arange(int(np.ceil((LONGEST - shortest) / spacing)) + 1)
    times = np.exp(log)
    weights = spacing * times**n * np.exp(-times) / gamma(n)
    weights[-1] = max(weights[-1], 1.0 - weights[:-1].sum())
    return Creep(k, times, (1.0 - k) * weights / weights.sum())


def persson_brener(spectrum, k, speed):
    """Gamma/w of Persson and Brener: Gamma = 1/(1 - (1 - k) S), S the mean of sqrt(1 + y^2) - y over the spectrum,
    y = Gamma/(2 pi speed tau), speed of the crack in its length at rest per tau_0."""

    def mean(gain):
        x = gain / (2.0 * np.pi * speed)
        if spectrum == "sls":
            return np.hypot(1.0, x) - x
        if spectrum.startswith("terms:"):
            times, weights = series(spectrum.partition(":")[2])
            return weights @ (np.hypot(1.0, x / times) - x / times)
        n = float(spectrum.partition(":")[2])

        def part(s):
            y = x * np.exp(-s)
            return np.exp(n * s - np.exp(s)) / (np.hypot(1.0, y) + y)

        low = -40.0 / n
        points = sorted({min(max(p, low), 5.0) for p in (np.log(x), 0.0)})
        return quad(part, low, 5.0, points=points, epsabs=1e-14, epsrel=1e-12, limit=400)[0] / gamma(n)

    return brentq(lambda gain: gain * (1.0 - (1.0 - k) * mean(gain)) - 1.0, 1.0 - 1e-9, (1.0 + 1e-9) / k, xtol=1e-15,
                  rtol=1e-14)
