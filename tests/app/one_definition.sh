#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: one_definition.sh NM LIBRARY...
# Two libraries with a function of the same name and arguments link without a word,
# and one of them then runs the other's code. All rooms share one namespace: check it.
set -eu
nm=$1
shift
twice=$("$nm" --defined-only "$@" 2>/dev/null | awk '$2 == "T" && $3 ~ /hydroscope/ { print $3 }' | sort | uniq -d)
[ -z "$twice" ] && exit 0
echo "defined in more than one place:"
echo "$twice" | c++filt
exit 1
