#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: console_test.sh PROGRAM
# The console with scripts on standard input, and replays of what they did. Runs in the top folder.
. tests/app/expect.sh

# follow CODE TEXT ARGUMENTS...: the program with $work/script on its standard input.
follow() {
  code=$1 text=$2
  shift 2
  expect "$code" "$text" sh -c '"$@" <"$0"' "$work/script" "$program" "$@"
}

scene=tests/baselines/leaving.toml
cp "$scene" "$work/scene.toml"

# Steering and looking; a branch; what is asked for comes after the halt.
cat >"$work/script" <<'END'
# a comment, and an empty line

until touch   # the first
status
node 3
set tool.die.leaves_at_s 1.4
until detachment
events 3
warnings
states
back 0
run
quantities
help
END
follow 0 "the whole path was followed" console "$work/scene.toml" -o "$work/steered"
for piece in "touched, first node" "margin to letting go" "let go" "branch 1 begins" "the scene asks for no quantities" \
  "until thinning X"; do
  grep -qF -- "$piece" "$work/out" || fail "no '$piece' from the script"
done
grep -q '"outcome": "user stop"' "$work/steered/summary.json" || fail "the branch that was left has no summary"
grep -q '"outcome": "completed"' "$work/steered/branches/1/summary.json" || fail "the last branch has no summary"
for branch in steered steered/branches/1; do
  "$program" inspect "$work/$branch" >"$work/out" 2>"$work/err" || fail "inspect refuses $branch"
done

# The same again from the journal, bit for bit; with any number of threads.
: >"$work/script"
follow 0 "the whole path was followed" run --replay "$work/steered/journal.jsonl" -o "$work/again" --threads 1
for name in history.csv events.csv branches/1/history.csv branches/1/events.csv; do
  cmp "$work/steered/$name" "$work/again/$name" || fail "$name differs in the replay"
done
(cd "$work/steered" && find . -name '*.vtp') | while read -r name; do
  cmp "$work/steered/$name" "$work/again/$name" || echo "$name" >>"$work/different"
done
[ ! -e "$work/different" ] || fail "states differ in the replay"

# A run that was only watched keeps what hydroscope run keeps.
echo run >"$work/script"
follow 0 "the whole path was followed" console "$work/scene.toml" -o "$work/watched"
"$program" run "$work/scene.toml" -o "$work/plain" --no-frames >"$work/out" 2>"$work/err"
for name in history.csv events.csv states/00002.vtp; do
  cmp "$work/plain/$name" "$work/watched/$name" || fail "$name depends on the console"
done

# A killed run: its journal ends within a line, and goes on as it was left.
cp "$work/steered/journal.jsonl" "$work/cut.jsonl"
head -c -20 "$work/steered/journal.jsonl" >"$work/cut.jsonl"
follow 0 "the last line is broken off" run --replay "$work/cut.jsonl" -o "$work/cut"
cmp "$work/steered/branches/1/history.csv" "$work/cut/branches/1/history.csv" || fail "the cut journal leads elsewhere"

# Faults.
follow 2 "a replay takes the settings of its journal" run --replay "$work/steered/journal.jsonl" --set a.b=1
follow 2 "SCENE is missing" run
printf 'until touch\nstep 2\nunti slip\nrun\n' >"$work/script"
follow 2 "standard input:3: 'unti' is no command; did you mean 'until'?" console "$work/scene.toml" -o "$work/fault"
[ -e "$work/fault/summary.json" ] || fail "a fault in the script lost the summary"
follow 2 "holds the results of a run" console "$work/scene.toml" -o "$work/fault"
: >"$work/script"
echo "# changed" >>"$work/scene.toml"
follow 2 "has changed since the journal was written" run --replay "$work/steered/journal.jsonl" -o "$work/changed"
[ ! -e "$work/changed" ] || fail "a refused replay made a folder"

# --force clears branches of an earlier run, too.
echo "step" >"$work/script"
follow 0 "stopped by the user" console "$work/scene.toml" -o "$work/steered" --force
[ ! -e "$work/steered/branches/1/history.csv" ] || fail "--force left a branch of the earlier run"

[ $failures -eq 0 ] && echo "all as expected"
exit $failures
