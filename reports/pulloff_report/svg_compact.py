"""Writes a drawing with fewer elements and without a visible change.

gnuplot and matplotlib draw each marker and each tick as an element of its own in one to three groups. Browsers, and above all
WeasyPrint, need a time for each element. This module removes groups that say nothing, joins a group with its only child, and
draws markers of one look that follow each other as one path.
"""

import functools
import math
import re
import xml.etree.ElementTree as ElementTree

RUN = 100  # markers of one path, at most: WeasyPrint 57 needs a time that grows with the square of the length of a path

QUARTER = 0.5523  # a quarter of a circle of radius 1 is a cubic curve whose handles have this length

DEFAULTS = {"stroke-linecap": "butt", "stroke-linejoin": "miter", "stroke-dasharray": "none"}
INHERITED = frozenset(("fill", "stroke", "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-dasharray", "font-family",
                       "font-size", "font-style", "font-weight", "shape-rendering"))
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
SHAPES = frozenset(("circle", "rect", "polygon", "path"))


def local(element):
    return element.tag.rsplit("}", 1)[-1]


def plain_attributes(element):
    """Replaces the style of an element by attributes, and omits what changes nothing."""
    for part in element.attrib.pop("style", "").split(";"):
        if ":" in part:
            name, value = part.split(":", 1)
            element.set(name.strip(), value.strip())
    element.attrib.pop("class", None)
    for name in ("fill", "stroke"):
        if name in element.attrib:
            element.set(name, element.get(name).replace(" ", ""))


def join(group, child):
    """Whether a group was joined with its only child, which then has the attributes of both."""
    clips = {"clip-path", "opacity", "id", "mask"}
    if not set(group.attrib) <= INHERITED | {"transform", "clip-path"}:
        return False
    if "clip-path" in group.attrib and clips | {"transform"} & set(child.attrib):
        return False
    transforms = [element.get("transform") for element in (group, child) if element.get("transform")]
    for name, value in group.attrib.items():
        if name not in child.attrib:
            child.set(name, value)
    if transforms:
        child.set("transform", " ".join(transforms))
    return True


def matrix_of(text):
    """A list of transforms as (scale, angle, x, y), or None if it is not a similarity."""
    scale, angle, x, y = 1.0, 0.0, 0.0, 0.0
    for name, inner in re.findall(r"(\w+)\s*\(([^)]*)\)", text):
        numbers = [float(number) for number in NUMBER.findall(inner)]
        if name == "translate":
            right, down = (numbers + [0.0])[:2]
            x += scale * (math.cos(angle) * right - math.sin(angle) * down)
            y += scale * (math.sin(angle) * right + math.cos(angle) * down)
        elif name == "scale" and len(set(numbers)) == 1:
            scale *= numbers[0]
        elif name == "rotate" and len(numbers) == 1:
            angle += math.radians(numbers[0])
        else:
            return None
    return scale, angle, x, y


def outline(shape):
    """The path of a shape as (letter, numbers) with the letters M, L, C, Z and, for a circle, O; None for other letters."""
    kind = local(shape)
    if kind == "circle":
        return [("O", [float(shape.get(name, 0)) for name in ("cx", "cy", "r")])]
    if kind == "rect":
        x, y, width, height = (float(shape.get(name, 0)) for name in ("x", "y", "width", "height"))
        return [("M", [x, y]), ("L", [x + width, y]), ("L", [x + width, y + height]), ("L", [x, y + height]), ("Z", [])]
    if kind == "polygon":
        numbers = [float(number) for number in NUMBER.findall(shape.get("points", ""))]
        corners = list(zip(numbers[::2], numbers[1::2]))
        return [("L" if k else "M", list(corner)) for k, corner in enumerate(corners)] + [("Z", [])]
    return path_outline(shape.get("d", ""))


def path_outline(data):
    made, x, y, begin = [], 0.0, 0.0, (0.0, 0.0)
    for letter, inner in re.findall(r"([A-Za-z])([^A-Za-z]*)", re.sub("[eE]", "?", data)):
        numbers = [float(number) for number in NUMBER.findall(inner)]
        kind, relative = letter.upper(), letter.islower()
        size = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "Z": 0}.get(kind)
        if size is None or "?" in inner or (size and (not numbers or len(numbers) % size)):
            return None
        if kind == "Z":
            made.append(("Z", []))
            x, y = begin
        for k in range(0, len(numbers), max(size, 1)):
            some = numbers[k:k + size]
            if kind == "H":
                some = [some[0], 0.0 if relative else y]
            elif kind == "V":
                some = [0.0 if relative else x, some[0]]
            if relative:
                some = [number + (y if n % 2 else x) for n, number in enumerate(some)]
            x, y = some[-2:]
            made.append(("L" if kind in "HV" or (kind == "M" and k) else kind, some))
            if made[-1][0] == "M":
                begin = x, y
    return made


