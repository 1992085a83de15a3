"""Which theory holds where: deviations of the smooth sphere, maps of wavy spheres, limits, and a rule with its misses."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import count, plain
from .figure import Figure, failures

TITLE = "Deviation of the theories, smooth sphere"
MAP_TITLE = "Nearest theory, wavy spheres"
WORDS = {"rigid": "rigid bodies", "dmt": "DMT", "jkr": "JKR, any preload", "maugis": "Maugis–Dugdale",
         "carpick-ogletree-salmeron": "Carpick–Ogletree–Salmeron", "pietrement-troyon": "Piétrement–Troyon",
         "schwarz": "Schwarz", "guduru": "Eq 5 after the preload", "kesari-lew": "Kesari–Lew",
         "persson-tosatti": "Persson–Tosatti", "rumpf-rabinowicz": "Rumpf–Rabinowicz"}
SMOOTH = list(WORDS)[1:7]   # the rigid smooth sphere has the force of DMT
# Theories of one colour in the maps.
KINDS = (("rigid bodies, DMT, Rumpf–Rabinowicz", ("rigid", "dmt", "rumpf-rabinowicz")),
         ("smooth sphere", ("carpick-ogletree-salmeron", "pietrement-troyon", "schwarz")),
         ("Maugis–Dugdale", ("maugis",)), ("Eq 5, JKR, Kesari–Lew, Persson–Tosatti", ("guduru", "jkr", "kesari-lew", "persson-tosatti")))
LEVELS = (0.01, 0.05, 0.2)
COLOURS = (("#0072B2", "#66AAD1", "#CCE3F0"), ("#009E73", "#66C5AB", "#CCECE3"), ("#B07A00", "#EBBF66", "#F8ECCF"),
           ("#D55E00", "#E69E66", "#F7DFCC"))
# The rule, fitted to the maps: a theory, the number that decides, its limit, and on which side the theory is used.
RULE = (("rigid", "μ", "tabor", 0.2, "at most"), ("pietrement-troyon", "A†", "amplitude", 0.1, "at most"),
        ("guduru", "μ", "tabor", 1.5, "at least"))
NEAR = 0.05


def middles(values):
    """Edges of the cells around the values, half way between neighbours on a logarithmic scale."""
    logs = [math.log(value) for value in values]
    inner = [(a + b) / 2 for a, b in zip(logs, logs[1:])]
    return [2 * logs[0] - inner[0]] + inner + [2 * logs[-1] - inner[-1]]


def deviations(point):
    """Theory -> deviation, of the theories that were evaluated."""
    rows = point.get("theories") or []
    return {row["theory"]: row["deviation"] for row in rows if row["deviation"] is not None}


def compared(case):
    return [point for point in case.points if deviations(point)]


def curve(case, theory):
    return sorted((point["input"]["tabor"], deviations(point)[theory]) for point in compared(case)
                  if theory in deviations(point))


def crossings(rows, level):
    """The Tabor parameters at which |deviation| passes a level, between neighbours on a logarithmic scale."""
    found = []
    for (a, y), (b, z) in zip(rows, rows[1:]):
        low, high = abs(y) - level, abs(z) - level
        if (low <= 0) != (high <= 0):
            found.append((math.exp(math.log(a) + low / (low - high) * math.log(b / a)), low <= 0))
    return found


def ranges(rows, level):
    """Where a theory is within a level, in words, as "μ ≤ 0.22, μ ≥ 2.1"."""
    passed = crossings(rows, level)
    if not passed:
        return "all μ" if abs(rows[0][1]) <= level else "no μ"
    words, low = [], None
    for at, leaves in passed:
        if leaves:
            words.append(f"{low:.2g} ≤ μ ≤ {at:.2g}" if low else f"μ ≤ {at:.2g}")
        low = None if leaves else at
    return ", ".join(words + ([f"μ ≥ {low:.2g}"] if low else []))


def limits(case):
    """Rows (theory, range within 1 %, 5 %, 20 %, greatest deviation and where)."""
    found = []
    for theory in SMOOTH:
        rows = curve(case, theory)
        worst = max(rows, key=lambda row: abs(row[1]))
        found.append((WORDS[theory] + (", rigid bodies" if theory == "dmt" else ""), [ranges(rows, level) for level in LEVELS],
                      worst))
    return found


def smooth(case):
    """The figure of the smooth sphere."""
    data = {"deviations": [[(tabor, max(100 * abs(value), 1e-3)) for tabor, value in curve(case, theory)] for theory in SMOOTH]}
    drawn = gnuplot.draw("theories", {"figure_height": 330, "name": [WORDS[theory] for theory in SMOOTH], "count": len(SMOOTH)}, data)
    caption = ("|Deviation| of the pull-off force of each theory from the computed one, in per cent, against the Tabor parameter μ; "
               "rigid bodies are as DMT. A dip is a change of sign.")
    return Figure("theories", None, TITLE, Markup(svg.embeddable(drawn, "theories", TITLE)), caption, failures(case),
                  case.record["command"])


def class_of(point):
    """The class of a scene: kind and level of the nearest theory; the last class if none is within 20 %."""
    found = deviations(point)
    nearest = min(found, key=lambda theory: abs(found[theory]))
    for k, level in enumerate(LEVELS):
        if abs(found[nearest]) <= level:
            return next(i for i, (_, theories) in enumerate(KINDS) if nearest in theories) * len(LEVELS) + k
    return len(KINDS) * len(LEVELS)


def is_any(point):
    return point["input"]["preload"] == "inf"


def cells(points, of):
    """Blocks of cells (x, y, left, right, low, high) in logarithms, one for each class."""
    blocks = [[] for _ in range(len(KINDS) * len(LEVELS) + 1)]
    place = [(point["input"]["tabor"], float(f"{of(point['input']):.10g}")) for point in points]
    xs, ys = (sorted({pair[k] for pair in place}) for k in (0, 1))
    left, low = middles(xs), middles(ys)
    for point, (x, y) in zip(points, place):
        i, j = xs.index(x), ys.index(y)
        blocks[class_of(point)].append((math.log(x), math.log(y), left[i], left[i + 1], low[j], low[j + 1]))
    return blocks, (left[0], left[-1], low[0], low[-1])


def wavy(case, of, name, title, label, said):
    """The map of a case after both preloads."""
    data, frame = {}, None
    for preload, wanted in (("usual", False), ("any", True)):
        data[preload], frame = cells([point for point in compared(case) if is_any(point) == wanted], of)
    drawn = gnuplot.draw("theories_map", {
        "figure_height": 340, "colours": [shade for shades in COLOURS for shade in shades] + ["#C8C8C8"],
        "kinds": [words for words, _ in KINDS], "y_label": gnuplot.Enhanced(label),
        "x_low": frame[0], "x_high": frame[1], "y_low": frame[2], "y_high": frame[3]}, data)
    none = {name: len(blocks[-1]) for name, blocks in data.items()}
    caption = Markup("The theory nearest to the computed pull-off force, {}, R† = 100: (a) preload πwR, (b) any preload. The three shades: "
                     "within 1, 5 and 20 %. Grey: no theory is within 20 % ({} of {}, and {} of {}). Where curves of "
                     "deviation cross zero a theory may be the nearest by chance.").format(
                         said, none["usual"], count(sum(map(len, data["usual"])), "scene"), none["any"], sum(map(len, data["any"])))
    return Figure(name, None, title, Markup(svg.embeddable(drawn, name, title)), caption, failures(case), case.record["command"])


def share(points, theory):
    """How many scenes a theory has, and in how many of them it is within 1, 5 and 20 %."""
    found = [abs(deviations(point)[theory]) for point in points if theory in deviations(point)]
    return len(found), [sum(value <= level for value in found) for level in LEVELS]


def advised(point):
    """The theory that the rule names for a scene; None: none."""
    for theory, _, key, limit, side in RULE:
        value = point["input"][key]
        if value <= limit if side == "at most" else value >= limit:
            return theory
    return None


def misses(points):
    """The rule on scenes: how often it names a theory, how often that is off by more than 5 %, and how often it names none
    although one of its theories is within 5 %."""
    named = wrong = silent = 0
    for point in points:
        found, theory = deviations(point), advised(point)
        if theory:
            named += 1
            wrong += abs(found.get(theory, math.inf)) > NEAR
        else:
            silent += any(abs(found.get(name, math.inf)) <= NEAR for name, *_ in RULE)
    return {"scenes": len(points), "named": named, "wrong": wrong, "silent": silent}


def rule():
    return [f"{WORDS[theory]} if {symbol} is {side} {plain(limit)}" for theory, symbol, _, limit, side in RULE]
