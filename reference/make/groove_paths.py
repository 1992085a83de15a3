"""JKR contact with grooves: the branch of equilibria, and loading and unloading at given approach.

A state has edges low, high, low, high... (a first low of 0: a central disc) and an approach. Each edge has the stress
intensity k = 1/sqrt(pi beta), whose energy release rate is w. Where v = 1 - K/k is positive, the contact grows: an edge moves
outwards if it is the high one of a contact, inwards if it is a low one. Units as in groove_tractions, load in pi w R.

Between jumps the branch is followed with the arclength in the edges and the approach. A path ends at a fold, an extremum of
the approach, or where the surfaces touch in a groove or outside; the next stable state is where the energy falls to: edges
move with v, contacts and grooves that shrink to nothing vanish, a contact forms where the surfaces touch.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from groove_tractions import Contact

CONVERGED = 1e-11         # of v
STEP = 1e-6               # of the differences for the Jacobian, of the narrowest width
WIDE = 3e-3               # of those of sixth order
STRIDE = 0.15             # of a step along the branch: of the widths beside an edge
LONGEST = 0.1             # of the approach in such a step
BEYOND = 1e-5             # of the approach at which a jump begins, from the fold
SEED, TINY = 2e-3, 2e-3   # half-width of a contact that forms, width of one that vanishes
NEARBY = 0.01             # distance of equilibria about an event, of the widths beside an edge
OUTSIDE = 1.3             # the gap is examined up to here beyond the outer edge


class Lost(ValueError):
    """Newton's method or a relaxation did not converge."""


