"""Traction-separation laws: one class each.

A law gives, for the gap H (in units of epsilon, 0 at the equilibrium distance), the traction p(H) > 0 compressive
in units of w/epsilon, with p(0) = 0 and int_0^inf (-p) dH = 1, its slope dp/dH and the energy U(H) with
p = -dU/dH, U(0) = -1, U(inf) = 0. `strength` multiplies all three: the solver takes its own unit of traction.

    peak_gap    the gap of the greatest tension
    decay       p ~ -H^-decay far away; None: faster than any power
    room(gap)   a distance over which the law changes little: the solver approaches by a part of it at once
    reach(part) the gap beyond which the tension is below part * w/epsilon
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Mie:
    """Attraction with the power m, repulsion with the power n of 1/(1 + H); Lennard-Jones is (3, 9)."""
    m: float
    n: float
    strength: float = 1.0

    def __post_init__(self):
        if not 1.0 < self.m < self.n:
            raise ValueError(f"mie:{self.m:g},{self.n:g}: expected 1 < m < n (int of the tension is finite)")

    @property
    def factor(self):
        return (self.m - 1.0) * (self.n - 1.0) / (self.n - self.m) * self.strength

    def traction(self, gap):
        attraction = (1.0 + gap)**-self.m
        return -self.factor * (attraction - attraction**(self.n / self.m))

    def slope(self, gap):
        x = 1.0 / (1.0 + gap)
        return self.m * self.factor * (x**(self.m + 1.0) - self.n / self.m * x**(self.n + 1.0))

    def energy(self, gap):
        x = 1.0 / (1.0 + gap)
        return self.factor * (x**(self.n - 1.0) / (self.n - 1.0) - x**(self.m - 1.0) / (self.m - 1.0))

    @property
    def peak_gap(self):
        return (self.n / self.m)**(1.0 / (self.n - self.m)) - 1.0

    @property
    def decay(self):
        return self.m

    def room(self, gap):
        return 1.0 + gap

    def reach(self, part):
        return (self.factor / self.strength / part)**(1.0 / self.m) - 1.0


@dataclass(frozen=True)
class Morse:
    """Steepness a: the energy is e^(-2aH) - 2 e^(-aH). There is no closest gap."""
    a: float
    strength: float = 1.0

    def __post_init__(self):
        if not self.a > 0.0:
            raise ValueError(f"morse:{self.a:g}: expected a > 0")

    def traction(self, gap):
        x = np.exp(-self.a * gap)
        return -2.0 * self.a * self.strength * x * (1.0 - x)

    def slope(self, gap):
        x = np.exp(-self.a * gap)
        return 2.0 * self.a**2 * self.strength * x * (1.0 - 2.0 * x)

    def energy(self, gap):
        x = np.exp(-self.a * gap)
        return self.strength * x * (x - 2.0)

    @property
    def peak_gap(self):
        return np.log(2.0) / self.a

    decay = None

    def room(self, gap):
        return 1.0 / self.a + np.maximum(gap, 0.0)

    def reach(self, part):
        return np.log(2.0 * self.a / part) / self.a


def law_of(text):
    """The law of `mie:m,n` or `morse:a` (in a table: `mie:m;n`)."""
    name, _, rest = text.partition(":")
    try:
        numbers = [float(word) for word in rest.replace(";", ",").split(",")]
        return {"mie": Mie, "morse": Morse}[name](*numbers)
    except (KeyError, TypeError):
        raise ValueError(f"law {text}: expected mie:m,n or morse:a") from None
