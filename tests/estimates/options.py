"""Command line options of all campaigns."""

import argparse

BETWEEN = "LOW:HIGH"


def span(text):
    try:
        low, high = map(float, text.split(":"))
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text} is no range: expected {BETWEEN}, two numbers") from error
    if not 0 < low <= high < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no range: expected {BETWEEN} with 0 < LOW <= HIGH")
    return low, high


def share(text):
    if not 0 <= float(text) <= 1:
        raise argparse.ArgumentTypeError(f"{text} is no share: expected a number from 0 to 1")
    return float(text)


# Some reference tables have uncertainties of 1e-10, so they can only judge looser tolerances.
def tolerance(text):
    if not 1e-10 <= float(text) <= 1e-2:
        raise argparse.ArgumentTypeError(f"{text} is no tolerance: expected a number from 1e-10 to 1e-2")
    return float(text)


def numbers(text):
    """Reads numbers of scenes, such as "3,7-9"."""
    found = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        if not first.isdigit() or not (last or first).isdigit():
            raise argparse.ArgumentTypeError(f"{text} are no scenes: expected numbers and ranges, as 3,7-9")
        found.extend(range(int(first), int(last or first) + 1))
    return found


def parser_of(document, journal, count, tolerances):
    """Options of every campaign. Given: the name of the journal in the build folder, the number of scenes, and the two
    tolerances."""
    parser = argparse.ArgumentParser(description=document.split("\n", maxsplit=1)[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--build", default="build", metavar="DIR", help="the build folder")
    parser.add_argument("--program", metavar="FILE", help="the program (default: that of the build folder)")
    parser.add_argument("--journal", metavar="FILE", help=f"where solutions are kept (default: BUILD/{journal})")
    parser.add_argument("--fresh", action="store_true", help="solve everything anew")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="solves at a time; 0: as many as cores")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of the scenes")
    parser.add_argument("--count", type=int, default=count, metavar="N", help="how many scenes are drawn")
    parser.add_argument("--scenes", type=numbers, metavar="LIST", help="only these of the drawn scenes, as 3,7-9")
    parser.add_argument("--loose", type=tolerance, default=tolerances[0], metavar="T",
                        help="tolerance whose errors are judged")
    parser.add_argument("--tight", type=tolerance, default=tolerances[1], metavar="T",
                        help="tolerance they are judged by")
    parser.add_argument("--time-limit", type=float, default=120.0, metavar="S", help="processor seconds of one solve")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser


def add_ranges(parser, spans, shares):
    """Adds options for the ranges and fractions of the scenes, with these defaults."""
    ranges = parser.add_argument_group("ranges of the scenes, each value uniform in its logarithm")
    for name, what in (("tabor", "Tabor parameter"), ("radius", "R, in epsilon"),
                       ("wavelength", "in units of sqrt(R epsilon)"), ("amplitude", "in units of the wavelength"),
                       ("outer", "outer radius where it is not R, in units of R")):
        ranges.add_argument(f"--{name}", type=span, default=spans[name], metavar=BETWEEN, help=what)
    for name, what in (("smooth", "share of scenes without waves"), ("cut", "share of surfaces that end"),
                       ("at-radius", "share of these that end at R"),
                       ("any-law", "share of scenes whose law is drawn")):
        if name not in shares:
            continue
        ranges.add_argument(f"--{name}", type=share, default=shares[name], metavar="SHARE", help=what)
