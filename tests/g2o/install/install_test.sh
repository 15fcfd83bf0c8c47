#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# install_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: installs the build, moves it, and builds a client of find_package(g2o).
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
consumer="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/consumer"

rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/moved"
if grep -rn "#include.*boxplus/" "$work/moved/include/g2o"; then
  echo "a header of the g2o face includes one of the engine" >&2
  exit 1
fi
"$cmake" -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/moved" -DCMAKE_CXX_COMPILER="$compiler"
"$cmake" --build "$work/build"
"$work/build/consumer"
"$work/build/old_consumer"
"$cmake" -S "$consumer" -B "$work/by_folder" -G Ninja -Dg2o_DIR="$work/moved/lib/cmake/g2o" -DCMAKE_CXX_COMPILER="$compiler" >/dev/null
