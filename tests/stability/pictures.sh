#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of docs/stability.md from the scenes of this folder.
#   sh tests/stability/pictures.sh BUILD      (from the root; BUILD holds the built program)
# The charts need the target hydroscope_stability_charts.
set -eu
build=$1
out=docs/images/stability
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

look_at=
# shot NAME SCENE VIEW AZIMUTH ELEVATION ZOOM [KEY=VALUE ...]: the last state of a run. Runs that are meant to
# fail end with exit code 3 or 4.
shot() {
  name=$1 scene=$2 view=$3 azimuth=$4 elevation=$5 zoom=$6
  shift 6
  sets=""
  for assignment; do sets="$sets --set $(echo "$assignment" | tr -d ' ')"; done
  # shellcheck disable=SC2086
  "$build/hydroscope" run "tests/stability/$scene.toml" -o "$work/$name" --no-frames $sets >"$work/log" 2>&1 ||
    case $? in 3 | 4) ;; *) cat "$work/log"; exit 1 ;; esac
  "$build/hydroscope" render "$work/$name" --views "$view" --size 640x480 --animation none \
    --set "frames.azimuth_deg=$azimuth" --set "frames.elevation_deg=$elevation" --set "frames.zoom=$zoom" \
    ${look_at:+--camera look-at:$look_at} --set frames.mirror=false --set frames.tool_opacity=0.6 >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  last=$(ls "$work/$name/frames/$view"/*.png | tail -1)
  cp "$last" "$out/$name.png"
}

look_at=3 shot concave-corner-naive concave-corner gap 84 8 2.2 tool.die.projection=orthogonal
look_at=3 shot concave-corner concave-corner gap 84 8 2.2
look_at=6 shot narrow-die-naive narrow-die contact-map 50 25 2.2 tool.die.projection=orthogonal
look_at=6 shot narrow-die narrow-die contact-map 50 25 2.2
look_at=6 shot sharp-corner-naive sharp-corner thickness 86 6 5 strip.elements_lead_in=8 strip.elements_arc=1 strip.elements_lead_out=3
look_at=34 shot sharp-corner-default sharp-corner thickness 86 6 5
look_at=4 shot bad-mesh-naive bad-mesh gap 50 25 2.2 tool.die.surface=facets tool.die.projection=orthogonal
look_at=4 shot bad-mesh bad-mesh gap 50 25 2.2
shot large-increments-naive large-increments thickness 84 8 0.92 increment.max_strain=1 increment.max_rotation_deg=90 \
  increment.max_slide=100 increment.max_penetration=10 increment.max_iterations=100
shot large-increments large-increments thickness 84 8 0.92
shot backed-wall-naive backed-wall contact-map 84 8 0.92 contact.release=sign
shot backed-wall backed-wall contact-map 84 8 0.92 'load.pressure_MPa=[[0,0],[1,30]]'
shot facet-noise-naive facet-noise contact-map 84 8 0.92 increment.correction=none contact.release=fluid increment.smallest=3e-4
shot facet-noise-default facet-noise contact-map 84 8 0.92
"$build/hydroscope" tool tests/stability/tools/bad-die.obj -o "$out/bad-die.png" --size 640x480 >"$work/log"
"$build/tests/stability/hydroscope_stability_charts" "$out"
