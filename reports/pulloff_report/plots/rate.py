"""Viscoelastic spheres: pull-off force against speed, and the enhancement by waves against speed."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import fixed, plain
from .figure import BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILLION, BLACK, Figure, failures

COLOURS = (BLACK, SKY, BLUE, GREEN, ORANGE, VERMILLION, PURPLE)
AT_ENDS = 10.0  # the limits 0 and inf are drawn so many times beyond the finite speeds
HALF = 0.5      # of the enhancement beyond 1
SHORT_RANGE = 3.0  # the Tabor parameter from which on the theory of Persson and Brener is drawn


def number(value):
    return float(value) if value is not None else math.nan


def forces(case, *keys):
    """{(values of keys): {speed: force}}; a function of the input for each key."""
    found = {}
    for point in case.points:
        if point.get("pull_off"):
            scene = point["input"]
            found.setdefault(tuple(key(scene) for key in keys), {})[number(scene["unload_speed"])] = point["pull_off"]["force"]
    return found


def theory_forces(case, theory, *keys):
    """The same of a theory, where it was evaluated."""
    found = {}
    for point in case.points:
        scene = point["input"]
        for row in point.get("theories") or []:
            if row["theory"] == theory and row["force"] is not None:
                found.setdefault(tuple(key(scene) for key in keys), {})[number(scene["unload_speed"])] = row["force"]
    return found


def finite(speeds):
    return sorted(speed for speed in speeds if 0.0 < speed < math.inf)


def place(speed, between):
    """Where a speed is drawn: the limits beside the finite speeds."""
    return between[0] / AT_ENDS if speed == 0.0 else between[-1] * AT_ENDS if math.isinf(speed) else speed


def ratio_of(scene):
    return round(scene["amplitude"] / scene["wavelength"], 9) if scene["amplitude"] else 0.0


def material(scene):
    return scene["viscoelastic"]


def preload(scene):
    return scene["preload_load"]


def enhancements(case):
    """{(preload, material): {A/lambda: {speed: force over that of the smooth sphere}}}."""
    found = {}
    rows = forces(case, preload, material, ratio_of)
    for (load, solid, ratio), values in rows.items():
        smooth = rows.get((load, solid, 0.0), {})
        if ratio:
            found.setdefault((load, solid), {})[ratio] = {
                speed: force / smooth[speed] for speed, force in values.items() if speed in smooth}
    return found


def crossing(values, level):
    """The speed at which the enhancement first falls below a level, between neighbours on a logarithmic scale; None: it does not."""
    speeds = finite(values)
    for low, high in zip(speeds, speeds[1:]):
        if values[low] >= level > values[high]:
            part = (values[low] - level) / (values[low] - values[high])
            return low * (high / low)**part
    return None


def best_waves(case):
    """For each preload and material: what the waves do that help most at rest."""
    found = []
    for (load, solid), of in sorted(enhancements(case).items()):
        ratio = max(of, key=lambda each: of[each].get(0.0, 0.0))
        values = of[ratio]
        if values.get(0.0, 0.0) > 1.0 and math.inf in values:
            found.append({"preload": load, "solid": solid, "ratio": ratio, "rest": values[0.0], "once": values[math.inf],
                          "half": crossing(values, 1.0 + HALF * (values[0.0] - 1.0))})
    return found


def finding(case):
    """What becomes of the enhancement, in a sentence, and a line for each preload and material; None: too few solves."""
    found = best_waves(case)
    if not found:
        return None
    left = max((each["once"] - 1.0) / (each["rest"] - 1.0) for each in found)
    halves = [each["half"] for each in found if each["half"]]
    where = f"; half is lost at {min(halves):.2g} to {max(halves):.2g} ε/τ₀" if len(halves) == len(found) else ""
    return {"sentence": f"Of what waves add to the pull-off force at rest, at most {max(0.0, 100.0 * left):.0f} % is left when the "
                        f"sphere is unloaded at once{where}.", "lines": [said(each) for each in found]}


def solid_words(solid):
    kind, _, numbers = solid.partition(":")
    k, *exponent = numbers.split(",")
    return f"k = {k}" if kind == "sls" else f"k = {k}, n = {exponent[0]}"


def axis(case):
    between = finite({number(point["input"]["unload_speed"]) for point in case.points})
    return between, {"x_low": between[0] / (3.0 * AT_ENDS), "x_high": between[-1] * 3.0 * AT_ENDS,
                     "rest": between[0] / AT_ENDS, "once": between[-1] * AT_ENDS}


def curve(values, between):
    """The rows of a curve; no line joins the limits to the finite speeds."""
    rows = []
    for speed in sorted(values):
        if math.isinf(speed):
            rows.append((between[-1], math.nan))
        rows.append((place(speed, between), values[speed]))
        if speed == 0.0:
            rows.append((between[0], math.nan))
    return rows


def wavy(case):
    found = enhancements(case)
    panels = sorted(found)
    ratios = sorted({ratio for of in found.values() for ratio in of})
    between, ends = axis(case)
    greatest = max(value for of in found.values() for values in of.values() for value in values.values())
    drawn = gnuplot.draw("rate_wavy", {
        "figure_height": 560, **ends, "panel_text": [f"preload {plain(load)} πwR, {solid_words(solid)}" for load, solid in panels],
        "ratio_text": [f"A/λ = {plain(ratio)}" for ratio in ratios], "ratio_count": len(ratios), "greatest": 1.08 * greatest,
        "colour": [COLOURS[k % len(COLOURS)] for k in range(len(ratios))] if len(ratios) <= len(COLOURS) else
                  [*COLOURS, "#7A7A7A"][:len(ratios)]},
        {"enhancement": [curve(found[panel].get(ratio, {}), between) for panel in panels for ratio in ratios]})
    scene = case.points[0]["input"]
    caption = Markup("Pull-off force of a viscoelastic wavy sphere over that of the smooth one at the same speed and preload, against the "
                     "speed of unloading in ε/τ₀; at both ends the limits 0 and ∞. μ = {}, λ† = {}, R† = {}, standard linear "
                     "solids, loaded slowly to the preload.").format(plain(scene["tabor"]), plain(scene["wavelength"]), plain(scene["radius"]))
    return Figure("rate-wavy", None, "Enhancement by waves against the speed of unloading",
                  Markup(svg.embeddable(drawn, "rate-wavy", "Force of wavy over that of smooth spheres against speed")),
                  caption, failures(case), case.record["command"])


def speeds(case):
    rows = forces(case, material, lambda scene: scene["tabor"])
    theory = theory_forces(case, "persson-brener", material, lambda scene: scene["tabor"])
    solids = sorted({key[0] for key in rows}, reverse=True)
    tabors = sorted({key[1] for key in rows})
    between, ends = axis(case)
    drawn = gnuplot.draw("rate_speed", {
        "figure_height": 330, **ends, "panel_text": [solid_words(solid) for solid in solids],
        "tabor_text": [f"μ = {plain(tabor)}" for tabor in tabors], "tabor_count": len(tabors),
        "colour": [COLOURS[k % len(COLOURS)] for k in range(len(tabors))]},
        {"force": [curve(rows.get((solid, tabor), {}), between) for solid in solids for tabor in tabors],
         "theory": [curve(theory.get((solid, tabor), {}) if tabor >= SHORT_RANGE else {}, between)
                    for solid in solids for tabor in tabors]})
    scene = case.points[0]["input"]
    caption = Markup("Pull-off force of viscoelastic smooth spheres, loaded slowly to the approach {}ε, against the speed of unloading in ε/τ₀; "
                     "at both ends the limits 0 and ∞. R† = {}. Dotted: 1.5, JKR of the relaxed body at any preload; 1.5/k, JKR unloaded at once from a "
                     "wide contact; 2/k, a rigid sphere that has flattened. Dashed: Persson and Brener, μ ≥ {}.").format(plain(scene["preload"]), plain(scene["radius"]), plain(SHORT_RANGE))
    return Figure("rate-speed", None, "Force against the speed of unloading",
                  Markup(svg.embeddable(drawn, "rate-speed", "Pull-off force against speed")), caption, failures(case), case.record["command"])


def said(found):
    """The finding of one material and preload in words."""
    where = f"with a preload of {plain(found['preload'])} πwR and {solid_words(found['solid'])}"
    return (f"{where}: {fixed(found['rest'], 2)} times the force of the smooth sphere at rest (A/λ = {plain(found['ratio'])}), "
            f"{fixed(found['once'], 2)} times if it is unloaded at once")
