#!/usr/bin/env python3
"""The Kesari-Lew envelope of Eq 5 and the effective work of adhesion, Eq 24.

    kesari_lew.py --write [DIR]  regenerate kesari_lew.csv and kesari_lew_edges.csv
    kesari_lew.py --sample       recompute a sample, compare (exit 1 on disagreement)

With the large-argument forms of H0 and H1, x = k a, the ripple of Eq 5 swings between +-c times the
adhesive term, c = 1/(sqrt(pi) alpha_KLJ): the edges are JKR curves of a smooth sphere with the works
of adhesion (1 + c)^2 w (lower edge) and (1 - c)^2 w (upper; for c > 1 its load is nowhere tensile),
the approach shifted by A, since the mean plane of the waviness lies A behind the crest at r = 0:

    load = [4 E* a^3/(3R) - (1 +- c) sqrt(8 pi w E* a^3)]/(pi w R),
    approach = a^2/R + A - (1 +- c) sqrt(2 pi w a/E*).

Eq 5 touches its numerical envelope where the ripple over a^(3/2) is extreme.
"""

import sys

from mpmath import findroot, mpf, pi, sqrt, struveh

from certified import INTERFACE_UNITS, PAPER, Table, command_line, text
from guduru import CURVES, Scene, scenes

DIGITS = 20
TOUCHES = (1, 2, 3, 4, 7, 8, 15, 16, 29, 30)           # indices of extremes of the ripple, from r = 0 on
SCENES = [words for words in scenes() if mpf(words[1]) > 0]
LOAD_BOUND = 1            # |load - edge| < LOAD_BOUND c sqrt(8 pi w E* a^3)/x^2
APPROACH_BOUND = 1        # |approach - edge| < APPROACH_BOUND A/x^(3/2)


def johnson(scene):
    """alpha_KLJ = sqrt(2 lambda w/(pi^2 A^2 E*))."""
    return sqrt(2 * scene.wavelength / (pi * scene.amplitude) ** 2 / scene.modulus)


def swing(scene):
    """c from the leading term of the ripple of Eq 5 over the adhesive term, without the Johnson parameter."""
    ripple = pi * scene.modulus * scene.amplitude * sqrt(2 / pi * scene.number)    # times a^(3/2)
    return ripple / sqrt(8 * pi * scene.modulus)


def edge(scene, sign, a):
    """(load, approach) of the lower (+1) or upper (-1) edge."""
    load_part, depth_part = scene.adhesion(a)
    factor = 1 + sign * swing(scene)
    load = 4 * scene.modulus * a ** 3 / (3 * pi * scene.radius ** 2) - factor * load_part
    return load, a ** 2 / scene.radius + scene.amplitude - factor * depth_part


def least(scene, sign):
    """The greatest tension of an edge, from a search of its minimum; 0 if there is none."""
    factor = 1 + sign * swing(scene)
    if factor <= 0:
        return mpf(0)
    first = (factor ** 2 * scene.radius ** 2 / scene.modulus) ** (mpf(1) / 3)
    a = findroot(lambda a: 4 * scene.modulus * a / scene.radius
                 - factor * sqrt(18 * pi * scene.modulus / a), first)
    return -edge(scene, sign, a)[0]


def pull_off_row(words, agreement):
    scene = Scene(words)
    parameter = johnson(scene)
    c = 1 / (sqrt(pi) * parameter)
    work = (1 + c) ** 2
    upper = max(mpf(0), 1 - c) ** 2
    label = f"envelope {words}"
    agreement.check(label + ", Johnson parameter", c, swing(scene))
    agreement.check(label + ", lower edge", mpf(3) / 2 * work, least(scene, 1))
    agreement.check(label + ", upper edge", mpf(3) / 2 * upper, least(scene, -1), 1)
    force = -scene.formula(scene.pull_off(lambda a: scene.formula(a)[2]))[0]
    return [*words, text(parameter, DIGITS), text(work, DIGITS), text(mpf(3) / 2 * work, DIGITS),
            text(mpf(3) / 2 * upper, DIGITS), text(force, DIGITS),
            text(abs(mpf(3) / 2 * work - force), 3)]


def touch(scene, index):
    """The contact radius at an extreme of (x H0 - H1)/sqrt(x), near x = (index + 3/4) pi."""
    def slope(x):
        h0, h1 = struveh(0, x), struveh(1, x)
        return x * (2 / pi - h1) - h0 / 2 + 3 * h1 / (2 * x)
    guess = (index + mpf(3) / 4) * pi
    x = findroot(slope, guess - mpf(7) / 8 / guess)
    if abs(x - guess) > 0.4:
        raise ValueError(f"extreme {index} of the ripple not found")
    return x / scene.number


