#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs the tests; arguments go to ctest (e.g. -L unit).
# The last lines are ctest's own summary.
set -eu
cd "$(dirname "$0")/.."
. scenes/build.sh

install_packages
mkdir -p build
build_release
# Long studies (label slow) are for the night; they run with: sh tests/run.sh -L slow
[ $# -gt 0 ] || set -- -LE slow
cd build/release
exec ctest --output-on-failure --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
