"""The picture of the adhesion sheet: load against approach of Maugis-Dugdale, JKR and DMT contacts, in the units of Maugis, with
the certified points of pull-off."""

from math import cos, hypot, pi, sin, sqrt

WIDTH, HEIGHT, LEFT, BOTTOM, RIGHT, TOP = 620, 222, 38, 34, 8, 8
RANGE = (-2.1, 1.75), (-2.15, 0.95)          # of approach and load
COLOURS = {"0.1": "#b8560f", "0.5": "#a3781a", "1": "#2f8f6b", "3": "#00588a"}
POINTS = 400
HEAD = 'font-family="Inter, DejaVu Sans, sans-serif"'


def end_of_tension(number, theta):
    """c of Maugis-Dugdale at the angle theta = arccos(a/c)."""
    s, k = sin(theta), cos(theta)
    square = number / 2 * (s * k + (1 - 2 * k * k) * theta)
    linear = 4 * number ** 2 / 3 * (theta * s - 1 + k)
    return 2 / (linear + hypot(linear, 2 * sqrt(square)))


def maugis(number):
    """Points (approach, load) from far in contact to its end, and on to the lowest approach without contact."""
    points = []
    for i in range(40, POINTS + 1):
        theta = pi / 2 * i / POINTS
        s, k, c = sin(theta), cos(theta), end_of_tension(number, theta)
        points.append(((c * k) ** 2 - 4 / 3 * number * c * s, (c * k) ** 3 - number * c * c * (k * s + theta)))
    edge, last = 8 * number / (3 * pi), end_of_tension(number, pi / 2)
    for i in range(1, POINTS + 1):
        c = last + (edge - last) * i / POINTS
        if last > edge:
            points.append((c * c / 2 - edge * c - 2 / (pi * number), -number * pi / 2 * c * c))
    return points


def jkr():
    return [(a * a - 2 / 3 * sqrt(6 * a), a ** 3 - a * sqrt(6 * a)) for a in (2 * (i / POINTS) ** 2 for i in range(POINTS + 1))]


def dmt():
    return [(a * a, a ** 3 - 2) for a in (1.6 * i / POINTS for i in range(POINTS + 1))]


def place(approach, load):
    (low, high), (bottom, top) = RANGE
    return (LEFT + (WIDTH - LEFT - RIGHT) * (approach - low) / (high - low),
            HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (load - bottom) / (top - bottom))


def line(points, colour, more=""):
    path = " ".join(f"{'L' if i else 'M'}{x:.2f} {y:.2f}" for i, (x, y) in enumerate(place(*point) for point in points))
    return f'<path d="{path}" fill="none" stroke="{colour}" {more} clip-path="url(#plane)"/>'


def label(approach, load, text, colour="#565d66", more=""):
    x, y = place(approach, load)
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="9.5" fill="{colour}" {HEAD} {more}>{text}</text>'


def axes():
    (low, high), (bottom, top) = RANGE
    left, right = place(low, bottom)[0], place(high, bottom)[0]
    parts = [f'<clipPath id="plane"><rect x="{left}" y="{TOP}" width="{right - left}" height="{HEIGHT - BOTTOM - TOP}"/></clipPath>']
    for tick in (-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5):
        x, y = place(tick, bottom)
        parts.append(f'<line x1="{x}" y1="{y}" x2="{x}" y2="{TOP}" stroke="#e9ebee" stroke-width="0.7"/>')
        parts.append(label(tick, bottom - 0.2, f"{tick:g}".replace("-", "−"), more='text-anchor="middle"'))
    for tick in (-2, -1.5, -1, -0.5, 0, 0.5):
        x, y = place(low, tick)
        parts.append(f'<line x1="{x}" y1="{y}" x2="{right}" y2="{y}" stroke="{"#8a929b" if tick == 0 else "#e9ebee"}" stroke-width="0.7"/>')
        parts.append(label(low - 0.03, tick - 0.04, f"{tick:g}".replace("-", "−"), more='text-anchor="end"'))
    parts.append(label(high, bottom - 0.44, "approach / (π²w²R/K²)¹ᐟ³", more='text-anchor="end"'))
    x, y = place(low, top)
    parts.append(f'<text transform="translate({x - 29} {y + 2}) rotate(-90)" font-size="9.5" text-anchor="end" fill="#565d66" {HEAD}>load / πwR</text>')
    return parts


def marker(values, number, kind, colour):
    point = [float(values[f"law-maugis-{number}", f"{kind}_{what}"]["value"]) for what in ("approach", "force")]
    if point[0] < RANGE[0][0]:
        return ""
    x, y = place(point[0], -point[1])
    inside = colour if kind == "pull_off" else "#ffffff"
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="3.4" fill="{inside}" stroke="{colour}" stroke-width="1.5"/>'


def draw(sheet, values):
    """The SVG. Points are those of the sheet, lines are computed here from the equations."""
    numbers = [str(problem["parameters"]["lambda"]) for problem in sheet["problems"] if "lambda" in problem["parameters"]]
    parts = axes()
    parts.append(line(jkr(), "#1b1d20", 'stroke-width="1.1" stroke-dasharray="4 2.5"'))
    parts.append(line(dmt(), "#1b1d20", 'stroke-width="1.1" stroke-dasharray="1.2 2.2"'))
    parts += [line(maugis(float(number)), COLOURS[number], 'stroke-width="1.7"') for number in numbers]
    parts += [marker(values, number, kind, COLOURS[number]) for number in numbers for kind in ("pull_off", "grips")]
    parts += [label(-2.0, -1.34, "λ = 0.1", COLOURS["0.1"]), label(-1.33, -0.30, "0.5", COLOURS["0.5"]),
              label(-1.09, -1.02, "1", COLOURS["1"]), label(-0.66, -0.04, "3", COLOURS["3"]), label(0.02, 0.05, "JKR", "#1b1d20"),
              label(0.2, -2.05, "DMT", "#1b1d20")]
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="100%">{"".join(parts)}</svg>'
