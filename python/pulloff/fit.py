"""A measured force curve of a sphere on a flat: work of adhesion w, range eps of the attraction, modulus E*, and the zeros of the
instrument, with standard errors; beside it what JKR, DMT and Maugis-Dugdale make of the same data.

    python3 -m pulloff.fit CURVE.csv --radius-m R [--stiffness-n-per-m K] ...       (or: pulloff fit CURVE.csv ...)

The model is the full traction-separation law, through the cantilever: both stable parts of the branch, apart and in contact, and the
two jumps between them. The unknowns are ln w, ln of the length L = mu eps = (R w^2/E*^2)^(1/3), ln of the Tabor parameter mu, and the
zeros of position and force; eps and E* follow. A baseline that drifts linearly with the position of the base is recognised, and its
slope is one more unknown. No start is needed: for a series of Tabor parameters the others are found first, each by a search over the
scale of lengths.

Loads over pi w R and approaches over L depend on mu alone, and of the sphere itself on R/L, too: the other unknowns need no solve. Near
branches that are solved, the misfit is interpolated linearly between theirs, least squares are found there, and the next branch is
solved at the place that they name.

Lengths are in nm and forces in nN here: 1 J/m2 = 1 nN/nm, 1 GPa = 1 nN/nm2. scipy is needed.
"""

from __future__ import annotations

import argparse
import dataclasses
import functools
import itertools
import json
import pathlib
import sys
from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import least_squares

import pulloff

TABORS = np.geomspace(0.05, 200, 13)  # at which a start is sought
TOLERANCE = 1e-5                       # of the branches
PER_STEP = 48                          # points between those of a branch: with 12, interpolation had a misfit of 14 times that of the tolerance
BESIDE = 3                             # samples next to a jump that are left out: the lever takes some to come to rest
CLEAR_JUMP = 8                         # noise of a step that is taken for a jump
LEAST_NOISE = 1e-4                     # relative to the depth of the curve: the noise of a computed one
SIGNIFICANT = 10                       # sum of squares by which a model has to be better
BAD_FIT = 4                            # chi2/n of a model that does not describe the data
UNKNOWN = 0.5                          # standard error of a logarithm above which the number is not known from the data
CLEAR_SLOPE = 4                        # standard errors of the slope of a baseline that is fitted
SPHERE_TABOR = 50.0                    # greatest Tabor parameter at its start, beyond which the range hardly matters
MOST_SOLVES = 30                       # of one fit
DIFFERENCE = 0.03                      # of ln mu and ln R/L between branches whose difference serves as derivative
CLOSE = 0.1                            # greatest such distance at the end
FAR = 0.4                              # and before
STRIDE = 1.0                           # greatest change of ln mu or ln R/L before a branch is solved again
SETTLED = 0.02                         # standard errors by which values may still move at the end
LARGE_CONTACT = 0.3                    # contact radius over R, beyond which a paraboloid is no sphere


class NoFit(RuntimeError):
    """The data do not give a fit; the message says why."""


# -- The data --

