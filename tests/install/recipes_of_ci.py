#!/usr/bin/env python3
"""The recipes for continuous integration in doc/examples/ci and the Dockerfile: both YAML texts are valid and run the same commands; packages,
options and libraries that they name are those of the tree and of the program.

Usage: recipes_of_ci.py PROGRAM SOURCE_TREE
"""

import pathlib
import re
import subprocess
import sys
import unittest

import yaml

PROGRAM, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
DOCKER = (ROOT / "Dockerfile").read_text(encoding="utf-8")


def recipes():
    """Commands of each recipe, by its first key."""
    found = {}
    for path in (ROOT / "doc/examples/ci").glob("*.yml"):
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
        if "jobs" in content:
            job, = content["jobs"].values()
            found["github"] = [step["run"] for step in job["steps"] if "run" in step]
        else:
            job, = content.values()
            found["gitlab"] = job["script"]
    return found


class Recipes(unittest.TestCase):
    def test_same_commands(self):
        both = recipes()
        self.assertEqual(set(both), {"github", "gitlab"})
        self.assertEqual(both["gitlab"], both["github"][1:], "the first step of GitHub installs git")

    def test_packages_and_options(self):
        for text in (*recipes()["gitlab"], DOCKER):
            for name in re.findall(r"-D(\w+)=", text):
                self.assertRegex((ROOT / "meson_options.txt").read_text(), rf"option\('{name}'")
            for path in re.findall(r"pulloff/(tools/\w+)", text):
                self.assertTrue((ROOT / path).exists(), path)

    def test_options_of_the_program(self):
        for line in [line for line in recipes()["gitlab"] if line.startswith("pulloff ")]:
            verb, *words = line.split()[1:]
            usage = subprocess.run([PROGRAM, verb, "--help"], capture_output=True, text=True, check=True).stdout
            for word in words:
                if word.startswith("--"):
                    self.assertIn(word, usage)

    def test_libraries_of_the_image(self):
        """The image has every library that the program names itself."""
        needed = set(re.findall(r"NEEDED\s+lib([\w+-]+)\.so", subprocess.run(["objdump", "-p", PROGRAM], capture_output=True, text=True,
                                                                            check=True).stdout))
        packages = DOCKER[DOCKER.rindex("FROM"):].split("apt-get install")[1].split("&&")[0]
        known = {"c": "", "m": "", "gcc_s": "", "gslcblas": "libgsl", "lapacke": "liblapacke", "openblas": "libopenblas"}
        for name in needed:
            if not name.startswith(("asan", "ubsan", "tsan")):
                self.assertIn(known.get(name, "lib" + name), packages)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
