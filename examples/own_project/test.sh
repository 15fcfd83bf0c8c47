#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: does what docs/first_steps.md says about an own project, with the
# program of README.md.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
examples="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

rm -rf "$work"
mkdir -p "$work/my_robot"
"$cmake" --install "$build" --prefix "$work/boxplus" >/dev/null
cp "$examples/own_project/CMakeLists.txt" "$work/my_robot"
cp "$examples/01_pose_graph.cpp" "$work/my_robot/main.cpp"
cd "$work/my_robot"
"$cmake" -B build -DCMAKE_PREFIX_PATH="$work/boxplus" -DCMAKE_CXX_COMPILER="$compiler"
"$cmake" --build build
build/my_robot
