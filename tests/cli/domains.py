#!/usr/bin/python3
"""The domains of the keys of a scene that doc/cases.md states are those of the program: domains.py PROGRAM

Each number of a stated domain is tried: the ends are accepted or refused as the page says, and so is what lies just
beside them. The limits of laws and profiles in doc/guide.md are the same.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The other keys that a scene needs with a key, in place of those of the first line.
BASE = {"tabor": "1", "radius": "100", "outer_radius": "30", "scheme": "panel"}
WITH = {"amplitude": {"wavelength": "9"}, "wavelength": {"amplitude": "0.1"}, "coupling": {"tabor": None},
        "mie_m": {"law": "mie", "mie_n": "60"}, "mie_n": {"law": "mie", "mie_m": "4"}, "morse_a": {"law": "morse"},
        "power_n": {"profile": "power", "power_c": "0.1"}, "table_scale": {"profile_file": "table.csv"}}
BESIDE = 1e-6


def trials(key, domain):
    """(value, whether it is in the domain), for a domain as the page writes it."""
    if match := re.fullmatch(r"(≥|>) (m|[0-9.e-]+)(?:, or `inf`|, at most ([0-9.e]+))?", domain):
        end = 4.0 if match[2] == "m" else float(match[2])
        yield from ((end - BESIDE, False), (end, match[1] == "≥"), (end + BESIDE, True), ("inf", "inf" in domain), ("nan", False))
        if match[3]:
            yield from ((float(match[3]), True), (float(match[3]) + BESIDE, False))
        elif key != "mie_m":    # which is below mie_n
            yield 100.0, True
    elif match := re.fullmatch(r"([0-9.e-]+) to ([0-9.e-]+)", domain):
        low, high = map(float, match.groups())
        yield from ((low, True), (high, True), (low * (1 - BESIDE), False), (high * (1 + BESIDE), False))
    elif domain.startswith("any number"):
        yield from ((-3.0, True), (2.0, True), ("nan", False), ("inf", "inf" in domain))


def domains(page, guide):
    """(key, domain) of the tables."""
    for keys, _, value, _ in re.findall(r"^\| (`[^|]*) \| ([^|]*) \| ([^|]*) \| ([^|]*)\|$", page, re.M):
        for key, domain in zip(re.findall(r"`(\w+)`", keys), value.split("; ")):
            yield key, domain
    m, n = re.search(r"^\| `mie:m,n` .* \| ([0-9.]+) < m < n ≤ ([0-9.]+);", guide, re.M).groups()
    yield from (("mie_m", f"> {m}"), ("mie_n", f"> m, at most {n}"))
    yield "morse_a", " to ".join(re.search(r"^\| `morse:a` .* \| ([0-9.]+) ≤ a ≤ ([0-9.]+) \|", guide, re.M).groups())
    yield "power_n", " to ".join(re.search(r"^\| `power:C,n` .* ([0-9.]+) ≤ n ≤ ([0-9.]+) \|", guide, re.M).groups())


def accepts(program, folder, key, value):
    scene = {**BASE, **WITH.get(key, {}), key: value}
    case = pathlib.Path(folder, "tried.yaml")
    case.write_text("name: tried\ntitle: T\nsuites: [own]\nwant: [pull_off]\nscene: {"
                    + ", ".join(f"{name}: {one}" for name, one in scene.items() if one is not None) + "}\n")
    done = subprocess.run([program, "plan", str(case)], capture_output=True, text=True, check=False,
                          env={"PULLOFF_DATA": folder, "PATH": "/usr/bin:/bin"})
    return done.returncode == 0, done.stderr.strip()


def main():
    page = (ROOT / "doc/cases.md").read_text().split("## Scene", 1)[1].split("\n## ", 1)[0]
    tried, failed, keys = 0, 0, set()
    with tempfile.TemporaryDirectory(prefix="pulloff-domains-") as folder:
        for name in ("cases", "reference"):    # without other cases, all of which a plan reads
            pathlib.Path(folder, name).mkdir()
        pathlib.Path(folder, "table.csv").write_text("r,gap\n" + "".join(f"{r},{r * r / 200}\n" for r in range(9)))
        for key, domain in domains(page, (ROOT / "doc/guide.md").read_text()):
            for value, inside in trials(key, domain):
                accepted, said = accepts(sys.argv[1], folder, key, value)
                tried += 1
                keys.add(key)
                if accepted != inside:
                    failed += 1
                    print(f"FAILED: {key} is {value!r}, {'in' if inside else 'out'}side the stated domain '{domain}': {said or 'accepted'}")
    print(f"{tried} values of {len(keys)} keys, {failed} failures")
    return failed > 0 or len(keys) < 14


sys.exit(main())
