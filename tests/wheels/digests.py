"""Compares the digests of libraries that were built for other machines with those of tests/bits/scenes.txt.

Usage: digests.py [--only WORD] NAME=FILE=COMMAND...

COMMAND answers as tests/library/solve_json.c: [theory NAME] KEY VALUE... are its arguments, the JSON document its output. FILE
is what was built. Prints a line for each: name, bytes of the file, scenes, how many digests agree, seconds; and each digest
that differs. Exit status: 0 all agree, 1 some do not. --only: the scenes whose command line has this word.
"""

import argparse
import pathlib
import re
import shlex
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "bits"))
from scenes import SCENES, keys_of, scenes_of_library  # noqa: E402


def digest_by(command, scene):
    theory, keys = keys_of(shlex.split(scene.replace("HERE", str(SCENES.parent))))
    words = (["theory", theory] if theory else []) + [word for pair in keys.items() for word in pair]
    ended = subprocess.run([*command, *words], capture_output=True, text=True, check=False)
    found = re.findall(r'^  "digest": "([0-9a-f]{16})"', ended.stdout, flags=re.M)
    return found[0] if ended.returncode == 0 and len(found) == 1 else f"status {ended.returncode}, {ended.stderr.strip()}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="")
    parser.add_argument("targets", nargs="+", metavar="NAME=FILE=COMMAND")
    chosen = parser.parse_args()
    scenes = [scene for scene in scenes_of_library() if chosen.only in scene[1]]
    failed = not scenes
    print(f"{'built for, run by':44} {'bytes':>8} {'scenes':>7} {'agree':>6} {'seconds':>8}")
    for name, file, command in (text.split("=", 2) for text in chosen.targets):
        begin = time.monotonic()
        found = [(digest_by(shlex.split(command), scene), digest, scene) for digest, scene in scenes]
        differ = [row for row in found if row[0] != row[1]]
        print(f"{name:44} {pathlib.Path(file).stat().st_size:8} {len(scenes):7} {len(scenes) - len(differ):6} {time.monotonic() - begin:8.1f}",
              flush=True)
        for digest, expected, scene in differ:
            print(f"    pulloff {scene}: {digest}, expected {expected}")
        failed = failed or bool(differ)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
