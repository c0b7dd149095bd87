#!/bin/sh
# SPDX-License-Identifier: MIT
# end.sh SIGNAL PROGRAM OUTPUT: sends the signal once the program walks; it must say that it stops, and end well.
"$2" >"$3" &
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
