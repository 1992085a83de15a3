"""Compares results of the page with those of the program, digest by digest.

Usage: identical.py [--random N] [--seed S] PAGE PROGRAM

Solves, in the page in a headless Chromium and with the program, the scenes of tests/bits/scenes.txt (a followed series and
uncertain numbers are of the command line only) and N random scenes that the program solves in ten seconds. Prints how many
are the same to the last bit, the time of the page relative to that of the program, and each difference. Exit status: 0 all
are the same, 1 some are not, or more than N random scenes took longer.
"""

import argparse
import json
import pathlib
import random
import shlex
import subprocess
import sys
import time

from browser import Browser

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "bits"))
from scenes import keys_of, scenes_of_library  # noqa: E402


def request_of(words):
    """The request to the page for a command line."""
    theory, keys = keys_of(words)
    files = {path: pathlib.Path(path).read_text(encoding="utf-8") for path in [keys.get("profile_file")] if path}
    return {"keys": keys, "files": files} | ({"theory": theory} if theory else {})


def random_scene(source):
    """A scene of any kind. A few of them, such as steep cones with a wave, have thousands of jumps and take minutes."""
    def between(low, high):
        return f"{low * (high / low) ** source.random():.4g}"

    words = ["solve"]
    kind = source.choice(["sphere"] * 6 + ["cone", "power", "punch", "truncated"])
    if kind == "sphere":
        words += ["--tabor", between(0.02, 5), "--radius", between(30, 400)]
    else:
        profile = {"cone": f"cone:{between(0.05, 1)}", "power": f"power:{between(0.005, 0.1)},{between(1.3, 4)}",
                   "punch": f"punch:{between(2, 20)},{between(10, 90)}", "truncated": f"truncated:{between(2, 20)},{between(20, 200)}"}
        words += ["--profile", profile[kind], "--coupling", between(0.02, 2)]
    for _ in range(source.choice([0, 0, 1, 1, 1, 2])):
        words += ["--wave", f"{between(0.02, 1.5)},{between(6, 40)}"]
    law = source.choice(["lennard-jones", "lennard-jones", f"mie:{between(2, 4)},{between(6, 12)}", f"morse:{between(0.5, 3)}"])
    words += ["--law", law]
    if source.random() < 0.15:
        words += ["--scheme", source.choice(["ring", "triangle"]), "--nodes", str(source.randrange(41, 161)), "--outer-radius", between(30, 90)]
    elif source.random() < 0.3:
        words += ["--tolerance", between(1e-8, 1e-4)]
    want = [name for name in ("curve", "profile", "hysteresis", "preload", "diagnostics") if source.random() < 0.25]
    return words + (["--want", ",".join(want)] if want else [])


def by_program(program, words, limit=None):
    """The answer of the program. subprocess.TimeoutExpired: it takes more than `limit` seconds."""
    ended = subprocess.run([program, *words, "--json"], capture_output=True, text=True, check=False, timeout=limit)
    return json.loads(ended.stdout) if ended.stdout else {"error": ended.stderr.strip()}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--random", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("page", type=lambda text: pathlib.Path(text).resolve(strict=True))
    parser.add_argument("program")
    chosen = parser.parse_args()
    source = random.Random(chosen.seed)
    sets = {"bits": [(shlex.split(scene), digest) for digest, scene in scenes_of_library()],
            "random": [(random_scene(source), None) for _ in range(2 * chosen.random)]}  # some are left out
    failed = False
    with Browser() as browser:
        begin = time.monotonic()
        browser.open(chosen.page.as_uri())
        while not browser.evaluate("document.getElementById('summary').textContent"):
            time.sleep(0.01)
        print(f"{chosen.page.stat().st_size} bytes, first curve after {time.monotonic() - begin:.2f} s")
        print(f"{'scenes':10} {'number':>6} {'same':>6} {'refused by both':>15} {'program, s':>10} {'page, s':>8} {'ratio':>6}")
        for name, scenes in sets.items():
            same = refused = solved = left_out = 0
            wanted = len(scenes) if name == "bits" else chosen.random
            seconds = [0.0, 0.0]
            for words, digest in scenes:
                if solved == wanted:
                    break
                try:
                    native = by_program(chosen.program, words, None if digest else 10)
                except subprocess.TimeoutExpired:
                    left_out += 1
                    continue
                solved += 1
                answer = browser.evaluate(f"pulloff.ask({json.dumps(request_of(words))}).then((done) => done.answer)")
                document = answer.get("document", {})
                refused += "error" in native and "error" in answer
                if native.get("digest") == document.get("digest") and (digest is None or digest == native.get("digest")):
                    same += 1
                    for k, result in enumerate((native, document)):
                        seconds[k] += result.get("work", {}).get("seconds") or 0.0
                    continue
                failed = True
                print(f"    pulloff {shlex.join(words)}: {document.get('digest') or answer.get('error')}, "
                      f"expected {digest or native.get('digest') or native.get('error')}")
            ratio = seconds[1] / seconds[0] if seconds[0] else float("nan")
            print(f"{name:10} {solved:6} {same:6} {refused:15} {seconds[0]:10.2f} {seconds[1]:8.2f} {ratio:6.2f}")
            if left_out:
                print(f"    {left_out} random scenes were left out, because the program takes more than ten seconds")
            failed = failed or solved < wanted
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
