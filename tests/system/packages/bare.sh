#!/bin/bash
# SPDX-License-Identifier: MIT
# bare.sh --base <folder to work in>
# bare.sh <folder with the packages> <folder to work in> <tests/system/cmake of the project>
# Tests the Debian packages on a minimal Debian 12 (a chroot): apt installs them with their dependencies, they are used as a user would, and they are
# removed. The minimal system is created only once and kept in the folder, with the downloaded packages; --base only creates it. No file system of the
# kernel, such as /proc, is mounted, since none is needed. Exit status 77: this machine cannot create such a system, and a line says why; with CI=true
# the status is 1.
set -euo pipefail
fail() { echo "bare.sh: $*" >&2; exit 1; }
skip() {
  echo "$*"
  if [ "${CI:-}" = true ]; then exit 1; fi
  exit 77
}
if [ "$1" = --base ]; then packages='' work=$2; else packages=$1 work=$2 projects=$3; fi
work=$(realpath -m "$work")
[ "$(id -u)" = 0 ] || skip 'to make a bare system needs root rights'
command -v mmdebstrap >/dev/null || skip 'there is no mmdebstrap (Debian: mmdebstrap)'
mkdir -p "$work"
base=$work/base root=$work/root log=$work/log kept=$work/downloads
mkdir -p "$kept"
: >"$log"

# The minimal system uses the package sources and the proxy of this machine, whether the environment or the configuration of apt names the proxy. In
# sources, `file:` is replaced by `copy:`, because the folder of a local mirror does not exist inside the chroot.
eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
rm -rf "$work/sources"
mkdir "$work/sources"
for file in "$list" "$parts"*.list "$parts"*.sources; do
  if [ -s "$file" ]; then sed -E '/^[^#]/ s#(^|[^a-z+])file:#\1copy:#g' "$file" >"$work/sources/${file##*/}"; fi
