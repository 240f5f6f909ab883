#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: chart_test.sh PROGRAM
# hydroscope chart as a user meets it, on a study of seconds. Runs in the top folder.
. tests/app/expect.sh

cat >"$work/blow.toml" <<'SCENE'
title = "A tube that is blown"
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 1.0
section = "octant"
extent = "slice"
elements_around = 4
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
control = "volume"
volume_ratio = [[0.0, 1.0], [1.0, 1.1]]
[quantity.r_mm]
kind = "radius"
angle_deg = 22.5
SCENE
cat >"$work/study.toml" <<'STUDY'
title = "Free expansion"
[run]
repeats = 2
[case.blow]
title = "Free expansion of a tube"
scene = "blow.toml"
default = "0.03"
[case.blow.axis.step]
label = "largest strain in an increment"
key = "increment.max_strain"
values = [0.005, 0.03]
[case.blow.variant.short]
label = "short path"
set.load.volume_ratio = [[0.0, 1.0], [1.0, 1.01]]
[case.blow.quantity.pressure]
column = "pressure_MPa"
driver = "q.r_mm"
at = [30.6, 31.0]
reference = "formula"
formula = "expansion-ring-pressure"
[case.blow.history.residual]
columns = ["residual"]
[case.blow.convergence.step]
axis = "step"
[case.blow.profile.wall]
runs = ["0.03"]
[plot.table]
file = "table.csv"
x = "n"
y = ["error"]
slope = -2
STUDY
printf 'n,error\n1,0.1\n2,0.025\n' >"$work/table.csv"
out=$work/results

expect 0 "3 runs for accuracy, 6 timed ones" "$program" chart "$work/study.toml" --list
[ ! -e "$out" ] || fail "--list made a folder"
expect 0 "blow: 3 runs, 1 failed" "$program" chart "$work/study.toml" -o "$out"
for name in blow-error-wall blow-error-factorisations blow-residual-residual blow-step blow-wall table; do
  for end in png csv; do [ -s "$out/$name.$end" ] || fail "no $name.$end"; done
done
# The run that does not come far enough is a point with its cause, not a hole.
grep -qF 'short path | - ' "$out/report.md" && grep -qF '**failed**: q.r_mm never came to 30.6' "$out/report.md" ||
  fail "no cause in the report"
grep -q '^"failed","short path",' "$out/blow-error-wall.csv" || fail "no failed point on the chart"
# The elastic-plastic ring is met: a polygon of 32 sides is 0.3 % off, no more.
awk -F, 'NR > 1 && $1 != "\"short\"" && !($7 < 0.6) { exit 1 }' "$out/blow-values.csv" || fail "errors are too large"

# Nothing is run twice; the same command only draws again.
touch "$work/mark"
expect 0 "accuracy: 3 runs, 3 of them done before" "$program" chart "$work/study.toml" -o "$out"
[ -z "$(find "$out/runs" -name history.csv -newer "$work/mark")" ] || fail "a finished run was run again"
# What was cut off is done again, and nothing else.
rm "$out/runs/blow/0.03.json"
expect 0 "accuracy: 3 runs, 2 of them done before" "$program" chart "$work/study.toml" -o "$out"
[ "$(find "$out/runs" -name history.csv -newer "$work/mark" | wc -l)" -eq 1 ] || fail "not one run was run again"
# Another scene is another study.
sed -i 's/swift_n = 0.2/swift_n = 0.21/' "$work/blow.toml"
expect 0 "accuracy: 3 runs, 0 of them done before" "$program" chart "$work/study.toml" -o "$out" --no-timing

# A run of a hundred thousand increments meets its time limit: a point, and done until the limit is longer.
cat >"$work/late.toml" <<'STUDY'
[run]
time_limit_s = 0.3
[case.late]
scene = "blow.toml"
timed = false
set.increment.largest = 1e-5
[case.late.quantity.r_mm]
reference = "formula"
formula = "expansion-ring-pressure"
STUDY
expect 0 "late: 1 runs, 1 failed" "$program" chart "$work/late.toml" -o "$work/late"
grep -qF 'time limit 0.3 s at ' "$work/late/report.md" || fail "no time limit in the report"
expect 0 "1 of them done before" "$program" chart "$work/late.toml" -o "$work/late"
sed -i 's/time_limit_s = 0.3/time_limit_s = 0.4/' "$work/late.toml"
expect 0 "0 of them done before" "$program" chart "$work/late.toml" -o "$work/late"

# Interrupted, it says so and goes on later; a run under way leaves no record.
sed -i 's/swift_n = 0.21/swift_n = 0.2/; s/elements_around = 4/elements_around = 400/' "$work/blow.toml"
"$program" chart "$work/study.toml" -o "$work/long" >"$work/out" 2>"$work/err" &
process=$!
while [ ! -e "$work/long/runs/blow/0.005.log" ]; do
  kill -0 $process 2>/dev/null || break
  sleep 0.05
done
kill -TERM $process
wait $process
[ $? -eq 130 ] || fail "interrupted: exit code is not 130"
[ -z "$(find "$work/long/runs" -name '*.json' -path '*blow/*.json' -not -path '*blow/*/*')" ] || fail "a record of a run that was cut off"

# Wrong input: place, key and what is meant.
expect 2 "did you mean 'blow'?" "$program" chart "$work/study.toml" -o "$out" --only blwo
sed 's/max_strain/max_strian/' "$work/study.toml" >"$work/wrong.toml"
expect 2 "wrong.toml:11: increment.max_strian = 0.005" "$program" chart "$work/wrong.toml" -o "$work/never"
[ ! -e "$work/never" ] || fail "a folder was made for a wrong study"

# The shipped studies: every run's scene is read and checked. Each axis has its treatments.
# The studies' scenes read dies that the generator makes.
for die in square_bulge_die square_die; do
  [ -f "scenes/dies/$die.stl" ] || "$(dirname "$program")/scenes/generators/hydroscope_make_dies" scenes/dies "$die" >/dev/null
done
for study in methods methods-3d; do
  expect 0 "[reference]" "$program" chart "scenes/studies/$study.toml" --list
  for key in 'curvature="none"' 'curvature="full"' 'correction="one-step-behind"' 'correction="algoneq"'; do
    grep -qF "$key" "$work/out" || fail "$study has no $key"
  done
done

[ "$failures" -eq 0 ] && echo "all as expected"
exit "$failures"