def short(number):
    return f"{number:.2f}".rstrip("0").rstrip(".") if round(number, 2) else "0"


@functools.lru_cache(maxsize=None)
def circle(radius):
    """A circle from its leftmost point, of four cubic curves: in a PDF they are shorter than arcs."""
    r, k, rest = (short(length) for length in (radius, QUARTER * radius, (1 - QUARTER) * radius))
    return f"c0,-{k} {rest},-{r} {r},-{r}s{r},{rest} {r},{r}s-{rest},{r} -{r},{r}s-{r},-{rest} -{r},-{r}z"


def placed(commands, where):
    """The text of a path whose points are moved by (scale, angle, x, y)."""
    scale, angle, x, y = where
    right, down = scale * math.cos(angle), scale * math.sin(angle)

    def point(a, b):
        return f"{short(x + right * a - down * b)},{short(y + down * a + right * b)}"

    words = []
    for letter, numbers in commands:
        if letter == "O":
            words.append("M" + point(numbers[0] - numbers[2] * math.cos(angle), numbers[1] + numbers[2] * math.sin(angle))
                         + circle(scale * numbers[2]))
        else:
            words.append(letter + " ".join(point(*numbers[k:k + 2]) for k in range(0, len(numbers), 2)))
    return "".join(words)


class Marker:
    """A shape that is moved to its place, or None as look if it cannot be drawn together with others."""

    def __init__(self, element, fill, stroke):
        self.look = None
        self.where = matrix_of(element.get("transform", "")) if "transform" in element.attrib else None
        if self.where is None or local(element) not in SHAPES:
            return
        fill, stroke = element.get("fill", fill), element.get("stroke", stroke)
        # Where markers overlap, a fill would be drawn below the strokes of earlier ones.
        if "none" not in (fill, stroke) and fill != stroke:
            return
        if set(element.attrib) & {"opacity", "fill-opacity", "stroke-opacity", "stroke-dasharray", "id", "clip-path"}:
            return
        if stroke != "none" and "stroke-width" not in element.attrib:
            return
        self.element = element
        self.look = (element.tag, self.where[:2], tuple(sorted(
            (name, value) for name, value in element.attrib.items() if name != "transform")))


def drawn_together(markers):
    """One path of several markers of the same look, or None."""
    first = markers[0].element
    commands = outline(first)
    if not commands:
        return None
    path = ElementTree.Element(first.tag.replace(local(first), "path"))
    for name in sorted(INHERITED & set(first.attrib)):
        path.set(name, first.get(name))
    if "stroke-width" in path.attrib:
        width = float(NUMBER.match(path.get("stroke-width"))[0]) * markers[0].where[0]
        path.set("stroke-width", f"{width:.3g}")
    path.set("d", "".join(placed(commands, marker.where) for marker in markers))
    return path


def with_joined_markers(children, fill, stroke):
    """The children of an element, with each run of markers of the same look as one path."""
    made, run = [], []

    def end_run():
        path = drawn_together(run) if len(run) > 1 else None
        made.extend([path] if path is not None else [marker.element for marker in run])
        run.clear()

    for child in children:
        marker = Marker(child, fill, stroke)
        if run and (marker.look != run[0].look or len(run) == RUN):
            end_run()
        if marker.look is None:
            made.append(child)
        else:
            run.append(marker)
    end_run()
    return made


def compact(element, fill="black", stroke="none", inherited=None):
    """Rewrites the drawing below an element in place."""
    plain_attributes(element)
    inherited = dict(inherited or DEFAULTS)
    for name in DEFAULTS:
        if element.get(name) == inherited[name]:
            del element.attrib[name]
        inherited[name] = element.get(name, inherited[name])
    fill, stroke = element.get("fill", fill), element.get("stroke", stroke)
    children = []
    for child in list(element):
        compact(child, fill, stroke, inherited)
        if local(child) == "g" and not child.attrib:
            children.extend(child)
        elif local(child) == "g" and len(child) == 1 and join(child, child[0]):
            children.append(child[0])
        elif local(child) != "g" or len(child):
            children.append(child)
    element[:] = with_joined_markers(children, fill, stroke)
