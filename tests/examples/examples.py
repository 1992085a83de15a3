#!/usr/bin/python3
"""Runs the examples of doc/examples/README.md, as printed there, in copies of the folder.

    examples.py BUILD ROOT [NUMBER...] [--write]

Every block ```sh must end with status 0 and leave the picture that its last word names; with --write that becomes the picture
of the page, in 128 colours. The comments <!-- prints: A; B --> of an example name what it must print. fit.ipynb must be made of
fit.py; with --write it is made anew. NUMBER: only these; without, all except those that build the program (SLOW)."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SLOW = {7}
WIDEST = 1000  # pixels of a stored picture


def small(picture, to):
    from PIL import Image

    image = Image.open(picture).convert("RGB")
    if image.width > WIDEST:
        image = image.resize((WIDEST, image.height * WIDEST // image.width), Image.LANCZOS)
    image.quantize(128).save(to, optimize=True)


def environment(build, root):
    library = build / "src/library"
    return dict(os.environ, PATH=f"{build / 'src/cli'}:{os.environ['PATH']}", PYTHONPATH=str(root / "python"),
                PULLOFF_LIBRARY=str(library / "libpulloff.so.0"), LD_LIBRARY_PATH=str(library), PULLOFF_DATA=str(root),
                PKG_CONFIG_PATH=str(build / "meson-uninstalled"), PYTHONDONTWRITEBYTECODE="1", MPLBACKEND="Agg")


def main():
    build, root = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    write, numbers = "--write" in sys.argv, {int(word) for word in sys.argv[3:] if word.isdigit()}
    source, space = root / "doc/examples", environment(build, root)
    failed = 0

    def tell(what, wrong):
        nonlocal failed
        failed += bool(wrong)
        print(f"{'FAILED' if wrong else 'ok'}: {what}{': ' + wrong if wrong else ''}", flush=True)

    examples = re.findall(r"^## (\d+)\. (.*?)$(.*?)(?=^## |\Z)", (source / "README.md").read_text(), re.M | re.S)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder, "doc/examples")
        shutil.copytree(source, copy, ignore=shutil.ignore_patterns("pictures"))
        for path in root.iterdir():
            if path.name not in ("doc", build.name) and not path.name.startswith("."):
                pathlib.Path(folder, path.name).symlink_to(path)
        for number, title, text in examples:
            if int(number) not in (numbers or set(range(len(examples) + 1)) - SLOW):
                continue
            for block in re.findall(r"^```sh\n(.*?)^```", text, re.M | re.S):
                picture = block.split()[-1]
                command = re.sub(r"^python3 ", "/usr/bin/python3 ", block, flags=re.M)
                ended = subprocess.run(["sh", "-ec", command], cwd=copy, env=space, capture_output=True, text=True)
                shown = f'src="pictures/{picture}"' in text and (write or (source / "pictures" / picture).exists())
                drawn = (copy / picture).exists() and (copy / picture).stat().st_size > 4000
                lacking = [phrase for phrases in re.findall(r"<!-- prints: (.*?) -->", text) for phrase in phrases.split("; ")
                           if phrase not in ended.stdout]
                tell(f"{number}. {title}", ended.stderr.strip() or "failed" if ended.returncode else
                     f"not printed: {', '.join(lacking)}" if lacking else
                     "" if drawn and shown else f"no picture {picture}")
                if write and drawn:
                    (source / "pictures").mkdir(exist_ok=True)
                    small(copy / picture, source / "pictures" / picture)
            if "fit.ipynb" in text:
                tell("the notebook", notebook(root, copy, source, write))
    size = sum(path.stat().st_size for path in (source / "pictures").iterdir())
    tell(f"the pictures have {size} bytes", "" if size < 300_000 else "more than 300,000")
    return 1 if failed else 0


def notebook(root, copy, source, write):
    """What is wrong with the notebook: it is not that of the script."""
    subprocess.run(["/usr/bin/python3", str(root / "tools/notebook.py"), "fit.py"], cwd=copy, check=True)
    if write:
        shutil.copy(copy / "fit.ipynb", source / "fit.ipynb")
    if (copy / "fit.ipynb").read_bytes() != (source / "fit.ipynb").read_bytes():
        return "it is not that of the script: python3 tools/notebook.py doc/examples/fit.py"
    return ""


if __name__ == "__main__":
    sys.exit(main())
