#!/bin/sh
# SPDX-License-Identifier: MIT
# end.sh SIGNAL PROGRAM OUTPUT: starts the program, with its output in the file OUTPUT, and sends it the signal when it has printed "walks". The
# program must print "stops" and end with exit status 0.
: >"$3" # what an earlier run printed must not count
"$2" >>"$3" &
program=$!
turns=0
until grep -q walks "$3" || [ $turns -eq 600 ]; do
  sleep 0.05
  turns=$((turns + 1))
done
kill -s "$1" $program
wait $program || exit 1
test "$(cat "$3")" = "walks
stops"
