"""Unloading of a viscoelastic half-space at constant speed, from the relaxed contact at a preload, or after loading
at constant speed from a distance, where it has not crept, and a dwell at that approach.

    H(r, t) = f(r) - D(t) + kappa G [k p(H) + sum_m z_m],    tau_m dz_m/dt + z_m = (1 - k) w_m p,    D = D0 - V t

with kappa that of the relaxed solid, the tractions z_m of Kelvin elements, and the units of branch.py. Through a spring
its base, at D + W/stiffness, has the speed V. Space: the
spectral panels of copson.py, narrow wherever the edge of the contact is until it ends, so that nothing is transferred
between meshes. Time: a diagonally implicit Runge-Kutta method of order 4 (Kennedy and Carpenter, Appl. Numer. Math. 44,
139 (2003), ARK4(3)6L[2]SA, implicit part) on the differential-algebraic system; its stages are elastic scenes.

Where the glassy scene (z_m frozen) has a fold no solution goes on. There the surfaces relax at frozen z_m and given
approach, against a local damping (stable_paths.py), to the next stable equilibrium.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.linalg import lu_factor, lu_solve
from scipy.optimize import brentq

from branch import CLOSEST_GAP, Level, NotConverged, State, correct, make_surface, remesh
from contact import contact_radius
from copson import Surface
from creep import creep
from stable_paths import come_to_rest

C = np.array([0.0, 1 / 2, 83 / 250, 31 / 50, 17 / 20, 1.0])
A = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
              [1 / 4, 1 / 4, 0.0, 0.0, 0.0, 0.0],
              [8611 / 62500, -1743 / 31250, 1 / 4, 0.0, 0.0, 0.0],
              [5012029 / 34652500, -654441 / 2922500, 174375 / 388108, 1 / 4, 0.0, 0.0],
              [15267082809 / 155376265600, -71443401 / 120774400, 730878875 / 902184768, 2285395 / 8070912, 1 / 4, 0.0],
              [82889 / 524892, 0.0, 15625 / 83664, 69875 / 102672, -2260 / 8211, 1 / 4]])
B = A[-1]
B_OTHER = np.array([4586570599 / 29645900160, 0.0, 178811875 / 945068544, 814220225 / 1159782912, -3700637 / 11593932,
                    61727 / 225920])      # of order 3
DIAGONAL = 0.25

ROUNDS, DONE = 30, 1e-9   # of Newton's method in a stage, and its last update
SLOW = 0.2                # the matrix is factorised again where an update exceeds this part of the one before,
LARGE, LARGEST = 0.5, 2.0  # ... or this change of 1 + H, relative; a step is refused where one exceeds the other
FIRST = 1e-3              # first step, in epsilon/V or in tau_0, the shorter of both
SAFETY, GROWTH, LEAST_PART, FAILED_PART = 0.85, 2.0, 0.2, 0.4    # of steps: over the predicted one, over the one before
FOLD = 1e-9               # steps end at a fold where they are shorter than this part of the time since the start
AT_FOLD = 1e-8            # ... or than the shorter of this part of epsilon/V and of tau_0/100
BEYOND = 1e-4             # distance beyond the fold at which the relaxation starts
MOVED = 0.02              # change of 1 + H, relative, that is a jump
MOST_STEPS = 4000
START = -10.0             # approach at which loading at a speed begins
FAR = 15.0                # gap added to the initial gap where loading begins
COARSE, COARSE_WIDTH = Level(order=6, tail=10, tolerance=1e-6), 2.5  # of the mesh on which surfaces relax
AT_APPROACH = np.array([1.0, 0.0, 0.0])
PART_OF_WAVE = 0.2        # widest panel over the wavelength
EARLY, LATE = 0.1, 100.0  # first step in time of a relaxation, and of its continuation on the narrow panels
WIDE_GAP = 12.0           # gap from which the panels become wider


@dataclass(frozen=True)
class Accuracy:
    """Order of the panels and of the mapped panel, their width over the length of the edge, the tolerance of a step (gap in
    epsilon, energies in pi w R epsilon), the unresolved part of the relaxed traction, the start of the mapped panel
    (relative), the refinement of a Gamma spectrum."""
    order: int
    tail: int
    width: float
    step: float
    traction: float = 1e-7
    cut: float = 1.0
    spectrum: float = 1.0


@dataclass(frozen=True)
class Moment:
    """A state at a time: position of the base, gap, tractions z_m (n, m) and their rates, load and its rate, work of the
    base, dissipation."""
    time: float
    base: float
    gap: np.ndarray
    z: np.ndarray
    z_rate: np.ndarray
    load: float
    load_rate: float
    gap_rate: np.ndarray
    work: float
    dissipated: float


@dataclass
class Unloaded:
    """What a test measures; energies in pi w R epsilon, radii in Gamma, times in tau_0."""
    force: float = -np.inf
    approach: float = np.nan
    contact_radius: float = np.nan
    time: float = np.nan
    work: float = np.nan
    dissipated: float = np.nan
    jump_loss: float = 0.0
    end_approach: float = np.nan
    energy_change: float = np.nan
    loading_work: float = np.nan
    loading_dissipated: float = np.nan
    loading_loss: float = np.nan
    loading_imbalance: float = 0.0
    steps: int = 0
    nodes: int = 0
    jumps: list = field(default_factory=list)

    @property
    def imbalance(self):
        return self.work - self.energy_change - self.dissipated - self.jump_loss


@dataclass(frozen=True)
class Frozen:
    """The initial gap of the glassy scene, on the nodes of the mesh."""
    undeformed: np.ndarray

    def gap(self, _):
        return self.undeformed


@dataclass(frozen=True)
class Loading:
    """Loading at a speed from the approach START, and how long the approach of the preload is held."""
    speed: float
    dwell: float


class Test:
    """One test: a problem (branch.py), the preload (an approach), the spectrum, k, the speed, the stiffness of a spring,
    the loading (None: the body is relaxed at the preload)."""

    def __init__(self, problem, preload, spectrum, k, speed, accuracy, stiffness=np.inf, loading=None):
        self.spring = self.soft = 1.0 / stiffness
        self.held = np.array([1.0, self.soft, 0.0])          # the base, of (approach, load, central gap)
        self.problem, self.preload, self.speed, self.accuracy = problem, preload, speed, accuracy
        self.unload_speed, self.loading = speed, loading
        fastest = max([speed, *([loading.speed, 1.0 / max(loading.dwell, 1e-3)] if loading else [])])
        self.creep = creep(spectrum, k, fastest, accuracy.spectrum)
        self.coarse = make_surface(problem, COARSE, lambda low, high: self.too_wide(low, high, COARSE_WIDTH))
        relaxed = self.relaxed()
        self.surface = surface = self.divided(relaxed.surface)
        self.undeformed = problem.profile.gap(surface.u)
        elastic = relaxed.gap + preload - problem.profile.gap(relaxed.surface.u)
        gap = self.undeformed - preload + relaxed.surface.interpolate(elastic, surface.u, 1)
        self.first = correct(problem, surface, gap, preload, AT_APPROACH, preload).gap
        self.operator = problem.elastic * surface.deflection
        self.weights = surface.weights
        self.unresolved = 0.0
        self.lu = None

    def too_wide(self, low, high, width):
        """Whether a panel is wider than the edge of the contact, of the relaxed one where `width` is 1. Where the gap is
        always wide the panels grow with it."""
        problem = self.problem
        mu = problem.elastic
        width *= min(mu**-2, (mu * (1.0 + max(self.preload, 0.0)))**-0.5)
        gap = (problem.profile.gap(low + np.linspace(0.0, 1.0, 9) * (high - low)) - self.preload).min()
        width *= max(1.0, gap / WIDE_GAP)
        for wave in getattr(problem.profile, "waves", ()):
            if wave.amplitude and gap < 100.0:
                width = min(width, PART_OF_WAVE * 2.0 * np.pi / wave.number)
        return high - low > width

    def relaxed(self):
        """The relaxed equilibrium at the preload that slow loading reaches, on panels that resolve it."""
        problem, accuracy, preload = self.problem, self.accuracy, self.preload
        level = Level(accuracy.order, accuracy.tail, accuracy.traction, accuracy.cut)
        surface, gap = self.coarse, problem.profile.gap(self.coarse.u) + FAR
        gap = come_to_rest(problem, surface, (1.0, 0.0, preload), gap, preload, EARLY)[0]
        finer = make_surface(problem, level, lambda low, high: self.too_wide(low, high, COARSE_WIDTH))
        elastic = surface.interpolate(gap + preload - problem.profile.gap(surface.u), finer.u, 1)
        gap = come_to_rest(problem, finer, (1.0, 0.0, preload), problem.profile.gap(finer.u) - preload + elastic, preload,
                           LATE)[0]
        state = correct(problem, finer, gap, preload, AT_APPROACH, preload)
        return remesh(problem, state, level, AT_APPROACH, preload)

    def divided(self, surface):
        """The panels of a surface, halved where they are too wide for the moving edge of the contact."""
        edges = [0.0]
        for low, high in zip(surface.edges, surface.edges[1:]):
            stack = [(low, high)]
            while stack:
                low, high = stack.pop()
                middle = 0.5 * (low + high)
                if self.too_wide(low, high, self.accuracy.width):
                    stack += [(middle, high), (low, middle)]
                else:
                    edges.append(high)
        return Surface(edges, surface.order, surface.tail, surface.extra, *(self.problem.decay if surface.tail else ()))

    # Equilibria

    def factorised(self, gap, coupling):
        """The factors of the matrix of Newton's method."""
        matrix = -(coupling * self.operator + self.soft * self.weights) * self.problem.law.slope(gap)[None, :]
        matrix.flat[::self.surface.size + 1] += 1.0
        return lu_factor(matrix, overwrite_a=True, check_finite=False)

    def equilibrium(self, gap, history, coupling, base):
        """The gap near `gap` where H + D - f - kappa G (history + coupling p) = 0; None if there is none. The matrix of
        Newton's method is kept as long as updates become small fast, also from one stage of a step to the next."""
        law = self.problem.law
        fixed = self.undeformed - base + self.operator @ history
        gap, last, fresh = gap.copy(), np.inf, False
        for _ in range(ROUNDS):
            if self.lu is None:
                self.lu, fresh, last = self.factorised(gap, coupling), True, np.inf
            p = law.traction(gap)
            residual = fixed + coupling * (self.operator @ p) + self.soft * (self.weights @ p) - gap
            update = lu_solve(self.lu, residual, check_finite=False)
            size, shrink = np.max(np.abs(update) / (1.0 + np.abs(gap))), np.max(-update / law.room(gap))
            if not size < LARGEST:
                return None
            if size > SLOW * last or shrink > CLOSEST_GAP or size > LARGE:
                self.lu = None
                if fresh:
                    gap, fresh = gap + update * min(1.0, CLOSEST_GAP / max(shrink, 1e-300)), False
                continue
            gap, last, fresh = gap + update, size, False
            if size < DONE:
                return gap
        return None

    def glassy_rates(self, gap, z_rate):
        """dH/dt and dW/dt."""
        rate = lu_solve(self.factorised(gap, self.creep.k), self.speed + self.operator @ z_rate.sum(axis=1))
        return rate, self.weights @ (self.problem.law.slope(gap) * rate)

    def rest(self, history, gap, base, target):
        """The equilibrium of the glassy scene, with the base at `target`, next to the one to which the surfaces relax from a
        gap with the base at `base`, with the deflection of the history. The relaxation itself takes wider panels."""
        coarse, fine, profile = self.coarse, self.surface, self.problem.profile
        elastic, undeformed = self.creep.k * self.problem.elastic, profile.gap(coarse.u)
        wide = replace(self.problem, elastic=elastic, profile=Frozen(undeformed + fine.interpolate(history, coarse.u, 1)))
        approach = base - self.soft * (self.weights @ self.problem.traction(gap))
        first = undeformed - approach + fine.interpolate(gap + approach - self.undeformed, coarse.u, 1)
        gap, approach = come_to_rest(wide, coarse, (1.0, self.soft, base), first, approach, EARLY)
        gap = self.undeformed - approach + coarse.interpolate(gap + approach - undeformed, fine.u, 1)
        narrow = replace(self.problem, elastic=elastic, profile=Frozen(self.undeformed + history))
        gap, approach = come_to_rest(narrow, fine, (1.0, self.soft, target), gap, approach, LATE)
        return correct(narrow, fine, gap, approach, self.held, target).gap

    # Energies

    def stored(self, gap, z):
        """Of the elastic half-space, of the attraction and of the spring."""
        p = self.problem.traction(gap)
        elastic = 0.5 * self.creep.k * p * (self.operator @ p)
        for part, one in zip(self.creep.parts, z.T):
            if part > 0.0:
                elastic = elastic + 0.5 * one * (self.operator @ one) / part
        return self.surface.load(elastic + self.problem.law.energy(gap)) + 0.5 * self.soft * self.surface.load(p)**2

    def dissipation(self, z_rate):
        """Per time."""
        parts = self.creep.parts > 0.0
        rate = z_rate[:, parts]
        factor = self.creep.times[parts] / self.creep.parts[parts]
        return self.weights @ ((rate * (self.operator @ rate)) @ factor)

    # Time

    def step(self, now, h):
        """The moment a time h later, and the error of the step; None if Newton's method fails."""
        x = h / self.creep.times
        share = DIAGONAL * x / (1.0 + DIAGONAL * x)
        coupling = self.creep.k + self.creep.parts @ share
        rates, loads, losses = [now.z_rate], [now.load], [self.dissipation(now.z_rate)]
        gap, self.lu = now.gap, None
        for i in range(1, 6):
            begin = now.z + h * sum(a * r for a, r in zip(A[i], rates) if a)
            history = (begin / (1.0 + DIAGONAL * x)).sum(axis=1)
            base = now.base - self.speed * C[i] * h
            guess = now.gap + C[i] * h * now.gap_rate if i == 1 else gap + (C[i] - C[i - 1]) * h * now.gap_rate
            far = np.max(np.abs(guess - gap) / (1.0 + np.abs(gap))) > 0.2
            gap = self.equilibrium(gap if far else guess, history, coupling, base)
            if gap is None:
                return None
            p = self.problem.traction(gap)
            z = begin / (1.0 + DIAGONAL * x) + p[:, None] * (self.creep.parts * share)
            rates.append((z - begin) / (DIAGONAL * h))
            loads.append(self.weights @ p)
            losses.append(self.dissipation(rates[-1]))
        wrong = h * sum((b - c) * (r / (1.0 + DIAGONAL * x)) for b, c, r in zip(B, B_OTHER, rates)).sum(axis=1)
        error = max(np.max(np.abs(self.operator @ wrong)), abs(self.speed) * h * abs((B - B_OTHER) @ loads),
                    h * abs((B - B_OTHER) @ losses))
        gap_rate, load_rate = self.glassy_rates(gap, rates[-1])
        after = Moment(now.time + h, base, gap, z, rates[-1], loads[-1], load_rate, gap_rate,
                       now.work - self.speed * h * (B @ loads), now.dissipated + h * (B @ losses))
        return after, error

    def begin(self, gap, z, time, base, work, dissipated):
        """A moment with rates of its own: at the start, and after a jump."""
        p = self.problem.traction(gap)
        z_rate = (p[:, None] * self.creep.parts - z) / self.creep.times
        gap_rate, load_rate = self.glassy_rates(gap, z_rate)
        return Moment(time, base, gap, z, z_rate, self.weights @ p, load_rate, gap_rate, work, dissipated)

    def opening(self, gap):
        """The least gap less that of the greatest tension: positive where there is no contact."""
        return min(self.surface.centre @ gap[:self.surface.order], gap.min()) - self.problem.law.peak_gap

    def jump(self, now):
        """The next stable equilibrium of the glassy scene, with the energy that is lost."""
        history = self.operator @ now.z.sum(axis=1)
        past, sense = BEYOND, np.sign(self.speed)
        while past < 0.1:
            gap = self.rest(history, now.gap + sense * past, now.base - sense * past, now.base)
            if np.max(sense * (gap - now.gap) / (1.0 + np.abs(now.gap))) > MOVED:
                lost = self.stored(now.gap, now.z) - self.stored(gap, now.z)
                return self.begin(gap, now.z, now.time, now.base, now.work, now.dissipated), lost
            past *= 4.0
        raise NotConverged(f"no fold at time {now.time:g}, where the steps end")

    def locate(self, now, h, of):
        """The moment within a step of length h at which of(moment) vanishes."""
        def at(part):
            found = self.step(now, part)
            if found is None:
                raise NotConverged("a shorter step does not converge")
            return found[0]
        root = brentq(lambda part: of(at(part)), 1e-6 * h, h, xtol=1e-13 * h, rtol=1e-12)
        return at(root)

    def approach(self, moment):
        """Of the base, less the stretch of the spring."""
        return moment.base - self.soft * moment.load

    def keep(self, result, moment):
        """Takes a moment as that of the greatest tension."""
        if -moment.load > result.force:
            approach = self.approach(moment)
            state = State(self.surface, moment.gap, approach, moment.load, 0.0)
            result.force, result.approach, result.time = -moment.load, approach, moment.time
            result.contact_radius = contact_radius(self.problem, state)

    def fallen(self, now, result):
        """The moment after the jump at the fold where steps end."""
        if self.speed > 0.0:
            self.keep(result, now)
        now, lost = self.jump(now)
        result.jump_loss += lost
        result.jumps.append((now.time, self.approach(now), lost))
        return now

    def passed(self, now, h, after, result):
        """Takes the greatest tension of a step of length h, and how far the panels resolve it."""
        self.unresolved = max(self.unresolved, self.surface.roughness(self.problem.traction(after.gap)).max())
        if self.speed > 0.0 and now.load_rate < 0.0 <= after.load_rate:
            self.keep(result, self.locate(now, h, lambda m: m.load_rate))

    def until(self, now, result, beyond, end=np.inf):
        """Steps from a moment until beyond(moment) > 0, or until a time. Returns the last moment."""
        speed = max(abs(self.speed), 1.0)
        h, shortest = FIRST / speed, AT_FOLD / (abs(self.speed) or 1.0)
        while result.steps < MOST_STEPS:
            result.steps += 1
            last = now.time + h >= end
            h = end - now.time if last else h
            found = self.step(now, h)
            error = np.inf if found is None else found[1]
            if error < self.accuracy.step:
                after = found[0]
                self.passed(now, h, after, result)
                if last or beyond(after) > 0.0:
                    return after if last else self.locate(now, h, beyond)
                now = after
                h *= min(GROWTH, SAFETY * (self.accuracy.step / max(error, 1e-300))**0.25)
                continue
            h *= FAILED_PART if found is None else max(LEAST_PART, SAFETY * (self.accuracy.step / error)**0.25)
            if h < max(FOLD * now.time, min(shortest, 0.01 * AT_FOLD)):
                now = self.fallen(now, result)
                if beyond(now) > 0.0:
                    return now
                h = FIRST * shortest
        raise NotConverged(f"{MOST_STEPS} steps")

    def relaxed_moment(self):
        """The relaxed contact at the preload."""
        p = self.problem.traction(self.first)
        return self.begin(self.first, p[:, None] * self.creep.parts, 0.0, self.preload + self.soft * self.surface.load(p),
                          0.0, 0.0)

    def loaded(self, result):
        """The moment after loading and dwell; the result has the work and the losses of these."""
        surface = self.surface
        glassy = replace(self.problem, elastic=self.creep.k * self.problem.elastic, profile=Frozen(self.undeformed))
        first = correct(glassy, surface, self.undeformed - START, START, AT_APPROACH, START).gap
        z = np.zeros((surface.size, self.creep.times.size))
        self.speed = -self.loading.speed
        base = START + self.soft * surface.load(self.problem.traction(first))
        now = self.until(self.begin(first, z, 0.0, base, 0.0, 0.0), result, lambda m: self.approach(m) - self.preload)
        if self.loading.dwell > 0.0:
            self.speed = self.soft = 0.0
            held = self.begin(now.gap, now.z, 0.0, self.preload, 0.0, 0.0)
            held = self.until(held, result, lambda _: -1.0, self.loading.dwell)
            self.soft = self.spring
            # the base follows the spring: its work is the change of the energy of the spring
            stretched = 0.5 * self.soft * (held.load**2 - now.load**2)
            now = replace(held, work=now.work + stretched, dissipated=now.dissipated + held.dissipated)
        result.loading_work, result.loading_dissipated, result.loading_loss = now.work, now.dissipated, result.jump_loss
        result.loading_imbalance = (now.work - now.dissipated - result.jump_loss - self.stored(now.gap, now.z)
                                    + self.stored(first, z))
        result.jump_loss = 0.0
        result.jumps.clear()
        self.speed = self.unload_speed
        return self.begin(now.gap, now.z, 0.0, self.preload + self.soft * now.load, 0.0, 0.0)

    def run(self):
        """The test, up to the end of contact."""
        result = Unloaded(nodes=self.surface.size)
        first = self.loaded(result) if self.loading else self.relaxed_moment()
        now = self.until(first, result, lambda m: self.opening(m.gap))
        result.work, result.dissipated, result.end_approach = now.work, now.dissipated, self.approach(now)
        result.energy_change = self.stored(now.gap, now.z) - self.stored(first.gap, first.z)
        return result
