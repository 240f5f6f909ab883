#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: inspect_test.sh PROGRAM
# hydroscope inspect as a user meets it, on a real small run. Runs in the top folder.
. tests/app/expect.sh

run=$work/circular-die
expect 0 completed "$program" run scenes/circular-die.toml -o "$run" --no-frames
# On unloading the whole wall lets go at once, and for good: no node before the others, none back.
expect 0 "92 detachments in 1 patch: 92 physical, 0 noise, 0 chatter; 0 came back" "$program" inspect "$run"
grep -q "unloading: the fluid went from 17.* to 16.* MPa" "$work/out" || fail "no reason for the patch"
expect 0 "causes: unloading 92" "$program" inspect "$run"
expect 0 '"detachments": 92' "$program" inspect "$run" --json
expect 0 "node,tool,patch," "$program" inspect "$run" --csv
[ "$(wc -l <"$work/out")" -eq 93 ] || fail "CSV: a head and 92 lines expected"
expect 0 "nothing let go" "$program" inspect "$run" --to 1.0
expect 0 "3 detachments" "$program" inspect "$run" --node-range 4-6
expect 0 "physical, opened by" "$program" inspect "$run" --node 17

# Close-ups of the patch: three states before, one at, three after.
expect 0 "7 frames:  $run/frames/detachment-1/00001.png ..." "$program" render "$run" --follow detachment --size 640x360
for phase in before before before at after after after; do
  number=$((${number:-0} + 1))
  grep -q "\"phase\": \"$phase\"" "$run/frames/detachment-1/0000$number.json" || fail "frame $number is not $phase"
done
grep -q '"let_go_in_frame": 92' "$run/frames/detachment-1/00004.json" || fail "all 92 nodes let go in frame 4"
expect 0 "to see it: hydroscope render $run --follow detachment --patch 1" "$program" inspect "$run"
expect 2 "--patch 2: the run has patches 1 to 1" "$program" render "$run" --follow detachment --patch 2
expect 2 "only 'detachment' can be followed" "$program" render "$run" --follow me
expect 2 "--patch: only together with --follow" "$program" render "$run" --patch 1
expect 2 "--follow draws one view" "$program" render "$run" --follow detachment --views gap,slip

# Bad input: where, and what.
expect 2 "did you mean 'die'?" "$program" inspect "$run" --tool dye
expect 2 "there is no such folder" "$program" inspect "$work/nowhere"
expect 2 "no saved states here" "$program" inspect "$work"
sed -i '5s/touch/tuch/' "$run/events.csv"
expect 2 "events.csv:5: 'tuch' is no kind of event" "$program" inspect "$run"
sed -i '5s/tuch/touch/' "$run/events.csv"
sed -i '7s/,[^,]*$//' "$run/history.csv"
expect 2 "history.csv:7:" "$program" inspect "$run"

# Help and completion know it.
expect 0 "List what let go of a tool" "$program" --help
expect 0 "--node-range A-B" "$program" inspect --help
expect 0 "'inspect --verdict') COMPREPLY" "$program" completion bash
expect 0 "inspect:List what let go" "$program" completion zsh

[ "$failures" -eq 0 ] && echo "all passed"
exit "$failures"
