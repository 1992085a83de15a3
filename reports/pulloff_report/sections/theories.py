"""Which theory holds where: the suite theories."""

from . import Section
from ..plots import theories

ABSENT = "which theory holds where (./reproduce --only theories)"


def ratio(scene):
    return scene["amplitude"] / scene["wavelength"]


def length(scene):
    return scene["wavelength"]


def build(source):
    case = {found.name: found for found in source.run.cases if "theories" in found.record["suites"]}
    data = {"figures": [], "limits": None, "shares": None, "rule": None}
    if "theories" in case:
        data["figures"].append(theories.smooth(case["theories"]))
        data["limits"] = theories.limits(case["theories"])
    for name, of, label, said in (("theories_ratio", ratio, "{/:Italic A}/λ", "λ† = 20"),
                                  ("theories_wavelength", length, "λ†", "A/λ = 0.02")):
        if name in case:
            data["figures"].append(theories.wavy(case[name], of, name, f"{theories.MAP_TITLE}, {said}", label, said))
    if "theories_random" in case:
        points = theories.compared(case["theories_random"])
        data["shares"] = [(words, *theories.share(points, name)) for name, words in theories.WORDS.items()]
        data["rule"] = {"words": theories.rule(), **theories.misses(points)}
    return Section("theories", "Which theory holds where", "theories.html", data,
                   [(f"figure-{item.id}", item.title) for item in data["figures"]], absent="" if case else ABSENT)
