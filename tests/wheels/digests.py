"""Compares the digests of libraries that were built for other machines with those of tests/bits/scenes.txt.

Usage: digests.py [--only WORD] NAME=FILE=COMMAND...

COMMAND answers as tests/library/solve_json.c: [theory NAME] KEY VALUE... are its arguments, the JSON document its output. FILE
is what was built. Prints a line for each: name, bytes of the file, scenes, how many digests agree, seconds; and each answer
that differs. Condition numbers, which are no part of a digest, have to be those of the first target. Exit status: 0 all agree,
1 some do not. --only: the scenes whose command line has this word.
"""

import argparse
import pathlib
import re
import shlex
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "bits"))
from scenes import keys_of, scenes_of_library  # noqa: E402


def answer_of(command, scene):
    """The digest and the condition numbers, or why there are none."""
    theory, keys = keys_of(shlex.split(scene))
    words = (["theory", theory] if theory else []) + [word for pair in keys.items() for word in pair]
    ended = subprocess.run([*command, *words], capture_output=True, text=True, check=False)
    found = re.findall(r'^  "digest": "([0-9a-f]{16})"', ended.stdout, flags=re.M)
    if ended.returncode != 0 or len(found) != 1:
        return f"status {ended.returncode}, {ended.stderr.strip()}", []
    return found[0], [float(text) for text in re.findall(r'condition": ([^,\n]+)', ended.stdout)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="")
    parser.add_argument("targets", nargs="+", metavar="NAME=FILE=COMMAND")
    chosen = parser.parse_args()
    scenes = [scene for scene in scenes_of_library() if chosen.only in scene[1]]
    failed, conditions = not scenes, {}
    print(f"{'built for, run by':44} {'bytes':>8} {'scenes':>7} {'agree':>6} {'seconds':>8}")
    for name, file, command in (text.split("=", 2) for text in chosen.targets):
        begin = time.monotonic()
        differ = []
        for digest, scene in scenes:
            answer = answer_of(shlex.split(command), scene)
            expected = digest, conditions.setdefault(scene, answer[1])
            if answer != expected:
                differ.append((scene, answer, expected))
        print(f"{name:44} {pathlib.Path(file).stat().st_size:8} {len(scenes):7} {len(scenes) - len(differ):6} {time.monotonic() - begin:8.1f}",
              flush=True)
        for scene, answer, expected in differ:
            print(f"    pulloff {scene}: {answer}, expected {expected}")
        failed = failed or bool(differ)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
