#!/bin/bash
# SPDX-License-Identifier: MIT
# bash start_test.sh <the project> <a folder to work in>
# Tests ./start in a project without a build tree, in one with a build tree, and in one that was copied with its build tree.
set -euo pipefail
project=$1 work=$2
rm -rf "$work"
mkdir -p "$work/bin" "$work/here/.ci"
cp "$project/start" "$work/here/"
cp "$project/.ci/common.sh" "$work/here/.ci/"

# Stand-ins for two programs: dpkg-query says that all packages are installed, and cmake records its arguments and creates the files that ./start
# looks for in a configured build tree.
printf '#!/bin/sh\necho "installed "\n' >"$work/bin/dpkg-query"
cat >"$work/bin/cmake" <<'FAKE'
#!/bin/bash
echo "$*" >>"$ASKED"
mkdir -p build/release/bin
[ "$1" = --build ] || printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$PWD" >build/release/CMakeCache.txt
FAKE
chmod +x "$work/bin/"*
export PATH=$work/bin:$PATH ASKED=$work/asked

fail() { printf '%s\n' "$1" "asked:" "$(cat "$ASKED")" "said:" "$said" >&2; exit 1; }
start() { : >"$ASKED"; said=$(cd "$1" && ./start --build-only 2>&1) || fail "$2: ./start fails"; }
asked() { grep -qxF -- "$1" "$ASKED" || fail "$2: CMake was not requested: $1"; }

start "$work/here" 'a new tree'
asked '--preset release --fresh -D DIRECTOR_TESTS=OFF' 'a new tree'

printf 'DIRECTOR_TESTS:BOOL=ON\n' >>"$work/here/build/release/CMakeCache.txt"
start "$work/here" 'a tree that ./test has configured'
asked '--preset release' 'a tree that ./test has configured'

cp -r "$work/here" "$work/there"
start "$work/there" 'a tree that was copied'
asked '--preset release --fresh -D DIRECTOR_TESTS=OFF' 'a tree that was copied'

said_without=$(tail -n 3 <<<"$said")
[ "$said_without" = 'director-clang, which `directorc verify` and `directorc stubs` need to read C++, was not built. To have it:
  apt-get install clang-19 libclang-19-dev llvm-19-dev
  ./start --build-only' ] || fail 'without director-clang it is not said how to have it'
printf '#!/bin/sh\n' >"$work/there/build/release/bin/director-clang"
chmod +x "$work/there/build/release/bin/director-clang"
start "$work/there" 'with director-clang'
[ "$(tail -n 1 <<<"$said")" = 'The compiler is at build/release/bin/directorc' ] || fail 'with director-clang something is missed'
echo 'start requests what it needs'
