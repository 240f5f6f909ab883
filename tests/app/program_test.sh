#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: program_test.sh PROGRAM
# The program as its user meets it: exit codes, messages, what is on disk. Runs in the top folder.
. tests/app/expect.sh

# A few increments of a plain tube, with no tool.
cat >"$work/quick.toml" <<'EOF'
title = "quick"
[tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 5
section = "quarter"
extent = "slice"
elements_around = 6
[material]
youngs_modulus_MPa = 206e3
[load]
pressure_MPa = [[0, 0], [1, 5]]
[frames]
views = ["thickness"]
number = 2
size_px = [160, 120]
animation = "none"
[states]
number = 2
[quantity.r_mm]
kind = "radius"
EOF
sed 's/radius_mm = 30/radius_mn = 30/' "$work/quick.toml" >"$work/bad.toml"

# Help and version.
expect 0 "usage: hydroscope COMMAND" "$program" --help
expect 2 "usage: hydroscope COMMAND" "$program"
expect 0 "hydroscope " "$program" --version
expect 0 "--threads" "$program" run --help
expect 0 "--threads" "$program" help run
expect 0 "# Scene reference" "$program" reference
expect 0 "complete -o filenames" "$program" completion bash
expect 2 "did you mean 'render'?" "$program" rendr
expect 2 "did you mean '--force'?" "$program" run x --forse

# Bad input: exit code 2, and nothing is written.
expect 2 "bad.toml:3: key 'tube.radius_mn': unknown; did you mean 'radius_mm'?" "$program" run "$work/bad.toml" -o "$work/bad"
expect 2 "no such scene file" "$program" run "$work/none.toml" -o "$work/bad"
expect 2 "--set tube.thickness_mm=-1" "$program" run "$work/quick.toml" -o "$work/bad" --set tube.thickness_mm=-1
expect 2 "\"colour\" is not known" "$program" run "$work/quick.toml" -o "$work/bad" --views colour
expect 2 "no such file" "$program" run "$work/quick.toml" -o "$work/bad" --set tool.die.file=none.stl
echo "this is no mesh" >"$work/text.stl"
expect 2 "text.stl" "$program" run "$work/quick.toml" -o "$work/bad" --set tool.die.file=text.stl
expect 2 "--threads 0" "$program" run "$work/quick.toml" -o "$work/bad" --threads 0
absent "$work/bad"
expect 2 "is a file" "$program" run "$work/quick.toml" -o "$work/quick.toml"
expect 2 "cannot be written" "$program" run "$work/quick.toml" -o "$work/quick.toml/below" --no-frames
expect 2 "no saved states here" "$program" render "$work"

# A run, and what is there afterwards.
expect 0 "r_mm = 30.0" "$program" run "$work/quick.toml" -o "$work/run" --no-frames
for name in summary.json history.csv events.csv model.json scene.toml overrides.txt states.pvd states/00000.vtp; do
  present "$work/run/$name"
done
absent "$work/run/frames"
grep -q '"outcome": "completed"' "$work/run/summary.json" || fail "outcome in summary.json"

# An existing folder is refused, replaced only by --force, and foreign files stay.
expect 2 "--force" "$program" run "$work/quick.toml" -o "$work/run" --no-frames
echo mine >"$work/run/notes.txt"
expect 0 "results: $work/run" "$program" run "$work/quick.toml" -o "$work/run" --no-frames --force
present "$work/run/notes.txt"

# Drawn again from the saved states, with another view than the run asked for.
expect 0 "frames:" "$program" render "$work/run" --views plastic-strain,contact-map --size 128x96
present "$work/run/frames/plastic-strain/00001.png"
present "$work/run/frames/contact-map/00003.png"
expect 2 "only keys of [frames]" "$program" render "$work/run" --set tube.radius_mm=31

# The same bits for any number of threads, and with frames or without.
expect 0 "results:" "$program" run "$work/quick.toml" -o "$work/framed" --threads 2
present "$work/framed/frames/thickness/00003.png"
expect 0 "results:" "$program" run "$work/quick.toml" -o "$work/single" --threads 1 --no-frames
cmp "$work/framed/history.csv" "$work/single/history.csv" || fail "history depends on threads or frames"
for state in 00000 00001 00002; do
  cmp "$work/framed/states/$state.vtp" "$work/single/states/$state.vtp" || fail "state $state depends on threads or frames"
done

# A tool that is taken away is gone from the states, and so from what is drawn of them.
expect 0 "renderer: llvmpipe" "$program" run tests/baselines/leaving.toml -o "$work/leaving" --views contact-map --frames 4 --size 128x96
grep -q '"present": true' "$work/leaving/frames/contact-map/00001.json" || fail "the tool is there at first"
grep -q '"present": false' "$work/leaving/frames/contact-map/00005.json" || fail "the tool has left"
grep -q '"rest_share": [0-9]' "$work/leaving/frames/contact-map/00005.json" || fail "no force balance in the sidecar"
grep -q '"renderer": "llvmpipe' "$work/leaving/summary.json" || fail "summary.json does not name the renderer"
expect 0 "frames:" "$program" render "$work/leaving" --views contact-map --size 128x96  # a state more: where it let go
grep -q '"present": false' "$work/leaving/frames/contact-map/00006.json" || fail "the tool came back when drawn again"

# Ctrl-C: the increment under way is finished, everything is written.
"$program" run "$work/quick.toml" -o "$work/stopped" --no-frames --set increment.largest=1e-5 \
  --set increment.smallest=1e-9 >"$work/out" 2>"$work/err" &
process=$!
tries=0
while [ ! -s "$work/stopped/states.pvd" ] && [ $tries -lt 100 ]; do
  sleep 0.1
  tries=$((tries + 1))
done
sleep 0.3
# A shell without job control starts background jobs deaf to SIGINT; TERM takes the same way.
kill -TERM $process
wait $process
got=$?
[ "$got" -eq 130 ] || fail "exit code $got instead of 130 after an interrupt"
present "$work/stopped/summary.json"
grep -q '"outcome": "user.stop"' "$work/stopped/summary.json" || fail "outcome after an interrupt"
[ "$(find "$work/stopped/states" -name '*.vtp' | wc -l)" -ge 2 ] || fail "the last state is missing"

# Disk full: a clean stop, whole files, no summary. A limit on file sizes stands in for the disk.
(
  ulimit -f 40
  "$program" run "$work/quick.toml" -o "$work/full" --no-frames --set increment.largest=1e-4 --set increment.smallest=1e-9 \
    >"$work/out" 2>"$work/err"
)
got=$?
[ "$got" -eq 5 ] || fail "exit code $got instead of 5 on a full disk"
grep -q "cannot be written" "$work/err" || fail "no word of the full disk"
absent "$work/full/summary.json"
[ "$(tail -c 1 "$work/full/history.csv" | wc -l)" -eq 1 ] || fail "history.csv ends within a line"

# A tool mesh by itself.
cat >"$work/tool.obj" <<'EOF'
v 0 0 0
v 10 0 0
v 10 10 0
v 0 10 0
f 1 2 3 4
EOF
expect 0 "2 facets, 4 points" "$program" tool "$work/tool.obj"
expect 0 "picture:" "$program" tool "$work/tool.obj" -o "$work/tool.png" --size 200x150
present "$work/tool.png"
expect 2 "text.stl" "$program" tool "$work/text.stl"

[ $failures -eq 0 ] && echo "all as expected"
exit $failures
