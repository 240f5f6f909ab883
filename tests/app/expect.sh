# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the shell tests, which run in the top folder with the program as $1: a folder for their files
# that goes away at the end, and checks that count what fails.
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
  sed 's/^/    /' "$work/out" "$work/err"
}

# expect CODE TEXT COMMAND...: exit code, and a piece of what is printed. No display, whatever the tester has.
expect() {
  code=$1 text=$2
  shift 2
  env -u DISPLAY -u WAYLAND_DISPLAY "$@" >"$work/out" 2>"$work/err"
  got=$?
  [ "$got" -eq "$code" ] || fail "exit code $got instead of $code: $*"
  cat "$work/out" "$work/err" | grep -qF -- "$text" || fail "no '$text' from: $*"
}

absent() { [ ! -e "$1" ] || fail "$1 should not be there"; }
present() { [ -e "$1" ] || fail "$1 is missing"; }
