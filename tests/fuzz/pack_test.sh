#!/bin/bash
# SPDX-License-Identifier: MIT
# bash pack_test.sh <tests/fuzz> <a folder to work in> <cmake>
# Tests tests/fuzz/pack: unpacking an archive gives the same files again, and the same files give the same archive. Each corpus must be such an archive.
set -euo pipefail
here=$1 work=$2 cmake=$3
rm -rf "$work"
mkdir -p "$work"

fail() { printf '%s\n' "$1" >&2; exit 1; }
unpack() { mkdir "$2" && (cd "$2" && "$cmake" -E tar xf "$1"); }

# The same files, created in another order, at another time and with other permissions.
mkdir "$work/one" "$work/other"
printf 'a: 1\n' >"$work/one/a"
printf '\0\377' >"$work/one/-b"
: >"$work/one/c d"
for name in 'c d' -b a; do cp "$work/one/$name" "$work/other/$name"; done
touch -d 2001-01-01 "$work/other/"*
chmod 600 "$work/other/"*
for folder in one other; do "$here/pack" "$work/$folder" "$work/$folder.tar.xz"; done
cmp "$work/one.tar.xz" "$work/other.tar.xz" || fail 'the same files do not make the same archive'
unpack "$work/one.tar.xz" "$work/again"
diff -r "$work/one" "$work/again" || fail 'what was packed does not come out again'

printf 'a: 2\n' >"$work/other/a"
"$here/pack" "$work/other" "$work/other.tar.xz"
! cmp -s "$work/one.tar.xz" "$work/other.tar.xz" || fail 'other files make the same archive'

# Each corpus is the same as if pack had written it. The tar archives are compared, since another version of xz may compress them differently.
for corpus in "$here"/corpus/*; do
  name=$(basename "$corpus" .tar.xz)
  unpack "$corpus" "$work/$name"
  "$here/pack" "$work/$name" "$work/$name.tar.xz"
  cmp <(xz -dc "$corpus") <(xz -dc "$work/$name.tar.xz") || fail "$corpus is not as tests/fuzz/pack writes it"
done
[ -d "$work/pipeline" ] || fail "$here/corpus has no corpus"
