"""The examples in SI units of the adhesion sheet: every number with a unit follows from the parameters of its problem."""

import json
import math
import pathlib
import re

import pytest

SHEET = pathlib.Path(__file__).resolve().parents[2] / "reference" / "sheet"
PROBLEMS = json.loads((SHEET / "problems.json").read_text())["problems"]
UNITS = {"um": 1e-6, "nm": 1e-9, "mm": 1e-3, "GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "mJ/m^2": 1e-3, "N/m": 1.0, "uN": 1e-6,
         "nN": 1e-9, "pN": 1e-12, "J": 1.0, "ms": 1e-3, "um/s": 1e-6, "mm/s": 1e-3}
UNIT = "(" + "|".join(sorted(map(re.escape, UNITS), key=len, reverse=True)) + r")(?![\w^/])"
NUMBER = r"(-?\d+(?:\.\d+)?(?:e-?\d+)?)"
SAID = re.compile(r"(?:([A-Za-z]\w*\*?) = (?:[(][^=]*[)] = )?|(?:unit of|that of)(?: the)? (\w+) (?:is )?|(k) = [\d.]+ is )" +
                  NUMBER + " " + UNIT)


def said(text):
    """[(name, number as written, unit)] of the numbers of a text, and how many numbers with a unit it has."""
    return ([(found[1] or found[2] or found[3], found[4], found[5]) for found in SAID.finditer(text)],
            len(re.findall(r"(?<![\w.])" + NUMBER + " " + UNIT, text)))


def in_si(problem):
    """{name: number in SI units} as the example says."""
    return {name: float(number) * UNITS[unit] for name, number, unit in said(problem["dimensional"])[0]}


def bodies(p, _):
    """Problems in SI units: their parameters, the radius of both spheres, the work of adhesion."""
    found = dict(p)
    if "R1" in p:
        found |= {"R": 1 / (1 / p["R1"] + 1 / p["R2"]), "w": p["gamma1"] + p["gamma2"] - p["gamma12"]}
    return found


def jkr(p, given):
    w, modulus = given["w"], given["E*"]
    found = {"length": w / modulus, "force": w**2 / modulus, "energy": w**3 / modulus**2}
    return found | ({"R": p["R"] * w / modulus} if "R" in p else {})


def maugis(p, given):
    w, radius, k = given["w"], given["R"], 4 / 3 * given["E*"]
    return {"force": math.pi * w * radius, "radius": (math.pi * w * radius**2 / k) ** (1 / 3),
            "approach": (math.pi**2 * w**2 * radius / k**2) ** (1 / 3),
            "s": p["lambda"] / 2 * (math.pi * w * k**2 / radius) ** (1 / 3)}


def grooves(p, given):
    w, radius, length = given["w"], given["R"], given["L"]
    return {"A": p["alpha"] * length**2 / radius, "E*": p["beta"] * 2 * math.pi * w * radius**2 / length**3,
            "force": math.pi * w * radius, "approach": length**2 / radius}


def with_law(p, given):
    """Lengths in epsilon; the coupling c = w/(E* epsilon)."""
    epsilon, w = given["epsilon"], given["w"]
    found = {name: p[name] * epsilon for name in ("R", "A", "b", "R_t", "preload", "outer_radius") if name in p}
    found["force"] = math.pi * w * found.get("R", epsilon)
    found["energy"] = found["force"] * epsilon
    found["k"] = p.get("stiffness", 0.0) * found["force"] / epsilon
    if "wavelength" in p:
        found["L"] = p["wavelength"] * epsilon
    if "coupling" in p or "tabor" in p:
        found["E*"] = w / (epsilon * (p["coupling"] if "coupling" in p else p["tabor"] ** 1.5 / math.sqrt(p["R"])))
    if "unload_speed" in p:
        found |= {"speed": epsilon / given["tau_0"], "unload_speed": p["unload_speed"] * epsilon / given["tau_0"]}
    return found


# Group or beginning of an id: what is chosen for the example, and what follows from it.
EXAMPLES = {"law-jkr": ([], bodies), "law-dmt": ([], bodies), "law-flat-punch": ([], bodies),
            "law-maugis": (["w", "R", "E*"], maugis), "contact law": (["w", "E*"], jkr),
            "rigid": (["w", "epsilon"], with_law), "full law, elastic": (["w", "epsilon"], with_law),
            "rate-dependent": (["w", "epsilon", "tau_0"], with_law), "JKR with grooves": (["w", "R", "L"], grooves)}


def example(problem):
    return next(found for name, found in EXAMPLES.items() if problem["id"].startswith(name) or problem["group"] == name)


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda problem: problem["id"])
def test_example_follows_from_the_parameters(problem):
    chosen, derive = example(problem)
    numbers, count = said(problem["dimensional"])
    given = in_si(problem)
    assert len(numbers) == count, "a number with a unit that this test does not read"
    if problem["id"] == "elastic-s-begins":
        assert not numbers
        return
    parameters = dict(problem["parameters"])
    if problem["id"] == "rigid-sphere":
        parameters["R"] = given["R"] / given["epsilon"]       # chosen: in units of pi w R no answer depends on it
    expected = derive(parameters, given)
    assert set(chosen) <= set(given)
    checked = [(name, number, unit) for name, number, unit in numbers if name not in chosen]
    assert checked
    for name, number, unit in checked:
        significant = len(re.sub(r"e.*|\D", "", number).lstrip("0"))
        assert float(f"{expected[name] / UNITS[unit]:.{significant}g}") == float(number), (name, expected[name])


def test_an_error_is_seen():
    """R = 100 epsilon is not 10 um, where epsilon = 0.3 nm."""
    problem = next(problem for problem in PROBLEMS if problem["id"] == "rate-fast")
    numbers, _ = said("With R = 10 um, w = 50 mJ/m^2 and epsilon = 0.3 nm the unit of force is 1.571 uN.")
    given = {name: float(number) * UNITS[unit] for name, number, unit in numbers} | {"tau_0": 1e-3}
    expected = with_law(problem["parameters"], given)
    assert abs(expected["R"] - given["R"]) > 1e-6 and abs(expected["force"] - given["force"]) > 1e-6
