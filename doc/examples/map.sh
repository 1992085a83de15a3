#!/bin/sh
# A map of the pull-off force over Tabor parameter and amplitude, in four shards as four machines would solve them, merged and
# drawn. Usage: map.sh FIGURE
set -e
cat >map.yaml <<'END'
name: map
title: Pull-off force of wavy spheres, wavelength 20
suites: [mine]
scene: {wavelength: 20, radius: 100, outer_radius: inf, scheme: panel, tolerance: 1e-4}
sweep:
  - {key: amplitude, from: 0.1, to: 5, count: 12, scale: log}
  - {key: tabor, from: 0.2, to: 5, count: 12, scale: log}
want: [pull_off]
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 1e-9, kind: abs, because: every scene has an equilibrium}
END
for shard in 1 2 3 4; do # each line on a machine of its own: see "Several machines" in the guide
  pulloff run map.yaml --shard $shard/4 --output shards/$shard
done
pulloff merge shards/*
pulloff verify map.yaml
pulloff plot --case map.yaml "$1"
