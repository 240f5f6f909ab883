#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the browser tests with node, or says how to get it: run.sh NODE OPTIONS...
node=$1
shift
if ! command -v "$node" >/dev/null 2>&1; then
  echo "browser tests: node is missing; install it with: apt-get install nodejs npm   (sh tests/run.sh does so)" >&2
  exit 1
fi
exec "$node" "$(dirname "$0")/run.mjs" "$@"
