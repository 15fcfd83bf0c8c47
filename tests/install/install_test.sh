#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# install_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: installs the build, moves the installed folder, and builds and runs
# a program that uses it.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
consumer="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/consumer"

rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/moved"
if grep -rnF -e "$work" -e "$build" "$work/moved" --include='*.cmake'; then
  echo "the CMake package contains the path of the build folder or of the first installation folder" >&2
  exit 1
fi

# A project gets the version that it asks for, or a later one with the same major number.
for version in 0.1 1.1 2.0; do
  mkdir -p "$work/asks"
  printf 'cmake_minimum_required(VERSION 3.22)\nproject(asks)\nfind_package(boxplus %s REQUIRED)\n' "$version" \
    >"$work/asks/CMakeLists.txt"
  if "$cmake" -S "$work/asks" -B "$work/asks/build" -DCMAKE_PREFIX_PATH="$work/moved" >/dev/null 2>&1; then
    echo "find_package(boxplus $version) accepts this version" >&2
    exit 1
  fi
done

"$cmake" -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/moved" -DCMAKE_CXX_COMPILER="$compiler"
"$cmake" --build "$work/build"
"$work/build/consumer"
if [[ -x "$work/moved/bin/boxplus" ]]; then "$work/build/viewer_consumer"; fi
if [[ -e "$work/build/petsc_consumer" ]]; then "$work/build/petsc_consumer"; fi

# The installed programs start, although their folder was moved.
for program in "$work"/moved/bin/*; do
  if [[ -x "$program" ]]; then "$program" --help >/dev/null; fi
done
