#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: installs boxplus and builds a user's project with the commands in
# docs/first_steps.md. The project contains the program in README.md.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
examples="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

rm -rf "$work"
mkdir -p "$work/my_robot"
"$cmake" --install "$build" --prefix "$work/boxplus" >/dev/null
cp "$examples/user_project/CMakeLists.txt" "$work/my_robot"
cp "$examples/01_pose_graph.cpp" "$work/my_robot/main.cpp"
cd "$work/my_robot"
# configure FOLDER OPTION...: configures the project in FOLDER. Prints the output of CMake, and also writes it to
# FOLDER.txt.
configure() {
  env -u CXXFLAGS "$cmake" -B "$1" -DCMAKE_PREFIX_PATH="$work/boxplus" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${@:2}" 2>&1 | tee "$1.txt"
}
configure build
"$cmake" --build build
build/my_robot

# If the user sets no build type, the project's CMakeLists.txt selects Release. If the project does not do this, CMake
# prints a notice.
grep -q -e '-O3' build/compile_commands.json || { echo "expected an optimized build"; exit 1; }
configure debug -DCMAKE_BUILD_TYPE=Debug >/dev/null
grep -q -e '-O3' debug/compile_commands.json && { echo "expected the requested build type"; exit 1; }
sed -i '/^if(NOT CMAKE_BUILD_TYPE/,/^endif/d' CMakeLists.txt
configure bare >/dev/null
grep -q "CMAKE_BUILD_TYPE is empty" bare.txt || { echo "expected a notice that this build is not optimized"; exit 1; }
if grep -q "CMAKE_BUILD_TYPE is empty" build.txt debug.txt; then
  echo "expected no notice, because these builds have a build type"
  exit 1
fi
