#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compares the binary interface of libboxplus with that of an earlier version, by abidiff of abigail-tools:
#
#   check_abi.sh [TAG]                                  the sources of TAG (the last tag v…) and those of this folder
#   check_abi.sh --libraries OLD NEW VERSION VERSION [OLD_HEADERS NEW_HEADERS]      two libraries with debug information
#
# Only what the public headers name counts. Functions may be added. Everything else is a break, and needs a new minor
# or major version (docs/versions.md). Exit codes: 0 no break, or one that the version announces; 1 a break; 2 wrong usage.
set -euo pipefail

fail() {
  echo "check_abi: $1" >&2
  exit 2
}

# public_symbols LIBRARY HEADERS: lists the symbols whose names have only words that the headers have, in the form of a
# whitelist of abidiff. The library exports its private functions, too, because its tests call them.
public_symbols() {
  python3 - "$1" "$2" <<'END'
import pathlib, re, subprocess, sys
library, headers = sys.argv[1], pathlib.Path(sys.argv[2])
words = {word for path in headers.rglob("*.h") for word in re.findall(r"\w+", path.read_text(encoding="utf-8"))}
listed = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout
symbols = [line.split()[-1] for line in listed.splitlines()]
names = subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True, check=True).stdout.splitlines()
print("[abi_whitelist]")
for symbol, name in zip(symbols, names):
    while re.search(r"<[^<>]*>", name):  # arguments of templates
        name = re.sub(r"<[^<>]*>", "", name)
    name = re.sub(r"^(vtable|typeinfo|typeinfo name|VTT|guard variable) for ", "", name).split("(")[0].split(" ")[-1]
    if words.issuperset(re.findall(r"\w+", name)):
        print(" ", symbol)
END
}

# compare OLD NEW OLD_VERSION NEW_VERSION [OLD_HEADERS NEW_HEADERS]
compare() {
  local status=0 options=(--no-added-syms)
  if (($# == 6)); then
    public=$(mktemp)
    trap 'rm -f "$public"' EXIT
    public_symbols "$1" "$5" >"$public"
    options+=(--headers-dir1 "$5" --headers-dir2 "$6" --kmi-whitelist "$public")
  fi
  abidiff "${options[@]}" "$1" "$2" || status=$?
  if ((status & 3)); then fail "abidiff failed"; fi
  if ((status == 0)); then
    echo "check_abi: version $4 can replace version $3"
  elif [[ ${3%.*} != "${4%.*}" ]]; then
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
  cmake -S "$1" -B "$2" -G Ninja -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -g" \
    -DBOXPLUS_BUILD_APPS=OFF -DBOXPLUS_BUILD_G2O=OFF -DBOXPLUS_BUILD_PYTHON=OFF -DBOXPLUS_BUILD_TESTS=OFF >/dev/null
  cmake --build "$2" --target boxplus
}

command -v abidiff >/dev/null || fail "needs abidiff, of Debian's package abigail-tools"
if [[ ${1:-} == --libraries ]]; then
  shift
  if (($# != 4 && $# != 6)); then fail "expected OLD NEW VERSION VERSION [OLD_HEADERS NEW_HEADERS]"; fi
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
