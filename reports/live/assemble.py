"""Puts pulloff.wasm, the JavaScript modules, the style and the scenes of the report's figures into one file: live.html.

Usage: assemble.py WASM VERSION RUN OUTPUT

RUN: the folder of the run's records; a figure without a record is left out.
"""

import base64
import gzip
import json
import pathlib
import re
import shlex
import struct
import sys

PAGE = pathlib.Path(__file__).with_name("page")
IMPORT = re.compile(r"^import [^;]* from '\./(\w+\.js)';\n", flags=re.M)
FIGURES = ["fig03", "fig04", "fig06", "fig08", "fig10"]
FIELDS = re.compile(r"name: '([\w-]+)',[^{}]*?usual: '([^']*)'")


def bundle(name, taken):
    """A module after the modules that it imports, each once; all names of the modules are different."""
    if name in taken:
        return ""
    taken.add(name)
    text = (PAGE / name).read_text(encoding="utf-8")
    before = "".join(bundle(other, taken) for other in IMPORT.findall(text))
    return before + re.sub(r"^export ", "", IMPORT.sub("", text), flags=re.M)


def numbers_of(point):
    """The numbers that are compared, as in page/figures.js."""
    pull_off = point["pull_off"]
    rows = [[pull_off[name] for name in ("force", "approach", "contact_radius", "error_estimate")]] if pull_off else []
    rows += [[special[name] for name in ("approach", "load", "contact_radius", "error_estimate")] for special in point["folds"] + point["extrema"]]
    return [number for row in rows for number in row]


def hash_of(numbers):
    """FNV-1a, 64 bits, of the bytes of the numbers; None is a NaN."""
    value = 0xCBF29CE484222325
    for byte in b"".join(bytes.fromhex("7ff8000000000000") if number is None else struct.pack(">d", number + 0.0) for number in numbers):
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def fragment_of(command, usual):
    """The address of a scene for the command that solves it: its options without those that have their usual value."""
    words = shlex.split(command)[2:]
    given = {name[2:]: value for name, value in zip(words[::2], words[1::2])}

    def is_usual(name, value):
        return value == usual[name] or (usual[name] and re.match(r"[\d.]", value) and float(value) == float(usual[name]))
    return "#" + "&".join(f"{name}={value}" for name, value in given.items() if not is_usual(name, value))


def figures_of(run):
    """{NAME: {title, want, scenes: [[fragment, hash]]}} of the figures of which the run has records. Where a curve is wanted,
    the solver takes other steps, so that its numbers differ within their errors."""
    usual = dict(FIELDS.findall((PAGE / "scene.js").read_text(encoding="utf-8")))
    found = {}
    for name in FIGURES:
        path = run / name / "record.json"
        if not path.is_file():
            continue
        record = json.loads(path.read_text(encoding="utf-8"))
        scenes = [[fragment_of(point["command"], usual), hash_of(numbers_of(point))] for point in record["points"]
                  if point["status"] == "ok" and not point["followed"]]
        want = "curve" if any(point["curve"] for point in record["points"]) else ""
        found[name] = {"title": f"Figure {record['figure']}: {record['title']}", "want": want, "scenes": scenes}
    return found


def main():
    wasm, version, run, output = sys.argv[1:]
    packed = gzip.compress(pathlib.Path(wasm).read_bytes(), 9, mtime=0)
    parts = {"MODULE": base64.b64encode(packed).decode(), "WORKER": bundle("worker.js", set()), "PAGE": bundle("page.js", set()),
             "RECORDS": json.dumps(figures_of(pathlib.Path(run)), ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c"),
             "VERSION": version, "/* style.css */": (PAGE / "style.css").read_text(encoding="utf-8")}
    page = (PAGE / "live.html").read_text(encoding="utf-8")
    assert all(page.count(mark) == 1 for mark in parts) and not any("</script" in text for text in parts.values())
    page = re.sub("|".join(map(re.escape, parts)), lambda mark: parts[mark[0]], page)
    pathlib.Path(output).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
