#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: renew.sh PROGRAM [NAME...]
# Solves the small scenes anew and approves of what they look like now: for a change of the
# state files or of the pictures that is meant. Look at the pictures before committing them.
set -eu
program=$(realpath "$1")
shift
cd "$(dirname "$0")"
[ $# -gt 0 ] || set -- corner leaving
for name; do
  "$program" run "$name.toml" -o "$name/run" --no-frames --force
  # What drawing needs; the rest is of no use here.
  rm -f "$name/run/history.csv" "$name/run/events.csv" "$name/run/summary.json" "$name/run/states.pvd"
  "$program" check "$name/run" --baseline "$name/approved" --pictures 3 --update
done
