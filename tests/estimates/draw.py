"""Random scenes from a seed.

A number depends only on the seed, on the number k of the scene and on the name of its key, as in a case with `sample`
(doc/cases.md). So scene k is the same on every machine and if more scenes are drawn. The numbers are rounded to 6
significant digits, so that the printed command repeats the scene exactly."""

import math
import os

MASK = 2**64 - 1


def mix(x):
    """The first output of SplitMix64 seeded with x (src/base/po_random.c)."""
    z = (x + 0x9E3779B97F4A7C15) & MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def uniform(seed, index, name):
    """A number of the open interval (0, 1)."""
    word = 0xCBF29CE484222325                           # FNV-1a of 64 bits
    for byte in name.encode():
        word = ((word ^ byte) * 0x100000001B3) & MASK
    return ((mix(mix(mix(seed & MASK) ^ index) ^ word) >> 12) + 0.5) * 2.0**-52


def between(bounds, part):
    """The value at the fraction `part` of a range, on a logarithmic scale."""
    low, high = bounds
    return float(f"{low * (high / low)**part:.6g}")


def scene(seed, index, ranges):
    """Flags of `pulloff solve`, name -> number or "inf". The ranges of wavelength, amplitude and outer radius are in
    units of sqrt(R epsilon), of the wavelength and of R. `smooth` and `cut` are the fractions of scenes without waves
    and of bounded surfaces, `at_radius` is the fraction of bounded surfaces with outer radius R."""
    def part(name):
        return uniform(seed, index, name)

    flags = {"tabor": between(ranges["tabor"], part("tabor")), "radius": between(ranges["radius"], part("radius"))}
    if part("smooth") >= ranges["smooth"]:
        length = between(ranges["wavelength"], part("wavelength")) * math.sqrt(flags["radius"])
        flags["wavelength"] = float(f"{length:.6g}")
        height = between(ranges["amplitude"], part("amplitude")) * flags["wavelength"]
        flags["amplitude"] = float(f"{height:.6g}")
    if part("cut") >= ranges["cut"]:
        flags["outer-radius"] = "inf"
    elif part("at_radius") < ranges["at_radius"]:
        flags["outer-radius"] = flags["radius"]
    else:
        outer = between(ranges["outer"], part("outer")) * flags["radius"]
        flags["outer-radius"] = float(f"{outer:.6g}")
    if part("any law") < ranges.get("any_law", 0.0):
        flags["law"] = law(part)
    return flags


def law(part):
    """A law as on the command line: in four scenes of ten that of the paper, in three each Mie and Morse."""
    kind = part("law")
    if kind < 0.4:
        return "lennard-jones"
    if kind < 0.7:
        small = 2.5 + 3.5 * part("mie_m")
        return f"mie:{small:.4g},{small + 2.0 + 8.0 * part('mie_n'):.4g}"
    return f"morse:{between((0.6, 5.0), part('morse_a')):g}"


def profile(part, width):
    """A profile whose gap is of order epsilon at the radius `width`."""
    kind = int(6.0 * part("profile"))
    edge = between((0.3, 5.0), part("edge"))
    if kind == 0:
        return f"cone:{float(f'{1.0 / width:.6g}'):g}"
    if kind in (1, 2):
        power = float(f"{between((1.1, 6.0), part('power')):.4g}")
        return f"power:{float(f'{width**-power:.6g}'):.10g},{power:g}"
    if kind in (3, 4):
        name = "punch" if kind == 3 else "truncated"
        return f"{name}:{float(f'{edge * width:.6g}'):g},{float(f'{0.5 * width * width:.6g}'):g}"
    return "sphere"


# The ranges of general scenes: waves and cut radii in units of the width.
GENERAL = {"width": (3.0, 30.0), "pliant": (1e-3, 30.0), "wavelength": (0.3, 4.0), "amplitude": (0.003, 0.3),
           "outer": (1.5, 10.0), "smooth": 0.3, "cut": 0.5}