@dataclass(frozen=True)
class State:
    edges: tuple
    approach: float
    load: float

    @property
    def grooves(self):
        return max(0, len(self.edges) // 2 - 1)


APART = State((), 0.0, 0.0)


class Scene:
    """alpha = A R/lambda^2, beta = lambda^3 E*/(2 pi w R^2), the digits of a state, and the route to the intensities."""

    def __init__(self, alpha, beta, digits=9, route=Contact):
        self.alpha, self.beta, self.digits, self.route = float(alpha), float(beta), digits, route
        self.k, self.unit = 1.0 / np.sqrt(np.pi * self.beta), 4.0 * np.pi * self.beta

    def contact(self, free, disc):
        return self.route(self.alpha, np.concatenate([[0.0] * disc, free]), self.digits)

    def linear(self, free, disc):
        """v and load as (constant, slope) in the approach."""
        c = self.contact(free, disc)
        return np.stack([1.0 - c.intensity[0] / self.k, -c.intensity[1] / self.k]), self.unit * c.load

    def jacobian(self, free, disc, approach, fine=False):
        """d v/d edge by central differences of second or sixth order."""
        step = (WIDE if fine else STEP) * np.min(widths(free)[:-1])
        stencil = [(1, 0.75), (2, -0.15), (3, 1.0 / 60.0)] if fine else [(1, 0.5)]
        result = np.zeros((len(free), len(free)))
        for j in range(len(free)):
            for m, weight in stencil:
                for way in (1.0, -1.0):
                    moved = free.copy()
                    moved[j] += way * m * step
                    v = self.linear(moved, disc)[0]
                    result[:, j] += way * weight / step * (v[0] + approach * v[1])
        return result

    def state(self, free, disc, approach):
        load = self.linear(free, disc)[1]
        return State(tuple([0.0] * disc + [float(x) for x in free]), float(approach), float(load[0] + approach * load[1]))

    def newton(self, free, disc, approach, row=None):
        """The equilibrium near these edges, at this approach or, given a row of weights of edges and approach, where their
        sum with these weights is that of the guess."""
        y, jacobian, last = np.append(free, approach), None, np.inf
        row = np.append(np.zeros(len(free)), 1.0) if row is None else row
        value = row @ y
        for _ in range(16):
            free, approach = y[:-1], y[-1]
            v = self.linear(free, disc)[0]
            now = v[0] + approach * v[1]
            size = np.max(np.abs(now))
            if size < CONVERGED:
                return free, approach
            if jacobian is None or size > 0.1 * last:
                jacobian = np.vstack([np.column_stack([self.jacobian(free, disc, approach), v[1]]), row])
            last = size
            move = np.linalg.solve(jacobian, -np.append(now, row @ y - value))
            room = near(free)
            far = np.max(np.abs(move[:-1]) / room)
            if not far < 3.0:
                raise Lost(f"a step of {far:.2g} widths")
            y = y + move * min(1.0, 0.3 / far if far > 0.0 else 1.0)
        raise Lost(f"v = {size:.2g} after 16 steps")

    def tangent(self, free, disc, approach, fine=False):
        """The direction of the branch in edges and approach, d load along it, and whether the energy is a minimum.

        The energy release rates are the derivatives of the elastic energy by the area of contact, and the load is that by the
        approach; hence d load/d edge = +-unit edge K dK/d approach.
        """
        v, load = self.linear(free, disc)
        jacobian = self.jacobian(free, disc, approach, fine)
        way = np.linalg.svd(np.column_stack([jacobian * near(free), v[1]]))[2][-1]
        way = way * np.append(near(free), 1.0)
        sign = signs(free, disc)
        rise = load[1] * way[-1] - self.unit * (sign * free * self.k**2 * (1.0 - v[0] - approach * v[1]) * v[1]) @ way[:-1]
        stable = np.max(np.linalg.eigvals(sign[:, None] * jacobian).real) < 0.0
        return way, rise, stable

    def gap_minimum(self, free, disc, approach):
        """The radius outside of the contacts where the gap is least, and that gap."""
        contact = self.contact(free, disc)
        ends = np.append(free, free[-1] + OUTSIDE) if disc else np.concatenate([[0.0], free, [free[-1] + OUTSIDE]])
        best = (np.nan, np.inf)
        for low, high in zip(ends[::2], ends[1::2]):
            r = np.linspace(low, high, max(12, int(40 * (high - low))) + 2)[1:-1]
            gap = contact.gap(approach, r)
            inner = np.flatnonzero((gap[1:-1] < gap[:-2]) & (gap[1:-1] <= gap[2:])) + 1
            if len(inner):
                i = inner[np.argmin(gap[inner])]
                fit = minimize_scalar(lambda x: contact.gap(approach, np.array([x]))[0], bounds=(r[i - 1], r[i + 1]),
                                      method="bounded", options={"xatol": 1e-9})
                best = min(best, (float(fit.x), float(fit.fun)), key=lambda pair: pair[1])
            if np.min(gap) < best[1] and np.min(gap) < 0.0:
                i = np.argmin(gap)
                best = (r[i], gap[i])
        return best

    def relax(self, edges, approach, power=1.0):
        """The stable state into which the energy falls from these edges at given approach, APART if no contact remains. The
        mobility of an edge is a power of the narrower width beside it."""
        edges, last, gain = list(edges), None, STRIDE
        for turn in range(3000):
            disc = int(edges[0] == 0.0)
            free = np.array(edges[disc:])
            v = self.linear(free, disc)[0]
            now = v[0] + approach * v[1]
            if turn % 5 == 0:
                r, gap = self.gap_minimum(free, disc, approach)
                if gap < 0.0 and np.min(np.abs(r - free)) > 3.0 * SEED:
                    edges = sorted(edges + [r - SEED, r + SEED])
                    last = None
                    continue
                if np.max(np.abs(now)) < 0.05:
                    found = self.settled(free, disc, approach)
                    if found:
                        return found
            move = signs(free, disc) * near(free)**power * now / (1.0 + np.abs(now))
            same = last is not None and len(last) == len(move) and move @ last > 0.5 * np.sqrt(move @ move * (last @ last))
            gain = STRIDE if last is None or len(last) != len(move) else 1.5 * gain if same else 0.5 * gain
            gain = min(gain, STRIDE / np.max(np.abs(move) / near(free)))
            last = move
            edges = [0.0] * disc + list(free + gain * move)
            edges = self.without_vanished(edges, disc, now)
            if not edges:
                return APART
        raise Lost(f"relaxation at approach {approach:.6g}")

    def settled(self, free, disc, approach):
        """The stable equilibrium here, if there is one."""
        try:
            found, _ = self.newton(free, disc, approach)
        except (Lost, np.linalg.LinAlgError):
            return None
        if np.max(np.abs(found - free)) > 0.05 or not self.tangent(found, disc, approach)[2]:
            return None
        return self.state(found, disc, approach) if self.gap_minimum(found, disc, approach)[1] >= 0.0 else None

    @staticmethod
    def without_vanished(edges, disc, v):
        """The edges without the first contact or groove that is narrow and becomes narrower."""
        v = np.concatenate([[v[0]] * disc, v])
        for i, width in enumerate(np.diff(edges)):
            contact = i % 2 == 0
            if width < TINY and (v[i] + v[i + 1] < 0.0 if contact else v[i] + v[i + 1] > 0.0):
                return edges[:i] + edges[i + 2:]
        return edges

    def walk(self, state, target):
        """Events from a stable state at given approach until the target: (kind, State), the last of kind "end", or "fold" or
        "touch" if the path ends before. The others are "minimum" and "maximum", of the load."""
        disc = int(bool(state.edges) and state.edges[0] == 0.0)
        free, approach = np.array(state.edges[disc:]), state.approach
        way = np.sign(target - approach)
        tangent, rise, _ = self.tangent(free, disc, approach)
        if tangent[-1] * way < 0.0:
            tangent, rise = -tangent, -rise
        length = 0.02
        while way * (target - approach) > 0.0:
            scale = np.append(1.0 / near(free), 1.0)
            pace = max(np.max(np.abs(tangent[:-1] * scale[:-1])) / STRIDE, abs(tangent[-1]) / LONGEST)
            length = min(2.0 * length, 1.0 / pace)
            if way * tangent[-1] * length > way * (target - approach):
                length = (target - approach) / tangent[-1]

            def step(size, fine=False):
                y = np.append(free, approach) + size * tangent
                new, there = self.newton(y[:-1], disc, y[-1], tangent * scale**2)
                direction, change, stable = self.tangent(new, disc, there, fine)
                if direction @ (tangent * scale**2) < 0.0:
                    direction, change = -direction, -change
                return new, there, direction, change, stable

            try:
                new = step(length)
            except (Lost, np.linalg.LinAlgError):
                length *= 0.25
                if length * pace < 1e-6:
                    raise Lost(f"the branch beyond approach {approach:.6g}") from None
                continue
            if way * (new[1] - target) > -1e-9:
                found, _ = self.newton(new[0], disc, target)
                direction, change, stable = self.tangent(found, disc, target)
                back = -1.0 if direction @ new[2] < 0.0 else 1.0
                new = (found, target, back * direction, back * change, stable)
            folded = new[2][-1] * tangent[-1] < 0.0
            if folded:
                length = crossing(lambda s: step(s, True)[2][-1], length)
                new = step(length)
            if rise * new[3] < 0.0:
                point = step(crossing(lambda s: step(s, True)[3], length))
                if not self.touch(point[0], disc, point[1]):
                    yield ("minimum" if rise < 0.0 else "maximum"), self.state(point[0], disc, point[1])
            if self.touch(new[0], disc, new[1]):
                point = step(crossing(lambda s: self.gap_minimum(*step(s)[:1], disc, step(s)[1])[1], length))
                yield "touch", self.state(point[0], disc, point[1])
                return
            if folded:
                self.direction = new[0] - free
                yield "fold", self.state(new[0], disc, new[1])
                return
            free, approach, tangent, rise, stable = new
            if not stable:
                raise Lost(f"an unstable state at approach {approach:.6g} before a fold")
        yield "end", self.state(free, disc, approach)

    def touch(self, free, disc, approach):
        return self.gap_minimum(free, disc, approach)[1] < 0.0

    def exact(self, kind, state, model):
        """The event of this kind near a state found with the scene `model`, from seven equilibria along the branch and the
        polynomial through them; of "end" and "jump" the equilibrium at the approach of the state."""
        if not state.edges:
            return state
        disc = int(state.edges[0] == 0.0)
        free, approach = np.array(state.edges[disc:]), state.approach
        still = kind in ("end", "jump")
        if still:
            way = row = np.append(np.zeros(len(free)), 1.0)
        else:
            way = model.tangent(free, disc, approach)[0]
            row = np.append(way[:-1] / near(free)**2, 0.0)               # along the edges, which no fold turns back
        place = np.append(free, approach)

        def equilibrium(s):
            """Edges, approach and load at the place s along the branch; the Jacobian is that of the model."""
            value = row @ (place + s * way)
            y = np.append(*model.newton(free + s * way[:-1], disc, approach + s * way[-1], row))
            v = model.linear(y[:-1], disc)[0]
            jacobian = np.vstack([np.column_stack([model.jacobian(y[:-1], disc, y[-1]), v[1]]), row])
            last = np.inf
            for _ in range(20):
                v, load = self.linear(y[:-1], disc)
                now = np.append(v[0] + y[-1] * v[1], row @ y - value)
                size = np.max(np.abs(now))
                if size < CONVERGED or (size < 1e-9 and size > 0.5 * last):
                    return [*y, load[0] + y[-1] * load[1]]
                last = size
                y = y - np.linalg.solve(jacobian, now)
            raise Lost(f"{kind} at approach {approach:.6g}: v = {last:.2g}")

        def state_of(y):
            return State(tuple([0.0] * disc + [float(x) for x in y[:len(free)]]), float(y[len(free)]), float(y[len(free) + 1]))

        if still:
            return state_of(equilibrium(0.0))
        places = NEARBY / np.max(np.abs(way[:-1]) / near(free)) * np.arange(-3, 4)
        found = [equilibrium(s) for s in places]
        table = np.array(found)
        if kind == "touch":
            table = np.column_stack([table, [self.gap_minimum(np.array(y[:-2]), disc, y[-2])[1] for y in found]])
        curves = [np.polynomial.Polynomial.fit(places, column, 6) for column in table.T]
        zero = curves[-1] if kind == "touch" else (curves[-2] if kind == "fold" else curves[-1]).deriv()
        roots = [x.real for x in zero.roots() if abs(x.imag) < 1e-12 and abs(x) < places[-1]]
        if not roots:
            raise Lost(f"{kind} at approach {approach:.6g}: none nearby")
        s = min(roots, key=abs)
        return state_of([curve(s) for curve in curves])

    def follow(self, state, target):
        """Every event from a stable state to the approach `target`, jumps included: (kind, State). After a fold or a touch
        comes "jump", the state that the jump reaches. Ends early if the bodies separate."""
        while True:
            for kind, state in self.walk(state, target):
                yield kind, state
            if kind == "end":
                return
            state = self.jump(kind, state, np.sign(target - state.approach))
            yield "jump", state
            if state is APART:
                return

    def jump(self, kind, state, way):
        """The stable state after a fold or a touch; both mobilities of the edges must lead to the same."""
        disc = int(state.edges[0] == 0.0)
        edges, approach = np.array(state.edges), state.approach + way * BEYOND
        if kind == "fold":
            edges[disc:] += STRIDE * self.direction / np.max(np.abs(self.direction) / near(edges[disc:]))
        else:
            r = self.gap_minimum(edges[disc:], disc, state.approach)[0]
            edges, approach = np.sort(np.append(edges, [r - SEED, r + SEED])), state.approach
        found, other = (self.relax(edges, approach, power) for power in (1.0, 0.5))
        if len(found.edges) != len(other.edges) or (found.edges and np.max(np.abs(np.subtract(found.edges, other.edges))) > 1e-8):
            raise Lost(f"the jump at approach {approach:.6g} depends on the mobilities")
        if found is APART:
            return APART
        disc = int(found.edges[0] == 0.0)
        free, approach = self.newton(np.array(found.edges[disc:]), disc, state.approach)
        return self.state(free, disc, approach)

    def first(self):
        """The state after first contact: the surfaces touch at the axis at approach 0."""
        return self.relax([0.0, 0.05], 0.0)


def crossing(function, length):
    """The zero of a function between 0 and length; the end that is nearer to 0 if its sign does not change."""
    ends = [(function(x), x) for x in (0.0, length)]
    if ends[0][0] * ends[1][0] >= 0.0:
        return min(ends, key=lambda end: abs(end[0]))[1]
    return brentq(function, 0.0, length, xtol=1e-13)


def widths(free):
    """Widths between edges, from the axis, and 1 beyond the last."""
    return np.append(np.diff(np.concatenate([[0.0], free])), 1.0)


def near(free):
    """The narrower width beside each edge."""
    width = widths(free)
    return np.minimum(width[:-1], width[1:])


def signs(free, disc):
    """1 for the high edge of a contact, -1 for a low one."""
    return np.where((np.arange(len(free)) + disc) % 2, 1.0, -1.0)
