#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs the tests; arguments go to ctest (e.g. -L unit).
# The last lines are ctest's own summary.
set -eu
cd "$(dirname "$0")/.."
. scenes/build.sh

# The browser tests need Chromium, node and what node brings from npm. Where that fails the other tests
# still run, and the browser tests say what is missing.
prepare_browser() {
  command -v apt-get >/dev/null 2>&1 && missing=$(sed 's/#.*//' tests/packages.txt | while read -r command package; do
    [ -z "$command" ] || command -v "$command" >/dev/null 2>&1 || printf '%s ' "$package"
  done) && [ -n "$missing" ] && install_named "$missing"
  installed=tests/browser/node_modules/.package-lock.json
  if [ ! -e "$installed" ] || [ tests/browser/package-lock.json -nt "$installed" ]; then
    (cd tests/browser && PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm ci --no-audit --no-fund --loglevel=error) || return 1
    touch "$installed"
  fi
}

install_packages
prepare_browser || echo "The browser tests are not prepared; the others run." >&2
mkdir -p build
build_release
# Long studies (label slow) are for the night; they run with: sh tests/run.sh -L slow
[ $# -gt 0 ] || set -- -LE slow
cd build/release
exec ctest --output-on-failure --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