@dataclasses.dataclass
class Curve:
    """Positions of the base, nm, growing towards the sample, and forces, nN, positive if they push the bodies apart."""
    into: tuple[np.ndarray, np.ndarray]
    out: tuple[np.ndarray, np.ndarray]
    notes: list[str] = dataclasses.field(default_factory=list)

    @functools.cached_property
    def noise(self):
        """Standard deviation of a force, by second differences of the halves of both ways that are far from the sample, without the
        outliers among them: a jump is one."""
        second = np.concatenate([np.diff(force[:max(8, len(force) // 2)], 2) for _, force in (self.into, self.out)])
        typical = 1.4826 * np.median(np.abs(second))
        least = LEAST_NOISE * (np.median(self.into[1]) - min(self.into[1].min(), self.out[1].min()))
        return max(np.sqrt(np.mean(second[np.abs(second) <= 4 * typical]**2) / 6), least)

    @functools.cached_property
    def spacing(self):
        return np.median(np.abs(np.diff(self.into[0])))

    @functools.cached_property
    def zero(self):
        return np.median(self.into[1][:max(8, len(self.into[1]) // 8)])

    @functools.cached_property
    def greatest(self):
        return float(max(self.into[1].max(), self.out[1].max()) - self.zero)

    @functools.cached_property
    def reference(self):
        """The position at which a sloping baseline has the zero of the force: the middle of the halves that are far from the sample."""
        return float(np.median(np.concatenate([position[:max(8, len(position) // 2)] for position, _ in (self.into, self.out)])))

    @functools.cached_property
    def baseline(self):
        """Slope of these halves, the zero of each by itself, and its standard error by the noise. A half ends before a jump and
        before the attraction bends it: it is shortened as long as a parabola finds a bend in it. One with fewer than 8 samples before
        the jump is left out."""
        jumps, ways = self.jumps(), []
        for (position, force), jump in zip((self.into, self.out), jumps):
            n = min(len(position) // 2, len(position) if jump is None else jump - BESIDE)
            if n < 8:
                continue
            while n > 16:
                (bend, *_), matrix = np.polyfit(position[:n] - position[:n].mean(), force[:n], 2, cov="unscaled")
                if abs(bend) < CLEAR_SLOPE / 2 * self.noise * np.sqrt(matrix[0, 0]):
                    break
                n = int(0.8 * n)
            ways.append((position[:n] - position[:n].mean(), force[:n]))
        squares = sum(x @ x for x, _ in ways)
        if not ways:
            return 0.0, self.noise / np.ptp(self.into[0])
        return sum(x @ y for x, y in ways) / squares, self.noise / np.sqrt(squares)

    def levelled(self, slope) -> Curve:
        """The curve without a slope of its baseline."""
        ways = [(position, force - slope * (position - self.reference)) for position, force in (self.into, self.out)]
        return Curve(*ways, self.notes)

    def jumps(self):
        """Indices of the last samples before the jumps into contact and out of it; None without a clear one. The way in jumps
        nearer to the sample than the way out, otherwise both follow one steep curve."""
        found = []
        for _, force in (self.into, self.out):
            steps = force[:-2] - force[2:]  # over two samples
            k = int(np.argmax(steps))
            found.append(k + (force[k] - force[k + 1] < force[k + 1] - force[k + 2]) if steps[k] > CLEAR_JUMP * self.noise else None)
        if None not in found and self.into[0][found[0]] - self.out[0][found[1]] <= 2 * self.spacing:
            return [None, None]
        return found


def turned(position, force):
    """A way in or out with positions that grow towards the sample. At one position, but for rounding, the samples of a jump keep their
    order along the way."""
    if position[0] > position[-1]:
        position, force = position[::-1], force[::-1]
    order, place = np.argsort(position, kind="stable"), np.zeros(len(position), int)
    place[order[1:]] = np.cumsum(np.diff(position[order]) > 1e-12 * np.ptp(position))
    order = np.argsort(place, kind="stable")
    return position[order], force[order]


def curve_of(position, force, position_out, force_out, stiffness=np.inf) -> Curve:
    """A curve of what was measured: zero and direction of the position and sign of the force are found. `stiffness` of the lever,
    nN/nm, only serves to say what was found."""
    into, out, notes = turned(position, force), turned(position_out, force_out), []
    def slopes(way):
        n = max(4, len(way[0]) // 10)
        return [abs(np.polyfit(way[0][part] - way[0][part].mean(), way[1][part], 1)[0]) for part in (slice(n), slice(-n, None))]
    far, near = slopes(into)
    if far > near:
        into, out = turned(-into[0], into[1]), turned(-out[0], out[1])
        notes.append("positions are turned, so that they grow towards the sample")
    if into[1][-1] < np.median(into[1][:max(4, len(into[1]) // 10)]):
        into, out = (into[0], -into[1]), (out[0], -out[1])
        notes.append("forces are turned, so that they are positive when they push the bodies apart")
    return Curve(into, out, notes)


# -- The model --

@functools.lru_cache(maxsize=256)
def solved(tabor, load, tolerance, radius):
    body = {} if radius is None else {"profile": f"exact_sphere:{radius!r}", "radius": radius}
    curve = pulloff.solve(tabor=tabor, want="curve", approach_start=-(60 + 2 * tabor), preload_load=load, tolerance=tolerance, **body).curve
    at = curve["position"]
    dense = np.interp(np.linspace(0, len(at) - 1, PER_STEP * len(at)), np.arange(len(at)), at)
    parts = [CubicHermiteSpline(at, curve[name], curve[name + "_rate"])(dense) for name in ("approach", "load")]
    return *parts, np.interp(dense, at, curve["contact_radius"])


def branch(tabor, load, tolerance=TOLERANCE, radius=None):
    """Approach, eps, load, pi w R, and contact radius, eps, along the branch up to a load; of a sphere of this radius, eps, None: of a
    paraboloid, whose branch does not depend on it. Numbers that differ by rounding have one branch."""
    return solved(float(f"{tabor:.12g}"), load, tolerance, radius and float(f"{radius:.12g}"))


def theory_branch(model, tabor, load):
    """The same of a theory of the paraboloid, in the units of Maugis (J. Colloid Interface Sci. 150 (1992) 243), the contact radius a
    and lambda; without the part apart, in which these theories have no force."""
    deep = tabor * (9 * np.pi**2 / 16) ** (1 / 3)
    last = 1.2 * (load + 2) ** (1 / 3) + 1
    a = np.linspace(0.01, last, 1200)
    if model == "JKR":
        return deep * (a**2 - 2 / 3 * np.sqrt(6 * a)), a**3 - np.sqrt(6 * a**3)
    if model == "DMT":
        return deep * a**2, a**3 - 2
    m = 1 + np.geomspace(1e3, 1e-6, 2400)
    tension = 1.0264004785593346 * 2 * (9 / (16 * np.pi)) ** (1 / 3) * tabor
    root, angle = np.sqrt(m**2 - 1), np.arccos(1 / m)
    p, q = tension / 2 * (root + (m**2 - 2) * angle), 4 / 3 * tension**2 * (root * angle - m + 1)
    a = (np.sqrt(q**2 + 4 * p) - q) / (2 * p)  # p a^2 + q a = 1
    keep = a < last
    return (deep * (a**2 - 4 / 3 * tension * a * root))[keep], (a**3 - tension * a**2 * (root + m**2 * angle))[keep]


@dataclasses.dataclass
class Model:
    """How a curve follows from the values w, eps, E*, z0, f0 (nN/nm, nm, nN/nm2, nm, nN)."""
    radius: float
    stiffness: float  # of the lever; inf: force against approach
    greatest: float   # force of the data, nN
    name: str = "solver"
    tolerance: float = TOLERANCE
    sphere: bool = False    # the sphere itself, otherwise a paraboloid
    near: tuple[float, float] | None = None  # the Tabor parameter and R/L of the branch to be taken; None: those of the values

    def load(self, work):
        """A load, pi w R, beyond all data: one of a few values, so that branches are used again."""
        return 2.0 ** np.ceil(np.log2(max(1.3 * self.greatest / (np.pi * work * self.radius), 0.25)))

    def branch(self, tabor, work, eps):
        tabor, slender = self.near or (tabor, self.radius / (tabor * eps))
        return branch(tabor, self.load(work), self.tolerance, tabor * slender if self.sphere else None)

    def states(self, tabor, work, eps):
        """Positions of the base and forces along the branch."""
        of = self.branch(tabor, work, eps) if self.name == "solver" else theory_branch(self.name, tabor, self.load(work))
        force = np.pi * work * self.radius * of[1]
        return tabor * eps / (self.near or (tabor,))[0] * of[0] + force / self.stiffness, force

    def parts(self, tabor, values):
        """The stable parts, apart and in contact, between which the base makes the contact jump."""
        work, eps, _, z0, f0 = values[:5]
        position, force = self.states(tabor, work, eps)
        falls = np.flatnonzero(np.diff(position) < 0)
        jump_in, jump_out = (falls[0], falls[-1] + 1) if len(falls) else (0, 0)
        return [(position[part] + z0, force[part] + f0) for part in (slice(jump_in + 1), slice(jump_out, None))]


def split(curve: Curve):
    """The samples apart and in contact, and the positions of the jumps in the data, nan without one."""
    (zi, fi), (zo, fo), (jump_in, jump_out) = curve.into, curve.out, curve.jumps()
    at = [np.nan if k is None else way[0][k:k + 2].mean() for k, way in ((jump_in, curve.into), (jump_out, curve.out))]

    def before(position, k, jump):
        """The samples before the jump, without BESIDE next to it. Computed curves have many more there, where the force is so steep that
        their distance counts."""
        return min(max(k - BESIDE, 0), int(np.searchsorted(position, jump - (BESIDE + 1) * curve.spacing, "right")))

    def after(position, k, jump, beside):
        return max(k + 2 + beside, int(np.searchsorted(position, jump + (beside + 1) * curve.spacing, "left")))
    first, last = (0, 0) if jump_in is None else (before(zi, jump_in, at[0]), after(zi, jump_in, at[0], 0))
    below, above = (0, 0) if jump_out is None else (before(zo, jump_out, at[1]), after(zo, jump_out, at[1], BESIDE))
    if jump_in is not None and jump_out is None:
        below, above = first, last
    far = np.r_[zi[:first], zo[:below]], np.r_[fi[:first], fo[:below]]
    near = np.r_[zi[last:], zo[above:]], np.r_[fi[last:], fo[above:]]
    return far, near, np.array(at)


def residuals(model: Model, tabor, values, curve: Curve, data, contact_only=False):
    """Over their standard deviations, of the samples apart, of those in contact, of the two jumps. The sixth value is the slope of the
    baseline of the data."""
    (far, near, jumps), (apart, contact) = data, model.parts(tabor, values)
    far, near = ((z, f - values[5] * (z - curve.reference)) for z, f in (far, near))
    by_jump = (np.array([apart[0][-1], contact[0][0]]) - jumps) / (curve.spacing / np.sqrt(12))
    by_jump = by_jump[~np.isnan(jumps)] if not contact_only else by_jump[1:][~np.isnan(jumps[1:])]
    of = [(np.interp(near[0], *contact) - near[1]) / curve.noise, by_jump]
    return np.concatenate(of if contact_only else [(np.interp(far[0], *apart) - far[1]) / curve.noise, *of])


# -- The fit --

@dataclasses.dataclass
class Fit:
    """What was found: values w, eps, E*, z0, f0 in nN/nm, nm, nN/nm2, nm, nN; their covariance, that of the logarithms for the first
    three; the sum of squares over their number, and that of the part in contact."""
    model: str
    tabor: float
    values: np.ndarray
    covariance: np.ndarray
    chi2: float
    chi2_contact: float
    count: int
    contact_radius: float = np.nan
    slope: float = 0.0  # of the baseline, nN/nm, and its standard error; 0 and nan if it is level
    slope_error: float = np.nan
    sphere: bool = False  # of the full law: whether the body is the sphere itself

    @property
    def errors(self):
        """Standard errors of the values, to first order in the logarithms."""
        spread = np.sqrt(np.diag(self.covariance))
        return np.where(np.arange(5) < 3, self.values * spread, spread)


def modulus_of(model, tabor, work, eps):
    return np.sqrt(model.radius * work**2 / (tabor * eps) ** 3)


def values_of(model, x):
    """From ln w, ln L, ln mu, z0, f0, slope."""
    work, length, tabor = np.exp(x[:3])
    return tabor, np.array([work, length / tabor, modulus_of(model, tabor, work, length / tabor), *x[3:]])


def search(model, curve, data, tabor, contact_only):
    """The best start at a Tabor parameter: the work by the least force, the scale of lengths by trial, the zero of the position by the
    place of the least force."""
    least = int(np.argmin(curve.out[1]))
    depth = max(curve.zero - curve.out[1][least], 3 * curve.noise)
    work = depth / (1.7 * np.pi * model.radius)
    for _ in range(2):
        force = model.states(tabor, work, 1.0)[1]
        work *= depth / -force.min()
    best = np.inf, None
    for eps in np.geomspace(1e-3, 1e2, 81):
        position, force = model.states(tabor, work, eps)
        falls = np.flatnonzero(np.diff(position) < 0)
        stable = slice(falls[-1] + 1 if len(falls) else 0, None)
        z0 = curve.out[0][least] - position[stable][np.argmin(force[stable])]
        values = np.array([work, eps, modulus_of(model, tabor, work, eps), z0, curve.zero, 0.0])
        cost = np.sum(np.minimum(np.abs(residuals(model, tabor, values, curve, data, contact_only)), 100))
        if cost < best[0]:
            best = cost, np.array([np.log(work), np.log(tabor * eps), np.log(tabor), z0, curve.zero, 0.0])
    return best


def units_of(curve, start):
    """By which the unknowns move."""
    return np.array([0.1, 0.1, 0.3, max(curve.spacing, 0.1 * np.exp(start[1] - start[2])), 3 * curve.noise, 3 * curve.baseline[1]])


def limits_of(start):
    """Least and greatest values of the unknowns."""
    least = np.array([start[0] - np.log(8), start[1] - np.log(100), np.log(TABORS[0] / 2), -np.inf, -np.inf, -np.inf])
    most = np.array([start[0] + np.log(8), start[1] + np.log(100), np.log(TABORS[-1] * 2), np.inf, np.inf, np.inf])
    return least, most


def refine(miss, start, unit, free, limits, steps=None):
    """Least squares of a misfit over some of the unknowns, in units in which each begins at 1."""
    free = np.array(free)

    def full(u):
        x = start.copy()
        x[free] += (u - 1) * unit[free]
        return x
    low, high = ((1 + (limit - start) / unit)[free] for limit in limits)
    found = least_squares(lambda u: miss(full(u)), np.ones(len(free)), bounds=(low, high), diff_step=0.02, x_scale="jac", max_nfev=steps,
                          xtol=1e-6, ftol=1e-8)
    return full(found.x), found, unit[free]


def misfit(model, curve, data, contact_only=False):
    """The misfit as a function of the unknowns."""
    def miss(x):
        tabor, values = values_of(model, x)
        return residuals(model, tabor, values, curve, data, contact_only)
    return miss


class Branches:
    """Branches that are solved, at places (ln mu, ln R/L), and the misfit between them. Of a paraboloid only the first coordinate
    counts."""

    def __init__(self, model, curve, data):
        self.model, self.curve, self.data = model, curve, data
        self.places: list[np.ndarray] = []
        self.count = 2 if model.sphere else 1

    def place(self, x):
        return np.array([x[2], np.log(self.model.radius) - x[1]])

    def miss_at(self, place):
        """The misfit with the branch at a place for all values of the unknowns."""
        return misfit(dataclasses.replace(self.model, near=tuple(np.exp(place))), self.curve, self.data)

    def solve(self, place, x):
        """Solves the branch at a place. Given: values of the unknowns, which say how far it has to reach."""
        self.miss_at(place)(x)
        self.places.append(place)

    def pairs(self, centre, farthest):
        """Pairs of places at most so far from the centre and from each other, the nearest ones, whose ways span the coordinates."""
        found: list[tuple[np.ndarray, np.ndarray]] = []

        def distance(p, q):
            return np.linalg.norm((p - q)[:self.count])
        for p, q in sorted(itertools.combinations(self.places, 2), key=lambda pair: max(distance(centre, place) for place in pair)):
            if len(found) == self.count or max(distance(centre, p), distance(centre, q)) > farthest:
                break
            ways = [(to - of)[:self.count] / distance(to, of) for of, to in (*found, (p, q))] if distance(p, q) >= DIFFERENCE / 3 else []
            if ways and (len(ways) == 1 or abs(np.linalg.det(ways)) > 0.5):
                found.append((p, q))
        return found

    def around(self, centre, farthest, x):
        """As pairs; the branches that are missing are solved."""
        found = self.pairs(centre, farthest)
        while len(found) < self.count:
            way = np.eye(2)[0]
            if found:
                way = (found[0][1] - found[0][0])[::-1] * [1, -1]  # at a right angle to the other one
                way *= np.sign(way[0] or 1) / np.linalg.norm(way)
            if centre[0] + DIFFERENCE > np.log(TABORS[-1] * 2):
                way = -way
            self.solve(centre + DIFFERENCE * way, x)
            found.append((centre, self.places[-1]))
        return found

    def interpolated(self, centre, pairs):
        """The misfit as a function of the unknowns, linear in the place of the branch, with differences between some pairs."""
        of_centre = self.miss_at(centre)
        misses = [(self.miss_at(p), self.miss_at(q)) for p, q in pairs]
        ways = np.array([(q - p)[:self.count] for p, q in pairs])

        def miss(x):
            shares = np.linalg.solve(ways.T, (self.place(x) - centre)[:self.count])
            return of_centre(x) + sum(share * (of_q(x) - of_p(x)) for share, (of_p, of_q) in zip(shares, misses))
        return miss


def settled(found):
    """A gain of cost by which no value moves by SETTLED of its standard error."""
    return SETTLED**2 / 2 * variance_of(found)


def refine_solved(model, curve, data, start, free):
    """Least squares over the unknowns with branches that are solved as needed. Ends where no value would move by SETTLED of its standard
    error, or where no branch nearby is better; by differences of branches no farther than CLOSE. Returned: as refine."""
    of, unit, limits = Branches(model, curve, data), units_of(curve, start), limits_of(start)
    fixed = [k for k in free if k != 2 and not (model.sphere and k == 1)]  # the unknowns of one branch
    centre, stride, farthest = of.place(start), STRIDE, FAR
    of.solve(centre, start)
    x, found, _ = refine(of.miss_at(centre), start, unit, fixed, limits)
    while True:
        pairs = of.around(centre, farthest, x)
        least, most = (limit.copy() for limit in limits)
        for k, at in ((2, centre[0]), (1, np.log(model.radius) - centre[1]))[:of.count]:
            least[k], most[k] = max(least[k], at - stride), min(most[k], at + stride)
        y, near, scale = refine(of.interpolated(centre, pairs), x, unit, free, (least, most))
        ends = found.cost - near.cost <= settled(found) or stride < DIFFERENCE / 3 or len(of.places) >= MOST_SOLVES
        if ends and farthest == CLOSE:
            found.jac = near.jac
            return x, found, scale
        if ends:
            stride, farthest = max(stride, DIFFERENCE), CLOSE
            continue
        place = of.place(y)
        of.solve(place, y)
        y, tried, _ = refine(of.miss_at(place), y, unit, fixed, limits)
        if tried.cost < found.cost:
            stride = min(2 * stride, STRIDE) if found.cost - tried.cost > (found.cost - near.cost) / 2 else stride
            x, found, centre = y, tried, place
        else:
            stride = np.linalg.norm((place - centre)[:of.count]) / 4


def variance_of(found):
    """Of the misfit: 1 by the noise of the data, or more if the model is farther from them. Computed data have less noise than what is
    taken for it, but the branches have errors."""
    return max(2 * found.cost / max(len(found.fun) - found.jac.shape[1], 1), 1.0)


def covariance_of(found, unit, free):
    """Of ln w, ln eps, ln E*, z0, f0, slope."""
    matrix = np.zeros((6, 6))  # of ln w, ln L, ln mu, z0, f0, slope
    curvature = found.jac.T @ found.jac
    spread = np.linalg.pinv(curvature, rcond=1e-14, hermitian=True)
    matrix[np.ix_(free, free)] = spread * np.outer(unit, unit) * variance_of(found)
    turn = np.eye(6)
    turn[1], turn[2] = [0, 1, -1, 0, 0, 0], [1, -1.5, 0, 0, 0, 0]
    return turn @ matrix @ turn.T


def finished(model, curve, data, x, found, unit, free):
    tabor, values = values_of(model, x)
    contact = residuals(model, tabor, values, curve, data, True)
    covariance = covariance_of(found, unit, free)
    fit = Fit(model.name, tabor, values[:5], covariance[:5, :5], 2 * found.cost / len(found.fun),
              float(contact @ contact) / len(contact), len(found.fun))
    if 5 in free:
        fit.slope, fit.slope_error = float(values[5]), float(np.sqrt(covariance[5, 5]))
    if model.name == "solver":
        _, load, radius = model.branch(tabor, values[0], values[1])
        fit.contact_radius = values[1] * float(np.interp(model.greatest / (np.pi * values[0] * model.radius), *(
            (load[np.argmin(load):], radius[np.argmin(load):]))))
    return fit


def fit_curve(curve: Curve, radius: float, stiffness: float = np.inf, sloping: bool | None = None) -> Fit:
    """Fits the full law. Given: radius, nm, and stiffness of the lever, nN/nm; whether the baseline slopes, None: if its slope is clear.
    Raises NoFit."""
    first, error = curve.baseline
    if sloping is None:
        sloping = abs(first) > CLEAR_SLOPE * error
    first *= sloping
    curve = curve.levelled(first)
    model, data = Model(radius, stiffness, curve.greatest), split(curve)
    free = range(6) if sloping else range(5)
    if curve.zero - curve.out[1].min() < CLEAR_JUMP * curve.noise:
        raise NoFit("no attraction above the noise on the way out")
    if len(data[1][0]) < 8:
        raise NoFit("fewer than 8 samples in contact")
    z, force = (values[:5] for values in curve.out)
    if np.median(force - np.interp(z, *curve.into)) < -CLEAR_JUMP * curve.noise:  # both ways attract where the bodies are apart
        raise NoFit("the way out ends in contact: expected positions to beyond the jump out of it")
    tried = []
    for tabor in TABORS:
        cost, start = search(model, curve, data, tabor, False)
        if start is not None:
            x, found, _ = refine(misfit(model, curve, data), start, units_of(curve, start), [k for k in free if k != 2], limits_of(start), 12)
            tried.append((found.cost, x))
    if not tried:
        raise NoFit("no start was found")
    best = None
    tried.sort(key=lambda pair: pair[0])
    for _, start in [pair for pair in tried[:2] if pair[0] < 2 * tried[0][0]]:
        x, found, unit = refine_solved(model, curve, data, start, free)
        if best is None or found.cost < best[1].cost:
            best = x, found, unit
    fit = finished(model, curve, data, *best, free)
    fit.slope += first
    if not np.all(np.isfinite(fit.values)) or not np.all(np.isfinite(fit.errors)):
        raise NoFit("no values of finite size describe the data")
    return fit


def fit_sphere(curve: Curve, radius: float, stiffness: float, near: Fit) -> Fit:
    """Fits the full law with the sphere itself. Given: the curve without a slope of its baseline, and the fit of the paraboloid, which
    is the start. Raises NoFit."""
    sloping = bool(np.isfinite(near.slope_error))
    model, data = Model(radius, stiffness, curve.greatest, sphere=True), split(curve)
    work, eps = near.values[:2]
    for _ in range(3):  # the work that gives the depth of the curve, at the same modulus and, if it is not too short, the same range
        scale = (radius * work**2 / near.values[2]**2) ** (1 / 3)
        eps = max(eps, scale / SPHERE_TABOR)
        tabor = scale / eps
        work *= max(curve.zero - curve.out[1].min(), 3 * curve.noise) / -model.states(tabor, work, eps)[1].min()
    start = np.array([np.log(work), np.log(tabor * eps), np.log(tabor), *near.values[3:5], 0.0])
    free = range(6) if sloping else range(5)
    x, found, unit = refine_solved(model, curve, data, start, free)
    fit = finished(model, curve, data, x, found, unit, free)
    fit.slope += near.slope
    fit.sphere = True
    if not np.all(np.isfinite(fit.values)) or not np.all(np.isfinite(fit.errors)):
        raise NoFit("no values of finite size describe the data")
    return fit


def fit_shapes(curve: Curve, radius: float, stiffness: float = np.inf, sloping: bool | None = None) -> tuple[Fit, Fit | None]:
    """Fits the full law of a paraboloid and, where its contact is large, that of the sphere itself. Returned: the fit that describes the
    data better, and the other one; None: there is none. Raises NoFit."""
    flat = fit_curve(curve, radius, stiffness, sloping)
    if flat.contact_radius <= LARGE_CONTACT * radius:
        return flat, None
    try:
        sphere = fit_sphere(curve.levelled(flat.slope), radius, stiffness, flat)
    except (NoFit, pulloff.Error, ValueError):
        return flat, None
    return (sphere, flat) if sphere.chi2 <= flat.chi2 else (flat, sphere)


def fit_theory(name: str, curve: Curve, radius: float, stiffness: float = np.inf) -> Fit:
    """Fits JKR, DMT or Maugis, which have no attraction before the contact: to the part in contact and the jump out of it, with the zero of
    the force from the part apart. Their lengths scale with mu eps alone; JKR and DMT therefore keep mu at 1."""
    model, data = Model(radius, stiffness, curve.greatest, name), split(curve)
    best, free = None, [0, 1, 2, 3] if name == "Maugis" else [0, 1, 3]
    for tabor in (np.geomspace(0.05, 5, 5) if name == "Maugis" else [1.0]):
        _, start = search(model, curve, data, tabor, True)
        start[4] = np.median(data[0][1]) if len(data[0][1]) else curve.zero
        x, found, unit = refine(misfit(model, curve, data, True), start, units_of(curve, start), free, limits_of(start), 60)
        if best is None or found.cost < best[1].cost:
            best = x, found, unit
    return finished(model, curve, data, *best, free)


# -- Files and the command --

UNITS = {"m": 1e9, "mm": 1e6, "um": 1e3, "µm": 1e3, "μm": 1e3, "nm": 1.0, "pm": 1e-3, "N": 1e9, "mN": 1e6, "uN": 1e3, "µN": 1e3, "μN": 1e3,
         "nN": 1.0, "pN": 1e-3}


def unit_of(name):
    """The factor to nm or nN of the unit at the end of the name of a column, and whether it is a force."""
    word = name.strip().rstrip(")]} ").replace("[", "_").replace("(", "_").replace("/", "_").replace(" ", "_").split("_")[-1]
    return UNITS.get(word), word.endswith("N")


def decoded(raw):
    """The text of a file in UTF-16 with a byte order mark, UTF-8 or Latin-1."""
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return raw.decode("utf-16")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        return raw.decode("latin-1")


def is_unit(cell):
    return cell in UNITS or (cell[:1] + cell[-1:] in ("[]", "()"))


def read_table(path):
    """Names of the columns and rows of a table: commas, semicolons, tabs or blanks, decimal commas, lines of text before the names, a
    line of units below them; without names, the columns are called 1, 2 and so on."""
    lines = [line.strip().lstrip("#").strip() for line in decoded(pathlib.Path(path).read_bytes()).splitlines() if line.strip()]
    separator = max((";", "\t", ","), key=lambda mark: sum(mark in line for line in lines[-20:]))
    separator = separator if lines and separator in lines[-1] else None

    def cells(line):
        return [cell.strip().strip('"') for cell in line.split(separator)]

    def number(cell):
        try:
            return float(cell.replace(",", ".") if separator != "," else cell)
        except ValueError:
            return None
    count = len(cells(lines[-1])) if lines else 0
    table = [row for row in map(cells, lines) if len(row) == count]
    numbers = [[number(cell) for cell in row] for row in table]
    filled = [any(value is not None for value in values) for values in numbers]
    begin = next((k for k in range(len(table)) if all(filled[k:k + 3])), len(table))  # text before the names may have numbers, too
    head = [row for row, has in zip(table[:begin], filled) if not has]
    units = head.pop() if len(head) > 1 and all(map(is_unit, head[-1])) else None
    names = head[-1] if head else [str(k + 1) for k in range(count)]
    names = [f"{name} {unit}" for name, unit in zip(names, units)] if units else names
    rows = [(row, values) for row, values, has in zip(table[begin:], numbers[begin:], filled[begin:]) if has]
    if len(rows) < 20:
        raise NoFit(f"{path}: expected at least 20 rows of {max(count, 2)} numbers")
    return names, rows


def read_curve(path, columns: Sequence[str] | None = None, stiffness: float = np.inf, units: Sequence[str] | None = None) -> Curve:
    """A curve from a table. Two columns, position and force or deflection, are the way in and then the way out; three, position, in,
    out, were measured at the same positions; a column `phase` with words such as loading and unloading, approach and retract, tells them apart, as the tables of
    pulloff solve --loop do. Deflections, in units of length, are multiplied by the stiffness. Given units, of the columns, stand in place
    of those in the names."""
    names, rows = read_table(path)
    if columns is None:
        columns = [str(k + 1) for k in range(len(units))] if units else [name for name in names if unit_of(name)[0]]
        columns = (["base_nm", "load_nN"] if {"base_nm", "load_nN"} <= set(names) else columns[:3])
    places = [int(word) - 1 if word.isdigit() else names.index(word) if word in names else None for word in columns]
    if len(places) not in (2, 3) or None in places or not all(0 <= place < len(names) for place in places):
        raise NoFit(f"{path}: expected two or three columns with units, of {', '.join(names)}: at the end of a name (z_nm, force [nN]), in a line "
                    "below the names, or given by --units, such as --units um,nN")
    if units and (len(units) != len(places) or not set(units) <= set(UNITS)):
        raise NoFit(f"units is {','.join(units)}: expected one of {', '.join(UNITS)} for each of the {len(places)} columns")
    units = [unit_of(unit) for unit in units or [names[place] for place in places]]
    if any(factor is None for factor, _ in units) or units[0][1]:
        raise NoFit(f"{path}: expected a unit of length at the end of the name of the position, and of length or force of the others: "
                    f"{', '.join(names[place] for place in places)}")
    if any(not force for _, force in units[1:]) and not np.isfinite(stiffness):
        raise NoFit("a deflection needs the stiffness of the lever")
    phase = names.index("phase") if "phase" in names else None
    kept = [(row, values) for row, values in rows if all(values[place] is not None and np.isfinite(values[place]) for place in places)]
    data = np.array([[values[place] for place in places] for _, values in kept])
    data *= [factor * (1 if i == 0 or force else stiffness) for i, (factor, force) in enumerate(units)]
    if len(places) == 3:
        return curve_of(data[:, 0], data[:, 1], data[:, 0], data[:, 2])
    if phase is not None:
        out = np.array([row[phase].lower().startswith(("retr", "unload", "withdr")) for row, _ in kept])
    else:
        ends = [abs(data[0, 0] - data[:, 0]), abs(data[-1, 0] - data[:, 0])]
        turn = int(np.argmax(ends[0] + ends[1]))
        out = np.arange(len(data)) > turn
    spans = [np.ptp(data[way, 0]) if way.any() else 0 for way in (out, ~out)]
    if out.sum() < 16 or (~out).sum() < 16 or min(spans) < 0.2 * max(spans):
        raise NoFit(f"{path}: expected a way in and a way out, with at least 16 rows each")
    return curve_of(data[~out, 0], data[~out, 1], data[out, 0], data[out, 1])


NAMES = ["w, J/m2", "range, nm", "E*, GPa", "zero position, nm", "zero force, nN"]


def shape_of(full, other, radius):
    """A line on the paraboloid that stands for a sphere, where the contact is large. Given: the fit with the other shape; None: there
    is none."""
    said = f"the contact radius reaches {full.contact_radius:.4g} nm, {full.contact_radius / radius:.2g} of the radius: "
    if other is None:
        return "warning     " + said + "the model is a paraboloid, and a sphere differs there"
    work, modulus = 100 * (other.values[[0, 2]] / full.values[[0, 2]] - 1)
    names = ("sphere itself", "paraboloid")
    return (f"shape       {said}the {names[not full.sphere]} is fitted; with the {names[full.sphere]} w would change by {work:+.3g} % and E* by "
            f"{modulus:+.3g} %, at chi2/n {other.chi2:.4g}")


def report(curve, full, theories, radius, other=None):
    """Lines of text."""
    lines = [f"curve       {len(curve.into[0])} samples in and {len(curve.out[0])} out; noise {curve.noise:.3g} nN, spacing {curve.spacing:.3g} nm"]
    lines += [f"            {note}" for note in curve.notes]
    jumps = [("no clear jump" if np.isnan(at) else f"{at:.4g} nm") for at in split(curve)[2]]
    lines.append(f"jumps       into contact {jumps[0]}, out of contact {jumps[1]}")
    lines.append("model   " + "".join(f"{name:>26}" for name in NAMES) + "    chi2/n   contact")
    for fit in (full, *theories):
        theory = fit.model != "solver"
        known = [True, fit.model != "JKR" and fit.model != "DMT" and np.sqrt(fit.covariance[1, 1]) < UNKNOWN, True, True, not theory]
        cells = [f"{value:.5g} +- {error:.2g}" if show else "" for value, error, show in zip(fit.values, fit.errors, known)]
        lines.append(f"{fit.model if theory else 'full law':8}" + "".join(f"{cell:>26}" for cell in cells)
                     + ("" if theory else f" {fit.chi2:.4g}").rjust(10) + f" {fit.chi2_contact:.4g}".rjust(10))
    if np.isfinite(full.slope_error):
        lines.append(f"baseline    slope {1e3 * full.slope:.4g} +- {1e3 * full.slope_error:.2g} nN/um of the position of the base, removed; the zero of "
                     f"the force is that at {curve.reference:.4g} nm")
    lines.append(f"tabor       {full.tabor:.4g}")
    if np.sqrt(full.covariance[1, 1]) > UNKNOWN:
        lines.append("range       not known from these data; the other values hardly depend on it")
    best = min(theories, key=lambda fit: fit.chi2_contact)
    gain = (best.chi2_contact - full.chi2_contact) * best.count
    lines.append("preferred   " + ("the full law: no theory fits the part in contact as well" if gain > SIGNIFICANT else
                                   f"{best.model}, which fits the part in contact better than the full law" if gain < -SIGNIFICANT else
                                   f"none: {best.model} fits the part in contact as well as the full law; that does not make its w right"))
    if full.chi2 > BAD_FIT:
        lines.append(f"warning     chi2/n is {full.chi2:.3g}: the full law does not describe these data, and the errors are not to be relied on")
    if other is not None:
        lines.append(shape_of(full, other, radius))
    elif full.contact_radius > LARGE_CONTACT * radius:
        lines.append(shape_of(full, None, radius))
    return lines


def draw(path, curve, fits, radius, stiffness):
    """Force against approach: the position of the base less the deflection."""
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6.4, 4), constrained_layout=True)
    for (z, f), colour, label in zip((curve.into, curve.out), ("tab:blue", "tab:orange"), ("way in", "way out")):
        axes.plot(z - f / stiffness, f, ".", color=colour, markersize=3, label=label)
    limits = axes.axis()
    for fit, style in zip(fits, ("k-", "r--", "g:", "m-.")):
        for part, label in zip(Model(radius, stiffness, curve.greatest, fit.model, sphere=fit.sphere).parts(fit.tabor, fit.values),
                               (None, fit.model.replace("solver", "full law"))):
            if label or fit.model == "solver":
                axes.plot(part[0] - part[1] / stiffness, part[1], style, linewidth=1, label=label)
    axes.axis(limits)
    axes.set(xlabel="position of the base" + (" less deflection" if np.isfinite(stiffness) else "") + " / nm", ylabel="force / nN")
    axes.legend(frameon=False)
    figure.savefig(path, dpi=120)


def document(curve, full, theories, other=None):
    keys = ["work_j_per_m2", "distance_m", "modulus_pa", "position_of_contact_m", "zero_of_force_n"]
    units = [1.0, 1e-9, 1e9, 1e-9, 1e-9]

    def of(fit):
        names = {"solver": "full_law"}
        return {"model": names.get(fit.model, fit.model.lower()), "shape": "sphere" if fit.sphere else "paraboloid", "chi2": fit.chi2, "chi2_in_contact": fit.chi2_contact, "tabor": fit.tabor,
                **{key: value * unit for key, value, unit in zip(keys, fit.values, units)},
                **{key + "_error": error * unit for key, error, unit in zip(keys, fit.errors, units)},
                **({"baseline_slope_n_per_m": fit.slope, "baseline_slope_n_per_m_error": fit.slope_error} if np.isfinite(fit.slope_error) else {})}
    return {"noise_n": curve.noise * 1e-9, "notes": curve.notes, "fits": [of(fit) for fit in (full, *theories, *([] if other is None else [other]))]}


def main(words=None):
    parser = argparse.ArgumentParser(prog="pulloff fit", description=(__doc__ or "").split("\n\n    python3")[0])
    parser.add_argument("curve", help="a table of positions and forces or deflections, with units at the end of the names of its columns")
    parser.add_argument("--radius-m", type=float, required=True, help="radius of the sphere, m")
    parser.add_argument("--stiffness-n-per-m", type=float, default=np.inf, help="of the cantilever, whose base is at the positions, N/m "
                        "(default: positions are the approach)")
    parser.add_argument("--columns", help="names or numbers of position and force, or of position, way in and way out, with commas between")
    parser.add_argument("--units", help="units of these columns, with commas between (default: those in their names)")
    parser.add_argument("--baseline", choices=("auto", "level", "sloping"), default="auto", help="whether the force far from the sample may "
                        "drift linearly with the position of the base: its slope is then fitted (default auto: if it exceeds 4 standard errors)")
    parser.add_argument("--plot", help="draw the fits in this file: .svg, .png or .pdf")
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    given = parser.parse_args(words)
    if not given.radius_m > 0 or not given.stiffness_n_per_m > 0:
        parser.error("radius and stiffness: expected numbers > 0")
    radius, stiffness = given.radius_m * 1e9, given.stiffness_n_per_m
    try:
        curve = read_curve(given.curve, given.columns and given.columns.split(","), stiffness, given.units and given.units.split(","))
        full, other = fit_shapes(curve, radius, stiffness, {"level": False, "sloping": True}.get(given.baseline))
        curve = curve.levelled(full.slope)
    except (NoFit, OSError, pulloff.Error) as error:
        print(f"pulloff: {error}", file=sys.stderr)
        return 4 if isinstance(error, OSError) else 3
    with np.errstate(all="ignore"):
        theories = [fit_theory(name, curve, radius, stiffness) for name in ("JKR", "DMT", "Maugis")]
    print(json.dumps(document(curve, full, theories, other), indent=1) if given.json else "\n".join(report(curve, full, theories, radius, other)))
    if given.plot:
        draw(given.plot, curve, (full, *theories), radius, stiffness)
    return 0


if __name__ == "__main__":
    sys.exit(main())
