"""Computes the digests of scenes of every kind in several ways and compares them with those of scenes.txt.

Usage: bits.py [--variants] [--emulator COMMAND] [--accept] NAME=PROGRAM...

Each program computes all scenes. --variants: each again with the oldest kernels of OpenBLAS and the functions that the C
library has for processors without AVX2 and FMA; and one scene with a condition number, for which alone OpenBLAS is called
(symbols.py), with every other set of kernels that OpenBLAS has for a processor like this one. --emulator: COMMAND runs the
programs. --accept: writes the digests of the first program to scenes.txt. Exit status: 0 all digests are those of scenes.txt,
1 some are not. Prints a line for each way: who computed, how many scenes, how many differ, seconds.
"""

import argparse
import concurrent.futures
import os
import pathlib
import platform
import re
import shlex
import subprocess
import sys
import time

from scenes import SCENES, read_scenes

# The instructions that each set of kernels needs, by their names in /proc/cpuinfo.
KERNELS = {"Prescott": "pni", "Core2": "ssse3", "Nehalem": "sse4_2", "Sandybridge": "avx", "Haswell": "avx2", "Zen": "avx2",
           "SkylakeX": "avx512vl", "Cooperlake": "avx512_bf16"}
OF_OPENBLAS = "--scheme triangle"  # words of this scene
OLD_PROCESSOR = "glibc.cpu.hwcaps=" + ",".join("-" + name for name in (
    "AVX512F", "AVX512VL", "AVX2", "FMA", "FMA4", "AVX2_Usable", "FMA_Usable"))


def environments():
    """Name and variables of each way of a program, and a word of the scenes that are computed so."""
    ways = {"": ({}, "")}
    if platform.machine() == "x86_64":
        flags = set(re.findall(r"\w+", pathlib.Path("/proc/cpuinfo").read_text()))
        oldest, *others = (name for name, flag in KERNELS.items() if flag in flags)
        ways[f"kernels {oldest}, C library without AVX2 and FMA"] = (
            {"OPENBLAS_CORETYPE": oldest, "GLIBC_TUNABLES": OLD_PROCESSOR}, "")
        ways |= {f"kernels {name}": ({"OPENBLAS_CORETYPE": name}, OF_OPENBLAS) for name in others}
    return ways


def digest_of(command, scene, variables):
    words = shlex.split(scene.replace("HERE", str(SCENES.parent)))
    ended = subprocess.run([*command, *words], env={**os.environ, **variables}, capture_output=True, text=True)
    found = re.findall(r"^digest +([0-9a-f]{16})$", ended.stdout, flags=re.M)
    if ended.returncode == 0 and len(found) == 1:
        return found[0]
    return f"exit status {ended.returncode}: {ended.stderr.strip()}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--variants", action="store_true")
    parser.add_argument("--emulator", default="")
    parser.add_argument("--accept", action="store_true")
    parser.add_argument("programs", nargs="+", metavar="NAME=PROGRAM")
    chosen = parser.parse_args()
    ways = environments() if chosen.variants else {"": ({}, "")}
    failed = False
    print(f"{'computed by':50} {'scenes':>7} {'differ':>7} {'seconds':>8}")
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for name, program in (text.split("=", 1) for text in chosen.programs):
            command = [*shlex.split(chosen.emulator), program]
            for way, (variables, word) in ways.items():
                scenes = [scene for scene in read_scenes() if word in scene[1]]
                begin = time.monotonic()
                digests = list(pool.map(lambda scene: digest_of(command, scene[1], variables), scenes))
                if chosen.accept:
                    head = [line for line in SCENES.read_text().splitlines() if line.startswith("#")]
                    SCENES.write_text("\n".join(head + [f"{d} {s[1]}" for d, s in zip(digests, scenes)]) + "\n")
                    return 0
                differ = [(scene, digest) for scene, digest in zip(scenes, digests) if digest != scene[0]]
                failed = failed or bool(differ)
                print(f"{', '.join(filter(None, (name, way))):50} {len(scenes):7} {len(differ):7} "
                      f"{time.monotonic() - begin:8.1f}")
                for (stored, scene), digest in differ:
                    print(f"    pulloff {scene}: {digest}, expected {stored}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
