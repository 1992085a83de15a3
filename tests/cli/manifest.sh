# shellcheck shell=sh disable=SC2154
# Sourced by tests of external solvers: manifests of responder.py.
root=$here/../..
export PULLOFF_DATA="$root"
python=/usr/bin/python3

manifest() { # MODE [MORE LINES]: the manifest MODE.yaml of a responder.
  cat >"$1.yaml" <<END
protocol: pulloff-ask/1
solver: $1
command: [$python, '$here/responder.py', $1, '$root/reference/feng_pull_off.csv', '{request}', '{response}']
can:
  scene: [{key: tabor, to: ${most:-5}}, {key: radius}, {key: outer_radius}]
  quantities: [pull_off_force, pull_off_approach, contact_radius]
  unstable: ${unstable:-true}
time_limit: ${limit:-2}
$2
END
}