def general_scene(seed, index, ranges=None):
    """Flags of a scene of any law, profile, waves and coupling. The widths are those at which the gap is of order
    epsilon. The elastic deformation is of the order of coupling times width (mu^(3/2) for a sphere). Lengths and
    amplitudes of the waves as in `scene`, cut radii in units of the width."""
    ranges = ranges or GENERAL

    def part(name):
        return uniform(seed, index, name)

    width = between(ranges["width"], part("width"))
    flags = {"law": law(part), "profile": profile(part, width)}
    flags["coupling"] = float(f"{between(ranges['pliant'], part('pliant')) / width:.6g}")
    if flags["profile"] == "sphere":
        flags["radius"] = float(f"{0.5 * width * width:.6g}")
    count = int(4.0 * part("waves")) if part("smooth") >= ranges["smooth"] else 0
    flags["wave"] = []
    for k in range(count):
        length = between(ranges["wavelength"], part(f"wavelength {k}")) * width
        height = between(ranges["amplitude"], part(f"amplitude {k}")) * length
        flags["wave"].append(f"{height:.6g},{length:.6g}")
    if part("cut") >= ranges["cut"]:
        flags["outer-radius"] = "inf"
    else:
        flags["outer-radius"] = float(f"{between(ranges['outer'], part('outer')) * width:.6g}")
    return flags


def steep_profile(part, width):
    """Cones, powers near 1 and above 8, exact spheres and hyperboloids, whose gap is of order epsilon at `width`."""
    kind = int(5.0 * part("profile"))
    if kind == 0:
        return f"cone:{float(f'{1.0 / width:.6g}'):g}"
    if kind in (1, 2):
        power = float(f"{between((1.01, 1.3) if kind == 1 else (8.0, 12.0), part('power')):.4g}")
        return f"power:{float(f'{width**-power:.6g}'):.10g},{power:g}"
    if kind == 3:
        return f"exact_sphere:{float(f'{0.5 * width * width:.6g}'):g}"
    edge = between((0.1, 10.0), part("edge"))
    return f"hyperboloid:{float(f'{1.0 / width:.6g}'):g},{float(f'{edge * width:.6g}'):g}"


def steep_law(part):
    """A Mie law with m > 10, a Morse law, or that of the paper."""
    kind = part("law")
    if kind < 0.5:
        small = 10.0 + 20.0 * part("mie_m")
        return f"mie:{small:.4g},{small + 2.0 + 20.0 * part('mie_n'):.4g}"
    return f"morse:{between((0.6, 20.0), part('morse_a')):g}" if kind < 0.75 else "lennard-jones"


def steep_scene(seed, index, ranges=None):
    """A general scene with a steep profile and law."""
    ranges = ranges or GENERAL
    flags = general_scene(seed, index, ranges)
    flags.pop("radius", None)

    def part(name):
        return uniform(seed, index, f"steep {name}")

    width = between(ranges["width"], uniform(seed, index, "width"))
    return dict(flags, law=steep_law(part), profile=steep_profile(part, width))


def table_rows(part, width):
    """(r, gap) of a body as an instrument might measure it: a parabola or a cone, with kinks or undulations or neither. The
    distance of the rows varies by a factor of 3; the last row is at 3 to 30 widths."""
    count, end = int(between((12, 400), part("rows"))), width * between((3.0, 30.0), part("end"))
    power = 2.0 if part("body") < 0.6 else 1.0
    kind = int(3.0 * part("feature"))
    places = [end * part(f"kink {k}") for k in range(3)] if kind == 1 else []
    slopes = [2.0 * (part(f"slope {k}") - 0.3) / width for k in range(3)]
    length = between((0.5, 10.0), part("length")) * width
    height = between((0.01, 0.3), part("height")) if kind == 2 else 0.0
    rows, r = [], 0.0
    for k in range(count):
        gap = (r / width)**power + sum(slope * max(0.0, r - place) for place, slope in zip(places, slopes))
        rows.append((r, gap + height * (1.0 - math.cos(2.0 * math.pi * r / length))))
        r += end / count * 3.0**(part(f"row {k}") - 0.5)
    return rows


def table_scene(seed, index, folder, ranges=None):
    """A general scene whose profile is a table in a file of this folder."""
    ranges = ranges or GENERAL

    def part(name):
        return uniform(seed, index, f"table {name}")

    flags = general_scene(seed, index, ranges)
    flags.pop("radius", None)
    flags.pop("profile")
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, f"table-{seed}-{index}.csv")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("r,gap\n" + "".join(f"{r:.9g},{gap:.9g}\n"
                                         for r, gap in table_rows(part, between(ranges["width"], uniform(seed, index, "width")))))
    return {"profile-file": path, **flags}
