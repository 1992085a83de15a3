"""Puts pulloff.wasm, the JavaScript modules and the style into one file: live.html.

Usage: assemble.py WASM VERSION OUTPUT
"""

import base64
import gzip
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).with_name("page")
IMPORT = re.compile(r"^import .* from '\./(\w+\.js)';\n", flags=re.M)


def bundle(name, taken):
    """A module after the modules that it imports, each once; all names of the modules are different."""
    if name in taken:
        return ""
    taken.add(name)
    text = (PAGE / name).read_text(encoding="utf-8")
    before = "".join(bundle(other, taken) for other in IMPORT.findall(text))
    return before + re.sub(r"^export ", "", IMPORT.sub("", text), flags=re.M)


def main():
    wasm, version, output = sys.argv[1:]
    packed = gzip.compress(pathlib.Path(wasm).read_bytes(), 9, mtime=0)
    parts = {"MODULE": base64.b64encode(packed).decode(), "WORKER": bundle("worker.js", set()), "PAGE": bundle("page.js", set()),
             "VERSION": version, "/* style.css */": (PAGE / "style.css").read_text(encoding="utf-8")}
    page = (PAGE / "live.html").read_text(encoding="utf-8")
    for mark, text in parts.items():
        assert page.count(mark) == 1 and "</script" not in text, mark
        page = page.replace(mark, text)
    pathlib.Path(output).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
