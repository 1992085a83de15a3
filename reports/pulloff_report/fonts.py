"""The two typefaces of the report: their files, the widths of text, and subsets to embed.

Text in a figure is placed with the widths computed here, and the same typefaces are embedded in the page.
A figure therefore looks the same in every browser and in the PDF.
"""

import base64
import functools
import io
import os

from fontTools import subset
from fontTools.ttLib import TTFont

from .errors import ReportError

FOLDERS = ("/usr/share/fonts", "/usr/local/share/fonts")

# fontTools and WeasyPrint write this time into their output, so that the same run gives the same bytes.
os.environ.setdefault("SOURCE_DATE_EPOCH", "0")

# (family, style, weight): file names in order of preference.
FILES = {
    ("Inter", "normal", 400): ("Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"),
    ("Inter", "italic", 400): ("Inter-Italic.otf", "Inter-Italic.ttf", "DejaVuSans-Oblique.ttf",
                               "DejaVuSans.ttf"),
    ("Inter", "normal", 600): ("Inter-SemiBold.otf", "Inter-SemiBold.ttf", "DejaVuSans-Bold.ttf"),
    ("Vollkorn", "normal", 400): ("Vollkorn-Regular.otf", "Vollkorn-Regular.ttf",
                                  "DejaVuSerif.ttf"),
    ("Vollkorn", "italic", 400): ("Vollkorn-Italic.otf", "Vollkorn-Italic.ttf",
                                  "DejaVuSerif-Italic.ttf", "DejaVuSerif.ttf"),
    ("Vollkorn", "normal", 600): ("Vollkorn-SemiBold.otf", "Vollkorn-SemiBold.ttf",
                                  "DejaVuSerif-Bold.ttf"),
}


@functools.lru_cache(maxsize=None)
def installed():
    """File name -> path of every font file on this machine."""
    found = {}
    for folder in FOLDERS:
        for place, _, names in os.walk(folder):
            for name in names:
                found.setdefault(name, os.path.join(place, name))
    return found


def path_of(family, style="normal", weight=400):
    """The file of a face, or of its substitute."""
    for name in FILES[(family, style, weight)]:
        if name in installed():
            return installed()[name]
    raise ReportError(f"no font file for {family}: install fonts-inter, fonts-vollkorn "
                      "or fonts-dejavu-core")


class Face:
    """Metrics of one face."""

    def __init__(self, path):
        with TTFont(path, lazy=True) as font:
            self._names = font.getBestCmap()
            self._widths = dict(font["hmtx"].metrics)
            self._unit = font["head"].unitsPerEm
            self.cap_height = getattr(font["OS/2"], "sCapHeight", 0.72 * self._unit) / self._unit

    def width(self, text, size):
        """Width of text without kerning."""
        total = 0
        for character in text:
            name = self._names.get(ord(character))
            total += self._widths[name][0] if name else self._unit // 2
        return total * size / self._unit


@functools.lru_cache(maxsize=None)
def face(family="Inter", style="normal", weight=400):
    return Face(path_of(family, style, weight))


def subset_bytes(path, text):
    """The font at path, reduced to the characters of text, as a WOFF file."""
    options = subset.Options(flavor="woff", layout_features=["kern", "mark", "mkmk", "tnum", "lnum",
                                                             "liga", "ccmp", "locl"],
                             notdef_outline=True, desubroutinize=True, hinting=False)
    font = subset.load_font(path, options)
    reducer = subset.Subsetter(options)
    reducer.populate(text=text)
    reducer.subset(font)
    stream = io.BytesIO()
    subset.save_font(font, stream, options)
    font.close()
    return stream.getvalue()


def font_faces(text):
    """CSS @font-face rules that carry every face, reduced to the characters of text."""
    rules = []
    for family, style, weight in FILES:
        data = subset_bytes(path_of(family, style, weight), text)
        uri = "data:font/woff;base64," + base64.b64encode(data).decode("ascii")
        rules.append(f"@font-face{{font-family:'{family}';font-style:{style};"
                     f"font-weight:{weight};src:url({uri}) format('woff')}}")
    return "\n".join(rules)
