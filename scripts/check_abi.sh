#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compares the binary interface of libboxplus with that of an earlier version:
#
#   check_abi.sh [TAG]                              the sources of TAG (the last tag v…) and those of this folder
#   check_abi.sh --libraries OLD NEW VERSION VERSION OLD_HEADERS NEW_HEADERS        two libraries and their headers
#
# Only what the public headers name counts. nm lists the functions. abidiff, of abigail-tools, compares the layouts of the
# types, in two small libraries that only include the headers: the debug information of libboxplus itself would take
# 24 GB of memory, most of it for templates of Eigen. Types that functions return are not compared.
#
# Functions and types may be added. Everything else is a break, and needs a new minor or major version
# (docs/versions.md). Exit codes: 0 no break, or one that the version announces; 1 a break; 2 wrong usage.
set -euo pipefail

fail() {
  echo "check_abi: $1" >&2
  exit 2
}

# removed_functions OLD NEW OLD_HEADERS: lists the symbols that only the old library has, and whose names have only words
# that the headers have. The libraries export their private functions, too, because the tests call them. Programs have
# inline functions and templates themselves, except for those that the headers declare as extern.
removed_functions() {
  python3 - "$@" <<'END'
import pathlib, re, subprocess, sys
def output(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, check=True, **more).stdout.splitlines()
old, new = ([line.split()[-2:] for line in output("nm", "-D", "--defined-only", path)] for path in sys.argv[1:3])
texts = [path.read_text(encoding="utf-8") for path in pathlib.Path(sys.argv[3]).rglob("*.h")]
words = {word for text in texts for word in re.findall(r"\w+", text)}
elsewhere = {name for text in texts for name in re.findall(r"extern\s+template\s+(?:class|struct)\s+(\w+)", text)}
kept = {symbol for _, symbol in new}
gone = [(kind, symbol) for kind, symbol in old if symbol not in kept]
names = output("c++filt", input="".join(symbol + "\n" for _, symbol in gone))
for (kind, _), name in zip(gone, names):
    short = name
    while re.search(r"<[^<>]*>", short):  # arguments of templates
        short = re.sub(r"<[^<>]*>", "", short)
    short = re.sub(r"^(vtable|typeinfo|typeinfo name|VTT|guard variable) for ", "", short).split("(")[0].split(" ")[-1]
    parts = re.findall(r"\w+", short)
    is_public = parts and words.issuperset(parts) and parts[0] not in ("std", "Eigen", "fmt")
    if is_public and (kind not in "WVu" or elsewhere.intersection(parts)):
        print("removed:", name)
END
}

# types HEADERS LIBRARY: builds a library with debug information for all types that the headers define.
types() {
  {
    (cd "$1" && find . -name '*.h' -not -path './boxplus/testing/*' | sort | sed 's|^./\(.*\)|#include <\1>|')
    echo "void function() {}" # abidiff needs one
  } |
    g++ -std=c++20 -DEIGEN_MAX_ALIGN_BYTES=16 -g -O0 -fno-eliminate-unused-debug-types -fPIC -shared -I "$1" \
      -isystem /usr/include/eigen3 -x c++ - -o "$2"
}

# changed_types OLD_HEADERS NEW_HEADERS FOLDER: prints what abidiff finds. Returns its exit code.
changed_types() {
  types "$1" "$3/old.so"
  types "$2" "$3/new.so"
  (
    ulimit -v 4000000
    abidiff --non-reachable-types --drop-private-types --headers-dir1 "$1" --headers-dir2 "$2" --no-added-syms \
      "$3/old.so" "$3/new.so"
  )
}

# compare OLD NEW OLD_VERSION NEW_VERSION OLD_HEADERS NEW_HEADERS
compare() {
  local status=0 removed changed
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  removed=$(removed_functions "$1" "$2" "$5") || fail "cannot compare the functions of $1 and $2"
  changed=$(changed_types "$5" "$6" "$work") || status=$?
  if ((status & 3)); then fail "abidiff failed"; fi
  # Types that are only added also set the exit code.
  if grep -q '^Unreachable types summary: 0 removed.*, 0 changed' <<<"$changed"; then status=0; fi
  if [[ -z $removed ]] && ((status == 0)); then
    echo "check_abi: version $4 can replace version $3"
    return
  fi
  printf '%s\n' "$removed" "$changed"
  if [[ ${3%.*} != "${4%.*}" ]]; then
    echo "check_abi: the changes above need a new minor or major version, which $4 is"
  else
    echo "check_abi: programs that were built with version $3 break with version $4; see docs/versions.md" >&2
    exit 1
  fi
}

# version SOURCE_FOLDER
version() {
  sed -n 's/^project(boxplus VERSION \([0-9.]*\).*/\1/p' "$1/CMakeLists.txt"
}

# build SOURCE_FOLDER BUILD_FOLDER
build() {
  cmake -S "$1" -B "$2" -G Ninja -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
    -DBOXPLUS_BUILD_APPS=OFF -DBOXPLUS_BUILD_G2O=OFF -DBOXPLUS_BUILD_PYTHON=OFF -DBOXPLUS_BUILD_TESTS=OFF >/dev/null
  cmake --build "$2" --target boxplus
}

command -v abidiff >/dev/null || fail "needs abidiff, of Debian's package abigail-tools"
if [[ ${1:-} == --libraries ]]; then
  shift
  if (($# != 6)); then fail "expected OLD NEW VERSION VERSION OLD_HEADERS NEW_HEADERS"; fi
  compare "$@"
  exit
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
tag=${1:-$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null || true)}
if [[ -z $tag ]]; then
  echo "check_abi: there is no tag to compare with"
  exit
fi
# Both build folders are at the same place in their sources, so that ccache compiles equal sources once.
old=build/abi/old_sources folder=build/abi/library
rm -rf "$old"
mkdir -p "$old"
git archive "$tag" | tar -x -C "$old"
build "$old" "$old/$folder"
build . "$folder"
compare "$old/$folder/src/libboxplus.so" "$folder/src/libboxplus.so" "$(version "$old")" "$(version .)" \
  "$old/include" include
