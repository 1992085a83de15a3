"""Prepares the SVG of gnuplot and matplotlib for embedding into a page.

Both draw markers by reference and in `currentColor`, and gnuplot writes a label as several spans under
one anchor. WeasyPrint 57 supports neither. This module replaces each reference by a copy of its target and each
`currentColor` by its value, and gives each span of text a position, so that browser and PDF show the same.
"""

import copy
import re
import xml.etree.ElementTree as ElementTree

from . import fonts, words

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
MACRON = "\u0304"  # combining macron, as in W̄; drawn as a line, because few fonts place it correctly

# Attributes that are not needed after references, colours and text are resolved, and values that say nothing.
DROPPED = ("href", "color", "space", "text-anchor", "font-family", "font-size", "class")
DEFAULTS = {("stroke-linecap", "butt"), ("stroke-linejoin", "miter")}
FAMILY = "Inter, 'DejaVu Sans', sans-serif"

ElementTree.register_namespace("", SVG)


def local(tag):
    return tag.rsplit("}", 1)[-1] if isinstance(tag, str) else ""


def number(text):
    """The number at the start of an attribute such as "-6.00px"; 0 for none."""
    match = re.match(r"\s*(-?[\d.]+)", text or "")
    return float(match.group(1)) if match else 0.0


def style_of(element):
    """The style attribute as a dict."""
    pairs = (part.split(":", 1) for part in element.get("style", "").split(";") if ":" in part)
    return {name.strip(): value.strip() for name, value in pairs}


class Spans:
    """The runs of one text element, each with its font, size and rise."""

    def __init__(self, element, inherited):
        self.runs = []
        self._collect(element, dict(inherited), 0.0)

    def _collect(self, element, look, rise):
        look = dict(look, **font_of(element))
        rise += number(element.get("dy"))
        if element.text:
            self.runs.append((element.text, look, rise))
        for child in element:
            rise = self._collect(child, look, rise)
            if child.tail and child.tail.strip():
                self.runs.append((child.tail, look, rise))
        return rise


def font_of(element):
    """Font properties that an element sets, from its attributes, style and font shorthand."""
    look = {}
    style = style_of(element)
    for name in ("font-family", "font-size", "font-style", "font-weight", "text-anchor", "fill"):
        value = style.get(name, element.get(name))
        if value is not None:
            look[name] = value
    if "font" in style:
        shorthand = style["font"]
        if "italic" in shorthand or "oblique" in shorthand:
            look["font-style"] = "italic"
        if re.search(r"\b(600|700|bold)\b", shorthand):
            look["font-weight"] = "600"
        size = re.search(r"([\d.]+)px", shorthand)
        if size:
            look["font-size"] = size.group(1)
    return look


def face_of(look):
    style = "italic" if look.get("font-style") in ("italic", "oblique") else "normal"
    weight = 600 if look.get("font-weight") in ("bold", "600", "700") else 400
    return fonts.face("Inter", style, 400 if style == "italic" else weight)


def bar_over(face, before, letter, size, look, x, y):
    """A line over a letter that follows the text `before`, which starts at x."""
    left = x + face.width(before, size)
    lean = 0.12 * size if look.get("font-style") == "italic" else 0.0
    inset = 0.06 * size
    height = y - (face.cap_height + 0.13) * size
    path = ElementTree.Element(f"{{{SVG}}}path")
    path.set("d", f"M{left + lean + inset:.2f},{height:.2f}"
                  f"h{face.width(letter, size) - 2 * inset:.2f}")
    path.set("stroke", look.get("fill", "black"))
    path.set("stroke-width", f"{0.07 * size:.2f}")
    path.set("fill", "none")
    return path


def set_text(element, inherited):
    """A group with the runs of a text element, each with its own position."""
    look = dict(inherited, **font_of(element))
    runs = Spans(element, inherited).runs
    sizes = [number(run_look.get("font-size", "12")) for _, run_look, _ in runs]
    widths = [face_of(run_look).width(text.replace(MACRON, ""), size)
              for (text, run_look, _), size in zip(runs, sizes)]
    x, y = number(element.get("x")), number(element.get("y"))
    x -= sum(widths) * {"middle": 0.5, "end": 1.0}.get(look.get("text-anchor"), 0.0)

    group = ElementTree.Element(f"{{{SVG}}}g")
    if element.get("transform"):
        group.set("transform", element.get("transform"))
    for (text, run_look, rise), size, width in zip(runs, sizes, widths):
        plain = text.replace(MACRON, "")
        if plain.strip():
            indent = len(plain) - len(plain.lstrip())
            face = face_of(run_look)
            place = x + face.width(plain[:indent], size)
            node = ElementTree.SubElement(group, f"{{{SVG}}}text", {
                "x": f"{place:.2f}", "y": f"{y + rise:.2f}", "font-size": f"{size:g}", "fill": run_look.get("fill", "black")})
            for name in ("font-style", "font-weight"):
                if run_look.get(name, "normal") not in ("normal", "400"):
                    node.set(name, run_look[name])
            node.text = plain.strip()
            for match in re.finditer("(.)" + MACRON, text):
                before = text[:match.start()].replace(MACRON, "")
                group.append(bar_over(face, before, match.group(1), size, run_look, x, y + rise))
        x += width
    return group if len(group) else None


