"""A scene of any traction-separation law and any profile: the problem it makes, and its special points.

The elastic number is c = w/(E* epsilon): H(r) + D - f(r) - c int G(r, s) p(H(s)) s ds = 0, lengths in epsilon,
tractions in w/epsilon. The solver has units of its own (branch.py): S for the load, in pi w epsilon, and Gamma for
radii, with f of r/Gamma, the law times Gamma^2/S and the elastic number c S/Gamma.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.polynomial.legendre import leggauss

from branch import APPROACH, Level, NotConverged, Problem
from converged import converge_mark
from landmarks import find_landmarks, landmark_kinds, trace
from laws import law_of
from profiles import profile_of
from tables import number

TRACE = Level(order=12, tail=14, tolerance=1e-6, kink=6)
FINE_TRACE = Level(order=14, tail=16, tolerance=1e-7, cut=1.1, kink=8)
POLISH = (Level(order=14, tail=18, tolerance=1e-9, kink=12),
          Level(order=16, tail=22, tolerance=1e-10, cut=1.21, kink=13),
          Level(order=18, tail=26, tolerance=1e-11, cut=1.37, extra=8, kink=14))

FIRM = 1.0                # load, in units of half the pull-off, at which the branch of a smooth profile ends
FAR = 12.0                # the trace begins this far out, and farther by the stretch of JKR at given approach
FAR_GAP = 36.0            # initial gap at the start of the mapped panel, at least (a sphere: 6 ranges sqrt(2R))
WAVY_GAP = 2000.0         # the same with waves: what the panel does not resolve carries less than 1e-9 of the load
NO_TENSION = 1e-18        # tension below which an exponential law ends
EDGE_LEVEL = 10           # halvings of the panels towards the cut
CLOSED = 1e-13            # tension at the end of an exponential law over the greatest traction, at most
_X, _W = leggauss(200)


def abel(profile, x):
    """g(x) = x int_0^(pi/2) f'(x sin(angle)) d(angle) at an array of radii, for scales: its digits are those of 200
    points between kinks."""
    ends = [np.zeros_like(x), *(np.arcsin(np.minimum(r / x, 1.0)) for r in profile.kinks), np.full_like(x, 0.5 * np.pi)]
    g = 0.0
    for low, high in zip(ends, ends[1:]):
        angle = low[:, None] + 0.5 * (high - low)[:, None] * (_X + 1.0)
        g = g + 0.5 * (high - low) * (profile.slope(x[:, None] * np.sin(angle)) @ _W)
    return x * g


@dataclass(frozen=True)
class Scales:
    """What a scene is measured by, in epsilon and pi w epsilon: the pull-off of the rigid bodies and of JKR, the
    stretch of JKR at given approach, its contact radius at the load that ends the branch."""
    rigid: float
    jkr: float
    stretch: float
    contact: float


def scales(law, profile, coupling, end):
    """Of a profile that ends at `end`; estimates, of some percent."""
    gap = np.geomspace(1e-4, 1e4, 1601)
    radii = np.geomspace(1e-6, 1e6, 4801)
    reach = np.interp(gap, np.maximum.accumulate(profile.gap(radii)), radii)    # where the gap is first that
    r = np.linspace(0.0, min(end, np.interp(60.0, gap, reach)), 20001)
    rigid = max(-np.trapz(2.0 * r * law.traction(profile.gap(r) - d), r) for d in np.linspace(-1.0, 0.5, 31))
    a = np.geomspace(1e-4, 10.0, 2001) * min(end, np.interp(60.0, gap, reach))
    a = a[a <= min(end, profile.extent)]
    g = abel(profile, a)
    area = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(a) * (g[1:] + g[:-1]))])
    load = (2.0 * (a * g - area) / coupling - np.sqrt(8.0 * np.pi * a**3 / coupling)) / np.pi
    jkr = -load.min()
    stretch = -(g - np.sqrt(2.0 * np.pi * a * coupling)).min()
    below = a[load < FIRM * jkr]                  # none: the contact of JKR is smaller than all of these
    return Scales(rigid, jkr, max(0.0, stretch), below[-1] if len(below) else a[0])


@dataclass(frozen=True)
class Scene:
    """One scene (texts, as in the tables); the approach that ends its branch (None: the load FIRM does)."""
    law: str
    profile: str
    waves: str
    coupling: str
    radius: str
    outer_radius: str
    complete_to: float = None
    tabor: str = field(default="-", compare=False)

    @property
    def key(self):
        return self.law, self.profile, self.waves, self.coupling, self.radius, self.outer_radius

    @property
    def unit(self):
        """Of the load, in pi w epsilon."""
        return 1.0 if self.radius == "-" else float(self.radius)

    def setting(self):
        """The problem in its own units, the unit of radii (in epsilon), of the load (in pi w epsilon), and the
        approach from which the branch is followed."""
        law, profile = law_of(self.law), profile_of(self.profile, self.waves, self.radius)
        coupling, outer = float(self.coupling), min(float(self.outer_radius), profile.extent)
        size = scales(law, profile, coupling, outer)
        # the unit of the load is half the pull-off: of rigid bodies if the parameter of Tabor they give is below 1.
        # The unit of radii is that of the paper, (c S^2)^(1/3) = sqrt(R mu epsilon) of a sphere.
        load = 0.5 * (size.rigid if coupling**2 * 0.5 * size.rigid < 1.0 else size.jkr)
        width = np.cbrt(coupling * load**2)
        first = -(FAR + size.stretch)
        scaled = replace(law, strength=width**2 / load)
        elastic = coupling * load / width
        base = profile_of(self.profile, "-", self.radius)
        end, edge_level, core = outer, EDGE_LEVEL, 1.0
        far_gap = max(FAR_GAP, -3.0 * first)
        if law.decay is None:
            gap = law.reach(NO_TENSION) + 2.0 * size.stretch + max(self.complete_to or 0.0, FAR)
            ended = max(farthest(base, gap, outer), 2.5 * size.contact)
            if ended < outer:
                end, edge_level = ended, 0
        elif np.isinf(outer):
            core = farthest(base, far_gap if self.waves == "-" else max(far_gap, WAVY_GAP), outer)
            core = max(core, 2.5 * size.contact)
        problem = Problem(scaled, profile.in_units_of(width), elastic, None if np.isinf(end) else end / width,
                          core / width, edge_level)
        if problem.outer is None:
            problem.decay          # refuses what has no finite load
        return problem, width, load, first


def sphere(law, tabor, radius=100):
    """A smooth unbounded sphere: c = mu^(3/2)/sqrt(R)."""
    return Scene(law, "sphere", "-", number(float(tabor)**1.5 / np.sqrt(radius)), str(radius), "inf", None, tabor)


def farthest(base, gap, end):
    """The radius where the initial gap is that, or the end of the profile."""
    low, high = 0.0, min(1.0, end)
    while high < end and base.gap(np.array(high)) < gap:
        high = min(2.0 * high, end)
    if base.gap(np.array(high)) < gap:
        return end
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if base.gap(np.array(middle)) < gap else (low, middle)
    return high


@dataclass(frozen=True)
class Solved:
    """The special points of a scene in order, and where their list ends."""
    rows: list
    complete_to: float
    width: float
    load: float


def end_of(scene, states):
    """The approach up to which the list is complete: two digits below the end of the trace."""
    if scene.complete_to is not None:
        return scene.complete_to
    last = states[-1].approach
    step = 10.0**(np.floor(np.log10(max(abs(last), 0.1))) - 1.0)
    end = float(number(step * np.floor(last / step)))
    first = next(i for i, s in enumerate(states) if s.approach > end)
    if any(s.rate[APPROACH] < 0.0 for s in states[first:]):
        raise NotConverged(f"{scene.key}: the branch turns where it was to end")
    return end


def solve(scene, levels=POLISH, check=True):
    """The special points of a scene; with `check` they are searched for on a second trace, of other mesh and step."""
    problem, width, load, first = scene.setting()
    ends = {"first_approach": first, "last_load": FIRM if scene.complete_to is None else np.inf,
            "last_approach": np.inf if scene.complete_to is None else scene.complete_to}
    states = trace(problem, TRACE, **ends)
    end = end_of(scene, states)
    marks = before(find_landmarks(problem, states), end)
    if check:
        finer = before(find_landmarks(problem, trace(problem, FINE_TRACE, refine=1.5, **ends)), end)
        if landmark_kinds(finer) != landmark_kinds(marks):
            raise NotConverged(f"{scene.key}: the finer trace has other special points")
        marks = finer
    if problem.law.decay is None and problem.edge_level == 0:
        for state in (mark.state for mark in marks):
            p = np.abs(problem.traction(state.gap))
            if p[-1] > CLOSED * p.max():
                raise NotConverged(f"{scene.key}: the tension is not over at the end of the surface")
    return Solved([converge_mark(problem, mark, levels) for mark in marks], end, width, load)


def before(marks, end):
    """The special points until the approach first exceeds the end."""
    beyond = next((i for i, mark in enumerate(marks) if mark.state.approach > end), len(marks))
    return marks[:beyond]
