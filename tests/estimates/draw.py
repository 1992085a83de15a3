"""Random scenes from a seed.

A number depends only on the seed, on the number k of the scene and on the name of its key, as in a case with `sample`
(doc/cases.md). So scene k is the same on every machine and if more scenes are drawn. The numbers are rounded to 6
significant digits, so that the printed command repeats the scene exactly."""

import math

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
    return flags
