#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: frames_test.sh PROGRAM MAKE_DIES
# A coarse main job gives the same history, events and states, byte for byte, whether frames are drawn beside it
# or not, and for one and two threads. Runs in the top folder.
set -eu
program=$1 make_dies=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$make_dies" "$work" square_bulge_die >"$work/out"

run() {
  folder=$1
  shift
  "$program" run scenes/square-bulge.toml -o "$work/$folder" --set "tool.die.file=$work/square_bulge_die.stl" \
    --set tube.elements_around=12 --set tube.elements_along=30 \
    --set 'load.pressure_MPa=[[0, 0], [0.15, 18], [0.4, 32]]' \
    --set 'load.axial_feed_mm=[[0, 0], [0.15, 0], [0.4, 0.5]]' \
    --set 'frames.size_px=[320, 240]' --set frames.number=10 "$@" >"$work/out" 2>&1 || {
    echo "FAILED: exit code $?"
    cat "$work/out"
    exit 1
  }
}

run drawn --threads 2
run plain --threads 2 --no-frames
run alone --threads 1 --no-frames
for view in contact-map tool-normals slip; do
  [ -s "$work/drawn/frames/$view/00010.png" ] || { echo "FAILED: no frames of $view were drawn"; exit 1; }
done
[ ! -e "$work/plain/frames" ] || { echo "FAILED: frames in spite of --no-frames"; exit 1; }
[ "$(wc -l <"$work/plain/history.csv")" -gt 10 ] || { echo "FAILED: hardly any increments"; exit 1; }
[ "$(wc -l <"$work/plain/events.csv")" -gt 50 ] || { echo "FAILED: hardly any contact"; exit 1; }
for other in drawn alone; do
  cmp "$work/plain/history.csv" "$work/$other/history.csv"
  cmp "$work/plain/events.csv" "$work/$other/events.csv"
  diff -r "$work/plain/states" "$work/$other/states"
done