class Flattener:
    """Copies a tree with references and colours resolved, and identifiers with a prefix."""

    def __init__(self, root, prefix):
        self.prefix = prefix
        self.places = []   # (number, x, y) of links, see live.py
        self.targets = {node.get("id"): node for node in root.iter() if node.get("id")}
        self.needed = set(re.findall(r"url\(#([^)]+)\)",
                                     ElementTree.tostring(root, encoding="unicode")))

    def attributes(self, element, colour):
        kept = {}
        for name, value in element.attrib.items():
            plain = local(name)
            if plain in DROPPED or (plain, value) in DEFAULTS or (plain == "id" and value not in self.needed):
                continue
            value = " ".join(value.replace("currentColor", colour).split())
            value = re.sub(r"url\(#([^)]+)\)", rf"url(#{self.prefix}-\1)", value)
            kept[plain] = f"{self.prefix}-{value}" if plain == "id" else value
        return kept

    def copy(self, element, colour="black", look=None):
        kind = local(element.tag)
        colour = element.get("color", colour)
        look = dict(look or {}, **font_of(element))
        if kind in ("metadata", "title", "desc", "filter", "style", ""):
            return None
        if kind == "text":
            return set_text(element, dict(look, fill=look.get("fill", colour)))
        if kind == "g" and "showHypertext" in element.get("onmousemove", ""):
            place = re.search(r"translate\(([\d.]+),([\d.]+)\)", ElementTree.tostring(element, encoding="unicode"))
            self.places.append((int(re.search(r"'link (\d+)'", element.get("onmousemove"))[1]), place[1], place[2]))
            return None
        if kind == "use":
            return self.draw_out(element, colour)
        node = ElementTree.Element(f"{{{SVG}}}{kind}", self.attributes(element, colour))
        for child in element:
            if kind == "defs" and local(child.tag) != "clipPath":
                continue
            made = self.copy(child, colour, look)
            if made is not None and local(made.tag) == "g" and not made.attrib:
                node.extend(made)
            elif made is not None:
                node.append(made)
        if kind in ("g", "defs") and len(node) == 0:
            return None
        return node

    def draw_out(self, element, colour):
        """A use element as a group with a copy of its target."""
        target = self.targets.get(element.get(f"{{{XLINK}}}href", element.get("href"))[1:])
        group = ElementTree.Element(f"{{{SVG}}}g", self.attributes(element, colour))
        x, y = group.attrib.pop("x", None), group.attrib.pop("y", None)
        if x or y:
            group.set("transform", f"{group.get('transform', '')} "
                                   f"translate({x or 0},{y or 0})".strip())
        made = copy.copy(self.copy(target, colour))
        made.attrib.pop("id", None)
        group.append(made)
        return group


def embeddable(text, prefix, label, links=None):
    """SVG source as a self-contained HTML element, scaled by its view box.

    prefix makes its identifiers unique in the page; label is the text for readers who cannot see the figure; links are
    those of live.py, see without_links.
    """
    root = ElementTree.fromstring(words.printable(text))
    flattener = Flattener(root, prefix)
    made = flattener.copy(root)
    width, height = number(root.get("width")), number(root.get("height"))
    box = root.get("viewBox") or f"0 0 {width:g} {height:g}"
    made.attrib.clear()
    made.set("viewBox", box)
    made.set("role", "group" if flattener.places else "img")
    made.set("aria-label", label)
    made.set("font-family", FAMILY)
    if flattener.places:
        ElementTree.SubElement(made, f"{{{SVG}}}g", {"class": "scenes"}).extend(links.elements(flattener.places))
    return ElementTree.tostring(made, encoding="unicode")


def without_links(drawing):
    """A drawing as it is without the page to which its scenes are linked."""
    return re.sub(r'<g class="scenes">.*?</g>', "", str(drawing).replace('role="group"', 'role="img"'), flags=re.DOTALL)
