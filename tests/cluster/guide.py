"""Runs the commands of the guide for several machines, as printed there, with GNU parallel and with Slurm.

Usage: guide.py PULLOFF GUIDE

The commands are taken from doc/guide.md. The cases that they name are small ones in a data folder of the test. The
shards use the OpenBLAS kernels of an old processor, as on a cluster of other machines. The merged run must be equal to
the run on this machine, to the last bit except for times. Exit status 77: a required program is not installed.
"""

import filecmp
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from cluster import DAEMONS, Cluster, daemon_path

SKIPPED = 77
NODES = "Prescott"  # an old processor
OF_MACHINE = {"seconds", "seconds_all", "processor_seconds_all", "date", "jobs", "openblas"}

CASES = {
    "drawn": """
suites: [paper]
scene: {outer_radius: inf, scheme: panel, tolerance: 1e-4}
sample: {seed: 5, count: 9, keys: [{key: tabor, from: 0.7, to: 1.3}, {key: radius, from: 70, to: 200}]}
want: [pull_off, curve]
""",
    "timed": """
suites: [precision]
scene: {tabor: 0.9, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [63, 71, 83]}]
repeats: 2
want: [pull_off, profile]
lines: [{name: smooth, theory: jkr, sweep: [{key: tabor, values: [1, 2]}]}]
""",
    "followed": """
suites: [paper, precision]
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21}
sweep: [{key: amplitude_ratio, values: [0.01, 0.02]}, {key: tabor, from: 0.5, to: 0.7, count: 4}]
follow: tabor
want: [pull_off]
""",
}


def skip_without_tools():
    lacking = [name for name in DAEMONS if not daemon_path(name)]
    lacking += [name for name in ("sbatch", "sinfo") if not shutil.which(name)]
    version = shutil.which("parallel") and subprocess.run(["parallel", "--version"], capture_output=True).stdout
    if not version or not version.startswith(b"GNU parallel"):
        lacking.append("GNU parallel")
    if lacking:
        print(f"skipped: there is no {', '.join(lacking)} (./check --suite cluster installs slurm-wlm, munge, parallel)")
        sys.exit(SKIPPED)


def commands(guide):
    """The commands of the guide for GNU parallel, for shard.sh and for Slurm."""
    text = pathlib.Path(guide).read_text()
    text = text[text.index("### Several machines"):]
    blocks = re.findall(r"^```sh\n(.*?)^```$", text, flags=re.M | re.S)
    assert len(blocks) >= 3 and blocks[0].startswith("parallel ") and blocks[1].startswith("#!/bin/sh\n#SBATCH ") \
        and blocks[2].startswith("sbatch "), "the guide no longer has three blocks of commands: change this test, too"
    return blocks[:3]


def without_machine(value):
    if isinstance(value, dict):
        return {key: without_machine(item) for key, item in value.items() if key not in OF_MACHINE}
    return [without_machine(item) for item in value] if isinstance(value, list) else value


def compare(merged, whole):
    """Compares all files of two runs: the same cases, equal records except for times, and identical tables."""
    names = [{str(path.relative_to(run)) for path in run.rglob("*") if path.is_file()} for run in (merged, whole)]
    assert names[0] == names[1], f"other files: {names[0] ^ names[1]}"
    for name in sorted(names[0]):
        if name.endswith("record.json"):
            pair = [without_machine(json.loads((run / name).read_text())) for run in (merged, whole)]
            assert pair[0] == pair[1], f"{name} of {merged} is not that of the whole run"
        else:
            assert filecmp.cmp(merged / name, whole / name, shallow=False), f"{name} is not the same"
    print(f"{len(names[0])} files of {len([name for name in names[0] if 'record' in name])} cases are those of the "
          "whole run")


def make_place(work, program):
    """Creates a folder like the source tree, with build/src/cli/pulloff and the cases of the test."""
    (work / "build/src/cli").mkdir(parents=True)
    (work / "build/src/cli/pulloff").symlink_to(program)
    (work / "data/cases").mkdir(parents=True)
    (work / "data/reference").mkdir()
    for name, text in CASES.items():
        (work / f"data/cases/{name}.yaml").write_text(f"name: {name}\ntitle: A small case{text}")


def run(script, work, environment):
    print(f"$ {script.strip()}", flush=True)
    ended = subprocess.run(["sh", "-e", "-c", script], cwd=work, env=environment, stdin=subprocess.DEVNULL,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(ended.stdout, end="", flush=True)
    assert ended.returncode == 0, f"exit status {ended.returncode}"
    return ended.stdout


def whole_run(suites, work):
    folder = work / f"whole-{suites}"
    run(f"build/src/cli/pulloff run --suite {suites} --output {folder.name} 2>/dev/null", work,
        dict(os.environ, PULLOFF_DATA=str(work / "data")))
    return folder


def main():
    program, guide = (os.path.realpath(path) for path in sys.argv[1:])
    skip_without_tools()
    with_parallel, shard, with_slurm = commands(guide)
    with tempfile.TemporaryDirectory(prefix="pulloff-") as folder:
        work = pathlib.Path(folder, "work")
        make_place(work, program)
        (work / "shard.sh").write_text(shard)
        environment = dict(os.environ, PULLOFF_DATA=str(work / "data"), OPENBLAS_CORETYPE=NODES, HOME=str(work))

        run(with_parallel, work, environment)
        merged = work / "build/run"
        compare(merged, whole_run("paper", work))
        shutil.rmtree(merged)

        daemons = pathlib.Path(folder, "daemons")
        daemons.mkdir()
        os.chmod(folder, 0o755)
        with Cluster(daemons) as cluster:
            environment["SLURM_CONF"] = cluster.environment["SLURM_CONF"]
            try:
                run(with_slurm, work, environment)
            except AssertionError:
                print("".join(path.read_text() for path in sorted(work.glob("slurm-*.out"))) + cluster.said())
                raise
        tasks = len(list((work / "tasks").iterdir()))
        assert tasks == int(re.search(r"--array=1-(\d+)", with_slurm).group(1)), f"{tasks} tasks wrote a shard"
        compare(merged, whole_run("paper,precision", work))


if __name__ == "__main__":
    main()