def edge_row(point, agreement):
    words, index = point
    scene = Scene(words)
    a = touch(scene, index)
    x = scene.number * a
    sign = 1 if index % 2 else -1
    load, approach, _ = scene.formula(a)
    other_load, other_approach, _ = scene.direct(a)
    label = f"touch {point}"
    load_part, depth_part = scene.adhesion(a)
    agreement.check(label + ", load", load, other_load, abs(load) + load_part)
    agreement.check(label + ", approach", approach, other_approach, abs(approach) + depth_part)
    edge_load, edge_approach = edge(scene, sign, a)
    load_bound = LOAD_BOUND * swing(scene) * load_part / x ** 2
    approach_bound = APPROACH_BOUND * scene.amplitude / x ** mpf(1.5)
    if abs(load - edge_load) > load_bound or abs(approach - edge_approach) > approach_bound:
        raise ValueError(f"{label}: Eq 5 ({text(load, 8)}, {text(approach, 8)}) is further from the "
                         f"edge ({text(edge_load, 8)}, {text(edge_approach, 8)}) than the asymptotics "
                         f"allow ({text(load_bound, 3)}, {text(approach_bound, 3)})")
    return [*words, "lower" if sign > 0 else "upper", str(index), text(a, DIGITS),
            text(edge_load, DIGITS), text(edge_approach, DIGITS), text(load, DIGITS),
            text(approach, DIGITS), text(load_bound, 6), text(approach_bound, 6)]


def known():
    """Compares the limit: Eq 5 with wavelengths of 1/1000 of the contact radius agrees with Eq 24."""
    scene = Scene(("3", "0.02", "0.05", "100"))
    force = -scene.formula(scene.pull_off(lambda a: scene.formula(a)[2]))[0]
    if abs(force / (mpf(3) / 2 * (1 + swing(scene)) ** 2) - 1) > 1e-5:
        raise ValueError("a short wavelength does not meet Eq 24")


def header(what, method, uncertainty, evidence):
    return {
        "what": what,
        "source": f"{PAPER}, Eq 24, after H. Kesari, A. J. Lew, J. Mech. Phys. Solids 59, 2488 (2011) "
                  "and M. Ciavarella (2016)",
        "kind": "oracle",
        "method": method,
        "units": INTERFACE_UNITS,
        "uncertainty": uncertainty,
        "evidence": evidence,
        "generator": "reference/make/kesari_lew.py",
        "command": "python3 reference/make/kesari_lew.py --write",
    }


TABLES = [
    Table("kesari_lew.csv",
          ["tabor", "amplitude", "wavelength", "radius", "johnson", "effective_work", "force",
           "upper_force", "guduru_force", "force_difference"],
          SCENES, pull_off_row,
          header("Johnson parameter, effective work of adhesion (Eq 24), greatest tension of the lower "
                 "edge (force = 3/2 effective_work) and of the upper edge (upper_force; 0: nowhere "
                 "tensile) of the envelope, beside the pull-off of Eq 5 itself (guduru_force)",
                 "closed form against the leading term of Eq 5 and a search of the minimum of the edge",
                 f"half a unit of digit {DIGITS} of the closed forms; as an estimate of the pull-off of "
                 "Eq 5 the envelope is asymptotic, off by force_difference",
                 "both routes for every row"),
          limit="1e-30", tolerance="1e-19", stride=14, checks=known),
    Table("kesari_lew_edges.csv",
          ["tabor", "amplitude", "wavelength", "radius", "edge", "index", "contact_radius", "edge_load",
           "edge_approach", "load", "approach", "load_difference_bound", "approach_difference_bound"],
          [(words, index) for words in CURVES[:5] for index in TOUCHES], edge_row,
          header("both edges of the envelope against Eq 5 where it touches its numerical envelope "
                 "(extremes of the ripple, counted from r = 0): edge_load, edge_approach from the closed "
                 "form, load, approach from Eq 5",
                 "Eq 5 by Struve functions (mpmath, 40 digits) and by Gauss-Legendre quadrature of the "
                 "contact integrals",
                 f"half a unit of digit {DIGITS} of every number; edge against Eq 5: the known asymptotic "
                 f"difference, at most {LOAD_BOUND} c sqrt(8 pi w E* a^3)/(k a)^2 in load and "
                 f"{APPROACH_BOUND} A/(k a)^1.5 in approach (bound columns), held by every row",
                 "both routes for every row"),
          limit="1e-25", tolerance="1e-19", stride=12),
]


if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
