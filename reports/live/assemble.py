"""Puts pulloff.wasm, the JavaScript modules, the style and the scenes of the report's figures into one file: live.html.

Usage: assemble.py WASM VERSION RUN OUTPUT

RUN: the folder of the run's records; a figure without a record is left out.
"""

import base64
import gzip
import json
import pathlib
import re
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from pulloff_report import live, tree  # noqa: E402

PAGE = pathlib.Path(__file__).with_name("page")
IMPORT = re.compile(r"^import [^;]* from '\./(\w+\.js)';\n", flags=re.M)
FIGURES = ["fig03", "fig04", "fig06", "fig08", "fig10"]


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


def figures_of(run):
    """{NAME: {title, want, scenes: [[fragment, hash]]}} of the figures of which the run has records. Where a curve is wanted,
    the solver takes other steps, so that its numbers differ within their errors."""
    found = {}
    for name in FIGURES:
        path = run / name / "record.json"
        if not path.is_file():
            continue
        record = json.loads(path.read_text(encoding="utf-8"))
        scenes = [[live.fragment(point["command"]), hash_of(numbers_of(point))] for point in record["points"]
                  if point["status"] == "ok" and not point["followed"]]
        want = "curve" if any(point["curve"] for point in record["points"]) else ""
        found[name] = {"title": f"Figure {record['figure']}: {record['title']}", "want": want, "scenes": scenes}
    return found


def packed(data):
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def main():
    wasm, version, run, output = sys.argv[1:]
    known = tree.identity(str(pathlib.Path(__file__).parents[2]))
    records = json.dumps(figures_of(pathlib.Path(run)), ensure_ascii=False, separators=(",", ":"))
    parts = {"MODULE": packed(pathlib.Path(wasm).read_bytes()), "RECORDS": packed(records.encode("utf-8")), "WORKER": bundle("worker.js", set()), "PAGE": bundle("page.js", set()),
             "VERSION": ", ".join([version, *([tree.words(known)] if known else [])]), "/* style.css */": (PAGE / "style.css").read_text(encoding="utf-8")}
    page = (PAGE / "live.html").read_text(encoding="utf-8")
    assert all(page.count(mark) == 1 for mark in parts) and not any("</script" in text for text in parts.values())
    page = re.sub("|".join(map(re.escape, parts)), lambda mark: parts[mark[0]], page)
    pathlib.Path(output).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
