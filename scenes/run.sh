#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs a shipped scene into results/NAME.
set -eu
cd "$(dirname "$0")/.."
. scenes/build.sh

usage() {
  echo "usage: sh scenes/run.sh NAME [options of hydroscope run]"
  echo "scenes:"
  for file in scenes/*.toml; do
    [ -e "$file" ] || continue
    printf '  %-18s %s\n' "$(basename "$file" .toml)" "$(sed -n 's/^title *= *"\(.*\)"/\1/p' "$file" | head -n 1)"
  done
}

name=${1:-}
case $name in
  '' | -h | --help)
    usage
    [ -n "$name" ] || exit 2
    exit 0
    ;;
esac
shift
name=$(basename "$name" .toml)
scene=scenes/$name.toml
if [ ! -f "$scene" ]; then
  echo "error: there is no scene '$name'" >&2
  usage >&2
  exit 2
fi

install_packages
mkdir -p build
build_release hydroscope hydroscope_make_dies

# Die meshes are made by a program of the project, not kept in it; those of an older one are made again.
maker=build/release/scenes/generators/hydroscope_make_dies
sed -n 's/^ *file *= *"\(.*\)\.stl".*/\1/p' "$scene" | while read -r die; do
  [ "scenes/$die.stl" -nt "$maker" ] || "$maker" "scenes/$(dirname "$die")" "$(basename "$die")"
done

# --force: results of an earlier run of the scene are replaced.
status=0
build/release/hydroscope run "$scene" -o "results/$name" --force "$@" || status=$?
if [ -d "results/$name/frames" ]; then
  echo "Frames are in $(pwd)/results/$name/frames"
fi
exit $status
