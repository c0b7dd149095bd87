# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034
# Functions that the scripts at the root share: printing messages, installing packages, configuring and building. Sourced by bash, with the working
# directory at the root of the project.

if [ -t 1 ] && [ -z "${NO_COLOR:-}" ] && [ "${TERM:-dumb}" != dumb ]; then
  bold=$'\e[1m' red=$'\e[31m' plain=$'\e[0m' terminal=yes
else
  bold='' red='' plain='' terminal=''
fi

step() { printf '%s\n' "${bold}== $*${plain}"; }
fail() {
  printf '%s\n' "${red}$(basename "$0"): $1${plain}" >&2
  shift
  [ $# = 0 ] || printf '  %s\n' "$@" >&2
  exit 1
}

# The Debian packages for each purpose, as PACKAGE or COMMAND:PACKAGE. If COMMAND is found, the package is not needed.
packages_main=(g++:g++ cmake:cmake ninja:ninja-build dot:graphviz
               libyaml-cpp-dev libfmt-dev libcli11-dev nlohmann-json3-dev libboost1.74-dev zlib1g-dev libcpp-httplib-dev pkg-config:pkgconf)
packages_test=(git:git doxygen:doxygen protoc:protobuf-compiler catch2 librapidcheck-dev nm:binutils make:make xz:xz-utils ccache:ccache)
packages_arm=(arm-none-eabi-g++:gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev qemu-system-arm:qemu-system-arm)
packages_schemas=(node:nodejs npm:npm)
packages_browser=(node:nodejs npm:npm chromium:chromium)
packages_bench=(libbenchmark-dev valgrind:valgrind)
packages_dds=(cyclonedds-dev idlc:cyclonedds-tools)
packages_packages=(mmdebstrap:mmdebstrap lintian:lintian dpkg-shlibdeps:dpkg-dev file:file clang-19 libclang-19-dev llvm-19-dev)
packages_clang=(clang-19 libclang-19-dev llvm-19-dev)
packages_asan=(clang++-19:clang-19 libclang-rt-19-dev lld-19)

# missing_packages <package>...: prints those that are not installed, one a line. Without dpkg it prints nothing; CMake then reports what it does not
# find.
missing_packages() {
  command -v dpkg-query >/dev/null || return 0
  local entry name
  for entry in "$@"; do
    name=${entry#*:}
    [ "$entry" != "$name" ] && command -v "${entry%%:*}" >/dev/null && continue
    case " $(dpkg-query -W -f='${db:Status-Status} ' "$name" 2>/dev/null)" in # another status is `not-installed`
      *' installed '*) ;;
      *) printf '%s\n' "$name" ;;
    esac
  done
}

# show_progress <log>: writes the output of apt, from stdin, to the log. Prints the progress as one line that is overwritten, or, if stdout is no
# terminal, as one line for every 50 packages.
show_progress() {
  awk -v log_file="$1" -v terminal="$terminal" '
    { print >> log_file; fflush(log_file) }
    /^(Get:|Unpacking |Setting up )/ {
      count++
      what = $1 == "Setting" ? "setting up " $3 : $1 == "Unpacking" ? "unpacking " $2 : "fetching " ($5 ~ /^[a-z0-9]/ ? $5 : $4)
      if (terminal) { printf "\r\033[K   %s", substr(what, 1, 70) } else if (count % 50 == 0) { printf "   %s ...\n", what }
      fflush()
    }
    END { if (terminal) printf "\r\033[K" }'
}

# why_apt_failed <log>: sets `why` to the reason, and prints nothing.
why_apt_failed() {
  if grep -qE 'No space left|enough free space' "$1"; then
    why="the disk is full: $(df -Ph / | awk 'NR == 2 { print $4 }') are free on /"
  elif grep -qE 'Could not get lock|is another process using it' "$1"; then
    why="another package manager is running; try again when it has finished"
  elif grep -qE 'Temporary failure resolving|Could not resolve|Could not connect|Connection failed|Network is unreachable|Failed to fetch|Unable to fetch' "$1"; then
    why="the package servers cannot be reached: check the network (and the proxy, if there is one)"
  elif grep -q 'Unable to locate package' "$1"; then
    why="this system does not offer $(sed -n 's/.*Unable to locate package //p' "$1" | paste -sd' ' -); Director is made for Debian 12"
  else
    why="apt-get failed: $(grep -E '^(E|W):' "$1" | tail -n 1)"
  fi
}

updated='' # `yes` if this run has already called apt-get update

# install_packages <package>...: installs the missing packages, and calls apt only if there are any. If it fails it returns 1 and sets `why` to the
# reason.
install_packages() {
  local missing asroot=() log
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  if ! command -v apt-get >/dev/null; then
    why="these packages are missing and there is no apt-get to install them: ${missing[*]}"
    return 1
  fi
  if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null || { [ ! -t 0 ] && ! sudo -n true 2>/dev/null; }; then
      why="packages are missing, and to install them needs root rights or sudo; as root: apt-get install ${missing[*]}"
      return 1
    fi
    asroot=(sudo)
  fi
  printf '   installing %s\n' "${missing[*]}"
  log=$(mktemp "${TMPDIR:-/tmp}/director-apt.XXXXXX")
  local apt=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o Acquire::Retries=3 -o DPkg::Lock::Timeout=120)
  if [ -z "$updated" ] && "${asroot[@]}" "${apt[@]}" update 2>&1 </dev/null | show_progress "$log"; then updated=yes; fi
  if ! "${asroot[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" 2>&1 </dev/null | show_progress "$log"; then
    why_apt_failed "$log"
    why="$why (its whole output: $log)"
    return 1
  fi
  rm -f "$log"
  hash -r
}

# need_disk <preset>...: fails if the disk has too little space for the build trees of those presets that have none yet.
need_disk() {
  local free needed=0 preset
  for preset in "$@"; do
    [ -d "build/$preset" ] || case $preset in asan) needed=$((needed + 1100)) ;; *) needed=$((needed + 800)) ;; esac
  done
  free=$(df -Pm . | awk 'NR == 2 { print $4 }')
  [ "$free" -ge "$needed" ] || fail "the disk is nearly full: about $needed MB are needed in $PWD, $free MB are free"
}

# need_right: creates the folder build if there is none, and fails if this user cannot write to it.
need_right() {
  { mkdir -p build && [ -w build ]; } 2>/dev/null || fail "cannot write to $PWD/build: build as the user to whom the project belongs"
}

# is_configured <preset>: whether there is a build tree that was configured in this place, and not copied from elsewhere.
is_configured() { [ -f "build/$1/CMakeCache.txt" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "build/$1/CMakeCache.txt"; }

# configure <preset> <cmake argument>...: prints the output of CMake only if it fails. A build tree that was copied from elsewhere is configured afresh.
configure() {
  local preset=$1 tree=build/$1 fresh=()
  shift
  mkdir -p "$tree"
  is_configured "$preset" || fresh=(--fresh)
  if ! cmake --preset "$preset" "${fresh[@]}" "$@" >"$tree/configure.log" 2>&1; then
    cat "$tree/configure.log" >&2
    return 1
  fi
}

# build <preset> [<target>...] [-- <argument of ninja>...]: builds the targets, or everything.
build() {
  local preset=$1
  shift
  NINJA_STATUS='   [%f/%t] ' cmake --build "build/$preset" ${1:+--target "$@"}
}
