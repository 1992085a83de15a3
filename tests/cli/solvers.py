"""What the tests of external solvers share: manifests of responder.py."""

import json
import pathlib

from conftest import HERE, ROOT

SCENE = "[{key: tabor, to: %s}, {key: radius}, {key: outer_radius}]"


def manifest(mode, *more, answers=None, scene=SCENE % 5, quantities="pull_off_force, pull_off_approach, contact_radius", unstable="true",
             start_limit=20, time_limit=2):
    """Writes the manifest MODE.yaml of a responder that answers in this mode, or in another one. Returns its name."""
    path = pathlib.Path(f"{mode}.yaml")
    path.write_text(f"""protocol: pulloff-ask/1
solver: {mode}
command: [/usr/bin/python3, '{HERE}/responder.py', {answers or mode}, '{ROOT}/reference/feng_pull_off.csv', '{{request}}', '{{response}}']
can:
  scene: {scene}
  quantities: [{quantities}]
  unstable: {unstable}
start_limit: {start_limit}
time_limit: {time_limit}
""" + "".join(f"{line}\n" for line in more))
    return path.name


def record(place):
    return json.loads(pathlib.Path(place).read_text())
