"""Links from the drawings of the figures to their scenes in the page with the solver (reports/live)."""

import shlex
import xml.etree.ElementTree as ElementTree

PAGE = "live.html"
SVG = "http://www.w3.org/2000/svg"
NEAR = "7"   # radius of the area about a marker that is a link


def options(command):
    """{name: text} of the options of a command `pulloff solve ...`."""
    words = shlex.split(command)[2:]
    return {name[2:]: value for name, value in zip(words[::2], words[1::2])}


def fragment(command):
    """The scene of a command, as the address of the page has it. The page chooses its additional results itself."""
    return "#" + "&".join(f"{name}={value}" for name, value in options(command).items() if name != "want")


def link(href, title, shape, **attributes):
    """An element that links to a scene. It opens beside the report. A reader of the keyboard has the links of the page, which are fewer."""
    made = ElementTree.Element(f"{{{SVG}}}a", {"class": "scene", "href": href, "tabindex": "-1", "target": "_blank"})
    ElementTree.SubElement(made, f"{{{SVG}}}title").text = title
    ElementTree.SubElement(made, f"{{{SVG}}}{shape}", attributes)
    return made


class Links:
    """The links of one drawing: the scenes of its markers. `blocks` are drawn by the script of the figure with the macro
    `link` of style.gp, so that gnuplot says where they are."""

    def __init__(self, count=1):
        self.points, self.blocks = [], [[] for _ in range(count)]

    def add(self, block, rows, point):
        """Links from places (x, y) of a block to the scene of a point of a record."""
        self.points.append(point)
        self.blocks[block] += [(x, y, len(self.points)) for x, y in rows]

    def elements(self, places):
        """Given: places (number, x, y) in the drawing."""
        for number, x, y in places:
            point = self.points[number - 1]
            yield link(PAGE + fragment(point["command"]), f"Solve in the browser: {point['label']}", "circle", cx=x, cy=y, r=NEAR)


class Cells:
    """The links of a map over the Tabor parameter and the amplitude. One link covers the map; the script of the page points it
    to the scene under the pointer. The map must show the scenes from corner to corner, on logarithmic axes."""

    def __init__(self, points):
        commands = [point["command"] for point in points if {"tabor", "amplitude"} <= set(options(point["command"]))]
        scenes = [options(command) for command in commands]
        self.blocks = [[(0, 0, 0), (1, 1, 1)] if commands else []]
        self.across, self.up = (sorted({scene[name] for scene in scenes}, key=float) for name in ("tabor", "amplitude"))
        self.command = commands[len(commands) // 2] if commands else ""

    def elements(self, places):
        (left, bottom), (right, top) = ((float(x), float(y)) for _, x, y in sorted(places))
        made = link(PAGE + fragment(self.command), "Solve a scene of the map in the browser", "rect", x=f"{left:.2f}", y=f"{top:.2f}",
                    width=f"{right - left:.2f}", height=f"{bottom - top:.2f}")
        made.set("data-tabor", " ".join(self.across))
        made.set("data-amplitude", " ".join(self.up))
        yield made
