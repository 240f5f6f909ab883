#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: check_test.sh PROGRAM
# hydroscope check as a continuous integration meets it. Runs in the top folder.
. tests/app/expect.sh
shipped=tests/baselines/leaving

check="$program check $shipped/run --baseline $shipped/approved --report $work/report"

# As approved: by the folder of the run or of its states, on any number of threads.
expect 0 "as the baseline" $check
grep -q 'tests="21" failures="0"' "$work/report/junit.xml" || fail "junit.xml of an accepted sequence"
absent "$work/report/index.html"
expect 0 "renderer: llvmpipe" $check --threads 1
expect 0 "as the baseline" $check --threads 4
expect 0 "as the baseline" "$program" check "$shipped/run/states/" --baseline "$shipped/approved" --report "$work/report"

# Another way to the same renderer: the same pixels, where the machine has it.
HYDROSCOPE_RENDERER=egl $check >"$work/out" 2>"$work/err"
if [ $? -eq 5 ]; then
  echo "skipped, EGL against OSMesa: $(cat "$work/err")"
else
  expect 0 "as the baseline" env HYDROSCOPE_RENDERER=egl $check
  grep -q "differ in at most 0 % of their pixels, by at most 0" "$work/out" ||
    grep -q "by another renderer" "$work/out" || fail "EGL and OSMesa draw other pixels"
fi

# Another font is told, and is no reason to reject.
expect 0 "note: lettering in 'URW Gothic" env HYDROSCOPE_FONTS=/nowhere $check

# Nothing to draw with: a readable error and code 5, and nothing hangs.
expect 5 "cannot use the software renderer /nowhere/libOSMesa.so.8" env HYDROSCOPE_OSMESA=/nowhere/libOSMesa.so.8 timeout 60 $check
expect 5 "invalid ELF header" env HYDROSCOPE_OSMESA=/etc/passwd timeout 60 $check
expect 5 "no function OSMesaCreateContextAttribs" env HYDROSCOPE_OSMESA=libz.so.1 timeout 60 $check
expect 5 "softpipe" env GALLIUM_DRIVER=softpipe timeout 60 $check
expect 5 "cannot use the software renderer" env HYDROSCOPE_OSMESA=/nowhere timeout 60 "$program" render "$shipped/run" --views gap

# A state that is gone: found, named, and shown.
cp -r "$shipped/run" "$work/run"
rm "$work/run/states/00002.vtp"
expect 1 "DIFFERENT sequence, frame 3: states/00002.vtp is missing" "$program" check "$work/run" --baseline "$shipped/approved"
present "$work/run/check/junit.xml"
present "$work/run/check/index.html"
grep -q '<failure type="sequence" message="states/00002.vtp is missing"/>' "$work/run/check/junit.xml" || fail "junit.xml does not name it"

# Another picture: three files and a page that needs no other.
cp -r "$shipped/approved" "$work/approved"
cp "$work/approved/contact-map/00001.png" "$work/approved/contact-map/00003.png"
expect 1 "pixels, contact-map, frame 3" "$program" check "$shipped/run" --baseline "$work/approved" --report "$work/other"
for picture in expected got difference; do present "$work/other/contact-map/00003-$picture.png"; done
[ "$(grep -o 'data:image/png;base64,' "$work/other/index.html" | wc -l)" -eq 5 ] || fail "pictures in index.html"
grep -qE '(src|href)="[^d]' "$work/other/index.html" && fail "index.html needs other files"
grep -q 'type="range"' "$work/other/index.html" || fail "index.html has no slider"
grep -aq "Renderer" "$work/other/contact-map/00003-got.png" || fail "the picture does not name its renderer"

# Renewed: says what changes, is then as approved, and leaves no report of the past.
expect 0 "DIFFERENT pixels, contact-map, frame 3" "$program" check "$shipped/run" --baseline "$work/approved" --update --pictures 2
expect 0 "as the baseline" "$program" check "$shipped/run" --baseline "$work/approved" --report "$work/other"
absent "$work/other/index.html"
absent "$work/other/contact-map/00003-got.png"
absent "$work/approved/contact-map/00003.png"
present "$work/approved/contact-map/00005.png"
expect 0 "1 pictures of each of 1 views" "$program" check "$shipped/run" --baseline "$work/one" --update --pictures 1 --views gap --size 128x96
expect 0 "5 sidecars, 1 pictures" "$program" check "$shipped/run" --baseline "$work/one" --report "$work/other"

# Bad input: 2, and nothing is written.
expect 2 "--baseline BASE is needed" "$program" check "$shipped/run"
expect 2 "there is no baseline; --update makes one" "$program" check "$shipped/run" --baseline "$work/none"
expect 2 "no saved states here" "$program" check tests/app --baseline "$shipped/approved"
expect 2 "there is no such folder" "$program" check "$work/nothing" --baseline "$shipped/approved"
expect 2 "--views: the baseline says how to draw" $check --views gap
echo "{" >"$work/approved/baseline.json"
expect 2 "baseline.json" "$program" check "$shipped/run" --baseline "$work/approved" --report "$work/other"
absent "$work/none"

[ $failures -eq 0 ] && echo "all as expected"
exit $failures
