#!/bin/bash
# bare.sh <folder with the packages> <folder to work in> <project that uses Director>
# The packages on a Debian 12 that has nothing else: installed by apt with what they depend on, used as somebody would use them, and removed. The bare
# system is made once and kept in the folder, with what was downloaded. Nothing is mounted: what the kernel offers is not needed.
# Exit status 77: this machine cannot make such a system.
set -euo pipefail
packages=$1 work=$2 project=$3
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "bare.sh: $*" >&2; exit 1; }
[ "$(id -u)" = 0 ] || skip 'to make a bare system needs root rights'
command -v mmdebstrap >/dev/null || skip 'there is no mmdebstrap (Debian: mmdebstrap)'
mkdir -p "$work"
base=$work/base root=$work/root log=$work/log kept=$work/downloads
mkdir -p "$kept"
trap 'rm -rf --one-file-system "$root"' EXIT

# Packages come from where this machine gets them, and the way it does.
sources=()
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
  if [ -s "$file" ]; then sources+=("$file"); fi
done
[ ${#sources[@]} -gt 0 ] || skip 'this machine has no sources of packages'
apt-config dump | grep '^Acquire::' >"$work/acquire.conf" || true

if [ ! -e "$base/made" ]; then
  rm -rf --one-file-system "$base"
  mmdebstrap --mode=root --variant=apt --architectures="$(dpkg --print-architecture)" --aptopt="$work/acquire.conf" bookworm "$base" "${sources[@]}" >"$log" 2>&1 ||
    { tail -n 5 "$log"; rm -rf --one-file-system "$base"; skip 'no bare system can be made: the packages cannot be fetched, or may not be unpacked'; }
  touch "$base/made"
fi
rm -rf --one-file-system "$root"
cp -a "$base" "$root"

# apt of this machine for that one: so it has the same network.
cat >"$work/apt.conf" <<END
Dir "$root";
DPkg::Chroot-Directory "$root";
APT::Architecture "$(dpkg --print-architecture)";
APT::Keep-Downloaded-Packages "true";
DPkg::Options { "--force-unsafe-io"; };
APT::Sandbox::User "root";
END
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

bare_apt update || skip 'the list of packages cannot be fetched'
before=$(files)
bare_apt install --no-install-recommends g++ cmake make || { tail -n 5 "$log"; skip 'the compiler for the bare system cannot be fetched'; }

echo 'installing director'
mkdir "$root/packages"
cp "$packages"/director_*.deb "$packages"/director-clang_*.deb "$root/packages/"
bare_apt install --no-install-recommends "$root"/packages/director_*.deb || { tail -n 20 "$log"; fail 'director cannot be installed'; }

cp -r "$project" "$root/lantern"
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
inside directorc stubs /lantern/lantern.yaml -o /bodies --check -I /usr/include/director # reads what it wrote
[ -s "$root/usr/share/man/man1/director-clang.1.gz" ] || fail 'director-clang has no manual page'

echo 'removing both'
bare_apt purge director director-clang || { tail -n 20 "$log"; fail 'they cannot be removed'; }
rm -r "$root/lantern" "$root/generated" "$root/bodies" "$root/packages"
[ "$(files)" = "$before" ] || fail "something is left: $(files)"
echo 'the packages work on a bare system'
