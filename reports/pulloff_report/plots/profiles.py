"""Pull-off of several profiles relative to their JKR limit, against a stiffness that is the Tabor parameter of a sphere."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import plain, value_of
from .figure import BLACK, BLUE, GREEN, ORANGE, PURPLE, VERMILLION, Figure, failures

NUMBER = None
TITLE = "Pull-off of six profiles relative to the JKR theory"
JKR = "jkr_pull_off.csv"
COLOURS, SHAPES = (BLUE, VERMILLION, GREEN, PURPLE, ORANGE, BLACK), (6, 4, 8, 12, 10, 1)
SPHERE = math.sqrt(2 * math.pi) * (9 * math.pi / 8) ** (1 / 6)  # sqrt(2 pi c a) = SPHERE mu for the sphere
LEAST = 0.03    # of the axis


def profile_name(point):
    """The profile of a point in words."""
    scene = point["input"]
    if scene["profile"] == "power":
        return gnuplot.Enhanced(f"r^{{{gnuplot.literal(plain(scene['power_n']))}}}")
    if scene["profile"] == "sphere":
        return "sphere, two waves" if scene["waves"] else "sphere"
    return {"cone": "cone", "punch": "rounded punch", "truncated": "truncated sphere", "exact_sphere": "exact sphere",
            "hyperboloid": "hyperboloid"}[scene["profile"]]


def key_of(point):
    """Profile, waves and coupling of a point, as a table of reference data names them."""
    scene = point["input"]
    parameters = [f"{value:.12g}" for key, value in scene.items()
                  if key.startswith(f"{scene['profile']}_") and value is not None]
    return (scene["profile"] + (":" + ";".join(parameters) if parameters else ""), scene["waves"] or "-",
            f"{value_of(point, 'coupling'):.6g}")


def limits(references):
    """Profile, waves and coupling -> (force, contact radius) of the JKR theory."""
    table = references.table(JKR)
    if table is None:
        return {}
    columns = table.columns
    return {(profile, waves, f"{float(coupling):.6g}"): (float(force), float(radius)) for profile, waves, coupling, force, radius in
            zip(columns["profile"], columns["waves"], columns["coupling"], columns["force"], columns["contact_radius"])}


def stiffness(point, radius):
    """The depth of the neck of a JKR contact at pull-off, as the Tabor parameter of a sphere with the same depth."""
    return math.sqrt(2 * math.pi * value_of(point, "coupling") * radius) / SPHERE


def make(case, references):
    known, ratios = limits(references), {}
    for point in case.points:
        jkr = known.get(key_of(point))
        if jkr and point["status"] == "ok" and point.get("pull_off"):
            x = stiffness(point, jkr[1])
            if x >= LEAST:
                ratios.setdefault(profile_name(point), []).append((x, point["pull_off"]["force"] / jkr[0]))
    away = [[(x, abs(y - 1)) for x, y in rows if x >= 0.5] for rows in ratios.values()]
    count = len(ratios)
    drawn = gnuplot.draw("profiles", {
        "count": count, "name": list(ratios), "colour": list(COLOURS[:count]), "shape": list(SHAPES[:count]),
        "figure_height": 330}, {"ratio": list(ratios.values()) or [[]], "away": away or [[]]})
    label = "Pull-off force of six profiles relative to the JKR theory, against the stiffness"
    return Figure("profiles", NUMBER, TITLE, Markup(svg.embeddable(drawn, "profiles", label)),
                  caption(ratios), remarks(case, known), case.record["command"])


def caption(ratios):
    last = Markup(", ").join(Markup("{:.4f} ({})").format(rows[-1][1], marked_up(name)) for name, rows in ratios.items())
    return Markup(
        "(a) Pull-off force of six profiles under the Lennard-Jones law, divided by that of the JKR theory with the same "
        "work of adhesion (<code>{}</code>). The axis is a Tabor parameter for any profile: "
        "√(2πwa/E*)/(3.094 ε), with a the contact radius at the JKR pull-off. The root is the depth of the neck around "
        "the contact; for a sphere the quotient is μ. (b) Distance of the quotient from 1; it has a minimum where the quotient crosses 1. The quotients at the "
        "right ends are {}.").format(f"reference/{JKR}", last)


def marked_up(name):
    """The name of a profile, whose exponent stands in gnuplot's braces, for a caption."""
    base, raised, exponent = name.partition("^{")
    return Markup("{}<sup>{}</sup>").format(base, exponent[:-1]) if raised else name


def remarks(case, known):
    made = failures(case)
    if not known:
        made.append(f"The JKR pull-offs ({JKR}) are not available, so nothing is drawn.")
    return made