done
sources=("$work"/sources/*)
[ -e "${sources[0]}" ] || skip 'this machine has no sources of packages'
apt-config dump | grep '^Acquire::' >"$work/acquire.conf" || true

if [ ! -e "$base/made" ]; then
  rm -rf --one-file-system "$base"
  mmdebstrap --mode=root --variant=apt --architectures="$(dpkg --print-architecture)" --aptopt="$work/acquire.conf" bookworm "$base" "${sources[@]}" >>"$log" 2>&1 ||
    { rm -rf --one-file-system "$base"
      skip "no bare system can be made: the packages cannot be fetched, or may not be unpacked: $(grep -m 1 '^E:' "$log") (its whole output: $log)"; }
  touch "$base/made"
fi
[ -n "$packages" ] || exit 0
trap 'rm -rf --one-file-system "$root"' EXIT
rm -rf --one-file-system "$root"
cp -a "$base" "$root"
# The package sources may have changed since the base was created, so they replace those that mmdebstrap wrote.
rm -rf "$root"/etc/apt/sources.list "$root"/etc/apt/sources.list.d/*
cp "${sources[@]}" "$root/etc/apt/sources.list.d/"
if [ -e "$root/etc/apt/sources.list.d/sources.list" ]; then mv "$root/etc/apt/sources.list.d/sources.list" "$root/etc/apt/"; fi

# The apt of this machine installs into the minimal system, so that it has the same network.
{
  cat "$work/acquire.conf"
  cat <<END
Dir "$root";
DPkg::Chroot-Directory "$root";
APT::Architecture "$(dpkg --print-architecture)";
APT::Keep-Downloaded-Packages "true";
DPkg::Options { "--force-unsafe-io"; };
APT::Sandbox::User "root";
END
} >"$work/apt.conf"
archives=$root/var/cache/apt/archives
ln -f "$kept"/*.deb "$archives/" 2>/dev/null || true
bare_apt() {
  local status=0
  echo "== apt-get $*" >>"$log"
  TMPDIR=$root/tmp APT_CONFIG=$work/apt.conf DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y "$@" >>"$log" 2>&1 || status=$?
  ln -f "$archives"/*.deb "$kept/" 2>/dev/null || true
  return $status
}
inside() { chroot "$root" /usr/bin/env -i HOME=/root TERM=dumb LC_ALL=C.UTF-8 PATH=/usr/local/bin:/usr/bin:/bin "$@"; }
files() { (cd "$root" && find usr etc opt -path usr/share/man/man1/director\* -o -iname '*director*' -print | grep -vE 'usr/(lib|share)/(python|cmake-)' | sort); }

bare_apt update || skip "the list of packages cannot be fetched: $(grep -m 1 '^E:' "$log")"
before=$(files)
bare_apt install --no-install-recommends g++ cmake make || skip "the compiler for the bare system cannot be fetched: $(grep -m 1 '^E:' "$log")"

echo 'installing director'
mkdir "$root/packages"
cp "$packages"/director_*.deb "$packages"/director-clang_*.deb "$root/packages/"
bare_apt install --no-install-recommends "$root"/packages/director_*.deb || { tail -n 20 "$log"; fail 'director cannot be installed'; }

cp -r "$projects/consumer" "$root/lantern"
# The lines for editors that --help prints name schemas that exist.
inside directorc --help | sed -n 's/^# yaml-language-server: $schema=//p' >"$work/schemas"
[ "$(wc -l <"$work/schemas")" = 2 ] || fail 'directorc --help does not name the two schemas'
while read -r schema; do [ -s "$root$schema" ] || fail "there is no $schema"; done <"$work/schemas"
grep -qx 'License: Expat' "$root/usr/share/doc/director/copyright" || fail 'the package does not say its licence'
inside directorc --version
inside directorc check --werror /lantern/lantern.yaml
inside directorc generate /lantern/lantern.yaml -o /generated
[ -s "$root/generated/lantern.cpp" ] || fail 'directorc wrote no C++'
[ -s "$root/usr/share/man/man1/directorc.1.gz" ] || fail 'there is no manual page'
for part in copyright changelog.Debian.gz; do [ -s "$root/usr/share/doc/director/$part" ] || fail "there is no $part"; done
inside cmake -S /lantern -B /lantern/build >>"$log" 2>&1 || { tail -n 20 "$log"; fail 'a project does not find Director'; }
inside cmake --build /lantern/build >>"$log" 2>&1 || { tail -n 20 "$log"; fail 'the project does not build'; }
said=$(inside /lantern/build/lantern)
[ "$said" = 'the lamp shines' ] || fail "the program said: $said"

echo 'installing director-clang'
bare_apt install --no-install-recommends "$root"/packages/director-clang_*.deb || { tail -n 20 "$log"; fail 'director-clang cannot be installed'; }
inside /usr/libexec/director/director-clang version <<<'{}'
inside directorc stubs /lantern/lantern.yaml -o /bodies --main
inside directorc generate /lantern/lantern.yaml -o /bodies
inside directorc stubs /lantern/lantern.yaml -o /bodies --check # reads the bodies that the call above wrote

# A program whose headers include those of the standard library, which include Clang's own headers: directorc checks that no body is missing, and
# compares the bodies with the behaviour.
cp -r "$projects/verify" "$root/walker"
sed -i '1i #include <cstddef>\n#include <vector>' "$root/walker/legs.hpp"
inside directorc stubs /walker/walker.yaml -o /walker --check
inside cmake -S /walker -B /walker/build -D EXCLUDED=doubles >>"$log" 2>&1 || { tail -n 20 "$log"; fail 'a project with VERIFY is not configured'; }
inside cmake --build /walker/build >>"$log" 2>&1 || { tail -n 20 "$log"; fail 'a program without fault does not pass VERIFY'; }
inside directorc verify --werror /walker/walker.yaml -p /walker/build --exclude=/walker/doubles
sed -i 's/Pose::moving/Pose::fallen/' "$root/walker/legs.cpp"
said=$(inside cmake --build /walker/build 2>&1) && fail "VERIFY lets a fault pass: $said"
grep -qF '/walker/legs.cpp:5:7: error: `Walk` sets `Pose` to `fallen`, which it does not declare [undeclared_state_write]' <<<"$said" ||
  fail "VERIFY does not tell of a fault: $said"
[ -s "$root/usr/share/man/man1/director-clang.1.gz" ] || fail 'director-clang has no manual page'

echo 'removing both'
bare_apt purge director director-clang || { tail -n 20 "$log"; fail 'they cannot be removed'; }
rm -r "$root/lantern" "$root/generated" "$root/bodies" "$root/walker" "$root/packages"
[ "$(files)" = "$before" ] || fail "something is left: $(files)"
echo 'the packages work on a bare system'
